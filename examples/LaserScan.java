import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.world.WorldReader;

/**
 * A laser scanner: reads a world file, sends a ray in each direction from one of its robots, and plots what came back, as
 * text and as an SVG picture. It needs nothing but the module and the JDK.
 *
 * <pre>
 * java -cp target/classes examples/LaserScan.java
 * java -cp target/classes examples/LaserScan.java WORLD.xml ROBOT PICTURE.svg
 * </pre>
 */
public final class LaserScan {
    private static final int RAYS = 720;
    private static final double RANGE = 10; // world units
    private static final int COLUMNS = 79;
    private static final int ROWS = 39;

    private LaserScan() {}

    /** Scans and plots. */
    public static void main(String[] args) throws IOException {
        Path file = Path.of(args.length > 0 ? args[0] : "worlds/rooms.xml");
        String name = args.length > 1 ? args[1] : "drum 1";
        Path picture = Path.of(args.length > 2 ? args[2] : "target/laser-scan.svg");

        Geometry geometry = WorldReader.read(file).toGeometry();
        GeometryObject robot = geometry.getObject(name);
        double step = 360.0 / RAYS;
        double[] distances = geometry.scan(name, 0, step, RAYS, 0, RANGE); // +Infinity where nothing echoes

        double nearest = Double.POSITIVE_INFINITY;
        int echoes = 0;
        for (double distance : distances) {
            nearest = Math.min(nearest, distance);
            echoes += Double.isFinite(distance) ? 1 : 0;
        }
        System.out.print(text(robot, distances));
        System.out.printf(
                Locale.ROOT,
                "%d rays from \"%s\", %d echoes within %.1f; the nearest surface is %.3f from its centre%n",
                RAYS,
                name,
                echoes,
                RANGE,
                nearest);

        Path folder = picture.toAbsolutePath().getParent();
        if (folder != null) {
            Files.createDirectories(folder);
        }
        Files.writeString(picture, svg(geometry, robot, distances));
        System.out.println("picture: " + picture);
    }

    /** Where ray k ends: at its echo, or at the end of its range. X is to the right, Z down the page. */
    private static Point end(GeometryObject robot, int k, double distance) {
        double angle = Math.toRadians(robot.heading() + k * 360.0 / RAYS); // counter-clockwise seen from above
        double length = Math.min(distance, RANGE);
        Point from = robot.center();
        return new Point(from.x() + length * Math.cos(angle), from.y(), from.z() - length * Math.sin(angle));
    }

    /** A plan in letters: # where something echoed, a dot where a ray went through, R for the robot. */
    private static String text(GeometryObject robot, double[] distances) {
        char[][] page = new char[ROWS][COLUMNS];
        for (char[] row : page) {
            Arrays.fill(row, ' ');
        }
        for (int k = 0; k < distances.length; k++) {
            for (double d = 0; d < Math.min(distances[k], RANGE); d += 0.05) {
                put(page, robot, end(robot, k, d), '.');
            }
        }
        for (int k = 0; k < distances.length; k++) {
            if (Double.isFinite(distances[k])) {
                put(page, robot, end(robot, k, distances[k]), '#');
            }
        }
        put(page, robot, robot.center(), 'R');
        StringBuilder text = new StringBuilder();
        for (char[] row : page) {
            text.append(new String(row).stripTrailing()).append('\n');
        }
        return text.toString();
    }

    private static void put(char[][] page, GeometryObject robot, Point at, char letter) {
        double x = (at.x() - robot.center().x()) / RANGE; // -1 to 1
        double z = (at.z() - robot.center().z()) / RANGE;
        page[(int) Math.round((z + 1) / 2 * (ROWS - 1))][(int) Math.round((x + 1) / 2 * (COLUMNS - 1))] = letter;
    }

    private static String svg(Geometry geometry, GeometryObject robot, double[] distances) {
        Point at = robot.center();
        double side = 2 * RANGE + 1;
        StringBuilder svg = new StringBuilder();
        svg.append(format(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" height=\"640\" viewBox=\"%.3f %.3f %.3f %.3f\">%n",
                at.x() - side / 2, at.z() - side / 2, side, side));
        svg.append(format(
                "<rect x=\"%.3f\" y=\"%.3f\" width=\"%.3f\" height=\"%.3f\" fill=\"#fbfaf6\"/>%n",
                at.x() - side / 2, at.z() - side / 2, side, side));
        for (GeometryObject object : geometry.objects()) {
            if (!object.equals(robot)) {
                svg.append(outline(object, "#d5d2c8"));
            }
        }
        svg.append("<polygon fill=\"#4a90c2\" fill-opacity=\"0.22\" points=\"");
        for (int k = 0; k < distances.length; k++) {
            Point end = end(robot, k, distances[k]);
            svg.append(format("%.3f,%.3f ", end.x(), end.z()));
        }
        svg.append(format("\"/>%n<g class=\"echoes\" fill=\"#b5361c\">%n"));
        for (int k = 0; k < distances.length; k++) {
            if (Double.isFinite(distances[k])) {
                Point end = end(robot, k, distances[k]);
                svg.append(format("<circle cx=\"%.3f\" cy=\"%.3f\" r=\"0.05\"/>%n", end.x(), end.z()));
            }
        }
        svg.append(format("</g>%n")).append(outline(robot, "#1d5c8f"));
        Point nose = end(robot, 0, 0.6);
        svg.append(format(
                "<path d=\"M%.3f %.3fL%.3f %.3f\" stroke=\"#1d5c8f\" stroke-width=\"0.08\"/>%n</svg>%n",
                at.x(), at.z(), nose.x(), nose.z()));
        return svg.toString();
    }

    /** What an object that stands upright covers of the floor, as far as it is of boxes and cylinders. */
    private static String outline(GeometryObject object, String colour) {
        StringBuilder inside = new StringBuilder();
        if (object instanceof CylinderObject cylinder) {
            inside.append(format("<circle r=\"%.3f\" fill=\"%s\"/>", cylinder.radius(), colour));
        } else if (object instanceof BoxObject box) {
            double w = box.width();
            double l = box.length();
            inside.append(format(
                    "<rect x=\"%.3f\" y=\"%.3f\" width=\"%.3f\" height=\"%.3f\" fill=\"%s\"/>",
                    -w / 2, -l / 2, w, l, colour));
        } else if (object instanceof ObjectGroup group) {
            group.members().forEach(member -> inside.append(outline(member, colour)));
        }
        // SVG turns clockwise on a page whose Y goes down: the other way round than headings.
        return format(
                "<g transform=\"translate(%.3f %.3f) rotate(%.6f)\">%s</g>%n",
                object.center().x(), object.center().z(), -object.heading(), inside);
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
