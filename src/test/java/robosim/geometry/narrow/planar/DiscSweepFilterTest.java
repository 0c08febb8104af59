package robosim.geometry.narrow.planar;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** What plain doubles say of a disc's way, against the same in decimals without rounding. */
class DiscSweepFilterTest {
    private static final int TRIALS = 20_000;

    /** MET or CLEAR without doubt, or UNSURE where a disc starts in touch or goes along. */
    private static int truth(BigDecimal qx, BigDecimal qz, double dx, double dz, BigDecimal reach) {
        BigDecimal wayX = new BigDecimal(dx);
        BigDecimal wayZ = new BigDecimal(dz);
        BigDecimal square = reach.multiply(reach);
        BigDecimal off = qx.multiply(qx).add(qz.multiply(qz));
        BigDecimal ahead = qx.multiply(wayX).add(qz.multiply(wayZ));
        BigDecimal way = wayX.multiply(wayX).add(wayZ.multiply(wayZ));
        if (off.compareTo(square) <= 0) {
            return -ahead.signum();
        }
        if (ahead.signum() <= 0) {
            return DiscSweepFilter.CLEAR;
        }
        if (ahead.compareTo(way) >= 0) {
            BigDecimal ex = qx.subtract(wayX);
            BigDecimal ez = qz.subtract(wayZ);
            return ex.multiply(ex).add(ez.multiply(ez)).compareTo(square) > 0
                    ? DiscSweepFilter.CLEAR
                    : DiscSweepFilter.MET;
        }
        BigDecimal aside = qx.multiply(wayZ).subtract(qz.multiply(wayX));
        return aside.multiply(aside).compareTo(square.multiply(way)) > 0 ? DiscSweepFilter.CLEAR : DiscSweepFilter.MET;
    }

    /** A way whose line passes the offset nearly as closely as the radii allow, or that ends so. */
    private static double[] near(SplittableRandom random) {
        double turn = random.nextDouble(-3.2, 3.2);
        double cos = StrictMath.cos(turn);
        double sin = StrictMath.sin(turn);
        double reach = random.nextDouble(0.1, 2);
        double gap = random.nextInt(-3, 4) * StrictMath.pow(10, -random.nextInt(1, 18));
        double along = random.nextDouble(0.5, 3);
        boolean isAside = random.nextBoolean();
        double ahead = isAside ? along : along + reach * (1 + gap);
        double aside = isAside ? reach * (1 + gap) : 0;
        double length = isAside ? along * 2 : along;
        return new double[] {ahead * cos - aside * sin, ahead * sin + aside * cos, length * cos, length * sin, reach};
    }

    private static double[] any(SplittableRandom random) {
        return new double[] {
            random.nextDouble(-2, 2),
            random.nextDouble(-2, 2),
            random.nextDouble(-3, 3),
            random.nextDouble(-3, 3),
            random.nextDouble(2)
        };
    }

    @Test
    void saysNothingThatIsNotSo() {
        SplittableRandom random = new SplittableRandom(17);
        int[] said = new int[3];
        int[] saidNear = new int[3];
        for (int trial = 0; trial < TRIALS; trial++) {
            boolean isNear = trial % 2 == 0;
            double[] n = isNear ? near(random) : any(random);
            double scale = random.nextInt(10) == 0 ? StrictMath.scalb(1.0, random.nextInt(-120, 90)) : 1;
            for (int k = 0; k < 5; k++) {
                n[k] *= scale;
            }
            double slack = random.nextInt(3) == 0 ? scale * StrictMath.pow(10, -random.nextInt(3, 12)) : 0;
            // What is meant is off by up to the slack.
            double off = slack * random.nextDouble(-1, 1);
            double aside = Math.sqrt(slack * slack - off * off) * random.nextDouble(-1, 1);
            BigDecimal qx = new BigDecimal(n[0]).add(new BigDecimal(off * 0.999));
            BigDecimal qz = new BigDecimal(n[1]).add(new BigDecimal(aside * 0.999));
            BigDecimal reach = new BigDecimal(n[4]).add(new BigDecimal(slack * random.nextDouble(-1, 1)));
            boolean isAll = random.nextInt(4) > 0;
            int verdict = DiscSweepFilter.past(n[0], n[1], n[2], n[3], n[4], slack, isAll);
            (isNear ? saidNear : said)[verdict + 1]++;
            String what = "DiscSweepFilter.past(%s, %s, %s, %s, %s, %s, %s), meant %s %s %s"
                    .formatted(n[0], n[1], n[2], n[3], n[4], slack, isAll, qx, qz, reach);
            if (verdict == DiscSweepFilter.MET) {
                assertThat(isAll).as(what).isTrue();
            }
            if (verdict != DiscSweepFilter.UNSURE) {
                assertThat(truth(qx, qz, n[2], n[3], reach)).as(what).isEqualTo(verdict);
            }
        }
        int half = TRIALS / 2;
        assertThat(said[DiscSweepFilter.CLEAR + 1]).isBetween(half * 3 / 10, half * 8 / 10);
        assertThat(said[DiscSweepFilter.MET + 1]).isBetween(half / 10, half * 6 / 10);
        assertThat(saidNear[DiscSweepFilter.UNSURE + 1]).isBetween(half / 20, half * 7 / 10);
        assertThat(saidNear[DiscSweepFilter.CLEAR + 1]).isGreaterThan(half / 10);
        assertThat(saidNear[DiscSweepFilter.MET + 1]).isGreaterThan(half / 10);
    }

    @Test
    void leavesToOthersWhatIsTooSmall() {
        assertThat(DiscSweepFilter.past(1, 0, 0, 0, 0.5, 0, true)).isEqualTo(DiscSweepFilter.UNSURE);
        assertThat(DiscSweepFilter.past(0x1p-500, 0, 0x1p-500, 0, 0x1p-502, 0, true))
                .isEqualTo(DiscSweepFilter.UNSURE);
        assertThat(DiscSweepFilter.past(Double.NaN, 0, 1, 0, 0.5, 0, true)).isEqualTo(DiscSweepFilter.UNSURE);
        assertThat(DiscSweepFilter.past(3, 0, 1, 0, Double.POSITIVE_INFINITY, 0, true))
                .isEqualTo(DiscSweepFilter.UNSURE);
    }
}
