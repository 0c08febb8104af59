package robosim.geometry.narrow.ray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.PlanarRows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;
import robosim.geometry.reference.Twofold;

public class PlanarRayTest {
    private final Scratch scratch = new Scratch();
    private double worst;

    private double ray(double ox, double oz, double ux, double uz, LeafKind kind, double[] row) {
        return PlanarRay.distance(new BeamAxis().line(ox, 0, oz, ux, 0, uz), kind, row, 0, scratch.ray);
    }

    public static String text(double ox, double oz, double ux, double uz, LeafKind kind, double[] row) {
        return "ray (%s, %s) -> (%s, %s), kind %s %s".formatted(ox, oz, ux, uz, kind, Arrays.toString(row));
    }

    /** True where it hits; also compares the distance, in ulp of the largest number that went in. */
    private boolean checked(double ox, double oz, double ux, double uz, LeafKind kind, double[] row, double ulps) {
        Form form = PlanarRows.form(kind);
        double[] ray = {ox, 0, oz, ux, 0, uz};
        boolean truth = PlanarTwin.exactly(number -> Truth.planarRay(number, ray, form, row));
        double distance = ray(ox, oz, ux, uz, kind, row);
        String text = text(ox, oz, ux, uz, kind, row);
        assertThat(distance < Double.POSITIVE_INFINITY).as(text).isEqualTo(truth);
        assertThat(distance).as(text).isGreaterThanOrEqualTo(0);
        if (truth) {
            double right = truth(ray, form, row);
            double size = Math.max(right, Math.max(Math.abs(ox), Math.abs(oz)));
            for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 6); k++) {
                size = Math.max(size, Math.abs(row[k]));
            }
            double off = Math.abs(distance - right) / Math.ulp(size);
            worst = Math.max(worst, off);
            assertThat(off).as(text + " is " + distance + ", not " + right).isLessThanOrEqualTo(ulps);
            if (right == 0) {
                assertThat(distance).as(text).isZero();
            }
        }
        return truth;
    }

    /** Of a ray that hits: how far, rounded once. */
    private static double truth(double[] ray, Form form, double[] row) {
        double[] start = Arrays.copyOf(ray, Leaf.STRIDE);
        Arrays.fill(start, 3, Leaf.STRIDE, 0);
        if (PlanarTwin.touch(Form.SPHERE, start, form, row)) {
            return 0;
        }
        return along(PlanarTwin.of(form, row), ray[0], ray[2], ray[3], ray[5]);
    }

    private static double along(PlanarTwin twin, double ox, double oz, double dx, double dz) {
        Twofold ux = Twofold.of(dx);
        Twofold uz = Twofold.of(dz);
        Twofold entry = twin.entry(ox, oz, ux, uz);
        return entry == null
                ? Double.POSITIVE_INFINITY
                : entry.times(PlanarTwin.dot(ux, uz, ux, uz).root()).head();
    }

    @Test
    void randomRaysAgreeWithTheReference() {
        PlanarRows rows = new PlanarRows(11);
        int hits = 0;
        int count = 4000;
        for (int k = 0; k < count; k++) {
            LeafKind kind = rows.exactKind();
            double[] row = rows.row(kind, 1, 1);
            double t = rows.between(4);
            double ox = row[0] + 2 * StrictMath.cos(t) + rows.between(0.5);
            double oz = row[2] + 2 * StrictMath.sin(t) + rows.between(0.5);
            double aim = Math.toRadians(rows.between(35));
            double ux = -StrictMath.cos(t + aim) * 3;
            double uz = -StrictMath.sin(t + aim) * 3;
            hits += checked(ox, oz, ux, uz, kind, row, 4) ? 1 : 0;
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 7 / 10);
    }

    @Test
    void discsGrazedFromAfarAreAsGoodAsNearOnes() {
        PlanarRows rows = new PlanarRows(14);
        int hits = 0;
        int count = 2000;
        for (int k = 0; k < count; k++) {
            double[] row = new double[Leaf.STRIDE];
            row[3] = 1;
            double angle = rows.between(3.2);
            double far = 2 + StrictMath.exp(rows.random().nextDouble() * 16);
            double aim = angle + StrictMath.asin((1 + rows.between(1e-9)) / far);
            hits += checked(
                            far * StrictMath.cos(angle),
                            far * StrictMath.sin(angle),
                            -StrictMath.cos(aim),
                            -StrictMath.sin(aim),
                            LeafKind.UPRIGHT_CYLINDER,
                            row,
                            4)
                    ? 1
                    : 0;
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 7 / 10);
        assertThat(worst).isGreaterThan(0.2);
    }

    @Test
    void rectanglesMetAtLowAnglesAreAsGood() {
        PlanarRows rows = new PlanarRows(15);
        int hits = 0;
        int count = 2000;
        for (int k = 0; k < count; k++) {
            double heading = rows.between(180);
            double[] row = rows.row(LeafKind.UPRIGHT_BOX, 10, 5);
            PlanarRows.upright(row, heading);
            double c = row[6];
            double s = row[8];
            double along = 20 + 1000 * rows.random().nextDouble();
            double off = row[5] + rows.between(8e-3);
            double slope = rows.random().nextDouble() * 1e-5;
            double ox = row[0] - along * c + off * s;
            double oz = row[2] + along * s + off * c;
            double ux = c - slope * s;
            double uz = -s - slope * c;
            hits += checked(ox, oz, ux, uz, LeafKind.UPRIGHT_BOX, row, 4) ? 1 : 0;
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 8 / 10);
    }

    @Test
    void boxesAtAnAttitudeAndTrianglesMetAtLowAnglesAreAsGood() {
        PlanarRows rows = new PlanarRows(19);
        int hits = 0;
        int count = 2000;
        for (int k = 0; k < count; k++) {
            LeafKind kind = k % 2 == 0 ? LeafKind.BOX : LeafKind.TRIANGLE;
            double[] row = rows.row(kind, 10, 5);
            double dirX = kind == LeafKind.BOX ? row[6] : row[3] - row[0];
            double dirZ = kind == LeafKind.BOX ? row[12] : row[5] - row[2];
            if (dirX == 0 && dirZ == 0) {
                continue;
            }
            // towards a point of the leaf at a low angle to a side
            double along = 20 + 1000 * rows.random().nextDouble();
            double slope = rows.between(1e-5);
            double offX = kind == LeafKind.BOX ? row[5] * row[8] + row[4] * row[7] : 0;
            double offZ = kind == LeafKind.BOX ? row[5] * row[14] + row[4] * row[13] : 0;
            double ux = dirX - slope * dirZ;
            double uz = dirZ + slope * dirX;
            double ox = row[0] + offX - along * ux + rows.between(1e-4);
            double oz = row[2] + offZ - along * uz + rows.between(1e-4);
            hits += checked(ox, oz, ux, uz, kind, row, 4) ? 1 : 0;
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 8 / 10);
    }

    @Test
    void directionsOfAnyLengthGiveTheSame() {
        PlanarRows rows = new PlanarRows(16);
        int hits = 0;
        LeafKind[] kinds = Leaves.KINDS;
        for (int k = 0; k < 500; k++) {
            LeafKind kind = kinds[k % 7];
            double[] row = rows.row(kind, 1, 1);
            double ux = rows.random().nextInt(-8, 9);
            double uz = rows.random().nextInt(1, 9);
            double distance = ray(-ux, -uz, ux, uz, kind, row);
            for (int exponent : new int[] {-1070, -700, -190, 90}) {
                double scaled = ray(-ux, -uz, Math.scalb(ux, exponent), Math.scalb(uz, exponent), kind, row);
                assertThat(scaled).as(text(-ux, -uz, ux, uz, kind, row)).isEqualTo(distance);
            }
            hits += distance < Double.POSITIVE_INFINITY ? 1 : 0;
        }
        assertThat(hits).isBetween(100, 400);
    }

    @Test
    void ovalsAndOctagonsAreMetWhereTheirOutlineIs() {
        PlanarRows rows = new PlanarRows(17);
        int hits = 0;
        int count = 3000;
        for (int k = 0; k < count; k++) {
            LeafKind kind = k % 2 == 0 ? LeafKind.CYLINDER : LeafKind.PRISM;
            double[] row = rows.row(kind, 0, 1);
            double angle = rows.between(3.2);
            double far = k % 10 == 0 ? 1e5 : 3;
            double ox = far * StrictMath.cos(angle);
            double oz = far * StrictMath.sin(angle);
            double tx = rows.between(1.2);
            double tz = rows.between(1.2);
            double length = StrictMath.hypot(tx - ox, tz - oz);
            double ux = (tx - ox) / length;
            double uz = (tz - oz) / length;
            double distance = ray(ox, oz, ux, uz, kind, row);
            PlanarTwin twin = PlanarRows.twin(kind, row);
            double truth = along(twin, ox, oz, ux, uz);
            String text = text(ox, oz, ux, uz, kind, row);
            if (twin.isOval) {
                // What passes by less than rounding may be met.
                double least = along(twin.grown(1e-12 * far), ox, oz, ux, uz);
                assertThat(distance).as(text).isBetween(least - 1e-9, truth + 1e-9);
            } else if (truth < Double.POSITIVE_INFINITY) {
                assertThat(distance).as(text).isCloseTo(truth, within(1e-9));
            } else {
                assertThat(distance).as(text).isInfinite();
            }
            hits += truth < Double.POSITIVE_INFINITY ? 1 : 0;
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 8 / 10);
    }

    @Test
    void startsInsideAreAtNoDistance() {
        PlanarRows rows = new PlanarRows(18);
        for (int k = 0; k < 700; k++) {
            LeafKind kind = Leaves.KINDS[k % 7];
            double[] row = rows.row(kind, 1, 1);
            double x = kind == LeafKind.TRIANGLE ? (row[0] + row[3] + row[6]) / 3 : row[0];
            double z = kind == LeafKind.TRIANGLE ? (row[2] + row[5] + row[8]) / 3 : row[2];
            if (kind == LeafKind.PRISM || (kind == LeafKind.TRIANGLE && row[0] == row[3])) {
                continue;
            }
            assertThat(ray(x, z, rows.between(1), 1, kind, row)).isZero();
        }
    }
}
