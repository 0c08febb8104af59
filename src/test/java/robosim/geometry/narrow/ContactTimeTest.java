package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.MovedLeaf;
import robosim.geometry.narrow.sweep.PlanarSweep;
import robosim.geometry.narrow.sweep.SpatialSweep;
import robosim.geometry.reference.Decimals;
import robosim.geometry.reference.HullMotion;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.StartTruth;
import robosim.geometry.reference.Truth.Form;
import robosim.geometry.reference.WayTruth;

/** Times of contact of straight motions against exact twins, where rounding is at its worst: one double down, no more. */
class ContactTimeTest {
    private static final double FREE = Double.POSITIVE_INFINITY;
    private static final LeafKind[] FLAT = {
        LeafKind.UPRIGHT_BOX, LeafKind.UPRIGHT_CYLINDER, LeafKind.SPHERE, LeafKind.BOX, LeafKind.TRIANGLE
    };
    private static final LeafKind[] SOLID = {LeafKind.UPRIGHT_BOX, LeafKind.BOX, LeafKind.TRIANGLE};

    private final Scratch scratch = new Scratch();
    private final SplittableRandom random = new SplittableRandom(30051);
    private int hits;
    private int misses;
    private int contacts;
    private int into;

    @Test
    void flatThingsNearlyInLine() {
        int count = Effort.cases(210);
        for (int k = 0; k < count; k++) {
            LeafKind kindA = FLAT[random.nextInt(FLAT.length)];
            LeafKind kindB = FLAT[random.nextInt(FLAT.length)];
            double[] a = nearlyInLine(kindA);
            double[] b = nearlyInLine(kindB);
            double[] d = move();
            d[1] = 0;
            if (k % 3 == 0) {
                a = broughtToContact(kindA, a, d, kindB, b);
            }
            flat(kindA, a, d[0], d[2], kindB, b, 1);
        }
        assertThat(hits).isGreaterThan(count / 18);
        assertThat(misses).isGreaterThan(count / 5);
        assertThat(contacts).isGreaterThan(count / 18);
        assertThat(into).isBetween(contacts / 5, contacts * 4 / 5);
    }

    @Test
    void flatThingsFarAwayAndOfAnySize() {
        int count = Effort.cases(180);
        for (int k = 0; k < count; k++) {
            LeafKind kindA = FLAT[random.nextInt(FLAT.length)];
            LeafKind kindB = FLAT[random.nextInt(FLAT.length)];
            double scale = Math.scalb(1.0, new int[] {-300, -40, 0, 40}[k % 4]);
            double[] a = scaled(kindA, SweepRows.random(kindA, 1.5, random), scale);
            double[] b = scaled(kindB, SweepRows.random(kindB, 1.5, random), scale);
            double far = scale * new double[] {0, 1e6, 1e9}[k % 3];
            double[] d = move();
            a = shifted(kindA, a, far);
            flat(kindA, a, d[0] * scale, d[2] * scale, kindB, shifted(kindB, b, far), scale);
        }
        assertThat(hits).isGreaterThan(count / 12);
        assertThat(misses).isGreaterThan(count / 12);
    }

    @Test
    void solidThings() {
        int count = Effort.cases(120);
        for (int k = 0; k < count; k++) {
            LeafKind kindA = SOLID[random.nextInt(SOLID.length)];
            LeafKind kindB = SOLID[random.nextInt(SOLID.length)];
            double scale = Math.scalb(1.0, new int[] {-40, 0, 0, 40}[k % 4]);
            double far = scale * new double[] {0, 0, 1e6}[k % 3];
            double[] a = scaled(kindA, k % 2 == 0 ? nearlyInLine(kindA) : SweepRows.random(kindA, 1.5, random), scale);
            double[] b = scaled(kindB, SweepRows.random(kindB, 1, random), scale);
            double[] d = move();
            for (int axis = 0; axis < 3; axis++) {
                // Towards each other, more or less.
                d[axis] = scale * (k % 5 == 0 ? d[axis] : d[axis] / 4 + 3 * (b[axis] - a[axis]) / scale);
            }
            solid(kindA, shifted(kindA, a, far), d, kindB, shifted(kindB, b, far));
        }
        assertThat(hits).isGreaterThan(count / 5);
        assertThat(misses).isGreaterThan(count / 10);
    }

