package robosim.geometry.sweep;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.json.JsonRecord;
import robosim.geometry.sweep.lines.ChecksummedLine;

/**
 * The outcome of one replicate.
 *
 * @param index      index of the replicate in its sweep
 * @param world      the world's name
 * @param parameters the values, by name
 * @param replicate  number of the replicate in its cell, from 0
 * @param seed       seed of its own random stream
 * @param values     its results; empty if it failed
 * @param error      why it failed, the first 2,000 characters; null if it did not fail
 */
public record Outcome(
        long index,
        String world,
        Map<String, String> parameters,
        long replicate,
        long seed,
        Map<String, Double> values,
        @Nullable String error) {
    private static final long MOST = 1L << 53;

    /**
     * Maximum length of an error in characters; at up to 6 bytes each it is far below the maximum of a string in a
     * line.
     */
    private static final int MOST_OF_AN_ERROR = 2_000;

    static Outcome of(
            long index, String world, SortedMap<String, String> parameters, long replicate, long seed, Result result) {
        return new Outcome(index, world, parameters, replicate, seed, result.values(), null);
    }

    static Outcome failed(
            long index,
            String world,
            SortedMap<String, String> parameters,
            long replicate,
            long seed,
            Throwable cause) {
        return new Outcome(index, world, parameters, replicate, seed, Map.of(), text(cause));
    }

    /** The text of a failure, shortened and without unpaired surrogates, so that a line can hold it. */
    private static String text(Throwable cause) {
        String text;
        try {
            text = String.valueOf(cause.toString());
        } catch (RuntimeException e) {
            text = cause.getClass().getName();
        }
        StringBuilder clean = new StringBuilder();
        text.codePoints()
                .limit(MOST_OF_AN_ERROR)
                .forEach(c -> clean.appendCodePoint(
                        c >= Character.MIN_SURROGATE && c <= Character.MAX_SURROGATE ? 0xFFFD : c));
        return text.codePointCount(0, text.length()) > MOST_OF_AN_ERROR ? clean + "..." : clean.toString();
    }

    /** Whether it failed. */
    public boolean isFailed() {
        return error != null;
    }

    /** The outcome as a line of JSON, without a checksum. */
    public String line() {
        return JsonRecord.line(
                "type",
                isFailed() ? "failure" : "result",
                "index",
                index,
                "world",
                world,
                "parameters",
                parameters,
                "replicate",
                replicate,
                "seed",
                hex(seed),
                isFailed() ? "error" : "values",
                isFailed() ? error : values);
    }

    /** The line of a file, with its checksum. */
    public String sealed() {
        return ChecksummedLine.seal(line());
    }

    /**
     * Reads a line without a checksum.
     *
     * @throws ProtocolException if it is not an outcome
     */
    public static Outcome of(String line) throws ProtocolException {
        Checks.present("line", line);
        JsonRecord record = JsonRecord.read(line);
        boolean isFailed = record.text("type").equals("failure");
        if (!isFailed && !record.text("type").equals("result")) {
            throw record.refused("type must be result or failure (got: " + record.text("type") + ")");
        }
        record.only("type index world parameters replicate seed " + (isFailed ? "error" : "values"), "");
        return new Outcome(
                record.whole("index", 0, MOST),
                record.text("world"),
                new TreeMap<>(SweepHeader.texts(record.record("parameters"))),
                record.whole("replicate", 0, MOST),
                unhex(record, "seed"),
                isFailed ? Map.of() : numbers(record.record("values")),
                isFailed ? record.text("error") : null);
    }

    private static Map<String, Double> numbers(JsonRecord record) throws ProtocolException {
        Map<String, Double> numbers = new LinkedHashMap<>();
        for (String name : record.names()) {
            numbers.put(name, record.isNull(name) ? Double.POSITIVE_INFINITY : record.number(name));
        }
        return numbers;
    }

    static String hex(long number) {
        return String.format("0x%016x", number);
    }

    static long unhex(JsonRecord record, String field) throws ProtocolException {
        String text = record.text(field);
        if (!text.matches("0x[0-9a-f]{16}")) {
            throw record.refused(field + " must be 0x and 16 hexadecimal digits (got: " + text + ")");
        }
        return Long.parseUnsignedLong(text.substring(2), 16);
    }
}
