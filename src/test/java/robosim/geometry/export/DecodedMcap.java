package robosim.geometry.export;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32;

/**
 * An MCAP file as its specification has it, read without the index; all checksums, lengths and places of the index are checked.
 * Messages are decoded by the schemas in the file. Shares nothing with the writer.
 */
final class DecodedMcap {
    private static final byte[] MAGIC = {(byte) 0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a};

    /** A message: its fields by name. */
    record Message(String topic, String type, long nanos, Map<String, Object> value) {}

    final List<Message> messages = new ArrayList<>();
    final Map<String, Long> counts = new LinkedHashMap<>();

    private record Schema(String name, String text) {}

    private record Channel(String topic, Schema schema) {}

    private final Map<Integer, Schema> schemas = new LinkedHashMap<>();
    private final Map<Integer, Channel> channels = new LinkedHashMap<>();
    private final ByteBuffer file;
    private int indexed;

    DecodedMcap(byte[] bytes) {
        file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        check(Arrays.equals(bytes(file, 8), MAGIC), "magic");
        while (true) {
            int at = file.position();
            int opcode = file.get();
            ByteBuffer record = slice(file, (int) file.getLong());
            if (opcode == 0x0f) {
                check(crc(0, at) == Integer.toUnsignedLong(record.getInt()), "checksum of the data");
                break;
            }
            switch (opcode) {
                case 1 -> check(text(record).equals("ros2"), "profile");
                case 6 -> chunk(record);
                case 7 -> messageIndex(record);
                default -> throw new AssertionError("a record of kind " + opcode + " at " + at);
            }
        }
        summary();
        check(indexed == messages.size(), "each message is in the index");
    }

    private void chunk(ByteBuffer chunk) {
        long from = chunk.getLong();
        long to = chunk.getLong();
        long size = chunk.getLong();
        long crc = Integer.toUnsignedLong(chunk.getInt());
        check(text(chunk).isEmpty(), "no compression");
        check(chunk.getLong() == size && chunk.remaining() == size, "size of a chunk");
        CRC32 sum = new CRC32();
        sum.update(chunk.duplicate());
        check(sum.getValue() == crc, "checksum of a chunk");
        while (chunk.hasRemaining()) {
            int opcode = chunk.get();
            ByteBuffer record = slice(chunk, (int) chunk.getLong());
            switch (opcode) {
                case 3 -> schema(record);
                case 4 -> channel(record);
                case 5 -> {
                    Message message = message(record);
                    check(message.nanos >= from && message.nanos <= to, "times of a chunk");
                    messages.add(message);
                }
                default -> throw new AssertionError("a record of kind " + opcode + " in a chunk");
            }
        }
    }

    private void schema(ByteBuffer record) {
        int id = record.getShort();
        Schema schema = new Schema(text(record), encoded(record));
        check(schemas.putIfAbsent(id, schema) == null || schemas.get(id).equals(schema), "one schema for each number");
    }

    private static String encoded(ByteBuffer record) {
        check(text(record).equals("ros2msg"), "encoding of a schema");
        return text(record);
    }

    private void channel(ByteBuffer record) {
        int id = record.getShort();
        Schema schema = schemas.get((int) record.getShort());
        Channel channel = new Channel(text(record), schema);
        check(text(record).equals("cdr"), "encoding of messages");
        check(record.getInt() == 0 && !record.hasRemaining(), "no metadata");
        check(channels.putIfAbsent(id, channel) == null || channels.get(id).equals(channel), "one channel");
    }

    private Message message(ByteBuffer record) {
        Channel channel = channels.get((int) record.getShort());
        long sequence = counts.merge(channel.topic, 1L, Long::sum) - 1;
        check(record.getInt() == sequence, "sequence");
        long nanos = record.getLong();
        check(record.getLong() == nanos, "time of publishing");
        check(record.getInt() == 0x100, "begin of a message"); // 00 01 00 00
        ByteBuffer body = record.slice().order(ByteOrder.LITTLE_ENDIAN);
        String type = channel.schema.name.replace("/msg/", "/");
        Map<String, Object> value = value(body, type, definitions(channel.schema));
        check(!body.hasRemaining(), "nothing after a message of " + channel.topic);
        return new Message(channel.topic, type, nanos, value);
    }

    private static Map<String, String> definitions(Schema schema) {
        Map<String, String> definitions = new LinkedHashMap<>();
        String[] parts = schema.text.split("={80}\nMSG: ");
        definitions.put(schema.name.replace("/msg/", "/"), parts[0]);
        for (int k = 1; k < parts.length; k++) {
            int line = parts[k].indexOf('\n');
            definitions.put(parts[k].substring(0, line), parts[k].substring(line + 1));
        }
        return definitions;
    }

