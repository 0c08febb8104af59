package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.SlideResult;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.Obstacle;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** Requests of a batch about the world's objects, against a world that is asked the same directly. */
class WorldRequestsTest extends SessionOfObjects {
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

    private static WorldAnswer.Identified told(WorldAnswer answer, Obstacle... obstacles) {
        return new WorldAnswer.Identified(answer, List.of(obstacles));
    }

    private static WorldAnswer.Identified blocked(Obstacle... obstacles) {
        return told(new WorldAnswer.Changed(false, obstacles.length == 0 ? null : obstacles[0].name()), obstacles);
    }

    private static WorldRequest.Identify place(double x, double z) {
        return new WorldRequest.Identify(new WorldRequest.Place("robot", new Point(x, 0, z), 0));
    }

    /** Two objects without a name, one that is left out, and numbers that go on where the init's end. */
    @Test
    void whatHasNoNameIsToldByItsIndex() {
        GeometryObject block = new BoxObject(new Point(0, 0, -3), 4, 2, 0.2);
        session.reply(new InitBundle(List.of(WALL, POST, WALL, ROBOT, block), SPATIAL));
        Obstacle wall = new Obstacle(0, "wall", GeometryObject.Kind.BOX, WALL.center());
        Obstacle post = new Obstacle(1, "", GeometryObject.Kind.CYLINDER, POST.center());
        Obstacle third = new Obstacle(4, "", GeometryObject.Kind.BOX, block.center());
        Obstacle ball = new Obstacle(5, "ball", GeometryObject.Kind.SPHERE, new Point(0, 0, -3));
        Obstacle crumb = new Obstacle(6, "", GeometryObject.Kind.SPHERE, new Point(0, 0, -3.5));
        Obstacle second = new Obstacle(7, "ball", GeometryObject.Kind.SPHERE, new Point(0, 0, 3));
        WorldAnswer done = new WorldAnswer.Changed(true, null);
        GeometryObject small = new SphereObject(new Point(0, 0, -3.5), 0.1);
        GeometryObject red = new SphereObject(ball.center(), 0.3).moveable("ball");
        assertThat(ask(
                        place(3, 0),
                        place(-3.2, 0),
                        place(9.9, 0),
                        place(0, -3),
                        new WorldRequest.Identify(new WorldRequest.Add(red, false)),
                        new WorldRequest.Identify(new WorldRequest.Add(red, true)),
                        new WorldRequest.Identify(new WorldRequest.Add(small, false)),
                        new WorldRequest.Identify(new WorldRequest.Add(small.movedTo(new Point(30, 0, 0)), true)),
                        place(0, -3.2),
                        new WorldRequest.Remove("ball"),
                        new WorldRequest.Add(red.movedTo(new Point(0, 0, 2)), false),
                        new WorldRequest.Place("ball", second.center(), 0),
                        place(0, 3),
                        place(0, 0),
                        new WorldRequest.Identify(go(5, 0)),
                        new WorldRequest.Identify(go(-5, 0)),
                        new WorldRequest.Identify(go(0, 1))))
                .startsWith(
                        blocked(wall),
                        blocked(post),
                        blocked(),
                        blocked(third),
                        blocked(third),
                        told(done),
                        told(done),
                        blocked(),
                        blocked(third, ball, crumb),
                        done,
                        done,
                        done,
                        blocked(second),
                        told(done))
                .endsWith(told(WorldAnswer.Went.MADE))
                .extracting(answer ->
                        answer instanceof WorldAnswer.Identified told && told.answer() instanceof WorldAnswer.Went
                                ? told.obstacles()
                                : List.of())
                .containsSubsequence(List.of(wall), List.of(post), List.of());
        session.reply(new InitBundle(List.of(ROBOT, POST), SPATIAL));
        assertThat(ask(place(-3, 0)).get(0)).as("a new world begins at 0").isEqualTo(blocked(post));
    }

