import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.WorldReader;

/**
 * A robot finds its way out of a maze that it does not know. All that it does is to listen around it, to turn by quarter
 * turns and to drive from cell to cell; it keeps a thread behind it, and where it finds only cells that it has been in, it goes
 * back along the thread (Tremaux). What it found is then checked without the module, wall by wall, and drawn.
 *
 * <pre>
 * java -cp target/classes examples/MazeSolver.java
 * java -cp target/classes examples/MazeSolver.java ROBOT PICTURE.svg
 * </pre>
 */
public final class MazeSolver {
    private static final Path MAZE = Path.of("worlds/maze.xml");
    private static final double CELL = 2; // metres from the middle of a cell to that of the next

    private final Geometry geometry;
    private final String robot;
    private final double halfWidth; // of the maze; the world goes on around it
    private final double halfLength;
    private final double reach; // from the robot's centre to its outermost point
    private final List<Point> way = new ArrayList<>(); // every cell that it came to, in order
    private final Deque<Point> thread = new ArrayDeque<>(); // from the start to where it is, without dead ends
    private int turns;
    private int echoes;

    private MazeSolver(Geometry geometry, String robot, double halfWidth, double halfLength) {
        this.geometry = geometry;
        this.robot = robot;
        this.halfWidth = halfWidth;
        this.halfLength = halfLength;
        this.reach = reach(geometry.getObject(robot));
    }

    /** Solves, checks, draws; ends with exit code 1 where the robot does not come out. */
    public static void main(String[] args) throws IOException {
        String robot = args.length > 0 ? args[0] : "mouse 3";
        Path picture = Path.of(args.length > 1 ? args[1] : "target/maze-solver.svg");
        Geometry geometry = WorldReader.read(MAZE).toGeometry();
        MazeSolver solver = new MazeSolver(geometry, robot, 20, 15);
        boolean out = solver.run();

        List<Point> found = new ArrayList<>(solver.thread);
        double room = leastRoom(geometry, solver.reach, solver.way);
        System.out.printf(
                Locale.ROOT,
                "%s %s after %d drives of %.0f m, %d turns and %d echoes; the way that it found has %d drives%n",
                robot,
                out ? "left the maze at " + text(found.get(found.size() - 1)) : "found no way out",
                solver.way.size() - 1,
                CELL,
                solver.turns,
                solver.echoes,
                found.size() - 1);
        System.out.printf(Locale.ROOT, "checked: it never came nearer than %.3f m to a wall%n", room);
        Path folder = picture.toAbsolutePath().getParent();
        if (folder != null) {
            Files.createDirectories(folder);
        }
        Files.writeString(picture, solver.svg(found));
        System.out.println("picture: " + picture);
        if (!out || room <= 0) {
            System.exit(1);
        }
    }

    private boolean run() {
        Set<Point> seen = new HashSet<>();
        face(90 * Math.rint(geometry.getObject(robot).heading() / 90));
        way.add(here());
        arrive(seen);
        while (!isOut() && !thread.isEmpty()) {
            if (!explore(seen)) {
                thread.removeLast(); // a dead end
                if (!thread.isEmpty()) {
                    face(heading(here(), thread.getLast()));
                    drive();
                }
            }
        }
        return isOut();
    }

    /** Right, ahead, left, back: the first way that is free and leads to a cell that it has not been in. */
    private boolean explore(Set<Point> seen) {
        double forward = geometry.getObject(robot).heading();
        for (double turn : new double[] {-90, 0, 90, 180}) {
            Point next = neighbour(forward + turn);
            if (!seen.contains(next) && isFree(turn)) {
                face(forward + turn);
                drive();
                arrive(seen);
                return true;
            }
        }
        return false;
    }

    /** Whether nothing echoes in a direction as far as it will reach when it stands in the next cell. */
    private boolean isFree(double direction) {
        echoes++;
        double angle = Math.toRadians(direction);
        double x = Math.round(Math.cos(angle)); // in its own frame: x is ahead, z to its right
        double z = -Math.round(Math.sin(angle));
        return Double.isInfinite(geometry.getSonarDistance(robot, x, z, 0, CELL + reach, 20));
    }

    private void arrive(Set<Point> seen) {
        seen.add(here());
        thread.addLast(here());
    }

    private void drive() {
        if (!geometry.simpleMove(robot, CELL, 0, 0)) {
            throw new IllegalStateException("the way that looked free is blocked at " + text(here()));
        }
        way.add(here());
    }

