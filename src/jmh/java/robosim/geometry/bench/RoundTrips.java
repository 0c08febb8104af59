package robosim.geometry.bench;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;

/**
 * What a round trip over loopback takes, request by request, for environments in Java that write their messages in
 * different ways: through {@link MessageWriter}, or through a bare {@link ObjectOutputStream}, with or without a buffer,
 * with or without Nagle's algorithm.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test
 * -Dexec.mainClass=robosim.geometry.bench.RoundTrips -Dexec.args=""}; an argument is the number of sonar requests in
 * each message, 8 unless given.
 */
public final class RoundTrips {
    private static final int WARM = 300;
    private static final int COUNT = 1_000;

    private RoundTrips() {}

    /** A way to write. */
    private enum Way {
        WRITER(true, true, true),
        BARE(false, false, true),
        BARE_NO_DELAY(true, false, true),
        BARE_BUFFERED(false, true, true),
        BARE_WITHOUT_RESET(false, false, false);

        private final boolean noDelay;
        private final boolean buffered;
        private final boolean reset;

        Way(boolean noDelay, boolean buffered, boolean reset) {
            this.noDelay = noDelay;
            this.buffered = buffered;
            this.reset = reset;
        }
    }

    @FunctionalInterface
    private interface Trip {
        Object go() throws IOException, ClassNotFoundException;
    }

    /** Prints the figures. */
    public static void main(String[] arguments) throws IOException, ClassNotFoundException {
        int requests = arguments.length == 0 ? 8 : Integer.parseInt(arguments[0]);
        System.out.println(
                "round trips of " + requests + " sonar requests, in microseconds: least, median, 99 %, most");
        for (Way way : Way.values()) {
            long[] nanos = measure(way, requests);
            Arrays.sort(nanos);
            System.out.printf(
                    Locale.ROOT,
                    "%-20s %8.0f %8.0f %8.0f %8.0f%n",
                    way,
                    nanos[0] / 1e3,
                    nanos[COUNT / 2] / 1e3,
                    nanos[COUNT / 100 * 99] / 1e3,
                    nanos[COUNT - 1] / 1e3);
        }
    }

    private static long[] measure(Way way, int requests) throws IOException, ClassNotFoundException {
        InitBundle world = new InitBundle(List.of(
                new BoxObject(new Point(3, 0, 0), 0.2, 2, 4),
                new CylinderObject(new Point(0, 0, 0), 0.25, 1).moveable("robot")));
        SonarRequest[] sonars = new SonarRequest[requests];
        for (int k = 0; k < requests; k++) {
            sonars[k] = new SonarRequest("robot", 1, k);
        }
        SonarRequestBundle request = new SonarRequestBundle(List.of(sonars));
        try (GeometryServer server = new GeometryServer(0);
                Socket socket = new Socket(server.address().getAddress(), server.port())) {
            socket.setTcpNoDelay(way.noDelay);
            Trip trip;
            if (way == Way.WRITER) {
                MessageWriter out = new MessageWriter(socket.getOutputStream());
                MessageReader in = new MessageReader(socket.getInputStream());
                out.write(world);
                trip = () -> {
                    out.write(request);
                    return in.read();
                };
            } else {
                OutputStream to = socket.getOutputStream();
                ObjectOutputStream out = new ObjectOutputStream(way.buffered ? new BufferedOutputStream(to) : to);
                out.flush();
                ObjectInputStream in = new ObjectInputStream(socket.getInputStream());
                out.writeObject(world);
                trip = () -> {
                    out.writeObject(request);
                    if (way.reset) {
                        out.reset();
                    }
                    out.flush();
                    return in.readObject();
                };
            }
            long[] nanos = new long[COUNT];
            for (int k = -WARM; k < COUNT; k++) {
                long start = System.nanoTime();
                Object answer = trip.go();
                if (answer == null) {
                    throw new IllegalStateException("every request must have an answer (got: none)");
                }
                nanos[Math.max(k, 0)] = System.nanoTime() - start;
            }
            return nanos;
        }
    }
}
