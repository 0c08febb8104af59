package robosim.geometry.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.xml.sax.SAXParseException;

/**
 * Translates messages of the schema validator into plain ones, using only its error key and the names that it quotes.
 */
final class SchemaErrors {
    private static final Pattern KEY = Pattern.compile("^(cvc-[A-Za-z0-9.-]+)\\s*:");
    private static final Pattern QUOTED = Pattern.compile("'([^']*)'");
    private static final Pattern CHILD = Pattern.compile("\"" + WorldWriter.NAMESPACE + "\":([a-z]+)");

    /** By type of the schema, what its values must be. */
    private static final Map<String, String> TYPES = Map.ofEntries(
            Map.entry("number", "a decimal number, like 12, -0.5 or 1.5e-3"),
            Map.entry("positive", "a number above 0, like 2 or 0.001"),
            Map.entry(
                    "size", "a length of at least 0, alone or followed by km, m, cm, mm, in or ft, like 0.25 or 25cm"),
            Map.entry("point", "three lengths x y z, like 1 0 -2.5 or 1m 0 -25cm"),
            Map.entry("heading", "a number of degrees, like 30, or two numbers to be added"),
            Map.entry("turn", "two numbers rx ry in degrees, like 0 90"),
            Map.entry("rotation", "nine numbers, row by row, like 1 0 0 0 1 0 0 0 1"),
            Map.entry("count", "a whole number from 1 to 10000"),
            Map.entry("cells", "a whole number of at least 1"),
            Map.entry("boolean", "true or false"),
            Map.entry("name", "text of at most 1000 characters, one of them visible"),
            Map.entry("layers", "names without spaces, separated by spaces"),
            Map.entry("color", "# and six hexadecimal digits, like #cc8800"),
            Map.entry(
                    "rgb", "# and six hexadecimal digits, like #cc8800, or three numbers from 0 to 1, like 0.8 0.5 0"),
            Map.entry("index", "a whole number of at least 0"),
            Map.entry("unit", "km, m, cm, mm, in or ft"),
            Map.entry("driveKind", "differential, omnidirectional, ackermann, velocity or force"),
            Map.entry("dimension", "PLANAR or SPATIAL"),
            Map.entry("accuracy", "SPHERE, AABB, OBB, DOP or EXACT"));

    /** Comes before the elements that may be in the place of another. */
    static final String ALLOWED = "allowed here: ";

    private SchemaErrors() {}

    /** Whether an error only precedes another one that names the place. */
    static boolean isDetail(SAXParseException error) {
        String key = key(error);
        return key != null
                && !key.startsWith("cvc-attribute")
                && !key.startsWith("cvc-complex-type")
                && !key.startsWith("cvc-type")
                && !key.startsWith("cvc-elt")
                && !key.startsWith("cvc-identity");
    }

    /** What is wrong with an element, and what to do about it. */
    static String explain(SAXParseException error, Element element) {
        String key = key(error);
        String message = String.valueOf(error.getMessage());
        List<String> quoted = quoted(message);
        String tag = "<" + element.name + ">";
        if (key == null) {
            return message;
        }
        return switch (key) {
            case "cvc-elt.1", "cvc-elt.1.a" ->
                "the root must be <world xmlns=\"" + WorldWriter.NAMESPACE + "\" ...> (got: " + tag + ")";
            case "cvc-complex-type.2.4.a", "cvc-complex-type.2.4.c", "cvc-complex-type.2.4.d" ->
                misplaced(quoted, element);
            case "cvc-complex-type.2.4.b" -> tag + " is not complete; add " + children(quoted);
            case "cvc-complex-type.2.1" -> tag + " must be empty; remove its content";
            case "cvc-complex-type.2.2" -> tag + " must contain only numbers; remove the elements in it";
            case "cvc-complex-type.2.3" -> tag + " cannot contain text; remove it or make it a comment";
            case "cvc-complex-type.3.2.2" ->
                tag + " has no attribute " + attribute(quoted, element) + "; see world.xsd for its attributes";
            case "cvc-complex-type.4" -> tag + " needs the attribute " + missing(quoted, element);
            case "cvc-attribute.3" -> wrongValue(quoted, element);
            default -> message.substring(message.indexOf(':') + 1).strip();
        };
    }

    private static String misplaced(List<String> quoted, Element element) {
        String children = children(quoted);
        String where = element.parent == null ? "" : " in <" + element.parent.name + ">";
        String remedy = children.isEmpty() ? "remove it" : ALLOWED + children;
        String namespace = element.namespace.equals(WorldWriter.NAMESPACE)
                ? ""
                : " of the namespace \"" + element.namespace + "\"";
        return "<" + element.name + ">" + namespace + " is not allowed" + where + "; " + remedy;
    }

    private static String wrongValue(List<String> quoted, Element element) {
        String attribute = attribute(quoted, element);
        String type = quoted.isEmpty() ? "" : quoted.get(quoted.size() - 1);
        String must = TYPES.get(type);
        return attribute + " of <" + element.name + "> must be " + (must == null ? "of type " + type : must) + " (got: "
                + element.attribute(attribute) + ")";
    }

    /** The element's attribute that the message names. */
    private static String attribute(List<String> quoted, Element element) {
        for (String name : quoted) {
            if (!name.equals(element.name) && element.attributes.getIndex(name) >= 0) {
                return name;
            }
        }
        return element.name; // an attribute with the same name as its element
    }

    private static String missing(List<String> quoted, Element element) {
        for (String name : quoted) {
            if (!name.equals(element.name)) {
                return name;
            }
        }
        return element.name;
    }

    /**
     * The elements allowed there: everything that the message quotes except the first, which is the refused element.
     */
    private static String children(List<String> quoted) {
        List<String> names = new ArrayList<>();
        for (String list : quoted.subList(Math.min(1, quoted.size()), quoted.size())) {
            Matcher matcher = CHILD.matcher(list);
            while (matcher.find()) {
                names.add("<" + matcher.group(1) + ">");
            }
        }
        return String.join(", ", names);
    }

    private static List<String> quoted(String message) {
        List<String> found = new ArrayList<>();
        Matcher matcher = QUOTED.matcher(message);
        while (matcher.find()) {
            found.add(matcher.group(1));
        }
        return found;
    }

    private static @Nullable String key(SAXParseException error) {
        Matcher matcher = KEY.matcher(String.valueOf(error.getMessage()));
        return matcher.find() ? matcher.group(1) : null;
    }
}
