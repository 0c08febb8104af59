package robosim.geometry.world.shared;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DecimalTest {
    @ParameterizedTest
    @CsvSource({
        "0.0, 0",
        "-0.0, -0",
        "5.0, 5",
        "-12.0, -12",
        "0.3, 0.3",
        "0.30000000000000004, 0.30000000000000004",
        "1.0E-4, 0.0001",
        "-1.25E-6, -0.00000125",
        "1.25E-7, 1.25e-7",
        "1.0E14, 100000000000000",
        "1.0E15, 1e15",
        "1.2345678E7, 12345678",
        "1.23456789125E7, 12345678.9125",
        "2.0E-323, 2e-323",
        "1.7976931348623157E308, 1.7976931348623157e308",
        "2.2250738585072014E-308, 2.2250738585072014e-308",
        // JDK 17 prints 2.0000000000000002E22 or the like of numbers as these.
        "2.0E-3, 0.002",
        "1.0E23, 1e23",
        "8.41E21, 8.41e21",
        "9.5E21, 9.5e21",
        "5.0E-324, 4.9e-324"
    })
    void asPeopleWriteThem(double value, String text) {
        assertThat(Decimal.of(value)).isEqualTo(text);
    }

    /** Against all shorter decimals there are. */
    @Test
    void theFewestDigitsThatReadBack() {
        SplittableRandom random = new SplittableRandom(7);
        int few = 0;
        int many = 0;
        for (int k = 0; k < 60_000; k++) {
            double value = switch (k % 4) {
                case 0 -> random.nextInt(-100_000, 100_000) / 1000.0;
                case 1 -> random.nextDouble(-100, 100);
                case 2 -> random.nextInt(1, 100) * Math.pow(10, random.nextInt(-20, 30));
                default -> (float) random.nextDouble(-100, 100);
            };
            String text = Decimal.of(value);
            assertThat(Double.doubleToRawLongBits(Double.parseDouble(text)))
                    .isEqualTo(Double.doubleToRawLongBits(value));
            assertThat(Numbers.parse(text)).isEqualTo(value);
            int digits = Math.max(1, new BigDecimal(text).stripTrailingZeros().precision());
            if (digits > 1) {
                BigDecimal shorter = new BigDecimal(value).round(new MathContext(digits - 1));
                assertThat(shorter.doubleValue()).as(text).isNotEqualTo(value);
            }
            few += digits < 8 ? 1 : 0;
            many += digits > 15 ? 1 : 0;
        }
        assertThat(few).isGreaterThan(15_000);
        assertThat(many).isGreaterThan(15_000);
    }
}
