package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.net.GeometryServer;

/** The Python package with the application jar that was built: its own tests, and the code of docs/guide-python.md. */
@Timeout(300)
class PythonPackageIT {
    private static final Path GUIDE = Path.of("docs", "guide-python.md");
    private static final Map<String, String> ENVIRONMENT = Map.of(
            "JAVA_HOME",
            System.getProperty("java.home"),
            "ROBOSIM_JAR",
            System.getProperty("robosim.app", "none"),
            "ROBOSIM_JAVA_OPTIONS",
            "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC");

    @BeforeAll
    static void pythonIsThere() {
        PythonEnvironmentTest.pythonIsThere();
    }

    @Test
    void itsTestsPass() throws Exception {
        String text = PythonClientTest.run(ENVIRONMENT, "-m", "unittest", "discover", "-v", "-s", "python/tests");
        assertThat(text).containsPattern("Ran [3-9][0-9] tests");
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
        Path picture = folder.resolve("plan.png");
        try (GeometryServer server = PythonClientTest.loading()) {
            Path file = folder.resolve("guide.py");
            Files.writeString(
                    file,
                    String.join("\n", program)
                                    .replace("7575", "" + server.port())
                                    .replace("plan.png", picture.toString())
                            + "\n");
            assertThat(PythonClientTest.run(ENVIRONMENT, file.toString()).lines())
                    .containsExactlyElementsOf(expected);
        }
        assertThat(picture).isNotEmptyFile();
    }
}
