package robosim.geometry.scenario;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.NumberText;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.protocol.json.JsonRecord;
import robosim.geometry.scenario.recording.Checksums;

/**
 * Reads a scenario step by step, so that a day's recording takes no more memory than its longest lines. Reading is
 * strict; every exception names file and line. Only an incomplete last line, as a killed writer leaves it, is skipped,
 * and {@link #torn()} reports it. Of a recording with checksums {@link #problems()} reports at the end what was altered or is
 * missing.
 */
public final class ScenarioReader implements Closeable {
    /** The ending of the names of scenario files. */
    public static final String ENDING = ".scenario.jsonl";

    private final Lines lines;
    private final WorldFiles worlds;
    private final ScenarioHeader header;

    /** The next line that is not a note, and its type; both null if it has not been read, or there is none. */
    private @Nullable String ahead;

    private String type = "";

    private final List<String> notes = new ArrayList<>();

    private final Checksums sums = new Checksums();

    /** Whether the header has a checksum, and so must each line. */
    private boolean isRecording;

    /** The number of lines whose checksum is wrong, and the first of them. */
    private long altered;

    private long firstAltered;

    private long requests;

    /** The number of requests at the end mark; -1 if that has not been read. */
    private long ended = -1;

    private ScenarioReader(InputStream in, String source, WorldFiles worlds) throws ScenarioException {
        this.lines = new Lines(in, source);
        this.worlds = worlds;
        this.header = begin();
    }

    /**
     * Opens a file. The worlds that it names are looked up relative to its folder, and must be within that folder's
     * parent.
     *
     * @throws ScenarioException if it cannot be opened, or does not begin as a scenario
     */
    public static ScenarioReader open(Path file) throws IOException {
        Path folder = Checks.present("file", file).toAbsolutePath().normalize().getParent();
        Path above = folder == null ? null : folder.getParent();
        return open(file, above != null ? above : file.toAbsolutePath().getRoot());
    }

    /**
     * Opens a file.
     *
     * @param root worlds that the file names are read from within this folder only
     * @throws ScenarioException if it cannot be opened, or does not begin as a scenario
     */
    public static ScenarioReader open(Path file, Path root) throws IOException {
        Checks.present("root", root);
        InputStream in;
        try {
            in = Files.newInputStream(Checks.present("file", file));
        } catch (NoSuchFileException e) {
            throw new ScenarioException(file.toString(), 0, "there is no such file; check the path", e);
        } catch (IOException e) {
            throw new ScenarioException(file.toString(), 0, "the file could not be opened: " + e, e);
        }
        try {
            return new ScenarioReader(in, file.toString(), WorldFiles.beside(file, root));
        } catch (ScenarioException e) {
            in.close();
            throw e;
        }
    }

    /**
     * Reads from a stream, which cannot refer to world files.
     *
     * @param source the name of the stream in messages
     * @throws ScenarioException if it does not begin as a scenario
     */
    public static ScenarioReader of(InputStream in, String source) throws ScenarioException {
        return new ScenarioReader(Checks.present("in", in), Checks.present("source", source), WorldFiles.none());
    }

    /** The header of the conversation. */
    public ScenarioHeader header() {
        return header;
    }

    /**
     * Reads the next step.
     *
     * @return null at the end
     * @throws ScenarioException if reading fails or the file is not a scenario; then nothing more can be read
     */
    public @Nullable Step next() throws ScenarioException {
        String line = peek();
        if (line == null) {
            return null;
        }
        long number = lines.number();
        List<String> before = List.copyOf(notes);
        notes.clear();
        Bundle request = guarded(() -> request(line));
        requests++;
        ahead = null;
        Reply expected = answer(request);
        Timing timing = timing();
        return new Step(number, before, request, expected, timing);
    }

    /** The number of the last line if it was incomplete and skipped; 0 otherwise. Known at the end. */
    public long torn() {
        return lines.torn();
    }

    /** Whether lines have checksums, as recorders write them. */
    public boolean isRecording() {
        return isRecording;
    }

    /** The number of lines that are not as they were recorded; 0 if there are no checksums. Known at the end. */
    public long altered() {
        return altered;
    }

    /** Whether there is nothing more that a recorder has written; true if there are no checksums. Known at the end. */
    public boolean isComplete() {
        return torn() == 0 && (!isRecording || ended >= 0);
    }

    /** Whether there are other requests than the end of the recording says. Known at the end. */
    public boolean hasOtherCount() {
        return ended >= 0 && ended != requests;
    }

