package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.net.ServerSocket;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;

/** A session in the module's own world, in process and over sockets at both ends. */
class SessionWorldTest {
    private static final double QUARTER = Math.PI / 2;

    private static BoxObject wall(double x, double z, double width, double length) {
        return new BoxObject(new Point(x, 0, z), width, 2, length);
    }

    /** A room of 10 x 10 inside its walls, which overlap at the corners, and a pillar. */
    private static InitBundle room(GeometryObject... more) {
        List<GeometryObject> objects = new ArrayList<>(List.<GeometryObject>of(
                wall(5.5, 0, 1, 12),
                wall(-5.5, 0, 1, 12),
                wall(0, 5.5, 12, 1),
                wall(0, -5.5, 12, 1).named("north"),
                new CylinderObject(new Point(3, 0, 3), 0.5, 2).named("pillar"),
                new CylinderObject(new Point(0, 0, 0), 0.5, 1).moveable("robot")));
        objects.addAll(List.of(more));
        return new InitBundle(objects);
    }

    private static MoveRequest turn(double radians) {
        return new MoveRequest("robot", 0, 0, 0, 0, radians);
    }

    private static MoveRequest forward(double x) {
        return new MoveRequest("robot", x, 0, 0, 0, 0);
    }

    @Test
    void knownDistancesComeBackExactly() {
        Session session = new Session();
        assertThat(session.answer(room())).isNull();
        // Forward, left, back and right to the walls at 5; and a quarter turn that changes nothing but who is who.
        SonarRequestBundle around = new SonarRequestBundle(List.of(
                new SonarRequest("robot", 2, 0),
                new SonarRequest("robot", 0, -3),
                new SonarRequest("robot", -1, 0),
                new SonarRequest("robot", 0, 1),
                new SonarRequest("robot", 1, 0, new Beam(6, 9, 0)),
                new SonarRequest("robot", 1, 0, new Beam(0, 4.9, 0)),
                new SonarRequest("north", 1, 0)));
        DistanceBundle four =
                new DistanceBundle(List.of(5.0, 5.0, 5.0, 5.0, 6.0, Double.POSITIVE_INFINITY, Double.NaN));
        try (LogCapture log = new LogCapture()) {
            assertThat(session.answer(around)).isEqualTo(four);
            for (int k = 1; k <= 8; k++) {
                assertThat(session.answer(new MoveBundle(List.of(turn(QUARTER)))))
                        .isEqualTo(new MoveBundle(List.of(turn(QUARTER))));
                assertThat(session.answer(around)).as(k + " quarter turns").isEqualTo(four);
            }
            assertThat(log.linesWith("\"north\"")).hasSize(1);
        }
        SonarRequest pillar = new SonarRequest("robot", 1, 1);
        DistanceBundle seen = (DistanceBundle) session.answer(new SonarRequestBundle(List.of(pillar)));
        assertThat(seen.distances().get(0)).isCloseTo(3 * Math.sqrt(2) - 0.5, within(1e-14));
    }

    /** Forward is (1, 0, 0); a turn of +90 degrees takes it to (0, 0, -1). */
    @Test
    void movesAreCarriedOutInOrderInRadians() {
        Session session = new Session();
        session.answer(room());
        MoveBundle asked = new MoveBundle(List.of(
                forward(2), // to (2, 0)
                forward(2.6), // through the wall
                turn(QUARTER),
                forward(3), // to (2, -3)
                forward(2), // through the north wall
                turn(-QUARTER),
                forward(2.25))); // to (4.25, -3)
        List<MoveRequest> moves = asked.moves();
        assertThat(session.answer(asked))
                .isEqualTo(
                        new MoveBundle(List.of(moves.get(0), moves.get(2), moves.get(3), moves.get(5), moves.get(6))));
        assertThat(session.answer(new SonarRequestBundle(
                        List.of(new SonarRequest("robot", 1, 0), new SonarRequest("robot", 0, -1)))))
                .isEqualTo(new DistanceBundle(List.of(0.75, 2.0)));
    }

