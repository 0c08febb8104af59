package robosim.geometry.engine.sensing;

import java.util.Arrays;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Twist;

/** Where a moving sensor's carrier is at the time of each beam. Poses are kept, as beams of one column share their times. */
final class SensorMotion {
    /** Poses kept, a power of two: the columns of a tile. */
    private static final int KEPT = 64;

    private final double[] start = new double[Pose.PLACE];

    // Made for the first sensor that moves.
    private double[] times = new double[0];
    private double[] poses = times;

    private final double[] pose = new double[Pose.PLACE];
    private Twist velocity = new Twist(0, 0, 0, 0);

    /** Takes where the carrier is at time 0, the {@link Pose#PLACE} numbers of its pose, and how it moves. */
    void start(double[] places, int at, Twist motion) {
        System.arraycopy(places, at, start, 0, Pose.PLACE);
        velocity = motion;
        if (times.length == 0) {
            times = new double[KEPT];
            poses = new double[KEPT * Pose.PLACE];
        }
        Arrays.fill(times, Double.NaN);
    }

    /** Where the numbers of the pose at a time begin in {@link #poses}. */
    int at(double seconds) {
        long bits = Double.doubleToRawLongBits(seconds) * 0x9e3779b97f4a7c15L;
        int entry = (int) (bits >>> 58);
        int at = entry * Pose.PLACE;
        if (times[entry] != seconds) {
            velocity.after(start, 0, seconds, pose);
            System.arraycopy(pose, 0, poses, at, Pose.PLACE);
            times[entry] = seconds;
        }
        return at;
    }

    /** Turns a vector from the own axes of the pose that begins at an index to the world's. */
    void turn(int at, double x, double y, double z, double[] out) {
        int r = at + 3;
        out[0] = poses[r] * x + poses[r + 1] * y + poses[r + 2] * z;
        out[1] = poses[r + 3] * x + poses[r + 4] * y + poses[r + 5] * z;
        out[2] = poses[r + 6] * x + poses[r + 7] * y + poses[r + 8] * z;
    }

    /** The numbers of the poses. */
    double[] poses() {
        return poses;
    }
}
