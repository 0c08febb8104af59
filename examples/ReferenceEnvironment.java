import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.Console;
import java.io.FilterInputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.world.SonarRing;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

/**
 * Plays RoboSim's environment module: loads a world, sends it to the geometry module over TCP, and lets its robots wander
 * by what their sonars tell. It checks every answer against the protocol, measures how long answers take, and can record
 * the conversation's bytes for {@code ConversationAudit}.
 *
 * <p>Started from the project's folder as
 *
 * <pre>
 * java -cp target/classes examples/ReferenceEnvironment.java --world worlds/rooms.xml --connect localhost:7575
 * </pre>
 *
 * against a module that listens, or with {@code --listen 7575} for a module that dials. The same world and seed make the
 * same conversation, to the byte.
 */
public final class ReferenceEnvironment {
    /** How long a step lasts in which robots are driven. */
    private static final double SECONDS = 0.1;

    private static final String USAGE = """
            usage: java -cp target/classes examples/ReferenceEnvironment.java --world FILE (--connect HOST:PORT | --listen PORT)
              --steps N      rounds of sonar and moves (default 1000)
              --seed S       of the robots' whims (default 1)
              --speed V      world units a robot advances in a step (default 0.05)
              --drive        hands the movement over: each step lasts 0.1 s, in which robots are driven, slide, push and bump
              --record DIR   writes what was sent to DIR/to-module.bin and what came back to DIR/from-module.bin,
                             and the numbers of the run to DIR/environment.properties
              --progress     shows the progress bar even where the output is no terminal
              --quiet        shows none""";

    private final Options options;
    private final World world;
    private final List<Robot> robots = new ArrayList<>();
    private final Tally tally = new Tally();

    private ReferenceEnvironment(Options options) throws IOException {
        this.options = options;
        this.world = WorldReader.read(Path.of(options.require("world")));
        SplittableRandom seeds = new SplittableRandom(options.number("seed", 1));
        double speed = options.decimal("speed", 0.05);
        for (WorldObject object : world.objects()) {
            // What lies on its side has no level sensors, and stays.
            if (object.object().isMoveable() && object.object().pose().isUpright()) {
                robots.add(new Robot(object, speed, seeds.split()));
            }
        }
        if (robots.isEmpty()) {
            throw new IllegalArgumentException(
                    "world must hold a moveable object that stands upright, else nothing can wander (got: "
                            + options.require("world") + ")");
        }
    }

    /** Exits with 0 where all answers kept to the protocol, 1 where one did not, 2 where it could not be asked. */
    public static void main(String[] arguments) {
        try {
            ReferenceEnvironment environment = new ReferenceEnvironment(new Options(arguments));
            environment.run();
        } catch (ProtocolFault fault) {
            System.err.println("The module broke the protocol: " + fault.getMessage());
            System.exit(1);
        } catch (IllegalArgumentException bad) {
            System.err.println(bad.getMessage());
            if (arguments.length == 0) {
                System.err.println(USAGE);
            }
            System.exit(2);
        } catch (IOException | ClassNotFoundException failed) {
            System.err.println("The conversation failed: " + failed);
            System.exit(2);
        }
    }

    private void run() throws IOException, ClassNotFoundException {
        long steps = options.number("steps", 1000);
        String folder = options.text("record", "");
        try (Socket socket = open();
                OutputStream sent = folder.isEmpty()
                        ? OutputStream.nullOutputStream()
                        : new BufferedOutputStream(Files.newOutputStream(record(folder, "to-module.bin")));
                OutputStream received = folder.isEmpty()
                        ? OutputStream.nullOutputStream()
                        : new BufferedOutputStream(Files.newOutputStream(record(folder, "from-module.bin")))) {
            socket.setTcpNoDelay(true);
            Connection connection = new Connection(socket, sent, received);
            connection.send(init());
            boolean driven = options.has("drive");
            if (driven) {
                giveBodies(connection);
            }
            Progress progress = new Progress(steps, options.has("progress") || (!options.has("quiet") && isTerminal()));
            for (long step = 0; step < steps; step++) {
                range(connection);
                if (driven) {
                    drive(connection);
                } else {
                    move(connection);
                }
                progress.show(step + 1);
            }
            progress.end();
            // What the robots see where they have come to rest.
            range(connection);
        }
        if (!folder.isEmpty()) {
            Files.writeString(record(folder, "environment.properties"), tally.properties(steps, robots.size()));
        }
        System.out.print(tally.text(steps, robots.size()));
    }

