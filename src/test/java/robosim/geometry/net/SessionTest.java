package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;

/** The session's own rules; {@link SessionWorldTest} compares its answers with those of a world. */
class SessionTest {
    private static final GeometryObject ROBOT = new SphereObject(new Point(), 1).moveable("robot");
    private static final GeometryObject WALL = new BoxObject(new Point(5, 0, 0), 1, 1, 1).named("wall");

    private final LogCapture log = new LogCapture();
    private Session session = session(SessionOptions.ROBOSIM, SessionListener.NONE);

    private static Session session(SessionOptions options, SessionListener listener) {
        return new Session(options, listener, "test");
    }

    @BeforeEach
    void nothingIsLogged() {
        assertThat(log.lines()).isEmpty();
    }

    @AfterEach
    void closeLog() {
        log.close();
    }

    private void init(GeometryObject... objects) {
        assertThat(session.answer(new InitBundle(List.of(objects)))).isNull();
    }

    private Geometry world() {
        return Objects.requireNonNull(session.world());
    }

    private GeometryObject robot() {
        return world().getObject("robot");
    }

    private List<MoveRequest> move(MoveRequest... moves) {
        return ((MoveBundle) session.answer(new MoveBundle(List.of(moves)))).moves();
    }

    private List<Double> measure(SonarRequest... requests) {
        return ((DistanceBundle) session.answer(new SonarRequestBundle(List.of(requests)))).distances();
    }

    private static MoveRequest turn(double rx, double ry) {
        return new MoveRequest("robot", 0, 0, 0, rx, ry);
    }

    @Test
    void beforeAnyWorldNobodyIsKnown() {
        assertThat(move(turn(0, 1))).isEmpty();
        assertThat(measure(new SonarRequest("robot", 1, 0), new SonarRequest("x", 1, 0)))
                .containsExactly(Double.NaN, Double.NaN);
        assertThat(log.linesWith("\"robot\"")).hasSize(2).allMatch(line -> line.contains("no world yet"));
        assertThat(log.linesWith("\"x\"")).hasSize(1);
    }

    @Test
    void quarterTurnsInRadiansAreExactInDegrees() {
        init(ROBOT);
        Geometry twin = new Geometry(4, 4, 4, Dimension.PLANAR, Accuracy.EXACT);
        twin.addObject(ROBOT);
        SplittableRandom random = new SplittableRandom(5);
        for (int k = -400; k <= 400; k++) {
            double nearest = java.math.BigDecimal.valueOf(k)
                    .multiply(new java.math.BigDecimal("1.57079632679489661923132169163975144209858469968755"))
                    .doubleValue();
            move(turn(nearest, -nearest));
            twin.move("robot", new Move(0, 0, 0, 90.0 * k, -90.0 * k));
            assertThat(robot()).as("%s quarters", k).isEqualTo(twin.getObject("robot"));
            double any = random.nextDouble(-10, 10);
            move(turn(any, 0));
            twin.move("robot", new Move(0, 0, 0, Math.toDegrees(any), 0));
            assertThat(robot().rotation())
                    .containsExactly(twin.getObject("robot").rotation(), org.assertj.core.data.Offset.offset(1e-11));
            session.answer(new InitBundle(List.of(ROBOT)));
            twin.placeObject("robot", new Point(), 0);
        }
        assertThat(Math.PI / 2 * 3).as("what a peer computes").isEqualTo(3 * Math.PI / 2);
    }

    @Test
    void widthsAreRadiansTooAndBelow180() {
        GeometryObject post = new CylinderObject(new Point(3, 0, -4), 0.25, 1);
        init(ROBOT, post);
        Geometry twin = new Geometry(20, 4, 20, Dimension.PLANAR, Accuracy.EXACT);
        twin.addObject(ROBOT);
        twin.addObject(post);
        List<Double> distances = measure(
                new SonarRequest("robot", 3, -3, new Beam(0.25, 9, Math.PI / 2)),
                new SonarRequest("robot", -1, 1, new Beam(0, 9, Math.nextDown(Math.PI))),
                new SonarRequest("robot", 3, -4));
        assertThat(distances)
                .containsExactly(
                        twin.getSonarDistance("robot", 3, -3, 0.25, 9, 90),
                        twin.getSonarDistance("robot", -1, 1, 0, 9, Math.nextDown(180.0)),
                        twin.getSonarDistance("robot", 3, -4, 0, Double.POSITIVE_INFINITY, 0));
        assertThat(distances.get(0)).isLessThan(9);
    }

