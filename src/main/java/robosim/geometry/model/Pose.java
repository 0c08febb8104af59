package robosim.geometry.model;

import java.util.Arrays;
import java.util.Collection;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.Rotations;
import robosim.geometry.exact.VectorMath;

/**
 * The position and attitude of an object: a centre and a rotation.
 *
 * <p>The heading of an upright pose is kept as a compensated angle (a sum and its rounding error), so that many small
 * turns do not drift; its rotation is computed afresh from that angle. The centre of an object that has moved in a
 * world keeps the rounding errors of its coordinates in the same way; no query sees them, and they are not sent over
 * the network. Poses are equal if their centres and rotations are.
 */
public final class Pose {
    /** The share of the picture that what is to be seen may reach over. */
    private static final double FILLED = 0.93;

    /**
     * Within the {@link #PLACE} doubles of a stored pose, the index of the centre's three rounding errors, one per
     * coordinate.
     */
    public static final int LOST = 3 + Attitude.STRIDE;

    /**
     * Number of doubles in which a world stores a pose: the centre, the attitude, and the rounding errors of the
     * centre.
     */
    public static final int PLACE = LOST + 3;

    private static final double[] NOTHING_LOST = new double[3];

    /** The attitude facing +X, shared by all poses that have it; never written to. */
    private static final double[] FORWARD = forward();

    /** At the origin, facing +X. */
    public static final Pose ORIGIN = new Pose(new Point(), Attitude.identity());

    private final Point center;

    /** Laid out by {@link Attitude}. */
    private final double[] attitude;

    private final double[] lost;

    private Pose(Point center, double[] attitude) {
        this(center, attitude, NOTHING_LOST);
    }

    private Pose(Point center, double[] attitude, double[] lost) {
        this.center = center;
        this.attitude = attitude;
        this.lost = lost;
    }

    private static double[] forward() {
        double[] attitude = Attitude.identity();
        Attitude.setHeading(attitude, 0, 0, 0);
        return attitude;
    }

    /** An upright pose at a point, with a heading in degrees. */
    public static Pose of(Point center, double heading) {
        if (Double.doubleToRawLongBits(heading) == 0) {
            return new Pose(Checks.present("center", center), FORWARD);
        }
        double[] attitude = Attitude.identity();
        Attitude.setHeading(attitude, 0, Checks.angle("heading", heading), 0);
        return new Pose(Checks.present("center", center), attitude);
    }

    /**
     * A pose from the numbers of an {@link Attitude}, which are copied.
     *
     * @throws IllegalArgumentException if they are not a rotation
     */
    public static Pose of(Point center, double[] attitude, int at) {
        checkAttitude("attitude", attitude, at, Attitude.STRIDE, at);
        return new Pose(Checks.present("center", center), Arrays.copyOfRange(attitude, at, at + Attitude.STRIDE));
    }

    private static void checkAttitude(String argument, double[] numbers, int at, int length, int attitude) {
        Checks.present(argument, numbers);
        if (at < 0 || numbers.length - length < at) {
            throw new IllegalArgumentException(argument + " must have " + length + " numbers from there on (got: "
                    + numbers.length + " and " + at + ")");
        }
        if (!Attitude.isRotation(numbers, attitude)) {
            throw new IllegalArgumentException(
                    argument + " must hold a rotation: 9 numbers, row-major, whose columns are"
                            + " right-handed and orthonormal to 1e-9 (got: "
                            + Arrays.toString(Arrays.copyOfRange(numbers, attitude, attitude + 9)) + ")");
        }
        Checks.angle(argument + "'s heading", numbers[attitude + 9]);
        Checks.angle(argument + "'s lost heading", numbers[attitude + 10]);
    }

    /**
     * A pose from the {@link #PLACE} numbers that a world stores, which are copied.
     *
     * @throws IllegalArgumentException if they are not a valid place and rotation
     */
    public static Pose of(double[] places, int at) {
        checkAttitude("places", places, at, PLACE, at + 3);
        return new Pose(
                new Point(places[at], places[at + 1], places[at + 2]),
                Arrays.copyOfRange(places, at + 3, at + LOST),
                Arrays.copyOfRange(places, at + LOST, at + PLACE));
    }

