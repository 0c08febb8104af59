package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.NetOptions;
import robosim.geometry.scenario.drive.WorldLoading;

/** examples/robosim.py and the code of docs/guide-python.md, in processes of their own, against the module in this one. */
@Tag("clock")
@Timeout(120)
class PythonClientTest {
    private static final Path TESTS = Path.of("src", "test", "resources", "robosim", "geometry", "cli", "client.py");
    private static final Path GUIDE = Path.of("docs", "guide-python.md");

    @BeforeAll
    static void pythonIsThere() {
        PythonEnvironmentTest.pythonIsThere();
    }

    /** What a program prints; it must end well. */
    private static String run(Path program, String... arguments) throws Exception {
        ProcessBuilder builder = new ProcessBuilder("python3", "-W", "error", program.toString());
        builder.redirectErrorStream(true).command().addAll(List.of(arguments));
        builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
        builder.environment().put("PYTHONPATH", Examples.FOLDER.toString());
        Process process = builder.start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(text).isZero();
        return text;
    }

    /** A server that reads world files for its clients. */
    private static GeometryServer loading() throws IOException {
        NetOptions options = NetOptions.defaults().withWorlds(WorldLoading.of(Path.of("worlds"), List.of()));
        return new GeometryServer(InetAddress.getLoopbackAddress(), 0, options);
    }

    @Test
    void everyMessageIsAnswered() throws Exception {
        try (GeometryServer server = loading()) {
            assertThat(run(TESTS, "127.0.0.1:" + server.port(), "worlds")).isEqualToIgnoringNewLines("all done");
        }
    }

    @Test
    void aBadArgumentCostsOnlyItsOwnRequest() throws Exception {
        try (GeometryServer server = new GeometryServer(0)) {
            assertThat(run(TESTS.resolveSibling("badarguments.py"), "127.0.0.1:" + server.port()))
                    .isEqualToIgnoringNewLines("all done");
        }
    }

    /** Against a stand-in for the module, whose answers come late and in pieces. */
    @Test
    void afterAnInterruptNoCallReturnsTheAnswerOfAnother() throws Exception {
        assertThat(run(TESTS.resolveSibling("interrupts.py"))).isEqualToIgnoringNewLines("all done");
    }

    @Test
    void byItselfItCarriesOutItsExample() throws Exception {
        try (GeometryServer server = new GeometryServer(0)) {
            String text = run(Examples.FOLDER.resolve("robosim.py"), "127.0.0.1:" + server.port());
            assertThat(text.lines()).containsExactly("2.9", "wall", "inf");
        }
    }

    /** All blocks of Python on the page as one program; each comment after a print is what it prints. */
    @Test
    void theGuideSaysWhatHappens(@TempDir Path folder) throws Exception {
        List<String> program = new ArrayList<>();
        List<String> expected = new ArrayList<>();
        boolean isCode = false;
        for (String line : Files.readAllLines(GUIDE)) {
            if (line.startsWith("```")) {
                isCode = line.equals("```python");
            } else if (isCode) {
                int comment = line.indexOf("  # ");
                if (line.contains("print(") && comment > 0) {
                    expected.add(line.substring(comment + 4));
                }
                program.add(line);
            }
        }
        assertThat(expected).hasSizeGreaterThan(10);
        try (GeometryServer server = loading()) {
            Path file = folder.resolve("guide.py");
            Files.writeString(file, String.join("\n", program).replace("7575", "" + server.port()) + "\n");
            assertThat(run(file).lines()).containsExactlyElementsOf(expected);
        }
    }
}
