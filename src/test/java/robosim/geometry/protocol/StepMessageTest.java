package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.DriveSettings.Kind;
import robosim.geometry.protocol.motion.SurfaceSettings;
import robosim.geometry.protocol.motion.Velocity;

/** Steps of bodies in both encodings. */
class StepMessageTest {
    private static final String STORED = "steps.ser";
    private static final String LATER = "stops.ser";
    private static final double NONE = Double.POSITIVE_INFINITY;

    @Test
    void stepsComeBackAsTheyWere() throws IOException {
        List<Bundle> all = new ArrayList<>(StepSamples.everyBundle());
        all.add(StepSamples.landing());
        all.addAll(StepSamples.later());
        all.add(StepSamples.pushing());
        all.add(StepSamples.ignoring());
        SplittableRandom random = new SplittableRandom(21);
        for (int k = 0; k < 500; k++) {
            all.add(StepSamples.random(random));
        }
        assertThat(MessageTest.readAll(MessageTest.write(all.toArray(Bundle[]::new))))
                .isEqualTo(all);
        for (Bundle bundle : all) {
            if (!bundle.isAnswer()) {
                assertThat(JsonLines.readRequest(JsonLines.write(bundle))).isEqualTo(bundle);
            }
        }
        Reply reply = new Reply(StepSamples.answer());
        assertThat(JsonLines.readReply(JsonLines.write(reply))).isEqualTo(reply);
        assertThat(JsonLines.isReply(JsonLines.write(reply))).isTrue();
        Reply reasons = new Reply(StepSamples.later().get(1));
        assertThat(JsonLines.readReply(JsonLines.write(reasons))).isEqualTo(reasons);
        // What older clients know is all that they get, unless there is a fall.
        assertThat(JsonLines.write(reply)).doesNotContain("fall");
        Reply landing = new Reply(StepSamples.landing());
        assertThat(JsonLines.write(landing)).contains("\"fall\":1.25");
        assertThat(JsonLines.readReply(JsonLines.write(landing))).isEqualTo(landing);
    }

    @Test
    void storedStepsMeanWhatTheyMeant() throws IOException {
        assertThat(MessageTest.readAll(StoredBytesTest.stored(STORED))).isEqualTo(StepSamples.everyBundle());
        assertThat(MessageTest.readAll(StoredBytesTest.stored(LATER))).isEqualTo(StepSamples.later());
    }

    @Test
    void whatIsLeftOutInJsonHasItsDefault() throws IOException {
        assertThat(JsonLines.readRequest("{\"seconds\":0.5,\"commands\":[{\"objectName\":\"r\"}],\"type\":\"step\","
                        + "\"bodies\":[{\"objectName\":\"b\",\"drive\":{\"kind\":\"FORCE\"}}]}"))
                .isEqualTo(new StepBundle(
                        0.5,
                        List.of(BodyRequest.of("b").withDrive(DriveSettings.of(Kind.FORCE))),
                        List.of(new DriveCommand("r", 0, 0))));
    }

    private static void refuses(Runnable made, String words) {
        assertThatThrownBy(made::run)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(words);
    }

