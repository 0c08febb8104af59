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
import java.time.Instant;
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
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.Session;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.scenario.drive.WorldLoading;

/**
 * What a healthy environment waits for an answer while others do all they can: a closed loop of small bundles, each answer
 * compared with that of a session in process, beside nobody and beside each {@link Greed}. Server, greedy ones and healthy
 * one are processes of their own, on one machine, over loopback.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.bench.Fairness
 * -Dexec.args=""}; four minutes. The arguments name attacks, all where there are none; {@code -Dseconds=10} for each,
 * {@code -Dpause=2} for milliseconds between the healthy one's requests, {@code -Dserver.flags="-Xmx2g"} for the server's Java,
 * {@code -Dserver.classes=old.jar} for the server of another build.
 */
public final class Fairness {
    /** At most; a short measurement, which only checks the answers, warms up no longer than it takes. */
    private static final long WARM_MILLIS = 3000;

    private static final int BUNDLES = 2000;

    /** Milliseconds from an answer to the next request. */
    private static final long PAUSE = Long.getLong("pause", 0);

    /** Longer waits are shown when they occur. */
    private static final long LONG_NANOS = 100_000_000;

    private static final long MOST_ALONE_NANOS = 30_000_000_000L;
    private static final int MOST_ANSWERS = 1 << 24;

    private Fairness() {}

    /** Prints the figures; or is one of the processes. */
    public static void main(String[] arguments) throws Exception {
        if (arguments.length == 1 && arguments[0].equals("serve")) {
            NetOptions options = NetOptions.defaults().withWorlds(WorldLoading.of(null, List.of()));
            say("" + new GeometryServer(InetAddress.getLoopbackAddress(), 0, options).port());
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
            print("a sleep", waits[2]);
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

    /**
     * What a healthy environment waits beside nobody, for half the time but at most half a minute, then beside an attack, of one
     * server; and how much too long a thread of its process slept meanwhile, which is the machine's own share.
     */
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
            Waits before = Waits.of(healthy.ask(port, Math.min(nanos / 2, MOST_ALONE_NANOS)));
            Process greedy = start(List.of("-XX:TieredStopAtLevel=1"), "attack", attack.name(), "" + port);
            try {
                line(greedy); // its messages are made
                Thread.sleep(warm);
                Sleeper sleeper = new Sleeper();
                sleeper.start();
                Waits beside = Waits.of(healthy.ask(port, nanos));
                return new Waits[] {before, beside, Waits.of(sleeper.over())};
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

    /** A thread that sleeps a millisecond, again and again. */
    private static final class Sleeper extends Thread {
        private long[] late = new long[1 << 12];
        private int count;
        private volatile boolean isOver;

        @Override
        public void run() {
            while (!isOver && count < MOST_ANSWERS) {
                long start = System.nanoTime();
                rest(1);
                late = noted(late, count++, System.nanoTime() - start - 1_000_000);
            }
        }

        long[] over() throws InterruptedException {
            isOver = true;
            join();
            return Arrays.copyOf(late, count);
        }
    }

    private static long[] noted(long[] times, int count, long nanos) {
        long[] room = count < times.length ? times : Arrays.copyOf(times, 2 * count);
        room[count] = nanos;
        return room;
    }

    static void rest(long millis) {
        try {
            Thread.sleep(millis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
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
                requests.add(
                        switch (k % 8) {
                            case 0, 2, 4 -> moves(random);
                            case 6 -> step(random);
                            case 7 -> batch(random);
                            default -> sonars(random);
                        });
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

        private static Bundle step(SplittableRandom random) {
            return new StepBundle(
                    0.05,
                    List.of(),
                    List.of(new DriveCommand(
                            "robot " + random.nextInt(8), random.nextDouble(-1, 1), 0, random.nextDouble(-1, 1))));
        }

        private static Bundle batch(SplittableRandom random) {
            String robot = "robot " + random.nextInt(8);
            double[] poses = random.doubles(64, -15, 15).toArray();
            for (int k = 1; k < poses.length; k += 4) {
                poses[k] = 0;
            }
            return new BatchRequestBundle(List.of(
                    new SenseRequest(robot, new BeamPattern.Fan(-2, 0.1, 41)),
                    new FreePosesRequest(robot, Numbers.of(poses))));
        }

        /** The nanoseconds of each answer. */
        long[] ask(int port, long nanos) throws IOException {
            long[] times = new long[1 << 12];
            int count = 0;
            try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
                socket.setTcpNoDelay(true);
                socket.setSoTimeout(60_000);
                MessageWriter out = new MessageWriter(socket.getOutputStream());
                MessageReader in = new MessageReader(socket.getInputStream());
                long end = System.nanoTime() + nanos;
                while (System.nanoTime() < end && count < MOST_ANSWERS) {
                    out.write(world);
                    for (int k = 0; k < BUNDLES && count < MOST_ANSWERS && System.nanoTime() < end; k++) {
                        long start = System.nanoTime();
                        out.write(requests.get(k));
                        Bundle answer = in.read();
                        long taken = System.nanoTime() - start;
                        times = noted(times, count++, taken);
                        if (taken > LONG_NANOS) {
                            System.out.println(Instant.now() + " waited " + taken / 1_000_000 + " ms for answer " + k);
                        }
                        if (!answers.get(k).equals(answer)) {
                            throw new IOException(
                                    "answer " + k + " must be " + answers.get(k) + " (got: " + answer + ")");
                        }
                        if (PAUSE > 0) {
                            rest(PAUSE);
                        }
                    }
                }
            }
            return Arrays.copyOf(times, count);
        }
    }
}
