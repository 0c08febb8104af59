package robosim.geometry.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.Step;

/** A recorded conversation with chance in it. */
class ScenarioSweepTest {
    private static final Path STORED = Path.of("worlds", "scenarios");
    private static final Path WANDERING = STORED.resolve("wandering.scenario.jsonl");

    @TempDir
    Path folder;

    private static Map<String, Double> values(ParameterSweep sweep, long index) {
        Outcome outcome = sweep.run(index);
        assertThat(outcome.error()).isNull();
        return outcome.values();
    }

    private static double value(ParameterSweep sweep, long index, String name) {
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
        ParameterSweep sweep =
                ParameterSweep.of(scenario).over(scenario.world()).replicates(2);
        assertThat(value(sweep, 0, "other than recorded")).isZero();
        assertThat(values(sweep, 1)).isEqualTo(values(sweep, 0));
        ParameterSweep zeros =
                sweep.vary("place", "0").vary("aim", "0").vary("slip", "0").vary("range", "0");
        assertThat(values(zeros, 0)).isEqualTo(values(sweep, 0));
    }

    /** A push acts in a sweep as in its recording. */
    @Test
    void pushesAreCarriedOut() throws IOException {
        Session session = new Session();
        InitBundle world = new InitBundle(
                List.of(new BoxObject(new Point(), 1, 1, 1).moveable("crate")),
                new WorldSettings(40, 4, 40, Dimension.PLANAR, Accuracy.EXACT));
        session.reply(world);
        List<Step> steps = new ArrayList<>(List.of(new Step(world, null)));
        Body smooth = Body.of(2, 1).withFloorFriction(0);
        for (StepBundle step : List.of(
                StepBundle.of(0).withBody("crate", smooth, null),
                StepBundle.of(1).withPush("crate", new Point(6, 0, 0), null, null))) {
            steps.add(new Step(step, session.reply(step)));
        }
        Path file = folder.resolve("pushed.scenario.jsonl");
        try (OutputStream out = Files.newOutputStream(file)) {
            new Scenario(new ScenarioHeader("a push", SessionOptions.ROBOSIM), steps).write(out);
        }
        ScenarioSweep scenario = ScenarioSweep.read(file);
        ParameterSweep sweep = ParameterSweep.of(scenario).over(scenario.world());
        assertThat(value(sweep, 0, "other than recorded")).isZero();
        assertThat(value(sweep, 0, "way [world units]")).isCloseTo(3, within(1e-12));
    }

    @ParameterizedTest
    @ValueSource(strings = {"place=0.5", "heading=20", "slip=0.2", "aim=5", "range=0.1"})
    void eachKindOfChanceTells(String parameter) throws IOException {
        ScenarioSweep scenario = ScenarioSweep.read(WANDERING);
        String[] words = parameter.split("=", 2);
        ParameterSweep sweep = ParameterSweep.of(scenario)
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
        ParameterSweep sweep = ParameterSweep.of(scenario)
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
        ParameterSweep sweep =
                ParameterSweep.of(scenario).over(both).over(scenario.world()).vary("accuracy", "EXACT", "SPHERE");
        for (long index = 0; index < 4; index++) {
            assertThat(value(sweep, index, "not answered")).isEqualTo(value(sweep, 1, "not answered"));
        }
    }

    /** A robot beside a wall tries again where its disc reaches it; the next robot's draws are the same all the same. */
    @Test
    void anotherTryOfOneRobotMovesNoOther() throws IOException {
        CylinderObject body = new CylinderObject(new Point(), 0.5, 1);
        InitBundle init = new InitBundle(
                List.of(
                        body.moveable("a"),
                        new BoxObject(new Point(2.1, 0, 0), 2, 1, 8),
                        body.movedTo(new Point(20, 0, 0)).moveable("b")),
                new WorldSettings(100, 10, 100, Dimension.PLANAR, Accuracy.EXACT));
        Path file = folder.resolve("two.scenario.jsonl");
        try (OutputStream out = Files.newOutputStream(file)) {
            new Scenario(new ScenarioHeader("two", SessionOptions.ROBOSIM), List.of(new Step(init, null))).write(out);
        }
        ScenarioSweep scenario = ScenarioSweep.read(file);
        int triedAgain = 0;
        for (int number = 0; number < 50; number++) {
            Point[] near = starts(scenario, number, 0.5);
            Point[] far = starts(scenario, number, 4);
            triedAgain += Math.abs(near[0].x() * 8 - far[0].x()) > 1e-9 ? 1 : 0;
            assertThat((near[1].x() - 20) * 8).isCloseTo(far[1].x() - 20, within(1e-9));
            assertThat(near[1].z() * 8).isCloseTo(far[1].z(), within(1e-9));
        }
        assertThat(triedAgain).isBetween(10, 45);
    }

