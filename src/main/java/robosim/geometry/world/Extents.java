package robosim.geometry.world;

import java.util.List;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;

/** The extents of objects along the world's axes, to within rounding. */
public final class Extents {
    private final double[] least = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    private final double[] most = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};

    private Extents() {}

    /** The extents of all objects of a world. */
    public static Extents of(List<WorldObject> objects) {
        Checks.present("objects", objects);
        Extents extents = new Extents();
        for (WorldObject object : objects) {
            extents.add(object.object(), Placement.NONE);
        }
        return extents;
    }

    /** Whether there are no objects. */
    public boolean isEmpty() {
        return least[0] > most[0];
    }

    /** The minimum along an axis, X (0), Y (1) or Z (2). */
    public double least(int axis) {
        return least[axis];
    }

    /** The maximum along an axis, X (0), Y (1) or Z (2). */
    public double most(int axis) {
        return most[axis];
    }

    /** The largest distance from the origin along an axis, on either side. */
    double farthest(int axis) {
        return isEmpty() ? 0 : Math.max(Math.abs(least[axis]), Math.abs(most[axis]));
    }

    private void add(GeometryObject object, Placement frame) {
        Pose pose = object.pose();
        Placement place = frame.then(Placement.turned(pose.center(), pose.rotation()));
        switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                add(place, box.width() / 2, box.height() / 2, box.length() / 2);
            }
            case CYLINDER -> cylinder(place, (CylinderObject) object);
            case SPHERE -> {
                double radius = ((SphereObject) object).radius();
                add(place.origin(), new Point(radius, radius, radius));
            }
            case MESH -> {
                for (Point vertex : ((MeshObject) object).vertices()) {
                    add(place.apply(vertex), new Point());
                }
            }
            case GROUP -> {
                for (GeometryObject member : ((ObjectGroup) object).members()) {
                    add(member, place);
                }
            }
        }
    }

    private void add(Placement place, double x, double y, double z) {
        Point a = place.direction(x, 0, 0);
        Point b = place.direction(0, y, 0);
        Point c = place.direction(0, 0, z);
        add(
                place.origin(),
                new Point(
                        Math.abs(a.x()) + Math.abs(b.x()) + Math.abs(c.x()),
                        Math.abs(a.y()) + Math.abs(b.y()) + Math.abs(c.y()),
                        Math.abs(a.z()) + Math.abs(b.z()) + Math.abs(c.z())));
    }

    private void cylinder(Placement place, CylinderObject cylinder) {
        Point axis = place.direction(0, 1, 0);
        double half = cylinder.height() / 2;
        double r = cylinder.radius();
        add(place.origin(), new Point(reach(axis.x(), half, r), reach(axis.y(), half, r), reach(axis.z(), half, r)));
    }

    private static double reach(double along, double half, double radius) {
        double share = Math.min(1, Math.abs(along));
        return half * share + radius * Math.sqrt((1 - share) * (1 + share));
    }

    private void add(Point middle, Point reach) {
        add(0, middle.x(), reach.x());
        add(1, middle.y(), reach.y());
        add(2, middle.z(), reach.z());
    }

    private void add(int axis, double middle, double reach) {
        least[axis] = Math.min(least[axis], middle - reach);
        most[axis] = Math.max(most[axis], middle + reach);
    }
}
