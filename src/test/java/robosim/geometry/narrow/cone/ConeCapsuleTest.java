package robosim.geometry.narrow.cone;

import static org.assertj.core.api.Assertions.assertThat;
import static robosim.geometry.reference.Decimals.dot;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.ray.SpatialRay;
import robosim.geometry.narrow.ray.SpatialRayTest;
import robosim.geometry.reference.DecimalRoot;

/**
 * A capsule in a cone against decimals of 60 digits, in which the cosine is the stored one: the least distance of a ball
 * that goes along the segment, led to its minimum.
 */
class ConeCapsuleTest {
    private static final MathContext DIGITS = new MathContext(60);
    private static final BigDecimal ONE = BigDecimal.ONE;

    /** What is outside of the cone counts from here. */
    private static final BigDecimal NEVER = BigDecimal.TEN.pow(40);

    private final Scratch scratch = new Scratch();
    private final BigDecimal[] middle = new BigDecimal[3];
    private final BigDecimal[] arm = new BigDecimal[3];
    private final BigDecimal[] axis = new BigDecimal[3];
    private BigDecimal cos = ONE;
    private BigDecimal sin = ONE;
    private BigDecimal radius = ONE;

    @ParameterizedTest
    @EnumSource(names = {"UPRIGHT_CAPSULE", "CAPSULE"})
    void isHardlyBelowTheTruth(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(231 + kind.ordinal());
        int count = Effort.cases(120, 60);
        int heard = 0;
        int silent = 0;
        int grazing = 0;
        int between = 0;
        double worst = 0;
        for (int n = 0; n < count; n++) {
            double scale = Math.scalb(1.0, n % 7 == 0 ? random.nextInt(-300, 60) : 0);
            double half = StrictMath.pow(10, -random.nextDouble(0, n % 3 == 0 ? 5 : 2)) * 1.5;
            double cosine = StrictMath.cos(half);
            double[] d = SpatialRayTest.unit(Leaves.vector(random, 1));
            double[] o = Leaves.vector(random, scale);
            double[] row = capsule(kind, random, scale);
            double far = scale * StrictMath.pow(10, random.nextDouble(0, n % 5 == 0 ? 6 : 1));
            double angle = half * random.nextDouble(0, 1.5) + (n % 4 == 0 ? 0.3 : 0);
            double[] aim = turned(d, SpatialRayTest.unit(Leaves.vector(random, 1)), angle);
            for (int k = 0; k < 3; k++) {
                row[k] = o[k] + far * aim[k];
            }
            take(o, d, cosine, kind, row);
            boolean isGrazing = false;
            if (n % 2 == 0) {
                // As thick as it takes to touch the border, or by so little more or less.
                double gap = least(false)[0].doubleValue();
                if (gap > 0) {
                    isGrazing = true;
                    double off = random.nextInt(3) == 0
                            ? random.nextInt(-3, 4) * 0x1p-52
                            : (random.nextBoolean() ? 1 : -1) * StrictMath.pow(10, -random.nextDouble(3, 17));
                    row[3] = gap * (1 + off);
                    radius = new BigDecimal(row[3]);
                }
            }
            if (SpatialRay.distance(new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]), kind, row, 0, scratch.ray)
                    < 1e300) {
                continue; // the axis meets it, or starts in it: as exactly as for the ray
            }
            BigDecimal[] least = least(true);
            BigDecimal truth = least[0];
            String what = "half %s, %s truth %s"
                    .formatted(half, SpatialRayTest.name(o, d, kind, row), truth.round(new MathContext(20)));
            double answer = cone(o, d, cosine, kind, row);
            double size = far + row[3] + row[4];
            if (truth.compareTo(NEVER) >= 0) {
                silent++;
                double missed = truth.subtract(NEVER).subtract(radius).doubleValue();
                if (missed > 0x1p-44 * size) {
                    assertThat(answer).as(what).isInfinite();
                }
                continue;
            }
            heard++;
            grazing += isGrazing ? 1 : 0;
            between += Math.abs(least[1].doubleValue()) < 1 ? 1 : 0;
            assertThat(answer).as(what).isFinite();
            double below = truth.subtract(new BigDecimal(answer)).doubleValue();
            assertThat(below).as(what).isNotNegative();
            if (below > 0x1p-44 * size) {
                worst = Math.max(worst, below / truth.doubleValue());
                assertThat(worst).as(what).isLessThanOrEqualTo(0x1p-40);
            }
        }
        assertThat(heard).isGreaterThan(count * 2 / 10);
        assertThat(silent).isGreaterThan(count / 10);
        assertThat(grazing).isGreaterThan(count / 20);
        assertThat(between).isGreaterThan(count / 20);
    }

    /** A segment that touches the border from outside, between its ends, at a distance of 1: (1, 0, 1) at 60 degrees from (1, 1, 0). */
    @Test
    void aTangentSegmentIsHeard() {
        double[] d = {1, 1, 0};
        // Through (1, 0, 1) and along (1, -1, -1), which is square to the border there.
        double[] row = new double[16];
        row[0] = 1;
        row[2] = 1;
        row[4] = 1;
        row[7] = 1;
        row[10] = -1;
        row[13] = -1;
        assertThat(cone(new double[3], d, 0.5, LeafKind.CAPSULE, row))
                .isBetween(Math.sqrt(2) * (1 - 0x1p-40), Math.sqrt(2) * (1 + 0x1p-52));
        row[3] = 0x1p-30;
        assertThat(cone(new double[3], d, 0.5, LeafKind.CAPSULE, row)).isBetween(1.414, 1.4142136);
        // Turned away by a little more than what may be heard.
        row[3] = 0;
        assertThat(cone(new double[3], d, 0.5 + 0x1p-40, LeafKind.CAPSULE, row)).isInfinite();
    }

    /** Beside a short segment that is nearest at an end, to which a search comes close only. */
    @Test
    void aShortSegmentIsHardlyBelowTheTruth() {
        double[] o = {0.7041550027051194, 0.3085778573652017, -0.1111495927988969};
        double[] d = {-0.19837810385662885, -4.239867797583155, 4.6533562501149826};
        double[] row = new double[16];
        double[] numbers = {
            0.744159406988691, 0.10591009542814556, -0.14465301078602355, 0.20927192959509372, 7.144968664870911E-7
        };
        System.arraycopy(numbers, 0, row, 0, 5);
        row[7] = 0.7251703615315184;
        row[10] = 0.02941728775104118;
        row[13] = 0.6879408186302216;
        double cosine = StrictMath.cos(1.7292261900499056E-5);
        take(o, d, cosine, LeafKind.CAPSULE, row);
        BigDecimal truth = least(true)[0];
        BigDecimal answer = new BigDecimal(cone(o, d, cosine, LeafKind.CAPSULE, row));
        assertThat(answer).isBetween(truth.subtract(new BigDecimal(0x1p-45)), truth);
    }

    /** Thin ones that pass a narrow cone by 10^-12 to 10^-5, where the distance from the cone hardly changes along them. */
    @Test
    void whatIsMissedByLittleIsNotHeard() {
        double[] o = {-1.3612539954111225, 1.7855461550813745, -1.0378057674317152};
        double[] d = {1.0664419243522767E-4, -0.9999999922875328, 6.365493562095842E-5};
        double[] row = new double[16];
        row[0] = -1.361111138644569;
        row[1] = -0.17303440448196383;
        row[2] = -1.037910276671231;
        row[4] = 1.9585805595633383;
        isMissed(o, d, 1.1434148170146109E-4, LeafKind.UPRIGHT_CAPSULE, row);

        o = new double[] {-2.4436706506733015, 0.7061061702098379, -1.009773318196646};
        d = new double[] {1.1634127356854398, -8.719614090779476, -1.6131363705031816};
        row = new double[16];
        row[0] = -1.9439286637154725;
        row[1] = -1.0482157567056718;
        row[2] = -1.371636005160548;
        row[4] = 2.286159294408648;
        row[7] = 0.26875068058742463;
        row[10] = -0.9433839730299987;
        row[13] = -0.19442158088527758;
        isMissed(o, d, 0.1430309559089543, LeafKind.CAPSULE, row);

        o = new double[] {4.048684937915821, 0.9499087638184673, 3.2002982565877383};
        d = new double[] {-3.058325500165685, -0.2611644758629321, -2.098380762228681};
        row = new double[16];
        row[0] = 0.8695099992353867;
        row[1] = 0.6781559529111871;
        row[2] = 1.018708585089707;
        row[3] = 3.726558602259326E-8;
        row[4] = 5.675546243502183E-4;
        row[7] = -0.876424495136596;
        row[10] = 0.4720453277568838;
        row[13] = -0.09514889840381309;
        isMissed(o, d, 6.913805323962652E-6, LeafKind.CAPSULE, row);
    }

    private void isMissed(double[] o, double[] d, double half, LeafKind kind, double[] row) {
        double cosine = StrictMath.cos(half);
        take(o, d, cosine, kind, row);
        double gap = least(false)[0].subtract(radius).doubleValue();
        double size = Math.abs(row[0] - o[0]) + Math.abs(row[1] - o[1]) + Math.abs(row[2] - o[2]) + row[3] + row[4];
        assertThat(gap).isGreaterThan(0x1p-44 * size);
        assertThat(cone(o, d, cosine, kind, row)).isInfinite();
    }

    /** Behind the apex, beside it, and so near that the cone's border passes by the apex. */
    @Test
    void whatIsBehindIsNotHeard() {
        SplittableRandom random = new SplittableRandom(9);
        int silent = 0;
        int count = Effort.cases(150);
        for (int n = 0; n < count; n++) {
            double[] row = capsule(LeafKind.CAPSULE, random, 1);
            double half = random.nextDouble(0.01, 1.5);
            double[] d = SpatialRayTest.unit(Leaves.vector(random, 1));
            double[] o = new double[3];
            for (int k = 0; k < 3; k++) {
                row[k] = -d[k] * (row[3] + row[4]) * (1 + StrictMath.pow(10, -random.nextDouble(0, 6)));
            }
            take(o, d, StrictMath.cos(half), LeafKind.CAPSULE, row);
            BigDecimal truth = least(true)[0];
            double answer = cone(o, d, StrictMath.cos(half), LeafKind.CAPSULE, row);
            if (truth.compareTo(NEVER) >= 0) {
                silent++;
                assertThat(answer).as(Arrays.toString(row)).isInfinite();
            } else {
                assertThat(answer).as(Arrays.toString(row)).isLessThanOrEqualTo(truth.doubleValue());
            }
        }
        assertThat(silent).isGreaterThan(count * 2 / 3);
    }

    private static double[] capsule(LeafKind kind, SplittableRandom random, double scale) {
        double[] row = Leaves.random(kind, random, scale);
        switch (random.nextInt(8)) {
            case 0 -> row[3] = 0;
            case 1 -> row[4] = 0;
            case 2 -> row[3] *= 0x1p-40;
            case 3 -> row[4] *= 20;
            default -> {}
        }
        return row;
    }

    private static double[] turned(double[] d, double[] across, double angle) {
        double along = across[0] * d[0] + across[1] * d[1] + across[2] * d[2];
        double[] e = SpatialRayTest.unit(
                new double[] {across[0] - along * d[0], across[1] - along * d[1], across[2] - along * d[2]});
        double c = StrictMath.cos(angle);
        double s = StrictMath.sin(angle);
        return new double[] {c * d[0] + s * e[0], c * d[1] + s * e[1], c * d[2] + s * e[2]};
    }

    private double cone(double[] o, double[] d, double cosine, LeafKind kind, double[] row) {
        double sine = Math.sqrt((1 - cosine) * (1 + cosine));
        return SpatialCone.distance(
                new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cosine, sine),
                kind,
                row,
                0,
                Double.POSITIVE_INFINITY,
                scratch.cone);
    }

    private void take(double[] o, double[] d, double cosine, LeafKind kind, double[] row) {
        for (int k = 0; k < 3; k++) {
            middle[k] = new BigDecimal(row[k]).subtract(new BigDecimal(o[k]));
            double own = kind == LeafKind.CAPSULE ? row[7 + 3 * k] : k == 1 ? 1 : 0;
            arm[k] = new BigDecimal(row[4]).multiply(new BigDecimal(own));
            axis[k] = new BigDecimal(d[k]);
        }
        BigDecimal length = DecimalRoot.of(dot(axis, axis), DIGITS);
        for (int k = 0; k < 3; k++) {
            axis[k] = axis[k].divide(length, DIGITS);
        }
        cos = new BigDecimal(cosine);
        sin = DecimalRoot.of(ONE.subtract(cos.multiply(cos)), DIGITS);
        radius = new BigDecimal(row[3]);
    }

    /** The least of what {@link #about} answers along the segment, and where. */
    private BigDecimal[] least(boolean isRound) {
        BigDecimal low = ONE.negate();
        BigDecimal high = ONE;
        BigDecimal place = low;
        BigDecimal best = about(low, isRound);
        for (BigDecimal t : new BigDecimal[] {high, BigDecimal.ZERO}) {
            if (about(t, isRound).compareTo(best) < 0) {
                best = about(t, isRound);
                place = t;
            }
        }
        BigDecimal third = ONE.divide(BigDecimal.valueOf(3), DIGITS);
        for (int step = 0; step < 160; step++) {
            BigDecimal part = high.subtract(low).multiply(third, DIGITS);
            BigDecimal first = low.add(part);
            BigDecimal second = high.subtract(part);
            BigDecimal atFirst = about(first, isRound);
            BigDecimal atSecond = about(second, isRound);
            if (atFirst.compareTo(best) < 0) {
                best = atFirst;
                place = first;
            }
            if (atSecond.compareTo(best) < 0) {
                best = atSecond;
                place = second;
            }
            if (atFirst.compareTo(atSecond) <= 0) {
                high = second;
            } else {
                low = first;
            }
        }
        return new BigDecimal[] {best, place};
    }

    /** How near a ball about a place of the segment comes in the cone, or how far its centre is from the cone, from NEVER on. */
    private BigDecimal about(BigDecimal t, boolean isRound) {
        BigDecimal[] x = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            x[k] = middle[k].add(arm[k].multiply(t, DIGITS), DIGITS);
        }
        BigDecimal ahead = dot(x, axis).round(DIGITS);
        BigDecimal length = DecimalRoot.of(dot(x, x), DIGITS);
        BigDecimal aside =
                DecimalRoot.of(dot(x, x).subtract(ahead.multiply(ahead)).max(BigDecimal.ZERO), DIGITS);
        BigDecimal past = aside.multiply(cos).subtract(ahead.multiply(sin));
        BigDecimal along = ahead.multiply(cos).add(aside.multiply(sin));
        boolean isWithin = past.signum() <= 0;
        BigDecimal gap = isWithin ? BigDecimal.ZERO : along.signum() < 0 ? length : past;
        if (!isRound) {
            return gap;
        }
        if (isWithin) {
            return length.subtract(radius);
        }
        if (gap.compareTo(radius) > 0) {
            return NEVER.add(gap);
        }
        BigDecimal chord = radius.multiply(radius).subtract(past.multiply(past)).max(BigDecimal.ZERO);
        return along.subtract(DecimalRoot.of(chord, DIGITS));
    }
}
