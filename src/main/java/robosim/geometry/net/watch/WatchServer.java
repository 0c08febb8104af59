package robosim.geometry.net.watch;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.net.pace.SocketSettings;
import robosim.geometry.net.pace.Watchdog;

/**
 * A second port of a server, on the loopback address, that reports what happens to anyone who dials it. Nothing is read
 * from a watcher, so it can only watch.
 *
 * <p>A watcher that reads nothing for 10 seconds, or falls too far behind, is disconnected with a line in the log;
 * sessions never wait for a watcher. An idle watcher gets an empty line every 2 seconds, which also detects watchers
 * that are gone.
 */
public final class WatchServer implements AutoCloseable {
    /** Maximum number of watchers at a time; each has a thread and a queue. */
    public static final int MOST_WATCHERS = 16;

    private static final System.Logger LOG = System.getLogger(WatchServer.class.getPackageName());
    private static final Duration STALL = Duration.ofSeconds(10);
    private static final long IDLE_MILLIS = 2000;
    private static final long GRACE_MILLIS = 2000;
    private static final byte[] ALIVE = {'\n'};

    private final ServerSocket listening;
    private final Source source;
    private final Watchdog watchdog;
    private final Thread acceptor;
    private final Map<Socket, Thread> watchers = new ConcurrentHashMap<>();
    private volatile boolean closed;

    /** What can be watched. */
    @FunctionalInterface
    public interface Source {
        /**
         * Adds a watcher.
         *
         * @param breakOff to be called, from any thread, when the watcher gets no more; it does not block
         */
        Lines join(Runnable breakOff);
    }

    /** The lines that one watcher gets. */
    public interface Lines extends AutoCloseable {
        /**
         * Waits for the next complete lines.
         *
         * @return the lines; empty if none came in that time
         * @throws IOException if this watcher gets no more
         */
        byte[] next(long millis) throws IOException, InterruptedException;

        /** Why this watcher gets no more; null if it ended by itself. */
        @Nullable
        String problem();

        @Override
        void close();
    }

    /**
     * Starts to listen on the loopback address.
     *
     * @param port 1 to 65535, or 0 for any free port
     * @throws UncheckedIOException if it cannot listen there
     */
    public WatchServer(int port, Source source) {
        Checks.port(port, 0);
        this.source = Checks.present("source", source);
        InetAddress loopback = InetAddress.getLoopbackAddress();
        try {
            this.listening = new ServerSocket(port, MOST_WATCHERS, loopback);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot listen on " + loopback + ":" + port + ": " + e.getMessage(), e);
        }
        this.watchdog = new Watchdog("geometry-watchers-" + port(), STALL);
        this.acceptor = new Thread(this::accept, "geometry-watch-server-" + port());
        acceptor.setDaemon(true);
        acceptor.start();
    }

    /** The port that it listens on. */
    public int port() {
        return listening.getLocalPort();
    }

    /** The address that it listens on. */
    public InetSocketAddress address() {
        return (InetSocketAddress) listening.getLocalSocketAddress();
    }

    /** The number of watchers. */
    public int watchers() {
        return watchers.size();
    }

    private void accept() {
        boolean full = false;
        while (!closed) {
            try {
                Socket socket = listening.accept();
                boolean refused = watchers.size() >= MOST_WATCHERS;
                if (refused) {
                    // Logged first, so that the reason is in the log by the time the watcher sees the connection end.
                    if (!full) {
                        warn("watchers are refused, there are " + MOST_WATCHERS);
                    }
                    socket.close();
                } else {
                    serve(socket);
                }
                full = refused;
            } catch (IOException | OutOfMemoryError e) { // out of files or threads for the moment
                if (!closed) {
                    warn("cannot accept: " + e.getMessage());
                    pause();
                }
            }
        }
    }

    private static void pause() {
        try {
            TimeUnit.MILLISECONDS.sleep(100);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void serve(Socket socket) throws IOException {
        String peer = "peer " + socket.getRemoteSocketAddress();
        Thread thread = new Thread(() -> tell(socket, peer), "geometry-watcher-" + port() + "-" + socket.getPort());
        thread.setDaemon(true);
        watchers.put(socket, thread);
        try {
            thread.start();
        } catch (OutOfMemoryError e) {
            watchers.remove(socket);
            socket.close();
            throw e;
        }
    }

    private void tell(Socket socket, String peer) {
        Lines lines = null;
        Watchdog.Guard guard = watchdog.guard(() -> abort(socket));
        try (socket) {
            SocketSettings.apply(socket);
            socket.shutdownInput(); // anything that a watcher sends is discarded
            lines = source.join(() -> abort(socket));
            OutputStream out = socket.getOutputStream();
            while (!closed) {
                byte[] next = lines.next(IDLE_MILLIS);
                guard.begin(System.nanoTime() + STALL.toNanos());
                out.write(next.length == 0 ? ALIVE : next);
                guard.end();
            }
        } catch (IOException | RuntimeException | OutOfMemoryError e) {
            String problem = lines == null ? null : lines.problem();
            if (guard.isBroken()) {
                problem = "it read nothing for " + STALL.toSeconds() + " s";
            }
            if (problem != null && !closed) {
                warn(peer + ": is told no more, " + problem);
            } else {
                LOG.log(System.Logger.Level.DEBUG, "watch " + port() + ", " + peer + ": gone", e);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt(); // closed
        } finally {
            guard.close();
            if (lines != null) {
                lines.close();
            }
            watchers.remove(socket);
        }
    }

    private void warn(String words) {
        LOG.log(System.Logger.Level.WARNING, "watch " + port() + ", " + words);
    }

    private static void abort(Closeable socket) {
        try {
            socket.close();
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "a socket for watchers could not be closed", e);
        }
    }

    /** Stops accepting watchers and disconnects all. When this method returns, no thread and no socket is left. */
    @Override
    public void close() {
        closed = true;
        abort(listening);
        Map<Socket, Thread> left = Map.copyOf(watchers);
        left.forEach((socket, thread) -> {
            abort(socket);
            thread.interrupt();
        });
        try {
            acceptor.join(GRACE_MILLIS);
            for (Thread thread : left.values()) {
                thread.join(GRACE_MILLIS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            watchdog.close();
        }
    }
}
