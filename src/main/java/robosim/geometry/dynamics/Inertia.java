package robosim.geometry.dynamics;

import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.RoundedBox;

/** Volumes and moments of inertia of solids about their own axes, and how far they reach. */
final class Inertia {
    /** The least moment of a body is at least this share of its greatest: a needle turns about itself too. */
    private static final double LEAST = 1e-6;

    private Inertia() {}

    static double volume(GeometryObject object) {
        RoundedBox box = object.roundedBox();
        double r = box.radius();
        double ball = box.ball();
        double length = 2 * box.halfHeight();
        return 2 * box.halfWidth() * length * (2 * box.halfLength())
                + Math.PI * r * r * length
                + Math.PI * 4 / 3 * ball * ball * ball;
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

    /** The square of the radius of gyration about the own Y: the inertia of a unit of mass. */
    static double gyrationSquare(GeometryObject object) {
        RoundedBox box = object.roundedBox();
        double r = box.radius();
        if (box.disc() > 0) {
            return r * r / 2;
        }
        if (box.ball() == 0) {
            double width = 2 * box.halfWidth();
            double length = 2 * box.halfLength();
            return (width * width + length * length) / 12;
        }
        // A rod and a ball of one radius r, in shares of their volumes: r^2 / 2 and 2 r^2 / 5.
        double length = 2 * box.halfHeight();
        return length == 0 ? 0.4 * (r * r) : r * r * (length / 2 + 8 * r / 15) / (length + 4 * r / 3);
    }

    /** The squares of the radii of gyration about the own axes: the moments of a unit of mass. */
    static double[] gyrationSquares(GeometryObject object) {
        RoundedBox box = object.roundedBox();
        double r = box.radius();
        double h = 2 * box.halfHeight();
        if (box.disc() > 0) {
            double across = r * r / 4 + h * h / 12;
            return new double[] {across, r * r / 2, across};
        }
        if (box.ball() > 0) {
            return h == 0 ? new double[] {0.4 * r * r, 0.4 * r * r, 0.4 * r * r} : capsule(r, h);
        }
        double x = 4 * box.halfWidth() * box.halfWidth() / 12;
        double y = h * h / 12;
        double z = 4 * box.halfLength() * box.halfLength() / 12;
        return new double[] {y + z, x + z, x + y};
    }

    /** A rod and two half balls, each by its share of the volume; the halves about the rod's ends by Steiner's theorem. */
    private static double[] capsule(double r, double h) {
        double ball = 4 * r / 3;
        double whole = h + ball;
        double along = r * r * (h / 2 + 0.4 * ball) / whole;
        double across = (h * (r * r / 4 + h * h / 12) + ball * (0.4 * r * r + h * h / 4 + 3 * h * r / 8)) / whole;
        return new double[] {across, along, across};
    }

    /** No point is farther from the centre. */
    static double reach(GeometryObject object) {
        RoundedBox box = object.roundedBox();
        double x = box.halfWidth() + box.disc();
        double y = box.halfHeight();
        double z = box.halfLength();
        return (Math.sqrt(x * x + y * y + z * z) + box.ball()) * (1 + 1e-9);
    }
}
