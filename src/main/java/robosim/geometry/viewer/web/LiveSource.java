package robosim.geometry.viewer.web;

import java.io.IOException;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.net.pace.CpuTurns;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.Step;
import robosim.geometry.scenario.Watching;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.scenario.source.WatchReader;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.Replayer;

/**
 * Reads a running session into a film, on a thread of its own, while there is a page that shows it. That thread has a budget: it
 * computes for at most a quarter of the time, whatever it has to do. Where that is too little, it loses the session, and finds
 * it again as it is by then.
 */
public final class LiveSource implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(LiveSource.class.getPackageName());

    /** Nanoseconds of rest for each nanosecond of computing. */
    private static final int REST = 3;

    private static final long LEAST_REST_NANOS = 2_000_000;

    /** One world may take long to read; then the pages are as late as it took, and not three times as late. */
    private static final long MOST_REST_NANOS = 1_000_000_000;

    /** How long the session is followed without a page, so that one that is loaded again finds it. */
    private static final long ALONE_SECONDS = 10;

    private static final long PAUSE_MILLIS = 1000;

    /** How late a page may be where a session is faster than its budget; then it begins anew with the present world. */
    private static final long MOST_LATE_NANOS = 1_000_000_000;

    private final LiveFilm film;
    private final Opening opening;
    private final Colours colours;
    private final Consumer<String> onConnection;
    private final Thread thread;
    private volatile @Nullable StepReader reader;
    private volatile boolean closed;

    /** How a session is reached. */
    @FunctionalInterface
    public interface Opening {
        /** Reaches it. */
        StepReader open() throws IOException;
    }

    /**
     * Begins to read.
     *
     * @param colours      of a world file's objects
     * @param onConnection is given the name of the connection that is followed, where a session begins
     */
    public LiveSource(LiveFilm film, Opening opening, Colours colours, Consumer<String> onConnection) {
        this.film = Checks.present("film", film);
        this.opening = Checks.present("opening", opening);
        this.colours = Checks.present("colours", colours);
        this.onConnection = Checks.present("onConnection", onConnection);
        thread = new Thread(this::run, "viewer-source");
        thread.setDaemon(true);
        thread.start();
    }

    private void run() {
        try {
            while (!closed) {
                film.awaitViewer();
                boolean isLate = false;
                try (StepReader opened = opening.open()) {
                    reader = opened;
                    film.tells(opened instanceof WatchReader dialled ? dialled::state : () -> "");
                    isLate = follow(opened);
                } catch (IOException | RuntimeException e) {
                    if (!closed) {
                        String why = String.valueOf(e.getMessage());
                        film.tells(() -> why);
                    }
                }
                if (!closed && !isLate) {
                    Thread.sleep(PAUSE_MILLIS);
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt(); // closed
        }
    }

    /** Reads until the session is over, or there has been no page for a while, or it falls behind; returns whether it does. */
    private boolean follow(StepReader opened) throws IOException, InterruptedException {
        LongSupplier cpu = CpuTurns.ofThread();
        ScenarioHeader header = opened.header();
        Replayer stage = new Replayer(header.options(), colours);
        long rested = cpu.getAsLong();
        long earliest = Long.MAX_VALUE;
        long most = 0;
        for (Step step = opened.next(); step != null && film.isWatched(ALONE_SECONDS); step = opened.next()) {
            if (!header.equals(opened.header())) { // another server, with other defaults
                header = opened.header();
                stage = new Replayer(header.options(), colours);
            }
            String connection = Watching.connection(step.notes());
            if (connection != null) {
                onConnection.accept(connection);
            }
            long now = System.nanoTime();
            long late = step.timing() == null ? 0 : now - step.timing().at();
            earliest = Math.min(earliest, late);
            if (most > 0 && late - earliest > most) {
                return true;
            }
            film.add(stage.play(step));
            // The world itself may take longer to read than what happens in it may be late.
            most = most > 0 ? most : MOST_LATE_NANOS + 2 * (System.nanoTime() - now);
            long rest = (cpu.getAsLong() - rested) * REST;
            if (rest > LEAST_REST_NANOS) {
                Thread.sleep(Math.min(rest, MOST_REST_NANOS) / 1_000_000);
                rested = cpu.getAsLong();
            }
        }
        return false;
    }

    @Override
    public void close() {
        closed = true;
        thread.interrupt();
        StepReader open = reader;
        if (open != null) {
            try {
                open.close();
            } catch (IOException e) {
                LOG.log(System.Logger.Level.DEBUG, "what was viewed could not be closed", e);
            }
        }
    }
}