    private static boolean isTerminal() {
        Console console = System.console();
        if (console == null) {
            return false;
        }
        try {
            // From Java 22 on there is a console without a terminal too, and this method tells.
            return (boolean) Console.class.getMethod("isTerminal").invoke(console);
        } catch (ReflectiveOperationException before22) {
            return true;
        }
    }

    private static Path record(String folder, String name) throws IOException {
        return Files.createDirectories(Path.of(folder)).resolve(name);
    }

    private Socket open() throws IOException {
        if (options.has("listen") == options.has("connect")) {
            throw new IllegalArgumentException("one of --connect and --listen must be given");
        }
        if (options.has("listen")) {
            int port = Math.toIntExact(options.number("listen", 0));
            try (ServerSocket server = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
                System.out.println("Listening on port " + server.getLocalPort());
                return server.accept();
            }
        }
        String place = options.require("connect");
        int colon = place.lastIndexOf(':');
        if (colon < 1 || !place.substring(colon + 1).matches("\\d{1,5}")) {
            throw new IllegalArgumentException("--connect must be HOST:PORT (got: " + place + ")");
        }
        return new Socket(place.substring(0, colon), Integer.parseInt(place.substring(colon + 1)));
    }

    /** The world as RoboSim sees it: from above, and exactly. */
    private InitBundle init() {
        List<GeometryObject> objects =
                world.objects().stream().map(WorldObject::object).toList();
        return new InitBundle(
                objects,
                new WorldSettings(world.width(), world.height(), world.length(), Dimension.PLANAR, Accuracy.EXACT));
    }

    /** One round of all sonars of all robots. */
    private void range(Connection connection) throws IOException, ClassNotFoundException {
        List<SonarRequest> requests = new ArrayList<>();
        for (Robot robot : robots) {
            requests.addAll(robot.requests);
        }
        long begin = System.nanoTime();
        Object answer = connection.ask(new SonarRequestBundle(requests));
        tally.sonarNanos.add(System.nanoTime() - begin);
        if (!(answer instanceof DistanceBundle bundle)) {
            throw new ProtocolFault("a SonarRequestBundle was answered by " + nameOf(answer));
        }
        List<Double> distances = bundle.distances();
        if (distances.size() != requests.size()) {
            throw new ProtocolFault(requests.size() + " requests, " + distances.size() + " distances");
        }
        int k = 0;
        for (Robot robot : robots) {
            for (int sensor = 0; sensor < robot.requests.size(); sensor++, k++) {
                double distance = distances.get(k);
                checkDistance(requests.get(k), distance);
                robot.distances[sensor] = distance;
                tally.echoes += distance < Double.POSITIVE_INFINITY ? 1 : 0;
            }
        }
        tally.distances += k;
    }

    private static void checkDistance(SonarRequest request, double distance) {
        Beam beam = request.beam();
        double min = beam == null ? 0 : beam.min();
        double max = beam == null ? Double.POSITIVE_INFINITY : beam.max();
        if (!(distance >= min && distance <= max) && distance != Double.POSITIVE_INFINITY) {
            throw new ProtocolFault("a distance must be " + min + " to " + max + " or infinite (got: " + distance
                    + " for " + request + ")");
        }
    }

    /** One bundle with a move of each robot. */
    private void move(Connection connection) throws IOException, ClassNotFoundException {
        List<MoveRequest> moves = new ArrayList<>();
        for (Robot robot : robots) {
            moves.add(robot.wander());
        }
        long begin = System.nanoTime();
        Object answer = connection.ask(new MoveBundle(moves));
        tally.moveNanos.add(System.nanoTime() - begin);
        if (!(answer instanceof MoveBundle bundle)) {
            throw new ProtocolFault("a MoveBundle was answered by " + nameOf(answer));
        }
        List<MoveRequest> made = bundle.moves();
        int next = 0;
        for (int k = 0; k < moves.size(); k++) {
            boolean allowed = next < made.size() && sameBits(moves.get(k), made.get(next));
            next += allowed ? 1 : 0;
            robots.get(k).told(allowed);
        }
        if (next != made.size()) {
            throw new ProtocolFault("the answer must hold the moves that were made, in their order, bit for bit (got: "
                    + made.get(next) + ", which is none of those left)");
        }
        tally.asked += moves.size();
        tally.made += made.size();
    }

