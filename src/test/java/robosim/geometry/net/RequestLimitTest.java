package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Rulings;
import robosim.geometry.WorkLimit;
import robosim.geometry.WorkLimitException;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.Velocity;

/** No request takes more than its limit, nor goes on when nobody waits for it; those of others are answered meanwhile. */
@Tag("clock")
class RequestLimitTest {
    private static final WorldSettings ROOM = new WorldSettings(10, 10, 10, Dimension.SPATIAL, Accuracy.EXACT);

    /** Minutes of work. */
    private static final MoveRequest LONG = new MoveRequest("m", 0, 1e-5, 0, 0, 0);

    private static final MoveRequest SHORT = new MoveRequest("ball", 0.1, 0, 0, 0, 0);

    private static InitBundle rulings(int slivers) {
        List<GeometryObject> objects = List.of(
                Rulings.mesh(slivers, true, 0),
                Rulings.mesh(slivers, false, 1e-3).moveable("m"),
                new BoxObject(new Point(3, 3, 3), 1, 1, 1).named("box"),
                new SphereObject(new Point(-3, 3, 3), 0.5).moveable("ball"));
        return new InitBundle(objects, ROOM);
    }

    private static NetOptions within(Duration time, long work) {
        return NetOptions.defaults().withQuotas(Quotas.DEFAULT.withRequestLimit(time, work));
    }

    private static GeometryServer server(NetOptions options) {
        return new GeometryServer(InetAddress.getLoopbackAddress(), 0, options);
    }

    /** Options with no limit in practice, and with a listener that tells of each request of a kind that has begun. */
    private static NetOptions tellingOf(CountDownLatch begun, Class<? extends Bundle> kind) {
        return within(Duration.ofHours(1), Long.MAX_VALUE).withListeners(connection -> new SessionListener() {
            @Override
            public void requested(Bundle request) {
                if (kind.isInstance(request)) {
                    begun.countDown();
                }
            }
        });
    }

