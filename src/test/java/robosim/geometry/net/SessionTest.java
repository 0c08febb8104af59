package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import robosim.geometry.MoveResult;
import robosim.geometry.SenseBuffer;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;
import robosim.geometry.net.session.World;
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

/** The session's own rules, over a world that notes what it is asked; SessionWorldTest has the real one. */
class SessionTest {
    private static final GeometryObject ROBOT = new SphereObject(new Point(), 1).moveable("robot");
    private static final GeometryObject WALL = new BoxObject(new Point(5, 0, 0), 1, 1, 1).named("wall");

    private final List<Notes> worlds = new ArrayList<>();
    private final LogCapture log = new LogCapture();
    private Session session = session(SessionOptions.ROBOSIM, SessionListener.NONE);

    /** Notes what it is asked; refuses moves of x below 0 and objects beyond x = 1000. */
    private static final class Notes implements World {
        final WorldSettings settings;
        final List<String> added = new ArrayList<>();
        final List<Move> moves = new ArrayList<>();
        final List<List<Double>> beams = new ArrayList<>();

        Notes(WorldSettings settings) {
            this.settings = settings;
        }

        @Override
        public boolean add(GeometryObject object) {
            if (object.center().y() == 13) {
                throw new IllegalArgumentException("y must be lucky (got: 13)\nforged line");
            }
            if (object.center().x() > 1000) {
                return false;
            }
            added.add(String.valueOf(object.name()));
            return true;
        }

        @Override
        public MoveResult move(String name, Move move) {
            moves.add(move);
            if (move.y() == 13) {
                throw new IllegalArgumentException("y must be lucky (got: 13)");
            }
            return new MoveResult(move.x() >= 0, 1, 1, null, null, null);
        }

        @Override
        public double sonar(String name, double x, double z, double min, double max, double width) {
            beams.add(List.of(x, z, min, max, width));
            if (z == 13) {
                throw new IllegalArgumentException("direction must not be vertical (got: 13)");
            }
            return beams.size();
        }

        // Batches are asked of real worlds: BatchSessionTest.

        @Override
        public void sense(String name, Pose mount, RayPattern pattern, SenseOptions options, SenseBuffer out) {
            throw new UnsupportedOperationException(name);
        }

        @Override
        public void freePoses(String name, double[] poses, long[] free) {
            throw new UnsupportedOperationException(name);
        }

        @Override
        public void freeEdges(String name, double[] edges, long[] free) {
            throw new UnsupportedOperationException(name);
        }
    }

