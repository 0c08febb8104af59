package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.ChildJvm;
import robosim.geometry.cli.studies.SweepCommand;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.sweep.Replicate;
import robosim.geometry.sweep.Result;
import robosim.geometry.sweep.SweepScenario;
import robosim.geometry.sweep.Wander;

@Tag("clock")
@Timeout(60)
class SweepCommandTest extends CommandRun {
    private static final String SCENARIO = "worlds/scenarios/wandering.scenario.jsonl";
    private static final Pattern DIGEST = Pattern.compile("digest ([0-9a-f]{64})");

    private String digest() {
        Matcher digest = DIGEST.matcher(out.toString());
        assertThat(digest.find()).as(out.toString()).isTrue();
        return digest.group(1);
    }

    /** With proofs the results are the same to the bit. */
    @Test
    void aShareOfTheAnswersIsProved() throws IOException {
        Object[] words = {"sweep", SCENARIO, "-n", 2, "-p", "slip=0.1", "--digest", "-o"};
        assertThat(run(with(words, folder.resolve("plain.jsonl")))).isZero();
        String plain = digest();
        assertThat(out.toString()).doesNotContain("proofs:");
        assertThat(run(with(words, folder.resolve("proved.jsonl"), "--prove", "0.05")))
                .isZero();
        assertThat(digest()).isEqualTo(plain);
        assertThat(out.toString()).containsPattern("proofs: [1-9][0-9]+ hold, [0-9]+ answers have none, 0 failed");
    }

    private static Object[] with(Object[] words, Object... more) {
        return Stream.concat(Arrays.stream(words), Arrays.stream(more)).toArray();
    }

