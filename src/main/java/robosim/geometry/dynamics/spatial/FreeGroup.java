package robosim.geometry.dynamics.spatial;

import java.util.Arrays;
import java.util.List;
import robosim.geometry.engine.motion.Placer;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Pose;

/**
 * Bodies that touch each other: whatever they do to each other, their momentum stays, and their angular momentum about their
 * common centre of mass.
 *
 * <p>Of all motions with these two, the one as a single rigid body has the least energy, and what any other has above that is
 * the energy of the deviation from it. So energy is taken from the deviation, which changes neither momentum.
 */
final class FreeGroup {
    /** Shifts of a body alone and of a group that are rounding, metres. */
    private static final double ROUNDING = 1e-13;

    private static final double LEAST_SHIFT = 1e-15;

    /** Energy that a body alone may gain in a slice by rounding, as a share of what it has. */
    private static final double MOST_EXCESS = 1e-12;

    /** Radians: what integration adds to the energy in a slice takes far smaller turns back. */
    private static final double MOST_TURN = 1e-5;

    private final List<RigidBody> bodies;
    private final double[] gravity;
    private final Placer placer;
    private final ContactDetection detection;
    private final double[] centre = new double[3];
    private final double[] drift = new double[3];
    private final double[] from = new double[3];
    private final double[] fromDrift = new double[3];
    private final double[] before = new double[3];
    private final double[] after = new double[3];
    private final double[] spin = new double[3];
    private final double[] turn = new double[3];

    /** The inertia about the centre: XX, YY, ZZ, YZ, ZX, XY. */
    private final double[] inertia = new double[6];

    private final RotationVectors turning = new RotationVectors();
    private final double[] turned = new double[ObjectTable.PLACE];
    // By group, its first body; by body, the next one of its group, or -1.
    private int[] first = new int[0];
    private int[] next = new int[0];
    private double mass;
    private int count;
    private boolean isDriven;
    private boolean isAmongOthers;
    private boolean isHeld;

    FreeGroup(List<RigidBody> bodies, double[] gravity, Placer placer, ContactDetection detection) {
        this.bodies = bodies;
        this.gravity = gravity;
        this.placer = placer;
        this.detection = detection;
    }

    /** Lists the bodies of each group of a cluster that move, after the groups have changed. */
    void list(Clusters cluster) {
        if (first.length < bodies.size()) {
            first = new int[2 * bodies.size()];
            next = new int[2 * bodies.size()];
        }
        for (int m = 0; m < cluster.count; m++) {
            first[cluster.member[m]] = -1;
        }
        for (int m = cluster.count - 1; m >= 0; m--) {
            int b = cluster.member[m];
            if (!bodies.get(b).isAsleep) {
                int group = bodies.get(b).group;
                next[b] = first[group];
                first[group] = b;
            }
        }
    }

    /**
     * Puts the centre of a group where its momentum takes it in a time, gives it the angular momentum that it had when the slice
     * began, and takes the energy that is more than allowed.
     */
    void keep(int group, double seconds, double allowed) {
        if (next[first[group]] < 0 && isOnItsWay(bodies.get(first[group]), seconds, allowed)) {
            return; // as most bodies that fall
        }
        sum(group);
        if (!isDriven) {
            centre(group, seconds);
            for (int axis = 0; axis < 3; axis++) {
                spin[axis] = before[axis] - after[axis];
            }
            divide(spin, turn);
            for (int b = first[group]; b >= 0; b = next[b]) {
                add(bodies.get(b), 1);
            }
            System.arraycopy(before, 0, after, 0, 3);
        }
        divide(after, turn);
        double moving = 0;
        for (int b = first[group]; b >= 0; b = next[b]) {
            moving += bodies.get(b).kinetic(bodies.get(b).v);
        }
        double inner = moving - rigid();
        double excess = moving + risen(group) - allowed;
        if (count == 1) {
            if (!bodies.get(group).isPushed) {
                turnBack(bodies.get(group));
            }
            hold(bodies.get(group), allowed);
        } else if (excess > 0 && inner > 0) {
            scale(group, Math.sqrt(Math.max(0, inner - excess) / inner));
        }
    }

