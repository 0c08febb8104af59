package robosim.geometry.bench;

import com.fasterxml.jackson.core.JsonFactory;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.Session;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;

/**
 * What a healthy environment waits for an answer while others do all they can: a closed loop of small bundles, each answer
 * compared with that of a session in process, beside nobody and beside each {@link Greed}. Server, greedy ones and healthy
 * one are processes of their own, on one machine, over loopback.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.bench.Fairness
 * -Dexec.args=""}; four minutes. The arguments name attacks, all where there are none; {@code -Dseconds=10} for each,
 * {@code -Dserver.flags="-Xmx2g"} for the server's Java, {@code -Dserver.classes=old.jar} for the server of another build.
 */
public final class Fairness {
    /** At most; a short measurement, which only checks the answers, warms up no longer than it takes. */
    private static final long WARM_MILLIS = 3000;

    private static final int BUNDLES = 2000;

    private Fairness() {}

    /** Prints the figures; or is one of the processes. */
    public static void main(String[] arguments) throws Exception {
        if (arguments.length == 1 && arguments[0].equals("serve")) {
            say("" + new GeometryServer(0).port());
            return;
        }
        if (arguments.length == 3 && arguments[0].equals("attack")) {
            Greed.valueOf(arguments[1]).begin(Integer.parseInt(arguments[2]));
            return;
        }
        List<Greed> attacks = arguments.length == 0
                ? List.of(Greed.values())
                : Arrays.stream(arguments).map(Greed::valueOf).toList();
        System.out.printf(
                "%-8s %9s %9s %9s %9s %9s  ms; load of the machine %.1f%n",
                "beside",
                "answers",
                "p50",
                "p99",
                "p99.9",
                "worst",
                java.lang.management.ManagementFactory.getOperatingSystemMXBean()
                        .getSystemLoadAverage());
        for (Greed attack : attacks) {
            Waits[] waits = measure(attack, Duration.ofSeconds(Long.getLong("seconds", 8)));
            print("nobody", waits[0]);
            print(attack.name().toLowerCase(Locale.ROOT), waits[1]);
        }
    }

    /**
     * How long answers took, in milliseconds.
     *
     * @param answers how many there were
     */
    record Waits(int answers, double p50, double p99, double p999, double worst) {
        private static Waits of(long[] nanos) {
            Arrays.sort(nanos);
            return new Waits(nanos.length, at(nanos, 0.5), at(nanos, 0.99), at(nanos, 0.999), at(nanos, 1));
        }

        private static double at(long[] sorted, double share) {
            return sorted[(int) Math.min(sorted.length - 1, (long) (share * sorted.length))] / 1e6;
        }
    }

    /** What a healthy environment waits beside nobody, for half the time, then beside an attack, of one server. */
    static Waits[] measure(Greed attack, Duration time) throws Exception {
        Healthy healthy = new Healthy();
        long nanos = time.toNanos();
        long warm = Math.min(WARM_MILLIS, time.toMillis());
        List<String> flags =
                List.of(System.getProperty("server.flags", "").trim().split(" +"));
        Process server = start(flags.get(0).isEmpty() ? List.of() : flags, "serve");
        try {
            int port = Integer.parseInt(line(server));
            healthy.ask(port, warm * 1_000_000);
            Waits before = Waits.of(healthy.ask(port, nanos / 2));
            Process greedy = start(List.of("-XX:TieredStopAtLevel=1"), "attack", attack.name(), "" + port);
            try {
                line(greedy); // its messages are made
                Thread.sleep(warm);
                return new Waits[] {before, Waits.of(healthy.ask(port, nanos))};
            } finally {
                greedy.destroyForcibly().waitFor();
            }
        } finally {
            server.destroyForcibly().waitFor();
        }
    }

    private static void print(String beside, Waits waits) {
        System.out.printf(
                Locale.ROOT,
                "%-8s %9d %9.2f %9.2f %9.2f %9.2f%n",
                beside,
                waits.answers(),
                waits.p50(),
                waits.p99(),
                waits.p999(),
                waits.worst());
    }

    private static Process start(List<String> flags, String... arguments) throws IOException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(flags);
        String other = arguments[0].equals("serve") ? System.getProperty("server.classes", "") : "";
        String own = ClassPath.of(Fairness.class, GeometryServer.class, JsonFactory.class);
        command.addAll(List.of("-cp", other.isEmpty() ? own : other + java.io.File.pathSeparator + own));
        command.add(Fairness.class.getName());
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
    }

    private static String line(Process process) throws IOException {
        String line =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8)).readLine();
        if (line == null) {
            throw new IOException("the process must say a line (got: its end)");
        }
        return line;
    }

    static void say(String line) {
        System.out.println(line);
        System.out.flush();
    }

    /** An environment of some robots that asks one small bundle after the other. */
    private static final class Healthy {
        private final InitBundle world;
        private final List<Bundle> requests = new ArrayList<>();
        private final List<Bundle> answers = new ArrayList<>();

        Healthy() {
            SplittableRandom random = new SplittableRandom(11);
            List<GeometryObject> objects = new ArrayList<>();
            for (int k = 0; k < 60; k++) {
                objects.add(new BoxObject(new Point(random.nextInt(-20, 20), 0, random.nextInt(-20, 20)), 0.4, 2, 3));
            }
            for (int k = 0; k < 8; k++) {
                objects.add(new CylinderObject(new Point(random.nextInt(-15, 15), 0, random.nextInt(-15, 15)), 0.3, 1)
                        .moveable("robot " + k));
            }
            world = new InitBundle(objects);
            Session session = new Session();
            session.answer(world);
            for (int k = 0; k < BUNDLES; k++) {
                requests.add(k % 2 == 0 ? moves(random) : sonars(random));
                answers.add(session.answer(requests.get(k)));
            }
        }

        private static Bundle moves(SplittableRandom random) {
            List<MoveRequest> moves = new ArrayList<>();
            for (int k = 0; k < 8; k++) {
                moves.add(new MoveRequest("robot " + k, random.nextDouble(-0.1, 0.2), 0, 0, 0, random.nextDouble()));
            }
            return new MoveBundle(moves);
        }

        private static Bundle sonars(SplittableRandom random) {
            List<SonarRequest> sonars = new ArrayList<>();
            for (int k = 0; k < 16; k++) {
                sonars.add(new SonarRequest("robot " + k % 8, random.nextDouble(), 1, new Beam(0, 10, 0.3)));
            }
            return new SonarRequestBundle(sonars);
        }

        /** The nanoseconds of each answer. */
        long[] ask(int port, long nanos) throws IOException {
            long[] times = new long[1 << 20];
            int count = 0;
            try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
                socket.setTcpNoDelay(true);
                socket.setSoTimeout(60_000);
                MessageWriter out = new MessageWriter(socket.getOutputStream());
                MessageReader in = new MessageReader(socket.getInputStream());
                long end = System.nanoTime() + nanos;
                while (System.nanoTime() < end && count < times.length) {
                    out.write(world);
                    for (int k = 0; k < BUNDLES && count < times.length && System.nanoTime() < end; k++) {
                        long start = System.nanoTime();
                        out.write(requests.get(k));
                        Bundle answer = in.read();
                        times[count++] = System.nanoTime() - start;
                        if (!answers.get(k).equals(answer)) {
                            throw new IOException(
                                    "answer " + k + " must be " + answers.get(k) + " (got: " + answer + ")");
                        }
                    }
                }
            }
            return Arrays.copyOf(times, count);
        }
    }
}
