package robosim.geometry.narrow.ray;

import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;

/** The cylinder, or the capsule, that a query is about: what its row tells, and its axis, which is of about unit length. */
final class PlacedCylinder {
    double cx;
    double cy;
    double cz;
    double r;

    /** Half the height, in lengths of the axis. */
    double h;

    double ax;
    double ay;
    double az;

    /** Whether its heights are those of the world, which are subtracted with fewer roundings. */
    boolean isUpright;

    /** Takes an upright cylinder, whose axis is the world's Y. */
    PlacedCylinder upright(double[] b, int j) {
        about(b, j, 0, 1, 0);
        isUpright = true;
        return this;
    }

    /** Takes a turned one, whose axis is the Y axis of the stored rotation. */
    PlacedCylinder turned(double[] b, int j) {
        int y = j + Leaf.ROTATION + 1;
        return about(b, j, b[y], b[y + 3], b[y + 6]);
    }

    /** Takes one about an axis. */
    PlacedCylinder about(double[] b, int j, double x, double y, double z) {
        cx = b[j];
        cy = b[j + 1];
        cz = b[j + 2];
        r = b[j + 3];
        h = b[j + 4];
        ax = x;
        ay = y;
        az = z;
        isUpright = false;
        return this;
    }

    /** The square of the axis. */
    double square() {
        return ax * ax + ay * ay + az * az;
    }

    /** The largest coordinate or size. */
    double extent() {
        return Math.max(VectorMath.largest(cx, cy, cz), Math.max(r, h));
    }
}