    /**
     * A pose from serialized values: a rotation, kept as given, and the heading with its rounding error, in degrees.
     * The heading is used only if it gives exactly that rotation.
     */
    public static Pose of(Point center, double[] rotation, double heading, double rest) {
        Pose given = of(center, 0).oriented(rotation);
        if (given.isUpright() && Math.abs(heading) <= 180 && Math.abs(rest) <= 1e-12) {
            double[] entry = Attitude.identity();
            Attitude.setHeading(entry, 0, heading, rest);
            Pose made = of(center, entry, 0);
            if (made.equals(given)) {
                return made;
            }
        }
        return given;
    }

    /**
     * A pose from {@link #PLACE} numbers that come from outside and are not trusted.
     *
     * @throws IllegalArgumentException if no pose has these numbers
     */
    public static Pose checked(double[] places, int at) {
        Pose pose = of(places, at);
        double[] given = pose.attitude;
        double heading = Attitude.heading(given, 0);
        double rest = pose.lostHeading();
        Pose made = of(pose.center, 0).oriented(pose.rotation());
        boolean isRead = rest == 0 && made.heading() == heading;
        if (!isRead && made.isUpright() && Math.abs(heading) <= 180 && Math.abs(rest) <= Math.ulp(180.0)) {
            double[] entry = Attitude.identity();
            Attitude.setHeading(entry, 0, heading, rest);
            isRead = Arrays.equals(entry, withoutNegativeZero(given));
        }
        if (!isRead) {
            throw new IllegalArgumentException("heading must be that of its rotation (got: " + heading + " and " + rest
                    + " degrees for " + Arrays.toString(pose.rotation()) + ")");
        }
        for (int axis = 0; axis < 3; axis++) {
            double place = axis == 0 ? pose.center.x() : axis == 1 ? pose.center.y() : pose.center.z();
            if (!(Math.abs(pose.lost[axis]) <= Math.ulp(place) / 2)) {
                throw new IllegalArgumentException("what a coordinate has lost must be at most half an ulp of it (got: "
                        + pose.lost[axis] + " of " + place + ")");
            }
        }
        return pose;
    }

    private static double[] withoutNegativeZero(double[] numbers) {
        double[] plain = numbers.clone();
        for (int k = 0; k < plain.length; k++) {
            plain[k] += 0.0;
        }
        return plain;
    }

    /**
     * The pose of a camera that looks from one point to another, upright in the picture. One that looks straight up or down
     * has -Z up in a picture from above and +Z up in one from below, as on a plan.
     *
     * @throws IllegalArgumentException if the two are the same point
     */
    public static Pose lookAt(Point eye, Point target) {
        Checks.present("eye", eye);
        Checks.present("target", target);
        double x = target.x() - eye.x();
        double y = target.y() - eye.y();
        double z = target.z() - eye.z();
        double length = VectorMath.length(x, y, z);
        if (!(length > 0)) {
            throw new IllegalArgumentException("target must not be the eye itself (got: " + target + ")");
        }
        x /= length;
        y /= length;
        z /= length;
        // To the right: forward times up, which is (-z, 0, x).
        double level = VectorMath.length(x, 0, z);
        double rightX = level > 0x1p-20 ? -z / level : 1;
        double rightZ = level > 0x1p-20 ? x / level : 0;
        if (level <= 0x1p-20) {
            x = 0;
            z = 0;
            y = y < 0 ? -1 : 1;
        }
        // Up: to the right times forward.
        double upX = -rightZ * y;
        double upY = rightZ * x - rightX * z;
        double upZ = rightX * y;
        return Pose.of(eye, 0).oriented(new double[] {x, upX, rightX, y, upY, 0, z, upZ, rightZ});
    }

