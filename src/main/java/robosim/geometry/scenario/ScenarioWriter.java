package robosim.geometry.scenario;

import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.protocol.json.JsonRecord;
import robosim.geometry.scenario.recording.Checksums;
import robosim.geometry.scenario.recording.RecordingFile;

/**
 * Writes a scenario as it happens: each call writes whole lines with one write to the stream and flushes it. Everything
 * written can be read again; anything that could not be is refused.
 *
 * <p>A {@linkplain #recording recording} has a checksum in each line and a line that marks its end, so that a reader notices
 * what was altered or is missing. What is written to be edited has neither.
 */
public final class ScenarioWriter implements Closeable {
    private final OutputStream out;
    private final long mostBytes;
    private final @Nullable Checksums sums;
    private long bytes;
    private long requests;

    /** Whether the last line is incomplete. */
    private boolean torn;

    /** Writes the header of a scenario without checksums. */
    public ScenarioWriter(OutputStream out, ScenarioHeader header) throws IOException {
        this(out, header, Long.MAX_VALUE);
    }

    /**
     * Writes the header of a scenario without checksums.
     *
     * @param mostBytes maximum size of the file; a call that would exceed it throws an IOException and writes nothing
     */
    public ScenarioWriter(OutputStream out, ScenarioHeader header, long mostBytes) throws IOException {
        this(out, header, mostBytes, null);
    }

    /**
     * Writes the header of a recording, with a checksum in each line.
     *
     * @param mostBytes maximum size of the file; a call that would exceed it throws an IOException and writes nothing
     */
    public static ScenarioWriter recording(OutputStream out, ScenarioHeader header, long mostBytes) throws IOException {
        return new ScenarioWriter(out, header, mostBytes, new Checksums());
    }

    private ScenarioWriter(OutputStream out, ScenarioHeader header, long mostBytes, @Nullable Checksums sums)
            throws IOException {
        this.out = Checks.present("out", out);
        this.mostBytes = mostBytes;
        this.sums = sums;
        String line = Checks.present("header", header).line();
        JsonRecord.read(line);
        put(line);
    }

    /** Writes a note for people, which belongs to the next request. */
    public void note(String text) throws IOException {
        String line = JsonRecord.line("type", "note", "text", Checks.present("text", text));
        JsonRecord.read(line);
        put(line);
    }

    /** Writes a request; its answer, if it has one, must be written next. */
    public void request(Bundle request) throws IOException {
        String line = JsonLines.write(request);
        if (request instanceof InitBundle || isOdd(line)) {
            JsonLines.readRequest(line);
        }
        put(line);
        requests++;
    }

    /** Marks the end of a recording, after which nothing may be written; without checksums there is no such mark. */
    public void end() throws IOException {
        if (sums != null) {
            put(JsonRecord.line("type", "end", "requests", requests));
        }
    }

    /** Writes the answer to the last request, null after an init, and its timing, null if not recorded. */
    public void answer(@Nullable Reply reply, @Nullable Timing timing) throws IOException {
        List<String> lines = new ArrayList<>();
        if (reply != null) {
            String line = JsonLines.write(reply);
            if (isOdd(line)) {
                JsonLines.readReply(line);
            }
            lines.add(line);
        }
        if (timing != null) {
            lines.add(JsonRecord.line("type", "time", "at", timing.at(), "took", timing.took()));
        }
        if (!lines.isEmpty()) {
            put(lines.toArray(String[]::new));
        }
    }

    /**
     * Whether a line contains an unpaired surrogate, escaped: names in Java serialization may, but JSON lines refuse
     * them.
     */
    private static boolean isOdd(String line) {
        return line.contains("\\ud");
    }

    /** Writes a step with its notes. */
    public void write(Step step) throws IOException {
        for (String note : Checks.present("step", step).notes()) {
            note(note);
        }
        request(step.request());
        answer(step.expected(), step.timing());
    }

    /** The number of bytes written. */
    public long bytes() {
        return bytes;
    }

    private void put(String... lines) throws IOException {
        String before = sums == null ? "" : sums.state();
        try {
            write(lines);
        } catch (IOException e) {
            if (sums != null) {
                sums.restore(before);
            }
            throw e;
        }
    }

    private void write(String... lines) throws IOException {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        for (String line : lines) {
            byte[] encoded = line.getBytes(StandardCharsets.UTF_8);
            if (encoded.length > MessageLimits.MAX_MESSAGE_BYTES) {
                throw new IOException("a line must have at most " + MessageLimits.MAX_MESSAGE_BYTES + " bytes (got: "
                        + encoded.length + ")");
            }
            text.writeBytes(sums == null ? encoded : sums.seal(line).getBytes(StandardCharsets.UTF_8));
            text.write('\n');
        }
        if (text.size() > mostBytes - bytes) {
            throw new IOException("a recording must have at most " + mostBytes + " bytes (got: more)");
        }
        try {
            out.write(text.toByteArray());
            out.flush();
        } catch (IOException e) {
            torn = !cutBack(e);
            throw e;
        }
        bytes += text.size();
    }

    /** Removes the remains of lines that could not be written completely, if possible. */
    private boolean cutBack(IOException cause) {
        if (out instanceof RecordingFile file) {
            try {
                file.cutTo(bytes);
                return true;
            } catch (IOException e) {
                cause.addSuppressed(e);
            }
        }
        return false;
    }

    /** Writes a last note on why nothing more is written, if there is room and no line is incomplete. */
    void giveUp(String reason) throws IOException {
        if (!torn) {
            note("recorded no further: " + reason);
        }
    }

    @Override
    public void close() throws IOException {
        out.close();
    }
}
