package robosim.geometry.cli.network;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import robosim.geometry.net.FiguresMXBean;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.world.shared.JsonText;

/**
 * A port on the loopback address for the operator of a server, over HTTP: its health, metrics for Prometheus, and its
 * connections, any of which can be ended. It has threads of its own and waits for no session.
 */
final class AdminPort implements AutoCloseable {
    /** Most requests at a time. Each that is unfinished takes a thread until its time is up, and must not delay a health check. */
    private static final int THREADS = 64;

    private static final Pattern END = Pattern.compile("/connections/(\\d{1,18})/end");

    /** What a browser sends as the host of this port; a page of another site that resolves to this machine sends its own. */
    private static final Set<String> HOSTS = Set.of("localhost", "127.0.0.1", "[::1]");

    /** How long a request or an answer may take, so that nobody can hold the threads. */
    private static final String SECONDS = "5";

    private final HttpServer http;
    private final ExecutorService threads;
    private final GeometryServer server;

    private record Answer(int status, String type, String text) {
        static Answer plain(int status, String text) {
            return new Answer(status, "text/plain; charset=utf-8", text + "\n");
        }
    }

    /**
     * Starts to listen.
     *
     * @param port 1 to 65535, or 0 for any free port
     * @throws UncheckedIOException if it cannot listen there
     */
    AdminPort(int port, GeometryServer server) {
        this.server = server;
        System.setProperty("sun.net.httpserver.maxReqTime", SECONDS);
        System.setProperty("sun.net.httpserver.maxRspTime", SECONDS);
        InetAddress loopback = InetAddress.getLoopbackAddress();
        try {
            http = HttpServer.create(new InetSocketAddress(loopback, port), 0);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot listen on " + loopback + ":" + port + ": " + e.getMessage(), e);
        }
        threads = new ThreadPoolExecutor(THREADS, THREADS, 1, TimeUnit.MINUTES, new LinkedBlockingQueue<>(64), task -> {
            Thread thread = new Thread(task, "geometry-admin-" + port);
            thread.setDaemon(true);
            return thread;
        });
        http.setExecutor(threads);
        http.createContext("/", this::answer);
        http.start();
    }

    InetSocketAddress address() {
        return http.getAddress();
    }

    private void answer(HttpExchange exchange) throws IOException {
        try (exchange) {
            Answer answer = isFromElsewhere(exchange)
                    ? Answer.plain(403, "only for programs on this machine, not for pages of a browser")
                    : answer(
                            exchange.getRequestMethod(),
                            exchange.getRequestURI().getPath());
            byte[] bytes = answer.text().getBytes(StandardCharsets.UTF_8);
            exchange.getResponseHeaders().set("Content-Type", answer.type());
            boolean isHead = exchange.getRequestMethod().equals("HEAD");
            exchange.sendResponseHeaders(answer.status(), isHead ? -1 : bytes.length);
            if (!isHead) {
                try (OutputStream out = exchange.getResponseBody()) {
                    out.write(bytes);
                }
            }
        }
    }

    private static boolean isFromElsewhere(HttpExchange exchange) {
        String host = exchange.getRequestHeaders().getFirst("Host");
        boolean isOther =
                host != null && !HOSTS.contains(host.replaceFirst(":\\d+$", "").toLowerCase(Locale.ROOT));
        return isOther || exchange.getRequestHeaders().containsKey("Origin");
    }

    private Answer answer(String method, String path) {
        Matcher end = END.matcher(path);
        if (end.matches()) {
            if (!method.equals("POST")) {
                return Answer.plain(405, "to end a connection, POST " + path + " (got: " + method + ")");
            }
            boolean ended = server.end(Long.parseLong(end.group(1)));
            return ended ? Answer.plain(200, "ended") : Answer.plain(404, "no open connection has this number");
        }
        if (!method.equals("GET") && !method.equals("HEAD")) {
            return Answer.plain(405, "this is for GET (got: " + method + ")");
        }
        return switch (path) {
            case "/health" ->
                server.isListening()
                        ? Answer.plain(200, "ok")
                        : Answer.plain(503, "no new connections: the server is ending");
            case "/metrics" -> new Answer(200, "text/plain; version=0.0.4; charset=utf-8", metrics());
            case "/connections" ->
                new Answer(
                        200,
                        "application/json",
                        JsonText.of(server.peers().stream()
                                        .map(AdminPort::fields)
                                        .toList()) + "\n");
            default -> Answer.plain(404, "there are /health, /metrics and /connections; POST /connections/NUMBER/end");
        };
    }

    private static Map<String, @Nullable Object> fields(GeometryServer.Peer peer) {
        return JsonText.fields(
                "id", peer.id(),
                "peer", peer.address(),
                "since", peer.since().toString(),
                "admitted", peer.admitted(),
                "message", peer.message(),
                "request", peer.request(),
                "requestSeconds", peer.age().toMillis() / 1e3);
    }

    private String metrics() {
        FiguresMXBean figures = server.figures();
        StringBuilder text = new StringBuilder(2000);
        Runtime java = Runtime.getRuntime();
        add(text, "connections", "gauge", "Open connections.", figures.getOpenConnections());
        add(text, "connections_total", "counter", "Connections so far.", figures.getConnections());
        add(
                text,
                "connections_refused_total",
                "counter",
                "Connections refused, or closed before their first message, because there were too many.",
                figures.getRefusedConnections());
        add(text, "messages_total", "counter", "Messages carried out.", figures.getBundles());
        add(text, "requests_total", "counter", "Moves, distances, beams, poses, edges.", figures.getRequests());
        add(text, "moves_refused_total", "counter", "Moves that were not made.", figures.getRefusedMoves());
        add(text, "errors_total", "counter", "Connections closed because of an error.", figures.getErrors());
        add(text, "heap_bytes", "gauge", "Memory in use.", java.totalMemory() - java.freeMemory());
        add(text, "heap_max_bytes", "gauge", "Memory that may be used.", java.maxMemory());
        head(text, "answer_seconds", "summary", "From a request that was read to its answer in the socket's queue.");
        quantile(text, "0.5", figures.getAnswerMicrosecondsP50());
        quantile(text, "0.99", figures.getAnswerMicrosecondsP99());
        sample(text, "answer_seconds_sum", seconds(figures.getAnswerMicrosecondsInAll()));
        sample(text, "answer_seconds_count", Long.toString(figures.getAnswers()));
        return text.toString();
    }

    private static void add(StringBuilder text, String name, String type, String help, long value) {
        head(text, name, type, help);
        sample(text, name, Long.toString(value));
    }

    private static void head(StringBuilder text, String name, String type, String help) {
        text.append("# HELP robosim_").append(name).append(' ').append(help).append('\n');
        text.append("# TYPE robosim_").append(name).append(' ').append(type).append('\n');
    }

    private static void quantile(StringBuilder text, String quantile, double microseconds) {
        sample(text, "answer_seconds{quantile=\"" + quantile + "\"}", seconds(microseconds));
    }

    private static String seconds(double microseconds) {
        return String.format(Locale.ROOT, "%.9f", microseconds / 1e6);
    }

    private static void sample(StringBuilder text, String name, String number) {
        text.append("robosim_").append(name).append(' ').append(number).append('\n');
    }

    @Override
    public void close() {
        http.stop(0);
        threads.shutdownNow();
    }
}
