package robosim.geometry.export;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.CRC32;

/**
 * Writes an MCAP file of ROS 2 messages: chunks without compression, an index of them at the end, and checksums of all. Equal
 * messages give equal bytes.
 *
 * <p>Source: the MCAP format specification, version 0 (mcap.dev/spec).
 */
final class McapWriter implements MessageSink {
    private static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

    private static final int HEADER = 1;
    private static final int FOOTER = 2;
    private static final int SCHEMA = 3;
    private static final int CHANNEL = 4;
    private static final int MESSAGE = 5;
    private static final int CHUNK = 6;
    private static final int MESSAGE_INDEX = 7;
    private static final int CHUNK_INDEX = 8;
    private static final int STATISTICS = 0x0b;
    private static final int SUMMARY_OFFSET = 0x0e;
    private static final int DATA_END = 0x0f;

    /** A chunk ends after so many bytes. A reader holds a chunk in memory. */
    private static final int CHUNK_BYTES = 1 << 20;

    /** A channel's number has two bytes. */
    private static final int MOST_CHANNELS = (1 << 16) - 1;

    private final OutputStream out;
    private final RosTypes types;
    private final CRC32 dataCrc = new CRC32();
    private long written;

    private final Map<String, Integer> schemas = new LinkedHashMap<>();
    private final Map<String, Channel> channels = new LinkedHashMap<>();
    private final List<byte[]> schemaRecords = new ArrayList<>();
    private final List<byte[]> channelRecords = new ArrayList<>();
    private final List<byte[]> chunkRecords = new ArrayList<>();

    private Content chunk = new Content();
    private final Map<Integer, Content> index = new TreeMap<>();
    private long chunkFrom;
    private long chunkTo;
    private long first;
    private long last;
    private long messages;

    /** A topic and its type. */
    private static final class Channel {
        private final int id;
        private final String type;
        private long messages;

        private Channel(int id, String type) {
            this.id = id;
            this.type = type;
        }
    }

    /** Begins a file. */
    McapWriter(OutputStream out, RosTypes types, String library) throws IOException {
        this.out = out;
        this.types = types;
        data(MAGIC);
        data(new Content().text("ros2").text(library).as(HEADER));
    }

    @Override
    public void write(String topic, String type, long nanos, List<?> value) throws IOException {
        Channel channel = channel(topic, type);
        if (messages == 0) {
            first = nanos;
        }
        if (index.isEmpty()) {
            chunkFrom = nanos;
        }
        chunkTo = nanos;
        last = nanos;
        index.computeIfAbsent(channel.id, unseen -> new Content())
                .number(nanos, 8)
                .number(chunk.size(), 8);
        chunk.bytes(new Content()
                .number(channel.id, 2)
                .number(channel.messages, 4)
                .number(nanos, 8)
                .number(nanos, 8)
                .bytes(types.encode(type, value))
                .as(MESSAGE));
        channel.messages++;
        messages++;
        if (chunk.size() >= CHUNK_BYTES) {
            endChunk();
        }
    }

    private Channel channel(String topic, String type) throws IOException {
        Channel known = channels.get(topic);
        if (known != null) {
            if (!known.type.equals(type)) {
                throw new IllegalArgumentException(
                        "messages of topic " + topic + " must be of type " + known.type + " (got: " + type + ")");
            }
            return known;
        }
        Integer schema = schemas.get(type);
        if (schema == null) {
            schema = schemas.size() + 1;
            schemas.put(type, schema);
            byte[] record = new Content()
                    .number(schema, 2)
                    .text(type.replace("/", "/msg/"))
                    .text("ros2msg")
                    .text(types.schema(type))
                    .as(SCHEMA);
            schemaRecords.add(record);
            chunk.bytes(record);
        }
        if (channels.size() >= MOST_CHANNELS) {
            throw new IOException("an MCAP file must have at most " + MOST_CHANNELS
                    + " topics; record fewer objects or sensors (got: one more, " + topic + ")");
        }
        Channel made = new Channel(channels.size() + 1, type);
        channels.put(topic, made);
        byte[] record = new Content()
                .number(made.id, 2)
                .number(schema, 2)
                .text(topic)
                .text("cdr")
                .number(0, 4) // no metadata
                .as(CHANNEL);
        channelRecords.add(record);
        chunk.bytes(record);
        return made;
    }

