package robosim.geometry.dynamics.spatial;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Radians;

/**
 * How one driven body stands on what is below it, and the impulses that its drive gives in a part of a slice: forward, to the
 * right, and about the normal of the ground.
 */
final class Wheels {
    /** Wheels that move across their way more quickly than this slide, m/s. */
    private static final double STICK = 1e-4;

    private RigidBody body;

    /** What carries it; null if that stands still. */
    private @Nullable RigidBody support;

    final double[] up = new double[3];
    private final double[] forward = new double[3];
    private final double[] right = new double[3];
    private final double[] axis = new double[3];

    /** The most that friction can give now. */
    double grip;

    boolean isSliding;
    private boolean isForce;
    private boolean isAnyWay;

    // Velocities to reach, and what a change of each by one takes.
    private double forwardTo;
    private double rightTo;
    private double turnTo;
    private double forwardEase;
    private double rightEase;
    private double turnEase;

    // Impulses that hold it on a slope or that a force gives, and by how much others may differ from these.
    private double forwardHold;
    private double rightHold;
    private double turnHold;
    private double reach;
    private double turnReach;

    /** From the middle to each of two rims, and the impulse along one that stands for a unit of angular impulse. */
    private double rim;

    private double spinShare;

    /** The arm at which friction resists turning. */
    private double arm;

    // Impulses so far.
    private double push;
    private double aside;
    private double spin;

    Wheels(RigidBody body) {
        this.body = body;
    }

    /** Stands on something, whose normal is in {@link #up}, not yet of unit length. */
    void begin(RigidBody on, @Nullable RigidBody carrier) {
        body = on;
        support = carrier;
        on.carrier = carrier;
        push = 0;
        aside = 0;
        spin = 0;
        grip = 0;
        double size = RigidBody.length(up, 0);
        double[] place = on.place;
        for (int k = 0; k < 3; k++) {
            up[k] /= size;
            right[k] = place[3 + 3 * k + 2];
        }
        // Wheels roll across their axles, along the ground.
        cross(up, right, forward);
        size = RigidBody.length(forward, 0);
        for (int k = 0; k < 3; k++) {
            forward[k] /= size;
        }
        cross(forward, up, right);
    }

    private static void cross(double[] a, double[] b, double[] out) {
        out[0] = a[1] * b[2] - a[2] * b[1];
        out[1] = a[2] * b[0] - a[0] * b[2];
        out[2] = a[0] * b[1] - a[1] * b[0];
    }

    /** Asks the drive what it aims at for the end of a time, in which gravity pulls. */
    void aim(int b, Driver driver, Driver.Aim aim, double seconds, double[] gravity) {
        double goes = speed(forward, false);
        double slips = speed(right, false);
        double turns = turning(false);
        aim.set(goes, slips, turns);
        driver.next(b, aim, seconds);
        isForce = aim.isForce;
        isAnyWay = aim.isAnyWay;
        isSliding = !isAnyWay && Math.abs(slips) > STICK;
        forwardTo = aim.forward;
        rightTo = aim.right;
        turnTo = aim.turn;
        // Where its axes will point in the end, so that it goes along the chord of its arc meanwhile.
        turnAxes((0.5 * (turns + turnTo) + (support == null ? 0 : spin(support, false))) * seconds);
        forwardEase = 1 / lightness(forward);
        rightEase = 1 / lightness(right);
        turnEase = 1 / turnLightness();
        double yaw = 1 / about(body, up);
        arm = 2.0 / 3 * Math.sqrt(2 * yaw / body.mass);
        if (isForce) {
            forwardHold = body.mass * (forwardTo - goes);
            rightHold = body.mass * (rightTo - slips);
            turnHold = yaw * (turnTo - turns);
        } else {
            forwardHold = -body.mass * dot(gravity, forward) * seconds;
            rightHold = -body.mass * dot(gravity, right) * seconds;
            turnHold = 0;
            rim = aim.rim;
            spinShare = body.mass * rim / yaw;
            reach = body.mass * aim.acceleration * seconds;
            turnReach = yaw * aim.turnAcceleration * seconds;
        }
    }

