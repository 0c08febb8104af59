package robosim.geometry.model;

import robosim.geometry.exact.Rotations;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.GeometryObject.RoundedBox;

/**
 * Checks that a bounding volume encloses its object. It compares how far each part extends along the volume's own axes,
 * or from its centre or axis; a turned cylinder inside a cylinder is represented by its enclosing box. What cannot be
 * shown to be enclosed is refused.
 */
final class Enclosing {
    private Enclosing() {}

    /** Refuses a volume that is not a box, cylinder or sphere, or does not enclose the object in its own frame. */
    static void check(GeometryObject volume, GeometryObject object) {
        if (!(volume instanceof BoxObject || volume instanceof CylinderObject || volume instanceof SphereObject)) {
            throw new IllegalArgumentException(
                    "boundingVolume must be a box, a cylinder or a sphere (got: " + volume + ")");
        }
        double[] frame = identity();
        double[] origin = new double[3];
        checkContent(volume, object, frame, origin);
    }

    /**
     * Checks an object whose pose is relative to a frame; {@code frame} is that frame's rotation and {@code origin} its
     * origin in the frame of the volume.
     */
    private static void check(GeometryObject volume, GeometryObject object, double[] frame, double[] origin) {
        double[] rotation = new double[9];
        Rotations.multiply(frame, 0, object.rotation(), 0, rotation, 0);
        double[] place = apply(frame, object.center(), origin);
        checkContent(volume, object, rotation, place);
    }

    /** The same of what is in an object, which stands at a place in the frame of the volume. */
    private static void checkContent(GeometryObject volume, GeometryObject object, double[] rotation, double[] place) {
        if (object instanceof ObjectGroup group) {
            group.members().forEach(member -> check(volume, member, rotation, place));
        } else if (object instanceof MeshObject mesh) {
            checkMesh(volume, mesh.triangles(), rotation, place);
        } else if (object instanceof GridObject) {
            throw ObjectGroup.refused(object);
        } else {
            RoundedBox box = object.roundedBox();
            if (box.disc() > 0) {
                require(volume, place, box.disc(), box.halfHeight(), rotation, object);
                return;
            }
            for (int corner = 0; corner < 8; corner++) {
                double[] at =
                        apply(rotation, box.corner(corner, 0), box.corner(corner, 1), box.corner(corner, 2), place);
                require(volume, at, box.ball(), box.ball() > 0 ? -1 : 0, rotation, object);
            }
        }
    }

    private static void checkMesh(GeometryObject volume, TriangleMesh mesh, double[] rotation, double[] place) {
        for (int t = 0; t < mesh.size(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                int v = mesh.vertex(t, corner);
                double[] p =
                        apply(rotation, mesh.coordinate(v, 0), mesh.coordinate(v, 1), mesh.coordinate(v, 2), place);
                require(volume, p, 0, 0, rotation, "vertices[" + v + "]");
            }
        }
    }

    /**
     * Refuses a volume that does not enclose a part: a point (radius and half height 0), a sphere (half height -1) or a
     * cylinder about the own Y of a rotation.
     */
    private static void require(
            GeometryObject volume, double[] p, double radius, double halfHeight, double[] rotation, Object part) {
        double[] axes = volume.rotation();
        double dx = p[0] - volume.center().x();
        double dy = p[1] - volume.center().y();
        double dz = p[2] - volume.center().z();
        double[] along = new double[3];
        double[] reach = new double[3];
        for (int k = 0; k < 3; k++) {
            along[k] = Math.abs(dx * axes[k] + dy * axes[k + 3] + dz * axes[k + 6]);
            double c = Math.min(
                    1, Math.abs(axes[k] * rotation[1] + axes[k + 3] * rotation[4] + axes[k + 6] * rotation[7]));
            reach[k] = halfHeight < 0 ? radius : halfHeight * c + radius * Math.sqrt((1 - c) * (1 + c));
        }
        boolean inside;
        if (volume instanceof BoxObject box) {
            inside = along[0] + reach[0] <= box.width() / 2
                    && along[1] + reach[1] <= box.height() / 2
                    && along[2] + reach[2] <= box.length() / 2;
        } else if (volume instanceof CylinderObject cylinder) {
            double across = reach[0] == radius && reach[2] == radius
                    ? StrictMath.hypot(along[0], along[2]) + radius
                    : StrictMath.hypot(along[0] + reach[0], along[2] + reach[2]);
            inside = across <= cylinder.radius() && along[1] + reach[1] <= cylinder.height() / 2;
        } else {
            double far = halfHeight > 0 || (halfHeight == 0 && radius > 0)
                    ? rim(dx, dy, dz, radius, halfHeight, rotation)
                    : Math.sqrt(dx * dx + dy * dy + dz * dz) + radius;
            inside = far <= ((SphereObject) volume).radius();
        }
        if (!inside) {
            throw new IllegalArgumentException("boundingVolume must enclose its object, else collisions would be lost;"
                    + " make it larger or leave it out (got: " + volume + ", which does not hold " + part + ")");
        }
    }

    /** The distance of the farthest point of a cylinder's rims from the origin of d. */
    private static double rim(double dx, double dy, double dz, double radius, double halfHeight, double[] rotation) {
        double axial = Math.abs(dx * rotation[1] + dy * rotation[4] + dz * rotation[7]);
        double squared = dx * dx + dy * dy + dz * dz;
        double across = Math.sqrt(Math.max(0, squared - axial * axial));
        return Math.sqrt((axial + halfHeight) * (axial + halfHeight) + (across + radius) * (across + radius));
    }

    private static double[] identity() {
        return new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1};
    }

    private static double[] apply(double[] rotation, Point p, double[] origin) {
        return apply(rotation, p.x(), p.y(), p.z(), origin);
    }

    private static double[] apply(double[] rotation, double x, double y, double z, double[] origin) {
        double[] placed = new double[3];
        for (int k = 0; k < 3; k++) {
            placed[k] = rotation[3 * k] * x + rotation[3 * k + 1] * y + rotation[3 * k + 2] * z + origin[k];
        }
        return placed;
    }
}
