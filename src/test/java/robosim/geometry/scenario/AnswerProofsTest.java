package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;

/** Answers of sessions that are proved, and what becomes of wrong ones. */
class AnswerProofsTest {
    private static final SonarRequest AHEAD = new SonarRequest("robot", 1, 0, new Beam(0, 20, 0));
    private static final SonarRequest WIDE = new SonarRequest("robot", 1, 0, new Beam(0, 20, 0.3));

    @TempDir
    private Path folder;

    private static InitBundle world() {
        List<GeometryObject> objects = new ArrayList<>();
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < 30; k++) {
            double angle = 2 * Math.PI * k / 30;
            objects.add(new BoxObject(
                            new Point(6 * StrictMath.cos(angle), 0, 6 * StrictMath.sin(angle)),
                            random.nextDouble(0.2, 1.2),
                            2,
                            random.nextDouble(0.2, 1.2))
                    .turned(0, random.nextDouble(360)));
        }
        objects.add(new CylinderObject(new Point(), 0.3, 1).moveable("robot"));
        return new InitBundle(objects);
    }

    private static List<Bundle> conversation() {
        SplittableRandom random = new SplittableRandom(4);
        List<Bundle> requests = new ArrayList<>(List.of(world()));
        for (int k = 0; k < 60; k++) {
            List<MoveRequest> moves = new ArrayList<>();
            for (int m = 0; m < 3; m++) {
                moves.add(new MoveRequest("robot", random.nextDouble(-2, 3), 0, 0, 0, random.nextDouble(-2, 2)));
            }
            requests.add(new MoveBundle(moves));
            requests.add(new SonarRequestBundle(List.of(AHEAD, WIDE)));
        }
        return requests;
    }

    private AnswerProofs talk(double share) {
        AnswerProofs proofs = new AnswerProofs(share, SessionOptions.ROBOSIM, folder);
        Session heard = new Session(SessionOptions.ROBOSIM, proofs.apply("a"), "a");
        Session alone = new Session(SessionOptions.ROBOSIM, SessionListener.NONE, "b");
        for (Bundle request : conversation()) {
            assertThat(heard.reply(request)).isEqualTo(alone.reply(request));
        }
        return proofs;
    }

    @Test
    void allAnswersAreProvedAndStayTheSame() {
        AnswerProofs all = talk(1);
        assertThat(all.failed()).isZero();
        assertThat(all.proved()).isGreaterThan(300);
        assertThat(all.unprovable()).isLessThan(all.proved() / 50);
        AnswerProofs some = talk(0.1);
        assertThat(some.failed()).isZero();
        assertThat(some.proved()).isBetween(all.proved() / 20, all.proved() / 5);
        assertThat(talk(0.1).proved()).isEqualTo(some.proved());
        assertThat(talk(0).proved()).isZero();
    }

    /** A distance that was changed on its way, and a move that is told to be made although it was refused. */
    @Test
    void aWrongAnswerIsStored() throws Exception {
        AnswerProofs proofs = new AnswerProofs(1, SessionOptions.ROBOSIM, folder);
        SessionListener listener = proofs.apply("a");
        Session session = new Session(SessionOptions.ROBOSIM, SessionListener.NONE, "a");
        listener.opened(session);
        session.reply(world());

        Bundle sonar = new SonarRequestBundle(List.of(AHEAD));
        listener.requested(sonar);
        listener.replied(sonar, new Reply(new DistanceBundle(List.of(1.25)), List.of()), 0);
        assertThat(proofs.failed()).isEqualTo(1);

        Bundle far = new MoveBundle(List.of(new MoveRequest("robot", 50, 0, 0, 0, 0)));
        listener.requested(far);
        listener.replied(far, new Reply(far, List.of()), 0);
        assertThat(proofs.failed()).isEqualTo(2);
        assertThat(proofs.toString()).contains("2 failed, see " + folder);

        for (int k = 1; k <= 2; k++) {
            Path file = folder.resolve("failed-proof-" + k + ScenarioReader.ENDING);
            assertThat(Files.readString(file)).contains("asked again, the answer is another one");
            List<Mismatch> found = new ArrayList<>();
            try (ScenarioReader reader = ScenarioReader.open(file)) {
                Replay.of(reader, found::add);
            }
            assertThat(found).as("replayed, the wrong answer %d shows", k).hasSize(1);
        }
    }

    @Test
    void aShareIsFromZeroToOne() {
        for (double share : new double[] {-0.1, 1.1, Double.NaN}) {
            assertThatThrownBy(() -> new AnswerProofs(share, SessionOptions.ROBOSIM, folder))
                    .hasMessage("share must be from 0 to 1 (got: " + share + ")");
        }
    }
}
