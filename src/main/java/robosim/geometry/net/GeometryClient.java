package robosim.geometry.net;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * Dials RoboSim's environment module and answers it until it ends the connection.
 *
 * <pre>{@code
 * new Thread(new GeometryClient("localhost", 5555)).start();
 * }</pre>
 */
public final class GeometryClient implements Runnable, AutoCloseable {
    private static final int GRACE_SECONDS = 2;

    private final String host;
    private final int port;
    private final NetOptions options;

    private final Object lock = new Object();
    private final CountDownLatch ended = new CountDownLatch(1);
    private boolean started;
    private boolean closed;
    private @Nullable Connection connection;

    /** Dials nobody yet. */
    public GeometryClient(String host, int port) {
        this(host, port, NetOptions.defaults());
    }

    /**
     * Dials nobody yet.
     *
     * @param host    the environment's name or address
     * @param port    1 to 65535
     * @param options how to treat the connection
     */
    public GeometryClient(String host, int port, NetOptions options) {
        this.host = Arguments.present("host", host);
        this.port = Arguments.port(port, 1);
        this.options = Arguments.present("options", options);
    }

    /**
     * Dials and answers until the environment or {@link #close} ends it; once. What goes wrong on the connection is
     * logged.
     *
     * @throws UncheckedIOException  where the environment cannot be reached
     * @throws IllegalStateException where it was run before
     */
    @Override
    public void run() {
        Socket socket = new Socket();
        Connection own = new Connection(socket, "client of " + host + ":" + port, options);
        synchronized (lock) {
            if (started) {
                throw new IllegalStateException("a client runs once; make another");
            }
            started = true;
            if (closed) {
                ended.countDown();
                return;
            }
            connection = own;
        }
        try {
            dial(socket);
            own.run();
        } finally {
            own.abort();
            ended.countDown();
        }
    }

    private void dial(Socket socket) {
        try {
            socket.connect(
                    new InetSocketAddress(host, port), (int) options.stallTime().toMillis());
        } catch (IOException e) {
            if (!isClosed()) {
                throw new UncheckedIOException(
                        "cannot reach an environment at " + host + ":" + port + ": " + e.getMessage(), e);
            }
        }
    }

    private boolean isClosed() {
        synchronized (lock) {
            return closed;
        }
    }

    /**
     * Ends the connection: what has been read is answered, for at most 2 seconds. When this returns, {@link #run} has
     * ended or is about to. Does nothing the second time.
     */
    @Override
    public void close() {
        Connection own;
        synchronized (lock) {
            if (closed) {
                return;
            }
            closed = true;
            own = connection;
        }
        if (own == null) {
            return;
        }
        own.stop();
        try {
            if (!ended.await(GRACE_SECONDS, TimeUnit.SECONDS)) {
                own.abort();
                ended.await(GRACE_SECONDS, TimeUnit.SECONDS);
            }
        } catch (InterruptedException e) {
            own.abort();
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Dials an environment and serves it to its end.
     *
     * @param args host and port
     * @throws IllegalArgumentException where they are not
     */
    public static void main(String[] args) {
        if (args.length != 2 || !args[1].matches("\\d{1,5}")) {
            throw new IllegalArgumentException(
                    "arguments must be a host and a port, as in: localhost 5555 (got: " + String.join(" ", args) + ")");
        }
        new GeometryClient(args[0], Integer.parseInt(args[1])).run();
    }
}
