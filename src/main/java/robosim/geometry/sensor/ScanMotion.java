package robosim.geometry.sensor;

import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Twist;

/**
 * How a sensor moves while it is read: takes what a ray measured, in the sensor's own frame at the time of the ray, to the
 * sensor's frame at time 0. With the twist of what carries the sensor, a mount with rotation M at m, and the carrier at s,
 * turned by T, after a time, a vector v becomes M' T M v, and the sensor's origin is at M' (s + T m - m).
 */
final class ScanMotion {
    private final Twist twist;
    private final double[] mount = new double[9];
    private final double mx;
    private final double mz;

    private double at = Double.NaN;
    private double sin;
    private double cos;

    /** Where the sensor is, in the carrier's frame at time 0, less where it is mounted. */
    private final double[] shift = new double[3];

    ScanMotion(Twist twist, Mounting mounting) {
        this.twist = twist;
        boolean isCarried = mounting.carrier() != null;
        Pose pose = isCarried ? mounting.pose() : Pose.ORIGIN; // a free sensor moves by itself
        pose.rotation(mount, 0);
        mx = pose.center().x();
        mz = pose.center().z();
    }

    /** Goes to a time. */
    void to(double seconds) {
        if (seconds == at) {
            return;
        }
        at = seconds;
        double turn = twist.ry() * seconds;
        sin = Degrees.sin(turn);
        cos = Degrees.cos(turn);
        // The chord of the arc, as Twist.after has it.
        double half = turn / 2;
        double time = half == 0 ? seconds : seconds * (Degrees.sin(half) / Degrees.toRadians(half));
        double sinHalf = Degrees.sin(half);
        double cosHalf = Degrees.cos(half);
        double forward = time * (twist.x() * cosHalf + twist.z() * sinHalf);
        double right = time * (twist.z() * cosHalf - twist.x() * sinHalf);
        shift[0] = forward + (cos * mx + sin * mz) - mx;
        shift[1] = seconds * twist.y();
        shift[2] = right + (cos * mz - sin * mx) - mz;
    }

    /** Turns a vector to the sensor's axes at time 0. */
    void turn(double[] vector) {
        double x = mount[0] * vector[0] + mount[1] * vector[1] + mount[2] * vector[2];
        double y = mount[3] * vector[0] + mount[4] * vector[1] + mount[5] * vector[2];
        double z = mount[6] * vector[0] + mount[7] * vector[1] + mount[8] * vector[2];
        back(cos * x + sin * z, y, cos * z - sin * x, vector);
    }

    /** Writes where the sensor is, in its own frame at time 0. */
    void origin(double[] out) {
        back(shift[0], shift[1], shift[2], out);
    }

    private void back(double x, double y, double z, double[] out) {
        out[0] = mount[0] * x + mount[3] * y + mount[6] * z;
        out[1] = mount[1] * x + mount[4] * y + mount[7] * z;
        out[2] = mount[2] * x + mount[5] * y + mount[8] * z;
    }
}
