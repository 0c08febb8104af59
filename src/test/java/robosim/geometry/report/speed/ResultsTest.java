package robosim.geometry.report.speed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.Dimension;

class ResultsTest {
    private static final Subject EXACT = Subject.exact(Dimension.SPATIAL);

    @TempDir
    Path folder;

    @Test
    void figuresComeBackFromTheirFile() throws IOException {
        Results results = new Results();
        results.head("machine", "two: cores");
        results.add(new Measure("sizes", EXACT, "100", "ray", "ns", 12.5));
        results.add(new Measure("sizes", Subject.peer("JTS"), "100", "ray", "ns", Double.POSITIVE_INFINITY));
        results.add(new Measure("moves", EXACT, "a", "move", "early q0.5", 9.5e-19));
        results.write(folder.resolve("r.csv"));
        Results read = Results.read(folder.resolve("r.csv"));
        assertThat(read.head()).isEqualTo(results.head());
        assertThat(read.where(all -> true))
                .isEqualTo(results.where(all -> true))
                .hasSize(3);
        assertThat(read.value("sizes", EXACT, "100", "ray", "ns")).hasValue(12.5);
        assertThat(read.value("sizes", EXACT, "1000", "ray", "ns")).isEmpty();
    }

    @Test
    void theLeastTimeIsKeptAndTheLastOfAllElse() {
        Results results = new Results();
        for (double value : new double[] {5, 3, 4}) {
            results.add(new Measure("sizes", EXACT, "100", "ray", "ns", value));
            results.add(new Measure("sizes", EXACT, "100", "ray", "ratio", value));
        }
        assertThat(results.value("sizes", EXACT, "100", "ray", "ns")).hasValue(3);
        assertThat(results.value("sizes", EXACT, "100", "ray", "ratio")).hasValue(4);
    }

    @Test
    void aNewRunOfAStudyTakesThePlaceOfTheOldOne() {
        Results results = new Results();
        results.add(new Measure("sizes", EXACT, "100", "ray", "ns", 3));
        results.add(new Measure("peers", EXACT, "100", "ray", "ns", 3));
        results.forget("peers");
        results.add(new Measure("peers", EXACT, "100", "ray", "ns", 5));
        assertThat(results.value("peers", EXACT, "100", "ray", "ns")).hasValue(5);
        assertThat(results.value("sizes", EXACT, "100", "ray", "ns")).hasValue(3);
    }

    @Test
    void whatIsNoFigureIsRefused() {
        assertThatThrownBy(() -> Measure.of("a,b,c")).hasMessageContaining("got: a,b,c");
        assertThatThrownBy(() -> new Measure("sizes", EXACT, "1,000", "ray", "ns", 1))
                .hasMessageContaining("got: 1,000");
    }

    @Test
    void peersAreReadFromLinesOfSpacesOrCommas() throws IOException {
        Path file = folder.resolve("peers.csv");
        Files.writeString(file, """
                peer,workload,size,ns,hits,checksum,build_ms
                embree W1a 100 113.5 143820 2114168.307223 0.41 mem_mb=0.01 least=99.5 most=131.0 beside=214.0
                fcl,W2,knot4k,12000.0,1342,1342.0,8.5

                ratio W1a 100 1.352 x embree, 1.309 to 1.486 in 5 JVMs
                robosim W1a 100 493.0 bytes a part, 9.3 cache lines a query
                """);
        List<Measure> measures = PeerLines.read(file);
        assertThat(measures)
                .contains(new Measure("peers", new Subject("embree", "", "", ""), "100", "W1a", "ns", 113.5))
                .contains(new Measure("peers", new Subject("fcl", "", "", ""), "knot4k", "W2", "build ms", 8.5))
                .contains(new Measure("peers", new Subject("embree", "", "", ""), "100", "W1a", "least", 99.5))
                .contains(new Measure("peers", new Subject("embree", "", "", ""), "100", "W1a", "most", 131))
                .contains(new Measure("peers", new Subject("embree", "", "", ""), "100", "W1a", "beside", 214))
                .contains(new Measure("peers", new Subject("embree", "", "", ""), "100", "W1a", "bytes", 100))
                .contains(new Measure("peers", new Subject("robosim", "", "", ""), "100", "W1a", "bytes", 493))
                .hasSize(11);
        Files.writeString(file, "nothing here\n");
        assertThatThrownBy(() -> PeerLines.read(file)).hasMessageContaining("peer workload size ns");
    }

    @Test
    void whereNobodyWatchesTheBarIsALineForEachPart() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Bar bar = new Bar(new PrintStream(bytes, true, StandardCharsets.UTF_8), false, 4);
        bar.show("cones", 1, 0.5);
        bar.finish("cones", 1);
        bar.end();
        assertThat(bytes.toString(StandardCharsets.UTF_8))
                .startsWith(" 25 %  cones")
                .doesNotContain("\r");
        Bar watched = new Bar(new PrintStream(bytes, true, StandardCharsets.UTF_8), true, 4);
        watched.show("cones", 1, 1);
        assertThat(bytes.toString(StandardCharsets.UTF_8))
                .contains("\r[########")
                .contains(" 25 %  cones");
    }
}
