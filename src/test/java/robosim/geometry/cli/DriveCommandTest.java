package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Scenario;

/** The command that drives robots. */
class DriveCommandTest {
    private static final String WORLD = "worlds/pushing.xml";

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return Commands.run(new PrintWriter(out), new PrintWriter(err), arguments);
    }

    @Test
    void aRobotPushesWhatIsInItsWay() {
        assertThat(run("drive", WORLD, "--robot", "cart", "--speed", "0.8", "--seconds", "12"))
                .as(err.toString())
                .isLessThan(2);
        assertThat(out.toString())
                .containsPattern("\"cart\" at \\([0-9.]+, [-0-9.]+\\).* m/s, after .* m; met \"crate 1\"")
                .contains("\"mule\" at (-4, 2), heading 30, 0 m/s, after 0 m\n")
                .contains("12 s in 240 steps, ", "cart");
    }

    /** What turns a force is a torque: 0.5 N m on 1 kg m^2 turn by 0.25 rad in a second. */
    @Test
    void aTorqueIsInNewtonMetres(@TempDir Path folder) throws IOException {
        Path world = Files.writeString(folder.resolve("w.xml"), """
                <world xmlns="urn:robosim:world:1" width="20" height="5" length="20" dimension="PLANAR">
                  <cylinder radius="0.5" height="1" name="tug" moveable="true">
                    <body mass="5" inertia="1"><drive kind="force"/></body>
                  </cylinder>
                </world>
                """);
        for (String[] command : new String[][] {{"--robot", "tug", "--turn", "0.5"}, {"--tell", "tug=0,0.5"}}) {
            out.getBuffer().setLength(0);
            List<String> all = new ArrayList<>(List.of("drive", world.toString(), "--seconds", "1"));
            all.addAll(List.of(command));
            assertThat(run(all.toArray(new String[0]))).as(err.toString()).isLessThan(2);
            assertThat(out.toString()).contains(", heading 14.3239, ");
        }
    }

    @Test
    void aDriveIsRecordedAndReplayedToTheBit(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("out.scenario.jsonl");
        assertThat(run(
                        "drive",
                        WORLD,
                        "--tell",
                        "cart=0.8,5",
                        "--tell",
                        "mule=1,-20",
                        "--seconds",
                        "6.02",
                        "--record",
                        file.toString()))
                .as(err.toString())
                .isLessThan(2);
        assertThat(out.toString()).contains("6.02 s in 121 steps");
        Scenario scenario = Scenario.read(file);
        assertThat(scenario.steps()).hasSize(2 + 121);
        assertThat(Replay.of(scenario)).isEmpty();
        StepBundle.Answer last = (StepBundle.Answer)
                java.util.Objects.requireNonNull(scenario.steps().get(122).expected())
                        .bundle();
        assertThat(last.bodies()).hasSize(6);
        assertThat(run("replay", file.toString())).isZero();
        Path page = folder.resolve("out.html");
        assertThat(run("export", file.toString(), page.toString()))
                .as(err.toString())
                .isZero();
        assertThat(Files.size(page)).isGreaterThan(10_000);
        assertThat(run("drive", WORLD, "--record", file.toString())).isEqualTo(2);
        assertThat(err.toString()).contains("--record must be a new file");
    }

    @Test
    void everyMoveableObjectMayBePushed() {
        assertThat(run(
                        "drive",
                        "worlds/rooms.xml",
                        "--robot",
                        "drum 1",
                        "--push",
                        "--mass",
                        "drum 2=3",
                        "--seconds",
                        "2"))
                .as(err.toString())
                .isZero();
        assertThat(out.toString().lines().filter(line -> line.contains(" m/s, after ")))
                .hasSize(8);
    }

    /** Where heights do not count, a floor is in the way of what stands on it. */
    @Test
    void aFloorUnderARobotInPlanIsNamed(@TempDir Path folder) throws IOException {
        Path world = Files.writeString(
                folder.resolve("floor.xml"),
                "<world xmlns='urn:robosim:world:1' width='20' height='4' length='20' dimension='SPATIAL'>"
                        + "<box name='floor' center='0 -1 0' width='10' height='1' length='10'/>"
                        + "<cylinder name='scout' moveable='true' center='0 0.01 0' radius='0.3' height='1'/></world>");
        assertThat(run("drive", world.toString(), "--seconds", "1"))
                .as(err.toString())
                .isZero();
        assertThat(out.toString()).doesNotContain("in plan");
        assertThat(run("drive", world.toString(), "--seconds", "1", "--planar")).isZero();
        assertThat(out.toString())
                .contains(
                        "\"scout\" overlaps box \"floor\" in plan, where heights do not count: take it out of the world,"
                                + " put the robot elsewhere, or drive without --planar\n");
        Files.writeString(world, Files.readString(world).replace("SPATIAL", "PLANAR"));
        assertThat(run("drive", world.toString(), "--seconds", "1")).isZero();
        assertThat(out.toString()).contains("or make the world one with dimension=\"SPATIAL\"\n");
    }

    @Test
    void whatCannotBeIsRefused() {
        assertThat(run("drive", WORLD, "--robot", "wall east")).isEqualTo(2);
        assertThat(err.toString()).contains("--robot must name a moveable object of the world, one of [\"cart\"");
        assertThat(run("drive", WORLD, "--tell", "cart=fast")).isEqualTo(2);
        assertThat(err.toString()).contains("--tell must be NAME=SPEED[,TURN], as in cart=0.5,10 (got: cart=fast)");
        assertThat(run("drive", WORLD, "--mass", "cart=-3")).isEqualTo(2);
        assertThat(err.toString()).contains("--mass: mass must be");
        assertThat(run("drive", WORLD, "--mass", "cart=0")).isEqualTo(2);
        assertThat(err.toString())
                .contains("--mass must be above 0; leave it out for the mass of the shape (got: cart=0)");
        assertThat(run("drive", WORLD, "--seconds", "0")).isEqualTo(2);
        assertThat(err.toString()).contains("--seconds and --step must be above 0");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', textBlock = """
                    --speed NaN                  | --speed must be from -10^9 to 10^9 (got: NaN)
                    --turn Infinity              | --turn must be from -10^9 to 10^9 (got: Infinity)
                    --tell cart=NaN              | --tell must be from -10^9 to 10^9 (got: NaN)
                    --tell cart=1,2e9            | --tell must be from -10^9 to 10^9 (got: 2.0E9)
                    --tell cart=1,               | --tell must be NAME=SPEED[,TURN], as in cart=0.5,10 (got: cart=1,)
                    --tell cart=1,2,3            | --tell must be NAME=SPEED[,TURN], as in cart=0.5,10 (got: cart=1,2,3)
                    --tell cart                  | --tell must be NAME=SPEED[,TURN], as in cart=0.5,10 (got: cart)
                    --tell pad=1                 | --tell must name a moveable object of the world, one of
                    --tell cart=1,0 --robot cart | has a command already (got: --tell=cart=1,0)
                    --tell cart=1 --tell cart=2  | has a command already (got: --tell=cart=2)
                    --robot cart --robot cart    | has a command already (got: --robot=cart)
                    --mass cart                  | --mass must be NAME=KG, as in crate=8 (got: cart)
                    --mass cart=heavy            | --mass must be NAME=KG, as in crate=8 (got: cart=heavy)
                    --mass pad=1                 | --mass must name a moveable object of the world, one of
                    """)
    void theMessageNamesTheOption(String options, String reason) {
        assertThat(run(("drive " + WORLD + " " + options).split(" "))).isEqualTo(2);
        assertThat(err.toString()).contains(reason).doesNotContain("option option");
        assertThat(out.toString()).isEmpty();
    }

    @Test
    void theTurnMayBeLeftOut() {
        assertThat(run("drive", WORLD, "--tell", "cart=1", "--seconds", "1")).isZero();
        String straight = out.toString();
        out.getBuffer().setLength(0);
        assertThat(run("drive", WORLD, "--tell", "cart=1,0", "--seconds", "1")).isZero();
        assertThat(straight).isEqualTo(out.toString()).contains("\"cart\" at (", "1 m/s, after ");
    }

    /** One after the other as they stand in the help, since a later one reads what an earlier one writes; in a folder of its own. */
    @Test
    void theExamplesOfTheHelpDoWhatTheySay(@TempDir Path folder) {
        String recording = folder.resolve("out.scenario.jsonl").toString();
        int driven = 0;
        int repeated = 0;
        for (String line : Commands.line(false)
                .getSubcommands()
                .get("drive")
                .getCommandSpec()
                .usageMessage()
                .footer()) {
            String[] words =
                    line.strip().replace("out.scenario.jsonl", recording).split(" +");
            String[] arguments = Arrays.copyOfRange(words, 1, words.length);
            if (arguments[0].equals("view")) {
                // Opens a window; the page for a browser reads the same recording.
                arguments = new String[] {
                    "export", recording, folder.resolve("out.html").toString()
                };
            }
            assertThat(run(arguments)).as("%s: %s", line, err).isZero();
            driven += arguments[0].equals("drive") ? 1 : 0;
            repeated += arguments[0].equals("replay") ? 1 : 0;
        }
        assertThat(driven).isEqualTo(2);
        assertThat(repeated).isEqualTo(1);
    }
}