    private Session session(SessionOptions options, SessionListener listener) {
        return new Session(options, listener, "test", settings -> {
            if (settings.width() == 13) {
                throw new IllegalArgumentException("width must be lucky (got: 13)");
            }
            worlds.add(new Notes(settings));
            return worlds.get(worlds.size() - 1);
        });
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

    private Notes world() {
        return worlds.get(worlds.size() - 1);
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
        SplittableRandom random = new SplittableRandom(5);
        for (int k = -400; k <= 400; k++) {
            double nearest = java.math.BigDecimal.valueOf(k)
                    .multiply(new java.math.BigDecimal("1.57079632679489661923132169163975144209858469968755"))
                    .doubleValue();
            move(turn(nearest, -nearest));
            Move move = world().moves.get(world().moves.size() - 1);
            assertThat(move.rx()).isEqualTo(90.0 * k);
            assertThat(move.ry()).isEqualTo(-90.0 * k + 0.0);
            double any = random.nextDouble(-10, 10);
            move(turn(any, 0));
            assertThat(world().moves.get(world().moves.size() - 1).rx())
                    .isCloseTo(Math.toDegrees(any), org.assertj.core.data.Percentage.withPercentage(1e-12));
        }
        assertThat(Math.PI / 2 * 3).as("what a peer computes").isEqualTo(3 * Math.PI / 2);
    }

    @Test
    void widthsAreRadiansTooAndBelow180() {
        init(ROBOT);
        measure(
                new SonarRequest("robot", 3, -4, new Beam(0.25, 9, Math.PI / 2)),
                new SonarRequest("robot", 1, 0, new Beam(0, 9, Math.nextDown(Math.PI))),
                new SonarRequest("robot", 1, 0));
        assertThat(world().beams)
                .containsExactly(
                        List.of(3.0, -4.0, 0.25, 9.0, 90.0),
                        List.of(1.0, 0.0, 0.0, 9.0, Math.nextDown(180.0)),
                        List.of(1.0, 0.0, 0.0, Double.POSITIVE_INFINITY, 0.0));
    }

    @Test
    void answersAreTheMovesMadeInOrderWithTheirOwnBits() {
        init(ROBOT, WALL);
        MoveRequest forth = new MoveRequest("robot", 1, -0.0, 0, 0, -0.0);
        MoveRequest into = new MoveRequest("robot", -1, 0, 0, 0, 0);
        MoveRequest back = new MoveRequest("robot", 2, 0, 0, 1e-320, 0);
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
        assertThat(world().moves).extracting(Move::x).containsExactly(1.0, -1.0, 2.0);
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
                .containsExactly(1.0, Double.NaN, Double.NaN, 2.0);
        assertThat(log.linesWith("\"nobody\"")).hasSize(1);
        assertThat(log.linesWith("\"wall\"")).hasSize(1);
    }

    @Test
    void whatTheWorldRefusesIsLoggedAndTheSessionGoesOn() {
        init(ROBOT);
        assertThat(move(new MoveRequest("robot", 0, 13, 0, 0, 0), turn(0, 1))).containsExactly(turn(0, 1));
        assertThat(measure(new SonarRequest("robot", 0, 13), new SonarRequest("robot", 0, 1)))
                .containsExactly(Double.NaN, 2.0);
        assertThat(log.linesWith("\"robot\"")).hasSize(2);
        assertThat(log.linesWith("(got: 13)")).hasSize(2);
    }

    @Test
    void repliesTellWhatWasRefusedAndWhy() {
        assertThat(session.reply(new InitBundle(List.of(ROBOT, WALL)))).isNull();
        MoveRequest forth = new MoveRequest("robot", 1, 0, 0, 0, 0);
        Reply moved = session.reply(new MoveBundle(List.of(
                new MoveRequest("nobody", 1, 0, 0, 0, 0),
                forth,
                new MoveRequest("robot", -1, 0, 0, 0, 0),
                new MoveRequest("robot", 0, 13, 0, 0, 0))));
        assertThat(moved)
                .isEqualTo(new Reply(
                        new MoveBundle(List.of(forth)),
                        List.of(
                                Problem.of(0, "no moveable object \"nobody\""),
                                Problem.of(2, "blocked by the border of the world after 1 of the turn"),
                                Problem.of(3, "y must be lucky (got: 13)"))));
        Reply seen = session.reply(new SonarRequestBundle(List.of(
                new SonarRequest("robot", 1, 0), new SonarRequest("wall", 1, 0), new SonarRequest("robot", 0, 13))));
        assertThat(seen)
                .isEqualTo(new Reply(
                        new DistanceBundle(List.of(1.0, Double.NaN, Double.NaN)),
                        List.of(
                                Problem.of(1, "no moveable object \"wall\""),
                                Problem.of(2, "direction must not be vertical (got: 13)"))));
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
        init(
                ROBOT,
                WALL.moveable("robot"),
                new SphereObject(new Point(2000, 0, 0), 1).moveable("far"),
                new SphereObject(new Point(0, 13, 0), 1).named("unlucky"),
                new SphereObject(new Point(3000, 0, 0), 1),
                WALL);
        assertThat(world().added).containsExactly("robot", "wall");
        assertThat(log.lines())
                .hasSize(4)
                .allSatisfy(line ->
                        assertThat(line).startsWith("WARNING test, message 1: ").doesNotContain("\n"));
        assertThat(log.linesWith("object \"robot\" was not added: an earlier object has its name"))
                .hasSize(1);
        assertThat(log.linesWith("object \"far\" was not added: it would leave the world"))
                .hasSize(1);
        assertThat(log.linesWith("object \"unlucky\" was not added: y must be lucky (got: 13)\\u000aforged"))
                .hasSize(1);
        assertThat(log.linesWith("objects[4] was not added")).hasSize(1);
        assertThat(move(new MoveRequest("far", 1, 0, 0, 0, 0))).isEmpty();
        assertThat(move(turn(0, 1))).hasSize(1);
    }

    @Test
    void aLaterWorldReplacesTheFirstOnlyWhenItIsWhole() {
        init(ROBOT);
        init(ROBOT.moveable("other"));
        assertThat(move(turn(0, 1))).isEmpty();
        assertThat(move(new MoveRequest("other", 1, 0, 0, 0, 0))).hasSize(1);
        WorldSettings unlucky = new WorldSettings(13, 1, 1, Dimension.PLANAR, Accuracy.EXACT);
        assertThat(session.answer(new InitBundle(List.of(ROBOT), unlucky))).isNull();
        assertThat(log.linesWith("width must be lucky (got: 13)")).hasSize(1);
        assertThat(move(new MoveRequest("other", 1, 0, 0, 0, 0))).hasSize(1);
        assertThat(worlds).hasSize(2);
    }

    @Test
    void settingsThatAreLeftOutComeFromTheOptions() {
        init(WALL);
        assertThat(world().settings.dimension()).isEqualTo(Dimension.PLANAR);
        assertThat(world().settings.accuracy()).isEqualTo(Accuracy.EXACT);
        assertThat(world().settings.width()).isEqualTo(2 * (5.5 + 5.5 / 4));
        session = session(new SessionOptions(Dimension.SPATIAL, Accuracy.DOP, new Beam(1, 2, 3)), SessionListener.NONE);
        init(ROBOT);
        measure(new SonarRequest("robot", 1, 0));
        assertThat(world().settings).isEqualTo(new WorldSettings(4, 4, 4, Dimension.SPATIAL, Accuracy.DOP));
        assertThat(world().beams.get(0).subList(2, 4)).containsExactly(1.0, 2.0);
        WorldSettings given = new WorldSettings(7, 8, 9, Dimension.PLANAR, Accuracy.OBB);
        session.answer(new InitBundle(List.of(ROBOT), given));
        assertThat(world().settings).isEqualTo(given);
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
        Bundle moves = new MoveBundle(List.of(turn(0, 1), new MoveRequest("robot", -1, 0, 0, 0, 0)));
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
