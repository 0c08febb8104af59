package robosim.geometry.bench;

import java.io.BufferedOutputStream;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.Socket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.Session;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

/**
 * A bundle of 1,000 sonar requests, each a single ray, of the robots of {@code worlds/warehouse.xml}: answered over
 * loopback, answered in process, and only written and read as bytes, in turn, so that it shows where the time goes.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test
 * -Dexec.mainClass=robosim.geometry.bench.SonarBundles}
 */
public final class SonarBundles {
    private static final int REQUESTS = 1000;

    private SonarBundles() {}

    /** Measures the three. */
    public static void main(String[] args) throws IOException {
        World world = WorldReader.read(Path.of("worlds", "warehouse.xml"));
        List<GeometryObject> objects =
                world.objects().stream().map(WorldObject::object).toList();
        InitBundle init = new InitBundle(objects);
        SonarRequestBundle requests = requests(objects);
        Session session = new Session();
        session.answer(init);
        DistanceBundle truth = (DistanceBundle) session.answer(requests);
        try (GeometryServer server = new GeometryServer(0);
                Socket socket = new Socket(server.address().getAddress(), server.port())) {
            socket.setTcpNoDelay(true);
            MessageWriter writer = new MessageWriter(new BufferedOutputStream(socket.getOutputStream(), 1 << 16));
            MessageReader reader = new MessageReader(socket.getInputStream());
            writer.write(init);
            if (!overSocket(writer, reader, requests).equals(truth)) {
                throw new IllegalStateException("both must hear the same");
            }
            double[][] nanos = Timing.inTurn(
                    300,
                    201,
                    () -> overSocket(writer, reader, requests).distances().size(),
                    () -> ((DistanceBundle) session.answer(requests))
                            .distances()
                            .size(),
                    () -> asBytes(requests) + asBytes(truth));
            Timing.print("microseconds a bundle of %d requests, median of 201", REQUESTS);
            Timing.print("%-42s %8.0f", "over loopback", Timing.median(nanos[0]) / 1000);
            Timing.print("%-42s %8.0f", "in process: the answers alone", Timing.median(nanos[1]) / 1000);
            Timing.print("%-42s %8.0f", "request and answer to bytes and back alone", Timing.median(nanos[2]) / 1000);
            double[] sum = new double[nanos[1].length];
            for (int k = 0; k < sum.length; k++) {
                sum[k] = nanos[1][k] + nanos[2][k];
            }
            Timing.print("over loopback / (in process + bytes): %.2f", Timing.ratio(nanos[0], sum));
        }
    }

    private static SonarRequestBundle requests(List<GeometryObject> objects) {
        List<String> robots = objects.stream()
                .filter(GeometryObject::isMoveable)
                .map(GeometryObject::name)
                .toList();
        SplittableRandom random = new SplittableRandom(3);
        List<SonarRequest> requests = new ArrayList<>();
        for (int k = 0; k < REQUESTS; k++) {
            double angle = random.nextDouble(2 * Math.PI);
            String robot = robots.get(k % robots.size());
            requests.add(new SonarRequest(robot, StrictMath.cos(angle), StrictMath.sin(angle)));
        }
        return new SonarRequestBundle(requests);
    }

    private static DistanceBundle overSocket(MessageWriter writer, MessageReader reader, SonarRequestBundle requests) {
        try {
            writer.write(requests);
            return (DistanceBundle) reader.read();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static int asBytes(Bundle bundle) {
        try {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream(1 << 16);
            new MessageWriter(bytes).write(bundle);
            Bundle read = new MessageReader(new ByteArrayInputStream(bytes.toByteArray())).read();
            if (read == null) {
                throw new IllegalStateException("a bundle must come back");
            }
            return bytes.size();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
