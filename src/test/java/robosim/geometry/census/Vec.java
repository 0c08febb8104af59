package robosim.geometry.census;

import java.util.SplittableRandom;

/** Three numbers. */
final class Vec {
    private Vec() {}

    static double dot(double[] p, double[] q) {
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    }

    static double[] cross(double[] p, double[] q) {
        return new double[] {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    }

    static double[] minus(double[] p, double[] q) {
        return new double[] {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
    }

    /** The vector p + f q. */
    static double[] plus(double[] p, double f, double[] q) {
        return new double[] {p[0] + f * q[0], p[1] + f * q[1], p[2] + f * q[2]};
    }

    static double length(double[] p) {
        return Math.sqrt(dot(p, p));
    }

    static double[] unit(double[] p) {
        return plus(new double[3], 1 / length(p), p);
    }

    /** What is left of p square to a unit vector, and again, as the first leaves a rounding of p. */
    static double[] squareTo(double[] u, double[] p) {
        double[] q = plus(p, -dot(p, u), u);
        return plus(q, -dot(q, u), u);
    }

    /** A unit vector to any side. */
    static double[] direction(SplittableRandom random) {
        while (true) {
            double[] p = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
            double length = length(p);
            if (length > 0.1 && length < 1) {
                return unit(p);
            }
        }
    }

    /** A rotation, row by row, whose columns are three unit vectors: u, then v made square to it, then both's product. */
    static double[] rotation(double[] u, double[] towards) {
        double[] v = unit(squareTo(u, towards));
        double[] w = cross(u, v);
        return new double[] {u[0], v[0], w[0], u[1], v[1], w[1], u[2], v[2], w[2]};
    }

    /** The same with its columns put round, so that the one that was first is the k-th. */
    static double[] turnedRound(double[] r, int k) {
        double[] out = new double[9];
        for (int column = 0; column < 3; column++) {
            for (int axis = 0; axis < 3; axis++) {
                out[3 * axis + (column + k) % 3] = r[3 * axis + column];
            }
        }
        return out;
    }
}