    /** Makes every robot a body; what drives it are two wheels, which reach the speed of a command at once. */
    private void giveBodies(Connection connection) throws IOException, ClassNotFoundException {
        StepBundle step = StepBundle.of(0);
        for (Robot robot : robots) {
            step = step.withBody(robot.name);
        }
        check(connection.ask(step));
    }

    /** One step in which all robots are driven. */
    private void drive(Connection connection) throws IOException, ClassNotFoundException {
        Map<String, Twist> motions = new LinkedHashMap<>();
        for (Robot robot : robots) {
            motions.put(robot.name, robot.steer());
        }
        long begin = System.nanoTime();
        Object answered = connection.ask(StepBundle.of(SECONDS).withMotions(motions));
        tally.stepNanos.add(System.nanoTime() - begin);
        StepBundle.Answer answer = check(answered);
        StepResult result = answer.result();
        Map<String, Pose> places = answer.places();
        for (int k = 0; k < robots.size(); k++) {
            String name = robots.get(k).name;
            Point before = robots.get(k).place;
            Point now = places.get(name).center();
            tally.driven += before == null ? 0 : Math.hypot(now.x() - before.x(), now.z() - before.z());
            robots.get(k).place = now;
            robots.get(k).touches = result.contacts().stream()
                    .anyMatch(contact -> name.equals(contact.body()) || name.equals(contact.other()));
        }
        for (BodyContact contact : result.contacts()) {
            tally.bumps += contact.phase() == BodyContact.Phase.BEGIN ? 1 : 0;
        }
        tally.stopped += answer.stopped().size();
    }

    /** All robots have to be told of, in the order in which they became bodies, and contacts are of bodies. */
    private StepBundle.Answer check(Object answer) {
        if (!(answer instanceof StepBundle.Answer step)) {
            throw new ProtocolFault("a StepBundle was answered by " + nameOf(answer));
        }
        List<String> names = new ArrayList<>();
        robots.forEach(robot -> names.add(robot.name));
        List<String> told = List.copyOf(step.places().keySet());
        if (!told.equals(names)) {
            throw new ProtocolFault("the bodies must be " + names + " (got: " + told + ")");
        }
        for (BodyContact contact : step.result().contacts()) {
            if (!names.contains(contact.body())) {
                throw new ProtocolFault("a contact must be that of a body (got: " + contact + ")");
            }
        }
        if (!names.containsAll(step.stopped())) {
            throw new ProtocolFault("only bodies are stopped (got: " + step.stopped() + ")");
        }
        return step;
    }

    private static boolean sameBits(MoveRequest a, MoveRequest b) {
        return a.objectName().equals(b.objectName())
                && same(a.x(), b.x())
                && same(a.y(), b.y())
                && same(a.z(), b.z())
                && same(a.rx(), b.rx())
                && same(a.ry(), b.ry());
    }

    private static boolean same(double a, double b) {
        return Double.doubleToRawLongBits(a) == Double.doubleToRawLongBits(b);
    }

    private static String nameOf(Object answer) {
        return answer == null ? "null" : answer.getClass().getName();
    }

    /** Thrown where the module says what the protocol does not allow. */
    private static final class ProtocolFault extends RuntimeException {
        private static final long serialVersionUID = 1;

        ProtocolFault(String message) {
            super(message);
        }
    }

    /** A robot: goes ahead where there is room, turns to the roomier side where there is not, and is bold at times. */
    private static final class Robot {
        private final String name;
        private final double speed;
        private final double reach;
        private final SplittableRandom random;
        private final List<SonarRequest> requests = new ArrayList<>();
        private final List<Double> bearings = new ArrayList<>();
        private final double[] distances;
        private int refusedInARow;
        private int boldSteps;
        private int retreatSteps;
        private double retreat;
        private double side = 1;
        private boolean touches;
        private Point place;

