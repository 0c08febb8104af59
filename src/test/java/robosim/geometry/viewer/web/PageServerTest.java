package robosim.geometry.viewer.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.export.PageWriter;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.Step;
import robosim.geometry.scenario.Timing;
import robosim.geometry.scenario.Watching;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.Talk;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.Replayer;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldReader;
import robosim.geometry.world.shared.JsonText;

/** What browsers are served: the page, its data, what happens, and what may be changed. */
@Tag("clock")
@Timeout(60)
class PageServerTest {
    private final HttpClient browser = HttpClient.newHttpClient();
    private final LiveFilm film = new LiveFilm("a <live> page", "m");
    private final Replayer stage = new Replayer(SessionOptions.ROBOSIM);
    private PageServer server;

    private static InetSocketAddress anyPort() {
        return new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
    }

    @BeforeEach
    void serve() throws IOException {
        server = PageServer.live(anyPort(), film, null);
    }

    @AfterEach
    void close() {
        server.close();
    }

    private void play(Talk talk) {
        for (Step step : talk.steps()) {
            film.add(stage.play(step));
        }
    }

    private HttpResponse<String> get(URI address) throws Exception {
        return browser.send(HttpRequest.newBuilder(address).build(), HttpResponse.BodyHandlers.ofString());
    }

