import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.PrintStream;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
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

/**
 * Reads the recorded bytes of a conversation between an environment and the geometry module and decides afterwards, by
 * geometry of its own, whether the module was right: that no robot overlapped anything that it had not overlapped at the
 * start, on the way or at the end of a move; that each refused move was blocked; that each distance was right. Where the
 * movement was handed over in steps: that no step left anything in anything else or beyond the border, that no centre went
 * through anything, that a robot that met nothing has driven as it was told, and that contacts are where they are said to be.
 *
 * <p>It takes nothing from the module but the bundles and the objects' numbers. Everything is brute force on convex
 * pieces: the gap of two pieces is the largest over all candidate axes, the way of a translation is the convex hull of its
 * ends, a turn is halved until every part of it is certain, a beam is held against every piece.
 *
 * <p>The places of robots are summed in doubles here, as they are there, but not in the same order of operations: they may
 * drift apart by a few units in the last place for each move. {@link #SLACK} covers a million moves in a world of 1000
 * units; what is closer than it is neither right nor wrong and is counted as undecided.
 *
 * <pre>
 * java -cp target/classes examples/ConversationAudit.java target/demo
 * </pre>
 */
public final class ConversationAudit {
    /** World units within which a contact or a distance is not judged. */
    private static final double SLACK = 1e-9;

    /** Radians by which a beam may be turned by the places' drift. */
    private static final double TURN_SLACK = 1e-10;

    /** Corners of the polygon that stands for the rim of a tipped cylinder. */
    private static final int RIM = 2000;

    /** Faults that are told one by one. */
    private static final int TOLD = 20;

    private final PrintStream out;
    private final Map<String, Integer> byName = new HashMap<>();
    private final List<Body> bodies = new ArrayList<>();
    private final Map<String, Integer> refusedBy = new TreeMap<>();
    private final Set<Long> inContact = new HashSet<>();
    private double halfWidth;
    private double halfLength;
    private double slack = SLACK;

    private long asked;
    private long made;
    private long refused;
    private long undecided;
    private long startedInContact;
    private long distances;
    private long grazing;
    private long faults;
    private double largestError;
    private final Map<String, Twist> told = new HashMap<>();
    private long steps;
    private long places;
    private long free;
    private long contacts;
    private double largestDrift;
    private double leastGap = Double.POSITIVE_INFINITY;

    private ConversationAudit(PrintStream out) {
        this.out = out;
    }

    /** Exits with 0 where nothing is wrong, 1 where something is, 2 where the recording cannot be read. */
    public static void main(String[] arguments) {
        System.exit(run(arguments, System.out));
    }

    /** Audits the recording in a folder, writes audit.properties beside it, and answers the exit code. */
    public static int run(String[] arguments, PrintStream out) {
        if (arguments.length != 1) {
            out.println("usage: java -cp target/classes examples/ConversationAudit.java FOLDER"
                    + "   (with to-module.bin and from-module.bin)");
            return 2;
        }
        Path folder = Path.of(arguments[0]);
        ConversationAudit audit = new ConversationAudit(out);
        try (ObjectInputStream asked = open(folder.resolve("to-module.bin"));
                ObjectInputStream answered = open(folder.resolve("from-module.bin"))) {
            audit.read(asked, answered);
            Files.writeString(folder.resolve("audit.properties"), audit.properties());
        } catch (IOException | ClassNotFoundException | RuntimeException unreadable) {
            out.println("audit         the recording cannot be read: " + unreadable);
            return 2;
        }
        out.print(audit.text());
        return audit.faults == 0 ? 0 : 1;
    }

    private static ObjectInputStream open(Path file) throws IOException {
        return new ObjectInputStream(new BufferedInputStream(Files.newInputStream(file), 1 << 16));
    }

    // ---- the conversation ------------------------------------------------------------------------------------------

    private void read(ObjectInputStream requests, ObjectInputStream answers)
            throws IOException, ClassNotFoundException {
        Object request = next(requests);
        if (!(request instanceof InitBundle)) {
            throw new IOException("the first bundle must be an InitBundle (got: " + request + ")");
        }
        while (request != null) {
            if (request instanceof InitBundle init) {
                begin(init);
            } else if (request instanceof MoveBundle moves) {
                judgeMoves(moves.moves(), ((MoveBundle) require(next(answers))).moves());
            } else if (request instanceof StepBundle step) {
                judgeStep(step, (StepBundle.Answer) require(next(answers)));
            } else if (request instanceof SonarRequestBundle sonar) {
                judgeDistances(sonar.requests(), ((DistanceBundle) require(next(answers))).distances());
            } else {
                throw new IOException("no request: " + request);
            }
            request = next(requests);
        }
        if (next(answers) != null) {
            fault("there are more answers than requests");
        }
    }

    private static Object next(ObjectInputStream in) throws IOException, ClassNotFoundException {
        try {
            return in.readObject();
        } catch (EOFException end) {
            return null;
        }
    }

    private static Object require(Object answer) throws IOException {
        if (answer == null) {
            throw new IOException("the recording ends before the last answer");
        }
        return answer;
    }