    private static boolean comesTrue(BooleanSupplier what) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
        while (!what.getAsBoolean() && System.nanoTime() < end) {
            TimeUnit.MILLISECONDS.sleep(5);
        }
        return what.getAsBoolean();
    }

    // ---- sessions ----

    private static final BatchRequestBundle LOOK = new BatchRequestBundle(List.of(
            new WorldRequest.Describe(),
            new WorldRequest.ListObjects(0, 100),
            new WorldRequest.Locate("ball"),
            new WorldRequest.Locate("m")));

    private static String look(Session session, WorkLimit limit) {
        session.within(WorkLimit.none());
        String state = String.valueOf(session.answer(LOOK));
        session.within(limit);
        return state;
    }

    @Test
    void aBundleIsCarriedOutAsAWholeOrNotAtAll() {
        WorkLimit limit = WorkLimit.of(50_000);
        Session session = new Session().within(WorkLimit.none());
        session.reply(rulings(2000));
        BoxObject box = new BoxObject(new Point(0, -3, 0), 1, 1, 1);
        session.reply(new BatchRequestBundle(List.of(
                new WorldRequest.Remove("box"),
                new WorldRequest.Add(box.named("box"), false),
                new WorldRequest.Add(box.movedTo(new Point(3, -3, 0)), false))));
        String before = look(session, limit);
        List<Bundle> bundles = List.of(
                new MoveBundle(List.of(SHORT, LONG)),
                new BatchRequestBundle(List.of(
                        new WorldRequest.Remove("box"),
                        new WorldRequest.Remove("ball"),
                        new WorldRequest.Add(box.movedTo(new Point(-3, -3, 0)).moveable("ball"), false),
                        new WorldRequest.Add(box.movedTo(new Point(3, -3, 0)), true),
                        new WorldRequest.Go("ball", 0.1, 0, 0, 0, 0),
                        new WorldRequest.Go("m", 0, 1e-5, 0, 0, 0))));
        for (Bundle bundle : bundles) {
            assertThatThrownBy(() -> session.reply(bundle))
                    .isInstanceOf(WorkLimitException.class)
                    .hasMessageStartingWith("a request must take at most 50000 units of work");
            assertThat(look(session, limit)).isEqualTo(before);
        }
        assertThat(((MoveBundle) Objects.requireNonNull(session.answer(new MoveBundle(List.of(SHORT))))).moves())
                .containsExactly(SHORT);
        session.reply(new BatchRequestBundle(List.of(new WorldRequest.Add(box.movedTo(new Point(0, 3, 3)), false))));
        assertThat(look(session, limit)).contains("ListedObject[index=6");
    }

    @Test
    void aStepThatIsEndedLeavesBodiesAndCommandsAsTheyWere() {
        List<GeometryObject> objects = new ArrayList<>();
        for (int k = 0; k < 40; k++) {
            objects.add(new CylinderObject(new Point(k % 8, 0, k / 8 - 3), 0.4, 1).moveable("body " + k));
        }
        InitBundle init = new InitBundle(objects, new WorldSettings(20, 5, 20, Dimension.PLANAR, Accuracy.EXACT));
        List<BodyRequest> bodies = new ArrayList<>();
        for (int k = 0; k < 20; k++) {
            bodies.add(BodyRequest.of("body " + k).withVelocity(new Velocity(1 - k % 3, 0, 0.5, 0.1)));
        }
        StepBundle first = new StepBundle(0.5, bodies, List.of(new DriveCommand("body 0", 1, 0, 0.2)));
        StepBundle ended = new StepBundle(
                3600,
                List.of(BodyRequest.of("body 30").withVelocity(new Velocity(1, 0, 1, 0))),
                List.of(new DriveCommand("body 0", -1, 0, 0), new DriveCommand("body 31", 1, 0, 1)));
        StepBundle last = new StepBundle(0.5, List.of(), List.of());

        Session session = new Session().within(WorkLimit.none());
        Session twin = new Session().within(WorkLimit.none());
        for (Session each : List.of(session, twin)) {
            each.reply(init);
            each.reply(first);
        }
        session.within(WorkLimit.of(200));
        assertThatThrownBy(() -> session.reply(ended)).isInstanceOf(WorkLimitException.class);
        session.within(WorkLimit.none());
        assertThat(session.reply(last)).isEqualTo(twin.reply(last));
    }

    @Test
    void anInitThatIsEndedLeavesTheWorldBefore() {
        Session session = new Session().within(WorkLimit.none());
        session.reply(rulings(20));
        String before = look(session, WorkLimit.none());
        int[] left = {3};
        session.within(WorkLimit.none().pausing(() -> {
            if (left[0]-- == 0) {
                throw new IllegalStateException("enough");
            }
        }));
        List<GeometryObject> crowd = new ArrayList<>();
        for (int k = 0; k < 2000; k++) {
            crowd.add(new SphereObject(new Point(0, 0, 0), 1).named("s" + k));
        }
        assertThatThrownBy(() -> session.reply(new InitBundle(crowd, ROOM))).hasMessage("enough");
        assertThat(look(session, WorkLimit.none())).isEqualTo(before);
    }

    // ---- servers ----

    @Test
    void aRequestThatTakesTooLongIsRefusedAndTheSessionGoesOn() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = server(within(Duration.ofMillis(150), Long.MAX_VALUE));
                Peer peer = Peer.dial(server.port())) {
            peer.send(rulings(3000));
            assertThat(peer.move(SHORT, LONG)).isEmpty();
            assertThat(peer.move(SHORT)).containsExactly(SHORT);
            assertThat(peer.measure(new SonarRequest("ball", 1, 0))).hasSize(1).doesNotContain(Double.NaN);
            assertThat(log.linesWith("message 2 was not carried out: a request must take at most 150 ms"))
                    .hasSize(1);
        }
    }

    @Test
    void aJsonPeerIsToldWhyAndGoesOn() throws Exception {
        NetOptions options = within(Duration.ofMinutes(1), 20_000).withOpening(List.of(rulings(2000)));
        try (LogCapture log = new LogCapture();
                GeometryServer server = server(options);
                Peer peer = Peer.dial(server.port());
                BufferedReader heard = new BufferedReader(
                        new InputStreamReader(peer.socket.getInputStream(), StandardCharsets.UTF_8))) {
            peer.send(("{\"type\":\"hello\",\"version\":1}\n"
                            + "{\"type\":\"moves\",\"moves\":[{\"objectName\":\"m\",\"x\":0,\"y\":1e-5,\"z\":0,\"rx\":0,\"ry\":0}]}\n"
                            + "{\"type\":\"moves\",\"moves\":[{\"objectName\":\"ball\",\"x\":0.1,\"y\":0,\"z\":0,\"rx\":0,\"ry\":0}]}\n")
                    .getBytes(StandardCharsets.UTF_8));
            assertThat(heard.readLine()).contains("\"hello\"");
            assertThat(heard.readLine())
                    .contains("\"error\"")
                    .contains("a request must take at most 20000 units of work");
            assertThat(heard.readLine()).contains("\"moves\":[{\"objectName\":\"ball\"");
            assertThat(log.linesWith("was not carried out")).hasSize(1);
        }
    }

    @Test
    void thoseWhoseWorkIsLongAndHaveGoneKeepNobodyWaiting() throws Exception {
        CountDownLatch begun = new CountDownLatch(6);
        try (LogCapture log = new LogCapture();
                GeometryServer server = server(tellingOf(begun, MoveBundle.class))) {
            List<Peer> gone = new ArrayList<>();
            for (int k = 0; k < 6; k++) {
                Peer peer = Peer.dial(server.port());
                peer.send(rulings(2500));
                peer.send(new MoveBundle(List.of(LONG)));
                gone.add(peer);
            }
            try (Peer healthy = Peer.dial(server.port())) {
                healthy.send("{\"type\":\"hello\",\"version\":1}\n{\"type\":\"ping\",\"id\":7}\n"
                        .getBytes(StandardCharsets.UTF_8));
                BufferedReader heard = new BufferedReader(
                        new InputStreamReader(healthy.socket.getInputStream(), StandardCharsets.UTF_8));
                assertThat(heard.readLine()).contains("\"hello\"");
                assertThat(heard.readLine()).contains("\"pong\"");
                assertThat(begun.await(30, TimeUnit.SECONDS)).isTrue();
                for (Peer peer : gone) {
                    peer.close();
                }
                assertThat(comesTrue(() -> server.connections() == 1)).isTrue();
            }
            assertThat(log.linesWith("its work was cancelled, as the peer has gone"))
                    .hasSize(6);
        }
    }

    @Test
    void aPeerThatHasOnlyEndedItsSideGetsItsAnswer() throws Exception {
        for (String tongue : List.of("JSON", "Java")) {
            try (GeometryServer server = server(
                            within(Duration.ofMillis(700), Long.MAX_VALUE).withOpening(List.of(rulings(3000))));
                    Peer peer = Peer.dial(server.port())) {
                if (tongue.equals("Java")) {
                    peer.send(new MoveBundle(List.of(LONG)));
                    peer.send(new MoveBundle(List.of(SHORT)));
                    peer.socket.shutdownOutput();
                    assertThat(peer.receive()).isEqualTo(new MoveBundle(List.of()));
                    assertThat(peer.receive()).isEqualTo(new MoveBundle(List.of(SHORT)));
                } else {
                    peer.send(
                            "{\"type\":\"hello\",\"version\":1}\n{\"type\":\"moves\",\"moves\":[{\"objectName\":\"m\",\"x\":0,\"y\":1e-5,\"z\":0,\"rx\":0,\"ry\":0}]}\n"
                                    .getBytes(StandardCharsets.UTF_8));
                    peer.socket.shutdownOutput();
                    assertThat(peer.heardToTheEnd()).contains("a request must take at most 700 ms");
                }
            }
        }
    }

    @Test
    void theLongStepOfAPeerThatHasGoneIsCancelled() throws Exception {
        List<GeometryObject> objects = new ArrayList<>();
        List<BodyRequest> bodies = new ArrayList<>();
        for (int k = 0; k < 2000; k++) {
            objects.add(new CylinderObject(new Point(k % 50 - 25, 0, k / 50 - 20), 0.4, 1).moveable("b" + k));
            bodies.add(BodyRequest.of("b" + k).withVelocity(new Velocity(1 - k % 3, 0, k % 5 - 2, 0.1)));
        }
        CountDownLatch begun = new CountDownLatch(1);
        try (LogCapture log = new LogCapture();
                GeometryServer server = server(tellingOf(begun, StepBundle.class));
                Peer peer = Peer.dial(server.port())) {
            peer.send(new InitBundle(objects, new WorldSettings(100, 5, 100, Dimension.PLANAR, Accuracy.EXACT)));
            peer.send(new StepBundle(3600, bodies, List.of()));
            assertThat(begun.await(30, TimeUnit.SECONDS)).isTrue();
            peer.close();
            assertThat(comesTrue(() -> server.connections() == 0)).isTrue();
            assertThat(log.linesWith("its work was cancelled, as the peer has gone"))
                    .hasSize(1);
        }
    }

    @Test
    void whatIsUnderWayEndsWithTheServer() throws Exception {
        CountDownLatch begun = new CountDownLatch(1);
        GeometryServer server = server(tellingOf(begun, MoveBundle.class));
        try (Peer peer = Peer.dial(server.port())) {
            peer.send(rulings(2500));
            peer.send(new MoveBundle(List.of(LONG)));
            assertThat(begun.await(30, TimeUnit.SECONDS)).isTrue();
            Thread working = Thread.getAllStackTraces().keySet().stream()
                    .filter(each -> each.getName().startsWith("geometry-session-" + server.port()))
                    .findAny()
                    .orElseThrow();
            server.close();
            working.join(TimeUnit.SECONDS.toMillis(20));
            assertThat(working.isAlive()).isFalse();
        } finally {
            server.close();
        }
    }
}
