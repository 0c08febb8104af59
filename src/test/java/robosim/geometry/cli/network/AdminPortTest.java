package robosim.geometry.cli.network;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.HostilePeerTest;
import robosim.geometry.net.LogCapture;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.SessionListener;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;

/** What the operator of a server sees and does, also while its sessions are busy. */
@Tag("clock")
public class AdminPortTest {
    private static final MoveRequest NOBODY = new MoveRequest("nobody", 1, 0, 0, 0, 0);

    /** The complete answer to an HTTP request without a body. */
    public static String http(int port, String method, String path, String... headers) throws IOException {
        List<String> lines = new ArrayList<>(List.of(method + " " + path + " HTTP/1.1", "Connection: close"));
        lines.addAll(List.of(headers.length == 0 ? new String[] {"Host: localhost:" + port} : headers));
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            socket.setSoTimeout(20_000);
            socket.getOutputStream()
                    .write((String.join("\r\n", lines) + "\r\nContent-Length: 0\r\n\r\n")
                            .getBytes(StandardCharsets.US_ASCII));
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static long number(String metrics, String name) {
        Matcher line = Pattern.compile("^robosim_" + name + " (\\d+)$", Pattern.MULTILINE)
                .matcher(metrics);
        assertThat(line.find()).as(name + " in " + metrics).isTrue();
        return Long.parseLong(line.group(1));
    }

    @Test
    void itTellsHowTheServerIsAndCountsWhatItDoes() throws Exception {
        try (GeometryServer server = new GeometryServer(0);
                AdminPort admin = new AdminPort(0, server);
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            int port = admin.address().getPort();
            assertThat(admin.address().getAddress().isLoopbackAddress()).isTrue();
            assertThat(http(port, "GET", "/health")).startsWith("HTTP/1.1 200").endsWith("\r\n\r\nok\n");
            MessageWriter out = new MessageWriter(socket.getOutputStream());
            MessageReader in = new MessageReader(socket.getInputStream());
            for (int k = 0; k < 3; k++) {
                out.write(new MoveBundle(List.of(NOBODY, NOBODY)));
                in.read();
            }
            HostilePeerTest.await(() -> server.figures().getAnswers() == 3);
            String metrics = http(port, "GET", "/metrics");
            assertThat(number(metrics, "connections")).isEqualTo(1);
            assertThat(number(metrics, "connections_total")).isEqualTo(1);
            assertThat(number(metrics, "messages_total")).isEqualTo(3);
            assertThat(number(metrics, "requests_total")).isEqualTo(6);
            assertThat(number(metrics, "moves_refused_total")).isEqualTo(6);
            assertThat(number(metrics, "answer_seconds_count")).isEqualTo(3);
            assertThat(metrics)
                    .contains(
                            "Content-type: text/plain; version=0.0.4", "robosim_answer_seconds{quantile=\"0.99\"} 0.0");
            // The form of the text: https://prometheus.io/docs/instrumenting/exposition_formats
            String body = metrics.substring(metrics.indexOf("\r\n\r\n") + 4);
            assertThat(body.lines())
                    .allMatch(
                            line -> line.matches(
                                    "# (HELP|TYPE) robosim_[a-z_]+ .+|robosim_[a-z_]+(\\{quantile=\"0\\.\\d+\"\\})? \\d+(\\.\\d+)?"));
            server.drain(java.time.Duration.ZERO);
            assertThat(http(port, "GET", "/health")).startsWith("HTTP/1.1 503");
        }
    }

    @Test
    void itShowsWhatTakesLongAndEndsIt() throws Exception {
        CountDownLatch slow = new CountDownLatch(1);
        SessionListener waiting = new SessionListener() {
            @Override
            public void requested(Bundle request) {
                try {
                    slow.await();
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        };
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(
                        InetAddress.getLoopbackAddress(),
                        0,
                        NetOptions.defaults().withListeners(name -> waiting));
                AdminPort admin = new AdminPort(0, server);
                Socket busy = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            int port = admin.address().getPort();
            new MessageWriter(busy.getOutputStream()).write(new MoveBundle(List.of(NOBODY)));
            HostilePeerTest.await(() -> server.peers().stream().anyMatch(each -> each.request() != null));
            Thread.sleep(20);
            try (Socket idle = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
                HostilePeerTest.await(() -> server.peers().size() == 2);
                String all = http(port, "GET", "/connections");
                assertThat(all)
                        .containsPattern("\\{\"id\":1,\"peer\":\"/127.0.0.1:" + busy.getLocalPort()
                                + "\",\"since\":\"20[^\"]+Z\",\"admitted\":true,\"message\":1,"
                                + "\"request\":\"MoveBundle\",\"requestSeconds\":0?\\.?[0-9.]*[1-9]")
                        .contains(":" + idle.getLocalPort(), "\"admitted\":false,\"message\":1,\"request\":null");
            }
            assertThat(http(port, "GET", "/connections/1/end")).startsWith("HTTP/1.1 405");
            assertThat(http(port, "POST", "/connections/77/end")).startsWith("HTTP/1.1 404");
            assertThat(http(port, "POST", "/connections/1/end")).startsWith("HTTP/1.1 200");
            assertThat(busy.getInputStream().readAllBytes()).hasSizeLessThan(5);
            assertThat(log.linesWith("ended by an operator at message 1")).hasSize(1);
            slow.countDown();
            HostilePeerTest.await(() -> server.connections() == 0);
        }
    }

    @Test
    void pagesOfABrowserAndUnknownPathsGetNothing() throws Exception {
        try (GeometryServer server = new GeometryServer(0);
                AdminPort admin = new AdminPort(0, server)) {
            int port = admin.address().getPort();
            assertThat(http(port, "GET", "/connections", "Host: evil.example:" + port))
                    .startsWith("HTTP/1.1 403");
            assertThat(http(port, "POST", "/connections/1/end", "Host: localhost", "Origin: http://evil.example"))
                    .startsWith("HTTP/1.1 403");
            assertThat(http(port, "GET", "/"))
                    .startsWith("HTTP/1.1 404")
                    .contains("/health, /metrics and /connections");
            assertThat(http(port, "DELETE", "/health")).startsWith("HTTP/1.1 405");
            assertThat(http(port, "GET", "/health", "Host: 127.0.0.1")).startsWith("HTTP/1.1 200");
        }
    }
}
