package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.protocol.ProtocolException;

/**
 * A line of JSON that is not a protocol message: an object whose fields are read by name, as strictly as a message.
 * Scenario files contain such lines in addition to messages.
 */
public final class JsonRecord {
    private final String place;
    private final Map<String, @Nullable Object> fields;

    private JsonRecord(String place, Map<String, @Nullable Object> fields) {
        this.place = place;
        this.fields = fields;
    }

    /**
     * Reads a line.
     *
     * @throws ProtocolException if it is not an object of strings, numbers, booleans, nulls and nested objects
     */
    public static JsonRecord read(String line) throws ProtocolException {
        byte[] bytes = JsonLines.bytes(line);
        return JsonLines.guarded(() -> {
            try (JsonInput in = JsonInput.of(bytes, 0, bytes.length)) {
                return new JsonRecord("", plain(in));
            }
        });
    }

    /**
     * Checks the record's fields.
     *
     * @param required names separated by spaces
     * @param optional names separated by spaces, or empty
     * @return this
     * @throws ProtocolException naming a field that is missing or unknown
     */
    public JsonRecord only(String required, String optional) throws ProtocolException {
        Checks.present("optional", optional);
        for (String name : List.of(Checks.present("required", required).split(" "))) {
            if (!fields.containsKey(name)) {
                throw refused("must have the field \"" + name + "\" (got: none)");
            }
        }
        List<String> known = Arrays.asList((required + " " + optional).trim().split(" "));
        for (String name : fields.keySet()) {
            if (!known.contains(name)) {
                throw refused(
                        "a field must be one of " + String.join(", ", known) + " (got: " + Text.quoted(name) + ")");
            }
        }
        return this;
    }

    /** The names of all fields, in their order. */
    public List<String> names() {
        return List.copyOf(fields.keySet());
    }

    /** Whether there is such a field. */
    public boolean has(String field) {
        return fields.containsKey(Checks.present("field", field));
    }

    /** Whether the field exists and is null. */
    public boolean isNull(String field) {
        return has(field) && fields.get(field) == null;
    }

    /** A string. */
    public String text(String field) throws ProtocolException {
        return value(field, String.class, "a string");
    }

    /** A finite number. */
    public double number(String field) throws ProtocolException {
        return value(field, Double.class, "a number");
    }

    /** A whole number from {@code least} to {@code most}, within the range that a double holds exactly. */
    public long whole(String field, long least, long most) throws ProtocolException {
        double number = number(field);
        if (!(number >= least && number <= most) || number != Math.rint(number)) {
            throw at(field).refused("must be a whole number from " + least + " to " + most + " (got: " + number + ")");
        }
        return (long) number;
    }

    /** A constant of an enum. */
    public <E extends Enum<E>> E constant(String field, Class<E> type) throws ProtocolException {
        Checks.present("type", type);
        String text = text(field);
        for (E constant : type.getEnumConstants()) {
            if (constant.name().equals(text)) {
                return constant;
            }
        }
        throw at(field)
                .refused("must be one of " + Arrays.toString(type.getEnumConstants()) + " (got: " + Text.quoted(text)
                        + ")");
    }

    /** A nested record. */
    @SuppressWarnings("unchecked") // no other maps are made here
    public JsonRecord record(String field) throws ProtocolException {
        return new JsonRecord(
                place + "/" + field, (Map<String, @Nullable Object>) value(field, Map.class, "an object, {...}"));
    }

    private <T> T value(String field, Class<T> type, String kind) throws ProtocolException {
        Object value = fields.get(Checks.present("field", field));
        if (!type.isInstance(value)) {
            throw at(field).refused("must be " + kind + " (got: " + (value == null ? "null or none" : "another") + ")");
        }
        return type.cast(value);
    }

    private JsonRecord at(String field) {
        return new JsonRecord(place + "/" + field, fields);
    }

    /** An exception about this record, with its place. */
    public ProtocolException refused(String what) {
        Checks.present("what", what);
        return new ProtocolException((place.isEmpty() ? "the line: " : "at " + Text.line(place) + ": ") + what);
    }

    /** Writes a line of fields, given as their names and values in turns. */
    public static String line(@Nullable Object... fields) {
        return write(fields(Checks.present("fields", fields)));
    }

    /** Fields in their order, given as their names and values in turns. */
    public static Map<String, @Nullable Object> fields(@Nullable Object... pairs) {
        Map<String, @Nullable Object> fields = new LinkedHashMap<>();
        for (int k = 0; k < Checks.present("pairs", pairs).length; k += 2) {
            fields.put(String.valueOf(pairs[k]), pairs[k + 1]);
        }
        return fields;
    }

    /**
     * Writes a line, without its line feed.
     *
     * @param fields the fields, in the order of the map: Strings, Longs, Integers, Doubles, Booleans, enums, nulls and
     *               nested maps. An infinite Double becomes null, as in messages
     */
    public static String write(Map<String, ? extends @Nullable Object> fields) {
        Checks.present("fields", fields);
        StringWriter text = new StringWriter();
        try (JsonGenerator out = JsonInput.FACTORY.createGenerator(text)) {
            write(out, fields);
        } catch (IOException e) {
            throw new UncheckedIOException("writing to a string cannot fail", e);
        }
        return JsonLines.wellFormed(text.toString());
    }

    private static void write(JsonGenerator out, Map<?, ?> fields) throws IOException {
        out.writeStartObject();
        for (Map.Entry<?, ?> field : fields.entrySet()) {
            out.writeFieldName(String.valueOf(field.getKey()));
            Object value = field.getValue();
            if (value instanceof Map<?, ?> inner) {
                write(out, inner);
            } else if (value instanceof Double number && Double.isFinite(number)) {
                out.writeNumber(number);
            } else if (value instanceof Long || value instanceof Integer) {
                out.writeNumber(((Number) value).longValue());
            } else if (value instanceof Boolean flag) {
                out.writeBoolean(flag);
            } else if (value == null || value instanceof Double) {
                out.writeNull();
            } else {
                out.writeString(value instanceof Enum<?> constant ? constant.name() : value.toString());
            }
        }
        out.writeEndObject();
    }

    /** Reads a whole line, an object whose fields are not known beforehand: texts, numbers, flags, nulls and such objects. */
    private static Map<String, @Nullable Object> plain(JsonInput in) throws IOException {
        in.begin();
        Map<String, @Nullable Object> fields = fields(in);
        in.end();
        return fields;
    }

    private static Map<String, @Nullable Object> fields(JsonInput in) throws IOException {
        if (!in.isObject()) {
            throw in.refused("must be an object, {...} (got: " + in.kind() + ")");
        }
        Map<String, @Nullable Object> fields = new LinkedHashMap<>();
        for (String name = in.nextField(); name != null; name = in.nextField()) {
            if (fields.containsKey(name)) {
                throw in.refused("a field must occur only once (got: " + in.told(name) + " twice)");
            }
            fields.put(name, value(in));
        }
        return fields;
    }

    private static @Nullable Object value(JsonInput in) throws IOException {
        if (in.isObject()) {
            return fields(in);
        }
        if (in.isText()) {
            return in.text();
        }
        if (in.isNumber()) {
            return in.number();
        }
        if (in.isFlag()) {
            return in.flag();
        }
        if (in.isNull()) {
            return null;
        }
        throw in.refused("must be an object, a string, a number, true, false or null (got: " + in.kind() + ")");
    }
}
