package robosim.geometry.census;

import java.util.SplittableRandom;

/** Vectors and turns of the twins, in plain doubles. */
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

    /** A vector at length 1; the first axis for one without a length. */
    static double[] unit(double[] p) {
        double length = length(p);
        return length > 0 ? new double[] {p[0] / length, p[1] / length, p[2] / length} : new double[] {1, 0, 0};
    }

    static double between(double[] p, double[] q) {
        double x = p[0] - q[0];
        double y = p[1] - q[1];
        double z = p[2] - q[2];
        return Math.sqrt(x * x + y * y + z * z);
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

    /** The matrix, row by row, of a turn about a unit axis. */
    static double[] turn(double[] w, double degrees) {
        double c = StrictMath.cos(Math.toRadians(degrees));
        double s = StrictMath.sin(Math.toRadians(degrees));
        double half = StrictMath.sin(Math.toRadians(0.5 * degrees));
        double d = 2 * half * half; // 1 - cos, of a small angle too
        return new double[] {
            c + d * w[0] * w[0],
            d * w[0] * w[1] - s * w[2],
            d * w[0] * w[2] + s * w[1],
            d * w[1] * w[0] + s * w[2],
            c + d * w[1] * w[1],
            d * w[1] * w[2] - s * w[0],
            d * w[2] * w[0] - s * w[1],
            d * w[2] * w[1] + s * w[0],
            c + d * w[2] * w[2]
        };
    }

    static double[] times(double[] m, double[] p) {
        return new double[] {
            m[0] * p[0] + m[1] * p[1] + m[2] * p[2],
            m[3] * p[0] + m[4] * p[1] + m[5] * p[2],
            m[6] * p[0] + m[7] * p[1] + m[8] * p[2]
        };
    }
}
