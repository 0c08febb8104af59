package robosim.geometry.dynamics.spatial;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.dynamics.planar.ContactLog;
import robosim.geometry.engine.objects.ObjectTable;

/**
 * A rigid body: where it is, how it moves, and its inertia. A velocity is six numbers: m/s along the world's axes, then
 * radians a second about them.
 */
final class RigidBody implements Cloneable {
    final int id;
    final double mass;

    /** Moments of inertia about the own axes. */
    final double[] moments;

    /** Whether it is a sphere, which turns in itself. */
    final boolean isBall;

    /** No point of it is farther from its centre. */
    final double reach;

    double damping;
    double turnDamping;
    double maxSpeed = Double.POSITIVE_INFINITY;
    double maxTurn = Double.POSITIVE_INFINITY;

    /** Its own friction with what carries it is at least this. */
    double floorFriction;

    /** Quadratic drag, kg/m, and rolling resistance, a share of the load. */
    double drag;

    double rolling;

    /** A force and a torque that act on it now, and whether they do. */
    double[] push = new double[6];

    boolean isPushed;

    /** Whether it has a drive, whether that moves it, and whether it stood on its wheels in the last slice. */
    boolean isDriven;

    boolean isDriving;
    boolean isOnWheels;

    /** Whether a drive moves it or what it touched in the last slice, directly or not. */
    boolean isPressed;

    /** What its drive does in this slice, joules, and of that what is still to come. */
    double work;

    double lastWork;

    /** What contacts may lend its group in this slice, joules, the most that they may have lent, and what they have. */
    double lends;

    double mostLent;
    double lent;

    /** Where it is, laid out as in the table of objects. */
    double[] place = new double[ObjectTable.PLACE];

    /** The velocity now, and that at the end of a slice. */
    double[] v = new double[6];

    double[] u = new double[6];

    /** Of the change from one to the other, what moving bodies give it, and take the opposite of, in the rest of a slice. */
    double[] given = new double[6];

    /** The moving body on which its drive acts, and of what that one is given, the opposite of this drive's impulses. */
    @Nullable
    RigidBody carrier;

    double[] reaction = new double[6];

    /** What the body itself gets by these. */
    double[] driven = new double[6];

    /**
     * The angular momentum about a point that it got in this part of a slice of impulses between moving bodies, and of being
     * moved otherwise than by its velocity. Of a group it adds up to what bodies ought not to give each other.
     */
    double[] exchanged = new double[3];

    /** The inverse of the inertia about the world's axes. */
    double[] inverse = new double[9];

    /** Kinetic energy when the slice began, the centre, the velocity, and the angular momentum about the centre. */
    double energy;

    double[] start = new double[3];
    double[] began = new double[6];
    double[] spun = new double[3];

    /** The velocity before a collision that another body has. */
    double[] known = new double[6];

    /** Which bodies share their energy in this slice: the index of one of them. */
    int group;

    boolean isTouching;

    /** Whether it touches what stands still in this slice. */
    boolean isHeld;

    /** Whether it has met a moving body of another cluster in this slice, which has the opposite of what this one got. */
    boolean isAmongOthers;

    boolean isCarried;

    /** In how many slices in a row it has waited for another body. */
    int waits;

    boolean isAsleep;

    /** Why it was stopped in this step, and the object that stopped it; null if it was not, below 0 if that is unknown. */
    ContactLog.@Nullable Cause stop;

    int stopper;

    /** How long it has been slow, seconds. */
    double slow;

    private double[] own = new double[3];
    private double[] got = new double[6];

    RigidBody(int id, double mass, double[] moments, boolean isBall, double reach) {
        this.id = id;
        this.mass = mass;
        this.moments = moments.clone();
        this.isBall = isBall;
        this.reach = reach;
    }

