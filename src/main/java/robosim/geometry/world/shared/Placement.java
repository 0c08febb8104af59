package robosim.geometry.world.shared;

import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.Rotations;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * The pose of one frame in another, in the world's axes: first rotated, then translated. Quarter turns are exact; turns
 * about the vertical are added as angles, not multiplied as matrices, so that two of 45 degrees make exactly one of 90.
 */
public final class Placement {
    public static final Placement NONE = upright(new Point(), 0, 0);

    private final Point origin;
    private final double[] rotation;

    /** Whether this turns about the vertical alone, by {@code heading + lost} degrees. */
    private final boolean upright;

    private final double heading;
    private final double lost;

    private Placement(Point origin, double[] rotation, boolean upright, double heading, double lost) {
        this.origin = origin;
        this.rotation = rotation;
        this.upright = upright;
        this.heading = heading;
        this.lost = lost;
    }

    /** Turned about the vertical by a compensated angle in degrees. */
    public static Placement upright(Point origin, double heading, double lost) {
        double[] rotation = new double[Rotations.SIZE];
        Rotations.yaw(heading, lost, rotation, 0);
        return new Placement(origin, rotation, true, heading, lost);
    }

    /** Turned by a rotation that is orthonormal to 1e-9. */
    public static Placement turned(Point origin, double[] rotation) {
        return new Placement(origin, rotation.clone(), false, 0, 0);
    }

    /** That of an object. */
    public static Placement of(Pose pose) {
        double heading = pose.heading();
        double lost = pose.lostHeading();
        double[] attitude = Attitude.identity();
        Attitude.setHeading(attitude, 0, heading, lost);
        return pose.isUpright() && Pose.of(pose.center(), attitude, 0).equals(pose)
                ? upright(pose.center(), heading, lost)
                : turned(pose.center(), pose.rotation());
    }

    /** The pose of a frame within this one, relative to the outer frame. */
    public Placement then(Placement inner) {
        Point place = apply(inner.origin);
        if (upright && inner.upright) {
            double[] sum = {heading, lost};
            Degrees.add(sum, 0, inner.heading);
            Degrees.add(sum, 0, inner.lost);
            return upright(place, sum[0], sum[1]);
        }
        double[] product = new double[Rotations.SIZE];
        Rotations.multiply(rotation, 0, inner.rotation, 0, product, 0);
        if (!isExact(rotation) && !isExact(inner.rotation)) {
            Rotations.orthonormalise(product, 0);
        }
        return new Placement(place, product, false, 0, 0);
    }

    /** The pose of the outer frame in this one. */
    public Placement inverse() {
        double[] back = new double[Rotations.SIZE];
        for (int k = 0; k < Rotations.SIZE; k++) {
            back[k] = rotation[k % 3 * 3 + k / 3];
        }
        Point place = apply(back, -origin.x(), -origin.y(), -origin.z());
        return upright ? upright(place, -heading, -lost) : new Placement(place, back, false, 0, 0);
    }

    /** Transforms a point of this frame to the outer frame. */
    public Point apply(Point place) {
        Point turned = apply(rotation, place.x(), place.y(), place.z());
        return new Point(origin.x() + turned.x(), origin.y() + turned.y(), origin.z() + turned.z());
    }

    /** Transforms a direction of this frame to the outer frame. */
    public Point direction(double x, double y, double z) {
        return apply(rotation, x, y, z);
    }

    public Point origin() {
        return origin;
    }

    /** Whether this has no rotation and moves at most along the vertical. */
    public boolean isOnTheSpot() {
        return upright && heading == 0 && lost == 0 && origin.x() == 0 && origin.z() == 0;
    }

    /** Whether this turns about the vertical at most. */
    public boolean isUpright() {
        return upright;
    }

    /** Whether this only moves. */
    public boolean isShift() {
        return upright && heading == 0 && lost == 0;
    }

    public Pose pose() {
        if (!upright) {
            return Pose.of(origin, 0).oriented(rotation);
        }
        double[] attitude = Attitude.identity();
        Attitude.setHeading(attitude, 0, heading, lost);
        return Pose.of(origin, attitude, 0);
    }

    private static Point apply(double[] r, double x, double y, double z) {
        return new Point(
                r[0] * x + r[1] * y + r[2] * z, r[3] * x + r[4] * y + r[5] * z, r[6] * x + r[7] * y + r[8] * z);
    }

    /** Whether a rotation only permutes axes and changes signs, so that products with it are exact. */
    private static boolean isExact(double[] rotation) {
        for (double number : rotation) {
            if (number != 0 && Math.abs(number) != 1) {
                return false;
            }
        }
        return true;
    }
}
