package robosim.geometry.export;

import robosim.geometry.model.Pose;

/** A rotation as a unit quaternion: x, y, z and w. */
record Quaternion(double x, double y, double z, double w) {
    static final Quaternion NONE = new Quaternion(0, 0, 0, 1);

    /** The rotation of a pose, whose rows are in order: by its largest component, so that none is divided by a small one. */
    static Quaternion of(Pose pose) {
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
        double length = Math.sqrt(x * x + y * y + z * z + w * w);
        return new Quaternion(x / length, y / length, z / length, w / length);
    }

    /** The same rotation by the quaternion that is nearer to another one. */
    Quaternion towards(Quaternion other) {
        double dot = x * other.x + y * other.y + z * other.z + w * other.w;
        return dot < 0 ? new Quaternion(-x, -y, -z, -w) : this;
    }
}
