import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import robosim.geometry.Avoidance;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Twist;
import robosim.geometry.world.WorldReader;

/**
 * RRT-Connect (Kuffner and LaValle 2000) for a car that drives arcs on a ROS map, and for a drone in the warehouse. Each
 * edge is a drive with a constant twist, swept with a margin; the car's come in pairs of arcs, of which one passes into the
 * other. Draws both paths as seen from above.
 *
 * <pre>
 * java -cp target/classes examples/Planner.java
 * java -cp target/classes:snakeyaml-engine.jar examples/Planner.java FOLDER SEED MAP.yaml
 * </pre>
 */
public final class Planner {
    private static final double MARGIN = 0.1;
    private static final double STEP = 1.5;
    private static final double TURNING_RADIUS = 0.7;

    private record Leg(Twist twist, double seconds) {}

    private record Node(Pose pose, Node parent, Leg leg) {}

    private final Snapshot world;
    private final String robot;
    private final boolean isCar;
    private final Avoidance avoid;
    private final SplittableRandom random;
    private int edges;

    private Planner(Geometry world, String robot, boolean isCar, Avoidance avoid, long seed) {
        this.world = world.snapshot();
        this.robot = robot;
        this.isCar = isCar;
        this.avoid = avoid;
        random = new SplittableRandom(seed);
    }

    /** Plans for both robots and writes {@code car.svg} and {@code drone.svg}. */
    public static void main(String[] args) throws Exception {
        Path folder = args.length > 0 ? Path.of(args[0]) : Files.createTempDirectory("planner");
        long seed = args.length > 1 ? Long.parseLong(args[1]) : 1;
        Geometry map = args.length > 2 ? WorldReader.read(Path.of(args[2])).toGeometry() : flat();
        map.addObjectUnchecked(new BoxObject(new Point(-5, 0, -3), 0.8, 0.5, 0.45).moveable("car"));
        Planner car = new Planner(map, "car", true, Avoidance.margin(MARGIN), seed);
        car.report(folder, Pose.of(new Point(-5, 0, -3), 0), Pose.of(new Point(5, 0, 3), -90));

        Geometry hall = WorldReader.read(Path.of("worlds/warehouse.xml")).toGeometry();
        hall.addObjectUnchecked(new BoxObject(new Point(-38, 1, -24), 0.6, 0.3, 0.6).moveable("drone"));
        Planner drone = new Planner(hall, "drone", false, Avoidance.margin(MARGIN), seed);
        drone.report(folder, Pose.of(new Point(-38, 1, -24), 0), Pose.of(new Point(36, -1, 22), 0));
    }

    private void report(Path folder, Pose from, Pose to) throws IOException {
        long start = System.nanoTime();
        List<Pose> path = plan(from, to);
        double millis = (System.nanoTime() - start) * 1e-6;
        Path picture = folder.resolve(robot + ".svg");
        Files.writeString(picture, svg(path), StandardCharsets.UTF_8);
        System.out.printf(
                Locale.ROOT,
                "%s: %d poses, %d drives swept in %.0f ms, %s%n",
                robot,
                path.size(),
                edges,
                millis,
                picture);
    }

    /** Two trees: each in turn grows towards a random pose, and the other tries to reach what was added. */
    private List<Pose> plan(Pose from, Pose to) {
        List<Node> ahead = new ArrayList<>(List.of(new Node(from, null, null)));
        List<Node> back = new ArrayList<>(List.of(new Node(to, null, null)));
        for (int n = 0; n < 10_000; n++) {
            boolean isAhead = n % 2 == 0;
            List<Node> tree = isAhead ? ahead : back;
            Pose sample = sample();
            Node near = nearest(tree, sample, isAhead ? 1 : -1);
            Node added = near == null ? null : extend(tree, near, sample, isAhead ? 1 : -1);
            Node met = added == null ? null : connect(isAhead ? back : ahead, added.pose, isAhead ? -1 : 1);
            if (met != null) {
                List<Pose> path = new ArrayList<>(way(isAhead ? added : met));
                Collections.reverse(path);
                path.addAll(way(isAhead ? met : added));
                return path;
            }
        }
        throw new IllegalStateException("no path found for " + robot + " (got: none in 10,000 rounds)");
    }

