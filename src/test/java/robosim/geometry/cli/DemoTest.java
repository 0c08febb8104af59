package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.motion.BodyAnswer;

/** The main job on a small world, as two processes over TCP: environment, module, audit, picture, summary. */
@Tag("slow")
class DemoTest {
    private static final String WORLD = """
        <world xmlns="urn:robosim:world:1" width="8" height="3" length="6" unit="m" dimension="PLANAR">
          <box center="0 0 -2.9" width="8" height="2" length="0.2"/>
          <box center="0 0 2.9" width="8" height="2" length="0.2"/>
          <box center="-3.9 0 0" width="0.2" height="2" length="6"/>
          <box center="3.9 0 0" width="0.2" height="2" length="6"/>
          <box name="screen" center="0.5 0 0.4" heading="30" width="2.5" height="2" length="0.1"/>
          <cylinder name="pole" center="-1.5 0 -1" radius="0.2" height="2"/>
          <cylinder name="drum" moveable="true" center="-2.5 0 1" radius="0.3" height="1">
            <sonar count="8" min="0.05" max="3" width="30"/>
          </cylinder>
          <box name="cart" moveable="true" center="2 0 -1.5" heading="90" width="0.7" height="1" length="0.5">
            <sonar count="5" first="-60" step="30" min="0.05" max="4" width="0"/>
          </box>
        </world>
        """;

    /** An auditor that doubts everything, and takes no time. */
    private static final String DOUBTING = """
        class ConversationAudit {
            public static void main(String[] a) {
                System.out.println("1 FAULTS");
                System.exit(1);
            }
        }
        """;

    /** What one run leaves, for all tests that only read it. */
    @TempDir
    static Path recorded;

    private static int code;
    private static String said;
    private static String complained;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    @BeforeAll
    static void record() throws Exception {
        DemoTest run = new DemoTest();
        code = run.demo(recorded);
        said = run.out.toString();
        complained = run.err.toString();
    }

