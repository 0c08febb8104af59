package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.net.watch.WatchServer;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.SurfaceMixing;
import robosim.geometry.protocol.motion.Velocity;

/** What watchers are told, without sockets. */
class WatchingTest {
    private static final GeometryObject WALL = new BoxObject(new Point(3, 0, 0), 1, 1, 4).named("wall");
    private static final GeometryObject ROBOT = new CylinderObject(new Point(), 0.5, 1).moveable("r");
    private static final Bundle FORWARD = new MoveBundle(List.of(Conversation.move("r", 0.5, 0)));
    private static final Bundle LOOK = new SonarRequestBundle(List.of(new SonarRequest("r", 1, 0)));

    private final Watching watching = new Watching(SessionOptions.ROBOSIM);
    private final AtomicInteger broken = new AtomicInteger();

    /** A session that is watched. */
    private final class Held {
        final SessionListener listener;
        final Session session;

        Held(String name) {
            listener = watching.apply(name);
            session = new Session(SessionOptions.ROBOSIM, listener, name);
        }

        Held world(GeometryObject... objects) {
            session.reply(new InitBundle(List.of(objects)));
            return this;
        }
    }

    private WatchServer.Lines join() {
        return watching.join(broken::incrementAndGet);
    }

    /** All that waits for a watcher, read as a scenario. */
    private static List<Step> told(WatchServer.Lines lines) throws Exception {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (byte[] next = lines.next(0); next.length > 0; next = lines.next(0)) {
            all.write(next);
        }
        List<Step> steps = new ArrayList<>();
        try (ScenarioReader reader = ScenarioReader.of(new ByteArrayInputStream(all.toByteArray()), "watch")) {
            for (Step step = reader.next(); step != null; step = reader.next()) {
                steps.add(step);
            }
        }
        return steps;
    }

    /** The world at the end of a replay, whose answers must be those that were told. */
    private static Geometry world(List<Step> steps) {
        Session[] session = new Session[1];
        Replay replay = new Replay(SessionOptions.ROBOSIM, new SessionListener() {
            @Override
            public void opened(Session opened) {
                session[0] = opened;
            }
        });
        assertThat(steps).allSatisfy(step -> assertThat(replay.step(step)).isNull());
        return session[0].world();
    }

    /** A robot that pushes a crate, with what it was told at the beginning. */
    private Held pushing() {
        GeometryObject crate = new BoxObject(new Point(1.5, 0, 0.1), 0.5, 0.5, 0.5).moveable("crate");
        Held held = new Held("pushing").world(WALL, ROBOT, crate);
        held.session.reply(new StepBundle(
                0.125,
                List.of(
                        BodyRequest.of("r").withMass(9).withDrive(DriveSettings.of(DriveSettings.Kind.VELOCITY)),
                        BodyRequest.of("crate").withMass(2).withVelocity(new Velocity(0, 0, 0.25, 1.1)),
                        BodyRequest.of("nobody")),
                List.of(new DriveCommand("r", 1, 0, 0.3)),
                new SurfaceMixing(SurfaceMixing.Rule.LARGER, SurfaceMixing.Rule.MEAN),
                List.of()));
        return held;
    }

    @Test
    void whoComesLateGoesOnWithTheBodiesToTheBit() throws Exception {
        for (int count = 0; count < 24; count += 3) {
            Held held = pushing();
            for (int k = 0; k < count; k++) {
                held.session.reply(new StepBundle(0.125, List.of(), List.of()));
            }
            WatchServer.Lines lines = join();
            for (int k = 0; k < 6; k++) {
                held.session.reply(LOOK);
                held.session.reply(new StepBundle(0.125, List.of(), List.of()));
            }
            List<Step> steps = told(lines);
            assertThat(steps).hasSize(1 + 1 + count + 12);
            assertThat(world(steps).objects()).isEqualTo(held.session.world().objects());
        }
    }

