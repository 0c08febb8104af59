package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Double-doubles against decimals: the errors that {@link DoubleDouble} and {@link DoubleDoubleSum} state. */
class DoubleDoubleTest {
    private static final MathContext DIGITS = new MathContext(80);
    private static final BigDecimal SUMS = new BigDecimal(0x1p-104);
    private static final BigDecimal PRODUCTS = new BigDecimal(0x1p-100);
    private static final int CASES = 3000;

    private final SplittableRandom random = new SplittableRandom(71);
    private final double[] out = new double[4];

    /** A number and its tail; now and then a power of two, or one without a tail. */
    private double[] number() {
        double hi = Math.scalb(random.nextDouble(-2, 2), random.nextInt(-60, 60));
        if (random.nextInt(8) == 0) {
            hi = Math.copySign(Math.scalb(1, random.nextInt(-60, 60)), hi);
        }
        double lo = random.nextInt(4) == 0 ? 0 : random.nextDouble(-0.5, 0.5) * Math.ulp(hi);
        double[] number = new double[2];
        DoubleDouble.sum(hi, lo, number, 0);
        return number;
    }

    private static BigDecimal value(double[] number) {
        return new BigDecimal(number[0]).add(new BigDecimal(number[1]));
    }

    private BigDecimal result() {
        assertThat(Math.abs(out[1])).isLessThanOrEqualTo(Math.ulp(out[0]) / 2);
        return value(out);
    }

    private static void near(BigDecimal result, BigDecimal truth, BigDecimal bound) {
        assertThat(result.subtract(truth).abs()).isLessThanOrEqualTo(bound);
    }

    @Test
    void sumsAndProductsOfTwoDoublesAreExact() {
        for (int k = 0; k < CASES; k++) {
            double a = number()[0];
            double b = number()[0];
            DoubleDouble.sum(a, b, out, 0);
            assertThat(result()).isEqualByComparingTo(new BigDecimal(a).add(new BigDecimal(b)));
            DoubleDouble.product(a, b, out, 0);
            assertThat(result()).isEqualByComparingTo(new BigDecimal(a).multiply(new BigDecimal(b)));
            double difference = a - b;
            assertThat(new BigDecimal(difference).add(new BigDecimal(DoubleDouble.differenceTail(a, b, difference))))
                    .isEqualByComparingTo(new BigDecimal(a).subtract(new BigDecimal(b)));
        }
    }

    @Test
    void sumsAreOffByNoMoreThanStated() {
        DoubleDoubleSum sum = new DoubleDoubleSum();
        DoubleDoubleSum other = new DoubleDoubleSum();
        for (int k = 0; k < CASES; k++) {
            double[] a = number();
            double[] b = number();
            if (k % 3 == 0) { // which cancels
                b[0] = -a[0] * (1 + random.nextInt(-2, 3) * 0x1p-52);
                b[1] = random.nextDouble(-0.5, 0.5) * Math.ulp(b[0]);
            }
            BigDecimal bound = value(a).abs().add(value(b).abs()).multiply(SUMS);
            BigDecimal plus = value(a).add(value(b));
            BigDecimal minus = value(a).subtract(value(b));
            DoubleDouble.add(a[0], a[1], b[0], b[1], out, 0);
            near(result(), plus, bound);
            DoubleDouble.subtract(a[0], a[1], b[0], b[1], out, 0);
            near(result(), minus, bound);
            sum.clear();
            sum.add(a[0], a[1]);
            other.clear();
            other.add(b[0], b[1]);
            assertThat(sum.isBelow(other)).isEqualTo(value(a).compareTo(value(b)) < 0);
            assertThat(sum.isBelow(sum)).isFalse();
            DoubleDoubleSum more = new DoubleDoubleSum();
            more.set(sum);
            more.lo = Math.nextUp(more.lo);
            assertThat(sum.isBelow(more)).isTrue();
            assertThat(more.isBelow(sum)).isFalse();
            sum.add(other);
            near(new BigDecimal(sum.hi).add(new BigDecimal(sum.lo)), plus, bound);
            sum.subtract(other);
            sum.subtract(other);
            near(new BigDecimal(sum.hi).add(new BigDecimal(sum.lo)), minus, bound.multiply(BigDecimal.valueOf(4)));
        }
    }

