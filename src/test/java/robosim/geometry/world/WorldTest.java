package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

class WorldTest {
    private static WorldObject ball(String name, double x) {
        return new WorldObject(new SphereObject(new Point(x, 0, 0), 0.5).named(name));
    }

    @Test
    void becomesAGeometryOfItsSettings() {
        WorldObject overlapping = ball("b", 0.25);
        World world =
                new World(10, 4, 6, Unit.FOOT, Dimension.PLANAR, Accuracy.DOP, List.of(ball("a", 0), overlapping));
        Geometry geometry = world.toGeometry();
        assertThat(geometry.width()).isEqualTo(10);
        assertThat(geometry.height()).isEqualTo(4);
        assertThat(geometry.length()).isEqualTo(6);
        assertThat(geometry.dimension()).isEqualTo(Dimension.PLANAR);
        assertThat(geometry.accuracy()).isEqualTo(Accuracy.DOP);
        assertThat(geometry.objects()).containsExactly(world.objects().get(0).object(), overlapping.object());
    }

    @Test
    void namesWhatLiesOutside() {
        WorldObject nameless = new WorldObject(new BoxObject(new Point(0, 9, 0), 1, 1, 1));
        World world = new World(4, 4, 4, List.of(ball("in", 1.5), ball("out", 1.75), nameless, ball("far", 20)));
        assertThatIllegalArgumentException()
                .isThrownBy(world::toGeometry)
                .withMessageContaining("within the world of 4.0 x 4.0 x 4.0")
                .withMessageContaining("sphere \"out\" at (1.75, 0.0, 0.0)")
                .withMessageContaining("box at (0.0, 9.0, 0.0)")
                .withMessageContaining("sphere \"far\"")
                .withMessageNotContaining("\"in\"");
        List<WorldObject> refused = new ArrayList<>();
        Geometry geometry = world.toGeometry(refused::add);
        assertThat(refused)
                .containsExactly(
                        world.objects().get(1), nameless, world.objects().get(3));
        assertThat(geometry.objects()).containsExactly(world.objects().get(0).object());
    }

    @Test
    void refusesSizesThatAreNoneAndNamesTwice() {
        for (double wrong : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY, 0x1p102}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> new World(1, wrong, 1, List.of()))
                    .withMessage("height must be above 0 and at most 2^101 (got: " + wrong + ")");
        }
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new World(9, 9, 9, List.of(ball("a", 0), ball("b", 1), ball("a", 2))))
                .withMessage("names must be unique in a world (got twice: a)");
        assertThat(new World(9, 9, 9, List.of(ball("a", 0), ball("b", 1))).objects())
                .hasSize(2);
    }
}
