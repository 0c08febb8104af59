package robosim.geometry.model;

import robosim.geometry.exact.Rotations;

/**
 * Checks that a bounding volume encloses its object. It compares how far each part extends along the volume's own axes,
 * or from its centre or axis; a turned cylinder inside a cylinder is represented by its enclosing box. What cannot be
 * shown to be enclosed is refused.
 */
final class Enclosing {
    private Enclosing() {}

    /** Refuses a volume that is not a box, cylinder or sphere, or does not enclose the object in its own frame. */
    static void check(GeometryObject volume, GeometryObject object) {
        switch (volume.kind()) {
            case BOX, CYLINDER, SPHERE -> {}
            case CAPSULE, MESH, GROUP, GRID -> throw notAVolume(volume);
        }
        double[] frame = identity();
        double[] origin = new double[3];
        if (object instanceof ObjectGroup group) {
            for (GeometryObject member : group.members()) {
                check(volume, member, frame, origin);
            }
        } else if (object instanceof MeshObject mesh) {
            checkMesh(volume, mesh.triangles(), frame, origin);
        }
    }

    private static IllegalArgumentException notAVolume(GeometryObject volume) {
        return new IllegalArgumentException(
                "boundingVolume must be a box, a cylinder or a sphere (got: " + volume + ")");
    }

    /**
     * Checks an object whose pose is relative to a frame; {@code frame} is that frame's rotation and {@code origin} its
     * origin in the frame of the volume.
     */
    private static void check(GeometryObject volume, GeometryObject object, double[] frame, double[] origin) {
        double[] rotation = new double[9];
        Rotations.multiply(frame, 0, object.rotation(), 0, rotation, 0);
        double[] place = apply(frame, object.center(), origin);
        switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                for (int corner = 0; corner < 8; corner++) {
                    double x = (corner & 1) == 0 ? -box.width() / 2 : box.width() / 2;
                    double y = (corner & 2) == 0 ? -box.height() / 2 : box.height() / 2;
                    double z = (corner & 4) == 0 ? -box.length() / 2 : box.length() / 2;
                    require(volume, apply(rotation, x, y, z, place), 0, 0, rotation, object);
                }
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                require(volume, place, cylinder.radius(), cylinder.height() / 2, rotation, object);
            }
            case SPHERE -> require(volume, place, ((SphereObject) object).radius(), -1, rotation, object);
            case CAPSULE -> {
                CapsuleObject capsule = (CapsuleObject) object;
                double half = capsule.segment() / 2;
                require(volume, apply(rotation, 0, half, 0, place), capsule.radius(), -1, rotation, object);
                require(volume, apply(rotation, 0, -half, 0, place), capsule.radius(), -1, rotation, object);
            }
            case MESH -> checkMesh(volume, ((MeshObject) object).triangles(), rotation, place);
            case GROUP -> {
                for (GeometryObject member : ((ObjectGroup) object).members()) {
                    check(volume, member, rotation, place);
                }
            }
            case GRID -> throw ObjectGroup.refused(object);
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
        boolean inside = switch (volume.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) volume;
                yield along[0] + reach[0] <= box.width() / 2
                        && along[1] + reach[1] <= box.height() / 2
                        && along[2] + reach[2] <= box.length() / 2;
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) volume;
                double across = reach[0] == radius && reach[2] == radius
                        ? StrictMath.hypot(along[0], along[2]) + radius
                        : StrictMath.hypot(along[0] + reach[0], along[2] + reach[2]);
                yield across <= cylinder.radius() && along[1] + reach[1] <= cylinder.height() / 2;
            }
            case SPHERE -> {
                double far = halfHeight > 0 || (halfHeight == 0 && radius > 0)
                        ? rim(dx, dy, dz, radius, halfHeight, rotation)
                        : Math.sqrt(dx * dx + dy * dy + dz * dz) + radius;
                yield far <= ((SphereObject) volume).radius();
            }
            case CAPSULE, MESH, GROUP, GRID -> throw notAVolume(volume);
        };
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
