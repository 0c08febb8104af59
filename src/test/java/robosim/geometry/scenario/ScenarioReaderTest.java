package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.lang.ref.WeakReference;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.SonarRequestBundle;

class ScenarioReaderTest {
    static final SessionOptions OPTIONS = SessionOptions.ROBOSIM;

    private static final String HEADER = "{\"type\":\"scenario\",\"version\":1,\"title\":\"a test\"}\n";
    private static final String SONARS =
            "{\"type\":\"sonars\",\"requests\":[{\"objectName\":\"r\",\"xOffset\":1,\"zOffset\":0}]}\n";
    private static final String DISTANCES = "{\"type\":\"distances\",\"distances\":[2.5]}\n";
    private static final String MOVES =
            "{\"type\":\"moves\",\"moves\":[{\"objectName\":\"r\",\"x\":1,\"y\":0,\"z\":0,\"rx\":0,\"ry\":0}]}\n";
    private static final String NONE_MADE = "{\"type\":\"moves\",\"moves\":[],\"refused\":[]}\n";
    private static final String TIME = "{\"type\":\"time\",\"at\":12,\"took\":3}\n";
    private static final String NOTE = "{\"type\":\"note\",\"text\":\"ünd so weiter\"}\n";

    @TempDir
    Path folder;

    private static ScenarioReader reader(String text) throws ScenarioException {
        return ScenarioReader.of(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "here");
    }

    @Test
    void stepsHaveTheirAnswersTimesAndNotes() throws IOException {
        ScenarioReader reader = reader(HEADER + NOTE + "\n" + NOTE + MOVES + MOVES + NONE_MADE + TIME + "   \r\n"
                + SONARS + NOTE + DISTANCES + NOTE + TIME + SONARS + TIME + MOVES.trim());
        assertThat(reader.header()).isEqualTo(new ScenarioHeader("a test", "", OPTIONS));
        Step unanswered = reader.next();
        assertThat(unanswered.request()).isInstanceOf(MoveBundle.class);
        assertThat(unanswered.notes()).containsExactly("ünd so weiter", "ünd so weiter");
        assertThat(unanswered.line()).isEqualTo(5);
        assertThat(unanswered.expected()).isNull();
        Step moves = reader.next();
        assertThat(moves.expected().bundle()).isEqualTo(new MoveBundle(List.of()));
        assertThat(moves.timing()).isEqualTo(new Timing(12, 3));
        Step sonars = reader.next();
        assertThat(sonars.request()).isInstanceOf(SonarRequestBundle.class);
        assertThat(sonars.line()).isEqualTo(10);
        assertThat(sonars.expected()).isNotNull();
        assertThat(sonars.timing()).isNotNull();
        assertThat(sonars.notes()).isEmpty();
        Step timed = reader.next();
        assertThat(timed.expected()).isNull();
        assertThat(timed.timing()).isNotNull();
        assertThat(timed.notes()).hasSize(2);
        assertThat(reader.next().timing()).isNull();
        assertThat(reader.next()).isNull();
        assertThat(reader.torn()).isZero();
    }