    private void begin(InitBundle init) throws IOException {
        WorldSettings settings = init.settings();
        if (settings == null || settings.dimension() != Dimension.PLANAR) {
            throw new IOException("only conversations with PLANAR settings can be judged (got: " + settings + ")");
        }
        halfWidth = settings.width() / 2;
        halfLength = settings.length() / 2;
        bodies.clear();
        byName.clear();
        inContact.clear();
        for (GeometryObject object : init.objects()) {
            Body body = new Body(object);
            slack = Math.max(slack, body.slack);
            if (object.name() != null) {
                byName.put(object.name(), bodies.size());
            }
            bodies.add(body);
        }
        for (int mover = 0; mover < bodies.size(); mover++) {
            for (int other = 0; bodies.get(mover).moveable && other < bodies.size(); other++) {
                if (mover != other && gap(bodies.get(mover), bodies.get(other)) <= slack) {
                    inContact.add(pair(mover, other));
                }
            }
        }
        startedInContact = inContact.size();
    }

    private static long pair(int a, int b) {
        return (long) Math.min(a, b) << 32 | Math.max(a, b);
    }

    private Body moveable(String name) {
        Integer index = byName.get(name);
        return index == null || !bodies.get(index).moveable ? null : bodies.get(index);
    }

    private void fault(String message) {
        faults++;
        if (faults <= TOLD) {
            out.println("fault " + faults + ": " + message);
        }
    }

    // ---- moves -----------------------------------------------------------------------------------------------------

    private void judgeMoves(List<MoveRequest> moves, List<MoveRequest> answer) {
        int next = 0;
        for (MoveRequest move : moves) {
            asked++;
            boolean allowed = next < answer.size() && answer.get(next).equals(move);
            next += allowed ? 1 : 0;
            made += allowed ? 1 : 0;
            refused += allowed ? 0 : 1;
            judge(move, allowed);
        }
        if (next < answer.size()) {
            fault("an answer holds a move that was not asked, or out of order: " + answer.get(next));
        }
    }

    private void judge(MoveRequest move, boolean allowed) {
        Body mover = moveable(move.objectName());
        if (mover == null) {
            if (allowed) {
                fault("a move of no moveable object was made: " + move);
            }
            return;
        }
        if (move.y() != 0 || move.rx() != 0) {
            fault("a move up, down or about the own X cannot be judged here: " + move);
            return;
        }
        Motion motion = new Motion(mover, move);
        double least = motion.borderGap(halfWidth, halfLength);
        String nearest = "the border";
        int self = byName.get(move.objectName());
        boolean excused = false;
        for (int k = 0; k < bodies.size(); k++) {
            if (k == self) {
                continue;
            }
            if (inContact.contains(pair(self, k))) {
                excused = true;
                continue;
            }
            double gap = motion.gap(bodies.get(k), slack);
            if (gap < least) {
                least = gap;
                nearest = bodies.get(k).text;
            }
        }
        if (Math.abs(least) <= slack) {
            undecided++;
        } else if (allowed && least < 0) {
            fault("a move went " + -least + " deep into " + nearest + ": " + move);
        } else if (!allowed && least > 0 && !excused) {
            fault("a move was refused that is free by " + least + ": " + move);
        }
        if (!allowed) {
            refusedBy.merge(
                    least <= slack ? motion.first(bodies, self, nearest, this::isInContact) : "contact at the start",
                    1,
                    Integer::sum);
            return;
        }
        leastGap = Math.min(leastGap, least);
        motion.carryOut();
        inContact.removeIf(
                pair -> (pair >> 32 == self || (pair & 0xffffffffL) == self) && gap(first(pair), second(pair)) > slack);
    }

    private boolean isInContact(int a, int b) {
        return inContact.contains(pair(a, b));
    }

    private Body first(long pair) {
        return bodies.get((int) (pair >> 32));
    }

    private Body second(long pair) {
        return bodies.get((int) pair);
    }

    // ---- steps -----------------------------------------------------------------------------------------------------

    private void judgeStep(StepBundle step, StepBundle.Answer answer) {
        steps++;
        step.bodyNames().forEach(name -> told.put(name, Twist.drive(0, 0)));
        told.putAll(step.motions());
        StepResult result = answer.result();
        List<BodyContact> all = new ArrayList<>(result.contacts());
        all.addAll(result.ended());
        Set<String> touching = new HashSet<>(answer.stopped());
        for (BodyContact contact : all) {
            contacts += contact.phase() == BodyContact.Phase.BEGIN ? 1 : 0;
            touching.add(contact.body());
            touching.add(contact.other());
        }
        Map<Body, double[]> before = new HashMap<>();
        for (Map.Entry<String, Pose> each : answer.places().entrySet()) {
            String name = each.getKey();
            Pose at = each.getValue();
            Body body = moveable(name);
            if (body == null) {
                fault("a step tells of no moveable object: " + name + " at " + at);
                return;
            }
            before.put(body, new double[] {body.x, body.z});
            if (!touching.contains(name) && !isInContact(body)) {
                judgeFree(body, told.get(name), step.seconds(), at);
            }
            body.place(at.center().x(), at.center().z(), Math.toRadians(at.heading()));
        }
        for (String name : answer.places().keySet()) {
            judgePlace(byName.get(name), before.get(moveable(name)));
        }
        for (BodyContact contact : all) {
            judgeContact(contact, before);
        }
        inContact.removeIf(pair -> gap(first(pair), second(pair)) > slack);
    }

    private boolean isInContact(Body body) {
        int self = bodies.indexOf(body);
        return inContact.stream().anyMatch(pair -> pair >> 32 == self || (pair & 0xffffffffL) == self);
    }