    @Test
    void aScenarioFile() throws IOException {
        Path results = folder.resolve("results.jsonl");
        Path plot = folder.resolve("plot.svg");
        Path table = folder.resolve("table.md");
        int code = run(
                "sweep",
                SCENARIO,
                "-n",
                5,
                "-p",
                "place=0,0.5",
                "-p",
                "aim=0,5",
                "--threads",
                2,
                "-o",
                results,
                "--plot",
                plot,
                "--table",
                table,
                "--digest");
        assertThat(err.toString()).isEmpty();
        assertThat(code).isZero();
        assertThat(out.toString()).contains("| moves made", "20 replicates on 2 threads");
        assertThat(Files.readAllLines(results)).hasSize(21);
        assertThat(Files.readString(plot)).startsWith("<svg").contains("[world units]");
        assertThat(out.toString()).startsWith(Files.readString(table));
        String digest = digest();
        assertThat(run(
                        "sweep",
                        SCENARIO,
                        "-n",
                        5,
                        "-p",
                        "place=0,0.5",
                        "-p",
                        "aim=0,5",
                        "-o",
                        results,
                        "--resume",
                        "--digest"))
                .isZero();
        assertThat(out.toString()).contains("0 replicates on", "20 done before");
        assertThat(digest()).isEqualTo(digest);
        assertThat(run("sweep", SCENARIO, "-n", 5, "-o", results)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("must be a new file");
    }

    /** A sweep that is stopped by a signal tells the command that goes on, and that command does. */
    @Test
    @EnabledOnOs({OS.LINUX, OS.MAC})
    void aStoppedSweepSaysHowToGoOn() throws Exception {
        Path results = folder.resolve("a b.jsonl");
        Path said = folder.resolve("said");
        Process sweep = new ProcessBuilder(
                        ChildJvm.running(Main.class, "sweep", SCENARIO, "-n", "2000000", "-o", results.toString()))
                .redirectErrorStream(true)
                .redirectOutput(said.toFile())
                .start();
        try {
            while (!Files.exists(results) || Files.size(results) < 2000) {
                assertThat(sweep.isAlive()).as(said + "").isTrue();
                Thread.sleep(20);
            }
        } finally {
            sweep.destroy();
        }
        assertThat(sweep.waitFor()).isEqualTo(128 + 15);
        assertThat(said)
                .content()
                .containsPattern("Stopped after [1-9][0-9,]* of 2,000,000 replicates, which are in ")
                .endsWith("robosim-geometry sweep " + SCENARIO + " -n 2000000 -o '" + results + "' --resume\n");
        assertThat(run("sweep", SCENARIO, "-n", 2_000_000, "-o", results)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("--out must be a new file, or --resume must be given");
    }

    /** A file of another format is a world too, with the folders of its models. */
    @Test
    void aWorldOfAnotherFormat() throws IOException {
        Path model = Files.createDirectories(folder.resolve("models/post"));
        Files.writeString(model.resolve("model.config"), "<model><name>post</name><sdf>model.sdf</sdf></model>");
        Files.writeString(model.resolve("model.sdf"), """
                <sdf version="1.6"><model name="post"><static>1</static><link name="l"><collision name="c"><geometry>
                <cylinder><radius>0.2</radius><length>1</length></cylinder>
                </geometry></collision></link></model></sdf>""");
        Path world = Files.writeString(folder.resolve("yard.sdf"), """
                <sdf version="1.6"><world name="yard">
                <include><uri>model://post</uri><pose>2 1 0 0 0 0</pose></include>
                <model name="robot"><link name="l"><collision name="c"><geometry>
                <box><size>0.4 0.4 0.4</size></box></geometry></collision></link></model>
                </world></sdf>""");
        int code = run(
                "sweep",
                Wander.class.getName(),
                world,
                "-n",
                2,
                "-o",
                folder.resolve("r.jsonl"),
                "--models",
                folder.resolve("models"));
        assertThat(err.toString()).isEmpty();
        assertThat(code).isIn(ExitCodes.FINE, ExitCodes.FINDINGS);
        assertThat(out.toString()).contains("2 replicates on");
    }

    @Test
    void shardsOfAClassAreMerged() {
        String name = Wander.class.getName();
        Path whole = folder.resolve("whole.jsonl");
        // One in 40 fails, which is told.
        assertThat(run("sweep", name, "worlds/rooms.xml", "worlds/maze.xml", "-n", 40, "-o", whole, "--digest"))
                .isEqualTo(ExitCodes.FINDINGS);
        assertThat(out.toString())
                .containsPattern(
                        "\n[2-9] replicates failed:\n  java.lang.IllegalStateException: a flat battery\n"
                                + "    [2-9] times, first in index \\d+: world (rooms|maze), replicate \\d+, seed 0x[0-9a-f]{16}\n");
        String digest = digest();
        Path[] parts = new Path[3];
        for (int k = 0; k < 3; k++) {
            parts[k] = folder.resolve("part-" + k);
            run("sweep", name, "worlds/rooms.xml", "worlds/maze.xml", "-n", 40, "--shard", k + "/3", "-o", parts[k]);
        }
        assertThat(run("sweep", "merge", parts[2], parts[0], "--digest")).isEqualTo(ExitCodes.FINDINGS);
        assertThat(out.toString()).containsPattern("2[5-8] of 80 replicates are missing");
        assertThat(digest()).isNotEqualTo(digest);
        Path merged = folder.resolve("merged.jsonl");
        run("sweep", "merge", parts[2], parts[0], parts[1], "--digest", "-o", merged);
        assertThat(digest()).isEqualTo(digest);
        assertThat(merged).hasSameTextualContentAs(whole);
    }

    /** One that fails in a way of its own for each world and step, at times in many lines. */
    public static final class Fussy implements SweepScenario {
        private static final long serialVersionUID = 1;

        /** As the command makes it. */
        public Fussy() {}

        @Override
        public Result run(Replicate replicate) {
            if (replicate.has("step") && replicate.number("step") < 1 && replicate.number() % 4 == 1) {
                return Result.of("v", 1);
            }
            throw new AssertionError("no step of " + (replicate.has("step") ? replicate.text("step") : "none")
                    + "\nand more of it\u0007");
        }
    }

    /** The first few errors, each with the replicate that met it first; the order of the threads is none of theirs. */
    @Test
    void whyReplicatesFailIsToldOnce() throws IOException {
        Path results = folder.resolve("results.jsonl");
        String name = Fussy.class.getName();
        assertThat(run("sweep", name, "worlds/rooms.xml", "-n", 8, "-p", "step=0,1,2,3,4", "-o", results))
                .isEqualTo(ExitCodes.FINDINGS);
        String told = out.toString();
        assertThat(told.substring(told.indexOf("38 replicates failed"), told.indexOf("40 replicates on")))
                .matches("""
                        38 replicates failed:
                          java.lang.AssertionError: no step of 0 ...
                            6 times, first in index 0: world rooms, step=0, replicate 0, seed 0x[0-9a-f]{16}
                          java.lang.AssertionError: no step of 1 ...
                            8 times, first in index 1: world rooms, step=1, replicate 0, seed 0x[0-9a-f]{16}
                          java.lang.AssertionError: no step of 2 ...
                            8 times, first in index 2: world rooms, step=2, replicate 0, seed 0x[0-9a-f]{16}
                          and 16 with other errors
                        For the full errors, see the lines in the results whose "type" is "failure".
                        """);
        String seed = told.replaceAll("(?s).*?index 1:.*?(0x[0-9a-f]{16}).*", "$1");
        assertThat(Files.readAllLines(results))
                .anyMatch(line -> line.contains("\"index\":1,") && line.contains("\"seed\":\"" + seed + "\""));
        assertThat(run("sweep", "merge", results)).isEqualTo(ExitCodes.FINDINGS);
        assertThat(out.toString()).contains("no step of 2 ...", "and 16 with other errors");
        Path single = folder.resolve("single.jsonl");
        assertThat(run("sweep", name, "worlds/rooms.xml", "-n", 1, "-o", single))
                .isEqualTo(ExitCodes.FINDINGS);
        assertThat(out.toString())
                .containsPattern(
                        "1 replicate failed:\n.*no step of none \\.\\.\\.\n    in index 0: world rooms, replicate 0");
    }

    @Test
    void badUsageIsToldInASentence() {
        assertThat(run("sweep")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("SCENARIO must be given");
        assertThat(run("sweep", "no.such.Scenario", "worlds/rooms.xml")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("there is none of that name");
        assertThat(run("sweep", "java.lang.Object", "worlds/rooms.xml")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("must be a class that implements");
        assertThat(run("sweep", Wander.class.getName())).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("WORLD must be given for a class");
        assertThat(run("sweep", "missing.scenario.jsonl")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("that exists; check the path");
        assertThat(run("sweep", SCENARIO, "--shard", "3/3")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("shard must be from 0/n to (n - 1)/n");
        assertThat(run("sweep", "merge", "missing.jsonl")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(run("sweep", "--help")).isZero();
        assertThat(out.toString()).contains("--shard=I/N", "merge", "Parameters of a scenario file");
    }

    /** What would be another sweep than the one that was meant is refused before there is a file. */
    @Test
    void badParametersAreToldBeforeAnythingIsDone() {
        Path results = folder.resolve("results.jsonl");
        String[][] bad = {
            {"plac=1", "one of place, heading, slip, aim, range, speed, turn, mass, accuracy, dimension (got: plac)"},
            {"place=-1", "place must be at least 0"},
            {"place=near", "place must be a number"},
            {"place", "--parameter must be NAME=VALUE[,VALUE...] (got: place)"},
            {"=1", "--parameter must be NAME=VALUE[,VALUE...] (got: =1)"},
            {"accuracy=fine", "accuracy must be one of"},
        };
        for (String[] each : bad) {
            assertThat(run("sweep", SCENARIO, "-n", 1, "-p", each[0], "-o", results))
                    .as(each[0])
                    .isEqualTo(ExitCodes.UNUSABLE);
            assertThat(err.toString()).contains(each[1]);
        }
        assertThat(run("sweep", SCENARIO, "-n", 1, "-p", "place=0", "-p", "place=1", "-o", results))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("--parameter must name each parameter once", "(got: place again)");
        assertThat(results).doesNotExist();
    }

    /** A scenario that cannot be made. */
    public static final class Unmade implements SweepScenario {
        private static final long serialVersionUID = 1;

        /** Fails. */
        public Unmade() {
            throw new IllegalStateException("no file docking.properties");
        }

        @Override
        public Result run(Replicate replicate) {
            return Result.of("v", 1);
        }
    }

    @Test
    void aConstructorThatFailsTellsWhy() {
        assertThat(run("sweep", Unmade.class.getName(), "worlds/rooms.xml")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("which failed with java.lang.IllegalStateException: no file docking.prop");
    }

    @Test
    void tellsHowLongItStillTakes() {
        assertThat(SweepCommand.left(1_000_000_000L, 0, 10)).isEmpty();
        assertThat(SweepCommand.left(10_000_000_000L, 10, 30)).isEqualTo("30 s left");
        assertThat(SweepCommand.left(10_000_000_000L, 10, 90)).isEqualTo("1 min 30 s left");
        assertThat(SweepCommand.left(10_000_000_000L, 10, 7260)).isEqualTo("2 h 1 min left");
    }

    /** A world that was meant for something else would be lost. */
    @ParameterizedTest
    @CsvSource({"--table, .md", "--plot, .svg", "--csv, .csv"})
    void reportsHaveTheirEndings(String option, String ending) throws IOException {
        Path world = Files.writeString(folder.resolve("w.xml"), "<world/>");
        assertThat(run(
                        "sweep",
                        "worlds/scenarios/wandering.scenario.jsonl",
                        "-n",
                        "1",
                        "-o",
                        folder.resolve("s.jsonl"),
                        option,
                        world))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith(option + " must end in " + ending + " (got: " + world + ")");
        assertThat(world).hasContent("<world/>");
    }

    @Test
    void replicatesThatCannotDifferAreToldAndRowsAreWrittenAsCsv() throws IOException {
        Path csv = folder.resolve("s.csv");
        assertThat(run(
                        "sweep",
                        SCENARIO,
                        "-n",
                        3,
                        "-p",
                        "place=0",
                        "--goal",
                        "drum 1@1000,0,1",
                        "-o",
                        folder.resolve("s.jsonl"),
                        "--csv",
                        csv))
                .isZero();
        assertThat(err.toString())
                .startsWith("warning: the 3 replicates of each world and combination of values cannot");
        assertThat(out.toString())
                .contains("The replicates of each world and combination of values are all the same")
                .contains("| time to goal of drum 1 [requests] |")
                .doesNotContain("| end x");
        List<String> lines = Files.readAllLines(csv);
        assertThat(lines).hasSize(4);
        assertThat(lines.get(0))
                .startsWith("index,world,place,replicate,seed,moves made,")
                .contains(",time to goal of drum 1 [requests],end x of drum 1 [world units],")
                .endsWith(",error");
        List<String> heads = List.of(lines.get(0).split(",", -1));
        List<String> row = List.of(lines.get(2).split(",", -1));
        assertThat(row).hasSameSizeAs(heads).startsWith("1", "wandering", "0", "1");
        assertThat(row.get(heads.indexOf("time to goal of drum 1 [requests]"))).isEmpty();
        assertThat(Double.parseDouble(row.get(heads.indexOf("end x of drum 1 [world units]"))))
                .isBetween(-20.0, 20.0);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            drum 1@1,2   | --goal must be ROBOT@X,Z,RADIUS, as in cart@4,-2,0.5 (got: drum 1@1,2)
            drum@1,2,1   | --goal: robot of a goal must be a moveable object of wandering, one of ["drum 1",
            drum 1@1,x,1 | --goal must be ROBOT@X,Z,RADIUS, as in
            drum 1@1,2,0 | --goal: goal must be at finite x and z, with a finite radius above 0
            """)
    void aWrongGoalIsRefused(String goal, String reason) {
        assertThat(run("sweep", SCENARIO, "--goal", goal, "-o", folder.resolve("s.jsonl")))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith(reason);
    }
}
