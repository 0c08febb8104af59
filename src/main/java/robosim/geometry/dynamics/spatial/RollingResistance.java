package robosim.geometry.dynamics.spatial;

import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Angular impulses against rolling: at each contact at most the load times the lever times the coefficient of the body, so that
 * a ball that rolls slows evenly and comes to rest, and one that a slope pulls by less stays where it is.
 */
final class RollingResistance {
    private final List<RigidBody> bodies;

    /** By contact: the coefficient times the lever, metres; 0 for none. */
    private double[] lever = new double[0];

    /** What a change of the turn by one takes, and what has been given, three numbers each. */
    private double[] ease = new double[0];

    private double[] given = new double[0];
    private boolean any;
    private final double[] by = new double[3];

    RollingResistance(List<RigidBody> bodies) {
        this.bodies = bodies;
    }

    /** Begins with so many contacts. */
    void begin(int count) {
        any = false;
        if (lever.length < count) {
            lever = new double[2 * count];
            ease = new double[2 * count];
            given = new double[6 * count];
        }
    }

    /** Takes up a contact. */
    void prepare(Contacts c, int k) {
        RigidBody body = bodies.get(c.body[k]);
        RigidBody other = moving(c, k);
        lever[k] = Math.max(lever(body, c, k), other == null ? 0 : lever(other, c, k));
        if (lever[k] > 0) {
            any = true;
            // Of a ball that of its inertia; of all others at most that about any axis, so that impulses converge.
            ease[k] = 1 / (lightness(body) + (other == null ? 0 : lightness(other)));
            Arrays.fill(given, 3 * k, 3 * k + 3, 0);
        }
    }

    private static double lever(RigidBody body, Contacts c, int k) {
        if (body.rolling == 0) {
            return 0;
        }
        double x = c.point[3 * k] - body.place[0];
        double y = c.point[3 * k + 1] - body.place[1];
        double z = c.point[3 * k + 2] - body.place[2];
        return body.rolling * Math.sqrt(x * x + y * y + z * z);
    }

    private static double lightness(RigidBody body) {
        double sum = body.inverse[0] + body.inverse[4] + body.inverse[8];
        return body.isAsleep ? 0 : body.isBall ? sum / 3 : sum;
    }

    /** What a contact is with, if that moves. */
    private @Nullable RigidBody moving(Contacts c, int k) {
        return c.other[k] < 0 || bodies.get(c.other[k]).isAsleep ? null : bodies.get(c.other[k]);
    }

    /** Resists at a contact that is pressed so much; answers by how much that changes a speed there. */
    double resist(Contacts c, int k, double pressed, boolean atEnd) {
        if (!any || lever[k] == 0) {
            return 0;
        }
        RigidBody body = bodies.get(c.body[k]);
        RigidBody other = moving(c, k);
        double[] v = atEnd ? body.u : body.v;
        double[] w = other == null ? null : atEnd ? other.u : other.v;
        double most = lever[k] * pressed;
        double size = 0;
        for (int axis = 0; axis < 3; axis++) {
            double turn = v[3 + axis] - (w == null ? 0 : w[3 + axis]);
            by[axis] = given[3 * k + axis] - turn * ease[k];
            size += by[axis] * by[axis];
        }
        double share = size > most * most ? most / Math.sqrt(size) : 1;
        double changed = 0;
        for (int axis = 0; axis < 3; axis++) {
            double to = share * by[axis];
            by[axis] = to - given[3 * k + axis];
            given[3 * k + axis] = to;
            changed += Math.abs(by[axis]);
        }
        turn(body, v, 1);
        if (other != null && w != null) {
            turn(other, w, -1);
            if (atEnd) {
                turn(body, body.given, 1);
                turn(other, other.given, -1);
            }
        }
        return changed / ease[k] * body.reach;
    }

    private void turn(RigidBody body, double[] v, double sign) {
        for (int axis = 0; axis < 3 && !body.isAsleep; axis++) {
            int row = 3 * axis;
            v[3 + axis] +=
                    sign * (body.inverse[row] * by[0] + body.inverse[row + 1] * by[1] + body.inverse[row + 2] * by[2]);
        }
    }
}