    @Test
    void optionsAreThoseOfTheHeader() throws IOException {
        SessionOptions options = new SessionOptions(Dimension.SPATIAL, Accuracy.DOP, new Beam(0.1, 7, 0.3));
        for (SessionOptions each : List.of(options, OPTIONS)) {
            ScenarioHeader header = new ScenarioHeader("title \"quoted\"", each);
            assertThat(reader(header.line() + "\n").header()).isEqualTo(header);
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            {"type":"distances","distances":[1]}                           | 2 | an answer must follow its request
            {"type":"moves","moves":[],"refused":[]}                       | 2 | an answer must follow its request
            {"type":"time","at":1,"took":1}                                | 2 | a time must follow a request
            {"type":"scenario","version":1,"title":"x"}                    | 2 | a header must come once
            {"type":"fly"}                                                 | 2 | "fly"
            {"type":"note"}                                                | 2 | must have the field "text"
            {"type":"note","text":1}                                       | 2 | /text
            {"type":"note","text":"a","more":1}                            | 2 | "more"
            {"type":"note","text":"a","text":"b"}                          | 2 | once
            {"type":"note","text":["a"]}                                   | 2 | /text
            {"type":"note","text":"a"} x                                   | 2 | JSON
            {"type":"world"}                                               | 2 | must have the field "file"
            {"type":"world","file":"../rooms.xml"}                         | 2 | only be named in a file
            {"type":"moves","moves":[{"objectName":"r"}]}                  | 2 | must have the field "x"
            {"type":"moves","moves":[NaN]}                                 | 2 | JSON
            {"type":"hello","version":1}                                   | 2 | "hello"
            {"type":"moves","moves":[]}~{"type":"distances","distances":[]}| 3 | moves must be answered by moves
            {"type":"sonars","requests":[]}~{"type":"moves","moves":[],"refused":[]} | 3 | answered by distances
            {"type":"sonars","requests":[]}~{"type":"distances","distances":[1]}     | 3 | one distance for each
            {"type":"init","objects":[]}~{"type":"distances","distances":[]}         | 3 | an init must have no answer
            {"type":"init","objects":[]}~{"type":"time","at":-1,"took":1}  | 3 | whole number from 0
            {"type":"init","objects":[]}~{"type":"time","at":1.5,"took":1} | 3 | whole number from 0
            {"type":"init","objects":[]}~{"type":"time","at":1}            | 3 | "took"
            nothing                                                        | 2 | JSON
            []                                                             | 2 | must be an object
            """)
    void whatIsNoScenarioIsRefusedWithItsLine(String lines, int line, String reason) throws IOException {
        ScenarioReader reader = reader(HEADER + lines.replace('~', '\n') + "\n" + SONARS);
        assertThatThrownBy(() -> {
                    while (reader.next() != null) {
                        continue;
                    }
                })
                .isInstanceOfSatisfying(ScenarioException.class, e -> {
                    assertThat(e.line()).isEqualTo(line);
                    assertThat(e.source()).isEqualTo("here");
                })
                .hasMessageStartingWith("here:" + line + ": ")
                .hasMessageContaining(reason);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            {"type":"scenario","version":2,"title":"x"}                    | version must be 1
            {"type":"scenario","version":1}                                | "title"
            {"type":"scenario","version":1,"title":null}                   | /title
            {"type":"scenario","version":1,"title":"x","options":{}}       | "dimension"
            {"type":"scenario","version":1,"title":"x","options":[]}       | must be an object
            {"type":"scenario","version":1,"title":"x","options":{"dimension":"FLAT","accuracy":"EXACT","beam":{"min":0,"max":1,"width":0}}} | /options/dimension: must be one of [PLANAR, SPATIAL]
            {"type":"scenario","version":1,"title":"x","options":{"dimension":"PLANAR","accuracy":"EXACT","beam":{"min":2,"max":1,"width":0}}} | max
            {"type":"init","objects":[]}                                   | begin with its header
            {"type":"note","text":"x"}                                     | begin with its header
            """)
    void whatDoesNotBeginAsAScenarioIsRefused(String line, String reason) {
        assertThatThrownBy(() -> reader(line + "\n" + SONARS))
                .isInstanceOf(ScenarioException.class)
                .hasMessageContaining(reason);
        assertThatThrownBy(() -> reader("")).hasMessageContaining("begin with its header");
    }

    @Test
    void otherBytesThanTextAreRefused() throws IOException {
        ScenarioReader reader = ScenarioReader.of(
                new ByteArrayInputStream((HEADER + NOTE + SONARS).getBytes(StandardCharsets.ISO_8859_1)), "here");
        assertThatThrownBy(reader::next).hasMessageStartingWith("here:2: ").hasMessageContaining("UTF-8");
    }

    /** Cut after any of its bytes a file is read up to the last whole line, and told to be torn where it is. */
    @Test
    void aTornLastLineIsToldAndIgnored() throws IOException {
        String whole = HEADER + SONARS + DISTANCES + TIME + NOTE + MOVES + NONE_MADE;
        byte[] bytes = whole.getBytes(StandardCharsets.UTF_8);
        int torn = 0;
        for (int length = HEADER.length(); length <= bytes.length; length++) {
            ScenarioReader reader = ScenarioReader.of(new ByteArrayInputStream(bytes, 0, length), "here");
            int steps = 0;
            while (reader.next() != null) {
                steps++;
            }
            boolean ended = bytes[length - 1] == '\n' || length < bytes.length && bytes[length] == '\n';
            assertThat(reader.torn() > 0).as("cut after %s bytes", length).isEqualTo(!ended);
            torn += reader.torn() > 0 ? 1 : 0;
            int lines = (int) new String(bytes, 0, length, StandardCharsets.ISO_8859_1)
                            .chars()
                            .filter(c -> c == '\n')
                            .count()
                    + (ended && bytes[length - 1] != '\n' ? 1 : 0);
            assertThat(steps).as("cut after %s bytes", length).isEqualTo(lines < 2 ? 0 : lines < 6 ? 1 : 2);
        }
        assertThat(torn).isGreaterThan(250);
    }

    @Test
    void aMistakeInALastLineWithoutItsEndIsNoTear() throws IOException {
        ScenarioReader reader = reader(HEADER + SONARS + "{\"type\":\"time\",\"at\":12,\"tock\":\"}\\\"{\"}");
        assertThatThrownBy(reader::next).hasMessageStartingWith("here:3: ").hasMessageContaining("took");
    }

    @Test
    void aWorldFileIsFoundBesideTheScenarioAndNotAboveItsRoot() throws IOException {
        Path scenarios = Files.createDirectories(folder.resolve("worlds/scenarios"));
        Files.copy(Path.of("worlds/maze.xml"), folder.resolve("worlds/maze.xml"));
        Files.copy(Path.of("worlds/maze.xml"), folder.resolve("maze.xml"));
        Path file = scenarios.resolve("a.scenario.jsonl");
        Files.writeString(file, HEADER + "{\"type\":\"world\",\"file\":\"../maze.xml\"}\n");
        InitBundle init = (InitBundle) Scenario.read(file).steps().get(0).request();
        assertThat(init.objects()).hasSizeGreaterThan(20);
        assertThat(init.settings()).isNotNull();

        assertThatThrownBy(() -> Scenario.read(file, scenarios))
                .isInstanceOf(ScenarioException.class)
                .hasMessageStartingWith(file + ":2: ")
                .hasMessageContaining("under " + scenarios);
        for (String name :
                List.of("../../maze.xml", folder.resolve("maze.xml").toString(), "../none.xml", ".", "\\u0000")) {
            Files.writeString(file, HEADER + "{\"type\":\"world\",\"file\":\"" + name + "\"}\n");
            assertThatThrownBy(() -> Scenario.read(file))
                    .as(name)
                    .isInstanceOf(ScenarioException.class)
                    .hasMessageStartingWith(file + ":2: file must ");
        }
        // Whether there is anything outside is not told.
        Files.writeString(file, HEADER + "{\"type\":\"world\",\"file\":\"../../none.xml\"}\n");
        assertThatThrownBy(() -> Scenario.read(file)).hasMessageContaining("file must lead to a file under");
        Files.createSymbolicLink(folder.resolve("worlds/link.xml"), folder.resolve("maze.xml"));
        Files.writeString(file, HEADER + "{\"type\":\"world\",\"file\":\"../link.xml\"}\n");
        assertThatThrownBy(() -> Scenario.read(file)).hasMessageContaining("links followed");
        assertThat(Scenario.read(file, folder).steps()).hasSize(1);
    }

    @Test
    void aWorldFileThatIsNoneOrDoesNotFitIsRefused() throws IOException {
        Path file = folder.resolve("a.scenario.jsonl");
        Files.writeString(file, HEADER + NOTE + "{\"type\":\"world\",\"file\":\"bad.xml\"}\n");
        Path bad = folder.resolve("bad.xml");
        Files.writeString(bad, "<world/>");
        assertThatThrownBy(() -> Scenario.read(file))
                .isInstanceOf(ScenarioException.class)
                .hasMessageStartingWith(file + ":3: " + bad + ":1:");
        Files.writeString(
                bad,
                "<world xmlns=\"urn:robosim:world:1\" width=\"2\" height=\"2\" length=\"2\">"
                        + "<sphere name=\"ball\" center=\"1 0 0\" radius=\"1\"/></world>");
        assertThatThrownBy(() -> Scenario.read(file))
                .hasMessageStartingWith(file + ":3: ")
                .hasMessageContaining("ball");
    }

    @Test
    void filesThatAreNotThereAreRefused() {
        assertThatThrownBy(() -> Scenario.read(folder.resolve("none"))).hasMessageContaining("no such file");
        assertThatThrownBy(() -> Scenario.read(folder))
                .isInstanceOf(ScenarioException.class)
                .hasMessageContaining("could not be");
    }

    /** A recording of a day is read step by step: no more of it is in memory than a step and a buffer. */
    @Test
    void aHugeFileIsStreamed() throws IOException {
        int count = 20_000;
        byte[] step = (SONARS + DISTANCES + TIME).getBytes(StandardCharsets.UTF_8);
        long[] taken = {0};
        Enumeration<InputStream> steps = new Enumeration<>() {
            @Override
            public boolean hasMoreElements() {
                return taken[0] < count;
            }

            @Override
            public InputStream nextElement() {
                taken[0]++;
                return new ByteArrayInputStream(step);
            }
        };
        InputStream header = new ByteArrayInputStream(HEADER.getBytes(StandardCharsets.UTF_8));
        InputStream body = new SequenceInputStream(steps);
        try (ScenarioReader reader =
                ScenarioReader.of(new SequenceInputStream(Collections.enumeration(List.of(header, body))), "huge")) {
            WeakReference<Step> first = new WeakReference<>(reader.next());
            int read = 1;
            while (reader.next() != null) {
                read++;
                assertThat((taken[0] - read) * step.length).isLessThan(1 << 18);
            }
            assertThat(read).isEqualTo(count);
            for (int k = 0; k < 50 && first.get() != null; k++) {
                System.gc();
            }
            assertThat(first.get()).isNull();
        }
    }
}
