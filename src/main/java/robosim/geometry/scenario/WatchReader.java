package robosim.geometry.scenario;

import java.io.IOException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import robosim.geometry.net.WatchClient;

/**
 * Reads a session as it is held, from a {@link robosim.geometry.net.WatchServer}, to which nothing is ever sent. When the
 * server is gone, or has let this reader go because it was too slow, it is dialled again each second until this is closed;
 * it then begins with the world as it stands by then.
 */
public final class WatchReader implements StepReader {
    private static final long PAUSE_MILLIS = 1000;

    private final String host;
    private final int port;
    private final ScenarioHeader header;
    private final CountDownLatch closed = new CountDownLatch(1);

    private volatile ScenarioReader reader;
    private volatile String state = "";

    private WatchReader(String host, int port, ScenarioReader reader) {
        this.host = host;
        this.port = port;
        this.reader = reader;
        this.header = reader.header();
    }

    /**
     * Dials.
     *
     * @throws IOException where nobody listens there, or what is told there is no scenario
     */
    public static WatchReader dial(String host, int port) throws IOException {
        return new WatchReader(host, port, connect(host, port));
    }

    private static ScenarioReader connect(String host, int port) throws IOException {
        return ScenarioReader.of(WatchClient.dial(host, port), host + ":" + port);
    }

    @Override
    public ScenarioHeader header() {
        return header;
    }

    /** What is wrong with the connection, for people; empty where nothing is. */
    public String state() {
        return state;
    }

    /** Waits for the next step; null when this is closed. */
    @Override
    public @Nullable Step next() {
        while (closed.getCount() > 0) {
            try {
                Step step = reader.next();
                if (step != null) {
                    state = "";
                    return step;
                }
                state = "the server has hung up; dialling again";
            } catch (IOException e) {
                state = e.getMessage() + "; dialling again";
            }
            again();
        }
        return null;
    }

    private void again() {
        try {
            reader.close();
            if (!closed.await(PAUSE_MILLIS, TimeUnit.MILLISECONDS)) {
                reader = connect(host, port);
                if (closed.getCount() == 0) {
                    reader.close(); // it was closed meanwhile
                }
            }
        } catch (IOException e) {
            state = e.getMessage() + "; dialling again";
        } catch (InterruptedException e) {
            closed.countDown();
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() throws IOException {
        closed.countDown();
        reader.close();
    }
}