    /** Beyond the limit what was told is forgotten, and the bodies are told as they are. */
    @Test
    void whoComesVeryLateGetsTheBodiesAsTheyAre() throws Exception {
        Held held = pushing();
        for (int k = 0; k <= BodyHistory.MOST_STEPS; k++) {
            held.session.reply(new StepBundle(0.0005, List.of(), List.of()));
        }
        WatchServer.Lines lines = join();
        for (int k = 0; k < 3; k++) {
            held.session.reply(new StepBundle(0.125, List.of(), List.of()));
        }
        List<Step> steps = told(lines);
        assertThat(steps).hasSize(2 + 3);
        StepBundle bodies = (StepBundle) steps.get(1).request();
        assertThat(bodies.seconds()).isZero();
        assertThat(bodies.bodies()).extracting(BodyRequest::objectName).containsExactly("r", "crate");
        assertThat(bodies.commands()).containsExactly(new DriveCommand("r", 1, 0, 0.3));
        assertThat(bodies.mixing()).isEqualTo(new SurfaceMixing(SurfaceMixing.Rule.LARGER, SurfaceMixing.Rule.MEAN));
        Replay replay = new Replay(SessionOptions.ROBOSIM);
        steps.forEach(replay::step);
        StepBundle.Answer replayed = (StepBundle.Answer) replay.reply().bundle();
        StepBundle.Answer live = (StepBundle.Answer) steps.get(4).expected().bundle();
        for (int k = 0; k < 2; k++) { // what is pushed is no longer known to be
            Point there = live.bodies().get(k).center();
            Point here = replayed.bodies().get(k).center();
            assertThat(here.x()).isCloseTo(there.x(), within(0.02));
            assertThat(here.z()).isCloseTo(there.z(), within(0.02));
        }
        assertThat(live.bodies().get(0).center().x()).isGreaterThan(1);
    }

    private static GeometryObject robot(Step step) {
        List<GeometryObject> objects = ((InitBundle) step.request()).objects();
        return objects.get(objects.size() - 1);
    }

    @Test
    void whoComesFirstIsToldAll() throws Exception {
        WatchServer.Lines lines = join();
        Held held = new Held("one").world(WALL, ROBOT);
        var made = held.session.reply(FORWARD);
        var heard = held.session.reply(LOOK);
        List<Step> steps = told(lines);
        assertThat(steps).hasSize(3);
        assertThat(steps).allSatisfy(step -> assertThat(step.timing()).isNotNull());
        assertThat(((InitBundle) steps.get(0).request()).objects()).containsExactly(WALL, ROBOT);
        assertThat(steps.get(1).request()).isEqualTo(FORWARD);
        assertThat(steps.get(1).expected()).isEqualTo(made);
        assertThat(steps.get(2).expected()).isEqualTo(heard);
    }

    @Test
    void whoComesLateIsToldTheWorldAsItStands() throws Exception {
        Held held = new Held("one").world(WALL, ROBOT);
        for (int k = 0; k < 8; k++) {
            held.session.reply(FORWARD); // refused from the fourth on
        }
        WatchServer.Lines lines = join();
        held.session.reply(LOOK);
        List<Step> steps = told(lines);
        assertThat(steps).hasSize(2);
        assertThat(robot(steps.get(0)).center()).isEqualTo(new Point(1.5, 0, 0));
        assertThat(robot(steps.get(0))).isEqualTo(held.session.world().getObject("r"));
        assertThat(steps.get(0).notes()).containsExactly("one, as it is after 9 steps");
        // The size is that of the session's own world, which was made for the objects where they began.
        InitBundle now = (InitBundle) steps.get(0).request();
        assertThat(now.settings()).isNotNull();
        assertThat(now.settings().width()).isEqualTo(held.session.world().width());
        assertThat(now.settings().dimension()).isEqualTo(Dimension.PLANAR);
        // And whoever carries it on gets the session's own answers.
        Replay replay = new Replay(SessionOptions.ROBOSIM);
        assertThat(steps).allSatisfy(step -> assertThat(replay.step(step)).isNull());
    }

    /** Moves and changes in batches, and steps, are moves too. */
    @Test
    void whoComesLateIsToldWhatBatchesAndStepsMoved() throws Exception {
        GeometryObject ball = new CylinderObject(new Point(-5, 0, 5), 0.5, 1).moveable("ball");
        List<Bundle> requests = List.of(
                new BatchRequestBundle(List.of(new WorldRequest.Go("r", 0.5, 0, 0, 0, 0))),
                new BatchRequestBundle(List.of(new WorldRequest.GoToContact("r", 9, 0, 0, 0, 0, 0.25))),
                new BatchRequestBundle(List.of(new WorldRequest.Place("r", new Point(0, 0, 2), 1))),
                new BatchRequestBundle(List.of(new WorldRequest.Add(ball, false), new WorldRequest.Remove("wall"))),
                new StepBundle(1, List.of(), List.of(new DriveCommand("r", 1, 0, 0))));
        for (int count = 1; count <= requests.size(); count++) {
            Held held = new Held("session " + count).world(WALL, ROBOT);
            requests.subList(0, count).forEach(held.session::reply);
            WatchServer.Lines lines = join();
            held.session.reply(LOOK);
            Geometry now = world(told(lines));
            assertThat(now.objects())
                    .as("after " + count)
                    .containsExactlyInAnyOrderElementsOf(held.session.world().objects());
            assertThat(now.objects()).doesNotContain(ROBOT);
            held.listener.ended();
        }
    }

