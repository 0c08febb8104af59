package robosim.geometry.viewer.web;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.export.PageWriter;
import robosim.geometry.net.pace.Watchdog;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.JsonText;

/**
 * Serves a page over HTTP: one that is complete, or one that follows a {@link LiveFilm} by server-sent events. Whoever knows the
 * {@linkplain #page address}, which contains a secret, sees it; without it every answer is 403. A page that reads too slowly is
 * disconnected, and comes back by itself.
 */
public final class PageServer implements AutoCloseable {
    /** Most pages that follow at a time; each takes a thread. */
    public static final int MOST_VIEWERS = 16;

    private static final System.Logger LOG = System.getLogger(PageServer.class.getPackageName());
    private static final int OTHER_THREADS = 16;
    private static final int SECRET_BYTES = 16;
    private static final Duration STALL = Duration.ofSeconds(10);
    private static final long IDLE_MILLIS = 2000;

    /** Between two messages to a page: no screen shows more, and a burst of frames goes in one. */
    private static final long BREATH_MILLIS = 15;

    private static final int MOST_COMMAND_BYTES = 10_000;

    /** What a browser sends as the host of this machine; a page of another site that resolves to it sends its own. */
    private static final Set<String> HOSTS = Set.of("localhost", "127.0.0.1", "[::1]");

    static {
        System.setProperty("sun.net.httpserver.nodelay", "true"); // an event is not to wait for the next one
    }

    private final HttpServer http;
    private final ExecutorService threads;
    private final Watchdog watchdog;
    private final String secret;
    private final boolean isLoopback;
    private final AtomicInteger viewers = new AtomicInteger();
    private final @Nullable LiveFilm film;
    private final @Nullable Control control;
    private final String text;
    private volatile boolean closed;

    /** A server of a complete page. */
    public static PageServer of(InetSocketAddress address, PageWriter page) throws IOException {
        return new PageServer(address, page.page(), null, null);
    }

    /**
     * A server of a page that follows what happens.
     *
     * @param control what pages may change; null for nothing
     */
    public static PageServer live(InetSocketAddress address, LiveFilm film, @Nullable Control control)
            throws IOException {
        List<String> commands = control == null ? List.of() : control.commands();
        String settings = JsonText.of(JsonText.fields("commands", commands));
        return new PageServer(address, PageWriter.live(film.title(), settings), film, control);
    }

    private PageServer(InetSocketAddress address, String text, @Nullable LiveFilm film, @Nullable Control control) {
        Checks.present("address", address);
        this.text = text;
        this.film = film;
        this.control = control;
        byte[] random = new byte[SECRET_BYTES];
        new SecureRandom().nextBytes(random);
        secret = HexFormat.of().formatHex(random);
        isLoopback = address.getAddress() != null && address.getAddress().isLoopbackAddress();
        try {
            http = HttpServer.create(address, 0);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot listen on " + address + ": " + e.getMessage(), e);
        }
        watchdog = new Watchdog("geometry-viewers", STALL);
        int most = MOST_VIEWERS + OTHER_THREADS;
        threads = new ThreadPoolExecutor(most, most, 1, TimeUnit.MINUTES, new LinkedBlockingQueue<>(64), task -> {
            Thread thread = new Thread(task, "geometry-viewer-" + address.getPort());
            thread.setDaemon(true);
            return thread;
        });
        http.setExecutor(threads);
        http.createContext("/", this::answer);
        http.start();
    }

    /** The address to open in a browser; it contains the secret. */
    public URI page() {
        InetAddress address = http.getAddress().getAddress();
        String host = address.isAnyLocalAddress() ? "localhost" : address.getHostAddress();
        String named = host.contains(":") ? "[" + host.replaceFirst("%.*", "") + "]" : host;
        return URI.create("http://" + named + ":" + http.getAddress().getPort() + "/" + secret + "/");
    }

    /** The number of pages that follow. */
    public int viewers() {
        return viewers.get();
    }