    private int demo(Path folder, String... more) throws Exception {
        Path world = folder.resolve("small.xml");
        Files.writeString(world, WORLD);
        String[] arguments = new String[9 + more.length];
        System.arraycopy(
                new String[] {
                    "demo", "--world", world.toString(), "--steps", "200", "--speed", "0.1", "-o", folder.toString()
                },
                0,
                arguments,
                0,
                9);
        System.arraycopy(more, 0, arguments, 9, more.length);
        return Commands.run(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
    }

    @Test
    void twoHundredStepsOnASmallWorldAreAllRight() throws Exception {
        assertThat(complained).isEmpty();
        assertThat(said).contains("nothing is wrong", "200 steps of 2 robots");
        assertThat(code).isZero();
        assertThat(recorded.resolve("world.svg")).content().contains("drum", "refusal", "ping", "scale-bar");
        assertThat(recorded.resolve("world.png")).isNotEmptyFile();
        assertThat(Files.readString(recorded.resolve("summary.txt"))).contains("400 asked", "2,613 answered");
        Properties audit = properties(recorded.resolve("audit.properties"));
        assertThat(audit).containsEntry("faults", "0").containsEntry("moves.asked", "400");
        // A walk that meets nothing, or goes nowhere, would prove nothing.
        assertThat(Integer.parseInt(audit.getProperty("moves.refused"))).isBetween(1, 200);
        assertThat(Double.parseDouble(audit.getProperty("distances.largest.error")))
                .isLessThan(1e-9);
        assertThat(Integer.parseInt(
                        properties(recorded.resolve("environment.properties")).getProperty("echoes")))
                .isBetween(500, 2612);
        assertThat(Commands.run(new PrintWriter(out, true), new PrintWriter(err, true), "replay", recorded.toString()))
                .isZero();
        assertThat(out.toString()).contains("1 scenario, 402 steps, 3,013 answers compared: all the same");
    }

    @Test
    void theMovementIsHandedOverAndAudited(@TempDir Path folder, @TempDir Path compiled) throws Exception {
        int code = demo(folder, "--drive");
        assertThat(err.toString()).isEmpty();
        assertThat(out.toString())
                .contains("nothing is wrong", "200 steps of 2 robots", "a step of 2 robots")
                .containsPattern("driven +[0-9.]+ m in 20.0 s, ");
        assertThat(code).isZero();
        Properties audit = properties(folder.resolve("audit.properties"));
        assertThat(audit)
                .containsEntry("faults", "0")
                .containsEntry("steps", "201")
                .containsEntry("steps.places", "402")
                .containsEntry("moves.asked", "0");
        // A drive that meets nothing, or nothing but walls, would prove nothing.
        assertThat(Integer.parseInt(audit.getProperty("steps.contacts"))).isBetween(3, 300);
        assertThat(Integer.parseInt(audit.getProperty("steps.free"))).isBetween(100, 399);
        assertThat(Double.parseDouble(
                        properties(folder.resolve("environment.properties")).getProperty("drive.way")))
                .isGreaterThan(5);
        assertThat(folder.resolve("world.svg"))
                .content()
                .contains("drum", "20 s driven", ">bump, ")
                .doesNotContain("refused move");
        assertThat(Commands.run(new PrintWriter(out, true), new PrintWriter(err, true), "replay", folder.toString()))
                .isZero();
        assertThat(out.toString()).contains("all the same");

        // What the audit says where a step has put a robot where it cannot have been.
        assertThat(Examples.compile(List.of(Examples.FOLDER.resolve("ConversationAudit.java")), compiled))
                .isEmpty();
        byte[] truth = Files.readAllBytes(folder.resolve("from-module.bin"));
        rewrite(folder, truth, 3, bundle -> moved((StepBundle.Answer) bundle, new Point(-3.7, 0, 1)));
        assertThat(Examples.audit(folder, compiled)).contains("deep in a box at (-3.9, 0.0)", "exit 1");
        rewrite(folder, truth, 3, bundle -> moved((StepBundle.Answer) bundle, new Point(-2.5, 0, 1.5)));
        assertThat(Examples.audit(folder, compiled)).contains("a robot that met nothing is off by", "exit 1");
        rewrite(folder, truth, 3, bundle -> moved((StepBundle.Answer) bundle, new Point(-1, 0, -2)));
        assertThat(Examples.audit(folder, compiled)).contains("the centre of drum went through pole", "exit 1");
    }

    /** The same answer, but for the place of the first body. */
    private static StepBundle.Answer moved(StepBundle.Answer answer, Point to) {
        List<BodyAnswer> bodies = new ArrayList<>(answer.bodies());
        BodyAnswer first = bodies.get(0);
        bodies.set(0, new BodyAnswer(first.objectName(), to, first.heading(), first.rotation(), first.velocity()));
        return new StepBundle.Answer(bodies, answer.contacts(), answer.stopped());
    }

    /** The programs with the auditor that doubts, in a folder. */
    private static String doubting(Path folder) throws IOException {
        Path programs = Files.createDirectories(folder.resolve("programs"));
        Files.copy(Examples.FOLDER.resolve("ReferenceEnvironment.java"), programs.resolve("ReferenceEnvironment.java"));
        Files.writeString(programs.resolve("ConversationAudit.java"), DOUBTING);
        return programs.toString();
    }

    @Test
    void theSeedMakesTheConversationWhoeverDialsAndFaultsFail(@TempDir Path dialled, @TempDir Path other)
            throws Exception {
        assertThat(demo(dialled, "--dial")).isZero();
        assertThat(demo(other, "--seed", "2", "--examples", doubting(other))).isEqualTo(ExitCodes.FINDINGS);
        for (String file : new String[] {"to-module.bin", "from-module.bin"}) {
            assertThat(recorded.resolve(file)).hasSameBinaryContentAs(dialled.resolve(file));
            assertThat(Files.mismatch(recorded.resolve(file), other.resolve(file)))
                    .isNotNegative();
        }
        assertThat(recorded.resolve("world.svg")).hasSameTextualContentAs(dialled.resolve("world.svg"));
        assertThat(Files.readString(other.resolve("summary.txt"))).contains("1 FAULTS");
        assertThat(Files.readString(other.resolve("world.svg"))).contains("the audit found something wrong");
    }

    @Test
    void aTamperedRecordingIsFoundOut(@TempDir Path folder, @TempDir Path compiled) throws Exception {
        for (String file : new String[] {"small.xml", "to-module.bin", "from-module.bin"}) {
            Files.copy(recorded.resolve(file), folder.resolve(file));
        }
        Path source = Examples.FOLDER.resolve("ConversationAudit.java");
        assertThat(Examples.compile(List.of(source), compiled)).isEmpty();
        assertThat(Examples.audit(folder, compiled)).contains("nothing is wrong");

        byte[] truth = Files.readAllBytes(folder.resolve("from-module.bin"));
        rewrite(folder, truth, 1, bundle -> {
            var distances = new ArrayList<>(((DistanceBundle) bundle).distances());
            distances.set(0, Math.min(distances.get(0), 3) - 0.001);
            return new DistanceBundle(distances);
        });
        assertThat(Examples.audit(folder, compiled)).contains("1 FAULTS", "a distance of");
        rewrite(
                folder,
                truth,
                2,
                bundle -> new MoveBundle(((MoveBundle) bundle).moves().subList(1, 2)));
        assertThat(Examples.audit(folder, compiled)).contains("refused that is free by", "exit 1");
    }

    /** Changes one of the module's answers, counted from 1. */
    private static void rewrite(Path folder, byte[] truth, int which, UnaryOperator<Bundle> change) throws Exception {
        try (var outgoing = Files.newOutputStream(folder.resolve("from-module.bin"))) {
            MessageReader reader = new MessageReader(new ByteArrayInputStream(truth));
            MessageWriter writer = new MessageWriter(outgoing);
            int k = 1;
            for (Bundle bundle = reader.read(); bundle != null; bundle = reader.read(), k++) {
                assertThat(bundle).isNotInstanceOf(InitBundle.class);
                writer.write(k == which ? change.apply(bundle) : bundle);
            }
        }
    }

    private static Properties properties(Path file) throws Exception {
        Properties properties = new Properties();
        try (var in = Files.newBufferedReader(file)) {
            properties.load(in);
        }
        return properties;
    }
}