    @Test
    void whatCannotBeAddedIsLoggedAndTheWorldStands() {
        try (LogCapture log = new LogCapture()) {
            Session session = new Session();
            WorldSettings small = new WorldSettings(20, 20, 20, Dimension.SPATIAL, Accuracy.EXACT);
            List<GeometryObject> objects = new ArrayList<>(room(
                            new SphereObject(new Point(1, 0, 0), 0.2).moveable("robot"),
                            new SphereObject(new Point(10, 0, 0), 0.2).moveable("outside"))
                    .objects());
            session.answer(new InitBundle(objects, small));
            assertThat(log.lines()).hasSize(2);
            assertThat(log.linesWith("object \"robot\" was not added")).hasSize(1);
            assertThat(log.linesWith("object \"outside\" was not added: it would leave the world"))
                    .hasSize(1);
            assertThat(session.answer(new SonarRequestBundle(List.of(new SonarRequest("robot", 1, 0)))))
                    .isEqualTo(new DistanceBundle(List.of(5.0)));
        }
    }

    @Test
    void aSonarThatLooksStraightUpIsRefusedInAPlanarWorldOnly() {
        try (LogCapture log = new LogCapture()) {
            Session session = new Session();
            BoxObject upright = wall(0, 0, 1, 1);
            double[] facingUp = {0, -1, 0, 1, 0, 0, 0, 0, 1};
            InitBundle planar =
                    new InitBundle(List.of(upright.oriented(facingUp).moveable("robot")));
            session.answer(planar);
            SonarRequestBundle up =
                    new SonarRequestBundle(List.of(new SonarRequest("robot", 1, 0), new SonarRequest("robot", 0, 1)));
            assertThat(session.answer(up)).isEqualTo(new DistanceBundle(List.of(Double.NaN, Double.POSITIVE_INFINITY)));
            assertThat(log.linesWith("\"robot\"")).hasSize(1);
            assertThat(log.linesWith("vertical")).hasSize(1);
            session.answer(
                    new InitBundle(planar.objects(), new WorldSettings(9, 9, 9, Dimension.SPATIAL, Accuracy.EXACT)));
            assertThat(session.answer(up))
                    .isEqualTo(new DistanceBundle(List.of(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY)));
        }
    }

    /** Some hundred bundles at random, answered with the same bits by the engine itself and at both ends of a socket. */
    @Test
    void bothEndsAnswerWithTheBitsOfTheEngine() throws Exception {
        try (GeometryServer server = new GeometryServer(0);
                ServerSocket environment = Peer.listen();
                GeometryClient client = new GeometryClient("127.0.0.1", environment.getLocalPort())) {
            Thread thread = new Thread(client, "geometry-client-of-a-test");
            thread.start();
            try (Peer dialling = Peer.dial(server.port());
                    Peer dialled = new Peer(environment.accept())) {
                Geometry geometry = new Geometry(100, 100, 100, Dimension.PLANAR, Accuracy.EXACT);
                WorldSettings settings = new WorldSettings(100, 100, 100, Dimension.PLANAR, Accuracy.EXACT);
                InitBundle init = new InitBundle(room().objects(), settings);
                init.objects().forEach(geometry::addObjectUnchecked);
                dialling.send(init);
                dialled.send(init);
                SplittableRandom random = new SplittableRandom(7);
                int made = 0;
                int refused = 0;
                for (int k = 0; k < 300; k++) {
                    double quarters = random.nextInt(-2, 3);
                    MoveRequest request = new MoveRequest(
                            "robot", random.nextDouble(-2, 2), 0, random.nextDouble(-2, 2), 0, quarters * QUARTER);
                    Move move = new Move(request.x(), 0, request.z(), 0, 90 * quarters);
                    boolean allowed = geometry.move("robot", move).allowed();
                    assertThat(dialling.move(request)).isEqualTo(allowed ? List.of(request) : List.of());
                    assertThat(dialled.move(request)).isEqualTo(allowed ? List.of(request) : List.of());
                    made += allowed ? 1 : 0;
                    refused += allowed ? 0 : 1;
                    double x = random.nextDouble(-1, 1);
                    double z = random.nextDouble(-1, 1);
                    SonarRequest line = new SonarRequest("robot", x, z);
                    SonarRequest cone = new SonarRequest("robot", x, z, new Beam(0.25, 4, QUARTER));
                    List<Double> distances = List.of(
                            geometry.getSonarDistance("robot", x, z, 0, Double.POSITIVE_INFINITY, 0),
                            geometry.getSonarDistance("robot", x, z, 0.25, 4, 90));
                    assertThat(dialling.measure(line, cone)).isEqualTo(distances);
                    assertThat(dialled.measure(line, cone)).isEqualTo(distances);
                }
                assertThat(made).isBetween(30, 270);
                assertThat(refused).isBetween(30, 270);
            }
            thread.join(5000);
            assertThat(thread.isAlive()).isFalse();
        }
    }
}