    @Test
    void aWatcherStaysWithItsSessionUntilThatIsOver() throws Exception {
        Held one = new Held("one").world(ROBOT);
        WatchServer.Lines lines = join();
        Held two = new Held("two").world(WALL, ROBOT);
        two.session.reply(FORWARD);
        new Held("three"); // has no world yet
        one.session.reply(LOOK);
        assertThat(told(lines)).hasSize(2);
        one.listener.ended();
        WatchServer.Lines second = join();
        one.session.reply(LOOK);
        two.session.reply(LOOK);
        List<Step> late = told(second);
        assertThat(late).hasSize(2);
        assertThat(late.get(0).notes()).containsExactly("two, as it is after 2 steps");
        // The first one was led over to the same.
        byte[] led = lines.next(0);
        assertThat(new String(led, "UTF-8")).contains("\"two, as it is after 2 steps\"", "\"init\"");
        assertThat(new String(lines.next(0), "UTF-8")).contains("\"sonars\"", "\"distances\"", "\"time\"");
        two.listener.ended();
        assertThat(lines.next(0)).isEmpty();
        new Held("four").world(ROBOT);
        assertThat(new String(lines.next(0), "UTF-8")).contains("\"four, as it is after 1 step\"");
        lines.close();
    }

    @Test
    void whoReadsTooSlowlyIsToldNoMoreAndTheSessionGoesOn() throws Exception {
        Held held = new Held("one").world(WALL, ROBOT);
        WatchServer.Lines slow = join();
        WatchServer.Lines quick = join();
        int told = 0;
        for (int k = 0; k < WatcherQueue.MOST_STEPS + 100; k++) {
            assertThat(held.session.reply(LOOK)).isNotNull();
            while (quick.next(0).length > 0) {
                told++;
            }
        }
        assertThat(broken).hasValue(1);
        assertThat(slow.problem()).startsWith("it reads too slowly");
        assertThat(quick.problem()).isNull();
        assertThat(told).isEqualTo(2 + WatcherQueue.MOST_STEPS + 100);
        slow.next(0); // its header
        assertThatThrownBy(() -> slow.next(0)).hasMessageContaining("too slowly");
        slow.close();
        held.session.reply(LOOK);
        assertThat(broken).hasValue(1);
    }

    @Test
    void manyRequestsAreTooMuchAsWell() throws Exception {
        Held held = new Held("one").world(WALL, ROBOT);
        WatchServer.Lines lines = join();
        List<SonarRequest> many = new ArrayList<>();
        for (int k = 0; k < 200_000; k++) {
            many.add(new SonarRequest("r", 1, 0));
        }
        Bundle large = new SonarRequestBundle(many);
        for (int k = 0; k < 4; k++) {
            held.session.reply(large);
        }
        assertThat(broken).hasValue(0);
        held.session.reply(large);
        assertThat(broken).hasValue(1);
        assertThat(lines.problem()).contains("too slowly: 5 steps");
    }

    @Test
    void whatASessionLeftOutIsNotTold() throws Exception {
        GeometryObject twin = new BoxObject(new Point(-3, 0, 0), 1, 1, 1).named("wall");
        new Held("one").world(WALL, twin, ROBOT);
        InitBundle now = (InitBundle) told(join()).get(0).request();
        assertThat(now.objects()).containsExactly(WALL, ROBOT);
    }