    @Test
    void answersAreTheMovesMadeInOrderWithTheirOwnBits() {
        init(ROBOT, WALL);
        MoveRequest forth = new MoveRequest("robot", 1, -0.0, 0, 0, -0.0);
        MoveRequest into = new MoveRequest("robot", 5, 0, 0, 0, 0);
        MoveRequest back = new MoveRequest("robot", -2, 0, 0, 1e-320, 0);
        assertThat(move(
                        forth,
                        into,
                        new MoveRequest("nobody", 1, 0, 0, 0, 0),
                        back,
                        new MoveRequest("wall", 1, 0, 0, 0, 0)))
                .containsExactly(forth, back)
                .first()
                .satisfies(move ->
                        assertThat(Double.doubleToRawLongBits(move.ry())).isEqualTo(Double.doubleToRawLongBits(-0.0)));
        assertThat(robot().center().x()).isEqualTo(-1);
        assertThat(log.linesWith("\"nobody\"")).hasSize(1);
        assertThat(log.linesWith("\"wall\"")).hasSize(1);
    }

    @Test
    void distancesOfUnknownAndStaticNamesAreNaN() {
        init(ROBOT, WALL);
        assertThat(measure(
                        new SonarRequest("robot", 1, 0),
                        new SonarRequest("nobody", 1, 0),
                        new SonarRequest("wall", 1, 0),
                        new SonarRequest("robot", 0, 1)))
                .containsExactly(4.5, Double.NaN, Double.NaN, Double.POSITIVE_INFINITY);
        assertThat(log.linesWith("\"nobody\"")).hasSize(1);
        assertThat(log.linesWith("\"wall\"")).hasSize(1);
    }

    @Test
    void whatTheWorldRefusesIsLoggedAndTheSessionGoesOn() {
        init(ROBOT, WALL);
        move(turn(Math.PI / 2, 0)); // its Z looks straight down
        assertThat(measure(new SonarRequest("robot", 0, 1), new SonarRequest("robot", 1, 0)))
                .containsExactly(Double.NaN, 4.5);
        assertThat(log.linesWith("\"robot\"")).hasSize(1);
    }

    @Test
    void repliesTellWhatWasRefusedAndWhy() {
        assertThat(session.reply(new InitBundle(List.of(ROBOT, WALL)))).isNull();
        MoveRequest forth = new MoveRequest("robot", 1, 0, 0, 0, 0);
        Reply moved = session.reply(new MoveBundle(
                List.of(new MoveRequest("nobody", 1, 0, 0, 0, 0), forth, new MoveRequest("robot", -20, 0, 0, 0, 0))));
        assertThat(moved.bundle()).isEqualTo(new MoveBundle(List.of(forth)));
        assertThat(moved.problems()).hasSize(2);
        assertThat(moved.problems().get(0)).isEqualTo(Problem.of(0, "no moveable object \"nobody\""));
        assertThat(moved.problems().get(1).index()).isEqualTo(2);
        assertThat(moved.problems().get(1).reason()).startsWith("blocked by the border of the world after ");
        move(turn(Math.PI / 2, 0));
        Reply seen = session.reply(new SonarRequestBundle(List.of(
                new SonarRequest("robot", 1, 0), new SonarRequest("wall", 1, 0), new SonarRequest("robot", 0, 1))));
        assertThat(seen.bundle()).isEqualTo(new DistanceBundle(List.of(3.5, Double.NaN, Double.NaN)));
        assertThat(seen.problems()).hasSize(2);
        assertThat(seen.problems().get(0)).isEqualTo(Problem.of(1, "no moveable object \"wall\""));
        assertThat(seen.problems().get(1).reason()).contains("vertical");
        assertThatThrownBy(() -> session.reply(new DistanceBundle(List.of())))
                .isInstanceOf(IllegalArgumentException.class);
    }

    /** A message of 64 MB can ask for a million unknown names; their words would be ten times its size. */
    @Test
    void wordsAboutUnknownNamesAreMadeWhenTheyAreAskedFor() {
        init(ROBOT);
        Problem problem = session.reply(new MoveBundle(List.of(new MoveRequest("nobody", 1, 0, 0, 0, 0))))
                .problems()
                .get(0);
        assertThat(problem.reason()).isEqualTo("no moveable object \"nobody\"").isNotSameAs(problem.reason());
    }