    /** Two wheels that go at their speeds at once carry what meets nothing along an arc. */
    private void judgeFree(Body body, Twist command, double seconds, Pose at) {
        free++;
        double half = Math.toRadians(command.ry()) * seconds / 2;
        double chord = command.x() * seconds * (half == 0 ? 1 : StrictMath.sin(half) / half);
        double c = body.c * StrictMath.cos(half) - body.s * StrictMath.sin(half);
        double s = body.s * StrictMath.cos(half) + body.c * StrictMath.sin(half);
        double off =
                Math.hypot(at.center().x() - (body.x + c * chord), at.center().z() - (body.z - s * chord));
        double endC = c * StrictMath.cos(half) - s * StrictMath.sin(half);
        double endS = s * StrictMath.cos(half) + c * StrictMath.sin(half);
        double heading = Math.toRadians(at.heading());
        double turned = Math.hypot(StrictMath.cos(heading) - endC, StrictMath.sin(heading) - endS);
        largestDrift = Math.max(largestDrift, Math.max(off, turned));
        if (!(off <= slack && turned <= slack)) {
            fault("a robot that met nothing is off by " + off + " and " + turned + " radians: " + command + ", " + at);
        }
    }

    /** A body must not be in anything but what it overlapped from the start, nor have gone through anything. */
    private void judgePlace(int self, double[] from) {
        Body body = bodies.get(self);
        double least = Double.POSITIVE_INFINITY;
        String nearest = "the border";
        for (Piece piece : body.pieces) {
            least = Math.min(least, Motion.room(piece, halfWidth, halfLength));
        }
        Piece way = hull(new double[] {from[0], body.x}, new double[] {from[1], body.z}, 0);
        for (int k = 0; k < bodies.size(); k++) {
            Body other = bodies.get(k);
            if (k == self
                    || inContact.contains(pair(self, k))
                    || other.centreDistance(body.x, body.z) - other.reach - body.reach > 1) {
                continue;
            }
            double gap = gap(body, other);
            if (gap < least) {
                least = gap;
                nearest = other.text;
            }
            for (Piece piece : other.pieces) {
                if (!other.moveable && gap(way, piece) < -slack) {
                    fault("the centre of " + body.text + " went through " + other.text);
                }
            }
        }
        places++;
        leastGap = Math.min(leastGap, least);
        if (least < -slack) {
            fault("a step left " + body.text + " " + -least + " deep in " + nearest);
        }
    }

    /** A contact is no farther from either of the two than these have moved in the step. */
    private void judgeContact(BodyContact contact, Map<Body, double[]> before) {
        double size = Math.hypot(contact.normal().x(), contact.normal().z());
        if (Math.abs(size - 1) > slack) {
            fault("a normal must have the length 1: " + contact);
        }
        Piece point = Body.disc(contact.point().x(), contact.point().z(), 0);
        for (String name : new String[] {contact.body(), contact.other()}) {
            Integer index = name == null ? null : byName.get(name);
            if (index != null) {
                Body body = bodies.get(index);
                double[] from = before.getOrDefault(body, new double[] {body.x, body.z});
                // Of what turns, the rim moves too: by no more than its way round in the step.
                double moved =
                        Math.hypot(body.x - from[0], body.z - from[1]) + (before.containsKey(body) ? body.reach : 0);
                double apart = Double.POSITIVE_INFINITY;
                for (Piece piece : body.pieces) {
                    apart = Math.min(apart, gap(point, piece));
                }
                if (apart > moved + 1e-6) {
                    fault("a contact is " + apart + " from " + name + ": " + contact);
                }
            }
        }
    }

    // ---- distances -------------------------------------------------------------------------------------------------

    private void judgeDistances(List<SonarRequest> requests, List<Double> answer) {
        if (requests.size() != answer.size()) {
            fault(requests.size() + " requests were answered by " + answer.size() + " distances");
            return;
        }
        for (int k = 0; k < requests.size(); k++) {
            distances++;
            judge(requests.get(k), answer.get(k));
        }
    }

    private void judge(SonarRequest request, double answer) {
        Body body = moveable(request.objectName());
        if (body == null) {
            if (!Double.isNaN(answer)) {
                fault("a distance for no moveable object: " + answer + " for " + request);
            }
            return;
        }
        Beam beam = request.beam() == null ? new Beam(0, Double.POSITIVE_INFINITY, 0) : request.beam();
        double ux = body.c * request.xOffset() + body.s * request.zOffset();
        double uz = -body.s * request.xOffset() + body.c * request.zOffset();
        double length = Math.sqrt(ux * ux + uz * uz);
        Sector sector = new Sector(body.x, body.z, ux / length, uz / length, beam.width() / 2);
        double seen = limited(nearest(sector, body), beam);
        if (within(answer, seen, seen)) {
            largestError = Math.max(largestError, seen == answer ? 0 : Math.abs(seen - answer));
            return;
        }
        // A beam that grazes a corner sees it or does not: what the drift of a place can change is allowed.
        double low = seen;
        double high = seen;
        for (Sector turned : sector.disturbed(TURN_SLACK, slack)) {
            double other = limited(nearest(turned, body), beam);
            low = Math.min(low, other);
            high = Math.max(high, other);
        }
        if (within(answer, low, high)) {
            grazing++;
        } else {
            fault("a distance of " + answer + " should be " + seen + " (" + low + " to " + high + "): " + request);
        }
    }

    private boolean within(double answer, double low, double high) {
        return answer >= low - slack && answer <= high + slack;
    }

