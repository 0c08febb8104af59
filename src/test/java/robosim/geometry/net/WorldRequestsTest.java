package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** Requests of a batch about the world's objects, against a world that is asked the same directly. */
class WorldRequestsTest {
    private static final WorldSettings SPATIAL = new WorldSettings(20, 6, 20, Dimension.SPATIAL, Accuracy.EXACT);
    private static final GeometryObject WALL = new BoxObject(new Point(3, 0, 0), 0.2, 2, 4).named("wall");
    private static final GeometryObject POST = new CylinderObject(new Point(-3, 0, 0), 0.5, 2);
    private static final GeometryObject ROBOT = new CylinderObject(new Point(), 0.25, 1).moveable("robot");

    private final Session session = new Session();

    private Reply reply(BatchRequest... requests) {
        return Objects.requireNonNull(session.reply(new BatchRequestBundle(List.of(requests))));
    }

    private List<BatchAnswer> ask(BatchRequest... requests) {
        return ((BatchAnswerBundle) reply(requests).bundle()).answers();
    }

    private static WorldRequest.Go go(double x, double ry) {
        return new WorldRequest.Go("robot", x, 0, 0, 0, ry);
    }

    @Test
    void anInitSaysWhatBecameOfIt() {
        GeometryObject outside = new SphereObject(new Point(30, 0, 0), 1);
        session.reply(new InitBundle(List.of(WALL, POST, WALL, ROBOT, outside), SPATIAL));
        WorldAnswer.Described told =
                (WorldAnswer.Described) ask(new WorldRequest.Describe()).get(0);
        assertThat(told)
                .isEqualTo(new WorldAnswer.Described(
                        3,
                        List.of(
                                new WorldAnswer.LeftOut(2, "wall", "an earlier object has its name"),
                                new WorldAnswer.LeftOut(4, "", "it would leave the world")),
                        20,
                        6,
                        20,
                        Dimension.SPATIAL,
                        Accuracy.EXACT));
        ask(new WorldRequest.Add(new SphereObject(new Point(5, 0, 5), 1), false));
        assertThat(ask(new WorldRequest.Describe()).get(0))
                .as("of the init, not of what came later")
                .isEqualTo(told);
    }

    @Test
    void settingsAreTakenOneByOne() {
        List<GeometryObject> objects = List.of(WALL, ROBOT);
        session.reply(new InitBundle(objects));
        WorldAnswer.Described plain =
                (WorldAnswer.Described) ask(new WorldRequest.Describe()).get(0);
        assertThat(plain.dimension()).isEqualTo(Dimension.PLANAR);
        assertThat(plain.accuracy()).isEqualTo(Accuracy.EXACT);
        session.reply(new InitBundle(objects, WorldSettings.NONE.withDimension(Dimension.SPATIAL)));
        assertThat(ask(new WorldRequest.Describe()).get(0))
                .isEqualTo(new WorldAnswer.Described(
                        2,
                        List.of(),
                        plain.width(),
                        plain.height(),
                        plain.length(),
                        Dimension.SPATIAL,
                        Accuracy.EXACT));
        session.reply(new InitBundle(objects, new WorldSettings(0, 50, 0, null, Accuracy.OBB)));
        assertThat(ask(new WorldRequest.Describe()).get(0))
                .isEqualTo(new WorldAnswer.Described(
                        2, List.of(), plain.width(), 50, plain.length(), Dimension.PLANAR, Accuracy.OBB));
    }

    @Test
    void withoutAWorldNothingHasAnAnswer() {
        Reply reply = reply(new WorldRequest.Describe(), new WorldRequest.Locate("robot"), go(1, 0));
        assertThat(((BatchAnswerBundle) reply.bundle()).answers())
                .containsExactly(new NoAnswer(), new NoAnswer(), new NoAnswer());
        assertThat(reply.problems())
                .extracting(Problem::reason)
                .containsExactly(
                        "there is no world yet",
                        "no moveable object \"robot\", there is no world yet",
                        "no moveable object \"robot\", there is no world yet");
    }