    /** A body in the same state, which goes on by itself. */
    RigidBody copy() {
        try {
            RigidBody copy = (RigidBody) clone();
            copy.place = place.clone();
            copy.v = v.clone();
            copy.u = u.clone();
            copy.given = given.clone();
            copy.push = push.clone();
            copy.reaction = reaction.clone();
            copy.driven = driven.clone();
            copy.exchanged = exchanged.clone();
            copy.inverse = inverse.clone();
            copy.start = start.clone();
            copy.began = began.clone();
            copy.spun = spun.clone();
            copy.known = known.clone();
            copy.own = own.clone();
            copy.got = got.clone();
            return copy;
        } catch (CloneNotSupportedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Lets a time begin in which nothing has been given yet. */
    void begin() {
        carrier = null;
        Arrays.fill(given, 0);
        Arrays.fill(reaction, 0);
        Arrays.fill(driven, 0);
    }

    /** Leaves a share of what is given in the rest of a time. */
    void keep(double share) {
        for (int k = 0; k < 6; k++) {
            given[k] *= share;
            reaction[k] *= share;
            driven[k] *= share;
        }
    }

    /**
     * Adds to what is exchanged a share of what is given, on the way from a place to the present one.
     *
     * @param to    the velocity with which the way ends
     * @param about what angular momenta are about
     */
    void exchange(double[] from, double[] to, double share, double[] about) {
        for (int k = 0; k < 6; k++) {
            got[k] = share * (given[k] + driven[k]);
        }
        spin(from, got, own);
        for (int k = 0; k < 3; k++) {
            int y = (k + 1) % 3;
            int z = (k + 2) % 3;
            double farY = 0.5 * (from[y] + place[y]) - about[y];
            double farZ = 0.5 * (from[z] + place[z]) - about[z];
            double aside = (place[y] - from[y]) * (v[z] + to[z]) - (place[z] - from[z]) * (v[y] + to[y]);
            exchanged[k] += own[k] + mass * (farY * got[z] - farZ * got[y] + 0.5 * aside);
        }
    }

    /** Takes the impulses of its drive in the rest of a time back from what carries it; the drive will act anew. */
    void release() {
        RigidBody on = carrier;
        if (on != null) {
            for (int k = 0; k < 6; k++) {
                on.u[k] -= reaction[k];
                on.given[k] -= reaction[k];
            }
        }
        carrier = null;
        Arrays.fill(reaction, 0);
        Arrays.fill(driven, 0);
    }

    /** Lets what pushes it, and quadratic drag, change the velocity that it has at the end of a time: the midpoint rule. */
    void resist(double seconds) {
        if (isPushed) {
            for (int axis = 0; axis < 3; axis++) {
                u[axis] += push[axis] / mass * seconds;
                int row = 3 * axis;
                u[3 + axis] +=
                        (inverse[row] * push[3] + inverse[row + 1] * push[4] + inverse[row + 2] * push[5]) * seconds;
            }
        }
        if (drag > 0 && !(isDriven && isTouching)) {
            double half = halfDrag(1, 0, seconds);
            half = halfDrag(1 / (1 + half), half, seconds);
            for (int axis = 0; axis < 3; axis++) {
                u[axis] = (u[axis] - half * v[axis]) / (1 + half);
            }
        }
    }

    /** Half of what drag takes in a time at the speed halfway, as a share; where the end has a share of u, less a share of v. */
    private double halfDrag(double share, double less, double seconds) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double twice = v[axis] + share * (u[axis] - less * v[axis]);
            square += twice * twice;
        }
        return Math.min(1, 0.25 * drag / mass * Math.sqrt(square) * seconds);
    }

    /** The acceleration by what pushes it, m/s^2. */
    double pushed() {
        return isPushed ? length(push, 0) / mass : 0;
    }

    /** The work of what pushes it since the slice began, in a time. */
    double pushWork(double seconds) {
        double work = 0;
        for (int axis = 0; isPushed && axis < 3; axis++) {
            work += push[axis] * (place[axis] - start[axis])
                    + 0.5 * push[3 + axis] * (began[3 + axis] + v[3 + axis]) * seconds;
        }
        return work;
    }