    private static Point[] starts(ScenarioSweep scenario, int number, double place) {
        Geometry world = scenario.world().snapshot().toGeometry();
        scenario.run(new Replicate(
                world, "two", new TreeMap<>(Map.of("place", String.valueOf(place))), number, 1, 1000 + number));
        return new Point[] {world.getObject("a").center(), world.getObject("b").center()};
    }

    /** Only the recording itself, in another file of its name, has the same results. */
    @Test
    void resultsOfAnotherRecordingAreRefused() throws Exception {
        String text = Files.readString(WANDERING);
        Path file = Files.createDirectories(folder.resolve("other")).resolve("wandering.scenario.jsonl");
        Path results = folder.resolve("results.jsonl");
        ScenarioSweep scenario = ScenarioSweep.read(WANDERING);
        ParameterSweep sweep = ParameterSweep.of(scenario).over(scenario.world());
        SweepRun.of(sweep, results).run();
        Files.writeString(file, text.replaceFirst("\"title\":\"", "\"title\":\"Retold: "));
        assertThat(Files.readString(file)).isNotEqualTo(text);
        ScenarioSweep same = ScenarioSweep.read(file);
        assertThat(SweepRun.of(ParameterSweep.of(same).over(same.world()), results)
                        .resume()
                        .run()
                        .digest())
                .isEqualTo(SweepResults.read(List.of(results)).digest());
        String shorter = text.substring(0, text.stripTrailing().lastIndexOf('\n') + 1);
        Files.writeString(file, shorter.substring(0, shorter.stripTrailing().lastIndexOf('\n') + 1));
        ScenarioSweep other = ScenarioSweep.read(file);
        ParameterSweep changed = ParameterSweep.of(other).over(other.world());
        assertThat(changed.header().worlds()).isEqualTo(sweep.header().worlds());
        assertThatThrownBy(() -> SweepRun.of(changed, results).resume().run())
                .isInstanceOf(SweepException.class)
                .hasMessageContaining("must be of the same sweep");
        Path others = folder.resolve("others.jsonl");
        SweepRun.of(changed, others).run();
        assertThatThrownBy(() -> SweepResults.read(List.of(results, others)))
                .isInstanceOf(SweepException.class)
                .hasMessageContaining("must be of the same sweep");
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
        ParameterSweep wrong = ParameterSweep.of(scenario).over(scenario.world());
        for (String amount : new String[] {"-1", "NaN", "Infinity"}) {
            assertThatThrownBy(() -> wrong.vary("place", "0", amount))
                    .hasMessageContaining("place must be at least 0 and finite (got: " + amount + ")");
        }
        assertThatThrownBy(() -> wrong.vary("mass", "1", "-0")).hasMessageContaining("mass must be above 0 (got: -0)");
        assertThatThrownBy(() -> wrong.vary("place", "near"))
                .hasMessageContaining("place must be a number (got: near)");
        assertThatThrownBy(() -> wrong.vary("plac", "1"))
                .hasMessageContaining(
                        "one of place, heading, slip, aim, range, speed, turn, mass, accuracy, dimension (got: plac)");
        assertThatThrownBy(() -> wrong.vary("accuracy", "fine")).hasMessageContaining("accuracy must be one of");
        assertThatThrownBy(() -> wrong.vary("place", "1", "1")).hasMessageContaining("each once");
        assertThatThrownBy(() -> wrong.vary("a b", "1")).hasMessageContaining("without blanks");
        assertThatThrownBy(() -> wrong.over(scenario.world())).hasMessageContaining("got twice");
        assertThatThrownBy(() -> Shard.parse("4/4")).hasMessageContaining("(n - 1)/n");
        assertThatThrownBy(() -> Shard.parse("a")).hasMessageContaining("as in 0/4");
    }

