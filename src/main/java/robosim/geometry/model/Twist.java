package robosim.geometry.model;

import java.util.Arrays;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.Degrees;

/**
 * A velocity that stays constant in the frame of whatever moves: a robot drives straight ahead, along a circle, or turns in
 * place. (A twist with an angular part about one axis; Lynch and Park 2017, 3.3.)
 *
 * <pre>{@code
 * Twist drive = new Twist(0.8, 0, 0, 30);              // ahead at 0.8 m/s, in a curve to the left
 * Pose later = drive.after(Pose.of(new Point(), 0), 3);
 * later.heading();                                      // 90
 * }</pre>
 *
 * @param x  world units a second along the own X: forward
 * @param y  world units a second along the own Y: up
 * @param z  world units a second along the own Z: to the right
 * @param ry degrees a second about the own Y, counter-clockwise seen from above
 */
public record Twist(double x, double y, double z, double ry) {

    /** Below this many degrees, the chord of an arc is as long as the arc, to the last bit. */
    private static final double STRAIGHT = 1e-7;

    /** Refuses values that are NaN or infinite, and velocities beyond 2<sup>100</sup>. */
    public Twist {
        x = Checks.coordinate("x", x);
        y = Checks.coordinate("y", y);
        z = Checks.coordinate("z", z);
        ry = Checks.angle("ry", ry);
    }

    /** A velocity forward, and one of the heading, as a robot with two driven wheels has them. */
    public static Twist drive(double forward, double degrees) {
        return new Twist(forward, 0, 0, degrees);
    }

    /**
     * Where a pose is some time later.
     *
     * @param seconds negative for earlier
     * @throws IllegalArgumentException if that is beyond 2<sup>100</sup>
     */
    public Pose after(Pose start, double seconds) {
        double[] place = new double[Pose.PLACE];
        Checks.present("start", start).place(place, 0);
        check(seconds, place[0], place[1], place[2]);
        after(place, 0, seconds, place);
        return Pose.of(place, 0);
    }

    /** Refuses a time at which what is at a place now would be out of the range of coordinates. */
    public void check(double seconds, double fromX, double fromY, double fromZ) {
        double farthest = Math.max(Math.abs(fromX), Math.max(Math.abs(fromY), Math.abs(fromZ)));
        double path = (Math.abs(x) + Math.abs(y) + Math.abs(z)) * Math.abs(seconds);
        if (!(farthest + 2 * path <= Checks.LIMIT) || !Double.isFinite(ry * seconds)) {
            throw new IllegalArgumentException(
                    "seconds must be a time at which coordinates are within 2^100 and the angle is finite (got: "
                            + seconds + " with " + this + ")");
        }
    }

    /**
     * The same for the {@link Pose#PLACE} numbers of a pose, without a check.
     *
     * @param from where its numbers begin
     * @param out  takes the numbers, from 0 on; may be the same array if {@code from} is 0
     */
    public void after(double[] place, int from, double seconds, double[] out) {
        double turn = ry * seconds;
        // The chord of the arc points half the turn to the side.
        double half = turn / 2;
        double sin = Degrees.sin(half);
        double cos = Degrees.cos(half);
        double time = Math.abs(half) < STRAIGHT ? seconds : seconds * (sin / Degrees.toRadians(half));
        double forward = time * (x * cos + z * sin);
        double up = seconds * y;
        double right = time * (z * cos - x * sin);
        int r = from + 3;
        double cx = place[from] + (place[r] * forward + place[r + 1] * up + place[r + 2] * right);
        double cy = place[from + 1] + (place[r + 3] * forward + place[r + 4] * up + place[r + 5] * right);
        double cz = place[from + 2] + (place[r + 6] * forward + place[r + 7] * up + place[r + 8] * right);
        boolean isThere = cx == place[from] && cy == place[from + 1] && cz == place[from + 2];
        System.arraycopy(place, from, out, 0, Pose.PLACE);
        if (!isThere) {
            Arrays.fill(out, Pose.LOST, Pose.PLACE, 0); // only whole poses keep what rounding takes
        }
        out[0] = cx;
        out[1] = cy;
        out[2] = cz;
        Attitude.turn(out, 3, 0, turn);
    }
}
