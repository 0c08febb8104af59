package robosim.geometry.export;

import java.io.IOException;
import java.io.OutputStream;
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

    private PackedStream chunk = new PackedStream();
    private final Map<Integer, PackedStream> index = new TreeMap<>();
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
        data(record(HEADER, new PackedStream().longText("ros2").longText(library)));
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
        index.computeIfAbsent(channel.id, unseen -> new PackedStream())
                .number(nanos, 8)
                .number(chunk.size(), 8);
        chunk.append(record(
                MESSAGE,
                new PackedStream()
                        .number(channel.id, 2)
                        .number(channel.messages, 4)
                        .number(nanos, 8)
                        .number(nanos, 8)
                        .append(types.encode(type, value))));
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
            byte[] record = record(
                    SCHEMA,
                    new PackedStream()
                            .number(schema, 2)
                            .longText(type.replace("/", "/msg/"))
                            .longText("ros2msg")
                            .longText(types.schema(type)));
            schemaRecords.add(record);
            chunk.append(record);
        }
        if (channels.size() >= MOST_CHANNELS) {
            throw new IOException("an MCAP file must have at most " + MOST_CHANNELS
                    + " topics; record fewer objects or sensors (got: one more, " + topic + ")");
        }
        Channel made = new Channel(channels.size() + 1, type);
        channels.put(topic, made);
        byte[] record = record(
                CHANNEL,
                new PackedStream()
                        .number(made.id, 2)
                        .number(schema, 2)
                        .longText(topic)
                        .longText("cdr")
                        .number(0, 4)); // no metadata
        channelRecords.add(record);
        chunk.append(record);
        return made;
    }

    private void endChunk() throws IOException {
        if (index.isEmpty()) {
            return;
        }
        byte[] records = chunk.toBytes();
        long start = written;
        byte[] record = record(
                CHUNK,
                new PackedStream()
                        .number(chunkFrom, 8)
                        .number(chunkTo, 8)
                        .number(records.length, 8)
                        .number(crc(records), 4)
                        .longText("")
                        .number(records.length, 8)
                        .append(records));
        data(record);
        PackedStream offsets = new PackedStream();
        long indexFrom = written;
        for (Map.Entry<Integer, PackedStream> each : index.entrySet()) {
            offsets.number(each.getKey(), 2).number(written, 8);
            byte[] entries = each.getValue().toBytes();
            data(record(
                    MESSAGE_INDEX,
                    new PackedStream()
                            .number(each.getKey(), 2)
                            .number(entries.length, 4)
                            .append(entries)));
        }
        chunkRecords.add(record(
                CHUNK_INDEX,
                new PackedStream()
                        .number(chunkFrom, 8)
                        .number(chunkTo, 8)
                        .number(start, 8)
                        .number(record.length, 8)
                        .number(offsets.size(), 4)
                        .append(offsets.toBytes())
                        .number(written - indexFrom, 8)
                        .longText("")
                        .number(records.length, 8)
                        .number(records.length, 8)));
        chunk = new PackedStream();
        index.clear();
    }

    /** Writes what is left and the summary. The stream stays open. */
    @Override
    public void finish() throws IOException {
        endChunk();
        plain(record(DATA_END, new PackedStream().number(dataCrc.getValue(), 4)));
        long summary = written;
        PackedStream all = new PackedStream();
        PackedStream groups = new PackedStream();
        group(SCHEMA, schemaRecords, summary, all, groups);
        group(CHANNEL, channelRecords, summary, all, groups);
        group(STATISTICS, List.of(statistics()), summary, all, groups);
        group(CHUNK_INDEX, chunkRecords, summary, all, groups);
        long groupsFrom = summary + all.size();
        all.append(groups.toBytes());
        PackedStream footer = new PackedStream().number(summary, 8).number(groupsFrom, 8);
        CRC32 crc = new CRC32();
        crc.update(all.toBytes());
        crc.update(FOOTER);
        crc.update(new PackedStream().number(footer.size() + 4L, 8).toBytes());
        crc.update(footer.toBytes());
        plain(all.toBytes());
        plain(record(FOOTER, footer.number(crc.getValue(), 4)));
        plain(MAGIC);
    }

    private static void group(int opcode, List<byte[]> records, long summary, PackedStream all, PackedStream groups) {
        if (records.isEmpty()) {
            return;
        }
        long from = summary + all.size();
        records.forEach(all::append);
        groups.append(record(
                SUMMARY_OFFSET,
                new PackedStream().number(opcode, 1).number(from, 8).number(summary + all.size() - from, 8)));
    }

    private byte[] statistics() {
        PackedStream counts = new PackedStream();
        channels.values().forEach(each -> counts.number(each.id, 2).number(each.messages, 8));
        return record(
                STATISTICS,
                new PackedStream()
                        .number(messages, 8)
                        .number(schemas.size(), 2)
                        .number(channels.size(), 4)
                        .number(0, 4) // attachments
                        .number(0, 4) // metadata
                        .number(chunkRecords.size(), 4)
                        .number(first, 8)
                        .number(last, 8)
                        .number(counts.size(), 4)
                        .append(counts.toBytes()));
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

    /** A record: its kind, its length and its content. */
    private static byte[] record(int opcode, PackedStream content) {
        return new PackedStream()
                .number(opcode, 1)
                .number(content.size(), 8)
                .append(content.toBytes())
                .toBytes();
    }
}
