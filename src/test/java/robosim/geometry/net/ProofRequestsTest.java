package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.WorkLimit;
import robosim.geometry.WorkLimitException;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.proof.Proof;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** Requests of proofs, against the prover of the session's world. */
class ProofRequestsTest extends SessionOfObjects {
    private static WorldRequest.Go go(double x, double ry) {
        return new WorldRequest.Go("robot", x, 0, 0, 0, ry);
    }

    @Test
    void answersCanBeProved() {
        session.reply(new InitBundle(List.of(WALL, ROBOT), SPATIAL));
        WorldRequest.Prove sensor = new WorldRequest.Prove(new SenseRequest(
                "robot",
                new Mount(new Point(0, 0.1, 0)),
                new BeamPattern.Fan(0, 0.5, 3),
                0,
                8,
                0,
                false,
                false,
                false,
                ScanMotion.NONE,
                false,
                List.of()));
        WorldRequest.Prove free = new WorldRequest.Prove(go(-1, 0.5));
        WorldRequest.Prove blocked = new WorldRequest.Prove(go(8, 0));
        WorldRequest.DescribeScene scene = new WorldRequest.DescribeScene();
        List<WorldRequest> asked =
                List.of(scene, new WorldRequest.Prove(new WorldRequest.Locate("wall")), free, blocked, sensor);
        var answers = ask(asked.toArray(WorldRequest[]::new));
        for (int k = 0; k < asked.size(); k++) {
            assertThat(answers.get(k).fits(asked.get(k)))
                    .as("" + answers.get(k))
                    .isTrue();
            assertThat(answers.get(k).fits(new WorldRequest.Describe())).isFalse();
        }
        assertThat(String.join("", ((WorldAnswer.SceneText) answers.get(0)).scene()))
                .isEqualTo(Proof.jsonOf(session.world().prove().scene()));
        assertThat(kinds(answers.get(1))).containsExactly("apart");
        assertThat(kinds(answers.get(2))).containsExactly("translation", "turn", "apart");
        assertThat(kinds(answers.get(3))).containsExactly("blocked");
        assertThat(kinds(answers.get(4))).containsExactly("ray", "ray", "ray");
        assertThat(session.world().getObject("robot").center()).isEqualTo(ROBOT.center());
        String text = String.join(
                "", ((WorldAnswer.Proved) answers.get(3)).proofs().get(0).proof());
        assertThat(text)
                .isEqualTo(session.world()
                        .prove()
                        .move("robot", new Move(8, 0, 0, 0, 0))
                        .get(0)
                        .proof()
                        .json());
    }

    private static List<String> kinds(BatchAnswer answer) {
        return ((WorldAnswer.Proved) answer)
                .proofs().stream()
                        .map(each -> String.join("", each.proof()).replaceAll("^..claim.:..kind.:.(\\w+).*", "$1"))
                        .toList();
    }

    @Test
    void whatHasNoProofSaysWhy() {
        session.reply(new InitBundle(List.of(WALL, ROBOT), SPATIAL));
        BeamPattern fan = new BeamPattern.Fan(0, 0.5, 3);
        var answers = ask(
                new WorldRequest.Prove(go(0, Math.PI)),
                new WorldRequest.Prove(new SenseRequest("robot", fan).ignoring(List.of("wall"))));
        assertThat(((WorldAnswer.Proved) answers.get(0)).proofs().get(0))
                .isEqualTo(new WorldAnswer.Evidence(List.of(), "a turn of half a circle and more is not proved"));
        assertThat(answers.get(1)).isEqualTo(new NoAnswer());
    }

    /** All pairs of two families of slivers along the lines of y = x z are near, and a plane is sought for each. */
    @Test
    void aLimitOfWorkEndsTheSearchForAProof() {
        int count = 120;
        List<Point> corners = new ArrayList<>();
        int[][] faces = new int[count][];
        List<Point> others = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            double x = 2.0 * k / count - 1;
            corners.addAll(List.of(new Point(x, -x, -1), new Point(x, x, 1), new Point(x + 1e-4, x, 1)));
            others.addAll(List.of(
                    new Point(-1, 1e-3 - x, x), new Point(1, 1e-3 + x, x), new Point(1, 1e-3 + x + 1e-4, x + 1e-4)));
            faces[k] = new int[] {3 * k, 3 * k + 1, 3 * k + 2};
        }
        Geometry world = new Geometry(20, 20, 20, Dimension.SPATIAL, Accuracy.EXACT);
        world.addObjectUnchecked(new MeshObject(corners, faces).moveable("robot"));
        world.addObjectUnchecked(new MeshObject(others, faces).named("wall"));
        world.limitWork(WorkLimit.of(2_000));
        assertThatThrownBy(() -> world.prove().apart("robot")).isInstanceOf(WorkLimitException.class);
        world.limitWork(WorkLimit.none());
        assertThat(world.prove().apart("robot").isProved()).isTrue();
        assertThat(world.workDone()).isGreaterThanOrEqualTo(count * count);
    }
}
