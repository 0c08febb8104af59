package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.Verdict;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
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

    /** Cylinders, turned, from contact up to a millionth of their sizes away from each other and from capsules. */
    @Test
    void aRandomSample() {
        SplittableRandom random = new SplittableRandom(36752);
        double widest = 0;
        int cases = Effort.cases(2_000, 500);
        for (int k = 0; k < cases; k++) {
            double p = StrictMath.pow(10, random.nextDouble(-3, 3));
            double q = StrictMath.pow(10, random.nextDouble(-3, 3));
            double r = StrictMath.pow(10, random.nextDouble(-3, 3));
            double half = StrictMath.pow(10, random.nextDouble(-3, 3));
            GeometryObject a = new CylinderObject(new Point(), p, q).turned(random.nextDouble(-180, 180), 0);
            GeometryObject b = k % 2 == 0
                    ? new CylinderObject(new Point(), r, half)
                            .turned(random.nextDouble(-180, 180), random.nextDouble(90))
                    : new CapsuleObject(new Point(), r, half)
                            .turned(random.nextDouble(-180, 180), random.nextDouble(90));
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double near = 0;
            double far = 3 * (p + q + r + half) / Math.max(0.1, Math.abs(x) + Math.abs(y));
            for (int step = 0; step < 58; step++) {
                double middle = near / 2 + far / 2;
                boolean isApart =
                        !CollisionDetection.intersects(a, b.movedTo(new Point(middle * x, middle * y, middle / 3)));
                near = isApart ? near : middle;
                far = isApart ? middle : far;
            }
            far *= 1 + (k % 3 == 0 ? 0 : StrictMath.pow(10, -random.nextDouble(6, 15)));
            GeometryObject there = b.movedTo(new Point(far * x, far * y, far / 3));
            Verdict verdict = ContactQuery.distance(a, there, Budget.UNLIMITED);
            double size = 4 * p + q + (k % 2 == 0 ? 4 : 6) * r + half + far * (Math.abs(x) + Math.abs(y) + 1.0 / 3);
            widest = Math.max(widest, (verdict.high() - verdict.low()) / (0x1p-44 * verdict.high() + 0x1p-45 * size));
        }
        assertThat(widest).isBetween(0.1, 0.76);
    }

    private static void assertNarrow(GeometryObject a, GeometryObject b, double size) {
        Verdict verdict = ContactQuery.distance(a, b, Budget.UNLIMITED);
        assertThat(verdict.high() - verdict.low()).isPositive().isLessThan(0x1p-44 * verdict.high() + 0x1p-45 * size);
    }
}