    private static double limited(double distance, Beam beam) {
        return distance > beam.max() ? Double.POSITIVE_INFINITY : Math.max(distance, beam.min());
    }

    private double nearest(Sector sector, Body self) {
        double nearest = Double.POSITIVE_INFINITY;
        for (Body other : bodies) {
            if (other != self && other.centreDistance(sector.x, sector.z) - other.reach < nearest + slack) {
                for (Piece piece : other.pieces) {
                    if (piece.beyond(sector.x, sector.z) < nearest + slack) {
                        nearest = Math.min(nearest, sector.distance(piece));
                    }
                }
            }
        }
        return nearest;
    }

    // ---- results ---------------------------------------------------------------------------------------------------

    private String properties() {
        StringBuilder text = new StringBuilder();
        text.append("moves.asked=").append(asked).append('\n');
        text.append("moves.made=").append(made).append('\n');
        text.append("moves.refused=").append(refused).append('\n');
        text.append("moves.undecided=").append(undecided).append('\n');
        text.append("moves.least.gap=").append(leastGap).append('\n');
        text.append("contacts.at.start=").append(startedInContact).append('\n');
        if (steps > 0) {
            text.append("steps=").append(steps).append('\n');
            text.append("steps.places=").append(places).append('\n');
            text.append("steps.contacts=").append(contacts).append('\n');
            text.append("steps.free=").append(free).append('\n');
            text.append("steps.largest.drift=").append(largestDrift).append('\n');
        }
        text.append("distances=").append(distances).append('\n');
        text.append("distances.grazing=").append(grazing).append('\n');
        text.append("distances.largest.error=").append(largestError).append('\n');
        text.append("slack=").append(slack).append('\n');
        text.append("faults=").append(faults).append('\n');
        refusedBy.forEach((name, count) -> text.append("refused.by.")
                .append(count)
                .append('=')
                .append(name)
                .append('\n'));
        return text.toString();
    }

    private String text() {
        StringBuilder text = new StringBuilder();
        String line = "%-14s%s%n";
        if (steps > 0) {
            text.append(line.formatted(
                    "audit",
                    "%,d steps: %,d places, none in anything else; %,d contacts began"
                            .formatted(steps, places, contacts)));
            text.append(line.formatted(
                    "",
                    "%,d times a robot met nothing, and drove as it was told to within %s"
                            .formatted(free, largestDrift)));
        }
        if (asked > 0 || steps == 0) {
            text.append(line.formatted(
                    steps > 0 ? "" : "audit",
                    "%,d moves: %,d made, %,d refused, %,d too close to judge"
                            .formatted(asked, made, refused, undecided)));
        }
        if (startedInContact > 0) {
            text.append(line.formatted("", "%,d pairs overlapped at the start".formatted(startedInContact)));
        }
        text.append(line.formatted(
                "", "the closest a made " + (steps > 0 ? "step" : "move") + " came to anything: " + leastGap));
        List<Map.Entry<String, Integer>> blockers = new ArrayList<>(refusedBy.entrySet());
        blockers.sort(Map.Entry.<String, Integer>comparingByValue().reversed());
        for (Map.Entry<String, Integer> blocker : blockers.subList(0, Math.min(8, blockers.size()))) {
            text.append(line.formatted("", "%,7d refused by %s".formatted(blocker.getValue(), blocker.getKey())));
        }
        text.append(line.formatted(
                "",
                "%,d distances: largest error %s, %,d at the very edge of a beam"
                        .formatted(distances, largestError, grazing)));
        text.append(line.formatted("", faults == 0 ? "nothing is wrong" : "%,d FAULTS".formatted(faults)));
        return text.toString();
    }

    // ---- geometry --------------------------------------------------------------------------------------------------

    /** A convex piece: a polygon, or a disc, which is a polygon of one corner and a radius. */
    private static final class Piece {
        private final double[] x;
        private final double[] z;
        private final double radius;

        /** How far from its first corner it reaches. */
        private final double reach;

        Piece(double[] x, double[] z, double radius) {
            this.x = x;
            this.z = z;
            this.radius = radius;
            double far = 0;
            for (int k = 1; k < x.length; k++) {
                far = Math.max(far, Math.hypot(x[k] - x[0], z[k] - z[0]));
            }
            this.reach = far + radius;
        }

        /** A distance from a place that no point of it is within, or about. */
        double beyond(double fromX, double fromZ) {
            return Math.hypot(x[0] - fromX, z[0] - fromZ) - reach;
        }
    }

    /** The convex hull of points, counter-clockwise as x turns to z: gift wrapping. */
    private static Piece hull(double[] x, double[] z, double radius) {
        int count = x.length;
        int first = 0;
        for (int k = 1; k < count; k++) {
            if (x[k] < x[first] || (x[k] == x[first] && z[k] < z[first])) {
                first = k;
            }
        }
        double[] hullX = new double[count];
        double[] hullZ = new double[count];
        int size = 0;
        int at = first;
        do {
            hullX[size] = x[at];
            hullZ[size++] = z[at];
            int next = at;
            for (int k = 0; k < count; k++) {
                if (x[k] == x[at] && z[k] == z[at]) {
                    continue;
                }
                double turn = (x[next] - x[at]) * (z[k] - z[at]) - (z[next] - z[at]) * (x[k] - x[at]);
                boolean farther = Math.hypot(x[k] - x[at], z[k] - z[at]) > Math.hypot(x[next] - x[at], z[next] - z[at]);
                if ((x[next] == x[at] && z[next] == z[at]) || turn < 0 || (turn == 0 && farther)) {
                    next = k;
                }
            }
            at = next;
        } while (size < count && !(x[at] == hullX[0] && z[at] == hullZ[0]));
        return new Piece(Arrays.copyOf(hullX, size), Arrays.copyOf(hullZ, size), radius);
    }