    /**
     * The pose of a camera that sees some points from a direction, from as near as it can: in the direction that decides how
     * near that is, the points reach over 0.93 of the picture, and in both directions the border is the same on
     * either side.
     *
     * @param points      at least one; of a box its {@linkplain Bounds#corners corners}
     * @param azimuth     degrees counter-clockwise about the vertical from +X, where the camera stands as seen from the points
     * @param elevation   degrees above the level at which it stands, from -90 to 90
     * @param fieldOfView horizontal field of view in degrees, above 0 and below 180
     * @param aspect      width of the picture over its height
     */
    public static Pose around(
            Collection<Point> points, double azimuth, double elevation, double fieldOfView, double aspect) {
        if (Checks.present("points", points).isEmpty()) {
            throw new IllegalArgumentException("points must not be empty (got: none)");
        }
        Checks.angle("azimuth", azimuth);
        if (!(elevation >= -90 && elevation <= 90)) { // written so that NaN fails it
            throw new IllegalArgumentException("elevation must be from -90.0 to 90.0 (got: " + elevation + ")");
        }
        if (!(fieldOfView > 0 && fieldOfView < 180)) {
            throw new IllegalArgumentException("fieldOfView must be above 0 and below 180 (got: " + fieldOfView + ")");
        }
        if (!(aspect > 0 && aspect <= 0x1p20)) {
            throw new IllegalArgumentException("aspect must be above 0 and at most 2^20 (got: " + aspect + ")");
        }
        double away = Degrees.cos(elevation);
        Point back = new Point(Degrees.cos(azimuth) * away, Degrees.sin(elevation), -Degrees.sin(azimuth) * away);
        Pose turned = lookAt(back, new Point());
        double[] r = turned.rotation();
        double wide = FILLED * Degrees.sin(fieldOfView / 2) / Degrees.cos(fieldOfView / 2);
        double high = wide / aspect;
        // The planes on the four sides of what may be seen each touch a point: their offsets, as seen along the
        // camera's axes.
        double right = Double.NEGATIVE_INFINITY;
        double left = Double.NEGATIVE_INFINITY;
        double top = Double.NEGATIVE_INFINITY;
        double bottom = Double.NEGATIVE_INFINITY;
        double near = Double.POSITIVE_INFINITY;
        double far = Double.NEGATIVE_INFINITY;
        for (Point point : points) {
            double ahead = r[0] * point.x() + r[3] * point.y() + r[6] * point.z();
            double up = r[1] * point.x() + r[4] * point.y() + r[7] * point.z();
            double aside = r[2] * point.x() + r[5] * point.y() + r[8] * point.z();
            right = Math.max(right, aside - wide * ahead);
            left = Math.max(left, -aside - wide * ahead);
            top = Math.max(top, up - high * ahead);
            bottom = Math.max(bottom, -up - high * ahead);
            near = Math.min(near, ahead);
            far = Math.max(far, ahead);
        }
        double ahead = Math.min(-(right + left) / (2 * wide), -(top + bottom) / (2 * high));
        // In front of a single point too, and of a corner that is sharper than the picture is wide.
        double eye = Math.min(ahead, near - Math.max((far - near) / 32, 0x1p-20 * Math.max(Math.abs(near), 0x1p-16)));
        double up = (top - bottom) / 2;
        double aside = (right - left) / 2;
        return turned.movedTo(new Point(
                r[0] * eye + r[1] * up + r[2] * aside,
                r[3] * eye + r[4] * up + r[5] * aside,
                r[6] * eye + r[7] * up + r[8] * aside));
    }

    /** The rounding error of the heading, in degrees: {@code heading() + lostHeading()} is the angle that is kept. */
    public double lostHeading() {
        return attitude[Attitude.STRIDE - 1];
    }

    /** The place. */
    public Point center() {
        return center;
    }

    /**
     * The rotation matrix, nine numbers row-major; its columns are the object's own axes in the world. A fresh array.
     */
    public double[] rotation() {
        return Arrays.copyOf(attitude, 9);
    }

    /** One number of the rotation, 0 to 8, row-major. */
    public double rotation(int index) {
        if (index < 0 || index > 8) {
            throw new IllegalArgumentException("index must be 0 to 8 (got: " + index + ")");
        }
        return attitude[index];
    }

    /** Writes the nine numbers of the rotation into an array. */
    public void rotation(double[] out, int at) {
        System.arraycopy(attitude, 0, out, at, 9);
    }

