package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.NetOptions;
import robosim.geometry.scenario.drive.WorldLoading;

/** python/robosim/client.py, in processes of its own, against the module in this one. */
@Tag("clock")
@Timeout(120)
class PythonClientTest {
    private static final Path TESTS = Path.of("src", "test", "resources", "robosim", "geometry", "cli", "client.py");

    @BeforeAll
    static void pythonIsThere() {
        PythonEnvironmentTest.pythonIsThere();
    }

    /** What a program prints; it must end well. */
    static String run(Map<String, String> environment, String... arguments) throws Exception {
        ProcessBuilder builder = new ProcessBuilder("python3", "-W", "error");
        builder.redirectErrorStream(true).command().addAll(List.of(arguments));
        builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
        builder.environment().put("PYTHONPATH", "python");
        builder.environment().putAll(environment);
        Process process = builder.start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(text).isZero();
        return text;
    }

    private static String run(Path program, String... arguments) throws Exception {
        List<String> all = new ArrayList<>(List.of(arguments));
        all.add(0, program.toString());
        return run(Map.of(), all.toArray(String[]::new));
    }

    /** A server that reads world files for its clients. */
    static GeometryServer loading() throws IOException {
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
            String text = run(Path.of("python", "robosim", "client.py"), "127.0.0.1:" + server.port());
            assertThat(text.lines()).containsExactly("2.9", "wall", "inf");
        }
    }
}
