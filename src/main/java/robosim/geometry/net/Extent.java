package robosim.geometry.net;

import java.util.List;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.TriangleMesh;

/**
 * How far objects extend from the origin along each axis. Never too small, as the added margin exceeds any rounding.
 */
final class Extent {
    /**
     * The margin beyond the farthest object, as a fraction of its distance; and the smallest margin, in world units.
     */
    private static final double ROOM = 0.25;

    private static final double LEAST_ROOM = 1;
    private static final double MOST = 0x1p101;

    private final double[] reach = new double[3];

    private Extent() {}

    /**
     * Width, height and length of a world, centred at the origin, that holds all objects with a margin: a quarter of
     * the distance of the farthest one, at least 1 world unit.
     */
    static double[] worldFor(List<GeometryObject> objects) {
        Extent extent = new Extent();
        double[] frame = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        for (GeometryObject object : objects) {
            extent.include(object, frame, new double[3]);
        }
        double[] sizes = new double[3];
        double room =
                Math.max(LEAST_ROOM, ROOM * Math.max(extent.reach[0], Math.max(extent.reach[1], extent.reach[2])));
        for (int k = 0; k < 3; k++) {
            sizes[k] = Math.min(MOST, 2 * (extent.reach[k] + room));
        }
        return sizes;
    }

    /** Includes an object whose pose is relative to a frame, given by its rotation and origin in the world. */
    private void include(GeometryObject object, double[] frame, double[] origin) {
        double[] rotation = product(frame, object.rotation());
        double[] place = placed(
                frame, object.center().x(), object.center().y(), object.center().z(), origin);
        switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                around(place, rotation, box.width() / 2, box.height() / 2, box.length() / 2);
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                disc(place, rotation, cylinder.radius(), cylinder.height() / 2);
            }
            case SPHERE -> ball(place, ((SphereObject) object).radius());
            case MESH -> {
                TriangleMesh mesh = ((MeshObject) object).triangles();
                for (int v = 0; v < mesh.vertices(); v++) {
                    double[] corner = placed(
                            rotation, mesh.coordinate(v, 0), mesh.coordinate(v, 1), mesh.coordinate(v, 2), place);
                    ball(corner, 0);
                }
            }
            case GROUP -> {
                for (GeometryObject member : ((ObjectGroup) object).members()) {
                    include(member, rotation, place);
                }
            }
        }
    }

    private void around(double[] place, double[] rotation, double x, double y, double z) {
        for (int k = 0; k < 3; k++) {
            double half = Math.abs(rotation[3 * k]) * x
                    + Math.abs(rotation[3 * k + 1]) * y
                    + Math.abs(rotation[3 * k + 2]) * z;
            reach[k] = Math.max(reach[k], Math.abs(place[k]) + half);
        }
    }

    /** Includes a cylinder about its own Y. */
    private void disc(double[] place, double[] rotation, double radius, double halfHeight) {
        for (int k = 0; k < 3; k++) {
            double along = Math.min(1, Math.abs(rotation[3 * k + 1]));
            double half = along * halfHeight + Math.sqrt((1 - along) * (1 + along)) * radius;
            reach[k] = Math.max(reach[k], Math.abs(place[k]) + half);
        }
    }

    private void ball(double[] place, double radius) {
        for (int k = 0; k < 3; k++) {
            reach[k] = Math.max(reach[k], Math.abs(place[k]) + radius);
        }
    }

    private static double[] placed(double[] rotation, double x, double y, double z, double[] origin) {
        double[] placed = new double[3];
        for (int k = 0; k < 3; k++) {
            placed[k] = rotation[3 * k] * x + rotation[3 * k + 1] * y + rotation[3 * k + 2] * z + origin[k];
        }
        return placed;
    }

    private static double[] product(double[] a, double[] b) {
        double[] product = new double[9];
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                product[3 * row + column] =
                        a[3 * row] * b[column] + a[3 * row + 1] * b[column + 3] + a[3 * row + 2] * b[column + 6];
            }
        }
        return product;
    }
}
