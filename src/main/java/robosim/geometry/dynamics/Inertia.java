package robosim.geometry.dynamics;

import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.SphereObject;

/** Moments of inertia of solids about their own axes, and how far they reach. */
final class Inertia {
    /** The least moment of a body is at least this share of its greatest: a needle turns about itself too. */
    private static final double LEAST = 1e-6;

    private Inertia() {}

    /** Whether it is one of the shapes that fall and tip. */
    static boolean isSolid(GeometryObject object) {
        return switch (object.kind()) {
            case SPHERE, BOX, CYLINDER, CAPSULE -> true;
            case MESH, GROUP, GRID -> false;
        };
    }

    /**
     * The moments of a body of a shape about its own axes, three numbers.
     *
     * @param x that about the own X; 0 for what follows from the shape and from that about the own Y
     * @param z likewise
     */
    static double[] moments(GeometryObject object, double x, double y, double z) {
        double[] unit = gyrationSquares(object);
        double scale = unit[1] > 0 ? y / unit[1] : 0;
        double[] all = {x > 0 ? x : unit[0] * scale, y, z > 0 ? z : unit[2] * scale};
        double most = Math.max(all[0], Math.max(all[1], all[2]));
        for (int axis = 0; axis < 3; axis++) {
            all[axis] = Math.max(all[axis], LEAST * most);
        }
        return all;
    }

    /** The squares of the radii of gyration about the own axes: the moments of a unit of mass. */
    static double[] gyrationSquares(GeometryObject object) {
        return switch (object.kind()) {
            case SPHERE -> {
                double r = ((SphereObject) object).radius();
                yield new double[] {0.4 * r * r, 0.4 * r * r, 0.4 * r * r};
            }
            case BOX -> {
                BoxObject box = (BoxObject) object;
                double x = box.width() * box.width() / 12;
                double y = box.height() * box.height() / 12;
                double z = box.length() * box.length() / 12;
                yield new double[] {y + z, x + z, x + y};
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                double r = cylinder.radius();
                double h = cylinder.height();
                double across = r * r / 4 + h * h / 12;
                yield new double[] {across, r * r / 2, across};
            }
            case CAPSULE -> capsule((CapsuleObject) object);
            case MESH, GROUP, GRID -> throw unknown(object);
        };
    }

    /** A rod and two half balls, each by its share of the volume; the halves about the rod's ends by Steiner's theorem. */
    private static double[] capsule(CapsuleObject capsule) {
        double r = capsule.radius();
        double h = capsule.segment();
        double rod = h;
        double ball = 4 * r / 3;
        double whole = rod + ball;
        if (!(whole > 0)) {
            return new double[3];
        }
        double along = r * r * (rod / 2 + 0.4 * ball) / whole;
        double across = (rod * (r * r / 4 + h * h / 12) + ball * (0.4 * r * r + h * h / 4 + 3 * h * r / 8)) / whole;
        return new double[] {across, along, across};
    }

    /** No point is farther from the centre. */
    static double reach(GeometryObject object) {
        double most = switch (object.kind()) {
            case SPHERE -> ((SphereObject) object).radius();
            case BOX -> {
                BoxObject box = (BoxObject) object;
                yield 0.5
                        * Math.sqrt(
                                box.width() * box.width() + box.height() * box.height() + box.length() * box.length());
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                double half = cylinder.height() / 2;
                yield Math.sqrt(cylinder.radius() * cylinder.radius() + half * half);
            }
            case CAPSULE -> ((CapsuleObject) object).segment() / 2 + ((CapsuleObject) object).radius();
            case MESH, GROUP, GRID -> throw unknown(object);
        };
        return most * (1 + 1e-9);
    }

    private static IllegalArgumentException unknown(GeometryObject object) {
        return new IllegalArgumentException("object must be a sphere, box, cylinder or capsule (got: " + object + ")");
    }
}
