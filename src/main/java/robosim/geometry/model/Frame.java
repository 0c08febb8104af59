package robosim.geometry.model;

import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;

/**
 * Coordinates of another program over the same world: the axes of ROS (REP 103), X forward, Y left and Z up, with angles in
 * <b>radians</b>. A point (x, y, z) of ROS is (x, z, -y) here; both systems are right-handed, so angles keep their sign and a
 * yaw is a heading. Lengths are the same in both.
 *
 * <p>A method named after a quantity converts from the world; one that begins with {@code world} converts back.
 *
 * <pre>{@code
 * Frame ros = Frame.ros(5, 4);                               // ROS's origin is a corner of a room of 10 x 8
 * ros.point(new Point(-5, 1.5, 4));                          // (0, 0, 1.5)
 * Frame.Pose2D place = ros.pose2D(Pose.of(new Point(1, 0, -2), 90)); // x 6, y 6, theta pi/2
 * ros.worldTwist(new Frame.Vectors(new Point(0.5, 0, 0), new Point(0, 0, 0.3))); // forward, and 17.2 degrees a second
 * }</pre>
 *
 * @param originX X, in the axes of ROS, at which the world's origin lies, world units
 * @param originY Y of the same
 */
public record Frame(double originX, double originY) {

    /**
     * A pose as {@code geometry_msgs/Pose} has it.
     *
     * @param position    world units
     * @param orientation from the object's own axes, X forward, Y left, Z up, to those of ROS
     */
    public record RosPose(Point position, Quaternion orientation) {
        /** Refuses null. */
        public RosPose {
            Checks.present("position", position);
            Checks.present("orientation", orientation);
        }
    }

    /**
     * A place on the floor.
     *
     * @param x     world units
     * @param y     world units
     * @param theta radians, counter-clockwise from X
     */
    public record Pose2D(double x, double y, double theta) {
        /** Refuses numbers that are NaN or infinite. */
        public Pose2D {
            x = Checks.coordinate("x", x);
            y = Checks.coordinate("y", y);
            Checks.radians("theta", theta);
        }
    }

    /**
     * Two vectors in the axes of ROS: a twist as {@code geometry_msgs/Twist} has it, or a wrench.
     *
     * @param linear  a velocity, world units a second; of a wrench, the force in newtons
     * @param angular radians a second; of a wrench, the torque in newton metres
     */
    public record Vectors(Point linear, Point angular) {
        /** Refuses null. */
        public Vectors {
            Checks.present("linear", linear);
            Checks.present("angular", angular);
        }
    }

    /** Refuses coordinates that are NaN, infinite or above 2<sup>100</sup>. */
    public Frame {
        originX = Checks.coordinate("originX", originX);
        originY = Checks.coordinate("originY", originY);
    }

    /** The frame of worlds imported from SDFormat or from ROS maps, which keep the origin of their file. */
    public static Frame ros() {
        return ros(0, 0);
    }

    /** The frame of ROS in which the world's origin, its centre, lies at these coordinates. */
    public static Frame ros(double originX, double originY) {
        return new Frame(originX, originY);
    }

    /** A direction, velocity, force or torque; the origin does not matter. */
    public Point vector(Point direction) {
        Checks.present("direction", direction);
        return new Point(direction.x(), 0 - direction.z(), direction.y());
    }

    /** The inverse of {@link #vector}. */
    public Point worldVector(Point direction) {
        Checks.present("direction", direction);
        return new Point(direction.x(), direction.z(), 0 - direction.y());
    }

    /** A place. */
    public Point point(Point place) {
        Point turned = vector(Checks.present("place", place));
        return new Point(turned.x() + originX, turned.y() + originY, turned.z());
    }

    /** The inverse of {@link #point}. */
    public Point worldPoint(Point place) {
        Checks.present("place", place);
        return worldVector(new Point(place.x() - originX, place.y() - originY, place.z()));
    }

    /** A pose; its quaternion has a w of at least 0. */
    public RosPose pose(Pose pose) {
        Quaternion q = Quaternion.of(Checks.present("pose", pose)).towards(Quaternion.NONE);
        return new RosPose(point(pose.center()), new Quaternion(q.x(), 0 - q.z(), q.y(), q.w()));
    }

    /** The inverse of {@link #pose}. */
    public Pose worldPose(RosPose pose) {
        Quaternion q = Checks.present("pose", pose).orientation();
        double[] rotation = new Quaternion(q.x(), q.z(), 0 - q.y(), q.w()).rotation();
        return Pose.of(worldPoint(pose.position()), 0).oriented(rotation);
    }

    /** Where on the floor something is; its height and its tilt are left out. */
    public Pose2D pose2D(Pose pose) {
        Point place = point(Checks.present("pose", pose).center());
        return new Pose2D(place.x(), place.y(), Degrees.toRadians(pose.heading()));
    }

    /** The inverse of {@link #pose2D}: an upright pose whose centre is at a height. */
    public Pose worldPose(Pose2D place, double height) {
        Checks.present("place", place);
        return Pose.of(worldPoint(new Point(place.x(), place.y(), height)), Degrees.toDegrees(place.theta()));
    }

    /** A velocity along a body's own axes, as odometry has it in its child frame. */
    public Vectors twist(Twist twist) {
        Checks.present("twist", twist);
        return new Vectors(
                vector(new Point(twist.x(), twist.y(), twist.z())), new Point(0, 0, Degrees.toRadians(twist.ry())));
    }

    /**
     * The inverse of {@link #twist}.
     *
     * @throws IllegalArgumentException if the angular velocity has a part about X or Y
     */
    public Twist worldTwist(Vectors twist) {
        Point about = Checks.present("twist", twist).angular();
        if (about.x() != 0 || about.y() != 0) {
            throw new IllegalArgumentException(
                    "angular must be about Z alone, since a Twist turns about the vertical (got: " + about + ")");
        }
        Point along = worldVector(twist.linear());
        return new Twist(along.x(), along.y(), along.z(), Degrees.toDegrees(about.z()));
    }

    /** A force and a torque. */
    public Vectors wrench(Point force, Point torque) {
        return new Vectors(vector(force), vector(torque));
    }

    /**
     * A box's length along X, width along Y and height along Z, from its width, height and length here: our width lies along X,
     * which is the length of a vehicle.
     */
    public Point box(double width, double height, double length) {
        return new Point(Checks.size("width", width), Checks.size("length", length), Checks.size("height", height));
    }

    /** The inverse of {@link #box}: width, height and length along our X, Y and Z. */
    public Point worldBox(double length, double width, double height) {
        return new Point(Checks.size("length", length), Checks.size("height", height), Checks.size("width", width));
    }
}