    @Test
    void productsQuotientsAndRootsAreOffByNoMoreThanStated() {
        for (int k = 0; k < CASES; k++) {
            double[] a = number();
            double[] b = number();
            BigDecimal product = value(a).multiply(value(b));
            DoubleDouble.multiply(a[0], a[1], b[0], b[1], out, 0);
            near(result(), product, product.abs().multiply(PRODUCTS));
            DoubleDoubleSum sum = new DoubleDoubleSum();
            sum.clear();
            sum.addProduct(a[0], a[1], b[0], b[1]);
            near(
                    new BigDecimal(sum.hi).add(new BigDecimal(sum.lo)),
                    product,
                    product.abs().multiply(PRODUCTS));
            BigDecimal quotient = value(a).divide(value(b), DIGITS);
            DoubleDouble.divide(a[0], a[1], b[0], b[1], out, 0);
            near(result(), quotient, quotient.abs().multiply(PRODUCTS));
            if (a[0] > 0) {
                BigDecimal root = value(a).sqrt(DIGITS);
                DoubleDouble.sqrt(a[0], a[1], out, 0);
                near(result(), root, root.multiply(PRODUCTS));
            }
        }
        DoubleDoubleSum whole = new DoubleDoubleSum();
        whole.clear();
        whole.addProduct(3, 0, 5, 0);
        assertThat(whole.plain).isTrue();
        assertThat(whole.hi).isEqualTo(15);
        whole.addProduct(0.1, 0, 0.1, 0);
        assertThat(whole.plain).as("it takes two doubles").isFalse();
        whole.clear();
        whole.addProduct(3, 0x1p-60, 5, 0);
        assertThat(whole.plain).isFalse();
        whole.clear();
        whole.addProduct(0x1p-600, 0, 0x1p-600, 0);
        assertThat(whole.plain).as("lost to underflow").isFalse();
        DoubleDouble.sqrt(0, 0, out, 0);
        assertThat(out[0]).isZero();
        DoubleDouble.sqrt(-1, 0, out, 0);
        assertThat(out[0]).isNaN();
    }

    /** What is taken from each other may all but cancel. */
    @Test
    void twoProductsAreWithinTwoUlpOfTheirDifference() {
        for (int k = 0; k < CASES; k++) {
            double a = number()[0];
            double b = number()[0];
            double c = k % 2 == 0 ? number()[0] : b * (1 + random.nextInt(-2, 3) * 0x1p-52);
            double d = k % 2 == 0 ? number()[0] : a * (1 + random.nextInt(-2, 3) * 0x1p-52);
            BigDecimal ab = new BigDecimal(a).multiply(new BigDecimal(b));
            BigDecimal cd = new BigDecimal(c).multiply(new BigDecimal(d));
            double difference = DoubleDouble.differenceOfProducts(a, b, c, d);
            near(new BigDecimal(difference), ab.subtract(cd), new BigDecimal(2 * Math.ulp(difference)));
            double sum = DoubleDouble.sumOfProducts(a, b, c, d);
            near(new BigDecimal(sum), ab.add(cd), new BigDecimal(2 * Math.ulp(sum)));
        }
    }