    @Test
    void whatIsOutOfRangeIsRefused() {
        for (double wrong : new double[] {-1e-300, 3600.1, NONE, Double.NaN}) {
            refuses(
                    () -> new StepBundle(wrong, List.of(), List.of()),
                    "seconds must be a number from 0 to 3600 (got: ");
        }
        refuses(() -> new StepBundle(1, null, List.of()), "bodies");
        refuses(() -> new StepBundle(1, List.of(), Arrays.asList((DriveCommand) null)), "commands[0]");
        BodyRequest body = BodyRequest.of("b");
        for (double wrong : new double[] {-1, 1e-10, 2e9, NONE, Double.NaN}) {
            refuses(() -> body.withMass(wrong), "mass must be a number from 10^-9 to 10^9, or 0");
        }
        refuses(() -> body.withDamping(-1, 0), "damping must be");
        refuses(() -> body.withDamping(0, NONE), "turnDamping must be");
        refuses(() -> new SurfaceSettings(1.5, 0, 0), "restitution must be a number from 0 to 1 (got: 1.5)");
        refuses(
                () -> new SurfaceSettings(0, 0.5, 0.6),
                "slidingFriction must be at most staticFriction, 0.5 (got: 0.6)");
        refuses(() -> new DriveCommand("r", NONE, 0), "forward must be");
        refuses(() -> new DriveCommand("r", 0, Double.NaN, 0), "right must be");
        refuses(() -> new DriveCommand(null, 0, 0, 0), "objectName");
        refuses(() -> new Velocity(0, 0, 0, Double.NaN), "ry must be");
        refuses(
                () -> new DriveSettings(Kind.FORCE, 1, NONE, NONE, NONE, NONE),
                "base must be left out for a drive of kind FORCE, which has none of these numbers (got: 1.0)");
        refuses(
                () -> new DriveSettings(Kind.OMNIDIRECTIONAL, 0.4, NONE, NONE, NONE, NONE),
                "base must be left out for a drive of kind OMNIDIRECTIONAL, which has maxSpeed, maxAcceleration, maxTurn"
                        + " and maxTurnAcceleration (got: 0.4)");
        refuses(() -> new DriveSettings(Kind.VELOCITY, 0, 1, NONE, NONE, NONE), "maxSpeed must be left out");
        refuses(() -> new DriveSettings(Kind.VELOCITY, 0, NONE, 1, NONE, NONE), "maxAcceleration must be left out");
        refuses(() -> new DriveSettings(Kind.DIFFERENTIAL, 0, NONE, NONE, 1, NONE), "maxTurn must be left out");
        refuses(() -> new DriveSettings(Kind.ACKERMANN, 0, NONE, NONE, 1, 1), "maxTurnAcceleration must be left out");
        refuses(
                () -> new DriveSettings(Kind.ACKERMANN, 0, NONE, NONE, 1.6, NONE),
                "maxTurn of a car must be below pi/2");
        refuses(() -> DriveSettings.of(Kind.FORCE).withCentreAhead(1), "centreAhead must be left out");
        refuses(() -> DriveSettings.of(Kind.ACKERMANN).withCentreAhead(Double.NaN), "centreAhead must be");
        Velocity rest = new Velocity(0, 0, 0, 0);
        refuses(() -> new BodyAnswer("b", new Point(), 4, Numbers.NONE, rest), "heading must be");
        refuses(() -> new BodyAnswer("b", new Point(), 0, Numbers.of(1, 2, 3), rest), "rotation");
        refuses(
                () -> new ContactAnswer("b", null, new Point(), new Point(), -1, ContactAnswer.Phase.BEGIN),
                "impulse must be");
        refuses(
                () -> new ContactAnswer("b", null, new Point(), new Point(), 0, ContactAnswer.Phase.BEGIN, -1),
                "fall must be");
        refuses(
                () -> new ContactAnswer("b", null, new Point(), new Point(), 0, ContactAnswer.Phase.BEGIN, Double.NaN),
                "fall must be");
    }

    @Test
    void jsonIsRefusedWithItsPlace() {
        assertThatThrownBy(() -> JsonLines.readRequest(
                        "{\"type\":\"step\",\"seconds\":1,\"bodies\":[{\"objectName\":\"b\"," + "\"restitution\":2}]}"))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("/bodies/0")
                .hasMessageContaining("restitution must be");
        assertThatThrownBy(() -> JsonLines.readRequest("{\"type\":\"step\",\"seconds\":1,\"speed\":2}"))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("speed");
    }

    /** World files have them in small letters, the wire in capitals. */
    @Test
    void kindsOfDrivesAreReadInCapitalsAndInSmallLetters() throws ProtocolException {
        String step =
                "{\"type\":\"step\",\"seconds\":0,\"bodies\":[{\"objectName\":\"b\",\"drive\":{\"kind\":\"%s\"}}]}";
        for (Kind kind : Kind.values()) {
            StepBundle expected =
                    new StepBundle(0, List.of(BodyRequest.of("b").withDrive(DriveSettings.of(kind))), List.of());
            assertThat(JsonLines.readRequest(step.formatted(kind))).isEqualTo(expected);
            assertThat(JsonLines.readRequest(step.formatted(kind.name().toLowerCase(Locale.ROOT))))
                    .isEqualTo(expected);
        }
        assertThatThrownBy(() -> JsonLines.readRequest(step.formatted("Force")))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("/bodies/0/drive/kind: must be one of [DIFFERENTIAL, ");
    }

    /** Wrote the stored bytes; whoever changes what is written adds a file and leaves this one alone. */
    static final class Write {
        private Write() {}

        public static void main(String[] args) throws IOException {
            Files.write(
                    Path.of(args[0], STORED),
                    MessageTest.write(StepSamples.everyBundle().toArray(Bundle[]::new)));
            Files.write(
                    Path.of(args[0], LATER),
                    MessageTest.write(StepSamples.later().toArray(Bundle[]::new)));
        }
    }
}
