package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** Half of every size is a double, also of the least ones, so verdicts are those of the sizes that an object reports. */
class HalvedSizesTest {
    private static final double LEAST = Double.MIN_VALUE;

    @Test
    void theLeastSizesAreThoseReported() {
        SplittableRandom random = new SplittableRandom(36027);
        int touching = 0;
        int odd = 0;
        int cases = Effort.cases(20_000, 7_000);
        for (int k = 0; k < cases; k++) {
            int[] a = {random.nextInt(12), random.nextInt(12), random.nextInt(12)};
            int[] b = {random.nextInt(12), random.nextInt(12), random.nextInt(12)};
            int[] off = {random.nextInt(-8, 9), random.nextInt(-8, 9), random.nextInt(-8, 9)};
            BoxObject one = new BoxObject(new Point(), a[0] * LEAST, a[1] * LEAST, a[2] * LEAST);
            BoxObject two = new BoxObject(
                    new Point(off[0] * LEAST, off[1] * LEAST, off[2] * LEAST),
                    b[0] * LEAST,
                    b[1] * LEAST,
                    b[2] * LEAST);
            boolean truth = 2 * Math.abs(off[0]) <= units(one.width()) + units(two.width())
                    && 2 * Math.abs(off[1]) <= units(one.height()) + units(two.height())
                    && 2 * Math.abs(off[2]) <= units(one.length()) + units(two.length());
            assertThat(CollisionDetection.intersects(one, two))
                    .as(one + " " + two)
                    .isEqualTo(truth);
            assertThat(Math.abs(one.width() - a[0] * LEAST)).isLessThanOrEqualTo(LEAST);
            touching += truth ? 1 : 0;
            odd += a[0] % 2 + b[0] % 2;
        }
        assertThat(touching).isBetween(cases / 10, cases * 9 / 10);
        assertThat(odd).isGreaterThan(cases / 2);
    }

    private static long units(double size) {
        assertThat(size / 2 * 2).isEqualTo(size);
        return Double.doubleToRawLongBits(size); // of a subnormal number
    }

    @Test
    void othersAreKept() {
        for (double size : new double[] {0, 2 * LEAST, Double.MIN_NORMAL, Math.nextUp(0x1p-1021), 0.1, 1e30}) {
            assertThat(new BoxObject(new Point(), size, size, size).height()).isEqualTo(size);
            assertThat(new CylinderObject(new Point(), 3 * LEAST, size).height())
                    .isEqualTo(size);
            assertThat(new CapsuleObject(new Point(), 3 * LEAST, size).segment())
                    .isEqualTo(size);
        }
        GeometryObject odd = new CylinderObject(new Point(), 3 * LEAST, 3 * LEAST);
        assertThat(odd).isEqualTo(new CylinderObject(new Point(), 3 * LEAST, 4 * LEAST));
    }
}