    @Test
    void changesSayWhatIsInTheWay() {
        session.reply(new InitBundle(List.of(WALL, POST, ROBOT), SPATIAL));
        assertThat(ask(
                        new WorldRequest.Place("robot", new Point(3, 0, 0), 1),
                        new WorldRequest.Place("robot", new Point(-3.2, 0, 0), 1),
                        new WorldRequest.Place("robot", new Point(9.9, 0, 0), 1),
                        new WorldRequest.Place("robot", new Point(0.1, 0, 0), 1),
                        new WorldRequest.Add(new SphereObject(new Point(0.2, 0, 0), 0.1), false),
                        new WorldRequest.Add(new SphereObject(new Point(0.2, 0, 0), 0.1).named("ball"), true),
                        new WorldRequest.Add(new SphereObject(new Point(10, 0, 0), 0.1), true),
                        new WorldRequest.Add(new SphereObject(new Point(10, 0, 0), 0.1), false),
                        new WorldRequest.Remove("ball"),
                        new WorldRequest.Remove("ball"),
                        new WorldRequest.Add(new SphereObject(new Point(0, 0, 5), 0.1).moveable("ball"), false),
                        new WorldRequest.Go("ball", 1, 0, 0, 0, 0),
                        new WorldRequest.Remove("ball")))
                .containsExactly(
                        new WorldAnswer.Changed(false, "wall"),
                        new WorldAnswer.Changed(false, ""),
                        new WorldAnswer.Changed(false, null),
                        new WorldAnswer.Changed(true, null),
                        new WorldAnswer.Changed(false, "robot"),
                        new WorldAnswer.Changed(true, null),
                        new WorldAnswer.Changed(false, null),
                        new WorldAnswer.Changed(false, null),
                        new WorldAnswer.Changed(true, null),
                        new WorldAnswer.Changed(false, null),
                        new WorldAnswer.Changed(true, null),
                        WorldAnswer.Went.MADE,
                        new WorldAnswer.Changed(true, null));
        Reply refused = reply(
                new WorldRequest.Add(ROBOT, true),
                new WorldRequest.Locate("nobody"),
                new WorldRequest.Place("wall", new Point(), 0),
                go(0.1, 0),
                new WorldRequest.Go("ball", 1, 0, 0, 0, 0));
        assertThat(refused.problems())
                .extracting(Problem::toString)
                .containsExactly(
                        "0: name must be unique in its world (got: \"robot\" again)",
                        "1: no object \"nobody\"",
                        "2: no moveable object \"wall\"",
                        "4: no moveable object \"ball\"");
        assertThat(((BatchAnswerBundle) refused.bundle()).answers().get(3)).isEqualTo(WorldAnswer.Went.MADE);
        assertThat(session.objectCount()).isEqualTo(3);
    }

    @Test
    void whatIsAddedHearsAndIsHeard() {
        session.reply(new InitBundle(List.of(ROBOT), SPATIAL));
        ask(new WorldRequest.Add(WALL, false));
        assertThat(session.answer(
                        new robosim.geometry.protocol.SonarRequestBundle(List.of(new SonarRequest("robot", 1, 0)))))
                .isEqualTo(new robosim.geometry.protocol.DistanceBundle(List.of(2.9)));
    }

    /** The same moves in a world of our own, and in a bundle. */
    @Test
    void movesSayWhatBlocksThem() {
        SplittableRandom random = new SplittableRandom(22);
        List<GeometryObject> objects = new ArrayList<>(List.of(WALL, POST, ROBOT));
        for (int k = 0; k < 12; k++) {
            Point at = new Point(16 * random.nextDouble() - 8, 0, 16 * random.nextDouble() - 8);
            GeometryObject box = new BoxObject(at, 1, 1, 0.5).turned(0, 90 * random.nextDouble());
            objects.add(k % 2 == 0 ? box : box.named("box " + k));
        }
        session.reply(new InitBundle(objects, SPATIAL));
        Session twin = new Session();
        twin.reply(new InitBundle(objects, SPATIAL));
        Geometry world = new Geometry(20, 6, 20);
        objects.forEach(world::addObjectUnchecked);
        int made = 0;
        int border = 0;
        int named = 0;
        int turns = 0;
        for (int k = 0; k < 600; k++) {
            WorldRequest.Go go = new WorldRequest.Go(
                    "robot", 4 * random.nextDouble() - 1, 0, random.nextDouble() - 0.5, 0, 6 * random.nextDouble() - 3);
            WorldAnswer.Went went = (WorldAnswer.Went) ask(go).get(0);
            MoveResult truth = world.move("robot", new Move(go.x(), 0, go.z(), 0, Degrees.toDegrees(go.ry())));
            MoveRequest same = new MoveRequest("robot", go.x(), 0, go.z(), 0, go.ry());
            assertThat(((MoveBundle) Objects.requireNonNull(twin.answer(new MoveBundle(List.of(same))))).moves())
                    .hasSize(went.made() ? 1 : 0);
            assertThat(went.made()).isEqualTo(truth.allowed());
            assertThat(went.fraction()).isEqualTo(truth.fraction());
            assertThat(went.turnFraction()).isEqualTo(truth.turnFraction());
            assertThat(went.contact()).isEqualTo(truth.contact());
            assertThat(went.normal()).isEqualTo(truth.normal());
            GeometryObject obstacle = truth.obstacle();
            assertThat(went.obstacle())
                    .isEqualTo(obstacle == null ? null : Objects.requireNonNullElse(obstacle.name(), ""));
            WorldAnswer.Located at =
                    (WorldAnswer.Located) ask(new WorldRequest.Locate("robot")).get(0);
            GeometryObject now = world.getObject("robot");
            assertThat(at.center()).isEqualTo(now.center());
            assertThat(at.rotation()).isEqualTo(new Numbers(now.pose().rotation()));
            assertThat(at.heading()).isEqualTo(Degrees.toRadians(now.heading()));
            made += went.made() ? 1 : 0;
            border += !went.made() && obstacle == null ? 1 : 0;
            named += obstacle != null && obstacle.name() != null ? 1 : 0;
            turns += went.fraction() == 1 && !went.made() ? 1 : 0;
        }
        assertThat(made).isBetween(150, 560);
        assertThat(named).isPositive();
        assertThat(border + turns).isPositive();
    }
}