    /**
     * Turns a group back by the angular momentum that its bodies gave each other: impulses act where both were when they were
     * worked out, and who is kept off another one does not go where its velocity has it.
     */
    void takeBack(int group) {
        if (first[group] < 0 || next[first[group]] < 0) {
            return;
        }
        sum(group);
        if (!isAmongOthers && (isHeld || isDriven)) { // of all others, the momenta will be those that they had
            Arrays.fill(spin, 0);
            for (int b = first[group]; b >= 0; b = next[b]) {
                for (int axis = 0; axis < 3; axis++) {
                    spin[axis] -= bodies.get(b).exchanged[axis];
                }
            }
            keepUpright();
            divide(spin, turn);
            for (int b = first[group]; b >= 0; b = next[b]) {
                add(bodies.get(b), 1);
            }
        }
    }

    /** Leaves what is about the vertical: what holds a group gives it the rest. */
    private void keepUpright() {
        double pull = RigidBody.length(gravity, 0);
        if (pull > 0) {
            double about = (spin[0] * gravity[0] + spin[1] * gravity[1] + spin[2] * gravity[2]) / pull / pull;
            for (int axis = 0; axis < 3; axis++) {
                spin[axis] = about * gravity[axis];
            }
        }
    }

    /** Takes an energy from how the bodies of a group move otherwise than as a single one, and what that has not from all. */
    void brake(int group, double moving, double excess) {
        sum(group);
        divide(after, turn);
        double inner = count > 1 ? Math.max(0, moving - rigid()) : 0;
        double taken = Math.min(inner, excess);
        if (taken > 0) {
            scale(group, Math.sqrt((inner - taken) / inner));
        }
        if (taken < excess) {
            double share = excess < moving ? Math.sqrt((moving - excess) / (moving - taken)) : 0;
            for (int b = first[group]; b >= 0; b = next[b]) {
                scale(bodies.get(b), share);
            }
        }
    }

    /** The energy of a single rigid body with the momenta of the group. */
    private double rigid() {
        double rigid = 0;
        for (int axis = 0; axis < 3; axis++) {
            rigid += 0.5 * (mass * drift[axis] * drift[axis] + after[axis] * turn[axis]);
        }
        return rigid;
    }

    private static void scale(RigidBody body, double share) {
        for (int k = 0; k < 6; k++) {
            body.v[k] *= share;
        }
    }

    /** Whether a body alone does not turn, is where its velocity takes it, and has no more energy than allowed. */
    private boolean isOnItsWay(RigidBody body, double seconds, double allowed) {
        for (int axis = 0; axis < 3; axis++) {
            double way = 0.5 * (body.began[axis] + body.v[axis]) * seconds;
            if (body.v[3 + axis] != 0
                    || body.spun[axis] != 0
                    || !(Math.abs(body.start[axis] + way - body.place[axis]) <= 0.5 * ROUNDING)) {
                return false;
            }
        }
        double moving = body.kinetic(body.v);
        return moving + body.risen(gravity) - allowed <= MOST_EXCESS * moving;
    }

    /**
     * Shifts all bodies of a group by what some of them were delayed or had to make room. All else is farther from where they come
     * to than the shift is long, so they pass through nothing.
     */
    private void centre(int group, double seconds) {
        for (int axis = 0; axis < 3; axis++) {
            spin[axis] = from[axis] + 0.5 * (fromDrift[axis] + drift[axis]) * seconds - centre[axis];
        }
        double length = RigidBody.length(spin, 0);
        if (length > (count > 1 ? LEAST_SHIFT : ROUNDING) && !isShifted(group, 1, length)) {
            isShifted(group, -1, length);
        }
    }