    @Test
    void manyThatAreInTheWayAreToldUpToAnEnd() {
        List<GeometryObject> objects = new ArrayList<>(List.of(ROBOT));
        for (int k = 0; k < 20; k++) {
            objects.add(new SphereObject(new Point(5, 0, 0), 1 + k));
        }
        session.reply(new InitBundle(objects, SPATIAL.withSize(100, 100, 100)));
        WorldAnswer.Identified told = (WorldAnswer.Identified) ask(place(5, 0)).get(0);
        assertThat(told.obstacles())
                .extracting(Obstacle::index)
                .containsExactly(1L, 2L, 3L, 4L, 5L, 6L, 7L, 8L, 9L, 10L, 11L, 12L, 13L, 14L, 15L, 16L);
        assertThat(told.answer()).isEqualTo(new WorldAnswer.Changed(false, ""));
    }

    /** Numbers go on, however many come and go before anybody asks. */
    @Test
    void numbersGoOnForAsLongAsObjectsComeAndGo() {
        for (int count : new int[] {3, 1500}) {
            session.reply(new InitBundle(List.of(ROBOT), SPATIAL));
            GeometryObject ball = new SphereObject(new Point(0, 0, 4), 0.3).named("ball");
            for (int k = 0; k < count; k++) {
                assertThat(ask(new WorldRequest.Add(ball, false), new WorldRequest.Remove("ball")))
                        .containsOnly(new WorldAnswer.Changed(true, null));
            }
            ask(
                    new WorldRequest.Add(ball, false),
                    new WorldRequest.Add(new SphereObject(new Point(0, 0, 6), 0.3), false));
            assertThat(ask(place(0, 4), place(0, 6)))
                    .containsExactly(
                            blocked(new Obstacle(1L + count, "ball", GeometryObject.Kind.SPHERE, ball.center())),
                            blocked(new Obstacle(2L + count, "", GeometryObject.Kind.SPHERE, new Point(0, 0, 6))));
        }
    }

    /** A session over a world that somebody else made. */
    @Test
    void objectsOfAGivenWorldAreCountedAsItListsThem() {
        Geometry world = new Geometry(20, 6, 20);
        List.of(WALL, POST, ROBOT).forEach(world::addObject);
        Session over = new Session(
                world.snapshot().toGeometry(),
                SessionOptions.ROBOSIM,
                SessionListener.NONE,
                "test",
                System.getLogger("test"));
        Reply reply = Objects.requireNonNull(over.reply(new BatchRequestBundle(List.of(place(-3, 0)))));
        assertThat(((BatchAnswerBundle) reply.bundle()).answers())
                .containsExactly(blocked(new Obstacle(1, "", GeometryObject.Kind.CYLINDER, POST.center())));
    }

    @Test
    void anInitThatAsksIsAnswered() {
        InitBundle init = new InitBundle(List.of(WALL, ROBOT, WALL), SPATIAL);
        BatchAnswerBundle told =
                (BatchAnswerBundle) Objects.requireNonNull(session.answer(new InitBundle.Answered(init)));
        assertThat(told.answers()).isEqualTo(ask(new WorldRequest.Describe()));
        assertThat(((WorldAnswer.Described) told.answers().get(0)).leftOut()).hasSize(1);
    }

    /** The same motions that turn while they translate, all or nothing and up to a clearance. */
    @Test
    void drivesAreThoseOfGeometry() {
        SplittableRandom random = new SplittableRandom(29);
        session.reply(new InitBundle(List.of(WALL, POST, ROBOT), SPATIAL));
        Geometry world = new Geometry(20, 6, 20);
        List.of(WALL, POST, ROBOT).forEach(world::addObjectUnchecked);
        int made = 0;
        for (int k = 0; k < 200; k++) {
            double ry = random.nextDouble(-2, 2);
            double seconds = random.nextDouble(4);
            Twist twist = new Twist(random.nextDouble(-1, 4), 0, 0.2 * random.nextDouble(), Degrees.toDegrees(ry));
            Double clearance = k % 2 == 0 ? null : 0.02;
            MoveResult truth = clearance == null
                    ? world.move("robot", twist, seconds)
                    : world.moveToContact("robot", twist, seconds, clearance);
            WorldAnswer.Identified answer = (WorldAnswer.Identified)
                    ask(new WorldRequest.Drive("robot", twist.x(), 0, twist.z(), ry, seconds, clearance))
                            .get(0);
            WorldAnswer.Went went = (WorldAnswer.Went) answer.answer();
            assertThat(went.made()).isEqualTo(truth.allowed());
            assertThat(went.fraction()).isEqualTo(truth.fraction());
            assertThat(went.turnFraction()).isEqualTo(truth.turnFraction());
            assertThat(went.contact()).isEqualTo(truth.contact());
            assertThat(Objects.requireNonNull(session.world()).getObject("robot"))
                    .isEqualTo(world.getObject("robot"));
            made += went.made() ? 1 : 0;
        }
        assertThat(made).isBetween(20, 180);
    }

