package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** A static object that is to be ignored does not echo, in whichever tree it stands. */
class IgnoredTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 40})
    void nextBehindIt(int levels) {
        Geometry world = new Geometry(2000, 400, 400);
        for (int k = 0; k < 400; k++) {
            int level = k % levels;
            Point place = new Point(2 * (k / levels), 4 * level - 80, 0);
            assertThat(world.addObject(new BoxObject(place, 1, 1, 1).named("box " + k)))
                    .isTrue();
        }
        Geometry copy = world.snapshot().toGeometry();
        for (int level = 0; level < levels; level++) {
            Ray ray = new Ray(new Point(-10, 4 * level - 80, 0), new Point(1, 0, 0));
            for (double width : new double[] {0, 3}) {
                for (Geometry each : new Geometry[] {world, copy}) {
                    double nearest = each.getRayDistance(ray, 0, 100, width);
                    double behind = each.getRayDistance(ray, 0, 100, width, "box " + level);
                    assertThat(nearest).isEqualTo(9.5);
                    assertThat(behind).isEqualTo(11.5);
                }
            }
        }
    }
}