    /** Shifts all bodies; whether all are free then, and all others farther away than a distance. */
    private boolean isShifted(int group, int sign, double distance) {
        boolean isFree = true;
        for (int b = first[group]; b >= 0; b = next[b]) {
            RigidBody body = bodies.get(b);
            for (int axis = 0; axis < 3; axis++) {
                body.place[axis] += sign * spin[axis];
            }
            placer.put(body.id, body.place);
        }
        for (int b = first[group]; b >= 0; b = next[b]) {
            RigidBody body = bodies.get(b);
            isFree = isFree && placer.isFree(body.id, body.place) && detection.isAlone(body, distance);
        }
        for (int axis = 0; axis < 3; axis++) {
            centre[axis] += sign * spin[axis];
        }
        return isFree;
    }

    /** The potential energy that a group has gained, where it is now. */
    private double risen(int group) {
        double risen = 0;
        for (int b = first[group]; b >= 0; b = next[b]) {
            risen += bodies.get(b).risen(gravity);
        }
        return risen;
    }

    /** Takes from the speed of a body alone what is more than allowed: it was delayed where it could not be put on its path. */
    private void hold(RigidBody body, double allowed) {
        double moving = body.kinetic(body.v);
        double excess = moving + body.risen(gravity) - allowed;
        if (excess > MOST_EXCESS * moving) {
            scale(body, Math.sqrt(Math.max(0, moving - excess) / moving));
        }
    }

