package robosim.geometry.world.shared;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Texts in JSON (RFC 8259) from and to maps, lists, strings, numbers and booleans; null is null. Of a name that an object has
 * twice, the last value counts.
 */
public final class JsonText {
    private final String text;
    private final String source;
    private int at;
    private int values;

    private JsonText(String text, String source) {
        this.text = text;
        this.source = source;
    }

    /**
     * The value of a text; its numbers are doubles.
     *
     * @param source the name of the text in messages
     */
    public static @Nullable Object parse(String text, String source) throws FileProblem {
        JsonText parser = new JsonText(text, source);
        parser.at = text.startsWith("\uFEFF") ? 1 : 0;
        Object value = parser.value(0);
        if (parser.next() != 0) {
            throw parser.wrong("the text must end after its first value (got: more)");
        }
        return value;
    }

    /**
     * The text of a value: null, a string, a number, a boolean, a collection or a map of strings to values. Maps keep their
     * order; NaN and infinities become null.
     */
    public static String of(@Nullable Object value) {
        StringBuilder text = new StringBuilder();
        write(value, text);
        return text.toString();
    }

    /** Fields in their order, given as their names and values in turns. */
    public static Map<String, @Nullable Object> fields(@Nullable Object... pairs) {
        Map<String, @Nullable Object> fields = new LinkedHashMap<>();
        for (int k = 0; k < pairs.length; k += 2) {
            fields.put(String.valueOf(pairs[k]), pairs[k + 1]);
        }
        return fields;
    }

    private static void write(@Nullable Object value, StringBuilder out) {
        if (value instanceof Map<?, ?> map) {
            String before = "{";
            for (Map.Entry<?, ?> entry : map.entrySet()) {
                out.append(before);
                quote(String.valueOf(entry.getKey()), out);
                out.append(':');
                write(entry.getValue(), out);
                before = ",";
            }
            out.append(map.isEmpty() ? "{}" : "}");
        } else if (value instanceof Collection<?> list) {
            String before = "[";
            for (Object element : list) {
                out.append(before);
                write(element, out);
                before = ",";
            }
            out.append(list.isEmpty() ? "[]" : "]");
        } else if (value instanceof Number || value instanceof Boolean) {
            boolean finite = !(value instanceof Double number) || Double.isFinite(number);
            out.append(finite ? value.toString() : "null");
        } else if (value == null) {
            out.append("null");
        } else {
            quote(value.toString(), out);
        }
    }

    private static void quote(String text, StringBuilder out) {
        out.append('"');
        for (int k = 0; k < text.length(); k++) {
            char c = text.charAt(k);
            if (c == '"' || c == '\\') {
                out.append('\\').append(c);
            } else if (c < ' ' || Character.isSurrogate(c)) {
                out.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
            } else {
                out.append(c);
            }
        }
        out.append('"');
    }

    /** The next character that is not white space, which is not taken; 0 at the end. */
    private char next() {
        while (at < text.length()) {
            char c = text.charAt(at);
            if (c != ' ' && c != '\n' && c != '\r' && c != '\t') {
                return c;
            }
            at++;
        }
        return 0;
    }

    private @Nullable Object value(int depth) throws FileProblem {
        if (depth > Limits.MAX_DEPTH) {
            throw wrong("values must be nested at most " + Limits.MAX_DEPTH + " deep; nest less (got: one more)");
        }
        if (++values > Limits.MAX_ELEMENTS) {
            throw wrong("the text must have at most " + Limits.MAX_ELEMENTS
                    + " values; simplify the scene, or write it as .glb (got: more)");
        }
        FileWork.take(1);
        return switch (next()) {
            case '{' -> object(depth);
            case '[' -> list(depth);
            case '"' -> string();
            case 't' -> word("true", true);
            case 'f' -> word("false", false);
            case 'n' -> word("null", null);
            default -> number();
        };
    }

