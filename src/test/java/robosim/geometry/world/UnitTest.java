package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class UnitTest {
    /** Tenths of a millimetre in one of each. */
    private static final Map<String, Long> TENTHS =
            Map.of("km", 10_000_000L, "m", 10_000L, "cm", 100L, "mm", 10L, "in", 254L, "ft", 3048L);

    @Test
    void convertsToTheNearestDouble() {
        SplittableRandom random = new SplittableRandom(1);
        int changed = 0;
        for (int k = 0; k < 2000; k++) {
            Unit from = Unit.values()[random.nextInt(6)];
            Unit to = Unit.values()[random.nextInt(6)];
            String decimal = k % 2 == 0
                    ? Double.toString(random.nextDouble(-1000, 1000))
                    : new BigDecimal(BigInteger.valueOf(random.nextInt(100_000)), random.nextInt(6)).toPlainString();
            double converted = Unit.length(decimal + from.symbol(), to);
            // |converted - exact| against half the gaps to both neighbours, as whole numbers of rationals.
            BigDecimal exact = new BigDecimal(decimal).multiply(BigDecimal.valueOf(TENTHS.get(from.symbol())));
            BigDecimal unit = BigDecimal.valueOf(TENTHS.get(to.symbol()));
            BigDecimal off =
                    new BigDecimal(converted).multiply(unit).subtract(exact).abs();
            for (double neighbour : new double[] {Math.nextUp(converted), Math.nextDown(converted)}) {
                BigDecimal other =
                        new BigDecimal(neighbour).multiply(unit).subtract(exact).abs();
                assertThat(off).as("%s %s in %s", decimal, from, to).isLessThanOrEqualTo(other);
            }
            changed += converted == Double.parseDouble(decimal) ? 0 : 1;
        }
        assertThat(changed).isBetween(1000, 1900);
    }

    @Test
    void knowsItsSymbolsAndLengths() {
        for (Unit unit : Unit.values()) {
            assertThat(Unit.of(unit.symbol())).isEqualTo(unit);
            assertThat(unit.metres()).isEqualTo(TENTHS.get(unit.symbol()) / 10_000.0);
        }
        assertThat(Unit.of("mile")).isNull();
        assertThat(Unit.of("")).isNull();
    }

    @Test
    void aLengthWithAUnitNeedsAWorldUnit() {
        assertThat(Unit.length("25cm", Unit.METRE)).isEqualTo(0.25);
        assertThat(Unit.length("0.1m", Unit.METRE)).isEqualTo(0.1);
        assertThat(Unit.length("12in", Unit.FOOT)).isEqualTo(1);
        assertThat(Unit.length("7", null)).isEqualTo(7);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Unit.length("25cm", null))
                .withMessageContaining("add unit=\"m\" to <world>");
        for (String wrong : new String[] {"m", "1 m", "1M", "1.m.", "--1", "1e", "", "1e9999mm", "\u0661"}) {
            assertThatIllegalArgumentException()
                    .as(wrong)
                    .isThrownBy(() -> Unit.length(wrong, Unit.CENTIMETRE))
                    .withMessageContaining("(got: ");
        }
    }
}
