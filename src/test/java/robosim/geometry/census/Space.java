package robosim.geometry.census;

import java.util.SplittableRandom;

/** Vectors and turns of the twins, in plain doubles. */
final class Space {
    private Space() {}

    static double dot(double[] p, double[] q) {
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    }

    static double length(double[] p) {
        return Math.sqrt(dot(p, p));
    }

    static double between(double[] p, double[] q) {
        double x = p[0] - q[0];
        double y = p[1] - q[1];
        double z = p[2] - q[2];
        return Math.sqrt(x * x + y * y + z * z);
    }

    static double[] cross(double[] p, double[] q) {
        return new double[] {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    }

    /** The sum p + times q. */
    static double[] sum(double[] p, double[] q, double times) {
        return new double[] {p[0] + times * q[0], p[1] + times * q[1], p[2] + times * q[2]};
    }

    /** A vector at length 1; the first axis for one without a length. */
    static double[] unit(double[] p) {
        double length = length(p);
        return length > 0 ? new double[] {p[0] / length, p[1] / length, p[2] / length} : new double[] {1, 0, 0};
    }

    static double[] direction(SplittableRandom random) {
        double up = random.nextDouble(-1, 1);
        double angle = random.nextDouble(-Math.PI, Math.PI);
        double level = Math.sqrt(1 - up * up);
        return new double[] {level * Math.cos(angle), up, level * Math.sin(angle)};
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
