package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.Session;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.scenario.source.WireReader;

class WireReaderTest {
    private static final InitBundle INIT = new InitBundle(List.of(new CylinderObject(new Point(), 1, 1).moveable("r")));
    private static final Bundle MOVES = new MoveBundle(List.of(Conversation.move("r", 1, 0)));
    private static final Bundle SONARS = new SonarRequestBundle(List.of(new SonarRequest("r", 1, 0)));
    private static final Bundle HEARD = new DistanceBundle(List.of(Double.POSITIVE_INFINITY));

    @TempDir
    private Path folder;

    private WireReader open(List<Bundle> to, List<Bundle> from) throws Exception {
        return WireReader.open(write("to", to), write("from", from));
    }

    private Path write(String name, List<Bundle> bundles) throws Exception {
        Path file = folder.resolve(name);
        try (OutputStream out = Files.newOutputStream(file)) {
            MessageWriter writer = new MessageWriter(out);
            for (Bundle bundle : bundles) {
                writer.write(bundle);
            }
        }
        return file;
    }

    @Test
    void requestsMeetTheirAnswers() throws Exception {
        try (WireReader reader = open(List.of(INIT, MOVES, SONARS), List.of(MOVES, HEARD))) {
            assertThat(reader.next()).isEqualTo(new Step(INIT, null));
            assertThat(reader.next()).isEqualTo(new Step(MOVES, new Reply(MOVES)));
            assertThat(reader.next()).isEqualTo(new Step(SONARS, new Reply(HEARD)));
            assertThat(reader.next()).isNull();
            assertThat(reader.header().title()).isEqualTo("to");
        }
    }

    /** An init that was answered is replayed as an init and the question. */
    @Test
    void anAnsweredInitMeetsItsAnswer() throws Exception {
        Bundle told = Objects.requireNonNull(new Session().answer(new InitBundle.Answered(INIT)));
        try (WireReader reader = open(List.of(new InitBundle.Answered(INIT), MOVES), List.of(told, MOVES))) {
            assertThat(reader.next()).isEqualTo(new Step(INIT, null));
            assertThat(reader.next()).isEqualTo(new Step(InitBundle.Answered.QUESTION, new Reply(told)));
            assertThat(reader.next()).isEqualTo(new Step(MOVES, new Reply(MOVES)));
        }
    }

    @Test
    void anAnswerThatIsMissingOrNoneIsTold() throws Exception {
        try (WireReader reader = open(List.of(INIT, MOVES), List.of())) {
            reader.next();
            assertThatThrownBy(reader::next).hasMessageContaining("message 2").hasMessageContaining("got: its end");
        }
        try (WireReader reader = open(List.of(INIT, MOVES), List.of(HEARD))) {
            reader.next();
            assertThatThrownBy(reader::next).hasMessageContaining("message 2").hasMessageContaining("got: distances");
        }
        try (WireReader reader = open(List.of(INIT), List.of(HEARD))) {
            reader.next();
            assertThatThrownBy(reader::next).hasMessageContaining("must have its request (got: one more)");
        }
        try (WireReader reader = open(List.of(HEARD), List.of())) {
            assertThatThrownBy(reader::next).hasMessageContaining("message 1").hasMessageContaining("got: distances");
        }
        assertThatThrownBy(() -> WireReader.open(folder.resolve("to"), folder.resolve("nowhere")))
                .hasMessageContaining("nowhere");
    }
}