    /**
     * Turns a body alone a little, such that its turn has the energy that it had, with the same angular momentum L: by a turn t,
     * the energy changes by the product of t and of w x L, if its angular velocity is w.
     */
    private void turnBack(RigidBody body) {
        double excess = 0.5 * (after[0] * turn[0] + after[1] * turn[1] + after[2] * turn[2]) - body.energy;
        for (int axis = 0; axis < 3; axis++) {
            excess += 0.5 * body.mass * body.began[axis] * body.began[axis];
        }
        if (Math.abs(excess) <= ROUNDING * body.energy) {
            return;
        }
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            int following = (axis + 1) % 3;
            int last = (axis + 2) % 3;
            spin[axis] = turn[following] * after[last] - turn[last] * after[following];
            square += spin[axis] * spin[axis];
        }
        double angle = Math.abs(excess) / Math.sqrt(square);
        if (!(angle < MOST_TURN)) {
            return; // about a main axis, or a ball: then the energy is that of the angular momentum
        }
        for (int axis = 0; axis < 3; axis++) {
            spin[axis] *= -excess / square;
        }
        turning.turn(body.place, spin, 1, turned);
        for (int axis = 0; axis < 3; axis++) {
            turned[axis] = body.place[axis];
            turned[Pose.LOST + axis] = body.place[Pose.LOST + axis];
        }
        if (detection.isAlone(body, body.reach * angle) && placer.isFree(body.id, turned)) {
            body.keepMomentum(body.place, body.v, turned, turn, 0);
            System.arraycopy(turn, 0, body.v, 3, 3);
            System.arraycopy(turned, 0, body.place, 0, Pose.PLACE);
            placer.put(body.id, body.place);
        }
    }

    /** Leaves a share of how bodies move otherwise than as a single rigid body. */
    private void scale(int group, double share) {
        for (int b = first[group]; b >= 0; b = next[b]) {
            RigidBody body = bodies.get(b);
            for (int k = 0; k < 6; k++) {
                body.v[k] = share * body.v[k] + (k < 3 ? (1 - share) * drift[k] : 0);
            }
            add(body, 1 - share);
        }
    }

    /** Adds a share of the turn about the centre to the velocity of a body. */
    private void add(RigidBody body, double share) {
        double x = body.place[0] - centre[0];
        double y = body.place[1] - centre[1];
        double z = body.place[2] - centre[2];
        body.v[0] += share * (turn[1] * z - turn[2] * y);
        body.v[1] += share * (turn[2] * x - turn[0] * z);
        body.v[2] += share * (turn[0] * y - turn[1] * x);
        for (int axis = 0; axis < 3; axis++) {
            body.v[3 + axis] += share * turn[axis];
        }
    }

    /** Works out the centre, its velocity, both angular momenta and the inertia of a group. */
    private void sum(int group) {
        mass = 0;
        count = 0;
        isDriven = false;
        isAmongOthers = false;
        isHeld = false;
        Arrays.fill(centre, 0);
        Arrays.fill(drift, 0);
        Arrays.fill(from, 0);
        Arrays.fill(fromDrift, 0);
        for (int b = first[group]; b >= 0; b = next[b]) {
            RigidBody body = bodies.get(b);
            mass += body.mass;
            count++;
            isDriven |= body.isDriven || body.isPushed || body.stop != null;
            isAmongOthers |= body.isAmongOthers || body.stop != null;
            isHeld |= body.isHeld;
            for (int axis = 0; axis < 3; axis++) {
                centre[axis] += body.mass * body.place[axis];
                drift[axis] += body.mass * body.v[axis];
                from[axis] += body.mass * body.start[axis];
                fromDrift[axis] += body.mass * body.began[axis];
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            centre[axis] /= mass;
            drift[axis] /= mass;
            from[axis] /= mass;
            fromDrift[axis] /= mass;
        }
        Arrays.fill(before, 0);
        Arrays.fill(after, 0);
        Arrays.fill(inertia, 0);
        for (int b = first[group]; b >= 0; b = next[b]) {
            RigidBody body = bodies.get(b);
            body.spin(body.place, body.v, spin);
            for (int axis = 0; axis < 3; axis++) {
                before[axis] += body.spun[axis];
                after[axis] += spin[axis];
            }
            orbit(body.mass, body.start, from, body.began, fromDrift, before);
            orbit(body.mass, body.place, centre, body.v, drift, after);
            addInertia(body);
        }
    }

    private static void orbit(double mass, double[] place, double[] centre, double[] v, double[] drift, double[] out) {
        for (int axis = 0; axis < 3; axis++) {
            int following = (axis + 1) % 3;
            int last = (axis + 2) % 3;
            out[axis] += mass
                    * ((place[following] - centre[following]) * (v[last] - drift[last])
                            - (place[last] - centre[last]) * (v[following] - drift[following]));
        }
    }

    private void addInertia(RigidBody body) {
        for (int axis = 0; axis < 3; axis++) {
            int following = (axis + 1) % 3;
            int last = (axis + 2) % 3;
            double y = body.place[following] - centre[following];
            double z = body.place[last] - centre[last];
            inertia[axis] += body.mass * (y * y + z * z);
            inertia[3 + axis] -= body.mass * y * z;
            for (int k = 0; k < 3; k++) {
                double along = body.place[3 + 3 * axis + k];
                inertia[axis] += body.moments[k] * along * along;
                inertia[3 + axis] += body.moments[k] * body.place[3 + 3 * following + k] * body.place[3 + 3 * last + k];
            }
        }
    }

    /** The turn of the group as a single rigid body that has an angular momentum (Cramer's rule). */
    private void divide(double[] momentum, double[] out) {
        double[] i = inertia;
        double yz = i[3];
        double zx = i[4];
        double xy = i[5];
        double a = i[1] * i[2] - yz * yz;
        double b = yz * zx - xy * i[2];
        double c = xy * yz - i[1] * zx;
        double determinant = i[0] * a + xy * b + zx * c;
        double d = i[0] * i[2] - zx * zx;
        double e = xy * zx - i[0] * yz;
        double f = i[0] * i[1] - xy * xy;
        out[0] = (a * momentum[0] + b * momentum[1] + c * momentum[2]) / determinant;
        out[1] = (b * momentum[0] + d * momentum[1] + e * momentum[2]) / determinant;
        out[2] = (c * momentum[0] + e * momentum[1] + f * momentum[2]) / determinant;
    }
}
