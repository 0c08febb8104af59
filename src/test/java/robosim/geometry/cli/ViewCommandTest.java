package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.viewer.playback.Pictures;

@Timeout(60)
class ViewCommandTest {
    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return Commands.run(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    view                             | Missing required parameter: 'WHAT'
                    view nowhere.xml                 | WHAT must be a file that exists, or HOST:PORT; check the path (got: nowhere.xml)
                    view worlds --port 0             | WHAT must be a file, not a folder; name a file in it (got: worlds)
                    view worlds/rooms.xml --port 70000                 | PORT must be 0 to 65535 (got: 70000)
                    view worlds/rooms.xml --world worlds/rooms.xml     | --world is for a recording or a session, and WHAT is a world
                    view localhost:0                 | PORT must be 1 to 65535 (got: 0)
                    serve 0 --control                | --control is for a page; add --view PORT (got: none)
                    serve 0 --view 80a               | --view must be PORT or ADDRESS:PORT, such as 8080 (got: 80a)
                    serve 0 --view 70000             | PORT must be 0 to 65535 (got: 70000)
                    serve 0 --watch 70000                    | PORT must be 0 to 65535 (got: 70000)
                    """)
    void badArgumentsAreRefusedWithTheirReason(String line, String reason) {
        assertThat(run(line.split(" "))).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains(reason);
        assertThat(out.toString()).isEmpty();
    }

    /** The page of a world and of a recording, until the command is ended. */
    @ParameterizedTest
    @ValueSource(strings = {"worlds/rooms.xml", "worlds/scenarios/wandering.scenario.jsonl"})
    void thePageIsServedUntilItEnds(String file) throws Exception {
        ExecutorService commands = Executors.newSingleThreadExecutor();
        try {
            Future<Integer> code = commands.submit(() -> run("view", file, "--no-browser"));
            Matcher address = Pattern.compile("View on (http://127\\.0\\.0\\.1:\\d+/\\w{32}/)\\R")
                    .matcher("");
            while (!address.reset(out.toString()).find()) {
                assertThat(code.isDone()).as(err.toString()).isFalse();
                TimeUnit.MILLISECONDS.sleep(10);
            }
            HttpResponse<String> page = HttpClient.newHttpClient()
                    .send(
                            HttpRequest.newBuilder(URI.create(address.group(1))).build(),
                            HttpResponse.BodyHandlers.ofString());
            assertThat(page.statusCode()).isEqualTo(200);
            assertThat(page.body()).contains("<title>" + Pictures.title(Path.of(file)) + "</title>");
        } finally {
            commands.shutdownNow();
            assertThat(commands.awaitTermination(20, TimeUnit.SECONDS)).isTrue();
        }
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void aPortThatIsTakenIsNotWatchedOn() throws Exception {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            String port = String.valueOf(taken.getLocalPort());
            assertThat(run("serve", "0", "--watch", port)).isEqualTo(ExitCodes.UNUSABLE);
            assertThat(err.toString()).contains("cannot listen on").contains(port);
        }
    }
}
