package robosim.geometry.viewer.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class StrokeFontTest {
    @Test
    void everyPrintableLetterOfAsciiHasAShapeOfItsOwn() {
        String unknown = shape("\u00e9");
        for (char c = '!'; c <= '~'; c++) {
            assertThat(shape(String.valueOf(c))).as("%s", c).isNotEqualTo(unknown);
            for (char other = '!'; other < c; other++) {
                assertThat(shape(String.valueOf(c)))
                        .as("%s and %s", c, other)
                        .isNotEqualTo(shape(String.valueOf(other)));
            }
        }
    }

    private static String shape(String letter) {
        StringBuilder text = new StringBuilder();
        for (double[] line : StrokeFont.lines(letter, 9.6, 0, 0)) {
            text.append(java.util.Arrays.toString(line));
        }
        return text.toString();
    }

    @Test
    void lettersStayWithinTheirWidthAndLine() {
        for (char c = '!'; c <= '~'; c++) {
            double width = StrokeFont.width(String.valueOf(c), 9.6);
            for (double[] line : StrokeFont.lines(String.valueOf(c), 9.6, 0, 0)) {
                for (int k = 0; k < line.length; k += 2) {
                    assertThat(line[k]).as("%s", c).isBetween(-0.2, width + 0.2);
                    assertThat(-line[k + 1]).as("%s", c).isBetween(-2.3, 8.0);
                }
            }
        }
    }

    @Test
    void textGrowsWithItsSizeAndItsLetters() {
        assertThat(StrokeFont.width("", 10)).isZero();
        assertThat(StrokeFont.width("drum 1", 20)).isEqualTo(2 * StrokeFont.width("drum 1", 10));
        List<double[]> lines = StrokeFont.lines("l l", 9.6, 100, 50);
        assertThat(lines).hasSize(2);
        assertThat(lines.get(0)).containsExactly(100, 50, 100, 42.8);
        assertThat(lines.get(1)[0]).isEqualTo(100 + StrokeFont.width("l l", 9.6));
    }
}
