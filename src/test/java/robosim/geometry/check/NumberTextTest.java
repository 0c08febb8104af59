package robosim.geometry.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import org.junit.jupiter.api.Test;

class NumberTextTest {
    @Test
    void toSoManyDigits() {
        assertThat(NumberText.digits(0.1 + 0.2, 15)).isEqualTo("0.3");
        assertThat(NumberText.digits(2.0 / 3, 6)).isEqualTo("0.666667");
        assertThat(NumberText.digits(-1234567, 6)).isEqualTo("-1234570");
        assertThat(NumberText.digits(0, 6))
                .isEqualTo(NumberText.digits(-0.0, 6))
                .isEqualTo("0");
        assertThat(NumberText.digits(100, 1)).isEqualTo("100");
    }

    @Test
    void toSoManyPlaces() {
        assertThat(NumberText.places(2.0 / 3, 3)).isEqualTo("0.667");
        assertThat(NumberText.places(-0.0001, 3)).isEqualTo("0");
        assertThat(NumberText.places(12, 3)).isEqualTo("12");
        assertThat(NumberText.places(1000.1, 2)).isEqualTo("1000.1");
    }

    @Test
    void verySmallAndVeryLarge() {
        assertThat(NumberText.digits(1e-6, 6)).isEqualTo("0.000001");
        assertThat(NumberText.digits(1.5e-9, 6)).isEqualTo("1.5e-9");
        assertThat(NumberText.digits(999_999_999_999_999.0, 15)).isEqualTo("999999999999999");
        assertThat(NumberText.digits(1e14, 6)).isEqualTo("100000000000000");
        assertThat(NumberText.digits(0x1p100, 6)).isEqualTo("1.26765e30");
        assertThat(NumberText.places(Double.NEGATIVE_INFINITY, 3)).isEqualTo("-Infinity");
        assertThat(NumberText.of(new BigDecimal("1e15"))).isEqualTo("1e15");
    }

    @Test
    void counts() {
        assertThat(NumberText.count(1, "step")).isEqualTo("1 step");
        assertThat(NumberText.count(3000, "step")).isEqualTo("3,000 steps");
    }
}
