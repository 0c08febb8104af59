package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Reference;

/** Verdicts of worlds as they are in exact arithmetic, in touch and an ulp from it, at whole numbers of any size. */
class AgainstReferenceTest {
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void exactContacts(Dimension dimension) {
        int[][] whole = {{3, 0, 4, 5}, {0, 0, 5, 5}, {4, 0, -3, 5}, {-5, 0, 12, 13}, {8, 0, 15, 17}, {2, 0, 0, 2}};
        int[][] inSpace = {{1, 2, 2, 3}, {2, 3, 6, 7}, {-4, 4, 7, 9}, {6, -6, 7, 11}};
        for (double unit : new double[] {1, 0x1p-3, 0x1p-30, 0x1p-200, 0x1p30}) {
            double size = 1000 * Math.max(1, unit);
            for (int[] w : whole) {
                contacts(dimension, w, unit, size);
            }
            if (dimension == Dimension.SPATIAL) {
                for (int[] w : inSpace) {
                    contacts(dimension, w, unit, size);
                }
            }
        }
    }

    private static void contacts(Dimension dimension, int[] w, double unit, double size) {
        Point apart = new Point(w[0] * unit, w[1] * unit, w[2] * unit);
        double length = w[3] * unit;
        SphereObject ball = new SphereObject(new Point(), length - unit);
        touching(dimension, ball, new SphereObject(apart, unit), size);
        touching(dimension, new SphereObject(new Point(), length), new SphereObject(apart, 0), size);
        // A box whose corner is there, and which lies beyond it.
        Point beyond = new Point(
                apart.x() + Math.signum(apart.x()) * unit,
                apart.y() + Math.signum(apart.y()) * unit,
                apart.z() + Math.signum(apart.z()) * unit);
        BoxObject box = new BoxObject(beyond, 2 * unit, 2 * unit, 2 * unit);
        touching(dimension, new SphereObject(new Point(), length), box, size);
        touching(dimension, new SphereObject(new Point(), length), RandomObjects.surfaceOf(box), size);
        if (w[1] == 0) {
            touching(dimension, new CylinderObject(new Point(), length, unit), box, size);
            touching(dimension, new CylinderObject(new Point(), length, unit), RandomObjects.surfaceOf(box), size);
            touching(
                    dimension,
                    new CylinderObject(new Point(), length - unit, unit),
                    new CylinderObject(apart, unit, unit),
                    size);
        }
        BoxObject twin =
                new BoxObject(apart, Math.abs(w[0]) * unit, 2 * Math.abs(w[1]) * unit + unit, Math.abs(w[2]) * unit);
        touching(dimension, new BoxObject(new Point(), Math.abs(w[0]) * unit, unit, Math.abs(w[2]) * unit), twin, size);
    }

    private static void touching(Dimension dimension, GeometryObject a, GeometryObject b, double size) {
        String pair = dimension + " " + a + " | " + b;
        Geometry world = new Geometry(size, size, size, dimension, Accuracy.EXACT);
        assertThat(world.addObjectUnchecked(a)).isTrue();
        assertThat(world.testObject(b)).as(pair).isTrue();
        assertThat(Reference.overlap(a, b, dimension)).as(pair).isTrue();
        Point c = b.center();
        for (Point near : List.of(
                new Point(Math.nextUp(c.x()), c.y(), c.z()),
                new Point(Math.nextDown(c.x()), c.y(), c.z()),
                new Point(c.x(), c.y(), Math.nextUp(c.z())),
                new Point(c.x(), c.y(), Math.nextDown(c.z())))) {
            GeometryObject moved = b.movedTo(near);
            assertThat(world.testObject(moved))
                    .as(pair + " moved to " + near)
                    .isEqualTo(Reference.overlap(a, moved, dimension));
        }
    }
}
