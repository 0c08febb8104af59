package robosim.geometry.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Scenario;

/** A recorded conversation with chance in it. */
class ScenarioSweepTest {
    private static final Path STORED = Path.of("worlds", "scenarios");
    private static final Path WANDERING = STORED.resolve("wandering.scenario.jsonl");

    @TempDir
    Path folder;

    private static Map<String, Double> values(Sweep sweep, long index) {
        Outcome outcome = sweep.run(index);
        assertThat(outcome.error()).isNull();
        return outcome.values();
    }

    private static double value(Sweep sweep, long index, String name) {
        Double value = values(sweep, index).get(name);
        assertThat(value).as(name).isNotNull();
        return value;
    }

    /** Without chance it is what was recorded, also in a copy of a copy. */
    @ParameterizedTest
    @ValueSource(strings = {"wandering", "quarter-turns", "overlapping-walls", "by-hand", "found-lost-side"})
    void withoutChanceItIsTheRecording(String name) throws IOException {
        Path file = STORED.resolve(name + ".scenario.jsonl");
        assertThat(Replay.of(Scenario.read(file))).isEmpty();
        ScenarioSweep scenario = ScenarioSweep.read(file);
        assertThat(scenario.name()).isEqualTo(name);
        Sweep sweep = Sweep.of(scenario).over(scenario.world()).replicates(2);
        assertThat(value(sweep, 0, "other than recorded")).isZero();
        assertThat(values(sweep, 1)).isEqualTo(values(sweep, 0));
        Sweep zeros =
                sweep.vary("place", "0").vary("aim", "0").vary("slip", "0").vary("range", "0");
        assertThat(values(zeros, 0)).isEqualTo(values(sweep, 0));
    }

    @ParameterizedTest
    @ValueSource(strings = {"place=0.5", "heading=20", "slip=0.2", "aim=5", "range=0.1"})
    void eachKindOfChanceTells(String parameter) throws IOException {
        ScenarioSweep scenario = ScenarioSweep.read(WANDERING);
        String[] words = parameter.split("=", 2);
        Sweep sweep = Sweep.of(scenario)
                .over(scenario.world())
                .vary(words[0], "0", words[1])
                .replicates(20);
        double moves = value(sweep, 0, "moves made") + value(sweep, 0, "moves refused");
        double distances = value(sweep, 0, "echoes") + value(sweep, 0, "no echo");
        TreeMap<Double, Integer> means = new TreeMap<>();
        for (long index = 1; index < sweep.size(); index += 2) {
            assertThat(value(sweep, index - 1, "other than recorded")).isZero();
            assertThat(value(sweep, index, "other than recorded")).isPositive();
            assertThat(value(sweep, index, "moves made") + value(sweep, index, "moves refused"))
                    .isEqualTo(moves);
            assertThat(value(sweep, index, "echoes") + value(sweep, index, "no echo"))
                    .isEqualTo(distances);
            means.merge(value(sweep, index, "mean distance [world units]"), 1, Integer::sum);
        }
        assertThat(means).as("each replicate has its own draws").hasSize(20);
    }

    /** Noise of the distances alone leaves the robots where they are; twice the noise is twice as far off. */
    @Test
    void drawsArePairedOverValues() throws IOException {
        ScenarioSweep scenario = ScenarioSweep.read(WANDERING);
        Sweep sweep = Sweep.of(scenario)
                .over(scenario.world())
                .vary("range", "0", "0.001", "0.002")
                .replicates(30);
        String mean = "mean distance [world units]";
        for (long index = 0; index < sweep.size(); index += 3) {
            double off = value(sweep, index + 1, mean) - value(sweep, index, mean);
            double twice = value(sweep, index + 2, mean) - value(sweep, index, mean);
            assertThat(off).isNotZero().isBetween(-0.0005, 0.0005);
            assertThat(twice / off).isBetween(1.99, 2.01);
        }
    }

    @Test
    void robotsStandInOtherWorldsToo() throws IOException {
        ScenarioSweep scenario = ScenarioSweep.read(STORED.resolve("by-hand.scenario.jsonl"));
        SweepWorld maze = SweepWorld.read(Path.of("worlds", "maze.xml"));
        SweepWorld both = scenario.in(maze);
        assertThat(both.name()).isEqualTo("maze");
        assertThat(both.snapshot().size())
                .isGreaterThan(maze.snapshot().size())
                .isLessThanOrEqualTo(
                        maze.snapshot().size() + scenario.world().snapshot().size());
        Sweep sweep = Sweep.of(scenario).over(both).over(scenario.world()).vary("accuracy", "EXACT", "SPHERE");
        for (long index = 0; index < 4; index++) {
            assertThat(value(sweep, index, "not answered")).isEqualTo(value(sweep, 1, "not answered"));
        }
    }

    @Test
    void refusesWhatItCannotSweep() throws IOException {
        String text = Files.readString(WANDERING);
        String[] lines = text.split("\n");
        Path twice = folder.resolve("twice.scenario.jsonl");
        Files.writeString(twice, text + lines[1] + "\n");
        assertThatThrownBy(() -> ScenarioSweep.read(twice))
                .isInstanceOf(SweepException.class)
                .hasMessageContaining("must have one world");
        Path none = folder.resolve("none.scenario.jsonl");
        Files.writeString(none, lines[0] + "\n");
        assertThatThrownBy(() -> ScenarioSweep.read(none)).hasMessageContaining("must begin with its world");
        ScenarioSweep scenario = ScenarioSweep.read(WANDERING);
        Sweep wrong = Sweep.of(scenario).over(scenario.world()).vary("place", "-1");
        assertThat(wrong.run(0).error()).contains("place must be at least 0");
        assertThatThrownBy(() -> wrong.vary("accuracy", "fine")).hasMessageContaining("accuracy must be one of");
        assertThatThrownBy(() -> wrong.vary("place", "1", "1")).hasMessageContaining("each once");
        assertThatThrownBy(() -> wrong.vary("a b", "1")).hasMessageContaining("without blanks");
        assertThatThrownBy(() -> wrong.over(scenario.world())).hasMessageContaining("got twice");
        assertThatThrownBy(() -> Shard.parse("4/4")).hasMessageContaining("(n - 1)/n");
        assertThatThrownBy(() -> Shard.parse("a")).hasMessageContaining("as in 0/4");
    }
}
