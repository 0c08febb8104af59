package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;

/**
 * No round trip waits for a delayed acknowledgement, which takes 40 ms, however an environment writes: among many, on
 * however busy a machine, some take as long as they must and no longer. Where every message stalls, none does.
 */
@Tag("clock")
class RoundTripTest {
    private static final int TRIPS = 60;

    /** Far more than a round trip takes, and far less than the 40 ms of a delayed acknowledgement. */
    private static final double MOST_MILLIS = 15;

    private static final InitBundle WORLD =
            new InitBundle(List.of(new CylinderObject(new Point(), 0.25, 1).moveable("robot")));

    private static SonarRequestBundle request(int size) {
        return new SonarRequestBundle(Collections.nCopies(size, new SonarRequest("robot", 1, 0)));
    }

    /** The milliseconds that a quarter of all round trips take at most: a simulator's other work lies between them. */
    private static double lowerQuartile(Trip trip) throws Exception {
        double[] millis = new double[TRIPS];
        for (int k = 0; k < TRIPS; k++) {
            Thread.sleep(2);
            long start = System.nanoTime();
            trip.go();
            millis[k] = (System.nanoTime() - start) / 1e6;
        }
        Arrays.sort(millis);
        return millis[TRIPS / 4];
    }

    private interface Trip {
        void go() throws IOException, ClassNotFoundException;
    }

    @ParameterizedTest
    @CsvSource({
        "1, false, false, true", "1, false, true, true", "1, true, false, true", "1, false, false, false",
        "200, false, false, true", "200, false, true, true", "200, true, false, true", "200, false, false, false"
    })
    @Timeout(60)
    void bareStreamsDoNotStall(int size, boolean noDelay, boolean buffered, boolean reset) throws Exception {
        try (GeometryServer server = new GeometryServer(0);
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            socket.setTcpNoDelay(noDelay);
            OutputStream to = socket.getOutputStream();
            ObjectOutputStream out = new ObjectOutputStream(buffered ? new BufferedOutputStream(to) : to);
            out.flush();
            ObjectInputStream in = new ObjectInputStream(socket.getInputStream());
            out.writeObject(WORLD);
            SonarRequestBundle request = request(size);
            double millis = lowerQuartile(() -> {
                out.writeObject(request);
                if (reset) {
                    out.reset();
                }
                out.flush();
                assertThat(((DistanceBundle) in.readObject()).distances()).hasSize(size);
            });
            assertThat(millis).isLessThan(MOST_MILLIS);
        }
    }

    @Test
    @Timeout(60)
    void norDoTheModulesOwn() throws Exception {
        try (GeometryServer server = new GeometryServer(0);
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            MessageWriter out = new MessageWriter(socket.getOutputStream());
            MessageReader in = new MessageReader(socket.getInputStream());
            out.write(WORLD);
            double millis = lowerQuartile(() -> {
                out.write(request(200));
                assertThat(in.read()).isNotNull();
            });
            assertThat(millis).isLessThan(MOST_MILLIS);
        }
    }
}
