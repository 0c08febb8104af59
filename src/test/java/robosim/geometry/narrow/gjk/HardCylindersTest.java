package robosim.geometry.narrow.gjk;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.narrow.CylinderTwin;
import robosim.geometry.narrow.Rows;
import robosim.geometry.narrow.SupportTwin;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Cylinders in the places where Newton's steps have least to hold on to: coaxial or parallel but for 10^-16 to 10^-1, rims that are
 * tangent, thin beside huge, a million away from the origin.
 *
 * <p>Against slabs in decimals, and against the search in double-doubles, which takes no such steps.
 */
class HardCylindersTest {
    private final Gjk gjk = new Gjk();
    private final Gjk fine = new Gjk();
    private SplittableRandom random = new SplittableRandom(71);

    @ParameterizedTest
    @EnumSource(names = {"CYLINDER", "UPRIGHT_CYLINDER", "BOX", "CAPSULE", "SPHERE"})
    void verdictsAndBracketsAreThoseOfDoubleDoubles(LeafKind kind) {
        random = new SplittableRandom(71 + kind.ordinal());
        int apart = 0;
        int deep = 0;
        int count = Effort.cases(4000);
        for (int n = 0; n < count; n++) {
            double[] r = random.nextInt(3) == 0 ? Rows.identity() : Rows.rotation(random);
            double[] a = Rows.cylinder(0, 0, 0, length(), length(), r);
            double[] b = leaf(kind, tilted(r));
            place(a, r, kind, b);
            Leaf leafA = new Leaf(LeafKind.CYLINDER, a, 0);
            Leaf leafB = new Leaf(kind, b, 0);
            String pair = Arrays.toString(a) + " with " + kind + " " + Arrays.toString(b);
            fine.spatial(leafA, leafB);
            fine.close();
            int verdict = gjk.decide(leafA, leafB);
            assertThat(gjk.decide(leafB, leafA)).as(pair).isEqualTo(verdict);
            gjk.spatial(leafA, leafB);
            assertThat(gjk.isDeep() && gjk.lower() > 0).as(pair).isFalse();
            if (verdict > 0 || gjk.isDeep()) {
                deep++;
                assertThat(fine.lower()).as(pair).isLessThanOrEqualTo(0);
            }
            assertThat(gjk.upper()).as(pair).isGreaterThanOrEqualTo(fine.lower() - gjk.error());
            assertThat(gjk.lower()).as(pair).isLessThanOrEqualTo(fine.upper() + gjk.error());
            if (gjk.lower() > 0) {
                apart++;
                assertThat(fine.isDeep()).as(pair).isFalse();
                BigDecimal[] way = CylinderTwin.decimals(gjk.nx(), gjk.ny(), gjk.nz());
                BigDecimal slab = new SupportTwin(LeafKind.CYLINDER, a).gap(new SupportTwin(kind, b), way);
                assertThat(new BigDecimal(gjk.lower())).as(pair).isLessThanOrEqualTo(slab);
                assertThat(new BigDecimal(gjk.upper() + gjk.error())).as(pair).isGreaterThanOrEqualTo(slab);
            }
        }
        assertThat(apart).isBetween(count / 5, count * 9 / 10);
        assertThat(deep).isBetween(count / 10, count * 8 / 10);
    }

    private double length() {
        return random.nextInt(4) == 0 ? StrictMath.pow(10, random.nextDouble(-6, 3)) : random.nextDouble(0.2, 1.5);
    }

    private double[] leaf(LeafKind kind, double[] r) {
        return switch (kind) {
            case BOX -> Rows.box(0, 0, 0, length(), length(), length(), r);
            case SPHERE -> Rows.sphere(0, 0, 0, length());
            case UPRIGHT_CYLINDER -> Rows.cylinder(0, 0, 0, length(), length(), Rows.identity());
            default -> Rows.cylinder(0, 0, 0, length(), length(), r);
        };
    }

    /** The same attitude, tilted a little, lying across, or any. */
    private double[] tilted(double[] r) {
        double angle = StrictMath.pow(10, random.nextDouble(-16, -1));
        double[] column = new double[9];
        int how = random.nextInt(4);
        double c = how == 0 ? 1 : how == 1 ? StrictMath.cos(angle) : 0;
        double s = how == 0 ? 0 : how == 1 ? StrictMath.sin(angle) : 1;
        for (int row = 0; row < 9; row += 3) {
            column[row] = r[row];
            column[row + 1] = c * r[row + 1] + s * r[row + 2];
            column[row + 2] = c * r[row + 2] - s * r[row + 1];
        }
        return how == 3 ? Rows.rotation(random) : column;
    }

    /** Coaxial, rim by rim, side by side, or anywhere near; then far from the origin. */
    private void place(double[] a, double[] r, LeafKind kind, double[] b) {
        double half = kind == LeafKind.SPHERE ? 0 : b[4];
        double off = 1 + random.nextInt(-1, 2) * StrictMath.pow(10, random.nextDouble(-17, -2));
        double side = random.nextInt(-1, 2) * b[3] + a[3];
        double share = random.nextDouble(-1.5, 1.5);
        double[] by = switch (random.nextInt(4)) {
            case 0 -> new double[] {0, share * (a[4] + half)};
            case 1 -> new double[] {side * off, (a[4] + half) / off};
            case 2 -> new double[] {(a[3] + b[3]) * off, share * a[4]};
            default -> new double[] {share * (a[3] + b[3]), random.nextDouble(-1.5, 1.5) * (a[4] + half)};
        };
        double far = random.nextInt(3) == 0 ? 1e6 : 0;
        for (int k = 0; k < 3; k++) {
            double origin = far * random.nextDouble(-1, 1);
            a[k] = origin;
            b[k] = origin + by[0] * r[3 * k] + by[1] * r[3 * k + 1];
        }
    }
}