    @Test
    void objectsThatCannotBeAddedAreNamedAndTheOthersStay() {
        WorldSettings settings = new WorldSettings(100, 10, 100, Dimension.PLANAR, Accuracy.EXACT);
        session.answer(new InitBundle(
                List.of(
                        ROBOT,
                        WALL.moveable("robot"),
                        new SphereObject(new Point(2000, 0, 0), 1).moveable("far\naway"),
                        new SphereObject(new Point(3000, 0, 0), 1),
                        WALL),
                settings));
        assertThat(world().objects()).containsExactly(ROBOT, WALL);
        assertThat(log.lines())
                .hasSize(3)
                .allSatisfy(line ->
                        assertThat(line).startsWith("WARNING test, message 1: ").doesNotContain("\n"));
        assertThat(log.linesWith("object \"robot\" was not added: an earlier object has its name"))
                .hasSize(1);
        assertThat(log.linesWith("object \"far\\u000aaway\" was not added: it would leave the world"))
                .hasSize(1);
        assertThat(log.linesWith("objects[3] was not added")).hasSize(1);
        assertThat(move(new MoveRequest("far\naway", 1, 0, 0, 0, 0))).isEmpty();
        assertThat(move(turn(0, 1))).hasSize(1);
    }

    @Test
    void aLaterWorldReplacesTheFirst() {
        init(ROBOT);
        Geometry first = world();
        init(ROBOT.moveable("other"));
        assertThat(world()).isNotSameAs(first);
        assertThat(move(turn(0, 1))).isEmpty();
        assertThat(move(new MoveRequest("other", 0.5, 0, 0, 0, 0))).hasSize(1);
    }

    @Test
    void settingsThatAreLeftOutComeFromTheOptions() {
        init(WALL);
        assertThat(settings()).isEqualTo(new WorldSettings(13.75, 3.75, 3.75, Dimension.PLANAR, Accuracy.EXACT));
        session = session(new SessionOptions(Dimension.SPATIAL, Accuracy.DOP, new Beam(1, 2, 3)), SessionListener.NONE);
        init(ROBOT);
        assertThat(settings()).isEqualTo(new WorldSettings(4, 4, 4, Dimension.SPATIAL, Accuracy.DOP));
        init(ROBOT, WALL);
        assertThat(measure(new SonarRequest("robot", 1, 0)))
                .as("beyond the range of 2")
                .containsExactly(Double.POSITIVE_INFINITY);
        WorldSettings given = new WorldSettings(7, 8, 9, Dimension.PLANAR, Accuracy.OBB);
        session.answer(new InitBundle(List.of(ROBOT), given));
        assertThat(settings()).isEqualTo(given);
    }

    private WorldSettings settings() {
        Geometry world = world();
        return new WorldSettings(world.width(), world.height(), world.length(), world.dimension(), world.accuracy());
    }

    @Test
    void aListenerSeesEverything() {
        List<Bundle> requests = new ArrayList<>();
        List<@Nullable Bundle> answers = new ArrayList<>();
        List<Boolean> tried = new ArrayList<>();
        session = session(SessionOptions.ROBOSIM, new SessionListener() {
            @Override
            public void tried(MoveRequest request, MoveResult result) {
                tried.add(result.allowed());
            }

            @Override
            public void answered(Bundle request, @Nullable Bundle answer, long nanoseconds) {
                requests.add(request);
                answers.add(answer);
                assertThat(nanoseconds).isBetween(0L, 10_000_000_000L);
            }
        });
        Bundle init = new InitBundle(List.of(ROBOT));
        Bundle moves = new MoveBundle(List.of(turn(0, 1), new MoveRequest("robot", -9, 0, 0, 0, 0)));
        session.answer(init);
        Bundle answer = session.answer(moves);
        assertThat(requests).containsExactly(init, moves);
        assertThat(answers).containsExactly(null, answer);
        assertThat(tried).containsExactly(true, false);
    }

    @Test
    void anAnswerIsNoRequest() {
        assertThatThrownBy(() -> session.answer(new DistanceBundle(List.of())))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("DistanceBundle");
    }

    @Test
    void warningsComeOnceForAWorldAndNotWithoutEnd() {
        init(ROBOT);
        for (int k = 0; k < 3; k++) {
            move(new MoveRequest("nobody", 1, 0, 0, 0, 0));
        }
        assertThat(log.linesWith("\"nobody\"")).hasSize(1);
        init(ROBOT);
        move(new MoveRequest("nobody", 1, 0, 0, 0, 0));
        assertThat(log.linesWith("\"nobody\"")).hasSize(2);
        for (int k = 0; k < 5000; k++) {
            move(new MoveRequest("nobody " + k, 1, 0, 0, 0, 0));
        }
        assertThat(log.lines()).hasSizeBetween(1000, 1010);
        assertThat(log.lines().get(log.lines().size() - 1)).contains("more are not logged");
        move(new MoveRequest("a" + "\n".repeat(10_000), 1, 0, 0, 0, 0));
        assertThat(log.lines()).allMatch(line -> line.length() < 800 && !line.contains("\n"));
    }
}
