package robosim.geometry.viewer.web;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import robosim.geometry.world.shared.JsonText;

/** One tab of a headless Chromium with software rendering, driven over the DevTools protocol. */
public final class Chromium implements AutoCloseable {
    private static final List<String> NAMES = List.of("chromium", "chromium-browser", "google-chrome");
    private static final long ANSWER_SECONDS = 60;

    private final Process process;
    private final WebSocket socket;
    private final List<String> complaints = new CopyOnWriteArrayList<>();
    private final Map<Long, CompletableFuture<Map<?, ?>>> waiting = new ConcurrentHashMap<>();
    private long calls;

    private Chromium(Process process, URI tab) {
        this.process = process;
        this.socket = HttpClient.newHttpClient()
                .newWebSocketBuilder()
                .buildAsync(tab, new Listener())
                .join();
    }

    /** The browser's program, if this machine has one. */
    public static Optional<Path> program() {
        String path = System.getenv("PATH") == null ? "" : System.getenv("PATH");
        return Stream.of(path.split(File.pathSeparator))
                .flatMap(folder -> NAMES.stream().map(name -> Path.of(folder, name)))
                .filter(Files::isExecutable)
                .findFirst();
    }

    /** Starts the browser; it keeps its profile and messages in the folder. */
    public static Chromium start(Path folder, int width, int height) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(
                        program().orElseThrow().toString(),
                        "--headless=new",
                        "--no-sandbox",
                        "--use-gl=angle",
                        "--use-angle=swiftshader",
                        "--enable-unsafe-swiftshader",
                        "--js-flags=--expose-gc",
                        "--window-size=" + width + "," + height,
                        "--remote-debugging-port=0",
                        "--user-data-dir=" + folder,
                        "about:blank")
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("messages").toFile());
        // Its sockets lie in the folder too, and go with it.
        builder.environment().put("TMPDIR", folder.toString());
        Process process = builder.start();
        Path port = folder.resolve("DevToolsActivePort");
        for (int k = 0; k < 600 && process.isAlive() && !(Files.exists(port) && Files.size(port) > 0); k++) {
            Thread.sleep(50);
        }
        if (!Files.exists(port)) {
            process.destroyForcibly();
            throw new IOException("no browser: " + Files.readString(folder.resolve("messages")));
        }
        String number = Files.readAllLines(port).get(0);
        String list = new String(
                URI.create("http://127.0.0.1:" + number + "/json")
                        .toURL()
                        .openStream()
                        .readAllBytes(),
                StandardCharsets.UTF_8);
        for (Object each : (List<?>) JsonText.parse(list, "tabs")) {
            Map<?, ?> tab = (Map<?, ?>) each;
            if ("page".equals(tab.get("type"))) {
                Chromium browser = new Chromium(process, URI.create((String) tab.get("webSocketDebuggerUrl")));
                for (String domain : List.of("Page", "Runtime", "Log")) {
                    browser.call(domain + ".enable", "{}");
                }
                return browser;
            }
        }
        process.destroyForcibly();
        throw new IOException("the browser has no tab: " + list);
    }

    private final class Listener implements WebSocket.Listener {
        private final StringBuilder text = new StringBuilder();

        @Override
        public CompletionStage<?> onText(WebSocket from, CharSequence part, boolean isLast) {
            text.append(part);
            if (isLast) {
                try {
                    receive((Map<?, ?>) JsonText.parse(text.toString(), "answer"));
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
                text.setLength(0);
            }
            from.request(1);
            return CompletableFuture.completedStage(null);
        }
    }

    private void receive(Map<?, ?> message) {
        if (message.get("id") instanceof Number id) {
            CompletableFuture<Map<?, ?>> answer = waiting.remove(id.longValue());
            if (answer != null) {
                answer.complete(message);
            }
            return;
        }
        Map<?, ?> details = (Map<?, ?>) message.get("params");
        switch (String.valueOf(message.get("method"))) {
            case "Runtime.consoleAPICalled", "Runtime.exceptionThrown" -> complaints.add(details.toString());
            case "Log.entryAdded" -> {
                Map<?, ?> entry = (Map<?, ?>) details.get("entry");
                // Chromium's own remark about reading a picture of its software renderer.
                if (!String.valueOf(entry.get("text")).contains("GPU stall due to ReadPixels")) {
                    complaints.add(entry.toString());
                }
            }
            default -> {} // what loads and when, which nobody here asks for
        }
    }

    private Map<?, ?> call(String method, String parameters) throws Exception {
        long id = ++calls;
        CompletableFuture<Map<?, ?>> answer = new CompletableFuture<>();
        waiting.put(id, answer);
        socket.sendText("{\"id\":%d,\"method\":\"%s\",\"params\":%s}".formatted(id, method, parameters), true)
                .join();
        Map<?, ?> message = answer.get(ANSWER_SECONDS, TimeUnit.SECONDS);
        if (message.get("error") != null) {
            throw new IOException(method + ": " + message.get("error"));
        }
        return (Map<?, ?>) message.get("result");
    }

    /** Opens a page and waits until it has loaded; complaints of the one before are forgotten. */
    public void open(URI page) throws Exception {
        complaints.clear();
        call("Page.navigate", "{\"url\":" + JsonText.of(page.toString()) + "}");
        until("document.readyState === 'complete'");
    }

    /** The value of an expression in the page; of a promise, what it is kept with. */
    public Object run(String program) throws Exception {
        Map<?, ?> result = call(
                "Runtime.evaluate",
                "{\"expression\":" + JsonText.of(program) + ",\"awaitPromise\":true,\"returnByValue\":true}");
        if (result.get("exceptionDetails") != null) {
            throw new IOException(program + ": " + result.get("exceptionDetails"));
        }
        return ((Map<?, ?>) result.get("result")).get("value");
    }

    /** Waits until a condition holds in the page. */
    public void until(String condition) throws Exception {
        Object held = run("new Promise(done => { const until = performance.now() + 30000; const look = () => { if ("
                + condition + ") done(true); else if (performance.now() > until) done(false); else setTimeout(look, 2);"
                + " }; look(); })");
        if (!Boolean.TRUE.equals(held)) {
            throw new IOException("never held in the page: " + condition);
        }
    }

    /** Presses and releases a key. */
    public void key(String key) throws Exception {
        String named = "\"key\":" + JsonText.of(key) + (key.length() == 1 ? ",\"text\":" + JsonText.of(key) : "");
        call("Input.dispatchKeyEvent", "{\"type\":\"keyDown\"," + named + "}");
        call("Input.dispatchKeyEvent", "{\"type\":\"keyUp\"," + named + "}");
    }

    /** Moves the pointer, or presses or releases its left button. */
    public void mouse(String type, double x, double y) throws Exception {
        String button = type.equals("mouseMoved") ? "\"buttons\":1" : "\"button\":\"left\",\"clickCount\":1";
        call("Input.dispatchMouseEvent", "{\"type\":\"%s\",\"x\":%s,\"y\":%s,%s}".formatted(type, x, y, button));
    }

    /** What the page looks like, as a PNG. */
    public byte[] picture() throws Exception {
        return Base64.getDecoder().decode((String)
                call("Page.captureScreenshot", "{\"format\":\"png\"}").get("data"));
    }

    /** Bytes of the page's objects after a collection. */
    public double heap() throws Exception {
        call("HeapProfiler.collectGarbage", "{}");
        return ((Number) call("Runtime.getHeapUsage", "{}").get("usedSize")).doubleValue();
    }

    /** All that the page wrote on its console, its exceptions, and what the browser said of it. */
    public List<String> complaints() {
        return new ArrayList<>(complaints);
    }

    @Override
    public void close() {
        socket.abort();
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
        try {
            process.waitFor(10, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