    /** What is wrong with a recording, one sentence each for people: what was altered, and what is missing. Known at the end. */
    public List<String> problems() {
        List<String> problems = new ArrayList<>();
        if (altered > 0) {
            problems.add("line " + firstAltered + " is not as it was recorded, or lines before it are missing"
                    + (altered == 1 ? "" : "; the same of " + NumberText.count(altered - 1, "more line"))
                    + "; its checksum is another");
        }
        if (torn() > 0) {
            problems.add(
                    "line " + torn() + " is incomplete, as after a killed recorder or a full disk; it was skipped");
        } else if (isRecording && ended < 0) {
            problems.add("the end of the recording is missing: its recorder was killed or stopped"
                    + (notes.isEmpty() ? "" : " (" + notes.get(notes.size() - 1) + ")")
                    + ", or the file was cut off");
        } else if (hasOtherCount()) {
            problems.add("there must be " + NumberText.count(ended, "request") + ", as its end says (got: " + requests
                    + ")");
        }
        return problems;
    }

    /** The notes after the last step. Known at the end. */
    public List<String> lastNotes() {
        return List.copyOf(notes);
    }

    private ScenarioHeader begin() throws ScenarioException {
        String first = peek();
        if (first == null || !notes.isEmpty() || !type.equals("scenario")) {
            throw lines.refused(
                    "a scenario must begin with its header, as in {\"type\":\"scenario\",\"version\":"
                            + ScenarioHeader.VERSION + ",\"title\":\"...\"} (got: "
                            + (first == null ? "no whole line" : "another line") + ")",
                    null);
        }
        ScenarioHeader begun = guarded(() -> ScenarioHeader.of(JsonRecord.read(first)));
        ahead = null;
        return begun;
    }

    private @Nullable String peek() throws ScenarioException {
        while (ahead == null) {
            String whole = lines.next();
            if (whole == null) {
                return null;
            }
            String line = checked(whole);
            if (line.startsWith("<")) {
                throw lines.refused(
                        "this is XML and no recording; a world file is for check, render and drive (got: <...>)", null);
            }
            type = guarded(() -> JsonLines.typeOf(line));
            if (ended >= 0) {
                throw lines.refused(
                        "nothing may follow the end of a recording (got: a line of type " + type + ")", null);
            }
            if (type.equals("end")) {
                ended = guarded(
                        () -> JsonRecord.read(line).only("type requests", "").whole("requests", 0, Timing.MOST));
            } else if (type.equals("note")) {
                notes.add(guarded(
                        () -> JsonRecord.read(line).only("type text", "").text("text")));
            } else {
                ahead = line;
            }
        }
        return ahead;
    }

    /** Compares the checksum of a line, if the first line has one; returns the line without it. */
    private String checked(String line) {
        isRecording |= lines.number() == 1 && Checksums.isSealed(line);
        if (!isRecording) {
            return line;
        }
        if (!sums.isRight(line)) {
            altered++;
            firstAltered = firstAltered == 0 ? lines.number() : firstAltered;
        }
        return Checksums.isSealed(line) ? Checksums.open(line) : line;
    }

    private Bundle request(String line) throws IOException {
        switch (type) {
            case "world" -> {
                return worlds.read(JsonRecord.read(line).only("type file", "").text("file"));
            }
            case "scenario" -> throw new ProtocolException("a header must come once, as the first line (got: another)");
            case "time" -> throw new ProtocolException("a time must follow a request or its answer (got: another)");
            default -> {
                if (JsonLines.isReply(line)) {
                    throw new ProtocolException("an answer must follow its request (got: one without)");
                }
                return JsonLines.readRequest(line);
            }
        }
    }

    /** The answer that follows a request; null if there is none. */
    private @Nullable Reply answer(Bundle request) throws ScenarioException {
        String line = peek();
        if (line == null || !guarded(() -> JsonLines.isReply(line))) {
            return null;
        }
        Reply answer = guarded(() -> {
            Reply reply = JsonLines.readReply(line);
            Step.checkAnswer(request, reply.bundle());
            return reply;
        });
        ahead = null;
        return answer;
    }

    private @Nullable Timing timing() throws ScenarioException {
        String line = peek();
        if (line == null || !type.equals("time")) {
            return null;
        }
        Timing timing = guarded(() -> {
            JsonRecord time = JsonRecord.read(line).only("type at took", "");
            return new Timing(time.whole("at", 0, Timing.MOST), time.whole("took", 0, Timing.MOST));
        });
        ahead = null;
        return timing;
    }

    @FunctionalInterface
    private interface Reading<T> {
        T read() throws IOException;
    }

    /** Reads, and reports any error with its file and line. */
    private <T> T guarded(Reading<T> reading) throws ScenarioException {
        try {
            return reading.read();
        } catch (IOException | IllegalArgumentException e) {
            throw lines.refused(String.valueOf(e.getMessage()), e);
        } catch (NoClassDefFoundError e) {
            throw lines.refused(
                    "scenarios need Jackson: put com.fasterxml.jackson.core:jackson-core on the class path, or on the"
                            + " module path with --add-modules com.fasterxml.jackson.core (missing: " + e.getMessage()
                            + ")",
                    e);
        }
    }

    @Override
    public void close() throws IOException {
        lines.close();
    }
}
