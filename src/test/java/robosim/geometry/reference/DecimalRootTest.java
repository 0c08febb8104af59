package robosim.geometry.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The square roots of oracles against those of the JDK, and against their definition. */
class DecimalRootTest {
    private final Random random = new Random(20261124);

    @Test
    void wholeRootsAreThoseOfTheDefinition() {
        int squares = 0;
        for (int k = 0; k < 30_000; k++) {
            BigInteger n = new BigInteger(random.nextInt(700), random);
            // Squares, and what is one below and above them.
            if (k % 2 == 0) {
                n = n.multiply(n).add(BigInteger.valueOf(k / 2 % 3 - 1)).max(BigInteger.ZERO);
            }
            BigInteger root = DecimalRoot.floor(n);
            assertThat(root.pow(2).compareTo(n)).as("%s", n).isLessThanOrEqualTo(0);
            assertThat(root.add(BigInteger.ONE).pow(2).compareTo(n)).as("%s", n).isPositive();
            squares += root.pow(2).equals(n) ? 1 : 0;
        }
        assertThat(squares).isBetween(5000, 6000);
    }

    @Test
    void decimalsHaveTheRootsThatTheJdkFinds() {
        int exact = 0;
        for (int precision : new int[] {1, 2, 34, 60, 120}) {
            MathContext digits = new MathContext(precision);
            for (int k = 0; k < 200; k++) {
                BigDecimal x = new BigDecimal(random.nextDouble() * Math.pow(2, random.nextInt(-90, 90)));
                BigDecimal square = k % 2 == 0 ? x : x.round(digits).pow(2);
                assertThat(DecimalRoot.of(square, digits))
                        .as("%s to %d digits", square, precision)
                        .isEqualByComparingTo(square.sqrt(digits));
                exact += DecimalRoot.of(square, digits).pow(2).compareTo(square) == 0 ? 1 : 0;
            }
        }
        assertThat(exact).isBetween(500, 600);
    }

    @Test
    void zeroHasARootAndNothingBelow() {
        assertThat(DecimalRoot.of(new BigDecimal("0.00"), MathContext.DECIMAL64))
                .isEqualByComparingTo(BigDecimal.ZERO);
        assertThatThrownBy(() -> DecimalRoot.of(new BigDecimal("-1e-9"), MathContext.DECIMAL64))
                .isInstanceOf(ArithmeticException.class)
                .hasMessageContaining("-1E-9");
    }
}