    /** A dot and a cross product, and a step along a vector, in registers. */
    @Test
    void vectorsInRegisters() {
        DoubleDoubles p = new DoubleDoubles(16);
        for (int k = 0; k < CASES; k++) {
            BigDecimal[] v = new BigDecimal[6];
            for (int i = 0; i < 6; i++) {
                double a = random.nextDouble(-2, 2);
                double b = random.nextDouble(-2, 2);
                p.difference(i, a, 1000 * b);
                assertThat(register(p, i)).isEqualByComparingTo(new BigDecimal(a).subtract(new BigDecimal(1000 * b)));
                p.product(i, a, b); // nearly all have a tail
                v[i] = new BigDecimal(a).multiply(new BigDecimal(b));
            }
            BigDecimal bound = new BigDecimal(0x1p-94);
            p.dot(6, 0, 3, 7);
            near(register(p, 6), dot(v), bound);
            p.set(10, p.get(0), p.rest(0));
            p.set(11, p.get(1), p.rest(1));
            p.set(12, p.get(2), p.rest(2));
            p.dot(10, 10, 3, 13); // over one of its own operands
            near(register(p, 10), dot(v), bound);
            p.cross(6, 0, 3, 9);
            for (int i = 0; i < 3; i++) {
                int l = (i + 1) % 3;
                int m = (i + 2) % 3;
                near(register(p, 6 + i), v[l].multiply(v[3 + m]).subtract(v[m].multiply(v[3 + l])), bound);
            }
            p.set(9, 0.75);
            p.advance(6, 0, 9, 3, 10);
            for (int i = 0; i < 3; i++) {
                near(register(p, 6 + i), v[i].add(v[3 + i].multiply(new BigDecimal("0.75"))), bound);
            }
            p.multiply(13, 4, 3.0);
            near(register(p, 13), v[4].multiply(BigDecimal.valueOf(3)), bound);
            p.divide(14, 13, 4);
            near(register(p, 14), BigDecimal.valueOf(3), new BigDecimal(0x1p-98));
            p.product(14, p.get(2), 0.1);
            assertThat(register(p, 14)).isEqualByComparingTo(new BigDecimal(p.get(2)).multiply(new BigDecimal(0.1)));
            double next = p.get(9);
            p.subtractVector(6, 0, 3);
            assertThat(p.get(9)).as("what is behind the vector").isEqualTo(next);
            for (int i = 0; i < 3; i++) {
                near(register(p, 6 + i), v[i].subtract(v[3 + i]), bound);
            }
        }
        p.set(0, -4);
        p.root(1, 0);
        assertThat(p.get(1)).isZero();
        p.negate(0);
        p.root(1, 0);
        assertThat(p.get(1)).isEqualTo(2);
    }

    private static BigDecimal dot(BigDecimal[] v) {
        return v[0].multiply(v[3]).add(v[1].multiply(v[4])).add(v[2].multiply(v[5]));
    }

    private static BigDecimal register(DoubleDoubles p, int i) {
        return new BigDecimal(p.get(i)).add(new BigDecimal(p.rest(i)));
    }

    /** Where it answers it is the largest double not above the quotient, whatever the errors are; else NaN. */
    @Test
    void aFlooredQuotientIsRightOrNone() {
        DoubleDoubleSum gap = new DoubleDoubleSum();
        DoubleDoubleSum closing = new DoubleDoubleSum();
        int told = 0;
        for (int k = 0; k < CASES; k++) {
            double[] a = number();
            double[] b = number();
            boolean isPlain = k % 3 == 0;
            boolean isExact = k % 5 == 0;
            gap.clear();
            closing.clear();
            double divisor = Math.abs(b[0]);
            double dividend = isExact ? divisor * (1 + random.nextInt(8)) : Math.abs(a[0]);
            gap.add(dividend, isPlain || isExact ? 0 : Math.ulp(dividend) * random.nextDouble(-0.4, 0.4));
            closing.add(divisor, isPlain || isExact ? 0 : Math.ulp(divisor) * random.nextDouble(-0.4, 0.4));
            double error = k % 7 == 0 ? 0x1p-50 * gap.hi : isPlain || isExact ? 0 : 0x1p-98 * gap.hi;
            double floor = DoubleDoubleSum.floorQuotient(gap, error, closing, 0);
            if (k % 7 == 0) {
                assertThat(floor).isNaN();
                continue;
            }
            if (Double.isNaN(floor)) {
                continue;
            }
            told++;
            BigDecimal top = new BigDecimal(gap.hi).add(new BigDecimal(gap.lo));
            BigDecimal under = new BigDecimal(closing.hi).add(new BigDecimal(closing.lo));
            assertThat(new BigDecimal(floor).multiply(under)).isLessThanOrEqualTo(top);
            assertThat(new BigDecimal(Math.nextUp(floor)).multiply(under)).isGreaterThan(top);
        }
        assertThat(told).isGreaterThan(CASES * 3 / 4);
        gap.clear();
        assertThat(DoubleDoubleSum.floorQuotient(gap, 0, closing, 0))
                .as("no gap")
                .isNaN();
    }
}
