package robosim.geometry.net;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.SplittableRandom;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.net.pace.Watchdog;

/**
 * Dials RoboSim's environment module and answers its requests until it ends the connection; with {@link Redial} it
 * dials again and again, until it is closed. Every connection begins without a world, unless its environment {@linkplain
 * Timeouts#resume resumes} the session of an earlier one.
 *
 * <!-- java: compiled -->
 * <pre>{@code
 * new Thread(new GeometryClient("localhost", 5555)).start();
 * }</pre>
 */
public final class GeometryClient implements Runnable, AutoCloseable {
    private static final System.Logger LOG = System.getLogger(GeometryClient.class.getPackageName());

    private final String host;
    private final int port;
    private final NetOptions options;
    private volatile Access access;
    private final Figures figures = new Figures();
    private final RandomGenerator random;
    private final Pause pause;

    private final Object lock = new Object();
    private final CountDownLatch closing = new CountDownLatch(1);
    private final CountDownLatch ended = new CountDownLatch(1);
    private @Nullable Thread runner;
    private @Nullable Connection connection;

    /** How a client waits before it dials again. */
    @FunctionalInterface
    interface Pause {
        /** Waits; returns early if the latch opens. */
        void await(CountDownLatch closing, Duration time) throws InterruptedException;
    }

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
        this(
                host,
                port,
                options,
                new SplittableRandom(),
                (closing, time) -> closing.await(time.toNanos(), TimeUnit.NANOSECONDS));
    }

    GeometryClient(String host, int port, NetOptions options, RandomGenerator random, Pause pause) {
        this.host = Checks.present("host", host);
        this.port = Checks.port(port, 1);
        this.options = Checks.present("options", options);
        this.access = options.access();
        this.random = random;
        this.pause = pause;
    }

    /**
     * Changes the keys, certificates or secret for the next time that it dials; the present connection goes on. The parameters are
     * those of {@link NetOptions#withAccess}.
     */
    public void renew(@Nullable Tls tls, char @Nullable [] secret) {
        access = Access.of(tls, secret);
    }

    /** What it has done so far; a live view. */
    public FiguresMXBean figures() {
        return figures;
    }

    /**
     * Dials and answers requests until the environment or {@link #close} ends the connection; if the options say so,
     * dials again until {@link #close}. Errors of a connection are logged.
     *
     * @throws UncheckedIOException if the environment cannot be reached and the options do not redial
     * @throws IllegalStateException if it was run before
     */
    @Override
    public void run() {
        synchronized (lock) {
            if (runner != null) {
                throw new IllegalStateException("a client can run only once; create another");
            }
            runner = Thread.currentThread();
        }
        String place = host + ":" + port;
        Management management = Management.show(figures, "GeometryClient", place);
        try (Watchdog watchdog =
                new Watchdog("geometry-watch-" + place, options.timeouts().finest())) {
            ConnectionContext around = new ConnectionContext(options, figures, watchdog);
            Redial redial = options.redial();
            try {
                if (redial == null) {
                    dialOnce(around);
                } else {
                    dialAgain(around, redial);
                }
            } finally {
                around.kept().close();
            }
        } finally {
            management.close();
            ended.countDown();
        }
    }

    private void dialOnce(ConnectionContext around) {
        try {
            converse(around, "client of " + host + ":" + port);
        } catch (IOException e) {
            throw new UncheckedIOException(cannotReach(e), e);
        }
    }

    private void dialAgain(ConnectionContext around, Redial redial) {
        int failures = 0;
        for (int dialled = 1; !isClosed(); dialled++) {
            String complaint = "the connection is over";
            try {
                boolean answered = converse(around, "client of " + host + ":" + port + ", connection " + dialled);
                failures = answered ? 0 : failures + 1;
            } catch (IOException e) {
                failures++;
                complaint = cannotReach(e);
            }
            if (!isClosed()) {
                Duration time = redial.pause(Math.max(0, failures - 1), random);
                LOG.log(System.Logger.Level.INFO, complaint + "; dialling again in " + time.toMillis() + " ms");
                await(time);
            }
        }
    }

    private void await(Duration time) {
        try {
            pause.await(closing, time);
        } catch (InterruptedException e) {
            closing.countDown();
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Dials and answers until the connection ends.
     *
     * @return whether any request was answered
     * @throws IOException if the environment cannot be reached
     */
    private boolean converse(ConnectionContext around, String name) throws IOException {
        Socket socket = new Socket();
        Access present = access;
        Tls tls = present.tls();
        Connection own = new Connection(
                socket, name, around.with(present), tls == null ? null : plain -> tls.dial(plain, host, port));
        try {
            synchronized (lock) {
                if (isClosed()) {
                    return false;
                }
                connection = own;
            }
            if (dial(socket)) {
                own.run();
            }
            return own.hasAnswered();
        } finally {
            own.abort();
        }
    }

    /** Connects; returns false if this client was closed meanwhile. */
    private boolean dial(Socket socket) throws IOException {
        try {
            socket.connect(new InetSocketAddress(host, port), (int)
                    options.timeouts().stall().toMillis());
            return true;
        } catch (IOException e) {
            if (isClosed()) {
                return false;
            }
            throw e;
        }
    }

    private String cannotReach(IOException e) {
        // whose message is the host's name once more
        String reason = e instanceof UnknownHostException ? "there is no host of that name" : e.getMessage();
        return "cannot reach an environment at " + host + ":" + port + ": " + reason;
    }

    private boolean isClosed() {
        return closing.getCount() == 0;
    }

    /**
     * Ends the connection within 2 seconds: requests already read are answered for a second and a half, then cut off,
     * with a line in the log; a peer that speaks JSON is told. When this method returns, {@link #run} has ended, or
     * will end after a single long query; if a listener closes its own client, this method does not wait for {@code
     * run}. A second call does nothing.
     */
    @Override
    public void close() {
        Connection own;
        boolean mayWait;
        synchronized (lock) {
            if (isClosed()) {
                return;
            }
            closing.countDown();
            own = connection;
            mayWait = runner != Thread.currentThread();
        }
        if (own == null) {
            return;
        }
        own.stop();
        if (!mayWait) {
            return;
        }
        try {
            if (!ended.await(ConnectionContext.ANSWERS_NANOS, TimeUnit.NANOSECONDS)) {
                own.cutOff();
                if (!ended.await(
                        ConnectionContext.WORDS_NANOS - ConnectionContext.ANSWERS_NANOS, TimeUnit.NANOSECONDS)) {
                    own.abort();
                    ended.await(ConnectionContext.ALL_NANOS - ConnectionContext.WORDS_NANOS, TimeUnit.NANOSECONDS);
                }
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
     * @throws IllegalArgumentException if the arguments are anything else
     */
    public static void main(String[] args) {
        if (args.length != 2 || !args[1].matches("\\d{1,5}")) {
            throw new IllegalArgumentException(
                    "arguments must be a host and a port, as in: localhost 5555 (got: " + String.join(" ", args) + ")");
        }
        new GeometryClient(args[0], Integer.parseInt(args[1])).run();
    }
}