    private void face(double degrees) {
        double turn = Math.IEEEremainder(degrees - geometry.getObject(robot).heading(), 360);
        if (turn != 0) {
            turns++;
            geometry.simpleTurn(robot, turn);
        }
    }

    /** Quarter turns and drives of 2 are exact: the middle of a cell is the same point each time. */
    private Point here() {
        return geometry.getObject(robot).center();
    }

    private Point neighbour(double heading) {
        double angle = Math.toRadians(heading);
        Point at = here();
        return new Point(
                at.x() + CELL * Math.round(Math.cos(angle)), at.y(), at.z() - CELL * Math.round(Math.sin(angle)));
    }

    private static double reach(GeometryObject robot) {
        return robot instanceof CylinderObject cylinder
                ? cylinder.radius()
                : robot instanceof BoxObject box ? Math.hypot(box.width(), box.length()) / 2 : 1;
    }

    private static double heading(Point from, Point to) {
        return Math.toDegrees(Math.atan2(-(to.z() - from.z()), to.x() - from.x()));
    }

    private boolean isOut() {
        return Math.abs(here().x()) > halfWidth || Math.abs(here().z()) > halfLength;
    }

    /**
     * How near the robot came to any wall, whichever way it looked, computed anew from the numbers of the walls alone: all of them stand
     * along the axes, and so do the legs of the way. At most 0 where it went through one.
     */
    private static double leastRoom(Geometry geometry, double reach, List<Point> way) {
        double least = Double.POSITIVE_INFINITY;
        for (GeometryObject object : geometry.objects()) {
            if (object.isMoveable() || !(object instanceof BoxObject wall)) {
                continue;
            }
            for (int k = 1; k < way.size(); k++) {
                Point a = way.get(k - 1);
                Point b = way.get(k);
                double dx = gap(a.x(), b.x(), wall.center().x(), wall.width() / 2);
                double dz = gap(a.z(), b.z(), wall.center().z(), wall.length() / 2);
                least = Math.min(least, Math.hypot(dx, dz) - reach);
            }
        }
        return least;
    }

    /** Between the interval from a to b and the one of that middle and half size. */
    private static double gap(double a, double b, double middle, double half) {
        return Math.max(0, Math.max(Math.min(a, b) - (middle + half), (middle - half) - Math.max(a, b)));
    }

    private String svg(List<Point> found) {
        StringBuilder svg = new StringBuilder();
        svg.append(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"880\" height=\"680\" viewBox=\"-22 -17 44 34\">\n");
        svg.append("<rect x=\"-22\" y=\"-17\" width=\"44\" height=\"34\" fill=\"#fbfaf6\"/>\n<g fill=\"#4d5966\">\n");
        for (GeometryObject object : geometry.objects()) {
            if (object instanceof BoxObject wall && !wall.isMoveable()) {
                svg.append(format(
                        "<rect x=\"%.3f\" y=\"%.3f\" width=\"%.3f\" height=\"%.3f\"/>%n",
                        wall.center().x() - wall.width() / 2,
                        wall.center().z() - wall.length() / 2,
                        wall.width(),
                        wall.length()));
            }
        }
        svg.append("</g>\n<g fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n");
        svg.append(line(way, "#9cc3df", 0.3));
        svg.append(line(found, "#1d5c8f", 0.16));
        svg.append("</g>\n");
        Point start = way.get(0);
        Point end = here();
        svg.append(format("<circle cx=\"%.3f\" cy=\"%.3f\" r=\"0.35\" fill=\"#e08a1e\"/>%n", start.x(), start.z()));
        svg.append(format("<circle cx=\"%.3f\" cy=\"%.3f\" r=\"0.35\" fill=\"#2e7d4f\"/>%n", end.x(), end.z()));
        return svg.append("</svg>\n").toString();
    }

    private static String line(List<Point> points, String colour, double width) {
        StringBuilder line = new StringBuilder("<polyline points=\"");
        for (Point point : points) {
            line.append(format("%.3f,%.3f ", point.x(), point.z()));
        }
        return line.append(format("\" stroke=\"%s\" stroke-width=\"%.2f\"/>%n", colour, width))
                .toString();
    }

    private static String text(Point point) {
        return format("(%.1f, %.1f)", point.x(), point.z());
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