    private void answer(HttpExchange exchange) throws IOException {
        try (exchange) {
            exchange.getResponseHeaders().set("Cache-Control", "no-store");
            exchange.getResponseHeaders().set("Referrer-Policy", "no-referrer");
            exchange.getResponseHeaders().set("X-Content-Type-Options", "nosniff");
            String[] path = exchange.getRequestURI().getPath().split("/", -1);
            if (path.length < 2 || !isSecret(path[1]) || (isLoopback && isFromElsewhere(exchange))) {
                say(exchange, 403, "open the whole address that was printed, with the secret after the port");
            } else if (path.length == 2) {
                exchange.getResponseHeaders().set("Location", "/" + secret + "/");
                say(exchange, 302, "");
            } else {
                answer(exchange, path[2]);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt(); // closed
        }
    }

    private boolean isSecret(String offered) {
        return MessageDigest.isEqual(secret.getBytes(StandardCharsets.UTF_8), offered.getBytes(StandardCharsets.UTF_8));
    }

    private static boolean isFromElsewhere(HttpExchange exchange) {
        String host = exchange.getRequestHeaders().getFirst("Host");
        return host != null && !HOSTS.contains(host.replaceFirst(":\\d+$", "").toLowerCase(Locale.ROOT));
    }

    private void answer(HttpExchange exchange, String name) throws IOException, InterruptedException {
        String method = exchange.getRequestMethod();
        boolean isCommand = name.equals("control");
        if (!method.equals(isCommand ? "POST" : "GET")) {
            say(exchange, 405, "this is for " + (isCommand ? "POST" : "GET") + " (got: " + method + ")");
        } else if (isCommand) {
            command(exchange);
        } else if (name.isEmpty()) {
            send(exchange, 200, "text/html; charset=utf-8", text.getBytes(StandardCharsets.UTF_8));
        } else if (film != null && name.equals("data")) {
            data(exchange, film);
        } else if (film != null && name.equals("events")) {
            follow(exchange, film);
        } else {
            say(exchange, 404, "there are the page, data, events and control");
        }
    }

    private static void say(HttpExchange exchange, int status, String words) throws IOException {
        send(exchange, status, "text/plain; charset=utf-8", (words + "\n").getBytes(StandardCharsets.UTF_8));
    }

    private static void send(HttpExchange exchange, int status, String type, byte[] bytes) throws IOException {
        exchange.getResponseHeaders().set("Content-Type", type);
        exchange.sendResponseHeaders(status, bytes.length);
        try (OutputStream out = exchange.getResponseBody()) {
            out.write(bytes);
        }
    }

    private static void data(HttpExchange exchange, LiveFilm film) throws IOException {
        LiveFilm.Start start = film.start();
        if (start == null) {
            say(exchange, 404, "there is no world yet");
            return;
        }
        exchange.getResponseHeaders().set("X-Number", String.valueOf(start.number));
        send(exchange, 200, "application/octet-stream", start.data);
    }

    private void command(HttpExchange exchange) throws IOException, InterruptedException {
        if (control == null) {
            say(exchange, 403, "this page may only look; start the server with --control to permit more");
            return;
        }
        byte[] body;
        try (InputStream in = exchange.getRequestBody()) {
            body = in.readNBytes(MOST_COMMAND_BYTES + 1);
        }
        if (body.length > MOST_COMMAND_BYTES) {
            say(exchange, 413, "a command must have at most " + MOST_COMMAND_BYTES + " bytes");
            return;
        }
        try {
            Object command = JsonText.parse(new String(body, StandardCharsets.UTF_8), "command");
            if (!(command instanceof Map<?, ?> fields)) {
                throw new IllegalArgumentException("a command must be an object (got: " + command + ")");
            }
            String said = control.carryOut(fields);
            String answer = JsonText.of(JsonText.fields("said", said, "state", control.state()));
            send(exchange, 200, "application/json", answer.getBytes(StandardCharsets.UTF_8));
        } catch (FileProblem | IllegalArgumentException e) {
            say(exchange, 400, String.valueOf(e.getMessage()));
        }
    }

    private void follow(HttpExchange exchange, LiveFilm live) throws IOException, InterruptedException {
        if (viewers.incrementAndGet() > MOST_VIEWERS) {
            viewers.decrementAndGet();
            say(exchange, 503, "there are " + MOST_VIEWERS + " pages, which is the maximum; close one");
            return;
        }
        live.join();
        Watchdog.Guard guard = watchdog.guard(exchange::close);
        try {
            exchange.getResponseHeaders().set("Content-Type", "text/event-stream");
            exchange.sendResponseHeaders(200, 0);
            tell(exchange.getResponseBody(), since(exchange), live, guard);
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "a page is gone" + (guard.isBroken() ? ", it read nothing" : ""), e);
        } finally {
            guard.close();
            live.leave();
            viewers.decrementAndGet();
        }
    }

    /** The last event that a page has; negative for none. */
    private static long since(HttpExchange exchange) {
        String last = exchange.getRequestHeaders().getFirst("Last-Event-ID");
        return last != null && last.matches("\\d{1,18}") ? Long.parseLong(last) : -1;
    }

    private void tell(OutputStream out, long last, LiveFilm live, Watchdog.Guard guard)
            throws IOException, InterruptedException {
        long number = last;
        String state = "";
        StringBuilder lines = new StringBuilder("retry: 500\n\n");
        while (!closed) {
            LiveFilm.News news = live.after(number, state, lines.isEmpty() ? IDLE_MILLIS : 0);
            if (news.isAnew()) {
                event(lines, "anew", news.number(), "{}");
            }
            for (LiveFilm.Event each : news.events()) {
                event(lines, "frame", each.number(), each.text());
            }
            if (!news.state().equals(state) || lines.isEmpty()) {
                String said = JsonText.of(
                        JsonText.fields("problem", news.state(), "control", control == null ? null : control.state()));
                event(lines, "state", news.number(), said);
            }
            number = news.number();
            state = news.state();
            guard.begin(System.nanoTime() + STALL.toNanos());
            out.write(lines.toString().getBytes(StandardCharsets.UTF_8));
            out.flush();
            guard.end();
            lines.setLength(0);
            TimeUnit.MILLISECONDS.sleep(BREATH_MILLIS);
        }
    }

    private static void event(StringBuilder lines, String name, long number, String text) {
        lines.append("id: ").append(number).append("\nevent: ").append(name);
        lines.append("\ndata: ").append(text).append("\n\n");
    }

    /** Stops to listen, and ends all pages' connections. */
    @Override
    public void close() {
        closed = true;
        http.stop(0);
        threads.shutdownNow();
        watchdog.close();
    }
}
