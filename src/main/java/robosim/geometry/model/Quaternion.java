package robosim.geometry.model;

/**
 * A rotation as a unit quaternion, in the order of ROS: the vector part x, y, z, then w. A quaternion and its negative are the
 * same rotation.
 *
 * @param x along X
 * @param y along Y
 * @param z along Z
 * @param w cosine of half the angle
 */
public record Quaternion(double x, double y, double z, double w) {
    /** No rotation. */
    public static final Quaternion NONE = new Quaternion(0, 0, 0, 1);

    /** How far a length may be from 1, as for the axes of a rotation. */
    private static final double LOOSE = 1e-9;

    /** What rounding to eight digits or to single precision leaves. */
    private static final double ROUNDED = 1e-6;

    /** Refuses numbers whose length is not 1 to within 1e-9; {@link #renormalised} accepts rounded ones. */
    public Quaternion {
        if (!(Math.abs(length(x, y, z, w) - 1) <= LOOSE)) { // written so that NaN fails it
            throw new IllegalArgumentException(
                    "a quaternion must have length 1 to within 1e-9; pass one with fewer digits"
                            + " to Quaternion.renormalised (got: " + text(x, y, z, w) + ")");
        }
    }

    /**
     * A rotation that was rounded, to eight digits or to single precision, made a unit quaternion again.
     *
     * @throws IllegalArgumentException if the length is not 1 to within 1e-6
     */
    public static Quaternion renormalised(double x, double y, double z, double w) {
        double length = length(x, y, z, w);
        if (!(Math.abs(length - 1) <= ROUNDED)) {
            throw new IllegalArgumentException(
                    "a quaternion must have length 1 to within 1e-6 (got: " + text(x, y, z, w) + ")");
        }
        return new Quaternion(x / length, y / length, z / length, w / length);
    }

    /** The rotation of a pose, computed by its largest component, so that nothing is divided by a small one. */
    public static Quaternion of(Pose pose) {
        double[] r = pose.rotation();
        double trace = r[0] + r[4] + r[8];
        if (trace > 0) {
            double d = Math.sqrt(trace + 1) * 2;
            return of((r[7] - r[5]) / d, (r[2] - r[6]) / d, (r[3] - r[1]) / d, d / 4);
        }
        if (r[0] >= r[4] && r[0] >= r[8]) {
            double d = Math.sqrt(1 + r[0] - r[4] - r[8]) * 2;
            return of(d / 4, (r[1] + r[3]) / d, (r[2] + r[6]) / d, (r[7] - r[5]) / d);
        }
        if (r[4] >= r[8]) {
            double d = Math.sqrt(1 + r[4] - r[0] - r[8]) * 2;
            return of((r[1] + r[3]) / d, d / 4, (r[5] + r[7]) / d, (r[2] - r[6]) / d);
        }
        double d = Math.sqrt(1 + r[8] - r[0] - r[4]) * 2;
        return of((r[2] + r[6]) / d, (r[5] + r[7]) / d, d / 4, (r[3] - r[1]) / d);
    }

    private static Quaternion of(double x, double y, double z, double w) {
        double length = length(x, y, z, w);
        return new Quaternion(x / length, y / length, z / length, w / length);
    }

    /** The same rotation by the quaternion that is nearer to another one. */
    public Quaternion towards(Quaternion other) {
        double dot = x * other.x + y * other.y + z * other.z + w * other.w;
        return dot < 0 ? new Quaternion(-x, -y, -z, -w) : this;
    }

    /** The rotation matrix: nine numbers, row-major, as {@link Pose#oriented} takes them. */
    public double[] rotation() {
        double n = x * x + y * y + z * z + w * w;
        return new double[] {
            (w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n,
            2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n,
            2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n
        };
    }

    private static double length(double x, double y, double z, double w) {
        return Math.sqrt(x * x + y * y + z * z + w * w);
    }

    private static String text(double x, double y, double z, double w) {
        return x + ", " + y + ", " + z + ", " + w;
    }
}