        Robot(WorldObject object, double speed, SplittableRandom random) {
            this.name = object.object().name();
            this.speed = speed;
            this.reach = reach(object.object());
            this.random = random;
            for (SonarRing ring : object.sonars()) {
                // On the wire every angle is in radians.
                Beam beam = new Beam(ring.min(), ring.max(), Math.toRadians(ring.width()));
                for (int sensor = 0; sensor < ring.count(); sensor++) {
                    Point direction = ring.direction(sensor);
                    requests.add(new SonarRequest(name, direction.x(), direction.z(), beam));
                    bearings.add(StrictMath.atan2(-direction.z(), direction.x()));
                }
            }
            if (requests.isEmpty()) {
                requests.add(new SonarRequest(name, 1, 0));
                bearings.add(0.0);
            }
            this.distances = new double[requests.size()];
        }

        /** How far a robot sticks out from its centre, where its shape tells. */
        private static double reach(GeometryObject object) {
            if (object instanceof BoxObject box) {
                return Math.hypot(box.width(), box.length()) / 2;
            }
            if (object instanceof CylinderObject cylinder) {
                return cylinder.radius();
            }
            return object instanceof SphereObject sphere ? sphere.radius() : 0;
        }

        MoveRequest wander() {
            double ahead = Double.POSITIVE_INFINITY;
            double left = 0;
            double right = 0;
            for (int k = 0; k < distances.length; k++) {
                double bearing = bearings.get(k);
                double seen = Math.min(distances[k], reach + 60 * speed);
                if (Math.abs(bearing) < 0.8) {
                    ahead = Math.min(ahead, seen);
                }
                if (bearing > 0) {
                    left += seen;
                } else if (bearing < 0) {
                    right += seen;
                }
            }
            if (refusedInARow > 0) {
                return unstick(left >= right ? 1 : -1);
            }
            if (retreatSteps > 0) {
                retreatSteps--;
                return backOff();
            }
            if (boldSteps == 0 && random.nextInt(50) == 0) {
                boldSteps = 40;
            }
            if (boldSteps > 0) {
                boldSteps--;
                return new MoveRequest(name, speed, 0, 0, 0, 0);
            }
            double jitter = random.nextDouble(-0.06, 0.06);
            if (ahead < reach + 8 * speed) {
                double side = left >= right ? 1 : -1;
                return new MoveRequest(name, speed / 4, 0, 0, 0, side * random.nextDouble(0.15, 0.35));
            }
            return new MoveRequest(name, speed, 0, 0, 0, jitter);
        }

        /** The same on wheels: after a bump it backs off for a while in a curve, to the roomier side. */
        Twist steer() {
            boolean backs = retreatSteps > 0;
            if (touches && !backs) {
                retreatSteps = 6 + random.nextInt(8);
                boldSteps = 0;
            }
            if (retreatSteps > 0) {
                retreatSteps--;
                side = backs ? side : random.nextBoolean() ? 1 : -1;
                return Twist.drive(-speed / (2 * SECONDS), side * 90);
            }
            MoveRequest wish = wander();
            return Twist.drive(wish.x() / SECONDS, Math.toDegrees(wish.ry() / SECONDS));
        }

        /** Turns away; where that is refused too, retreats a few steps to where it sees farthest, without a turn. */
        private MoveRequest unstick(int side) {
            boldSteps = 0;
            if (refusedInARow == 1) {
                return new MoveRequest(name, 0, 0, 0, 0, side * random.nextDouble(0.3, 2.4));
            }
            int farthest = random.nextInt(distances.length);
            for (int k = 0; k < distances.length; k++) {
                farthest = distances[k] > distances[farthest] ? k : farthest;
            }
            // Where that is refused as well, any way may be the one out.
            retreat = refusedInARow == 2 ? bearings.get(farthest) : random.nextDouble(-Math.PI, Math.PI);
            retreatSteps = 8;
            return backOff();
        }

        private MoveRequest backOff() {
            double x = speed * StrictMath.cos(retreat);
            double z = -speed * StrictMath.sin(retreat);
            return new MoveRequest(name, x, 0, z, 0, 0);
        }

        void told(boolean allowed) {
            refusedInARow = allowed ? 0 : refusedInARow + 1;
        }
    }

