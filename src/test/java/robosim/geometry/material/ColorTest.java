package robosim.geometry.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ColorTest {
    @Test
    void eachPackedColorIsItsText() {
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < 10_000; k++) {
            int pixel = random.nextInt(1 << 24);
            Color color = Color.ofPacked(pixel);
            assertThat(color.packed()).isEqualTo(pixel);
            assertThat(color.toString()).isEqualTo(String.format("#%06x", pixel));
            assertThat(Color.parse(color.toString())).isEqualTo(color);
            assertThat(color.isPacked()).isTrue();
        }
        assertThat(new Color(0.5, 0, 0).isPacked()).isFalse();
        assertThat(new Color(0.5, 0, 0)).hasToString("#800000");
        assertThat(Color.parse("#FFfF00")).isEqualTo(new Color(1, 1, 0));
        assertThat(Color.ofPacked(0xff000001)).hasToString("#000001");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "#", "red", "#12345", "#1234567", "#12345g", "123456", " #123456", "#-12345", "#١٢٣٤٥٦"})
    void whatIsNoColorIsRefused(String text) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Color.parse(text))
                .withMessageContaining("#rrggbb")
                .withMessageEndingWith("(got: " + text + ")");
    }

    /** Points of the curve of IEC 61966-2-1, computed to 20 digits elsewhere. */
    @Test
    void linearComponentsAreThoseOfTheStandard() {
        assertThat(Color.linear(0.0)).isZero();
        assertThat(Color.linear(1.0)).isEqualTo(1);
        assertThat(Color.linear(0.5)).isCloseTo(0.21404114048223255, within(1e-16));
        assertThat(Color.linear(0.04)).isCloseTo(0.0030959752321981424, within(1e-18));
        assertThat(Color.linear(0.2)).isCloseTo(0.033104766570885055, within(1e-17));
        assertThat(Color.linear(188)).isCloseTo(0.5028864580325687, within(1e-15));
        assertThat(new Color(0.5, 0.2, 1).linearRed()).isEqualTo(Color.linear(0.5));
        assertThat(new Color(0.5, 0.2, 1).linearGreen()).isEqualTo(Color.linear(0.2));
        assertThat(new Color(0.5, 0.2, 1).linearBlue()).isEqualTo(1);
    }

    @Test
    void theTablesAgreeWithTheFormulae() {
        double last = -1;
        for (int k = 0; k < 256; k++) {
            assertThat(Color.linear(k)).isEqualTo(Color.linear(k / 255.0)).isGreaterThan(last);
            assertThat(Color.component(Color.linear(k))).isEqualTo(k);
            last = Color.linear(k);
        }
        SplittableRandom random = new SplittableRandom(2);
        int rounded = 0;
        for (int k = 0; k < 100_000; k++) {
            double linear = random.nextDouble() * (k % 2 == 0 ? 1 : 0.01);
            Color color = Color.ofLinear(linear, 0, 1);
            assertThat(color.linearRed()).isCloseTo(linear, within(1e-7)); // the two branches meet only so well
            int component = Color.component(linear);
            assertThat(Math.abs(255 * color.red() - component)).isLessThan(0.5 + 2e-5);
            rounded += component == (int) (255 * color.red() + 0.5) ? 1 : 0;
        }
        assertThat(rounded).isGreaterThan(99_990);
        assertThat(Color.component(Double.NaN)).isZero();
        assertThat(Color.component(-1)).isZero();
        assertThat(Color.component(Double.POSITIVE_INFINITY)).isEqualTo(255);
    }
}
