package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** The commands, options, classes and files that the pages name are there. */
class PagesTest {
    private static final Pattern TYPE =
            Pattern.compile("\\brobosim\\.geometry(?:\\.[a-z]+)*\\.[A-Z]\\w*(?:[.$][A-Z]\\w*)?");
    private static final Pattern FILE =
            Pattern.compile("(?<![\\w/.-])(?:worlds|docs|examples|src|\\.ci)/[\\w./-]*[\\w](?![\\w/*-]*[*<{])");
    private static final Pattern COMMAND = Pattern.compile(
            "(?:-Dexec\\.args=\"|\\brobosim-geometry )((?:demo|check|view|export|convert|sweep|completion|serve|connect|replay|render)\\b[^\"`|#)]*)");
    private static final Pattern PROFILE = Pattern.compile("mvn [^`]*-P(\\w+)");
    private static final Pattern TEST = Pattern.compile("-Dtest=(\\w+)");

    private static List<Path> pages() throws IOException {
        try (Stream<Path> files = Stream.of(
                        "README.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs", "examples", "worlds")
                .flatMap(PagesTest::under)) {
            return files.filter(file -> file.toString().endsWith(".md"))
                    .filter(file -> !file.toString().contains("target"))
                    .sorted()
                    .toList();
        }
    }

    private static Stream<Path> under(String root) {
        try (Stream<Path> files = Files.walk(Path.of(root))) {
            return files.toList().stream();
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    @Test
    void whatPagesNameIsThere() throws IOException {
        List<String> wrong = new ArrayList<>();
        int seen = 0;
        for (Path page : pages()) {
            List<String> names = named(Files.readString(page));
            seen += names.size();
            for (String name : names) {
                String fault = fault(name);
                if (fault != null) {
                    wrong.add(page + ": " + name + ": " + fault);
                }
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(seen).as("names seen").isGreaterThan(150);
    }

    /** Each as its kind and name. */
    private static List<String> named(String text) {
        List<String> names = new ArrayList<>();
        find(TYPE, 0, "type", text, names);
        find(FILE, 0, "file", text, names);
        find(COMMAND, 1, "command", text, names);
        find(PROFILE, 1, "profile", text, names);
        find(TEST, 1, "test", text, names);
        return names;
    }

    private static void find(Pattern pattern, int group, String kind, String text, List<String> names) {
        Matcher matcher = pattern.matcher(text.replace("\\\n", " "));
        while (matcher.find()) {
            names.add(kind + " "
                    + matcher.group(group).lines().findFirst().orElse("").strip());
        }
    }

    private static @Nullable String fault(String name) throws IOException {
        String what = name.substring(name.indexOf(' ') + 1);
        return switch (name.substring(0, name.indexOf(' '))) {
            case "type" -> isType(what) ? null : "there is no such class or package";
            case "file" -> isFile(what) ? null : "there is no such file";
            case "command" -> command(what);
            case "profile" ->
                Files.readString(Path.of("pom.xml")).contains("<id>" + what + "</id>")
                        ? null
                        : "there is no such profile";
            default -> hasTest(what) ? null : "there is no such test";
        };
    }

    /** Of the project, or of the user's project that it has as an example. */
    private static boolean isFile(String name) {
        return name.endsWith("/nowhere.xml") // by which pages show what becomes of a name that is wrong
                || Stream.of("", "examples/scenario-tests", "examples/scenario-tests/src/test/resources")
                        .anyMatch(root -> Files.exists(Path.of(root, name)));
    }

    private static boolean isType(String name) {
        String binary = name.replaceAll("(?<=\\.[A-Z]\\w{0,60})\\.(?=[A-Z])", "\\$");
        return PagesTest.class.getClassLoader().getResource(binary.replace('.', '/') + ".class") != null;
    }

    private static boolean hasTest(String name) {
        return under("src/test/java")
                .anyMatch(file -> file.getFileName().toString().equals(name + ".java"));
    }

    /** The command, and each of its options as far as the line goes. */
    private static @Nullable String command(String line) {
        List<String> words = List.of(line.split("\\s+"));
        CommandLine command = Commands.line(false).getSubcommands().get(words.get(0));
        if (command == null) {
            return "there is no such command";
        }
        Set<String> options = command.getCommandSpec().optionsMap().keySet();
        return words.stream()
                .filter(word -> word.startsWith("-") && !options.contains(word.replaceFirst("=.*", "")))
                .findFirst()
                .map(word -> "there is no option " + word)
                .orElse(null);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "robosim.geometry.bench.Nothing",
                "robosim.geometry.model.Point.Inner",
                "`worlds/missing.xml`",
                "robosim-geometry serve 5555 --loud",
                "-Dexec.args=\"demo --nothing\"",
                "mvn verify -Pnothing",
                "mvn test -Dtest=NoTest",
            })
    void whatIsNotThereIsSeen(String text) throws IOException {
        List<String> names = named(text);
        assertThat(names).hasSize(1);
        assertThat(fault(names.get(0))).isNotNull();
    }

    @Test
    void whatIsThereIsFound(@TempDir Path folder) throws IOException {
        String text = """
                robosim.geometry.model.Point, robosim.geometry.junit, `worlds/rooms.xml`, `docs/`, target/demo/x.svg,
                robosim-geometry serve 5555 --record recordings   # robosim-geometry serve 5555 \\
                    --host 0.0.0.0
                mvn verify -Pstress and mvn test -Dtest=PagesTest
                """;
        List<String> names = named(text);
        assertThat(names).hasSize(6).contains("file worlds/rooms.xml", "profile stress", "test PagesTest");
        for (String name : names) {
            assertThat(fault(name)).as(name).isNull();
        }
    }
}
