package robosim.geometry.export;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Messages of ROS 2: their definitions, and values in the encoding that they describe, CDR, least significant byte first.
 *
 * <p>A value is a list of the values of its fields, in order. A field is a number, a Boolean, a text, a list of values, or an
 * array of bytes, floats or doubles.
 */
final class RosTypes {
    private static final byte[] BEGIN = {0, 1, 0, 0};

    private static final String SEPARATOR = "=".repeat(80);

    /**
     * A field of a message.
     *
     * @param type  a primitive type, or a message's
     * @param count of an array: how many elements it has, or 0 for any number; -1 for a single value
     */
    private record Field(String type, int count, String name) {}

    /** The text of each definition, by its name without {@code /msg/}. */
    private final Map<String, String> texts = new LinkedHashMap<>();

    private final Map<String, List<Field>> fields = new LinkedHashMap<>();

    RosTypes() {
        for (String section : resource().split("=== ", -1)) {
            int end = section.indexOf('\n');
            if (end > 0) {
                texts.put(section.substring(0, end), section.substring(end + 1).strip());
            }
        }
        texts.forEach((name, text) -> fields.put(name, parse(text)));
    }

    private static String resource() {
        try (InputStream in = RosTypes.class.getResourceAsStream("/robosim/geometry/export/ros2.msg")) {
            if (in == null) {
                throw new IllegalStateException("the jar must contain robosim/geometry/export/ros2.msg (got: none)");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static List<Field> parse(String text) {
        List<Field> parsed = new ArrayList<>();
        for (String line : text.split("\n", -1)) {
            if (line.contains("=")) {
                continue; // a constant
            }
            String[] parts = line.split(" ", -1);
            int bracket = parts[0].indexOf('[');
            String count = bracket < 0 ? "" : parts[0].substring(bracket + 1, parts[0].length() - 1);
            parsed.add(new Field(
                    bracket < 0 ? parts[0] : parts[0].substring(0, bracket),
                    bracket < 0 ? -1 : count.isEmpty() ? 0 : Integer.parseInt(count),
                    parts[1]));
        }
        return List.copyOf(parsed);
    }

    /** A definition, followed by those of all messages that it contains. */
    String schema(String type) {
        List<String> needed = new ArrayList<>(List.of(type));
        for (int k = 0; k < needed.size(); k++) {
            for (Field field : definition(needed.get(k))) {
                if (texts.containsKey(field.type) && !needed.contains(field.type)) {
                    needed.add(field.type);
                }
            }
        }
        StringBuilder schema = new StringBuilder(texts.get(type));
        for (String other : needed.subList(1, needed.size())) {
            schema.append('\n')
                    .append(SEPARATOR)
                    .append("\nMSG: ")
                    .append(other)
                    .append('\n');
            schema.append(texts.get(other));
        }
        return schema.append('\n').toString();
    }

    private List<Field> definition(String type) {
        List<Field> found = fields.get(type);
        if (found == null) {
            throw new IllegalArgumentException("type must be a message of ros2.msg (got: " + type + ")");
        }
        return found;
    }

    /** A value of a type as bytes. */
    byte[] encode(String type, List<?> value) {
        PackedStream out = new PackedStream().append(BEGIN);
        message(type, value, out);
        return out.toBytes();
    }

    private void message(String type, List<?> value, PackedStream out) {
        List<Field> all = definition(type);
        if (value.size() != all.size()) {
            throw new IllegalArgumentException(
                    type + " must have " + all.size() + " values (got: " + value.size() + ")");
        }
        for (int k = 0; k < all.size(); k++) {
            Field field = all.get(k);
            if (field.count < 0) {
                single(field.type, value.get(k), out);
            } else {
                array(field, value.get(k), out);
            }
        }
    }

    private void array(Field field, Object value, PackedStream out) {
        int size = size(value);
        if (field.count == 0) {
            number(size, 4, out);
        } else if (size != field.count) {
            throw new IllegalArgumentException(
                    field.name + " must have " + field.count + " elements (got: " + size + ")");
        }
        if (value instanceof byte[] bytes) {
            out.append(bytes);
        } else if (value instanceof float[] floats) {
            for (float each : floats) {
                single(field.type, each, out);
            }
        } else if (value instanceof double[] doubles) {
            for (double each : doubles) {
                single(field.type, each, out);
            }
        } else {
            for (Object each : (List<?>) value) {
                single(field.type, each, out);
            }
        }
    }

    private static int size(Object array) {
        if (array instanceof byte[] bytes) {
            return bytes.length;
        }
        if (array instanceof float[] floats) {
            return floats.length;
        }
        return array instanceof double[] doubles ? doubles.length : ((List<?>) array).size();
    }

    private void single(String type, Object value, PackedStream out) {
        switch (type) {
            case "bool" -> number((Boolean) value ? 1 : 0, 1, out);
            case "int8", "uint8" -> number(((Number) value).longValue(), 1, out);
            case "int16", "uint16" -> number(((Number) value).longValue(), 2, out);
            case "int32", "uint32" -> number(((Number) value).longValue(), 4, out);
            case "float32" -> number(Float.floatToRawIntBits(((Number) value).floatValue()), 4, out);
            case "float64" -> number(Double.doubleToRawLongBits(((Number) value).doubleValue()), 8, out);
            case "string" -> text((String) value, out);
            default -> message(type, (List<?>) value, out);
        }
    }

    /** A number, aligned to its own size, counted from after the four bytes that begin a message. */
    private static void number(long bits, int size, PackedStream out) {
        while ((out.size() - BEGIN.length) % size != 0) {
            out.octet(0);
        }
        out.number(bits, size);
    }

    /** A text's length counts the zero at its end. */
    private static void text(String text, PackedStream out) {
        byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
        number(utf8.length + 1L, 4, out);
        out.append(utf8).octet(0);
    }
}
