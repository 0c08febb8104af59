package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.platform.engine.TestExecutionResult;
import org.opentest4j.AssertionFailedError;
import robosim.geometry.Geometry;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.Step;

/** What a test is given, and what it leaves when it fails. */
@Tag("slow")
@World("worlds/rooms.xml")
class WorldExtensionTest {
    private RobotWorld before;

    @BeforeEach
    void keep(RobotWorld world) {
        before = world;
    }

    @Test
    void aTestAndWhatGoesBeforeItShareOneWorld(
            RobotWorld world, Geometry geometry, VirtualClock clock, Clock time, RandomGenerator random) {
        assertThat(world).isSameAs(before);
        assertThat(geometry).isSameAs(world.geometry());
        assertThat(clock).isSameAs(world.clock()).isSameAs(time);
        assertThat(clock.step()).isEqualTo(Duration.ofMillis(100));
        assertThat(random).isNotNull();
        world.robot("drum 1").drives(0.5).turns(90).senses(0, 5);
    }

    @Test
    @World(value = "worlds/maze.xml", stepMillis = 20)
    @Seed(42)
    void aMethodHasItsOwn(RobotWorld world, SplittableRandom splittable, Random random) {
        world.clock().advance(3);
        assertThat(world.clock().instant()).isEqualTo(Instant.ofEpochMilli(60));
        assertThat(world.geometry().hasObject("drum 1")).isFalse();
        assertThat(splittable.nextLong()).isEqualTo(new SplittableRandom(42).nextLong());
        assertThat(random.nextLong()).isEqualTo(new Random(42).nextLong());
    }

    /** Inherits the world of the class around it. */
    @Nested
    class Inside {
        @Test
        void theWorldOfTheOuterClassIsThere(RobotWorld world) {
            assertThat(world).isSameAs(before);
            assertThat(world.robots()).hasSize(8);
        }
    }

    private static Map<String, TestExecutionResult> fail(Path folder, Map<String, String> more) {
        Map<String, String> configuration = new HashMap<>(more);
        configuration.put("robosim.evidence", folder.toString());
        return Launched.run(Doomed.Failing.class, configuration);
    }

    private static Path folder(Path folder, String test) {
        return folder.resolve(Doomed.class.getName() + ".Failing." + test);
    }

    @Test
    void aFailureNamesItsSeedAndLeavesAScenarioThatReplaysIt(@TempDir Path folder) throws IOException {
        TestExecutionResult result = fail(folder, Map.of()).get("blocked");
        Path file = folder(folder, "blocked").resolve("replay.scenario.jsonl");
        assertThat(Launched.message(result))
                .startsWith("robot \"r1\" was to drive 3.5, but is blocked after ")
                .contains("by box \"wall\" at (4, 0, 0)")
                .endsWith("\n  seed:   7 (as @Seed(7L) or -Drobosim.seed=7)\n  replay: " + file + "\n  image:  "
                        + file.resolveSibling("last-moments.svg") + "\n  png:    "
                        + file.resolveSibling("last-moments.png") + "\n  page:   "
                        + file.resolveSibling("last-moments.html"));
        assertThat(folder(folder, "blocked").resolve("failure.txt")).content().contains("is blocked after");
        Scenario scenario = Scenario.read(file);
        assertThat(scenario.header().title()).endsWith("Failing.blocked, seed 7");
        assertThat(Replay.of(scenario)).isEmpty();
        assertThat(scenario.steps()).hasSize(3);
        Step last = scenario.steps().get(2);
        assertThat(last.expected().bundle()).as("the move that was blocked").isEqualTo(new MoveBundle(List.of()));
        assertThat(((MoveBundle) last.request()).moves().get(0).x()).isEqualTo(3.5);
    }

    @Test
    void anotherSeedIsAskedForFromOutside(@TempDir Path folder) {
        Map<String, TestExecutionResult> results = fail(folder, Map.of("robosim.seed", "99"));
        assertThat(Launched.message(results.get("blocked"))).contains("seed:   99 (");
        Map<String, TestExecutionResult> wrong = fail(folder, Map.of("robosim.seed", "many"));
        assertThat(Launched.message(wrong.get("passes"))).contains("robosim.seed must be a whole number (got: many)");
    }

