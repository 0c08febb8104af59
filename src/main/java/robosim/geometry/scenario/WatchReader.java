package robosim.geometry.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.net.WatchClient;
import robosim.geometry.net.WatchServer;

/**
 * Reads a session as it is held, from a {@link robosim.geometry.net.WatchServer}, to which nothing is ever sent. When the
 * server is gone, or has let this reader go because it was too slow, it is dialled again after a second, until this is
 * closed; it then begins with the world as it stands by then, and with a header of its own. A server that hangs up again
 * and again without telling a step is dialled after twice as long each time, up to a minute.
 */
public final class WatchReader implements StepReader {
    private static final long PAUSE_MILLIS = 1000;
    private static final long LONGEST_PAUSE_MILLIS = 60_000;

    private final String host;
    private final int port;
    private final CountDownLatch closed = new CountDownLatch(1);

    private volatile ScenarioReader reader;
    private volatile String state = "";

    /** Before dialling next. */
    private long pause = PAUSE_MILLIS;

    private WatchReader(String host, int port, ScenarioReader reader) {
        this.host = host;
        this.port = port;
        this.reader = reader;
    }

    /**
     * Dials.
     *
     * @throws IOException where nobody listens there, or what is told there is no scenario
     */
    public static WatchReader dial(String host, int port) throws IOException {
        return new WatchReader(Checks.present("host", host), port, connect(host, port));
    }

    private static ScenarioReader connect(String host, int port) throws IOException {
        return begin(WatchClient.dial(host, port), host + ":" + port);
    }

    /** Hangs up where that is no scenario. */
    static ScenarioReader begin(InputStream dialled, String source) throws IOException {
        try {
            PushbackInputStream in = new PushbackInputStream(dialled);
            int first = in.read();
            if (first < 0) {
                throw new IOException(source + " hung up at once; perhaps " + WatchServer.MOST_WATCHERS
                        + " watch already, which is the most, or it is ending");
            }
            in.unread(first);
            return ScenarioReader.of(in, source);
        } catch (IOException | RuntimeException e) {
            dialled.close();
            throw e;
        }
    }

    /** That of the server that was dialled last; another one may come with another server, before its first step. */
    @Override
    public ScenarioHeader header() {
        return reader.header();
    }

    /** What is wrong with the connection, for people; empty where nothing is. */
    public String state() {
        return state;
    }

    /** Waits for the next step; null when this is closed. */
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

    /** Dials until somebody is there or this is closed. */
    private void again(String problem) {
        String why = problem;
        while (!rest(why)) {
            long longer = Math.min(LONGEST_PAUSE_MILLIS, 2 * pause);
            try {
                reader.close();
                pause = PAUSE_MILLIS; // where nobody listens
                InputStream dialled = WatchClient.dial(host, port);
                pause = longer; // where somebody does, and tells no step
                reader = begin(dialled, host + ":" + port);
                state = "";
                if (closed.getCount() == 0) {
                    reader.close(); // it was closed meanwhile
                }
                return;
            } catch (IOException e) {
                why = String.valueOf(e.getMessage());
            }
        }
    }

    /** Waits before dialling; answers whether this is closed. */
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
