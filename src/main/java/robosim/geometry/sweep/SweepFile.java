package robosim.geometry.sweep;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.json.JsonRecord;
import robosim.geometry.sweep.lines.ChecksummedLine;

/**
 * Reads a file of results once, line by line. An incomplete last line, as a killed writer leaves it, is skipped: one
 * without a line feed, and if it is the first line, only if such a file begins like it. Anything else is refused, and
 * the file left as it is.
 */
final class SweepFile {
    /** Maximum length of an outcome's line, bytes. */
    private static final int MOST_BYTES = 1 << 24;

    private static final String HEADER = "{\"type\":\"sweep\",";

    private final Path file;
    private final String beginning;
    private @Nullable SweepHeader header;
    private long end;
    private long torn;

    /** Receives an outcome and the position of its line. */
    @FunctionalInterface
    interface Reader {
        void read(Outcome outcome, long offset, int length) throws IOException;
    }

    private SweepFile(Path file, String beginning) {
        this.file = file;
        this.beginning = beginning;
    }

    /** Reads a file of results of any sweep. */
    static SweepFile read(Path file, Reader reader) throws IOException {
        return read(file, HEADER, reader);
    }

    /** Reads a file that a run of a sweep is to continue. */
    static SweepFile read(Path file, SweepHeader own, Reader reader) throws IOException {
        return read(file, own.sealed(), reader);
    }

    private static SweepFile read(Path file, String beginning, Reader reader) throws IOException {
        SweepFile read = new SweepFile(file, beginning);
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file), 1 << 16)) {
            read.read(in, reader);
        } catch (NoSuchFileException e) {
            throw new SweepException(file + ": there is no such file; check the path", e);
        }
        return read;
    }

    /** The header of the results; null if the file has only an incomplete line. */
    @Nullable
    SweepHeader header() {
        return header;
    }

    /** The position at which the last complete line ends. */
    long end() {
        return end;
    }

    /** The number of the last line if it is incomplete; 0 otherwise. */
    long torn() {
        return torn;
    }

    private void read(InputStream in, Reader reader) throws IOException {
        long number = 0;
        for (byte[] line = line(in); line != null; line = line(in)) {
            number++;
            if (isTorn(line, number)) {
                torn = number;
                return;
            }
            boolean isEnded = line[line.length - 1] == '\n';
            String open =
                    isEnded ? ChecksummedLine.open(new String(line, 0, line.length - 1, StandardCharsets.UTF_8)) : null;
            if (open == null) {
                throw new SweepException(
                        file + " line " + number + ": it must be as it was written, with its check sum; "
                                + (number == 1 ? "name a file of results" : "restore the file or remove the line"));
            }
            try {
                if (number == 1 || open.startsWith(HEADER)) {
                    header = header(open, header);
                } else {
                    Outcome outcome = Outcome.of(open);
                    if (header != null) {
                        header.check(outcome);
                    }
                    reader.read(outcome, end, line.length);
                }
            } catch (ProtocolException | IllegalArgumentException e) {
                throw new SweepException(file + " line " + number + ": " + e.getMessage(), e);
            }
            end += line.length;
        }
    }

    private boolean isTorn(byte[] line, long number) {
        if (line[line.length - 1] == '\n') {
            return false;
        }
        // One char per byte, since the line may end within a character.
        String text = new String(line, StandardCharsets.ISO_8859_1);
        String whole = new String(beginning.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
        // If the sweep is not known, the line may continue after what all headers have in common.
        return number > 1 || whole.startsWith(text) || (beginning.equals(HEADER) && text.startsWith(HEADER));
    }

    /** Reads the first line, or the header that a continuing run with more replicates began with. */
    private static SweepHeader header(String line, @Nullable SweepHeader before) throws ProtocolException {
        JsonRecord record = JsonRecord.read(line);
        if (!record.has("type") || !record.text("type").equals("sweep")) {
            throw record.refused("a file of results must begin with its header, of type sweep (got: another line)");
        }
        SweepHeader header = SweepHeader.of(record);
        if (before != null && !header.isOfSame(before)) {
            throw record.refused(
                    "a file must hold the results of one sweep (got: one with " + header.differences(before) + ")");
        }
        return before == null || header.replicates() > before.replicates() ? header : before;
    }

    /** The next line with its line feed, or without one if it is incomplete; null at the end. */
    private byte @Nullable [] line(InputStream in) throws IOException {
        ByteArrayOutputStream line = new ByteArrayOutputStream(512);
        for (int next = in.read(); next >= 0; next = in.read()) {
            line.write(next);
            if (next == '\n') {
                break;
            }
            if (line.size() > MOST_BYTES) {
                throw new SweepException(file + ": a line must have at most " + MOST_BYTES + " bytes (got: more)");
            }
        }
        return line.size() == 0 ? null : line.toByteArray();
    }
}
