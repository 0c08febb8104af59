package robosim.geometry.cli.worlds;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import robosim.geometry.cli.terminal.Arguments;

/**
 * Which steps of a recording are wanted, as {@code --steps FIRST-LAST} says.
 *
 * @param words null if all are wanted
 * @param first the first step, counted from 0
 * @param end   the step behind the last one
 */
record StepRange(@Nullable String words, int first, int end) {
    private static final Pattern FORM = Pattern.compile("(\\d{1,9})-(\\d{1,9})");

    static StepRange of(@Nullable String words) {
        if (words == null) {
            return new StepRange(null, 0, 0);
        }
        Matcher match = FORM.matcher(words);
        Arguments.refuse(!match.matches(), "--steps must be FIRST-LAST, such as 1-500", words);
        return new StepRange(words, Integer.parseInt(match.group(1)) - 1, Integer.parseInt(match.group(2)));
    }

    /** The wanted steps, which must be among those that there are. */
    StepRange within(int least, int most) {
        if (words == null) {
            return new StepRange(null, least, most);
        }
        boolean isOutside = first < least || first >= end || end > most;
        Arguments.refuse(isOutside, "--steps must be within " + (least + 1) + "-" + most, words);
        return this;
    }
}