    private void endChunk() throws IOException {
        if (index.isEmpty()) {
            return;
        }
        byte[] records = chunk.content();
        long start = written;
        byte[] record = new Content()
                .number(chunkFrom, 8)
                .number(chunkTo, 8)
                .number(records.length, 8)
                .number(crc(records), 4)
                .text("")
                .number(records.length, 8)
                .bytes(records)
                .as(CHUNK);
        data(record);
        Content offsets = new Content();
        long indexFrom = written;
        for (Map.Entry<Integer, Content> each : index.entrySet()) {
            offsets.number(each.getKey(), 2).number(written, 8);
            byte[] entries = each.getValue().content();
            data(new Content()
                    .number(each.getKey(), 2)
                    .number(entries.length, 4)
                    .bytes(entries)
                    .as(MESSAGE_INDEX));
        }
        chunkRecords.add(new Content()
                .number(chunkFrom, 8)
                .number(chunkTo, 8)
                .number(start, 8)
                .number(record.length, 8)
                .number(offsets.size(), 4)
                .bytes(offsets.content())
                .number(written - indexFrom, 8)
                .text("")
                .number(records.length, 8)
                .number(records.length, 8)
                .as(CHUNK_INDEX));
        chunk = new Content();
        index.clear();
    }

    /** Writes what is left and the summary. The stream stays open. */
    @Override
    public void finish() throws IOException {
        endChunk();
        plain(new Content().number(dataCrc.getValue(), 4).as(DATA_END));
        long summary = written;
        Content all = new Content();
        Content groups = new Content();
        group(SCHEMA, schemaRecords, summary, all, groups);
        group(CHANNEL, channelRecords, summary, all, groups);
        group(STATISTICS, List.of(statistics()), summary, all, groups);
        group(CHUNK_INDEX, chunkRecords, summary, all, groups);
        long groupsFrom = summary + all.size();
        all.bytes(groups.content());
        Content footer = new Content().number(summary, 8).number(groupsFrom, 8);
        CRC32 crc = new CRC32();
        crc.update(all.content());
        crc.update(FOOTER);
        crc.update(new Content().number(footer.size() + 4L, 8).content());
        crc.update(footer.content());
        plain(all.content());
        plain(footer.number(crc.getValue(), 4).as(FOOTER));
        plain(MAGIC);
    }

    private static void group(int opcode, List<byte[]> records, long summary, Content all, Content groups) {
        if (records.isEmpty()) {
            return;
        }
        long from = summary + all.size();
        records.forEach(all::bytes);
        groups.bytes(new Content()
                .number(opcode, 1)
                .number(from, 8)
                .number(summary + all.size() - from, 8)
                .as(SUMMARY_OFFSET));
    }

    private byte[] statistics() {
        Content counts = new Content();
        channels.values().forEach(each -> counts.number(each.id, 2).number(each.messages, 8));
        return new Content()
                .number(messages, 8)
                .number(schemas.size(), 2)
                .number(channels.size(), 4)
                .number(0, 4) // attachments
                .number(0, 4) // metadata
                .number(chunkRecords.size(), 4)
                .number(first, 8)
                .number(last, 8)
                .number(counts.size(), 4)
                .bytes(counts.content())
                .as(STATISTICS);
    }

    private static long crc(byte[] bytes) {
        CRC32 crc = new CRC32();
        crc.update(bytes);
        return crc.getValue();
    }

    private void data(byte[] bytes) throws IOException {
        dataCrc.update(bytes);
        plain(bytes);
    }

    private void plain(byte[] bytes) throws IOException {
        out.write(bytes);
        written += bytes.length;
    }

    /** The content of a record, least significant byte first. */
    private static final class Content {
        private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

        private int size() {
            return bytes.size();
        }

        private byte[] content() {
            return bytes.toByteArray();
        }

        private Content number(long value, int size) {
            for (int k = 0; k < size; k++) {
                bytes.write((int) (value >>> (8 * k)));
            }
            return this;
        }

        private Content bytes(byte[] more) {
            bytes.writeBytes(more);
            return this;
        }

        private Content text(String text) {
            byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
            return number(utf8.length, 4).bytes(utf8);
        }

        /** The record: its kind, its length and its content. */
        private byte[] as(int opcode) {
            return new Content()
                    .number(opcode, 1)
                    .number(size(), 8)
                    .bytes(content())
                    .content();
        }
    }
}
