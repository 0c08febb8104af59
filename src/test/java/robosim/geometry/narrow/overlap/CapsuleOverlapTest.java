package robosim.geometry.narrow.overlap;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;
import robosim.geometry.reference.Reference;

/** A capsule that touches everything, at whole numbers. The census and the stress families have the random cases. */
class CapsuleOverlapTest {
    private final Scratch scratch = new Scratch();

    /** Pythagorean contacts, exact at any power of two. */
    @Test
    void wholeNumbersTouch() {
        for (double unit : new double[] {1, 0x1p-300, 0x1p60}) {
            CapsuleObject capsule = new CapsuleObject(new Point(), 5 * unit, 8 * unit);
            touches(capsule, new SphereObject(new Point(3 * unit, 4 * unit + 4 * unit, 0), 0), unit);
            touches(capsule, new SphereObject(new Point(6 * unit, 12 * unit, 0), 5 * unit), unit);
            touches(capsule, new CapsuleObject(new Point(6 * unit, 15 * unit, 0), 5 * unit, 6 * unit), unit);
            touches(
                    capsule,
                    new CapsuleObject(new Point(7 * unit, 0, 24 * unit), 20 * unit, 2 * unit).turned(90, 0),
                    unit);
            touches(capsule, new BoxObject(new Point(3.5 * unit, 8.5 * unit, 0), unit, unit, unit), unit);
            touches(capsule, new BoxObject(new Point(0, 9.5 * unit, 0), 9 * unit, unit, 9 * unit), unit);
            // By its side, along all of it.
            touches(capsule, new BoxObject(new Point(5.5 * unit, 0, 0), unit, 30 * unit, unit), unit);
            // Through the segment, with all of the surface far away.
            assertThat(overlap(capsule, new BoxObject(new Point(), 100 * unit, 0, 100 * unit)))
                    .isTrue();
            assertThat(overlap(capsule, new SphereObject(new Point(), 100 * unit)))
                    .isTrue();
        }
    }

    private void touches(GeometryObject a, GeometryObject b, double unit) {
        assertThat(Reference.overlap(a, b, Dimension.SPATIAL)).as(a + " | " + b).isTrue();
        assertThat(overlap(a, b)).as(a + " | " + b).isTrue();
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                Point c = b.center();
                double step = side * 0x1p-50 * 8 * unit;
                GeometryObject moved = b.movedTo(new Point(
                        c.x() + (axis == 0 ? step : 0),
                        c.y() + (axis == 1 ? step : 0),
                        c.z() + (axis == 2 ? step : 0)));
                assertThat(overlap(a, moved))
                        .as(a + " | " + moved)
                        .isEqualTo(Reference.overlap(a, moved, Dimension.SPATIAL));
            }
        }
    }

    private boolean overlap(GeometryObject a, GeometryObject b) {
        LeafColumn one = LocalLeaves.placed(a);
        LeafColumn two = LocalLeaves.placed(b);
        return SpatialOverlap.test(
                new Leaf(one.kind(0), one.rows(), 0), new Leaf(two.kind(0), two.rows(), 0), scratch.overlap);
    }
}
