package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

/** Motions of things that are tiny, or very high up: what they meet does not depend on it. */
class SweepScaleTest {
    private final Scratch scratch = new Scratch();
    private final Sweep sweep = new Sweep(scratch);

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void areAsFreeAsLargerOnes(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(30_061);
        int met = 0;
        int free = 0;
        for (int k = 0; k < 3000; k++) {
            int power = -random.nextInt(210, 1072);
            LeafKind kindA = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            LeafKind kindB = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            LeafColumn a = column(kindA, SweepRows.random(kindA, 2, random), power);
            LeafColumn b = column(kindB, SweepRows.random(kindB, 2, random), power);
            double[] by = {random.nextDouble(-3, 3), random.nextDouble(-3, 3), random.nextDouble(-3, 3)};
            for (int m = 0; m < 3; m++) {
                by[m] = Math.scalb(by[m], power);
            }
            boolean isMoved = k % 2 == 0 || kindA == LeafKind.PRISM || kindB == LeafKind.PRISM;
            double degrees = isMoved ? 0 : random.nextDouble(-400, 400);
            boolean tilts = random.nextBoolean();
            double tiny = share(dimension, a, b, by, degrees, tilts, 0);
            double large = share(dimension, a, b, by, degrees, tilts, Math.min(1000, -power));
            String what = "kinds %s and %s at 2^%d, turned by %s".formatted(kindA, kindB, power, degrees);
            if (large <= 1) {
                assertThat(tiny).as(what).isCloseTo(large, within(1e-9));
                met++;
            } else {
                assertThat(tiny).as(what).isEqualTo(large);
                free++;
            }
        }
        assertThat(met).isGreaterThan(300);
        assertThat(free).isGreaterThan(300);
    }

    /** Of a turned cylinder at the height of 2^60, seen from above; some begin in contact. */
    @Test
    void heightsDoNotCountInThePlane() {
        SplittableRandom random = new SplittableRandom(30_062);
        int met = 0;
        int free = 0;
        for (int k = 0; k < 400; k++) {
            LeafKind kind = Leaves.KINDS[random.nextInt(4)];
            double[] a = SweepRows.random(LeafKind.CYLINDER, 1.5, random);
            double[] b = SweepRows.random(kind, 1.5, random);
            double[] by = {random.nextDouble(-1, 1), 0, random.nextDouble(-1, 1)};
            double degrees = random.nextDouble(-200, 200);
            double low =
                    share(Dimension.PLANAR, column(LeafKind.CYLINDER, a, 0), column(kind, b, 0), by, degrees, false, 0);
            a[1] = 0x1p60;
            b[1] = -0x1p60;
            double high =
                    share(Dimension.PLANAR, column(LeafKind.CYLINDER, a, 0), column(kind, b, 0), by, degrees, false, 0);
            assertThat(high).as("case %d, kind %s, by %s", k, kind, degrees).isEqualTo(low);
            met += low <= 1 ? 1 : 0;
            free += low <= 1 ? 0 : 1;
        }
        assertThat(met).isGreaterThan(60);
        assertThat(free).isGreaterThan(60);
    }

    /** What is tiny on the floor is as free high up, where it may stand on something large. */
    @Test
    void heightsDoNotCountForWhatIsTinyInThePlane() {
        SplittableRandom random = new SplittableRandom(30_063);
        int met = 0;
        int free = 0;
        for (int k = 0; k < 3000; k++) {
            int power = -random.nextInt(210, 1072);
            LeafKind kindA = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            LeafKind kindB = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            LeafColumn a = column(kindA, SweepRows.random(kindA, 2, random), power);
            LeafColumn b = column(kindB, SweepRows.random(kindB, 2, random), power);
            double[] by = {random.nextDouble(-3, 3), 0, random.nextDouble(-3, 3)};
            by[0] = Math.scalb(by[0], power);
            by[2] = Math.scalb(by[2], power);
            boolean isMoved = k % 2 == 0 || kindA == LeafKind.PRISM || kindB == LeafKind.PRISM;
            double degrees = isMoved ? 0 : random.nextDouble(-400, 400);
            double low = share(Dimension.PLANAR, a, b, by, degrees, false, 0);
            lift(a);
            lift(b);
            by[1] = 0.75;
            double high = share(Dimension.PLANAR, a, b, by, degrees, false, 0);
            assertThat(high)
                    .as("case %d, kinds %s and %s at 2^%d, turned by %s", k, kindA, kindB, power, degrees)
                    .isEqualTo(low);
            met += low <= 1 ? 1 : 0;
            free += low <= 1 ? 0 : 1;
        }
        assertThat(met).isGreaterThan(300);
        assertThat(free).isGreaterThan(300);
    }

    private static void lift(LeafColumn column) {
        double[] row = column.rows();
        switch (column.kind(0)) {
            case TRIANGLE -> {
                row[1] += 0.5;
                row[4] += 1.5;
                row[7] += 0.25;
            }
            case PRISM -> {
                row[8] += 0.5;
                row[9] += 1.5;
            }
            case UPRIGHT_BOX, UPRIGHT_CYLINDER -> {
                row[1] += 0.5;
                row[4] += 0.25;
            }
            default -> row[1] += 0.5;
        }
    }

    /** By straight ways, and where there is an angle by turns. */
    private double share(
            Dimension dimension, LeafColumn a, LeafColumn b, double[] by, double degrees, boolean tilts, int power) {
        double x = Math.scalb(by[0], power);
        double y = Math.scalb(by[1], power);
        double z = Math.scalb(by[2], power);
        if (degrees == 0) {
            sweep.translation(dimension, x, y, z);
        } else {
            sweep.turn(dimension).about(x, y, z).by(tilts ? 0.6 : 0, tilts ? 0 : 1, tilts ? 0.8 : 0, degrees);
        }
        return sweep.free(column(a.kind(0), a.rows(), power), 0, column(b.kind(0), b.rows(), power), 0);
    }

    private static LeafColumn column(LeafKind kind, double[] row, int power) {
        LeafColumn column = new LeafColumn(1);
        column.append(1);
        column.setKind(0, kind);
        int lengths = kind == LeafKind.TRIANGLE ? 9 : kind == LeafKind.PRISM ? 10 : 6;
        for (int k = 0; k < Leaf.STRIDE; k++) {
            column.rows()[k] = k < lengths ? Math.scalb(row[k], power) : row[k];
        }
        return column;
    }
}