    @Test
    void aComparisonStaysOneAndAnExceptionBecomesAFailureWithItsCause(@TempDir Path folder) throws IOException {
        Map<String, TestExecutionResult> results = fail(folder, Map.of());
        AssertionFailedError compared =
                (AssertionFailedError) results.get("compared").getThrowable().orElseThrow();
        assertThat(compared.getExpected().getValue()).isEqualTo(4.0);
        assertThat(compared.getActual().getValue()).isEqualTo(3.5);
        assertThat(compared).hasMessageContaining("replay: ");
        Throwable broken = results.get("broken").getThrowable().orElseThrow();
        assertThat(broken)
                .hasMessageStartingWith("java.lang.IllegalStateException: out of luck\n  seed:   ")
                .hasCauseInstanceOf(IllegalStateException.class);
        Scenario left = Scenario.read(folder(folder, "broken").resolve("replay.scenario.jsonl"));
        assertThat(left.steps()).as("the world before and after").hasSize(2);
    }

    @Test
    void whatIsNoFailureLeavesNothing(@TempDir Path folder) throws IOException {
        Path stale = folder(folder, "passes").resolve("replay.scenario.jsonl");
        Files.createDirectories(stale.getParent());
        Files.writeString(stale, "of a run before");
        Map<String, TestExecutionResult> results = fail(folder, Map.of());
        assertThat(results.get("passes").getStatus()).isEqualTo(TestExecutionResult.Status.SUCCESSFUL);
        assertThat(results.get("assumed").getStatus()).isEqualTo(TestExecutionResult.Status.ABORTED);
        assertThat(stale).doesNotExist();
        assertThat(folder(folder, "assumed")).doesNotExist();
    }

    @Test
    void aWorldThatCannotBeHadIsToldByItsName() {
        Map<String, TestExecutionResult> results = Launched.run(Doomed.Misplaced.class, Map.of());
        assertThat(Launched.message(results.get("unknown"))).contains("@World must name a file", "(got: nowhere.xml)");
        assertThat(Launched.message(results.get("several"))).contains("one file except on a @ScenarioTest (got: 2)");
        assertThat(Launched.message(results.get("method"))).contains("must name a static method", "(got: missing)");
        assertThat(Launched.message(results.get("neither"))).contains("either files or a method (got: neither)");
        assertThat(Launched.message(results.get("schema")))
                .as("found on the class path, and refused by the reader")
                .contains("the world of @World cannot be had", "world.xsd");
    }

    @Test
    void aScenarioTestIsCarriedOutForEachWorldWithEachSeed(@TempDir Path folder) {
        Map<String, TestExecutionResult> results =
                Launched.run(Doomed.Manifold.class, Map.of("robosim.evidence", folder.toString()));
        assertThat(results.keySet())
                .containsExactly(
                        "worlds/rooms.xml, seed 1",
                        "worlds/rooms.xml, seed 2",
                        "worlds/rooms.xml, seed 3",
                        "worlds/warehouse.xml, seed 1",
                        "worlds/warehouse.xml, seed 2",
                        "worlds/warehouse.xml, seed 3");
        assertThat(results.values().stream().map(Launched::message).distinct()).hasSize(6);
        assertThat(Launched.message(results.get("worlds/warehouse.xml, seed 2")))
                .contains("@Seed(2L)");
        assertThat(folder).isDirectoryContaining(path -> path.toString().endsWith("Manifold.each-6"));
    }

    @Test
    void aServerNeedsNoWorld() {
        for (Class<?> tests : List.of(Doomed.Served.class, Doomed.Extended.class)) {
            assertThat(Launched.run(tests, Map.of()).get("served").getStatus())
                    .as(tests.getSimpleName())
                    .isEqualTo(TestExecutionResult.Status.SUCCESSFUL);
        }
    }

    @Test
    void aServerForAClientIsThereUntilTheTestHasEnded(@TempDir Path folder) throws IOException {
        Map<String, TestExecutionResult> results =
                Launched.run(Doomed.Talking.class, Map.of("robosim.evidence", folder.toString()));
        Path talk = folder.resolve(Doomed.class.getName() + ".Talking.talks").resolve("connection-1.scenario.jsonl");
        assertThat(Launched.message(results.get("talks")))
                .startsWith("{\"type\":\"distances\",\"distances\":[3.5]")
                .endsWith("\n  talk:   " + talk + "\n  image:  " + talk.resolveSibling("connection-1.svg")
                        + "\n  png:    " + talk.resolveSibling("connection-1.png")
                        + "\n  page:   " + talk.resolveSibling("connection-1.html"));
        Scenario scenario = Scenario.read(talk);
        assertThat(scenario.steps()).hasSize(2);
        assertThat(Replay.of(scenario)).isEmpty();
        assertThatThrownBy(() -> new Socket(InetAddress.getLoopbackAddress(), Doomed.Talking.port).close())
                .isInstanceOf(ConnectException.class);
    }
}
