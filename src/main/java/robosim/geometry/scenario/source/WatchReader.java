package robosim.geometry.scenario.source;

import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.net.watch.WatchClient;
import robosim.geometry.net.watch.WatchServer;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.Step;

/**
 * Reads a live session from a {@link WatchServer}, to which it sends nothing. If the server is
 * gone, or has disconnected this reader because it was too slow, the reader dials again after a second, until it is
 * closed; the conversation then goes on with a new header and the world as it is by then. If the server repeatedly
 * hangs up without sending a step, the pause doubles each time, up to a minute.
 */
public final class WatchReader implements StepReader {
    private static final long PAUSE_MILLIS = 1000;
    private static final long LONGEST_PAUSE_MILLIS = 60_000;

    private final String host;
    private final int port;
    private final CountDownLatch closed = new CountDownLatch(1);

    private volatile ScenarioReader reader;
    private volatile String state = "";

    /** The pause before dialling next, milliseconds. */
    private long pause = PAUSE_MILLIS;

    private WatchReader(String host, int port, ScenarioReader reader) {
        this.host = host;
        this.port = port;
        this.reader = reader;
    }

    /**
     * Dials.
     *
     * @throws IOException if the server cannot be reached, or does not send a scenario
     */
    public static WatchReader dial(String host, int port) throws IOException {
        return new WatchReader(Checks.present("host", host), port, connect(host, port));
    }

    private static ScenarioReader connect(String host, int port) throws IOException {
        return begin(WatchClient.dial(host, port), host + ":" + port);
    }

    /** Reads the beginning of a scenario; hangs up if it is not one. */
    public static ScenarioReader begin(InputStream dialled, String source) throws IOException {
        Checks.present("dialled", dialled);
        Checks.present("source", source);
        try {
            PushbackInputStream in = new PushbackInputStream(dialled);
            int first = in.read();
            if (first < 0) {
                throw new IOException(source + " hung up at once; perhaps " + WatchServer.MOST_WATCHERS
                        + " are watching already, which is the maximum, or it is shutting down");
            }
            in.unread(first);
            return ScenarioReader.of(in, source);
        } catch (IOException | RuntimeException e) {
            dialled.close();
            throw e;
        }
    }

    /** The header of the server that was dialled last; after a reconnection it may change before the next step. */
    @Override
    public ScenarioHeader header() {
        return reader.header();
    }

    /** What is wrong with the connection, as text for people; empty if nothing is. */
    public String state() {
        return state;
    }

    /** Waits for the next step; returns null when this is closed. */
    @Override
    public @Nullable Step next() {
        while (closed.getCount() > 0) {
            String why;
            try {
                Step step = reader.next();
                if (step != null) {
                    state = "";
                    pause = PAUSE_MILLIS;
                    return step;
                }
                List<String> last = reader.lastNotes();
                why = "the server has hung up" + (last.isEmpty() ? "" : ": " + last.get(last.size() - 1));
            } catch (IOException e) {
                why = String.valueOf(e.getMessage());
            }
            again(why);
        }
        return null;
    }

    /** Dials until a server answers or this is closed. */
    private void again(String problem) {
        String why = problem;
        while (!rest(why)) {
            long longer = Math.min(LONGEST_PAUSE_MILLIS, 2 * pause);
            try {
                reader.close();
                pause = PAUSE_MILLIS; // if there is no server
                InputStream dialled = WatchClient.dial(host, port);
                pause = longer; // if there is one, but it sends no step
                reader = begin(dialled, host + ":" + port);
                state = "";
                if (closed.getCount() == 0) {
                    reader.close(); // this was closed meanwhile
                }
                return;
            } catch (IOException e) {
                why = String.valueOf(e.getMessage());
            }
        }
    }

    /** Waits before dialling; returns whether this is closed. */
    private boolean rest(String why) {
        state = why + "; dialling again" + (pause > PAUSE_MILLIS ? " in " + pause / 1000 + " s" : "");
        try {
            return closed.await(pause, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            closed.countDown();
            Thread.currentThread().interrupt();
            return true;
        }
    }

    @Override
    public void close() throws IOException {
        closed.countDown();
        reader.close();
    }
}