    /** The two object streams over a socket; whatever goes through is recorded too. */
    private static final class Connection {
        private final ObjectOutputStream out;
        private final InputStream recorded;
        private ObjectInputStream in;

        Connection(Socket socket, OutputStream sent, OutputStream received) throws IOException {
            this.out =
                    new ObjectOutputStream(new BufferedOutputStream(copyOf(socket.getOutputStream(), sent), 1 << 16));
            this.recorded = copyOf(socket.getInputStream(), received);
        }

        void send(Object bundle) throws IOException {
            out.writeObject(bundle);
            // Each bundle stands for itself: nothing refers back to an earlier one.
            out.reset();
            out.flush();
        }

        Object ask(Object bundle) throws IOException, ClassNotFoundException {
            send(bundle);
            if (in == null) {
                // Not before: this waits for the module's first bytes.
                in = new ObjectInputStream(new BufferedInputStream(recorded, 1 << 16));
            }
            return in.readObject();
        }

        private static OutputStream copyOf(OutputStream target, OutputStream copy) {
            return new FilterOutputStream(target) {
                @Override
                public void write(int b) throws IOException {
                    target.write(b);
                    copy.write(b);
                }

                @Override
                public void write(byte[] bytes, int from, int length) throws IOException {
                    target.write(bytes, from, length);
                    copy.write(bytes, from, length);
                }
            };
        }

        private static InputStream copyOf(InputStream source, OutputStream copy) {
            return new FilterInputStream(source) {
                @Override
                public int read() throws IOException {
                    int b = source.read();
                    if (b >= 0) {
                        copy.write(b);
                    }
                    return b;
                }

                @Override
                public int read(byte[] bytes, int from, int length) throws IOException {
                    int count = source.read(bytes, from, length);
                    if (count > 0) {
                        copy.write(bytes, from, count);
                    }
                    return count;
                }
            };
        }
    }

    /** What was asked, what was answered, and how long it took. */
    private static final class Tally {
        private long distances;
        private long echoes;
        private long asked;
        private long made;
        private double driven;
        private long bumps;
        private long stopped;
        private final Times stepNanos = new Times();
        private final Times sonarNanos = new Times();
        private final Times moveNanos = new Times();

        String properties(long steps, int robots) {
            Map<String, Object> values = new LinkedHashMap<>();
            values.put("steps", steps);
            values.put("robots", robots);
            values.put("moves.asked", asked);
            values.put("moves.made", made);
            if (stepNanos.size > 0) {
                values.put("drive.seconds", steps * SECONDS);
                values.put("drive.way", driven);
                values.put("drive.bumps", bumps);
                values.put("drive.stopped", stopped);
                values.put("step.median.us", stepNanos.micros(0.5));
                values.put("step.99.us", stepNanos.micros(0.99));
            }
            values.put("sonar.bundles", sonarNanos.size);
            values.put("distances", distances);
            values.put("echoes", echoes);
            values.put("sonar.median.us", sonarNanos.micros(0.5));
            values.put("sonar.99.us", sonarNanos.micros(0.99));
            values.put("move.median.us", moveNanos.micros(0.5));
            values.put("move.99.us", moveNanos.micros(0.99));
            StringBuilder text = new StringBuilder();
            values.forEach(
                    (key, value) -> text.append(key).append('=').append(value).append('\n'));
            return text.toString();
        }

        private static String count(long count, String one) {
            return String.format(Locale.ROOT, "%,d %s%s", count, one, count == 1 ? "" : "s");
        }

        String text(long steps, int robots) {
            if (stepNanos.size > 0) {
                return String.format(
                        Locale.ROOT,
                        "environment   %s of %s: %.1f driven, %s; %s, %,d of them echoes%n"
                                + "              every answer kept to the protocol%n"
                                + "              a step took %s us (median), %s us (99 %%)%n",
                        count(steps, "step"),
                        count(robots, "robot"),
                        driven,
                        count(bumps, "bump"),
                        count(distances, "distance"),
                        echoes,
                        stepNanos.micros(0.5),
                        stepNanos.micros(0.99));
            }
            return String.format(
                    Locale.ROOT,
                    "environment   %s of %s: %s asked, %,d made; %s, %,d of them echoes%n"
                            + "              every answer kept to the protocol%n"
                            + "              a round of sonar took %s us (median), %s us (99 %%); of moves %s us, %s us%n",
                    count(steps, "step"),
                    count(robots, "robot"),
                    count(asked, "move"),
                    made,
                    count(distances, "distance"),
                    echoes,
                    sonarNanos.micros(0.5),
                    sonarNanos.micros(0.99),
                    moveNanos.micros(0.5),
                    moveNanos.micros(0.99));
        }
    }

