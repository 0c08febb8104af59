package robosim.geometry.cases;

import java.math.BigDecimal;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.Kind;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Gaps;
import robosim.geometry.reference.Reference;

/** What is true of the stored numbers, from the exact reference; never from the module. */
final class Truth {
    /** How exactly the share of a turn is worked out. */
    static final double TURN = 0x1p-20;

    private Truth() {}

    /** The distance in a beam without limits: null where it misses. */
    static @Nullable BigDecimal beam(Ray ray, double width, List<GeometryObject> objects, Dimension dimension) {
        BigDecimal nearest = null;
        for (GeometryObject object : objects) {
            BigDecimal distance =
                    width == 0 ? Reference.distance(ray, object, dimension) : cone(ray, object, dimension);
            if (distance != null && (nearest == null || distance.compareTo(nearest) < 0)) {
                nearest = distance;
            }
        }
        return nearest;
    }

    /** Cases ask for cones that hold the nearest point of each object that they reach. */
    private static BigDecimal cone(Ray ray, GeometryObject object, Dimension dimension) {
        return Gaps.distance(new SphereObject(ray.start(), 0), object, dimension);
    }

    /** A bracket of the share of a turn about the vertical that is free; null where all of it is. */
    static double @Nullable [] turn(
            GeometryObject mover, double degrees, List<GeometryObject> others, Dimension dimension) {
        double radius = 0;
        for (double half : reach(mover)) {
            radius += half * half;
        }
        return turn(mover, degrees, others, dimension, Math.sqrt(radius) * 1.001, 0, 1);
    }

    /** No point of the mover goes farther in half a range than that part of the circle it is on. */
    private static double @Nullable [] turn(
            GeometryObject mover,
            double degrees,
            List<GeometryObject> others,
            Dimension dimension,
            double radius,
            double from,
            double to) {
        double middle = (from + to) / 2;
        GeometryObject there = mover.turned(0, middle * degrees);
        double gap = Double.POSITIVE_INFINITY;
        for (GeometryObject other : others) {
            gap = Math.min(gap, Gaps.distance(there, other, dimension).doubleValue());
        }
        double farthest = radius * Math.toRadians(Math.abs(degrees)) * (to - from) / 2;
        if (gap > farthest * 1.001) {
            return null;
        }
        if (to - from < TURN) {
            return new double[] {from, to};
        }
        double[] first = turn(mover, degrees, others, dimension, radius, from, middle);
        return first != null ? first : turn(mover, degrees, others, dimension, radius, middle, to);
    }

    private static double[] reach(GeometryObject object) {
        return switch (object.kind()) {
            case BOX -> {
                var box = (robosim.geometry.model.BoxObject) object;
                yield new double[] {box.width() / 2, box.height() / 2, box.length() / 2};
            }
            case CYLINDER -> new double[] {((robosim.geometry.model.CylinderObject) object).radius()};
            case SPHERE -> new double[] {((SphereObject) object).radius()};
            case CAPSULE ->
                throw new IllegalArgumentException("a turn of a capsule is not known (got: " + object + ")");
            case MESH -> {
                double most = 0;
                for (Point p : ((robosim.geometry.model.MeshObject) object).vertices()) {
                    most = Math.max(most, 2 * Math.max(Math.abs(p.x()), Math.max(Math.abs(p.y()), Math.abs(p.z()))));
                }
                yield new double[] {most};
            }
            case GROUP, GRID -> throw new IllegalArgumentException("a turn of this is not known (got: " + object + ")");
        };
    }

    /** The greatest coordinate that an object reaches, more or less: what a rounding is measured by. */
    static double size(GeometryObject object) {
        double own = object.kind() == Kind.GROUP
                ? ((robosim.geometry.model.ObjectGroup) object)
                        .members().stream().mapToDouble(Truth::size).max().orElse(0)
                : 0;
        for (double half : object.kind() == Kind.GROUP ? new double[0] : reach(object)) {
            own = Math.max(own, half);
        }
        Point c = object.center();
        return own + Math.max(Math.abs(c.x()), Math.max(Math.abs(c.y()), Math.abs(c.z())));
    }
}