    private HttpResponse<String> post(PageServer to, String command) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(to.page().resolve("control"))
                .POST(HttpRequest.BodyPublishers.ofString(command))
                .build();
        return browser.send(request, HttpResponse.BodyHandlers.ofString());
    }

    /** The events of a page, one after the other. */
    private final class Events implements AutoCloseable {
        final InputStream stream;
        final BufferedReader lines;
        String name = "";
        long number;

        Events(PageServer of, long since) throws Exception {
            HttpRequest.Builder request = HttpRequest.newBuilder(of.page().resolve("events"));
            if (since >= 0) {
                request.header("Last-Event-ID", String.valueOf(since));
            }
            HttpResponse<InputStream> answer = browser.send(request.build(), HttpResponse.BodyHandlers.ofInputStream());
            assertThat(answer.statusCode()).isEqualTo(200);
            assertThat(answer.headers().firstValue("Content-Type")).hasValue("text/event-stream");
            stream = answer.body();
            lines = new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8));
        }

        /** The next event of a name, as its fields. */
        Map<?, ?> next(String wanted) throws Exception {
            while (true) {
                String line = lines.readLine();
                assertThat(line).as("the stream goes on").isNotNull();
                if (line.startsWith("id: ")) {
                    number = Long.parseLong(line.substring(4));
                } else if (line.startsWith("event: ")) {
                    name = line.substring(7);
                } else if (line.startsWith("data: ") && name.equals(wanted)) {
                    return (Map<?, ?>) JsonText.parse(line.substring(6), "event");
                }
            }
        }

        @Override
        public void close() throws IOException {
            stream.close();
        }
    }

    private static double[] placed(Map<?, ?> frame) {
        List<?> first = (List<?>) ((List<?>) frame.get("placed")).get(0);
        return first.stream().mapToDouble(each -> ((Number) each).doubleValue()).toArray();
    }

    @Test
    void aMoveIsTold() throws Exception {
        try (Events events = new Events(server, -1)) {
            assertThat(get(server.page().resolve("data")).statusCode())
                    .as("no world yet")
                    .isEqualTo(404);
            play(Talk.begun());
            events.next("anew");
            HttpResponse<String> data = get(server.page().resolve("data"));
            assertThat(data.statusCode()).isEqualTo(200);
            assertThat(data.headers().firstValue("X-Number")).hasValue(String.valueOf(events.number));
            film.add(stage.play(Talk.begun().drives(0.5, null).steps().get(1)));
            Map<?, ?> frame = events.next("frame");
            assertThat(placed(frame)).containsExactly(0, -4.5, 0, 0, 0, 0, 0, 1);
            assertThat(frame.get("refused")).isEqualTo(List.of());
            film.add(stage.play(Talk.begun().drives(30, null).steps().get(1)));
            frame = events.next("frame");
            assertThat(frame.get("placed")).isEqualTo(List.of());
            // The drum, ahead, by the wall: the first after the drum and the two that are no object.
            assertThat(frame.get("refused")).isEqualTo(List.of(List.of(0.0, 0.0, 3.0)));
            try (Events resumed = new Events(server, events.number - 1)) {
                assertThat(resumed.next("frame")).as("nothing is told twice").isEqualTo(frame);
            }
        }
    }

    @Test
    void whatWasMeasuredIsTold() throws Exception {
        play(Talk.begun());
        try (Events events = new Events(server, -1)) {
            events.next("anew");
            film.add(stage.play(Talk.begun().looks(null).steps().get(1)));
            List<?> scan = (List<?>) ((List<?>) events.next("frame").get("heard")).get(0);
            List<?> sensor = (List<?>) ((List<?>) scan.get(1)).get(0);
            assertThat(sensor).isEqualTo(List.of(0.0, 0.349066, 6.0, 0.0, 0.0, 0.0));
            assertThat(((List<?>) scan.get(2)).get(0)).as("beyond its range").isNull();
        }
    }

    @Test
    void aSessionThatRunsIsShown() throws Exception {
        Watching watching = new Watching(SessionOptions.ROBOSIM);
        Session session = new Session(SessionOptions.ROBOSIM, watching.apply("peer 1"), "peer 1");
        session.reply(Talk.begun().steps().get(0).request());
        List<String> connections = new ArrayList<>();
        LiveSource source = new LiveSource(
                film, () -> StepReader.of(ScenarioReader.of(watching.lines(), "here")), Colours.NONE, connections::add);
        try (Events events = new Events(server, -1)) {
            events.next("anew");
            assertThat(connections).containsExactly("peer 1");
            session.reply(new MoveBundle(List.of(Talk.move(0.25, 0))));
            assertThat(placed(events.next("frame"))[1]).isEqualTo(-4.75);
            session.reply(new InitBundle(List.of(Talk.DRUM)));
            events.next("anew");
        } finally {
            source.close();
        }
    }

    /** A session that is faster than what may be computed for its pages is left behind, and joined again. */
    @Test
    void aPageIsNotLateForLong() throws Exception {
        AtomicInteger openings = new AtomicInteger();
        List<Step> steps = Talk.begun().drives(0.25, null).drives(-0.25, null).steps();
        film.join();
        LiveSource source = new LiveSource(
                film,
                () -> {
                    openings.incrementAndGet();
                    return new StepReader() {
                        private int next;

                        @Override
                        public ScenarioHeader header() {
                            return new ScenarioHeader("late", SessionOptions.ROBOSIM);
                        }

                        @Override
                        public Step next() { // all at the beginning, by their times
                            Step step = steps.get(next == 0 ? 0 : 1 + next % 2);
                            next++;
                            return new Step(0, List.of(), step.request(), null, new Timing(0, 0));
                        }

                        @Override
                        public void close() {}
                    };
                },
                Colours.NONE,
                connection -> {});
        try {
            while (openings.get() < 3) {
                TimeUnit.MILLISECONDS.sleep(20);
            }
        } finally {
            source.close();
        }
    }

    @Test
    void withoutTheSecretThereIsNothing() throws Exception {
        URI page = server.page();
        assertThat(get(page.resolve("/")).statusCode()).isEqualTo(403);
        assertThat(get(page.resolve("/" + "0".repeat(32) + "/events")).statusCode())
                .isEqualTo(403);
        assertThat(get(page).statusCode()).isEqualTo(200);
        assertThat(get(URI.create(page.toString().replaceFirst("/$", "")))
                        .headers()
                        .firstValue("Location"))
                .hasValue(page.getPath());
        try (PageServer other = PageServer.live(anyPort(), film, null)) {
            assertThat(other.page().getPath()).isNotEqualTo(page.getPath());
        }
        String asked = "GET " + page.getPath() + " HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n";
        assertThat(raw(asked)).startsWith("HTTP/1.1 403");
    }

    private String raw(String asked) throws IOException {
        try (Socket socket =
                new Socket(InetAddress.getLoopbackAddress(), server.page().getPort())) {
            socket.getOutputStream().write(asked.getBytes(StandardCharsets.US_ASCII));
            return new String(socket.getInputStream().readNBytes(100), StandardCharsets.US_ASCII);
        }
    }

    @Test
    void thePageIsThatOfItsServer() throws Exception {
        HttpResponse<String> page = get(server.page());
        assertThat(page.body())
                .contains("connect-src 'self'", "{\"commands\":[]}", "<title>a &lt;live> page</title>")
                .doesNotContain("%LIVE%", "%DATA%", "%TITLE%");
        assertThat(page.headers().firstValue("Cache-Control")).hasValue("no-store");
        assertThat(page.headers().firstValue("Referrer-Policy")).hasValue("no-referrer");
        assertThat(get(server.page().resolve("other")).statusCode()).isEqualTo(404);
        try (PageServer still =
                PageServer.of(anyPort(), new PageWriter(Talk.begun().film()).titled("still"))) {
            assertThat(get(still.page()).body())
                    .contains("<title>still</title>")
                    .doesNotContain("connect-src");
            assertThat(get(still.page().resolve("events")).statusCode()).isEqualTo(404);
            assertThat(post(still, "{}").statusCode()).isEqualTo(403);
        }
    }

    @Test
    void nothingIsChangedWithoutPermission() throws Exception {
        play(Talk.begun());
        HttpResponse<String> refused = post(server, "{\"do\": \"drag\", \"name\": \"drum\", \"x\": 0, \"z\": 0}");
        assertThat(refused.statusCode()).isEqualTo(403);
        assertThat(refused.body()).contains("--control");
        assertThat(get(server.page().resolve("control")).statusCode()).isEqualTo(405);
    }

    @Test
    void aRobotOfAFileIsDragged() throws Exception {
        World world = WorldReader.read(new ByteArrayInputStream("""
            <world xmlns="urn:robosim:world:1" width="20" height="5" length="10" dimension="PLANAR">
              <box name="wall" center="2 0 0" width="1" height="1" length="4"/>
              <cylinder name="drum" moveable="true" center="-5 0 0" radius="0.5" height="1"/>
            </world>\
            """.getBytes(StandardCharsets.UTF_8)), "here", null);
        LiveFilm own = new LiveFilm("here", "");
        WorldControl control = new WorldControl(world, own);
        try (PageServer dragged = PageServer.live(anyPort(), own, control);
                Events events = new Events(dragged, -1)) {
            events.next("anew");
            assertThat(post(dragged, "{\"do\":\"drag\",\"name\":\"drum\",\"x\":-3,\"z\":1}")
                            .body())
                    .isEqualTo("{\"said\":\"\",\"state\":{}}");
            assertThat(placed(events.next("frame"))).startsWith(0, -3, 0, 1);
            assertThat(post(dragged, "{\"do\":\"drag\",\"name\":\"drum\",\"x\":8,\"z\":1}")
                            .body())
                    .contains("blocked by wall");
            assertThat(events.next("frame").get("refused")).asString().startsWith("[[0.0, 0.0, 3.0]]");
            assertThat(post(dragged, "{\"do\":\"drag\",\"name\":\"drum\",\"x\":8,\"z\":1,\"lift\":true}")
                            .body())
                    .contains("\"said\":\"\"");
            assertThat(placed(events.next("frame"))).startsWith(0, 8, 0, 1);
            assertThat(post(dragged, "{\"do\":\"turn\",\"name\":\"drum\",\"degrees\":90}")
                            .statusCode())
                    .isEqualTo(200);
            assertThat(placed(events.next("frame"))[5]).isCloseTo(Math.sqrt(0.5), within(1e-12));
            post(dragged, "{\"do\":\"reset\"}");
            assertThat(placed(events.next("frame"))).startsWith(0, -5, 0, 0);
            for (String wrong : List.of(
                    "{",
                    "[]",
                    "{\"do\":\"fly\"}",
                    "{\"do\":\"drag\",\"name\":\"nobody\",\"x\":1,\"z\":1}",
                    "{\"do\":\"drag\",\"name\":\"drum\",\"x\":\"1\",\"z\":1}",
                    "{\"do\":\"drag\",\"name\":\"wall\",\"x\":1,\"z\":1}")) {
                HttpResponse<String> answer = post(dragged, wrong);
                assertThat(answer.statusCode()).as(wrong).isEqualTo(400);
                assertThat(answer.body()).as(wrong).contains("(got: ");
            }
            assertThat(post(dragged, " ".repeat(20_000)).statusCode()).isEqualTo(413);
        }
    }

    /** Whoever reads nothing is not waited for, and begins anew once it reads again; others see the last. */
    @Test
    void aPageThatReadsNothingDelaysNobody() throws Exception {
        play(Talk.begun());
        try (Socket slow = new Socket(
                        InetAddress.getLoopbackAddress(), server.page().getPort());
                Events fast = new Events(server, -1)) {
            slow.setSoTimeout(20_000);
            slow.getOutputStream()
                    .write(("GET " + server.page().resolve("events").getPath() + " HTTP/1.1\r\nHost: localhost\r\n\r\n")
                            .getBytes(StandardCharsets.US_ASCII));
            BufferedReader lines =
                    new BufferedReader(new InputStreamReader(slow.getInputStream(), StandardCharsets.UTF_8));
            await(lines, "event: anew");
            fast.next("anew");
            List<String> notes = List.of("a long note ".repeat(100));
            Frame frame = new Frame(null, Map.of(), List.of(), Map.of(), "", notes, null);
            for (int k = 0; k < 30_000; k++) { // more than is kept, and than fits between the two ends
                film.add(frame);
            }
            while (fast.number < 30_001) { // it may begin anew too
                fast.next("state");
            }
            await(lines, "event: anew");
            assertThat(server.viewers()).isEqualTo(2);
        }
    }

    private static void await(BufferedReader lines, String wanted) throws IOException {
        String line = lines.readLine();
        while (line != null && !line.equals(wanted)) {
            line = lines.readLine();
        }
        assertThat(line).isEqualTo(wanted);
    }

    @Test
    void moreThanTheMostAreRefused() throws Exception {
        List<Events> all = new ArrayList<>();
        for (int k = 0; k < PageServer.MOST_VIEWERS; k++) {
            all.add(new Events(server, -1));
        }
        HttpResponse<String> refused = get(server.page().resolve("events"));
        assertThat(refused.statusCode()).isEqualTo(503);
        assertThat(get(server.page()).statusCode())
                .as("others are still served")
                .isEqualTo(200);
        for (Events each : all) {
            each.close();
        }
    }

    @Test
    void aPortThatIsTakenIsRefused() {
        InetSocketAddress taken = new InetSocketAddress(
                InetAddress.getLoopbackAddress(), server.page().getPort());
        assertThatThrownBy(() -> PageServer.live(taken, film, null))
                .isInstanceOf(UncheckedIOException.class)
                .hasMessageContaining("cannot listen on");
    }
}
