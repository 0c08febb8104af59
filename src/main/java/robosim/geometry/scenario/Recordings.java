package robosim.geometry.scenario;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Path;
import java.time.Clock;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import robosim.geometry.check.Checks;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.scenario.recording.RecordingFile;

/**
 * Records the sessions of a server or a client, each in a file that is created when its first request comes. Existing
 * files are never overwritten.
 *
 * <!-- java: compiled -->
 * <pre>{@code
 * NetOptions options = NetOptions.defaults();
 * options = options.withListeners(Recordings.inFolder(Path.of("recordings"), options.session()));
 * }</pre>
 */
public final class Recordings implements Function<String, SessionListener> {
    /** Default maximum size of a file in bytes: 1 GiB, some 500,000 bundles of 16 sonar requests with their answers. */
    public static final long DEFAULT_BYTES = 1L << 30;

    private static final DateTimeFormatter TIME =
            DateTimeFormatter.ofPattern("yyyyMMdd'T'HHmmss.SSS'Z'", Locale.ROOT).withZone(ZoneOffset.UTC);
    private static final int LONGEST_NAME = 80;

    private final Function<String, Path> files;
    private final SessionOptions session;
    private final long mostBytes;
    private final Clock clock;
    private final Maker maker;

    /** Creates a file that must not exist. */
    @FunctionalInterface
    interface Maker {
        OutputStream make(Path place) throws IOException;
    }

    private Recordings(Function<String, Path> files, SessionOptions session, long mostBytes, Clock clock, Maker maker) {
        this.files = files;
        this.session = Checks.present("session", session);
        this.mostBytes = mostBytes;
        this.clock = Checks.present("clock", clock);
        this.maker = maker;
    }

    /**
     * Recordings in a folder, each named by the time of its first request and the connection.
     *
     * @param session the options of the sessions
     */
    public static Recordings inFolder(Path folder, SessionOptions session) {
        Clock clock = Clock.systemUTC();
        Checks.present("folder", folder);
        return new Recordings(name -> folder.resolve(name), session, DEFAULT_BYTES, clock, RecordingFile::new);
    }

    /**
     * Recordings in a file of the given name for the first session, and files of that name with a number for later
     * ones.
     */
    public static Recordings inFile(Path file, SessionOptions session) {
        Checks.present("file", file);
        return new Recordings(name -> file, session, DEFAULT_BYTES, Clock.systemUTC(), RecordingFile::new);
    }

    /** Records one session into a stream, without times; the stream is closed at its end. */
    public static SessionListener ofSession(OutputStream out, ScenarioHeader header) {
        Checks.present("out", out);
        Checks.present("header", header);
        return new Recorder(header.title(), () -> ScenarioWriter.recording(out, header, Long.MAX_VALUE), null);
    }

    /** These recordings with another maximum size of each file, at which recording stops and the session goes on. */
    public Recordings atMost(long bytes) {
        Checks.refuse(bytes < 1, "bytes must be at least 1", bytes);
        return new Recordings(files, session, bytes, clock, maker);
    }

    /** These recordings with another clock for names and titles. */
    public Recordings by(Clock other) {
        return new Recordings(files, session, mostBytes, other, maker);
    }

    /**
     * These recordings, each of whose files is passed on once it is complete, in the thread that ends the session; for a
     * conversion to another format.
     */
    public Recordings whenClosed(Consumer<Path> done) {
        Checks.present("done", done);
        return into(place -> new RecordingFile(place) {
            @Override
            public void close() throws IOException {
                super.close();
                done.accept(place);
            }
        });
    }

    /** These recordings with files created by another maker. */
    Recordings into(Maker other) {
        return new Recordings(files, session, mostBytes, clock, other);
    }

    @Override
    public SessionListener apply(String connection) {
        Checks.present("connection", connection);
        return new Recorder(connection, () -> open(connection), System::nanoTime);
    }

    private ScenarioWriter open(String connection) throws IOException {
        String time = TIME.format(clock.instant());
        String plain = connection.replaceAll("[^A-Za-z0-9.]+", "-");
        plain = plain.substring(0, Math.min(LONGEST_NAME, plain.length()));
        Path file = files.apply(time + "-" + plain + ScenarioReader.ENDING);
        ScenarioHeader header = new ScenarioHeader(connection + ", " + time, session);
        for (int number = 1; ; number++) {
            OutputStream out;
            try {
                out = maker.make(numbered(file, number));
            } catch (FileAlreadyExistsException taken) {
                continue;
            }
            try {
                return ScenarioWriter.recording(out, header, mostBytes);
            } catch (IOException | RuntimeException | Error e) {
                out.close();
                throw e;
            }
        }
    }

    private static Path numbered(Path file, int number) {
        if (number == 1) {
            return file;
        }
        String name = String.valueOf(file.getFileName());
        int end = name.endsWith(ScenarioReader.ENDING)
                ? name.length() - ScenarioReader.ENDING.length()
                : name.lastIndexOf('.') > 0 ? name.lastIndexOf('.') : name.length();
        return file.resolveSibling(name.substring(0, end) + "-" + number + name.substring(end));
    }
}