    /** Where each robot ends is where a replay leaves it, and a goal is reached when its circle is first entered. */
    @Test
    void theRowsHaveTheEndsAndTheTimeToTheGoal() throws IOException {
        ScenarioSweep scenario = ScenarioSweep.read(WANDERING);
        Scenario read = Scenario.read(WANDERING);
        Session session = new Session(read.header().options(), SessionListener.NONE, "test");
        List<Point> places = new ArrayList<>();
        for (Step step : read.steps()) {
            session.reply(step.request());
            places.add(world(session).getObject("drum 1").center());
        }
        Point last = places.get(places.size() - 1);
        Point first = places.get(0);
        double half = Math.hypot(last.x() - first.x(), last.z() - first.z()) / 2;
        assertThat(half).isPositive();
        ParameterSweep sweep = ParameterSweep.of(scenario.toGoal("drum 1", last.x(), last.z(), half)
                        .toGoal("drum 1", first.x(), first.z(), half)
                        .toGoal("drum 2", 1000, 0, 1))
                .over(scenario.world());
        Map<String, Double> values = values(sweep, 0);
        assertThat(values)
                .containsEntry("end x of drum 1 [world units]", last.x())
                .containsEntry("end z of drum 1 [world units]", last.z())
                .containsEntry("time to goal 2 of drum 1 [requests]", 0.0)
                .containsEntry("time to goal 3 of drum 2 [requests]", Double.POSITIVE_INFINITY)
                .doesNotContainKey("end y of drum 1 [world units]");
        int reached = 0;
        while (Math.hypot(
                        places.get(reached).x() - last.x(), places.get(reached).z() - last.z())
                > half) {
            reached++;
        }
        assertThat(values).containsEntry("time to goal 1 of drum 1 [requests]", (double) reached);
        assertThat(sweep.header().print()).isNotEqualTo(scenario.fingerprint());
        assertThatThrownBy(() -> scenario.toGoal("drum9", 0, 0, 1)).hasMessageContaining("one of [\"drum 1\", ");
        assertThatThrownBy(() -> scenario.toGoal("drum 1", 0, 0, 0)).hasMessageContaining("a finite radius above 0");
    }

    private static Geometry world(Session session) {
        Geometry world = session.world();
        assertThat(world).isNotNull();
        return world;
    }

    @Test
    void itKnowsWhereReplicatesCannotDiffer() throws IOException {
        ScenarioSweep scenario = ScenarioSweep.read(WANDERING);
        ParameterSweep sweep =
                ParameterSweep.of(scenario).over(scenario.world()).replicates(3);
        assertThat(sweep.canDiffer()).isFalse();
        assertThat(sweep.replicates(1).canDiffer()).isTrue();
        assertThat(sweep.vary("speed", "1", "2").canDiffer()).isFalse();
        assertThat(sweep.vary("place", "0").vary("slip", "0").canDiffer()).isFalse();
        for (String parameter : List.of("place", "heading", "slip", "aim", "range")) {
            ParameterSweep varied = sweep.vary(parameter, "0", "0.5").vary("speed", "1", "2");
            assertThat(varied.canDiffer()).as(parameter).isTrue();
            assertThat(values(varied, 1)).as(parameter).isNotEqualTo(values(varied, 5));
        }
        // What is not requested cannot vary.
        ScenarioSweep turns = ScenarioSweep.read(STORED.resolve("by-hand.scenario.jsonl"));
        ParameterSweep deaf =
                ParameterSweep.of(turns).over(turns.world()).replicates(2).vary("range", "1");
        assertThat(deaf.canDiffer()).isEqualTo(!values(deaf, 0).equals(values(deaf, 1)));
        assertThat(Sweeps.wander(0).replicates(2).canDiffer()).isTrue();
    }
}