    /** The same moves to a contact, and along it, in a world of our own. */
    @Test
    void movesToAContactAndAlongItAreThoseOfGeometry() {
        SplittableRandom random = new SplittableRandom(23);
        List<GeometryObject> objects = new ArrayList<>(List.of(WALL, POST, ROBOT));
        for (int k = 0; k < 30; k++) {
            Point at = new Point(16 * random.nextDouble() - 8, 0, 16 * random.nextDouble() - 8);
            objects.add(new BoxObject(at, 1, 1, 0.5).turned(0, 90 * random.nextDouble()));
        }
        session.reply(new InitBundle(objects, SPATIAL));
        Geometry world = new Geometry(20, 6, 20);
        objects.forEach(world::addObjectUnchecked);
        int made = 0;
        int bends = 0;
        int borders = 0;
        for (int k = 0; k < 400; k++) {
            double x = 6 * random.nextDouble() - 1;
            double z = 2 * random.nextDouble() - 1;
            double ry = 6 * random.nextDouble() - 3;
            Move move = new Move(x, 0, z, 0, Degrees.toDegrees(ry));
            if (k % 2 == 0) {
                MoveResult truth = world.moveToContact("robot", move, 0.01);
                WorldAnswer.Identified told =
                        (WorldAnswer.Identified) ask(new WorldRequest.GoToContact("robot", x, 0, z, 0, ry, 0.01))
                                .get(0);
                WorldAnswer.Went went = (WorldAnswer.Went) told.answer();
                assertThat(went.made()).isEqualTo(truth.allowed());
                assertThat(went.fraction()).isEqualTo(truth.fraction());
                assertThat(went.turnFraction()).isEqualTo(truth.turnFraction());
                assertThat(went.contact()).isEqualTo(truth.contact());
                assertThat(went.normal()).isEqualTo(truth.normal());
                assertThat(told.obstacles()).isEqualTo(obstacles(objects, truth.obstacle()));
                made += went.made() ? 1 : 0;
            } else {
                SlideResult truth = world.moveAndSlide("robot", move, 0.01, 3);
                WorldAnswer.Slid slid =
                        (WorldAnswer.Slid) ask(new WorldRequest.GoAndSlide("robot", x, 0, z, 0, ry, 0.01, 3))
                                .get(0);
                assertThat(slid.displacement()).isEqualTo(truth.made());
                assertThat(slid.length()).isEqualTo(truth.length());
                assertThat(slid.left()).isEqualTo(truth.left());
                assertThat(slid.turnFraction()).isEqualTo(truth.turnFraction());
                assertThat(slid.contacts()).hasSameSizeAs(truth.contacts());
                for (int c = 0; c < slid.contacts().size(); c++) {
                    WorldAnswer.Contact contact = slid.contacts().get(c);
                    assertThat(contact.point())
                            .isEqualTo(truth.contacts().get(c).point());
                    assertThat(contact.normal())
                            .isEqualTo(truth.contacts().get(c).normal());
                    Obstacle obstacle = contact.obstacle();
                    assertThat(obstacle == null ? List.of() : List.of(obstacle))
                            .isEqualTo(
                                    obstacles(objects, truth.contacts().get(c).obstacle()));
                    borders += obstacle == null ? 1 : 0;
                }
                bends += slid.contacts().size() > 1 ? 1 : 0;
            }
            assertThat(Objects.requireNonNull(session.world()).getObject("robot"))
                    .isEqualTo(world.getObject("robot"));
        }
        assertThat(made).isBetween(40, 195);
        assertThat(bends).isGreaterThan(10);
        assertThat(borders).isGreaterThan(3);
    }