    private Pose sample() {
        double x = random.nextDouble(-0.5, 0.5) * world.width();
        double y = isCar ? 0 : random.nextDouble(-0.5, 0.5) * world.height();
        double z = random.nextDouble(-0.5, 0.5) * world.length();
        return Pose.of(new Point(x, y, z), isCar ? random.nextDouble(-180, 180) : 0);
    }

    /** Goes on towards a pose until something blocks; null where it is not reached. */
    private Node connect(List<Node> tree, Pose target, int sign) {
        Node node = nearest(tree, target, sign);
        while (node != null && distance(node.pose, target) > 1e-6) {
            node = extend(tree, node, target, sign);
        }
        return node;
    }

    /** The node with the shortest drive to a pose; null where none has any. */
    private Node nearest(List<Node> tree, Pose target, int sign) {
        Node nearest = null;
        double least = Double.POSITIVE_INFINITY;
        for (Node each : tree) {
            List<Leg> legs = legs(each.pose, target, sign);
            double length = legs.stream().mapToDouble(Leg::seconds).sum();
            if (!legs.isEmpty() && length < least) {
                nearest = each;
                least = length;
            }
        }
        return nearest;
    }

    private List<Leg> legs(Pose from, Pose to, int sign) {
        return isCar ? arcs(from, to, sign) : straight(from, to);
    }

    /** Adds the farthest free pose from a node towards a target, at most a step away; null where there is none. */
    private Node extend(List<Node> tree, Node from, Pose target, int sign) {
        Node node = from;
        double left = STEP;
        Node last = null;
        for (Leg leg : legs(from.pose, target, sign)) {
            double seconds = Math.min(left, leg.seconds);
            double free = seconds * free(node.pose, leg.twist, seconds);
            if (free < Math.min(seconds, 0.2)) {
                break;
            }
            free = free < seconds ? 0.9 * free : seconds;
            node = new Node(leg.twist.after(node.pose, free), node, new Leg(leg.twist, free));
            last = node;
            left -= free;
            if (free < leg.seconds || left <= 0) {
                break;
            }
        }
        if (last != null) {
            tree.add(last);
        }
        return last;
    }

    private double free(Pose at, Twist twist, double seconds) {
        Point c = at.center();
        double[] drive = {c.x(), c.y(), c.z(), at.heading(), twist.x(), twist.y(), twist.z(), twist.ry(), seconds};
        double[] fraction = new double[1];
        edges++;
        world.driveFractions(robot, drive, avoid, fraction);
        return fraction[0];
    }

    private static List<Leg> straight(Pose from, Pose to) {
        Point a = from.center();
        Point b = to.center();
        double length = distance(from, to);
        return length == 0
                ? List.of()
                : List.of(new Leg(
                        new Twist((b.x() - a.x()) / length, (b.y() - a.y()) / length, (b.z() - a.z()) / length, 0),
                        length));
    }

    /** Two arcs with a common tangent where they meet, from one pose to another (a biarc); none if they are too tight. */
    private static List<Leg> arcs(Pose from, Pose to, int sign) {
        double[] p = {from.center().x(), -from.center().z()};
        double[] q = {to.center().x(), -to.center().z()};
        double[] t = tangent(from, sign);
        double[] u = tangent(to, sign);
        double[] v = {q[0] - p[0], q[1] - p[1]};
        double along = v[0] * (t[0] + u[0]) + v[1] * (t[1] + u[1]);
        double open = 2 * (1 - t[0] * u[0] - t[1] * u[1]);
        double square = v[0] * v[0] + v[1] * v[1];
        double d = open > 1e-9 ? (Math.sqrt(along * along + open * square) - along) / open : square / (2 * along);
        double[] middle = {(p[0] + q[0] + d * (t[0] - u[0])) / 2, (p[1] + q[1] + d * (t[1] - u[1])) / 2};
        Leg first = arc(p, t, middle, sign);
        double angle = Math.toRadians(sign * first.twist.ry() * first.seconds * sign);
        double[] turned = {
            t[0] * Math.cos(angle) - t[1] * Math.sin(angle), t[0] * Math.sin(angle) + t[1] * Math.cos(angle)
        };
        Leg second = arc(middle, turned, q, sign);
        double tightest = Math.toDegrees(1 / TURNING_RADIUS);
        boolean isDriven = d > 0
                && Math.abs(first.twist.ry()) <= tightest
                && Math.abs(second.twist.ry()) <= tightest
                && first.seconds + second.seconds < 4 * STEP + 2 * Math.sqrt(square);
        return isDriven ? List.of(first, second) : List.of();
    }

