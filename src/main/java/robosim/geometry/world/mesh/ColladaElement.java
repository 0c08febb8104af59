package robosim.geometry.world.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Numbers;

/** An element of a COLLADA file that the shape of its surface depends on, with the numbers of its text. */
final class ColladaElement {
    private static final int LONGEST = 100;

    final String name;
    final int line;
    final Map<String, String> attributes;
    final List<ColladaElement> children = new ArrayList<>(2);
    final StringBuilder text = new StringBuilder(0);
    private final String source;
    private final StringBuilder word = new StringBuilder(0);
    private double[] numbers = {};
    private int count;

    /** What is wrong with the first word that is no number. It matters only if the numbers are used. */
    private @Nullable String wrongWord;

    ColladaElement(String source, String name, int line, Map<String, String> attributes) {
        this.source = source;
        this.name = name;
        this.line = line;
        this.attributes = attributes;
    }

    /** Adds characters of the text; answers how many numbers ended in them. */
    int add(char[] text, int start, int length) {
        int before = count;
        for (int k = start; k < start + length; k++) {
            char c = text[k];
            if (c == ' ' || c == '\n' || c == '\t' || c == '\r') {
                end();
            } else if (word.length() <= LONGEST) { // a longer one is refused anyway
                word.append(c);
            }
        }
        return count - before;
    }

    /** Ends the last word of the text. */
    void end() {
        if (word.length() == 0) {
            return;
        }
        double number = Double.NaN;
        try {
            number = Numbers.parse(word);
        } catch (IllegalArgumentException e) {
            wrongWord = wrongWord == null ? String.valueOf(e.getMessage()) : wrongWord;
        }
        word.setLength(0);
        if (count == numbers.length) {
            numbers = Arrays.copyOf(numbers, Math.max(16, 2 * count));
        }
        numbers[count++] = number;
    }

    /** How many numbers the text has. */
    int count() {
        return count;
    }

    /** A number of the text, all of which must be valid. */
    double number(int index) throws FileProblem {
        if (wrongWord != null) {
            throw wrong("<" + name + ">: " + wrongWord);
        }
        return numbers[index];
    }

    /** A number of the text as an index from 0 up to a limit, which it must not reach. */
    int index(int at, int limit, String what) throws FileProblem {
        double number = number(at);
        if (!(number >= 0 && number < limit) || number != Math.rint(number)) {
            throw wrong("<" + name + "> must have whole numbers from 0 and below " + limit + ", the number of " + what
                    + " (got: " + number + ")");
        }
        return (int) number;
    }

    /** The text as exactly this many numbers. */
    double[] exactly(int size) throws FileProblem {
        if (count != size) {
            throw wrong("<" + name + "> must have " + size + " numbers (got: " + count + ")");
        }
        double[] all = new double[size];
        for (int k = 0; k < size; k++) {
            all[k] = number(k);
        }
        return all;
    }

    @Nullable
    ColladaElement child(String child) {
        for (ColladaElement each : children) {
            if (each.name.equals(child)) {
                return each;
            }
        }
        return null;
    }

    ColladaElement required(String child) throws FileProblem {
        ColladaElement found = child(child);
        if (found == null) {
            throw wrong("<" + name + "> must have <" + child + "> (got: none)");
        }
        return found;
    }

    List<ColladaElement> all(String child) {
        return children.stream().filter(each -> each.name.equals(child)).toList();
    }

    String attribute(String attribute) {
        return attributes.getOrDefault(attribute, "").strip();
    }

    /** An attribute as a whole number from 0 to a limit; another number if it was left out. */
    int whole(String attribute, int otherwise, int most) throws FileProblem {
        String given = attribute(attribute);
        if (given.isEmpty()) {
            return otherwise;
        }
        try {
            int number = Numbers.index(given);
            if (number <= most) {
                return number;
            }
        } catch (IllegalArgumentException e) {
            throw wrong(attribute + " of <" + name + ">: " + e.getMessage());
        }
        throw wrong(attribute + " of <" + name + "> must be at most " + most + " (got: " + given + ")");
    }

    FileProblem wrong(String problem) {
        return new FileProblem(source, line, 0, problem);
    }
}
