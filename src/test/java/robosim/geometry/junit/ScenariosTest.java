package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** A folder of scenarios as tests. */
class ScenariosTest {
    private static final Path STORED = Path.of("worlds", "scenarios");

    @TestFactory
    Stream<DynamicTest> stored() {
        return Scenarios.in(STORED);
    }

    private static Path copy(Path folder, String name, String from, String to) throws IOException {
        String text = Files.readString(STORED.resolve(name));
        assertThat(text).contains(from);
        return Files.writeString(folder.resolve(name), text.replace(from, to));
    }

    @Test
    void eachIsNamedByItsFileAndTitle() {
        List<DynamicTest> tests = Scenarios.in(STORED).toList();
        assertThat(tests).hasSizeGreaterThan(12);
        assertThat(tests.get(0).getDisplayName())
                .isEqualTo("by-hand.scenario.jsonl: Written by hand: drum 1 drives along the corridor of rooms.xml, and"
                        + " meets a wall");
        assertThat(tests.get(0).getTestSourceUri())
                .hasValueSatisfying(
                        uri -> assertThat(uri.toString()).endsWith("worlds/scenarios/by-hand.scenario.jsonl"));
    }

    @Test
    void aChangedAnswerFailsWithTheWordsOfTheMismatch(@TempDir Path above) throws Throwable {
        Path folder = Files.createDirectories(above.resolve("a/b"));
        Files.copy(Path.of("worlds", "rooms.xml"), above.resolve("a/rooms.xml"));
        String made =
                "{\"type\":\"moves\",\"moves\":[{\"objectName\":\"drum 1\",\"x\":0.5,\"y\":0,\"z\":0,\"rx\":0,\"ry\":0}],"
                        + "\"refused\"";
        copy(folder, "by-hand.scenario.jsonl", made, "{\"type\":\"moves\",\"moves\":[],\"refused\"");
        List<DynamicTest> tests = Scenarios.in(above).toList();
        assertThat(tests).hasSize(1);
        assertThatThrownBy(() -> tests.get(0).getExecutable().execute())
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("by-hand.scenario.jsonl: 1 step is answered differently\n  step 3 (line ")
                .hasMessageContaining("move of \"drum 1\" by (0.5, 0.0, 0.0): expected refused, got made");
    }

    @Test
    void whatIsNoScenarioIsATestThatFails(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("a.scenario.jsonl"), "{\"type\":\"nonsense\"}\n");
        Files.writeString(
                folder.resolve("b.scenario.jsonl"), "{\"type\":\"scenario\",\"version\":1,\"title\":\"Nothing\"}\n");
        Files.writeString(
                folder.resolve("c.scenario.jsonl"),
                "{\"type\":\"scenario\",\"version\":1,\"title\":\"Torn\"}\n{\"type\":\"init\"");
        List<DynamicTest> tests = Scenarios.in(folder).toList();
        assertThat(tests)
                .extracting(DynamicTest::getDisplayName)
                .containsExactly("a.scenario.jsonl", "b.scenario.jsonl: Nothing", "c.scenario.jsonl: Torn");
        assertThatThrownBy(() -> tests.get(0).getExecutable().execute())
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("a.scenario.jsonl:1: ");
        assertThatThrownBy(() -> tests.get(1).getExecutable().execute())
                .hasMessageContaining("a scenario must have a step");
        assertThatThrownBy(() -> tests.get(2).getExecutable().execute())
                .hasMessageContaining("c.scenario.jsonl:2: the last line is incomplete");
    }

    @Test
    void aFolderWithoutAnyIsRefused(@TempDir Path folder) {
        assertThatThrownBy(() -> Scenarios.in(folder))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("folder must hold scenarios");
    }
}
