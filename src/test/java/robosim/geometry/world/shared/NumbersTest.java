package robosim.geometry.world.shared;

import static org.assertj.core.api.Assertions.assertThat;

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
}
