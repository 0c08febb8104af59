package robosim.geometry.dynamics.space;

import robosim.geometry.engine.motion.Placer;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.Rotations;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * Carries a body straight on while it turns, as far as that is free.
 *
 * <p>What does not turn, or turns in itself as a sphere does, is carried by swept moves. Of anything else no point is farther
 * from the chord between its places before and after than {@code reach * angle^2 / 8}: the sagitta of its arc. So if one
 * direction separates both poses from a piece by more than that, the motion between them is free. Where a body rests, it is
 * first lifted by that much along the contact, by a swept move, then turned, and then let down by another one. The world
 * decides in the end whether the body is free where it has come to, exactly.
 */
final class Way {
    /** Bodies stop so many metres before contact. */
    static final double GAP = 1e-8;

    /** A way that turns ends where less than so many metres of it could be tried; what is nearer is there. */
    static final double THERE = 4e-6;

    private static final double LEAST = 1e-6;

    /** Most radians of a turn that are decided at once. */
    private static final double TURN = 0.25;

    /** Turning by less than so many metres at the rim is not made. */
    private static final double NOTHING = 1e-13;

    private static final int MOST_TRIES = 96;

    private final Placer placer;
    private final Nearby near;
    private final Meeting meeting = new Meeting();
    private final LeafColumn before = new LeafColumn(1);
    private final LeafColumn after = new LeafColumn(1);
    private final double[] place = new double[Pose.PLACE];
    private final double[] raised = new double[Pose.PLACE];
    private final double[] turn = new double[9];
    private final double[] rotation = new double[9];
    private final double[] up = new double[3];

    /** How much {@link #up} is to be, so that the way is free above what it touches. */
    private double lift;

    Way(Placer placer, Nearby near) {
        this.placer = placer;
        this.near = near;
    }

    /** Goes by a displacement, turning by a vector in radians; answers the share that was made. */
    double go(Rigid body, double[] d, double[] angle) {
        double way = Rigid.length(d, 0);
        double turned = Rigid.length(angle, 0);
        boolean turns = !body.isBall && turned * body.reach > NOTHING;
        if (!turns) {
            double share = way == 0 ? 1 : placer.toContact(body.id, d[0], d[1], d[2], GAP);
            read(body);
            if (body.isBall && turned > 0) {
                turn(body.place, angle, share, body.place);
                placer.put(body.id, body.place);
            }
            return share;
        }
        near.find(body, d[0], d[1], d[2], body.reach * 1.01 + 1e-3);
        double rest = 1;
        double step = Math.min(1, TURN / turned);
        double least = LEAST / (way + body.reach * turned);
        for (int tries = 0; rest > 0 && tries < MOST_TRIES; tries++) {
            step = Math.min(step, rest);
            if (isMade(body, d, angle, turned, step)) {
                rest = step == rest ? 0 : rest - step;
            } else {
                step *= 0.5;
                if (step < least) {
                    break;
                }
            }
        }
        return 1 - rest;
    }

    /** Takes over where the world has a body. */
    void read(Rigid body) {
        System.arraycopy(placer.objects.places(), placer.objects.place(body.id), body.place, 0, Pose.PLACE);
    }

    void turn(double[] from, double[] angle, double share, double[] to) {
        double size = Rigid.length(angle, 0);
        double half = 0.5 * size * share;
        double sine = size == 0 ? 0 : StrictMath.sin(half) / size;
        double w = StrictMath.cos(half);
        double x = sine * angle[0];
        double y = sine * angle[1];
        double z = sine * angle[2];
        turn[0] = 1 - 2 * (y * y + z * z);
        turn[1] = 2 * (x * y - w * z);
        turn[2] = 2 * (x * z + w * y);
        turn[3] = 2 * (x * y + w * z);
        turn[4] = 1 - 2 * (x * x + z * z);
        turn[5] = 2 * (y * z - w * x);
        turn[6] = 2 * (x * z - w * y);
        turn[7] = 2 * (y * z + w * x);
        turn[8] = 1 - 2 * (x * x + y * y);
        Rotations.multiply(turn, 0, from, 3, rotation, 0);
        Rotations.orthonormalise(rotation, 0);
        if (from != to) {
            System.arraycopy(from, 0, to, 0, Pose.PLACE);
        }
        Attitude.orient(to, 3, rotation);
    }