    @Test
    void contactAtTheStartIsJudgedExactlyOnAGrid() {
        int free = 0;
        int count = Effort.cases(270);
        for (int k = 0; k < count; k++) {
            LeafKind kindA = random.nextInt(3) == 0 ? LeafKind.TRIANGLE : LeafKind.BOX;
            double[] a = wholeNumbers(kindA);
            double[] b = wholeNumbers(LeafKind.BOX);
            double[] d = {random.nextInt(-1, 2), random.nextInt(-1, 2), random.nextInt(-1, 2)};
            GridHull hull = new GridHull(corners(kindA, a), corners(LeafKind.BOX, b));
            if (!hull.touches()) {
                continue;
            }
            String what = what(kindA, a, d, LeafKind.BOX, b);
            boolean deeper = hull.goesDeeper(d);
            double time = SpatialSweep.translation(
                    new Leaf(kindA, a, 0), d[0], d[1], d[2], new Leaf(LeafKind.BOX, b, 0), scratch.sweep);
            assertThat(time).as(what).isEqualTo(deeper ? 0 : FREE);
            into += deeper ? 1 : 0;
            free += deeper ? 0 : 1;
        }
        assertThat(into).isGreaterThan(count / 23);
        assertThat(free).isGreaterThan(count / 23);
    }

    @Test
    void aDiscMeetsTheFaceOfABoxThatLeansByARounding() {
        // The box's upright edges are seen as a third pair of edges, 2^-53 long and in line with the first.
        double[] box = SweepRows.uprightBox(0, 0, 0, 1, 1, 1, 0);
        for (double lean = 0x1p-56; lean < 0x1p-40; lean *= 2) {
            box[11] = -lean;
            box[13] = lean;
            for (int k = 0; k < 40; k++) {
                double[] disc = SweepRows.disc(0.05 * (k - 20), 0, -3, 0x1p-30, 1);
                double time = PlanarSweep.translation(
                        new Leaf(LeafKind.SPHERE, disc, 0),
                        0x1p-60,
                        0,
                        4,
                        new Leaf(LeafKind.BOX, box, 0),
                        scratch.sweep);
                assertThat(time).isBetween(0.49, 0.51);
                flat(LeafKind.SPHERE, disc, 0x1p-60, 4, LeafKind.BOX, box, 1);
            }
        }
    }

    private void flat(LeafKind kindA, double[] a, double dx, double dz, LeafKind kindB, double[] b, double unit) {
        String what = what(kindA, a, new double[] {dx, 0, dz}, kindB, b);
        double time = PlanarSweep.translation(new Leaf(kindA, a, 0), dx, 17, dz, new Leaf(kindB, b, 0), scratch.sweep);
        double[] p = scaled(kindA, a, 1 / unit);
        double[] q = scaled(kindB, b, 1 / unit);
        double x = dx / unit;
        double z = dz / unit;
        Form formA = PlanarRows.form(kindA);
        Form formB = PlanarRows.form(kindB);
        if (PlanarTwin.touch(formA, p, formB, q)) {
            contacts++;
            boolean deeper = StartTruth.out(formA, p, x, z, formB, q) < 0;
            into += deeper ? 1 : 0;
            assertThat(time).as(what).isEqualTo(deeper ? 0 : FREE);
        } else if (PlanarTwin.exactly(n -> WayTruth.planar(n, formA, p, x, z, formB, q))) {
            hits++;
            double next = Math.nextUp(time);
            assertThat(PlanarTwin.exactly(n -> WayTruth.planarBy(n, formA, p, x, z, time, time * 0x1p-200, formB, q)))
                    .as(what)
                    .isFalse();
            assertThat(PlanarTwin.exactly(n -> WayTruth.planarBy(n, formA, p, x, z, next, 0, formB, q)))
                    .as(what)
                    .isTrue();
        } else {
            misses++;
            assertThat(time).as(what).isEqualTo(FREE);
        }
    }

    private void solid(LeafKind kindA, double[] a, double[] d, LeafKind kindB, double[] b) {
        String what = what(kindA, a, d, kindB, b);
        double time =
                SpatialSweep.translation(new Leaf(kindA, a, 0), d[0], d[1], d[2], new Leaf(kindB, b, 0), scratch.sweep);
        HullMotion twin = HullMotion.of(corners(kindA, a), corners(kindB, b), d);
        if (twin == null || twin.compareTo(1) > 0) {
            misses++;
            assertThat(time).as(what).isEqualTo(FREE);
        } else if (twin.compareTo(0) == 0) {
            assertThat(time).as(what).isIn(0.0, FREE);
        } else {
            hits++;
            assertThat(twin.compareTo(time)).as(what).isNotNegative();
            assertThat(twin.compareTo(Math.nextUp(time))).as(what).isNegative();
        }
    }

