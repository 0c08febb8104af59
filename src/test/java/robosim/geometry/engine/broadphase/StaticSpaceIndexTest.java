package robosim.geometry.engine.broadphase;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import robosim.geometry.index.QuadTree;
import robosim.geometry.index.boxes.SpaceKeys;

class StaticSpaceIndexTest {
    private static final int COUNT = 200;

    /** Boxes of a height, on so many levels a unit apart, on the ground. */
    private static double[] boxes(int levels, double height) {
        double[] bounds = new double[6 * COUNT];
        for (int id = 0; id < COUNT; id++) {
            bounds[6 * id] = id / levels;
            bounds[6 * id + 3] = id / levels + 0.5;
            bounds[6 * id + 1] = id % levels;
            bounds[6 * id + 4] = id % levels + height;
            bounds[6 * id + 5] = 1;
        }
        return bounds;
    }

    private static StaticSpaceIndex filled(boolean hasHeights, double[] bounds, QuadTree flat) {
        StaticSpaceIndex stacks = new StaticSpaceIndex(hasHeights);
        for (int id = 0; id < COUNT; id++) {
            flat.keep(id, Arrays.copyOfRange(bounds, 6 * id, 6 * id + 6));
            stacks.add(id, flat);
        }
        return stacks;
    }

    @Test
    void onlyWhatIsStackedStandsInAnOctree() {
        QuadTree flat = new QuadTree(-100, -100, 100, 100);
        assertThat(filled(true, boxes(20, 0.5), flat).cursor()).isNotNull();
        assertThat(flat.size()).isZero();

        assertThat(filled(true, boxes(1, 0.5), flat).cursor()).isNull();
        assertThat(flat.size()).isEqualTo(COUNT);

        flat = new QuadTree(-100, -100, 100, 100);
        assertThat(filled(false, boxes(20, 0.5), flat).cursor()).isNull();
        assertThat(flat.size()).isEqualTo(COUNT);

        // Levels that reach into each other are no stack.
        flat = new QuadTree(-100, -100, 100, 100);
        assertThat(filled(true, boxes(5, 4), flat).cursor()).isNull();
    }

    @Test
    void takesOutOfTheTreeThatItIsIn() {
        for (int levels : new int[] {1, 20}) {
            double[] bounds = boxes(levels, 0.5);
            QuadTree flat = new QuadTree(-100, -100, 100, 100);
            StaticSpaceIndex stacks = filled(true, bounds, flat);
            for (int id = 0; id < COUNT; id += 2) {
                stacks.remove(id, flat);
            }
            assertThat(flat.size()).isEqualTo(levels == 1 ? COUNT / 2 : 0);
            if (stacks.cursor() != null) {
                SpaceKeys keys = new SpaceKeys();
                keys.startPoint(0, 0, 0);
                stacks.cursor().start(bounds, keys);
                int left = 0;
                for (int id = stacks.cursor().next(1e9);
                        id >= 0;
                        id = stacks.cursor().next(1e9)) {
                    assertThat(id % 2).isEqualTo(1);
                    left++;
                }
                assertThat(left).isEqualTo(COUNT / 2);
            }
        }
    }
}
