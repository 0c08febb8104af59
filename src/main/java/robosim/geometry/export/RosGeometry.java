package robosim.geometry.export;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.Frame;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Quaternion;

/** Places and shapes in the axes of ROS, as values of its messages: X as here, Y along our -Z, Z up. */
final class RosGeometry {
    /** No displacement and no rotation. */
    static final List<?> IDENTITY = List.of(List.of(0.0, 0.0, 0.0), List.of(0.0, 0.0, 0.0, 1.0));

    /** From a sensor that faces X to a camera's frame, in which X is right, Y down and Z forward. */
    static final List<?> OPTICAL = List.of(List.of(0.0, 0.0, 0.0), List.of(-0.5, 0.5, -0.5, 0.5));

    private static final Frame ROS = Frame.ros();

    /** What a name of ROS may not contain. */
    private static final Pattern OTHER = Pattern.compile("[^A-Za-z0-9_]+");

    /** What has no material of its own. */
    private static final Material PLAIN = Material.of(Color.parse("#a0a8b0"));

    private RosGeometry() {}

    /**
     * Triangles.
     *
     * @param corners points, three for each triangle
     * @param color   red, green, blue and opacity
     */
    record Triangles(List<List<Double>> corners, List<Double> color) {
        /** These, moved up. */
        Triangles raised(double height) {
            return new Triangles(
                    corners.stream()
                            .map(p -> List.of(p.get(0), p.get(1), p.get(2) + height))
                            .toList(),
                    color);
        }
    }

    /** An object's triangles in the world. */
    static Triangles placed(GeometryObject object) {
        return of(object, object.pose());
    }

    /** An object's triangles in its own frame. */
    static Triangles own(GeometryObject object) {
        return of(object, Pose.ORIGIN);
    }

    /** How high an object's centre is above the lowest point that it has when it stands upright. */
    static double rise(GeometryObject object) {
        return 0 - object.at(Pose.ORIGIN).bounds().minY();
    }

    private static Triangles of(GeometryObject object, Pose pose) {
        List<List<Double>> corners = new ArrayList<>();
        add(object, pose, corners);
        Color color = object.material().within(PLAIN).color();
        return new Triangles(corners, List.of(color.red(), color.green(), color.blue(), 1.0));
    }

    private static void add(GeometryObject object, Pose pose, List<List<Double>> corners) {
        if (object instanceof ObjectGroup group) {
            group.members().forEach(member -> add(member, member.pose().within(pose), corners));
            return;
        }
        GlbShape shape = GlbShape.of(object);
        float[] points = shape.points();
        for (int index : shape.indices()) {
            corners.add(point(inWorld(pose, points[3 * index], points[3 * index + 1], points[3 * index + 2])));
        }
    }

    private static Point inWorld(Pose pose, double x, double y, double z) {
        Point c = pose.center();
        double[] r = pose.rotation();
        return new Point(
                c.x() + r[0] * x + r[1] * y + r[2] * z,
                c.y() + r[3] * x + r[4] * y + r[5] * z,
                c.z() + r[6] * x + r[7] * y + r[8] * z);
    }

    /** A point or a displacement. */
    static List<Double> point(Point p) {
        Point there = ROS.vector(p);
        return List.of(there.x(), there.y(), there.z());
    }

    /** A pose, which is also how a transform has its numbers. */
    static List<?> pose(Pose pose) {
        Quaternion q = ROS.pose(pose).orientation();
        return List.of(point(pose.center()), List.of(q.x(), q.y(), q.z(), q.w()));
    }

    /** A pose that is lower along its own vertical. */
    static Pose below(Pose pose, double height) {
        return pose.movedTo(inWorld(pose, 0, 0 - height, 0));
    }

    /** The corner of a map's first cell, on the floor: that of the grid's last row. */
    static List<?> gridOrigin(GridObject grid) {
        double x = -grid.columns() * grid.cell() / 2;
        double z = grid.rows() * grid.cell() / 2;
        Pose corner = grid.pose();
        return pose(corner.movedTo(inWorld(corner, x, 0 - grid.height() / 2, z)));
    }

    /** A name of ROS for an object. */
    static String text(String name) {
        String clean = OTHER.matcher(name).replaceAll("_");
        return clean.isEmpty() || Character.isDigit(clean.charAt(0)) ? "_" + clean : clean;
    }
}