    private static Map<String, Object> value(ByteBuffer in, String type, Map<String, String> definitions) {
        Map<String, Object> value = new LinkedHashMap<>();
        for (String line : definitions.get(type).strip().split("\n")) {
            if (line.contains("=")) {
                continue;
            }
            String field = line.substring(0, line.indexOf(' '));
            String name = line.substring(line.indexOf(' ') + 1);
            if (!field.endsWith("]")) {
                value.put(name, one(in, field, definitions));
                continue;
            }
            String size = field.substring(field.indexOf('[') + 1, field.length() - 1);
            int count = size.isEmpty() ? (int) (long) one(in, "uint32", definitions) : Integer.parseInt(size);
            List<Object> elements = new ArrayList<>();
            for (int k = 0; k < count; k++) {
                elements.add(one(in, field.substring(0, field.indexOf('[')), definitions));
            }
            value.put(name, elements);
        }
        return value;
    }

    private static Object one(ByteBuffer in, String type, Map<String, String> definitions) {
        return switch (type) {
            case "bool" -> in.get() == 1;
            case "int8" -> (long) in.get();
            case "uint8" -> (long) (in.get() & 255);
            case "int32" -> (long) aligned(in, 4).getInt();
            case "uint32" -> Integer.toUnsignedLong(aligned(in, 4).getInt());
            case "float32" -> (double) aligned(in, 4).getFloat();
            case "float64" -> aligned(in, 8).getDouble();
            case "string" -> {
                byte[] text = bytes(in, aligned(in, 4).getInt());
                check(text[text.length - 1] == 0, "a text ends in zero");
                yield new String(text, 0, text.length - 1, StandardCharsets.UTF_8);
            }
            default -> value(in, type, definitions);
        };
    }

    private static ByteBuffer aligned(ByteBuffer in, int size) {
        return in.position((in.position() + size - 1) / size * size);
    }

    private void messageIndex(ByteBuffer record) {
        Channel channel = channels.get((int) record.getShort());
        int entries = record.getInt() / 16;
        indexed += entries;
        long of = messages.stream().filter(m -> m.topic.equals(channel.topic)).count();
        check(entries >= 1 && entries <= of && record.remaining() == 16 * entries, "entries of an index");
    }

    private void summary() {
        int start = file.position();
        int end = file.limit() - 8 - 29;
        file.position(end);
        check(file.get() == 2 && file.getLong() == 20, "footer");
        check(file.getLong() == start, "place of the summary");
        long groups = file.getLong();
        check(crc(start, file.position()) == Integer.toUnsignedLong(file.getInt()), "checksum of the summary");
        check(Arrays.equals(bytes(file, 8), MAGIC) && !file.hasRemaining(), "magic at the end");
        file.position((int) groups);
        long next = start;
        while (file.position() < end) {
            check(file.get() == 0x0e, "a summary offset");
            ByteBuffer record = slice(file, (int) file.getLong());
            int opcode = record.get();
            check(record.getLong() == next, "groups follow each other");
            long length = record.getLong();
            group(opcode, (int) next, (int) (next + length));
            next += length;
        }
        check(next == groups, "groups are all of the summary");
    }

    private void group(int opcode, int from, int to) {
        ByteBuffer group = file.duplicate().order(ByteOrder.LITTLE_ENDIAN).position(from);
        while (group.position() < to) {
            check(group.get() == opcode, "a group has records of one kind");
            ByteBuffer record = slice(group, (int) group.getLong());
            switch (opcode) {
                case 3 -> schema(record);
                case 4 -> channel(record);
                case 8 -> chunkIndex(record);
                case 0x0b -> check(record.getLong() == messages.size(), "number of messages");
                default -> throw new AssertionError("a record of kind " + opcode + " in the summary");
            }
        }
        check(group.position() == to, "length of a group");
    }

    private void chunkIndex(ByteBuffer record) {
        long from = record.getLong();
        long to = record.getLong();
        ByteBuffer chunk = file.duplicate().order(ByteOrder.LITTLE_ENDIAN).position((int) record.getLong());
        long length = record.getLong();
        check(chunk.get() == 6 && chunk.getLong() == length - 9, "length of a chunk");
        check(chunk.getLong() == from && chunk.getLong() == to, "times in the index");
        int maps = record.getInt();
        for (int k = 0; k < maps; k += 10) {
            int channel = record.getShort();
            ByteBuffer at = file.duplicate().order(ByteOrder.LITTLE_ENDIAN).position((int) record.getLong());
            check(at.get() == 7, "an index of messages");
            at.getLong();
            check(at.getShort() == channel, "the channel of an index");
        }
    }

    private long crc(int from, int to) {
        CRC32 crc = new CRC32();
        crc.update(file.duplicate().limit(to).position(from));
        return crc.getValue();
    }

    private static ByteBuffer slice(ByteBuffer in, int length) {
        ByteBuffer slice = in.slice().limit(length).slice().order(ByteOrder.LITTLE_ENDIAN);
        in.position(in.position() + length);
        return slice;
    }

    private static byte[] bytes(ByteBuffer in, int length) {
        byte[] bytes = new byte[length];
        in.get(bytes);
        return bytes;
    }

    private static String text(ByteBuffer in) {
        return new String(bytes(in, in.getInt()), StandardCharsets.UTF_8);
    }

    private static void check(boolean holds, String what) {
        if (!holds) {
            throw new AssertionError(what);
        }
    }
}
