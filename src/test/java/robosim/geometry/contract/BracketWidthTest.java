package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.Verdict;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** The widest brackets of distances in space that are known, against the width that the page on numerics tells. */
class BracketWidthTest {
    @Test
    void aBoxAndACylinderAllButInContact() {
        GeometryObject box =
                new BoxObject(new Point(0, 0, 0), 1579.2455814713956, 2027.208820192783, 1110.4867515906567);
        GeometryObject cylinder = new CylinderObject(
                        new Point(-1077.4034005703818, -1090.726888217721, 771.0788331713684),
                        359.7257622933574,
                        154.24495624278842)
                .oriented(new double[] {
                    0.4058652675942235,
                    3.376289234132918E-13,
                    0.9139329212588139,
                    1.2621774483536189E-29,
                    1.0,
                    -3.694241837226473E-13,
                    -0.9139329212588139,
                    1.4993644518236984E-13,
                    0.4058652675942235
                });
        double sizes = 1579.25 + 2027.21 + 1110.49 + 4 * 359.73 + 154.24;
        assertNarrow(box, cylinder, sizes + 1077.40 + 1090.73 + 771.08);
    }

    @Test
    void aSphereAndATinyCylinderFarFromTheOrigin() {
        GeometryObject sphere = new SphereObject(
                new Point(689479.8361698777, -114020.3297680301, 566186.4303263506), 1.4084089008059597);
        GeometryObject cylinder = new CylinderObject(
                        new Point(689479.8341922179, -114021.74608757005, 566186.4269009434),
                        0.007910639129560944,
                        0.007910639129560944)
                .oriented(new double[] {0.8660254037844387, 0.5, 0.0, 0.0, 0.0, -1.0, -0.5, 0.8660254037844387, 0.0});
        assertNarrow(sphere, cylinder, 6 * 1.4084 + 5 * 0.00791 + 0.00198 + 1.41632 + 0.00343);
    }

    private static void assertNarrow(GeometryObject a, GeometryObject b, double size) {
        Verdict verdict = ContactQuery.distance(a, b, Budget.UNLIMITED);
        assertThat(verdict.high() - verdict.low()).isPositive().isLessThan(0x1p-44 * verdict.high() + 0x1p-45 * size);
    }
}