    /** Works out the inverse inertia at the present attitude. */
    void turnInertia() {
        for (int i = 0; i < 3; i++) {
            for (int j = i; j < 3; j++) {
                double sum = 0;
                for (int k = 0; k < 3; k++) {
                    sum += place[3 + 3 * i + k] * place[3 + 3 * j + k] / moments[k];
                }
                inverse[3 * i + j] = sum;
                inverse[3 * j + i] = sum;
            }
        }
    }

    /** The angular velocity at another attitude with the angular momentum that it has at this one; writes three numbers. */
    void keepMomentum(double[] from, double[] velocity, double[] to, double[] out, int at) {
        spin(from, velocity, own);
        double lx = own[0];
        double ly = own[1];
        double lz = own[2];
        for (int k = 0; k < 3; k++) {
            own[k] = (to[3 + k] * lx + to[6 + k] * ly + to[9 + k] * lz) / moments[k];
        }
        for (int row = 0; row < 3; row++) {
            int r = 3 + 3 * row;
            out[at + row] = to[r] * own[0] + to[r + 1] * own[1] + to[r + 2] * own[2];
        }
    }

    /** The angular momentum about its centre in the world's axes, by way of its own ones; writes three numbers. */
    void spin(double[] at, double[] velocity, double[] out) {
        double lx = 0;
        double ly = 0;
        double lz = 0;
        for (int k = 0; k < 3; k++) {
            double along = at[3 + k] * velocity[3] + at[6 + k] * velocity[4] + at[9 + k] * velocity[5];
            double momentum = moments[k] * along;
            lx += at[3 + k] * momentum;
            ly += at[6 + k] * momentum;
            lz += at[9 + k] * momentum;
        }
        out[0] = lx;
        out[1] = ly;
        out[2] = lz;
    }

    /** Kinetic energy at a velocity. */
    double kinetic(double[] velocity) {
        double turning = 0;
        for (int k = 0; k < 3; k++) {
            double along = place[3 + k] * velocity[3] + place[6 + k] * velocity[4] + place[9 + k] * velocity[5];
            turning += moments[k] * along * along;
        }
        return 0.5
                * (mass * (velocity[0] * velocity[0] + velocity[1] * velocity[1] + velocity[2] * velocity[2])
                        + turning);
    }

    /** How high it is, against gravity, times that. */
    double height(double[] gravity) {
        return -(gravity[0] * place[0] + gravity[1] * place[1] + gravity[2] * place[2]);
    }

    /** The potential energy that it has gained in this slice. */
    double risen(double[] gravity) {
        return -mass
                * (gravity[0] * (place[0] - start[0])
                        + gravity[1] * (place[1] - start[1])
                        + gravity[2] * (place[2] - start[2]));
    }

    /** The most at which any point of it moves. */
    double speed(double[] velocity) {
        return length(velocity, 0) + reach * length(velocity, 3);
    }

    static double length(double[] of, int at) {
        return Math.sqrt(of[at] * of[at] + of[at + 1] * of[at + 1] + of[at + 2] * of[at + 2]);
    }

    /** Slows it by its damping, unless it is for its drive to do that, and holds it within its limits. */
    void limit(double seconds) {
        if (!isDriven || !isOnWheels) {
            scale(v, 0, 1 / (1 + damping * seconds));
            scale(v, 3, 1 / (1 + turnDamping * seconds));
        }
        isOnWheels = false;
        double speed = length(v, 0);
        if (speed > maxSpeed) {
            scale(v, 0, maxSpeed / speed);
        }
        double turn = length(v, 3);
        if (turn > maxTurn) {
            scale(v, 3, maxTurn / turn);
        }
    }

    private static void scale(double[] of, int at, double by) {
        if (by != 1) {
            of[at] *= by;
            of[at + 1] *= by;
            of[at + 2] *= by;
        }
    }

    void wake() {
        isAsleep = false;
        slow = 0;
    }

    void sleep() {
        isAsleep = true;
        lent = 0;
        Arrays.fill(v, 0);
        Arrays.fill(u, 0);
        Arrays.fill(given, 0);
        Arrays.fill(reaction, 0);
    }
}
