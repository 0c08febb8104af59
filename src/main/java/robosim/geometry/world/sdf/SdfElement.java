package robosim.geometry.world.sdf;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.LeftOut;
import robosim.geometry.world.shared.LimitProblem;
import robosim.geometry.world.shared.Numbers;

/** An element of an SDFormat file that is relevant to its geometry; all others are only counted. */
public final class SdfElement {
    final SdfFile file;
    final String name;
    final int line;
    final int column;
    final Map<String, String> attributes;
    final List<SdfElement> children = new ArrayList<>(2);
    final StringBuilder text = new StringBuilder(0);

    /** Children irrelevant to the geometry, counted by name. */
    final Map<String, Integer> passedOver = new TreeMap<>();

    /** Children that are left out although they may be relevant, each with the reason. */
    final List<LeftOut> skipped = new ArrayList<>(0);

    SdfElement(SdfFile file, String name, int line, int column, Map<String, String> attributes) {
        this.file = file;
        this.name = name;
        this.line = line;
        this.column = column;
        this.attributes = attributes;
    }

    /** The first child of a name, or null. */
    @Nullable
    SdfElement child(String child) {
        for (SdfElement each : children) {
            if (each.name.equals(child)) {
                return each;
            }
        }
        return null;
    }

    /** The only child of a name, which must exist. */
    SdfElement required(String child) throws FileProblem {
        SdfElement found = child(child);
        if (found == null) {
            throw wrong("<" + name + "> must have <" + child + ">; add it (got: none)");
        }
        return found;
    }

    /** An attribute without surrounding white space; empty if it was left out. */
    String attribute(String attribute) {
        return attributes.getOrDefault(attribute, "").strip();
    }

    /** The name of this element, which must have one. */
    String givenName() throws FileProblem {
        String given = attribute("name");
        if (given.isEmpty()) {
            throw wrong("<" + name + "> must have a name; add name=\"...\" (got: none)");
        }
        return given;
    }

    /** The text of this element. */
    String value() {
        return text.toString().strip();
    }

    /** The text of a child; empty if there is none. */
    String valueOf(String child) {
        SdfElement found = child(child);
        return found == null ? "" : found.value();
    }

    /** The text of this element as exactly the given number of numbers. */
    double[] numbers(int count) throws FileProblem {
        String[] words = Numbers.words(value());
        if (words.length != count || words[0].isEmpty()) {
            throw wrong("<" + name + "> must be " + count + " number" + (count == 1 ? "" : "s") + " (got: "
                    + (words[0].isEmpty() ? "none" : words.length) + ")");
        }
        double[] numbers = new double[count];
        for (int k = 0; k < count; k++) {
            try {
                numbers[k] = Numbers.parse(words[k]);
            } catch (IllegalArgumentException e) {
                throw wrong("<" + name + ">: " + e.getMessage());
            }
        }
        return numbers;
    }

    /** The number in a child, which must exist. */
    double number(String child) throws FileProblem {
        return required(child).numbers(1)[0];
    }

    /** The three numbers in a child, SDFormat's x y z. */
    Point vector(String child, Point otherwise) throws FileProblem {
        SdfElement found = child(child);
        if (found == null) {
            return otherwise;
        }
        double[] numbers = found.numbers(3);
        try {
            return new Point(numbers[0], numbers[1], numbers[2]);
        } catch (IllegalArgumentException e) {
            throw found.wrong("<" + child + ">: " + e.getMessage());
        }
    }

    /** Parses a boolean. */
    static boolean isTrue(SdfElement place, String what, String value) throws FileProblem {
        return switch (value.toLowerCase(Locale.ROOT)) {
            case "true", "1" -> true;
            case "false", "0" -> false;
            default -> throw place.wrong(what + " must be true, false, 1 or 0 (got: " + value + ")");
        };
    }

    /** The frame to which a pose is relative; in older versions the attribute had another name. */
    String relativeTo() {
        String given = attribute("relative_to");
        return given.isEmpty() ? attribute("frame") : given;
    }

    /** The element in messages: its tag, and its name if it has one. */
    String tag() {
        String given = attribute("name");
        String written = name.endsWith("_state") ? name.substring(0, name.indexOf('_')) : name;
        return "<" + written + ">" + (given.isEmpty() ? "" : " \"" + given + "\"");
    }

    FileProblem beyond(String problem) {
        return new LimitProblem(file.shown(), line, column, problem);
    }

    FileProblem wrong(String problem) {
        return new FileProblem(file.shown(), line, column, problem);
    }
}