    private boolean isMade(Rigid body, double[] d, double[] angle, double turned, double share) {
        turn(body.place, angle, share, place);
        for (int axis = 0; axis < 3; axis++) {
            place[axis] = body.place[axis] + share * d[axis];
            place[Pose.LOST + axis] = 0;
        }
        near.leaf(body, body.place, before);
        near.leaf(body, place, after);
        double part = turned * share;
        double sagitta = body.reach * part * part / 8 * (1 + 1e-9);
        double moved = (Rigid.length(d, 0) + body.reach * turned) * share;
        if (isFree(sagitta, moved)) {
            if (!placer.isFree(body.id, place)) {
                return false;
            }
            take(body, place);
            return true;
        }
        return lift > 0 && isMadeAbove(body, sagitta);
    }

    private void take(Rigid body, double[] at) {
        System.arraycopy(at, 0, body.place, 0, Pose.PLACE);
        placer.put(body.id, body.place);
    }

    /** Whether the way is free as it is; if not, {@link #up} and {@link #lift} say how to make it free, if that may be. */
    private boolean isFree(double sagitta, double moved) {
        boolean isFree = true;
        lift = 0;
        up[0] = 0;
        up[1] = 0;
        up[2] = 0;
        for (int k = 0; k < near.count; k++) {
            if (!isPast(k, sagitta, moved)) {
                isFree = false;
                if (!meets(before, k)) {
                    lift = 0;
                    return false;
                }
                up[0] += meeting.nx;
                up[1] += meeting.ny;
                up[2] += meeting.nz;
            }
        }
        if (isFree) {
            return true;
        }
        double size = Rigid.length(up, 0);
        if (size < 0.1) {
            return false;
        }
        for (int axis = 0; axis < 3; axis++) {
            up[axis] /= size;
        }
        double most = 0;
        for (int k = 0; k < near.count; k++) {
            if (!isPast(k, sagitta, moved)) {
                meets(before, k);
                double nx = meeting.nx;
                double ny = meeting.ny;
                double nz = meeting.nz;
                double steep = nx * up[0] + ny * up[1] + nz * up[2];
                double room = Math.min(along(before, k, nx, ny, nz), along(after, k, nx, ny, nz));
                most = steep < 0.2 ? Double.POSITIVE_INFINITY : Math.max(most, (1.5 * sagitta + GAP - room) / steep);
            }
        }
        // More than the turn itself takes is a real collision.
        lift = most <= 8 * sagitta + 4 * GAP ? most : 0;
        return false;
    }

    private boolean meets(LeafColumn leaf, int k) {
        return meeting.measure(
                leaf.kind(0), leaf.rows(), 0, near.kind[k], near.rows, k * Leaf.STRIDE);
    }

    private double along(LeafColumn leaf, int k, double nx, double ny, double nz) {
        return meeting.along(leaf.kind(0), leaf.rows(), 0, near.kind[k], near.rows, k * Leaf.STRIDE, nx, ny, nz);
    }

    /** Whether one direction separates the body from a piece before and after by more than the sagitta. */
    private boolean isPast(int k, double sagitta, double moved) {
        if (!meets(after, k)) {
            return false;
        }
        if (meeting.apart > moved) {
            return true;
        }
        if (meeting.apart > sagitta && along(before, k, meeting.nx, meeting.ny, meeting.nz) > sagitta) {
            return true;
        }
        return meets(before, k)
                && meeting.apart > sagitta
                && along(after, k, meeting.nx, meeting.ny, meeting.nz) > sagitta;
    }

    /** Goes up, on, and down again. */
    private boolean isMadeAbove(Rigid body, double sagitta) {
        double x = lift * up[0];
        double y = lift * up[1];
        double z = lift * up[2];
        System.arraycopy(body.place, 0, raised, 0, Pose.PLACE);
        raise(raised, x, y, z);
        raise(place, x, y, z);
        near.leaf(body, raised, before);
        near.leaf(body, place, after);
        for (int k = 0; k < near.count; k++) {
            if (!isPast(k, sagitta, 0)) {
                return false;
            }
        }
        if (!placer.isFreeWay(body.id, body.place, x, y, z) || !placer.isFree(body.id, raised)) {
            return false;
        }
        if (!placer.isFree(body.id, place)) {
            return false;
        }
        placer.put(body.id, place);
        placer.toContact(body.id, -x, -y, -z, GAP);
        read(body);
        return true;
    }

    private static void raise(double[] at, double x, double y, double z) {
        at[0] += x;
        at[1] += y;
        at[2] += z;
    }
}