    /** What the answer should have for an object of a list; none has moved but the robot. */
    private static List<Obstacle> obstacles(List<GeometryObject> objects, @Nullable GeometryObject met) {
        for (int k = 0; met != null && k < objects.size(); k++) {
            if (objects.get(k).equals(met)) {
                String name = Objects.requireNonNullElse(met.name(), "");
                return List.of(new Obstacle(k, name, met.kind(), met.center()));
            }
        }
        return List.of();
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

    @Test
    void whatOverlapsIsFreedOrStays() {
        Session crowded = new Session();
        crowded.reply(new InitBundle(
                List.of(
                        new BoxObject(new Point(), 1, 1, 1).moveable("crate"),
                        new BoxObject(new Point(0.75, 0, 0), 1, 1, 4).named("wall")),
                new WorldSettings(20, 6, 20, Dimension.PLANAR, Accuracy.EXACT)));
        WorldRequest.Separate little = new WorldRequest.Separate("crate", 0.2);
        WorldRequest.Separate enough = new WorldRequest.Separate("crate", 1);
        BatchRequestBundle asked = new BatchRequestBundle(List.of(
                little,
                new WorldRequest.Locate("crate"),
                enough,
                new WorldRequest.Locate("crate"),
                enough,
                new WorldRequest.Separate("wall", 1)));
        var reply = Objects.requireNonNull(crowded.reply(asked));
        var answers = ((BatchAnswerBundle) reply.bundle()).answers();
        assertThat(answers.get(0)).isEqualTo(new WorldAnswer.Changed(false, null));
        assertThat(answers.get(0).fits(little)).isTrue();
        assertThat(new WorldAnswer.Changed(true, null).fits(little)).isFalse();
        assertThat(((WorldAnswer.Located) answers.get(1)).center()).isEqualTo(new Point());
        Point freed = ((WorldAnswer.Separated) answers.get(2)).displacement();
        assertThat(freed.x()).isBetween(-0.251, -0.25);
        assertThat(answers.get(2).fits(enough)).isTrue();
        assertThat(((WorldAnswer.Located) answers.get(3)).center()).isEqualTo(freed);
        assertThat(answers.get(4)).isEqualTo(new WorldAnswer.Separated(new Point()));
        assertThat(reply.problems()).hasSize(1);
        assertThat(reply.problems().get(0).toString()).contains("no moveable object \"wall\"");
    }

    @Test
    void aLoadIsAttachedAndDetached() {
        GeometryObject crate = new BoxObject(new Point(-1, 0, 0), 0.5, 0.5, 0.5).moveable("crate");
        session.reply(new InitBundle(List.of(WALL, crate, ROBOT), SPATIAL));
        Mount beyond = new Mount(new Point(3, 0, 0));
        WorldRequest.Attach refused = new WorldRequest.Attach("crate", "robot", beyond);
        var answers = ask(
                refused,
                new WorldRequest.Attach("crate", "robot", new Mount(new Point(30, 0, 0))),
                new WorldRequest.Attach("crate", "robot", new Mount(new Point(0.5, 0, 0))),
                go(0, Math.PI / 2),
                new WorldRequest.Locate("crate"),
                new WorldRequest.ListObjects(0, 9),
                new WorldRequest.Detach("crate"),
                go(0, Math.PI / 2),
                new WorldRequest.Locate("crate"),
                new WorldRequest.ListObjects(0, 9));
        assertThat(answers.get(0)).isEqualTo(new WorldAnswer.Changed(false, "wall"));
        assertThat(answers.get(0).fits(refused)).isTrue();
        assertThat(answers.get(1)).isEqualTo(new WorldAnswer.Changed(false, null));
        assertThat(answers.get(2)).isEqualTo(new WorldAnswer.Changed(true, null));
        assertThat(((WorldAnswer.Located) answers.get(4)).center()).isEqualTo(new Point(0, 0, -0.5));
        assertThat(names(answers.get(5))).containsExactly("0 wall", "2 robot");
        assertThat(answers.get(6)).isEqualTo(new WorldAnswer.Changed(true, null));
        assertThat(((WorldAnswer.Located) answers.get(8)).center()).isEqualTo(new Point(0, 0, -0.5));
        assertThat(names(answers.get(9))).as("it counts as added anew").containsExactly("0 wall", "2 robot", "3 crate");
    }

    private static List<String> names(Object listed) {
        return ((WorldAnswer.Listed) listed)
                .objects().stream()
                        .map(each -> each.index() + " " + each.name())
                        .toList();
    }

    @Test
    void whatCannotBeAttachedIsRefused() {
        session.reply(new InitBundle(List.of(WALL, ROBOT), SPATIAL));
        Reply reply = reply(
                new WorldRequest.Attach("robot", "robot", null),
                new WorldRequest.Attach("robot", "wall", null),
                new WorldRequest.Attach("wall", "robot", null),
                new WorldRequest.Attach("robot", "nobody", null),
                new WorldRequest.Detach("robot"),
                new WorldRequest.Detach("nobody"));
        assertThat(reply.problems()).hasSize(6);
        assertThat(((BatchAnswerBundle) reply.bundle()).answers()).allMatch(NoAnswer.class::isInstance);
    }

    /** A carrier of an init: its loads have no index of their own until they are detached. */
    @Test
    void whatCameAttachedIsDetached() {
        GeometryObject carrier = new ObjectGroup(List.of(
                        ROBOT.at(Pose.ORIGIN), new BoxObject(new Point(1, 0, 0), 0.5, 0.5, 0.5).moveable("crate")))
                .moveable("robot");
        GeometryObject second = new ObjectGroup(List.of(
                        new SphereObject(new Point(), 0.1).moveable("other"),
                        new SphereObject(new Point(1, 0, 0), 0.1).moveable("crate")))
                .moveable("other")
                .movedTo(new Point(-5, 0, -5));
        session.reply(new InitBundle(List.of(WALL, carrier, second), SPATIAL));
        WorldAnswer.Described told =
                (WorldAnswer.Described) ask(new WorldRequest.Describe()).get(0);
        assertThat(told.added()).isEqualTo(2);
        assertThat(told.leftOut().get(0).reason()).contains("loads must be unique");
        var answers = ask(
                new WorldRequest.Locate("crate"),
                new WorldRequest.Detach("crate"),
                new WorldRequest.ListObjects(0, 9),
                new WorldRequest.Go("crate", 0.1, 0, 0, 0, 0));
        assertThat(((WorldAnswer.Located) answers.get(0)).center()).isEqualTo(new Point(1, 0, 0));
        assertThat(names(answers.get(2))).containsExactly("0 wall", "1 robot", "3 crate");
        assertThat(((WorldAnswer.Went) answers.get(3)).made()).isTrue();
    }

    @Test
    void removingACarrierLeavesItsLoads() {
        GeometryObject crate = new BoxObject(new Point(-1, 0, 0), 0.5, 0.5, 0.5).moveable("crate");
        session.reply(new InitBundle(List.of(crate, ROBOT), SPATIAL));
        var answers = ask(
                new WorldRequest.Attach("crate", "robot", null),
                new WorldRequest.Remove("robot"),
                new WorldRequest.ListObjects(0, 9));
        assertThat(names(answers.get(2))).containsExactly("2 crate");
    }

    /** A sill of 0.2 stops what slides, and a walker climbs it and is put down behind it. */
    @Test
    void aWalkerClimbsASill() {
        double x = 0;
        double y = 0;
        for (WorldRequest.Walk walk : Arrays.asList(null, new WorldRequest.Walk(0.3, 0.5, 0.4))) {
            Session walking = new Session();
            walking.reply(new InitBundle(
                    List.of(
                            new BoxObject(new Point(0, -1.05, 0), 10, 0.1, 10),
                            new BoxObject(new Point(2, -0.9, 0), 2, 0.2, 10),
                            new CylinderObject(new Point(-1, -0.49, 0), 0.3, 1).moveable("robot")),
                    new WorldSettings(20, 6, 20, Dimension.SPATIAL, Accuracy.EXACT)));
            walking.reply(new BatchRequestBundle(
                    List.of(new WorldRequest.GoAndSlide("robot", 3, 0, 0, 0, 0, 0.01, 8, walk))));
            BatchAnswerBundle answer = (BatchAnswerBundle) Objects.requireNonNull(
                            walking.reply(new BatchRequestBundle(List.of(new WorldRequest.Locate("robot")))))
                    .bundle();
            Point at = ((WorldAnswer.Located) answer.answers().get(0)).center();
            if (walk == null) {
                x = at.x();
                y = at.y();
                assertThat(x).isCloseTo(1 - 0.3 - 0.01, within(1e-3));
            } else {
                assertThat(at.x()).isGreaterThan(x + 0.5);
                assertThat(at.y()).isCloseTo(-0.8 + 0.5 + 0.01, within(1e-2)).isGreaterThan(y + 0.1);
            }
        }
    }
}
