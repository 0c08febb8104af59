package robosim.geometry.scenario;

import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.Limits;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.protocol.json.JsonRecord;

/**
 * Writes a scenario as it happens: each call writes whole lines with one write to the stream and flushes it. What has been
 * written can be read again; what could not be is refused.
 */
public final class ScenarioWriter implements Closeable {
    private final OutputStream out;
    private final long mostBytes;
    private long bytes;

    /** Whether the last line breaks off. */
    private boolean torn;

    /** Writes the header. */
    public ScenarioWriter(OutputStream out, ScenarioHeader header) throws IOException {
        this(out, header, Long.MAX_VALUE);
    }

    /**
     * Writes the header.
     *
     * @param mostBytes of the file; a call that would write beyond that throws an IOException and writes nothing
     */
    public ScenarioWriter(OutputStream out, ScenarioHeader header, long mostBytes) throws IOException {
        this.out = Checks.present("out", out);
        this.mostBytes = mostBytes;
        String line = Checks.present("header", header).line();
        JsonRecord.read(line);
        put(line);
    }

    /** Something for people; reads as a note before the next request. */
    public void note(String text) throws IOException {
        Map<String, String> note = new LinkedHashMap<>();
        note.put("type", "note");
        note.put("text", Checks.present("text", text));
        String line = JsonRecord.write(note);
        JsonRecord.read(line);
        put(line);
    }

    /** A request; its answer, where it has one, comes next. */
    public void request(Bundle request) throws IOException {
        String line = JsonLines.write(request);
        if (request instanceof InitBundle || isOdd(line)) {
            JsonLines.readRequest(line);
        }
        put(line);
    }

    /** What was answered to the last request, null after an init; and when, null where that is not told. */
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
            Map<String, Object> time = new LinkedHashMap<>();
            time.put("type", "time");
            time.put("at", timing.at());
            time.put("took", timing.took());
            lines.add(JsonRecord.write(time));
        }
        if (!lines.isEmpty()) {
            put(lines.toArray(String[]::new));
        }
    }

    /** A request in Java serialization may have names that JSON lines refuse: with half a surrogate pair, escaped here. */
    private static boolean isOdd(String line) {
        return line.contains("\\ud");
    }

    /** A step with its notes. */
    public void write(Step step) throws IOException {
        for (String note : Checks.present("step", step).notes()) {
            note(note);
        }
        request(step.request());
        answer(step.expected(), step.timing());
    }

    /** How many bytes have been written. */
    public long bytes() {
        return bytes;
    }

    private void put(String... lines) throws IOException {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        for (String line : lines) {
            byte[] encoded = line.getBytes(StandardCharsets.UTF_8);
            if (encoded.length > Limits.MAX_MESSAGE_BYTES) {
                throw new IOException("a line must have at most " + Limits.MAX_MESSAGE_BYTES + " bytes (got: "
                        + encoded.length + ")");
            }
            text.writeBytes(encoded);
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

    /** What is left of lines that could not be written whole is taken back, where that is possible. */
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

    /** Says, as the last thing, why nothing more is written; where there is room for that, and no line breaks off. */
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
