package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Distances whose squares are below the least double: all of a pair times a power of two. */
class TinyDistanceTest {
    private static List<GeometryObject> things(double unit, double x) {
        Point at = new Point(x * unit, 3 * unit, 2 * unit);
        List<Point> corners = List.of(new Point(), new Point(unit, unit, 0), new Point(0, unit, unit));
        List<GeometryObject> things = new ArrayList<>();
        things.add(new BoxObject(at, unit, 2 * unit, unit));
        things.add(new BoxObject(at, unit, unit, 2 * unit).turned(0, 30));
        things.add(new CylinderObject(at, unit, unit));
        things.add(new SphereObject(at, unit));
        things.add(new MeshObject(corners, new int[][] {{0, 1, 2}}).movedTo(at));
        things.add(new BoxObject(at, unit, unit, unit).turned(20, 30));
        return things;
    }

    private static double proximity(double unit, int a, int b, Dimension dimension) {
        Geometry world = new Geometry(64 * unit, 64 * unit, 64 * unit, dimension, Accuracy.EXACT);
        GeometryObject first = things(unit, -4).get(a).movedTo(new Point(-4 * unit, -3 * unit, -unit));
        assertThat(world.addObjectUnchecked(first.moveable("a"))).isTrue();
        assertThat(world.addObjectUnchecked(things(unit, 5).get(b))).isTrue();
        return world.getProximity("a", Double.POSITIVE_INFINITY);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void scaleWithTheWorld(Dimension dimension) {
        int count = things(1, 0).size();
        for (int a = 0; a < count; a++) {
            for (int b = 0; b < count; b++) {
                double large = proximity(1, a, b, dimension);
                assertThat(large).isBetween(1.0, 20.0);
                for (int power : new int[] {-200, -440, -460, -500, -540, -600, -900}) {
                    double unit = Math.scalb(1.0, power);
                    assertThat(proximity(unit, a, b, dimension))
                            .as("%s, kinds %s and %s at 2^%d", dimension, a, b, power)
                            .isCloseTo(
                                    large * unit, within(dimension == Dimension.PLANAR ? 0 : 0x1p-43 * large * unit));
                }
            }
        }
    }
}