    /** Nanoseconds, many of them. */
    private static final class Times {
        private long[] nanos = new long[1024];
        private int size;

        void add(long value) {
            if (size == nanos.length) {
                nanos = Arrays.copyOf(nanos, 2 * size);
            }
            nanos[size++] = value;
        }

        /** The least time that so large a share stays within, in microseconds. */
        String micros(double share) {
            if (size == 0) {
                return "0";
            }
            long[] sorted = Arrays.copyOf(nanos, size);
            Arrays.sort(sorted);
            int rank = (int) Math.ceil(share * size) - 1;
            return String.format(Locale.ROOT, "%.1f", sorted[Math.max(0, rank)] / 1000.0);
        }
    }

    /** A bar on the terminal; nothing where the output goes elsewhere. */
    private static final class Progress {
        private static final int CELLS = 40;
        private final long steps;
        private final boolean shown;
        private final long begin = System.nanoTime();
        private long lastShown = begin - 1_000_000_000;

        Progress(long steps, boolean shown) {
            this.steps = steps;
            this.shown = shown;
        }

        void show(long done) {
            long now = System.nanoTime();
            if (!shown || (now - lastShown < 100_000_000 && done < steps)) {
                return;
            }
            lastShown = now;
            int filled = (int) (CELLS * done / steps);
            double seconds = (now - begin) / 1e9;
            System.err.printf(
                    Locale.ROOT,
                    "\r[%s%s] %3d %%  step %,d of %,d  %.0f steps/s ",
                    "#".repeat(filled),
                    ".".repeat(CELLS - filled),
                    100 * done / steps,
                    done,
                    steps,
                    done / Math.max(seconds, 1e-9));
        }

        void end() {
            if (shown) {
                System.err.println();
            }
        }
    }

    /** Arguments: {@code --name value}, and three names alone. */
    private static final class Options {
        private static final List<String> NAMES =
                List.of("world", "connect", "listen", "steps", "seed", "speed", "record");
        private final Map<String, String> values = new LinkedHashMap<>();

        Options(String[] arguments) {
            for (int k = 0; k < arguments.length; k++) {
                String name = arguments[k].startsWith("--") ? arguments[k].substring(2) : "";
                if (List.of("quiet", "progress", "drive").contains(name)) {
                    values.put(name, "");
                } else if (NAMES.contains(name) && k + 1 < arguments.length) {
                    values.put(name, arguments[++k]);
                } else {
                    throw new IllegalArgumentException(
                            "an argument must be one of those below, with its value (got: " + arguments[k] + ")");
                }
            }
        }

        boolean has(String name) {
            return values.containsKey(name);
        }

        String text(String name, String otherwise) {
            return values.getOrDefault(name, otherwise);
        }

        String require(String name) {
            String value = values.get(name);
            if (value == null) {
                throw new IllegalArgumentException("--" + name + " must be given");
            }
            return value;
        }

        long number(String name, long otherwise) {
            String value = values.get(name);
            try {
                long number = value == null ? otherwise : Long.parseLong(value);
                if (number >= 0) {
                    return number;
                }
            } catch (NumberFormatException noNumber) {
                // Refused below, like a negative one.
            }
            throw new IllegalArgumentException(
                    "--" + name + " must be a whole number of at least 0 (got: " + value + ")");
        }

        double decimal(String name, double otherwise) {
            String value = values.get(name);
            try {
                double number = value == null ? otherwise : Double.parseDouble(value);
                if (number > 0 && number < 1e9) {
                    return number;
                }
            } catch (NumberFormatException noNumber) {
                // Refused below, like one out of range.
            }
            throw new IllegalArgumentException("--" + name + " must be a number above 0 (got: " + value + ")");
        }
    }
}