    /** A floor of that many rows of as many vertices, of its own. */
    private static GeometryObject floor(int rows) {
        List<Point> vertices = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < rows; j++) {
                vertices.add(new Point(i, 0, j));
                if (i > 0 && j > 0) {
                    int last = i * rows + j;
                    faces.add(new int[] {last - rows - 1, last - rows, last, last - 1});
                }
            }
        }
        return new MeshObject(vertices, faces.toArray(int[][]::new));
    }

    @Test
    void aFewLargeMeshesAreTooMuchAsWell() {
        // A floor weighs 10,000 vertices and twice as many triangles: 33 of them fit, the header waits beside them.
        Held held = new Held("one").world(WALL, ROBOT);
        WatchServer.Lines lines = join();
        int inits = 0;
        while (broken.get() == 0 && inits < 1000) {
            held.world(new ObjectGroup(List.of(floor(100))));
            inits++;
        }
        assertThat(inits).isBetween(30, 40);
        assertThat(lines.problem()).contains("too slowly");
    }

    @Test
    void longNamesAreTooMuchAsWell() {
        String name = "n".repeat(60_000);
        Held held = new Held("one").world(WALL, ROBOT);
        join();
        int steps = 0;
        while (broken.get() == 0 && steps < 5000) {
            held.session.reply(new SonarRequestBundle(List.of(new SonarRequest(name + steps, 1, 0))));
            steps++;
        }
        assertThat(steps).isBetween(400, 600);
    }

    @Test
    void whatALargeStepNeededIsNotKept() throws Exception {
        WatcherQueue.Buffer buffer = new WatcherQueue.Buffer();
        buffer.writeBytes(new byte[5_000_000]);
        assertThat(buffer.room()).isGreaterThanOrEqualTo(5_000_000);
        assertThat(buffer.take()).hasSize(5_000_000);
        assertThat(buffer.room()).isLessThan(100_000);
        buffer.write(7);
        assertThat(buffer.take()).containsExactly(7);
        assertThat(buffer.take()).isEmpty();
    }

    @Test
    void aSessionOverAWorldThatIsThereBeginsWithIt() throws Exception {
        WatchServer.Lines early = join();
        Geometry geometry = new Geometry(20, 5, 10);
        geometry.addObject(WALL);
        geometry.addObject(ROBOT);
        SessionListener listener = watching.apply("one");
        Session session =
                new Session(geometry, SessionOptions.ROBOSIM, listener, "one", System.getLogger("robosim.test"));
        session.reply(FORWARD);
        WatchServer.Lines late = join();
        session.reply(LOOK);
        List<Step> all = told(early);
        assertThat(all).hasSize(3);
        assertThat(((InitBundle) all.get(0).request()).objects()).containsExactly(WALL, ROBOT);
        assertThat(all.get(1).request()).isEqualTo(FORWARD);
        List<Step> end = told(late);
        assertThat(end).hasSize(2);
        assertThat(robot(end.get(0)).center()).isEqualTo(new Point(0.5, 0, 0));
        assertThat(((InitBundle) end.get(0).request()).settings().width()).isEqualTo(20);
        Replay replay = new Replay(SessionOptions.ROBOSIM);
        assertThat(all).allSatisfy(step -> assertThat(replay.step(step)).isNull());
    }

    @Test
    void whoCannotBeToldIsToldWhy() throws Exception {
        // Half a surrogate pair, as a peer in Java serialization may have it, is refused by JSON lines.
        Held held = new Held("one").world(WALL, ROBOT);
        WatchServer.Lines lines = join();
        lines.next(0); // the header
        lines.next(0); // the world
        held.session.reply(new SonarRequestBundle(List.of(new SonarRequest("\ud800", 1, 0))));
        assertThat(new String(lines.next(0), "UTF-8")).contains("\"note\"", "a step cannot be written as lines: ");
        assertThatThrownBy(() -> lines.next(0)).hasMessageContaining("cannot be written");
        assertThat(lines.problem()).contains("cannot be written");
    }

    @Test
    void itListensOnOnePortUntilItIsClosed() throws Exception {
        int first = watching.listen(0);
        assertThatThrownBy(() -> watching.listen(0))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("watching must not be listening already (got: port " + first + ")");
        try (ScenarioReader reader = Watching.dial("127.0.0.1", first)) {
            assertThat(reader.header().title()).isEqualTo("a live session");
        }
        watching.close();
        watching.close();
        assertThatThrownBy(() -> Watching.dial("127.0.0.1", first)).isInstanceOf(IOException.class);
        int second = watching.listen(0);
        assertThat(second).isPositive();
        watching.close();
    }
}