    private void turnAxes(double angle) {
        double sin = Radians.sin(angle);
        double cos = Radians.cos(angle);
        for (int k = 0; k < 3; k++) {
            double f = forward[k];
            double r = right[k];
            forward[k] = f * cos - r * sin;
            right[k] = r * cos + f * sin;
        }
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /** How fast the body goes along a direction, as seen from what carries it. */
    private double speed(double[] along, boolean atEnd) {
        double[] v = atEnd ? body.u : body.v;
        double own = dot(v, along);
        RigidBody on = support;
        if (on == null) {
            return own;
        }
        double[] w = atEnd ? on.u : on.v;
        arm(on, along);
        return own - dot(w, along) - (w[3] * axis[0] + w[4] * axis[1] + w[5] * axis[2]);
    }

    /** The moment of a direction, at the centre of the body, about that of what carries it. */
    private void arm(RigidBody on, double[] along) {
        double x = body.place[0] - on.place[0];
        double y = body.place[1] - on.place[1];
        double z = body.place[2] - on.place[2];
        axis[0] = y * along[2] - z * along[1];
        axis[1] = z * along[0] - x * along[2];
        axis[2] = x * along[1] - y * along[0];
    }

    private double spin(RigidBody of, boolean atEnd) {
        double[] v = atEnd ? of.u : of.v;
        return v[3] * up[0] + v[4] * up[1] + v[5] * up[2];
    }

    private double turning(boolean atEnd) {
        double own = spin(body, atEnd);
        return support == null ? own : own - spin(support, atEnd);
    }

    private double lightness(double[] along) {
        RigidBody on = support;
        if (on == null) {
            return 1 / body.mass;
        }
        arm(on, along);
        return 1 / body.mass + 1 / on.mass + about(on, axis);
    }

    private double turnLightness() {
        double own = about(body, up);
        return support == null ? own : own + about(support, up);
    }

    /** By how much a torque about an axis changes the speed of turning about it. */
    private static double about(RigidBody of, double[] n) {
        double[] i = of.inverse;
        return n[0] * (i[0] * n[0] + i[1] * n[1] + i[2] * n[2])
                + n[1] * (i[3] * n[0] + i[4] * n[1] + i[5] * n[2])
                + n[2] * (i[6] * n[0] + i[7] * n[1] + i[8] * n[2]);
    }

    /** Gives impulses toward what the drive aims at; answers by how much that changes a velocity. */
    double roll() {
        double f = isForce ? forwardHold : push + (forwardTo - speed(forward, true)) * forwardEase;
        double r = isForce ? rightHold : aside + (rightTo - speed(right, true)) * rightEase;
        double t = isForce ? turnHold : spin + (turnTo - turning(true)) * turnEase;
        if (!isForce) {
            t = Math.max(-turnReach, Math.min(turnReach, t));
            if (rim > 0 && reach < Double.POSITIVE_INFINITY) {
                // Each of the two rims has its own limit, so that what both give goes straight ahead.
                double turning = t * spinShare;
                double leftRim = clamp(f - forwardHold - turning);
                double rightRim = clamp(f - forwardHold + turning);
                f = forwardHold + 0.5 * (leftRim + rightRim);
                t = 0.5 * (rightRim - leftRim) / spinShare;
            }
            double beyond = f - forwardHold;
            double across = r - rightHold;
            double size = isAnyWay ? Math.sqrt(beyond * beyond + across * across) : Math.abs(beyond);
            if (size > reach) {
                f = forwardHold + beyond * (reach / size);
                r = isAnyWay ? rightHold + across * (reach / size) : r;
            }
        }
        double size = Math.sqrt(f * f + r * r);
        if (size > grip) {
            f *= grip / size;
            r *= grip / size;
        }
        double most = grip * arm;
        t = Math.max(-most, Math.min(most, t));
        double byForward = f - push;
        double byRight = r - aside;
        double byTurn = t - spin;
        push = f;
        aside = r;
        spin = t;
        give(forward, byForward);
        give(right, byRight);
        twist(body.inverse, up, byTurn, body.u);
        if (support != null) {
            twist(body.inverse, up, byTurn, body.driven);
            twistBack(support, up, byTurn);
        }
        if (body.isBall) {
            standUpright();
        }
        return Math.max(
                Math.max(Math.abs(byForward) / forwardEase, Math.abs(byRight) / rightEase),
                Math.abs(byTurn) / turnEase * body.reach);
    }

    private double clamp(double impulse) {
        return Math.max(-reach, Math.min(reach, impulse));
    }

    private void give(double[] along, double impulse) {
        for (int k = 0; k < 3; k++) {
            body.u[k] += impulse / body.mass * along[k];
        }
        RigidBody on = support;
        if (on != null) {
            for (int k = 0; k < 3; k++) {
                body.driven[k] += impulse / body.mass * along[k];
                react(on, k, -impulse / on.mass * along[k]);
            }
            arm(on, along);
            twistBack(on, axis, impulse);
        }
    }

    private void twistBack(RigidBody on, double[] n, double impulse) {
        double[] i = on.inverse;
        for (int k = 0; k < 3; k++) {
            react(on, 3 + k, -impulse * (i[3 * k] * n[0] + i[3 * k + 1] * n[1] + i[3 * k + 2] * n[2]));
        }
    }

    /** Changes a velocity of what carries the body. */
    private void react(RigidBody on, int k, double by) {
        on.u[k] += by;
        on.given[k] += by;
        body.reaction[k] += by;
    }

    private static void twist(double[] i, double[] n, double impulse, double[] v) {
        for (int k = 0; k < 3; k++) {
            v[3 + k] += impulse * (i[3 * k] * n[0] + i[3 * k + 1] * n[1] + i[3 * k + 2] * n[2]);
        }
    }

    /** A sphere stands on a point, and its wheels keep it from rolling over. */
    private void standUpright() {
        double turns = spin(body, true);
        for (int k = 0; k < 3; k++) {
            body.u[3 + k] = turns * up[k];
        }
    }

    /** The work of these impulses: each times the mean of the speeds before and after. */
    double work() {
        return 0.5
                * (push * (speed(forward, false) + speed(forward, true))
                        + aside * (speed(right, false) + speed(right, true))
                        + spin * (turning(false) + turning(true)));
    }
}
