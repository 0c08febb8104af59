package robosim.geometry.net;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.net.pace.Admissions;
import robosim.geometry.net.pace.Watchdog;
import robosim.geometry.protocol.channel.MessageChannel;

/**
 * Serves environments that dial in, each with its own session on its own thread.
 *
 * <p>It listens from its construction until it is closed; its threads keep the process alive. On the loopback address
 * no authentication is needed; on any other it requires {@linkplain NetOptions#withAccess TLS or a secret}.
 *
 * <pre>{@code
 * NetOptions options = NetOptions.defaults().withConnections(4);
 * try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
 *     server.connections(); // 0: nobody has dialled server.port() yet
 * }
 * }</pre>
 */
public final class GeometryServer implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(GeometryServer.class.getPackageName());

    private final ServerSocket listening;
    private final NetOptions options;
    private final Figures figures = new Figures();
    private final Watchdog watchdog;
    private final Admissions admissions;
    private volatile ConnectionContext around;
    private final Management management;
    private final Map<Connection, Place> connections = new ConcurrentHashMap<>();

    /** Threads whose connection is over but that have not ended yet. */
    private final Set<Thread> ending = ConcurrentHashMap.newKeySet();

    private final Thread acceptor;
    private volatile boolean closed;
    private volatile boolean draining;
    private final AtomicLong lastId = new AtomicLong();

    /** A connection's number and thread. */
    private record Place(long id, Thread thread) {}

    /**
     * An open connection.
     *
     * @param id       its number, from 1 in the order in which connections were made
     * @param address  where its peer is
     * @param since    when it was made
     * @param admitted whether TLS, its secret and its first message have come
     * @param message  the number of the message that is awaited or carried out, from 1
     * @param request  the kind of request that is carried out or waits for its turn; null if none does
     * @param age      for how long it has been
     */
    public record Peer(
            long id,
            String address,
            Instant since,
            boolean admitted,
            long message,
            @Nullable String request,
            Duration age) {
        /** Refuses null, except for {@code request}. */
        public Peer {
            Checks.present("address", address);
            Checks.present("since", since);
            Checks.present("age", age);
        }
    }

    /**
     * Starts to listen on the loopback address.
     *
     * @param port 1 to 65535, or 0 for any free port
     * @throws UncheckedIOException if it cannot listen there
     */
    public GeometryServer(int port) {
        this(InetAddress.getLoopbackAddress(), port, NetOptions.defaults());
    }

    /**
     * Listens.
     *
     * @param address the address to listen on; the wildcard address for all
     * @param port    1 to 65535, or 0 for any free port
     * @param options how to treat connections
     * @throws UncheckedIOException     if it cannot listen there
     * @throws IllegalArgumentException if other machines can reach the address, and the options have neither TLS nor a
     *     secret
     */
    public GeometryServer(InetAddress address, int port, NetOptions options) {
        Checks.present("address", address);
        Checks.port(port, 0);
        this.options = Checks.present("options", options);
        options.access().check(address);
        this.listening = listen(address, port, options.quotas().connections() + Admissions.MOST);
        this.admissions = new Admissions(options.quotas().connections(), System::nanoTime);
        this.watchdog =
                new Watchdog("geometry-watch-" + port(), options.timeouts().finest());
        this.around = new ConnectionContext(options, figures, watchdog);
        this.management = Management.show(figures, "GeometryServer", address().toString());
        this.acceptor = new Thread(this::accept, "geometry-server-" + listening.getLocalPort());
        acceptor.start();
    }

    private static ServerSocket listen(InetAddress address, int port, int backlog) {
        try {
            return new ServerSocket(port, backlog, address);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot listen on " + address + ":" + port + ": " + e.getMessage(), e);
        }
    }

    /** The port that it listens on. */
    public int port() {
        return listening.getLocalPort();
    }

    /** The address that it listens on. */
    public InetSocketAddress address() {
        return (InetSocketAddress) listening.getLocalSocketAddress();
    }

    /** The number of open connections, with those that are not admitted yet. */
    public int connections() {
        return connections.size();
    }

    /**
     * Changes who may connect, for connections that are made from now on; the others go on. So keys, certificates and
     * secrets can be replaced while sessions last. The parameters are those of {@link NetOptions#withAccess}.
     *
     * @throws IllegalArgumentException if other machines can reach the address, and there is neither TLS nor a secret
     */
    public void renew(@Nullable Tls tls, char @Nullable [] secret) {
        Access access = Access.of(tls, secret);
        access.check(listening.getInetAddress());
        around = around.with(access);
    }

    /** What it has done so far; a live view. */
    public FiguresMXBean figures() {
        return figures;
    }

    /** Its open connections, the oldest first; waits for none of them. */
    public List<Peer> peers() {
        return connections.entrySet().stream()
                .map(each -> each.getKey().report(each.getValue().id()))
                .sorted(Comparator.comparingLong(Peer::id))
                .toList();
    }

    /**
     * Ends a connection at once; work for it ends soon after.
     *
     * @return whether there was one of that number
     */
    public boolean end(long id) {
        for (Map.Entry<Connection, Place> each : connections.entrySet()) {
            if (each.getValue().id() == id) {
                each.getKey().end();
                return true;
            }
        }
        return false;
    }

    /** Whether new connections are accepted. */
    public boolean isListening() {
        return !closed && !draining;
    }

    private void accept() {
        boolean full = false;
        while (isListening()) {
            try {
                Socket socket = listening.accept();
                boolean refused = admissions.isFull();
                if (refused) {
                    figures.refused();
                    // Logged first, so that the reason is in the log by the time the peer sees the connection end.
                    if (!full) {
                        LOG.log(
                                System.Logger.Level.WARNING,
                                "server " + port() + ": connections are refused, there are "
                                        + options.quotas().connections());
                    }
                    turnAway(socket);
                } else {
                    serve(socket);
                }
                full = refused;
            } catch (IOException | OutOfMemoryError e) { // out of files or threads for the moment
                if (isListening()) {
                    LOG.log(System.Logger.Level.WARNING, "server " + port() + ": cannot accept: " + e.getMessage());
                    pause();
                }
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt(); // closed
                return;
            }
        }
    }

    /**
     * Nothing here blocks: a new socket has room for a line. What has arrived is read, since closing with unread bytes
     * would discard the line.
     */
    private void turnAway(Socket socket) {
        try (socket) {
            if (around.options().access().tls() == null) {
                socket.getOutputStream().write(MessageChannel.errorLine(admissions.fullness()));
                socket.shutdownOutput();
                socket.getInputStream().skipNBytes(socket.getInputStream().available());
            }
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "server " + port() + ": a refused peer was gone already", e);
        }
    }

    private void serve(Socket socket) throws IOException, InterruptedException {
        String name = "server " + port() + ", peer " + socket.getRemoteSocketAddress();
        ConnectionContext present = around;
        Tls tls = present.options().access().tls();
        Connection connection = new Connection(socket, name, present, tls == null ? null : tls::accept);
        connection.enter(admissions, socket.getInetAddress());
        Thread thread = new Thread(
                () -> {
                    try {
                        connection.run();
                    } finally {
                        ending.add(Thread.currentThread());
                        connections.remove(connection);
                    }
                },
                "geometry-session-" + port() + "-" + socket.getPort());
        ending.removeIf(each -> !each.isAlive());
        connections.put(connection, new Place(lastId.incrementAndGet(), thread));
        try {
            thread.start();
        } catch (OutOfMemoryError e) {
            connections.remove(connection);
            connection.abort();
            connection.leave();
            throw e;
        }
    }

    private static void pause() {
        try {
            TimeUnit.MILLISECONDS.sleep(100);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void stopListening() {
        try {
            listening.close();
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "the listening socket could not be closed", e);
        }
    }

    /**
     * Stops accepting connections and lets the open ones go on until their peers end them, or the time is over; then
     * {@link #close closes}.
     */
    public void drain(Duration longest) {
        Checks.present("longest", longest);
        draining = true;
        stopListening();
        long end = System.nanoTime() + longest.toNanos();
        while (!connections.isEmpty()
                && !closed
                && !Thread.currentThread().isInterrupted()
                && end - System.nanoTime() > 0) {
            pause();
        }
        close();
    }

    /**
     * Stops accepting connections, answers the requests already read, and closes every connection, all within 2
     * seconds. Requests without an answer after a second and a half are cut off with a line in the log; a peer that
     * speaks JSON is told. When this method returns no socket is open, and the only threads left are in the middle of a
     * single long query and end after it. A second call does nothing.
     */
    @Override
    public void close() {
        closed = true;
        stopListening();
        around.kept().close();
        long start = System.nanoTime();
        try {
            join(acceptor, start + ConnectionContext.ANSWERS_NANOS);
            connections.keySet().forEach(Connection::stop);
            joinAll(start + ConnectionContext.ANSWERS_NANOS);
            connections.keySet().forEach(Connection::cutOff);
            joinAll(start + ConnectionContext.WORDS_NANOS);
            connections.keySet().forEach(Connection::abort);
            joinAll(start + ConnectionContext.ALL_NANOS);
        } catch (InterruptedException e) {
            connections.keySet().forEach(Connection::abort);
            Thread.currentThread().interrupt();
        } finally {
            watchdog.close();
            management.close();
        }
    }

    private void joinAll(long deadline) throws InterruptedException {
        for (Place place : connections.values()) {
            join(place.thread(), deadline);
        }
        for (Thread thread : ending) {
            join(thread, deadline);
        }
    }

    private static void join(Thread thread, long deadline) throws InterruptedException {
        long millis = TimeUnit.NANOSECONDS.toMillis(deadline - System.nanoTime());
        if (millis > 0 && thread != Thread.currentThread()) { // a listener may close its own server
            thread.join(millis);
        }
    }
}