    /** Degrees about the vertical from the world's X to forward, above -180 and up to 180. */
    public double heading() {
        return Attitude.heading(attitude, 0);
    }

    /** Whether the own Y is the world's, exactly: the pose is a place and a heading. */
    public boolean isUpright() {
        return attitude == FORWARD || Attitude.isUpright(attitude, 0);
    }

    /** Writes the {@link Attitude} of this pose into an array. */
    public void attitude(double[] column, int at) {
        System.arraycopy(attitude, 0, column, at, Attitude.STRIDE);
    }

    /** Writes the {@link #PLACE} numbers of this pose into an array. */
    public void place(double[] column, int at) {
        column[at] = center.x();
        column[at + 1] = center.y();
        column[at + 2] = center.z();
        attitude(column, at + 3);
        System.arraycopy(lost, 0, column, at + LOST, 3);
    }

    /** The same attitude at another point. */
    public Pose movedTo(Point place) {
        return new Pose(Checks.present("center", place), attitude);
    }

    /** This pose, given in the own frame of another one, in the frame in which that one is given. */
    public Pose within(Pose frame) {
        double[] r = Checks.present("frame", frame).attitude;
        double[] turned = Attitude.identity();
        double[] product = new double[9];
        Rotations.multiply(r, 0, attitude, 0, product, 0);
        Attitude.orient(turned, 0, product);
        Point f = frame.center;
        double[] place = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            int row = 3 * axis;
            place[axis] = r[row] * center.x() + r[row + 1] * center.y() + r[row + 2] * center.z();
        }
        return new Pose(new Point(f.x() + place[0], f.y() + place[1], f.z() + place[2]), turned);
    }

    /** This pose, given in the same frame as another one, in the own frame of that: {@code within(frame)} is the inverse. */
    public Pose relativeTo(Pose frame) {
        double[] r = Checks.present("frame", frame).attitude;
        double[] inverse = new double[9];
        for (int k = 0; k < 9; k++) {
            inverse[3 * (k % 3) + k / 3] = r[k];
        }
        double[] turned = Attitude.identity();
        double[] product = new double[9];
        Rotations.multiply(inverse, 0, attitude, 0, product, 0);
        Attitude.orient(turned, 0, product);
        double[] way = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            way[axis] = (coordinate(axis) - frame.coordinate(axis)) + (lost[axis] - frame.lost[axis]);
        }
        double[] place = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            int row = 3 * axis;
            place[axis] = inverse[row] * way[0] + inverse[row + 1] * way[1] + inverse[row + 2] * way[2];
        }
        return new Pose(new Point(place[0], place[1], place[2]), turned);
    }

    private double coordinate(int axis) {
        return axis == 0 ? center.x() : axis == 1 ? center.y() : center.z();
    }

    /** This pose turned in place by {@code ry} degrees about its own Y, then by {@code rx} about its own X. */
    public Pose turned(double rx, double ry) {
        double[] turned = attitude.clone();
        Attitude.turn(turned, 0, Checks.angle("rx", rx), Checks.angle("ry", ry));
        return new Pose(center, turned, lost);
    }

    /** This centre with another rotation, which is kept as given. */
    public Pose oriented(double[] rotation) {
        Checks.present("rotation", rotation);
        if (rotation.length != 9 || !Attitude.isRotation(rotation)) {
            throw new IllegalArgumentException(
                    "rotation must be 9 numbers, row-major, whose columns are right-handed and orthonormal to 1e-9"
                            + " (got: " + Arrays.toString(rotation) + ")");
        }
        double[] oriented = Attitude.identity();
        Attitude.orient(oriented, 0, rotation);
        return new Pose(center, oriented, lost);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Pose that
                && center.equals(that.center)
                && Arrays.equals(attitude, 0, 9, that.attitude, 0, 9);
    }

    @Override
    public int hashCode() {
        return 31 * center.hashCode() + Arrays.hashCode(rotation());
    }

    @Override
    public String toString() {
        String place = "(" + center.x() + ", " + center.y() + ", " + center.z() + ")";
        return isUpright() ? place + " heading " + heading() : place + " rotation " + Arrays.toString(rotation());
    }
}