    private double[] broughtToContact(LeafKind kindA, double[] a, double[] d, LeafKind kindB, double[] b) {
        double time =
                PlanarSweep.translation(new Leaf(kindA, a, 0), d[0], 0, d[2], new Leaf(kindB, b, 0), scratch.sweep);
        if (time > 1) {
            return a;
        }
        double[] pose = new double[Leaf.STRIDE];
        MovedLeaf.moved(
                new Leaf(kindA, a, 0), time * d[0], time * d[1], time * d[2], new Leaf(LeafKind.SPHERE, pose, 0));
        double x = d[0];
        if (random.nextBoolean()) { // and then across
            d[0] = -d[2];
            d[2] = x;
        }
        return pose;
    }

    private double[] move() {
        double[] d = {random.nextDouble(-4, 4), random.nextDouble(-4, 4), random.nextDouble(-4, 4)};
        switch (random.nextInt(4)) {
            case 0 -> d = new double[] {random.nextInt(-3, 4), 0, 0};
            case 1 -> d = new double[] {0x1p-60, 0, random.nextInt(-3, 4)};
            default -> {}
        }
        return d;
    }

    /** Turned by hardly more than quarter turns, thin, or with corners nearly on a line. */
    private double[] nearlyInLine(LeafKind kind) {
        double[] m = SweepRows.random(kind, 2, random);
        double little = Math.scalb(random.nextDouble(-1, 1), -random.nextInt(30, 56));
        double turn = 90 * random.nextInt(4);
        return switch (kind) {
            case UPRIGHT_BOX -> SweepRows.uprightBox(m[0], m[1], m[2], m[3], m[4], m[5], turn + little);
            case BOX ->
                SweepRows.box(
                        m[0],
                        m[1],
                        m[2],
                        m[3],
                        m[4],
                        m[5],
                        turn + little * random.nextInt(2),
                        little * random.nextInt(3),
                        little * random.nextInt(2));
            case TRIANGLE -> {
                for (int k = 0; k < 3; k++) {
                    m[6 + k] = m[k] + (m[3 + k] - m[k]) * random.nextInt(3) / 2 + little;
                }
                yield m;
            }
            case UPRIGHT_CYLINDER, SPHERE -> {
                m[3] = random.nextInt(4) == 0 ? Math.scalb(1.0, -random.nextInt(60)) : m[3];
                yield m;
            }
            case CYLINDER, PRISM -> m;
            case UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    // Columns of whole numbers, no more than about at right angles: what counts is that all is exact in longs.
    private double[] wholeNumbers(LeafKind kind) {
        double[] row = new double[Leaf.STRIDE];
        if (kind == LeafKind.TRIANGLE) {
            for (int k = 0; k < 9; k++) {
                row[k] = random.nextInt(-3, 4);
            }
            return row;
        }
        for (int k = 0; k < 3; k++) {
            row[k] = random.nextInt(-3, 4);
            row[3 + k] = random.nextInt(1, 3);
        }
        double[][] columns = {
            {1, 0, 0, 0, 1, 0, 0, 0, 1},
            {1, 1, 0, -1, 1, 0, 0, 0, 1},
            {1, 0, 1, 0, 1, 0, -1, 0, 1},
            {2, -1, 2, 2, 2, -1, -1, 2, 2}
        };
        System.arraycopy(columns[random.nextInt(4)], 0, row, Leaf.ROTATION, 9);
        return row;
    }

    private static List<BigDecimal[]> corners(LeafKind kind, double[] row) {
        return Decimals.corners(PlanarRows.form(kind), row);
    }

    private static double[] scaled(LeafKind kind, double[] row, double f) {
        double[] out = row.clone();
        int sizes = kind == LeafKind.TRIANGLE ? 9 : kind == LeafKind.PRISM ? 10 : 6;
        for (int k = 0; k < sizes; k++) {
            out[k] *= f;
        }
        return out;
    }

    private static double[] shifted(LeafKind kind, double[] row, double far) {
        double[] out = row.clone();
        MovedLeaf.moved(new Leaf(kind, row, 0), far, 0, -far, new Leaf(LeafKind.SPHERE, out, 0));
        return out;
    }

    private static String what(LeafKind kindA, double[] a, double[] d, LeafKind kindB, double[] b) {
        return "kind %s %s by %s, kind %s %s"
                .formatted(kindA, Arrays.toString(a), Arrays.toString(d), kindB, Arrays.toString(b));
    }
}