    private Map<String, @Nullable Object> object(int depth) throws FileProblem {
        Map<String, @Nullable Object> object = new LinkedHashMap<>();
        at++;
        if (next() == '}') {
            at++;
            return object;
        }
        while (true) {
            if (next() != '"') {
                throw missing("a name in quotes");
            }
            String name = string();
            if (next() != ':') {
                throw missing(":");
            }
            at++;
            object.put(name, value(depth + 1));
            if (isLast('}')) {
                return object;
            }
        }
    }

    private List<@Nullable Object> list(int depth) throws FileProblem {
        List<@Nullable Object> list = new ArrayList<>();
        at++;
        if (next() == ']') {
            at++;
            return list;
        }
        while (true) {
            list.add(value(depth + 1));
            if (isLast(']')) {
                return list;
            }
        }
    }

    /** Takes the comma behind a value, or the bracket behind the last. */
    private boolean isLast(char end) throws FileProblem {
        char c = next();
        if (c != ',' && c != end) {
            throw missing("a comma or " + end);
        }
        at++;
        return c == end;
    }

    private String string() throws FileProblem {
        int begin = ++at;
        while (at < text.length() && text.charAt(at) != '"' && text.charAt(at) != '\\' && text.charAt(at) >= ' ') {
            at++;
        }
        if (at < text.length() && text.charAt(at) == '"') {
            return text.substring(begin, at++); // most, and the long ones, have no escapes
        }
        StringBuilder string = new StringBuilder(text.substring(begin, at));
        while (at < text.length()) {
            char c = text.charAt(at++);
            if (c == '"') {
                return string.toString();
            }
            if (c < ' ') {
                throw wrong("a string must have no control characters (got: one)");
            }
            string.append(c == '\\' ? escaped() : c);
        }
        throw wrong("a string must end with quotes (got: the end of the file)");
    }

    private char escaped() throws FileProblem {
        char c = at < text.length() ? text.charAt(at++) : 0;
        return switch (c) {
            case '"', '\\', '/' -> c;
            case 'b' -> '\b';
            case 'f' -> '\f';
            case 'n' -> '\n';
            case 'r' -> '\r';
            case 't' -> '\t';
            case 'u' -> unicode();
            default -> throw wrong("a \\ in a string must be followed by one of \"\\/bfnrtu (got: another)");
        };
    }

    private char unicode() throws FileProblem {
        int code = 0;
        for (int k = 0; k < 4; k++) {
            int digit = at < text.length() ? Character.digit(text.charAt(at++), 16) : -1;
            if (digit < 0) {
                throw wrong("\\u must be followed by four hexadecimal digits (got: others)");
            }
            code = 16 * code + digit;
        }
        return (char) code;
    }

    private @Nullable Boolean word(String word, @Nullable Boolean value) throws FileProblem {
        if (!text.startsWith(word, at)) {
            throw missing("a value");
        }
        at += word.length();
        return value;
    }

    private Double number() throws FileProblem {
        int begin = at;
        while (at < text.length() && "+-.0123456789eE".indexOf(text.charAt(at)) >= 0) {
            at++;
        }
        if (begin == at) {
            throw missing("a value");
        }
        try {
            return Numbers.parse(text.substring(begin, at));
        } catch (IllegalArgumentException e) {
            throw wrong(String.valueOf(e.getMessage()));
        }
    }

    private FileProblem missing(String what) {
        String found =
                at < text.length() ? text.substring(at, Math.min(text.length(), at + 20)) : "the end of the file";
        return wrong(what + " must come next (got: " + found.replaceAll("\\p{Cntrl}", " ") + ")");
    }

    private FileProblem wrong(String problem) {
        int line = 1;
        for (int k = 0; k < Math.min(at, text.length()); k++) {
            line += text.charAt(k) == '\n' ? 1 : 0;
        }
        return new FileProblem(source, line, 0, problem);
    }
}
