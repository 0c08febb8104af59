package robosim.geometry.bench;

import java.io.BufferedOutputStream;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.Socket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import robosim.geometry.Geometry;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.Session;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

/**
 * One of the 1,000 sonar requests of a bundle, of the robots of {@code worlds/warehouse.xml}, which fits the second cache:
 * by single calls, by a session in process, over loopback; and its share of the bytes alone, to subtract.
 */
@State(Scope.Thread)
public class Bundles {
    private static final int REQUESTS = 1000;
    private static final double RANGE = 50;

    /** Full opening angle in degrees: rays, or sonars' cones. */
    @Param({"0", "15"})
    public double width;

    private final Session session = new Session();
    private final double[] distances = new double[REQUESTS];
    private Geometry geometry;
    private SonarRequest[] single;
    private SonarRequestBundle bundle;
    private DistanceBundle truth;
    private GeometryServer server;
    private Socket socket;
    private MessageWriter writer;
    private MessageReader reader;
    private JsonEnvironment json;

    /** Opens the world three times: by itself, in a session and behind a server; all must answer the same. */
    @Setup
    public void open() throws IOException {
        List<GeometryObject> objects = WorldReader.read(Path.of("worlds", "warehouse.xml")).objects().stream()
                .map(WorldObject::object)
                .toList();
        double size = 1000;
        geometry = new Geometry(size, size, size, Dimension.PLANAR, Accuracy.EXACT);
        objects.forEach(geometry::addObjectUnchecked);
        bundle = new SonarRequestBundle(requests(objects));
        single = bundle.requests().toArray(new SonarRequest[0]);
        InitBundle init =
                new InitBundle(objects, new WorldSettings(size, size, size, Dimension.PLANAR, Accuracy.EXACT));
        session.answer(init);
        truth = (DistanceBundle) session.answer(bundle);
        server = new GeometryServer(0);
        socket = new Socket(server.address().getAddress(), server.port());
        socket.setTcpNoDelay(true);
        writer = new MessageWriter(new BufferedOutputStream(socket.getOutputStream(), 1 << 16));
        reader = new MessageReader(socket.getInputStream());
        writer.write(init);
        json = new JsonEnvironment(server.port());
        json.say(init);
        singleCalls();
        for (int k = 0; k < REQUESTS; k++) {
            if (distances[k] != truth.distances().get(k)) {
                throw new IllegalStateException("request " + k + " must be answered alike by a bundle");
            }
        }
        if (!loopback().equals(truth) || !json().equals(truth)) {
            throw new IllegalStateException("both must hear the same");
        }
    }

    /** Hangs up. */
    @TearDown(Level.Trial)
    public void close() throws IOException {
        socket.close();
        json.close();
        server.close();
    }

    private List<SonarRequest> requests(List<GeometryObject> objects) {
        List<String> robots = objects.stream()
                .filter(GeometryObject::isMoveable)
                .map(GeometryObject::name)
                .toList();
        SplittableRandom random = new SplittableRandom(3);
        Beam beam = new Beam(0, RANGE, Degrees.toRadians(width));
        List<SonarRequest> requests = new ArrayList<>();
        for (int k = 0; k < REQUESTS; k++) {
            double angle = random.nextDouble(2 * Math.PI);
            String robot = robots.get(k % robots.size());
            requests.add(new SonarRequest(robot, StrictMath.cos(angle), StrictMath.sin(angle), beam));
        }
        return requests;
    }

    /** As a user of the library asks. */
    @Benchmark
    @OperationsPerInvocation(REQUESTS)
    public double[] singleCalls() {
        double degrees = Degrees.toDegrees(Degrees.toRadians(width)); // what the session makes of it
        for (int k = 0; k < REQUESTS; k++) {
            SonarRequest request = single[k];
            distances[k] = geometry.getSonarDistance(
                    request.objectName(), request.xOffset(), request.zOffset(), 0, RANGE, degrees);
        }
        return distances;
    }

    /** The same in a bundle. */
    @Benchmark
    @OperationsPerInvocation(REQUESTS)
    public Bundle inProcess() {
        return session.answer(bundle);
    }

    /** The same from an environment in another process. */
    @Benchmark
    @OperationsPerInvocation(REQUESTS)
    public Bundle loopback() throws IOException {
        writer.write(bundle);
        return reader.read();
    }

    /** The same in JSON lines. */
    @Benchmark
    @OperationsPerInvocation(REQUESTS)
    public Bundle json() throws IOException {
        return json.ask(bundle);
    }

    /** Request and answer to JSON lines and back. */
    @Benchmark
    @OperationsPerInvocation(REQUESTS)
    public int jsonBytes() throws IOException {
        String request = JsonLines.write(bundle);
        String answer = JsonLines.write(new Reply(truth));
        JsonLines.readRequest(request);
        JsonLines.readReply(answer);
        return request.length() + answer.length();
    }

    /** Request and answer to bytes and back. */
    @Benchmark
    @OperationsPerInvocation(REQUESTS)
    public int bytes() throws IOException {
        return asBytes(bundle) + asBytes(truth);
    }

    private static int asBytes(Bundle message) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream(1 << 16);
        new MessageWriter(bytes).write(message);
        Bundle read = new MessageReader(new ByteArrayInputStream(bytes.toByteArray())).read();
        if (read == null) {
            throw new IllegalStateException("a bundle must come back");
        }
        return bytes.size();
    }
}