    private static double[] tangent(Pose pose, int sign) {
        double angle = Math.toRadians(pose.heading());
        return new double[] {sign * Math.cos(angle), sign * Math.sin(angle)};
    }

    /** The arc at 1 m/s from a point with a tangent to another point. */
    private static Leg arc(double[] p, double[] t, double[] q, int sign) {
        double x = q[0] - p[0];
        double y = q[1] - p[1];
        double half = Math.atan2(t[0] * y - t[1] * x, t[0] * x + t[1] * y);
        double chord = Math.sqrt(x * x + y * y);
        double length = Math.abs(half) < 1e-9 ? chord : chord * half / Math.sin(half);
        return new Leg(Twist.drive(sign, Math.toDegrees(2 * half) / Math.max(length, 1e-12)), length);
    }

    private static double distance(Pose a, Pose b) {
        double turn = Math.toRadians(Math.IEEEremainder(a.heading() - b.heading(), 360));
        double x = a.center().x() - b.center().x();
        double y = a.center().y() - b.center().y();
        double z = a.center().z() - b.center().z();
        return Math.sqrt(x * x + y * y + z * z + turn * turn);
    }

    /** Poses from a node to the root of its tree, some on each leg. */
    private static List<Pose> way(Node leaf) {
        List<Pose> way = new ArrayList<>();
        for (Node node = leaf; node.parent != null; node = node.parent) {
            for (int k = 10; k > 0; k--) {
                way.add(node.leg.twist.after(node.parent.pose, node.leg.seconds * k / 10));
            }
        }
        return way;
    }

    /** The objects as seen from above, and the robot along its path. */
    private String svg(List<Pose> path) {
        StringBuilder out = new StringBuilder(String.format(
                Locale.ROOT,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"%s %s %s %s\" width=\"900\">%n",
                -world.width() / 2,
                -world.length() / 2,
                world.width(),
                world.length()));
        for (GeometryObject object : world.objects()) {
            if (object instanceof GridObject grid) {
                grid.occupied().stream()
                        .mapToObj(cell -> grid.box(cell % grid.columns(), cell / grid.columns()))
                        .forEach(box -> out.append(rectangle(box, "#555")));
            } else if (!robot.equals(object.name())) {
                boolean isFloor = object.bounds().maxX() - object.bounds().minX() > 0.9 * world.width();
                out.append(isFloor ? "" : rectangle(object, object instanceof CylinderObject ? "#777" : "#aaa"));
            }
        }
        GeometryObject shape = world.toGeometry().getObject(robot);
        for (Pose pose : path) {
            out.append(rectangle(shape.at(pose), "#d4580066"));
        }
        return out.append("</svg>\n").toString();
    }

    private static String rectangle(GeometryObject object, String color) {
        double turn = -object.heading();
        GeometryObject level = object instanceof BoxObject ? object.at(Pose.of(object.center(), 0)) : object;
        return String.format(
                Locale.ROOT,
                "<rect x=\"%.3f\" y=\"%.3f\" width=\"%.3f\" height=\"%.3f\" fill=\"%s\" transform=\"rotate(%.2f %.3f %.3f)\"/>%n",
                level.bounds().minX(),
                level.bounds().minZ(),
                level.bounds().maxX() - level.bounds().minX(),
                level.bounds().maxZ() - level.bounds().minZ(),
                color,
                level == object ? 0 : turn,
                object.center().x(),
                object.center().z());
    }

    /** A flat of three rooms, as it is read from a ROS map: a world that ends where the image does, and a grid of its cells. */
    private static Geometry flat() {
        BitSet walls = new BitSet();
        for (int cell = 0; cell < 240 * 160; cell++) {
            int column = cell % 240;
            int row = cell / 240;
            boolean isWall = row < 4 || row > 155 || column < 4 || column > 235;
            isWall |= column / 4 == 20 && (row < 90 || row > 130);
            isWall |= column / 4 == 40 && (row < 25 || row > 65);
            isWall |= (column - 120) * (column - 120) + (row - 50) * (row - 50) < 200;
            walls.set(cell, isWall);
        }
        Geometry world = new Geometry(12.1, 2, 8.1, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new GridObject(new Point(), 0.05, 2, 240, 160, walls).named("map"));
        return world;
    }
}
