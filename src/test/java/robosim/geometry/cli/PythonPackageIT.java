package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.docs.Block;
import robosim.geometry.docs.Pages;
import robosim.geometry.net.GeometryServer;

/**
 * The Python package with the application jar that was built: its own tests, the code of docs/guide-python.md, and every
 * program and command of docs/tutorial.md.
 */
@Timeout(300)
class PythonPackageIT {
    private static final Path GUIDE = Path.of("docs", "guide-python.md");
    private static final Path TUTORIAL = Path.of("docs", "tutorial.md");
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
    @Tag("sources")
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

    /** The page's programs, by the names in their first lines, and then its commands, in order. */
    @Test
    @Tag("sources")
    void theTutorialDoesWhatItSays(@TempDir Path folder) throws Exception {
        List<String> commands = new ArrayList<>();
        List<String> printed = new ArrayList<>();
        for (Block block : Pages.blocks(TUTORIAL)) {
            String first = block.code().lines().findFirst().orElse("");
            if (first.matches("(#|//) \\w+\\.\\w+")) {
                Files.writeString(folder.resolve(first.substring(first.indexOf(' ') + 1)), block.code());
            } else if (block.language().equals("console")) {
                for (String line : block.code().lines().toList()) {
                    if (line.startsWith("$ ")) {
                        commands.add(line.substring(2));
                        printed.add("");
                    } else {
                        int last = printed.size() - 1;
                        String one = line.equals("...") ? "(?:.*\\R)*?" : Pattern.quote(line) + "\\R";
                        printed.set(last, printed.get(last) + one);
                    }
                }
            }
        }
        assertThat(commands).hasSizeGreaterThan(9);
        for (int k = 0; k < commands.size(); k++) {
            assertThat(run(folder, commands.get(k))).as(commands.get(k)).matches(printed.get(k));
        }
        assertThat(folder).isDirectoryContaining("glob:**.gif").isDirectoryContaining("glob:**.mcap");
    }

    /** The test of a robot on the page is that of the example project. */
    @Test
    @Tag("sources")
    void theTutorialsTestIsTheExamples() throws Exception {
        String example = Files.readString(Path.of("examples/scenario-tests/src/test/java/example/FollowTest.java"));
        String shown = Pages.blocks(TUTORIAL).stream()
                .map(Block::code)
                .filter(code -> code.contains("@Test"))
                .findFirst()
                .orElseThrow();
        assertThat(example).contains(shown.substring(shown.indexOf("@Test")));
    }

    private static String run(Path folder, String command) throws Exception {
        String jar = Path.of(String.valueOf(ENVIRONMENT.get("ROBOSIM_JAR")))
                .toAbsolutePath()
                .toString();
        List<String> words = new ArrayList<>(List.of(command.split(" ")));
        if (words.get(0).equals("robosim-geometry")) {
            words.set(0, "java");
            words.addAll(1, List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-jar", jar));
        }
        words.replaceAll(word -> word.endsWith("-app.jar") ? jar : word);
        if (words.get(0).equals("java")) {
            words.set(0, Path.of(System.getProperty("java.home"), "bin", "java").toString());
        }
        ProcessBuilder builder = new ProcessBuilder(words);
        builder.directory(folder.toFile()).redirectErrorStream(true);
        builder.environment()
                .put("PYTHONPATH", Path.of("python").toAbsolutePath().toString());
        builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
        builder.environment().putAll(ENVIRONMENT);
        builder.environment().put("ROBOSIM_JAR", jar);
        Process process = builder.start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as("%s: %s", command, text).isZero();
        return text;
    }
}