    /**
     * How far two pieces are apart; below 0, how deep they overlap. Between polygons the distance and the depth are both
     * attained at the normal of an edge or at the line through two corners, so the largest gap over these axes is it.
     */
    private static double gap(Piece a, Piece b) {
        double best = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < a.x.length; i++) {
            for (int j = 0; j < b.x.length; j++) {
                best = Math.max(best, gapAlong(a, b, b.x[j] - a.x[i], b.z[j] - a.z[i]));
            }
        }
        best = Math.max(best, gapAlongNormals(a, b));
        best = Math.max(best, gapAlongNormals(b, a));
        if (best == Double.NEGATIVE_INFINITY) {
            best = 0; // two points at one place
        }
        return best - a.radius - b.radius;
    }

    private static double gapAlongNormals(Piece a, Piece b) {
        double best = Double.NEGATIVE_INFINITY;
        int n = a.x.length;
        for (int i = 0; n > 1 && i < n; i++) {
            int next = (i + 1) % n;
            // Outward, as the corners go round from x to z.
            best = Math.max(best, gapAlong(a, b, a.z[next] - a.z[i], a.x[i] - a.x[next]));
        }
        return best;
    }

    /** The gap between the shadows of two pieces on an axis, from a to b. */
    private static double gapAlong(Piece a, Piece b, double ax, double az) {
        double length = Math.sqrt(ax * ax + az * az);
        if (length == 0) {
            return Double.NEGATIVE_INFINITY;
        }
        double farthest = Double.NEGATIVE_INFINITY;
        double nearest = Double.POSITIVE_INFINITY;
        // From a corner of a, so that large coordinates cancel before they are multiplied.
        for (int i = 0; i < a.x.length; i++) {
            farthest = Math.max(farthest, (a.x[i] - a.x[0]) * ax + (a.z[i] - a.z[0]) * az);
        }
        for (int j = 0; j < b.x.length; j++) {
            nearest = Math.min(nearest, (b.x[j] - a.x[0]) * ax + (b.z[j] - a.z[0]) * az);
        }
        return (nearest - farthest) / length;
    }

    private static double gap(Body a, Body b) {
        double least = Double.POSITIVE_INFINITY;
        for (Piece p : a.pieces) {
            for (Piece q : b.pieces) {
                double around = q.beyond(p.x[0], p.z[0]) - p.reach;
                least = Math.min(least, around > 1 ? around : gap(p, q));
            }
        }
        return least;
    }

    /** An object: its pieces on the floor, and for one that moves its place and the cosine and sine of its heading. */
    private static final class Body {
        private static final BigDecimal TURN = new BigDecimal(
                "6.28318530717958647692528676655900576839433879875021164194988918461563281257241799725606");

        private final String text;
        private final boolean moveable;
        private final List<Piece> pieces = new ArrayList<>();
        private final List<Piece> first;
        private final double firstX;
        private final double firstZ;
        private final double firstC;
        private final double firstS;
        private double startC;
        private double startS;
        private BigDecimal turned = BigDecimal.ZERO;
        private double x;
        private double z;
        private double c;
        private double s;
        private double reach;
        private double slack;

        Body(GeometryObject object) {
            this.text = object.name() == null ? unnamed(object) : object.name();
            this.moveable = object.isMoveable();
            this.x = object.center().x();
            this.z = object.center().z();
            double[] rotation = object.rotation();
            this.startC = rotation[0];
            this.startS = rotation[2];
            this.c = startC;
            this.s = startS;
            add(object, new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, 0, 0, 0);
            first = List.copyOf(pieces);
            firstX = x;
            firstZ = z;
            firstC = c;
            firstS = s;
            for (Piece piece : pieces) {
                for (int k = 0; k < piece.x.length; k++) {
                    reach = Math.max(reach, Math.hypot(piece.x[k] - x, piece.z[k] - z) + piece.radius);
                }
            }
        }

        /** What has no name is known by its place. */
        private static String unnamed(GeometryObject object) {
            return "a " + object.kind().name().toLowerCase(Locale.ROOT) + " at ("
                    + (float) object.center().x() + ", "
                    + (float) object.center().z() + ")";
        }

        /** Puts it at a place, with a heading in radians. */
        void place(double toX, double toZ, double heading) {
            x = toX;
            z = toZ;
            c = StrictMath.cos(heading);
            s = StrictMath.sin(heading);
            startC = c;
            startS = s;
            turned = BigDecimal.ZERO;
            double turnC = firstC * c + firstS * s;
            double turnS = firstC * s - firstS * c;
            pieces.clear();
            for (Piece piece : first) {
                double[] px = new double[piece.x.length];
                double[] pz = new double[piece.x.length];
                for (int k = 0; k < px.length; k++) {
                    double ownX = piece.x[k] - firstX;
                    double ownZ = piece.z[k] - firstZ;
                    px[k] = turnC * ownX + turnS * ownZ + x;
                    pz[k] = -turnS * ownX + turnC * ownZ + z;
                }
                pieces.add(new Piece(px, pz, piece.radius));
            }
        }

        double centreDistance(double fromX, double fromZ) {
            return Math.hypot(x - fromX, z - fromZ);
        }

        /** Adds the pieces of an object that stands in a frame. */
        private void add(GeometryObject object, double[] frame, double ox, double oy, double oz) {
            double[] r = product(frame, object.rotation());
            Point p = object.center();
            double cx = frame[0] * p.x() + frame[1] * p.y() + frame[2] * p.z() + ox;
            double cy = frame[3] * p.x() + frame[4] * p.y() + frame[5] * p.z() + oy;
            double cz = frame[6] * p.x() + frame[7] * p.y() + frame[8] * p.z() + oz;
            if (object instanceof ObjectGroup group) {
                group.members().forEach(member -> add(member, r, cx, cy, cz));
            } else if (object instanceof SphereObject sphere) {
                pieces.add(disc(cx, cz, sphere.radius()));
            } else if (object instanceof CylinderObject cylinder && r[1] == 0 && r[7] == 0) {
                pieces.add(disc(cx, cz, cylinder.radius()));
            } else if (object instanceof CylinderObject cylinder) {
                double[][] rims = rims(cylinder);
                // A chord stays behind its arc by radius * (1 - cos(pi / RIM)).
                slack = Math.max(slack, cylinder.radius() * 5 / RIM / RIM);
                pieces.add(shadow(rims, r, cx, cz));
            } else if (object instanceof BoxObject box) {
                double[][] corners = new double[8][];
                for (int k = 0; k < 8; k++) {
                    corners[k] = new double[] {
                        (k & 1) == 0 ? -box.width() / 2 : box.width() / 2,
                        (k & 2) == 0 ? -box.height() / 2 : box.height() / 2,
                        (k & 4) == 0 ? -box.length() / 2 : box.length() / 2
                    };
                }
                pieces.add(shadow(corners, r, cx, cz));
            } else if (object instanceof MeshObject mesh) {
                List<Point> vertices = mesh.vertices();
                for (int[] face : mesh.faces()) {
                    for (int k = 2; k < face.length; k++) {
                        double[][] corners = new double[3][];
                        for (int corner = 0; corner < 3; corner++) {
                            Point v = vertices.get(face[corner == 0 ? 0 : k - 2 + corner]);
                            corners[corner] = new double[] {v.x(), v.y(), v.z()};
                        }
                        pieces.add(shadow(corners, r, cx, cz));
                    }
                }
            }
        }

        private static double[][] rims(CylinderObject cylinder) {
            double[][] rims = new double[2 * RIM][];
            for (int k = 0; k < RIM; k++) {
                double angle = 2 * Math.PI * k / RIM;
                double rx = cylinder.radius() * StrictMath.cos(angle);
                double rz = cylinder.radius() * StrictMath.sin(angle);
                rims[2 * k] = new double[] {rx, cylinder.height() / 2, rz};
                rims[2 * k + 1] = new double[] {rx, -cylinder.height() / 2, rz};
            }
            return rims;
        }

        private static Piece disc(double x, double z, double radius) {
            return new Piece(new double[] {x}, new double[] {z}, radius);
        }

        private static Piece shadow(double[][] points, double[] r, double cx, double cz) {
            double[] px = new double[points.length];
            double[] pz = new double[points.length];
            for (int k = 0; k < points.length; k++) {
                double[] p = points[k];
                px[k] = r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + cx;
                pz[k] = r[6] * p[0] + r[7] * p[1] + r[8] * p[2] + cz;
            }
            return hull(px, pz, 0);
        }

        private static double[] product(double[] a, double[] b) {
            double[] product = new double[9];
            for (int k = 0; k < 9; k++) {
                int row = k / 3 * 3;
                product[k] = a[row] * b[k % 3] + a[row + 1] * b[k % 3 + 3] + a[row + 2] * b[k % 3 + 6];
            }
            return product;
        }

        /** Turns by radians, which are summed without loss. */
        private void turn(double radians) {
            turned = turned.add(new BigDecimal(radians));
            double rest = turned.remainder(TURN, new MathContext(turned.precision() + 90))
                    .doubleValue();
            double turnC = StrictMath.cos(rest);
            double turnS = StrictMath.sin(rest);
            c = startC * turnC - startS * turnS;
            s = startS * turnC + startC * turnS;
        }
    }

    /** A move of a body: first a straight line, then a turn in place. */
    private static final class Motion {
        private final Body mover;
        private final double dx;
        private final double dz;
        private final double radians;

        Motion(Body mover, MoveRequest move) {
            this.mover = mover;
            this.dx = mover.c * move.x() + mover.s * move.z();
            this.dz = -mover.s * move.x() + mover.c * move.z();
            this.radians = move.ry();
        }

        /** What a piece sweeps while the body goes a share of its line. */
        private Piece swept(Piece piece, double share) {
            int n = piece.x.length;
            double[] x = Arrays.copyOf(piece.x, 2 * n);
            double[] z = Arrays.copyOf(piece.z, 2 * n);
            for (int k = 0; k < n; k++) {
                x[n + k] = piece.x[k] + share * dx;
                z[n + k] = piece.z[k] + share * dz;
            }
            return hull(x, z, piece.radius);
        }

        /** A piece after the line and so many radians of the turn. */
        private Piece turned(Piece piece, double angle) {
            double c = StrictMath.cos(angle);
            double s = StrictMath.sin(angle);
            double[] x = new double[piece.x.length];
            double[] z = new double[piece.x.length];
            for (int k = 0; k < x.length; k++) {
                double ownX = piece.x[k] - mover.x;
                double ownZ = piece.z[k] - mover.z;
                x[k] = c * ownX + s * ownZ + mover.x + dx;
                z[k] = -s * ownX + c * ownZ + mover.z + dz;
            }
            return new Piece(x, z, piece.radius);
        }

        /** A disc about the centre is the same in every direction. */
        private boolean turns(Piece piece) {
            return radians != 0 && !(piece.x.length == 1 && piece.x[0] == mover.x && piece.z[0] == mover.z);
        }

        /** The least gap to a body on the way, or a lower bound above the slack; far bodies are told by circles. */
        double gap(Body other, double slack) {
            double length = Math.hypot(dx, dz);
            double apart = mover.centreDistance(other.x, other.z) - mover.reach - other.reach - length;
            if (apart > 1) {
                return apart;
            }
            double least = Double.POSITIVE_INFINITY;
            for (Piece piece : mover.pieces) {
                Piece line = swept(piece, 1);
                for (Piece obstacle : other.pieces) {
                    double around = obstacle.beyond(mover.x, mover.z) - mover.reach - length;
                    if (around > 1) {
                        least = Math.min(least, around);
                        continue;
                    }
                    least = Math.min(least, ConversationAudit.gap(line, obstacle));
                    if (turns(piece)) {
                        least = Math.min(least, turnGap(piece, obstacle, 0, radians, slack));
                    }
                }
            }
            return least;
        }

        /** Halves the turn until no point of the piece can move farther than the gap, or an overlap is seen. */
        private double turnGap(Piece piece, Piece obstacle, double from, double to, double slack) {
            double gap = ConversationAudit.gap(turned(piece, (from + to) / 2), obstacle);
            double travel = mover.reach * Math.abs(to - from) / 2;
            if (gap < -slack || travel < slack / 4) {
                return gap;
            }
            if (gap - travel > slack) {
                return gap - travel;
            }
            double middle = (from + to) / 2;
            double first = turnGap(piece, obstacle, from, middle, slack);
            return first < -slack ? first : Math.min(first, turnGap(piece, obstacle, middle, to, slack));
        }

        double borderGap(double halfWidth, double halfLength) {
            double least = Double.POSITIVE_INFINITY;
            for (Piece piece : mover.pieces) {
                least = Math.min(least, room(swept(piece, 1), halfWidth, halfLength));
                if (turns(piece)) {
                    least = Math.min(least, borderTurnGap(piece, 0, radians, halfWidth, halfLength));
                }
            }
            return least;
        }

        private double borderTurnGap(Piece piece, double from, double to, double halfWidth, double halfLength) {
            double gap = room(turned(piece, (from + to) / 2), halfWidth, halfLength);
            double travel = mover.reach * Math.abs(to - from) / 2;
            if (gap < -SLACK || travel < SLACK / 4) {
                return gap;
            }
            if (gap - travel > SLACK) {
                return gap - travel;
            }
            double middle = (from + to) / 2;
            return Math.min(
                    borderTurnGap(piece, from, middle, halfWidth, halfLength),
                    borderTurnGap(piece, middle, to, halfWidth, halfLength));
        }

        private static double room(Piece piece, double halfWidth, double halfLength) {
            double least = Double.POSITIVE_INFINITY;
            for (int k = 0; k < piece.x.length; k++) {
                least = Math.min(least, halfWidth - Math.abs(piece.x[k]));
                least = Math.min(least, halfLength - Math.abs(piece.z[k]));
            }
            return least - piece.radius;
        }

        /** What the line meets first; where it meets nothing, what the turn does. */
        String first(List<Body> bodies, int self, String turnObstacle, PairTest inContact) {
            String first = turnObstacle;
            double earliest = 1;
            for (int k = 0; k < bodies.size(); k++) {
                if (k == self || inContact.test(self, k)) {
                    continue;
                }
                double share = share(bodies.get(k));
                if (share < earliest) {
                    earliest = share;
                    first = bodies.get(k).text;
                }
            }
            return first;
        }

        /** The share of the line at which a body is met, by halving; 1 where it is not. */
        private double share(Body other) {
            if (!meets(other, 1)) {
                return 1;
            }
            double free = 0;
            double met = 1;
            for (int k = 0; k < 40; k++) {
                double middle = (free + met) / 2;
                if (meets(other, middle)) {
                    met = middle;
                } else {
                    free = middle;
                }
            }
            return free;
        }

        private boolean meets(Body other, double share) {
            for (Piece piece : mover.pieces) {
                Piece line = swept(piece, share);
                for (Piece obstacle : other.pieces) {
                    if (ConversationAudit.gap(line, obstacle) <= 0) {
                        return true;
                    }
                }
            }
            return false;
        }

        void carryOut() {
            List<Piece> moved = new ArrayList<>();
            double oldC = mover.c;
            double oldS = mover.s;
            mover.turn(radians);
            // The turn that was made, from the headings, so that the pieces do not drift from them.
            double c = oldC * mover.c + oldS * mover.s;
            double s = oldC * mover.s - oldS * mover.c;
            for (Piece piece : mover.pieces) {
                double[] x = new double[piece.x.length];
                double[] z = new double[piece.x.length];
                for (int k = 0; k < x.length; k++) {
                    double ownX = piece.x[k] - mover.x;
                    double ownZ = piece.z[k] - mover.z;
                    x[k] = turns(piece) ? c * ownX + s * ownZ + (mover.x + dx) : ownX + (mover.x + dx);
                    z[k] = turns(piece) ? -s * ownX + c * ownZ + (mover.z + dz) : ownZ + (mover.z + dz);
                }
                moved.add(new Piece(x, z, piece.radius));
            }
            mover.pieces.clear();
            mover.pieces.addAll(moved);
            mover.x += dx;
            mover.z += dz;
        }
    }

    /** Whether two bodies, by index, have been in contact since the start. */
    private interface PairTest {
        boolean test(int a, int b);
    }

    /** A beam on the floor: all points within an angle of a direction. */
    private static final class Sector {
        private final double x;
        private final double z;
        private final double ux;
        private final double uz;
        private final double half;
        private final double cos;
        private final double sin;

        Sector(double x, double z, double ux, double uz, double half) {
            this.x = x;
            this.z = z;
            this.ux = ux;
            this.uz = uz;
            this.half = half;
            this.cos = StrictMath.cos(half);
            this.sin = StrictMath.sin(half);
        }

        /** This beam turned, narrowed, widened and moved by a little. */
        List<Sector> disturbed(double angle, double offset) {
            List<Sector> sectors = new ArrayList<>();
            for (double turn = -angle; turn <= angle; turn += angle) {
                double c = StrictMath.cos(turn);
                double s = StrictMath.sin(turn);
                for (double grow = -angle; grow <= angle; grow += angle) {
                    for (double aside = -offset; aside <= offset; aside += offset) {
                        double width = half == 0 ? 0 : Math.max(0, half + grow);
                        double dx = c * ux + s * uz;
                        double dz = -s * ux + c * uz;
                        sectors.add(new Sector(x - aside * uz, z + aside * ux, dx, dz, width));
                    }
                }
            }
            return sectors;
        }

        /** The nearest point of a piece within this beam; infinite where there is none. */
        double distance(Piece piece) {
            if (piece.x.length == 1) {
                return disc(piece.x[0] - x, piece.z[0] - z, piece.radius);
            }
            int n = piece.x.length;
            double nearest = Double.POSITIVE_INFINITY;
            boolean inside = n > 2;
            for (int k = 0; k < n; k++) {
                int next = (k + 1) % n;
                double ax = piece.x[k] - x;
                double az = piece.z[k] - z;
                double bx = piece.x[next] - x;
                double bz = piece.z[next] - z;
                inside &= ax * bz - az * bx >= 0;
                nearest = Math.min(nearest, edge(ax, az, bx, bz));
            }
            return inside ? 0 : nearest;
        }

        private double disc(double mx, double mz, double radius) {
            double distance = Math.hypot(mx, mz);
            if (distance <= radius) {
                return 0;
            }
            double ahead = mx * ux + mz * uz;
            double aside = mx * uz - mz * ux;
            if (half > 0 && StrictMath.atan2(Math.abs(aside), ahead) <= half) {
                return distance - radius;
            }
            // Its nearest point is outside the beam: then a side of the beam meets it first.
            return Math.min(
                    chord(mx, mz, radius, cos * ux + sin * uz, -sin * ux + cos * uz),
                    chord(mx, mz, radius, cos * ux - sin * uz, sin * ux + cos * uz));
        }

        private static double chord(double mx, double mz, double radius, double dx, double dz) {
            double ahead = mx * dx + mz * dz;
            double aside = Math.abs(mx * dz - mz * dx);
            if (ahead < 0 || aside > radius) {
                return Double.POSITIVE_INFINITY;
            }
            return ahead - Math.sqrt((radius - aside) * (radius + aside));
        }

        /** The nearest point of a segment within this beam, whose start is the origin here. */
        private double edge(double ax, double az, double bx, double bz) {
            double best = Math.min(
                    crossing(ax, az, bx, bz, cos * ux + sin * uz, -sin * ux + cos * uz),
                    crossing(ax, az, bx, bz, cos * ux - sin * uz, sin * ux + cos * uz));
            best = Math.min(best, Math.min(corner(ax, az), corner(bx, bz)));
            double ex = bx - ax;
            double ez = bz - az;
            double square = ex * ex + ez * ez;
            double share = square == 0 ? 0 : -(ax * ex + az * ez) / square;
            return share > 0 && share < 1 ? Math.min(best, corner(ax + share * ex, az + share * ez)) : best;
        }

        /** The distance of a point within this beam; infinite for one outside. */
        private double corner(double px, double pz) {
            double ahead = px * ux + pz * uz;
            double aside = Math.abs(px * uz - pz * ux);
            boolean within = aside == 0 ? ahead >= 0 : StrictMath.atan2(aside, ahead) <= half;
            return within ? Math.hypot(px, pz) : Double.POSITIVE_INFINITY;
        }

        private static double crossing(double ax, double az, double bx, double bz, double dx, double dz) {
            double fromA = dx * az - dz * ax;
            double fromB = dx * bz - dz * bx;
            if ((fromA > 0 && fromB > 0) || (fromA < 0 && fromB < 0) || fromA == fromB) {
                return Double.POSITIVE_INFINITY;
            }
            double share = fromA / (fromA - fromB);
            double px = ax + share * (bx - ax);
            double pz = az + share * (bz - az);
            double ahead = px * dx + pz * dz;
            return ahead < 0 ? Double.POSITIVE_INFINITY : ahead;
        }
    }
}
