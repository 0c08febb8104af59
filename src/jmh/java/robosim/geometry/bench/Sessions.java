package robosim.geometry.bench;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.Socket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

/**
 * What a session over loopback costs: a bundle of 1,000 sonar rays against the same in process and its bytes, all in one
 * run, and small bundles of 10 moves, asked one after the other as often as a simulator of 100 Hz does in an hour.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test
 * -Dexec.mainClass=robosim.geometry.bench.Sessions -Dexec.args=""}
 */
public final class Sessions {
    private static final int ROUNDS = 300;
    private static final int HOUR = 360_000;
    private static final int QUARTERS = 4;
    private static final int MOVES = 10;

    private Sessions() {}

    /** Prints the figures. */
    public static void main(String[] arguments) throws IOException {
        largeBundles();
        smallBundles();
    }

    @FunctionalInterface
    private interface Asking {
        Object ask() throws IOException;
    }

    private static LongSupplier task(Asking asking) {
        return () -> {
            try {
                return asking.ask().hashCode() == 0 ? 1 : 0;
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        };
    }

    private static void largeBundles() throws IOException {
        Bundles bundles = new Bundles();
        bundles.width = 0;
        bundles.open();
        double[][] nanos = Timing.inTurn(
                2 * ROUNDS,
                ROUNDS,
                task(bundles::inProcess),
                task(bundles::bytes),
                task(bundles::loopback),
                task(bundles::jsonBytes),
                task(bundles::json));
        bundles.close();
        double[] java = new double[ROUNDS];
        double[] json = new double[ROUNDS];
        for (int k = 0; k < ROUNDS; k++) {
            java[k] = nanos[0][k] + nanos[1][k];
            json[k] = nanos[0][k] + nanos[3][k];
        }
        Timing.print(
                "a bundle of 1,000 rays: in process %.0f us, its bytes %.0f us, over loopback %.0f us, %.2f times their sum",
                Timing.median(nanos[0]) / 1e3,
                Timing.median(nanos[1]) / 1e3,
                Timing.median(nanos[2]) / 1e3,
                Timing.ratio(nanos[2], java));
        Timing.print(
                "in JSON lines: its text %.0f us, over loopback %.0f us, %.2f times their sum, %.2f times that of Java",
                Timing.median(nanos[3]) / 1e3,
                Timing.median(nanos[4]) / 1e3,
                Timing.ratio(nanos[4], json),
                Timing.ratio(nanos[4], java));
    }

    private static void smallBundles() throws IOException {
        List<GeometryObject> objects = WorldReader.read(Path.of("worlds", "warehouse.xml")).objects().stream()
                .map(WorldObject::object)
                .toList();
        Bundle there = moves(objects, 0.01);
        Bundle back = moves(objects, -0.01);
        try (GeometryServer server = new GeometryServer(0);
                Socket socket = new Socket(server.address().getAddress(), server.port())) {
            socket.setTcpNoDelay(true);
            MessageWriter writer = new MessageWriter(new BufferedOutputStream(socket.getOutputStream(), 1 << 13));
            MessageReader reader = new MessageReader(socket.getInputStream());
            writer.write(new InitBundle(objects));
            long[] nanos = new long[HOUR];
            long[] part = new long[HOUR / QUARTERS];
            askAll(writer, reader, there, back, part); // warms up
            long heap = heap();
            long start = System.nanoTime();
            long[] growth = new long[QUARTERS];
            long measuring = 0;
            for (int quarter = 0; quarter < QUARTERS; quarter++) {
                askAll(writer, reader, there, back, part);
                System.arraycopy(part, 0, nanos, quarter * part.length, part.length);
                long before = System.nanoTime();
                growth[quarter] = heap() - heap;
                measuring += System.nanoTime() - before;
            }
            double seconds = (System.nanoTime() - start - measuring) / (double) TimeUnit.SECONDS.toNanos(1);
            Arrays.sort(nanos);
            Timing.print(
                    "bundles of %d moves: %d round trips, %.0f a second, p50 %.0f us, p99 %.0f us, p99.9 %.0f us,"
                            + " longest %.1f ms",
                    MOVES,
                    HOUR,
                    HOUR / seconds,
                    nanos[HOUR / 2] / 1e3,
                    nanos[HOUR / 100 * 99] / 1e3,
                    nanos[HOUR / 1000 * 999] / 1e3,
                    nanos[HOUR - 1] / 1e6);
            Timing.print(
                    "heap: %.1f MB, after each quarter of an hour's messages %s bytes more",
                    heap / 1e6, Arrays.toString(growth));
            Timing.print("the server's own figures: %s", server.figures().line());
        }
    }

    private static Bundle moves(List<GeometryObject> objects, double way) {
        List<MoveRequest> moves = new ArrayList<>();
        for (GeometryObject object : objects) {
            if (object.isMoveable() && moves.size() < MOVES) {
                moves.add(new MoveRequest(object.name(), way, 0, 0, 0, 0));
            }
        }
        if (moves.size() < MOVES) {
            throw new IllegalStateException("there must be " + MOVES + " robots (got: " + moves.size() + ")");
        }
        return new MoveBundle(moves);
    }

    private static void askAll(MessageWriter writer, MessageReader reader, Bundle there, Bundle back, long[] nanos)
            throws IOException {
        for (int k = 0; k < nanos.length; k++) {
            long start = System.nanoTime();
            writer.write(k % 2 == 0 ? there : back);
            Bundle answer = reader.read();
            nanos[k] = System.nanoTime() - start;
            if (!(answer instanceof MoveBundle)) {
                throw new IllegalStateException("moves must be answered by moves (got: " + answer + ")");
            }
        }
    }

    private static long heap() {
        long least = Long.MAX_VALUE;
        for (int k = 0; k < 4; k++) {
            System.gc();
            Runtime runtime = Runtime.getRuntime();
            least = Math.min(least, runtime.totalMemory() - runtime.freeMemory());
        }
        return least;
    }
}
