package robosim.geometry.world.shared;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.SplittableRandom;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

class NumbersTest {
    private static final Pattern SPACE = Pattern.compile("\\s+");

    /** Of all white space, also such as ends no word. */
    private static final String LETTERS = "ab1 \t\n\u000B\f\r\u001C\u0085\u00A0\u2003";

    @Test
    void wordsAreThoseOfARegularExpression() {
        SplittableRandom random = new SplittableRandom(1);
        int several = 0;
        for (int k = 0; k < 3000; k++) {
            StringBuilder text = new StringBuilder();
            for (int length = random.nextInt(12); length > 0; length--) {
                text.append(LETTERS.charAt(random.nextInt(LETTERS.length())));
            }
            String[] words = Numbers.words(text.toString());
            assertThat(words).containsExactly(SPACE.split(text.toString().strip(), -1));
            several += words.length > 1 ? 1 : 0;
        }
        assertThat(several).isBetween(1000, 2500);
    }

    @Test
    void plainDecimalsAreThoseOfJava() {
        SplittableRandom random = new SplittableRandom(1);
        int plain = 0;
        for (int k = 0; k < 300_000; k++) {
            StringBuilder word = new StringBuilder(List.of("", "-", "+").get(random.nextInt(3)));
            int digits = random.nextInt(1, 20);
            int point = random.nextInt(-1, digits + 1);
            for (int n = 0; n < digits; n++) {
                word.append(n == point ? "." : "").append(random.nextInt(10));
            }
            word.append(point == digits ? "." : "");
            double expected = Double.parseDouble(word.toString());
            assertThat(Double.doubleToRawLongBits(Numbers.parse((CharSequence) word)))
                    .as(word.toString())
                    .isEqualTo(Double.doubleToRawLongBits(expected));
            plain += Double.isNaN(Numbers.plain(word)) ? 0 : 1;
        }
        assertThat(plain).isBetween(200_000, 299_000);
        for (String word :
                List.of("-0", "-0.0", ".5", "5.", "000000000000001", "999999999999999", "0.000000000000001", "1e3")) {
            assertThat(Double.doubleToRawLongBits(Numbers.parse(new StringBuilder(word))))
                    .isEqualTo(Double.doubleToRawLongBits(Double.parseDouble(word)));
        }
    }

    @Test
    void whatIsNoNumberIsRefused() {
        for (String word :
                List.of("", "-", ".", "+.", "1.2.3", "--1", "1-", "0x1", "1f", "NaN", "Infinity", "1e400", "1e0001")) {
            assertThatThrownBy(() -> Numbers.parse(new StringBuilder(word)))
                    .as(word)
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("a number must be decimal and finite");
        }
    }
}
