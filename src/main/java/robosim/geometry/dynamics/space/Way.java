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
    static final double THERE = 1e-6;

    private static final double LEAST = 2e-9;

    /** Most radians of a turn that are decided at once. */
    private static final double TURN = 0.25;

    /** Turning by less than so many metres at the rim is not made. */
    private static final double NOTHING = 1e-13;

    private static final int MOST_TRIES = 96;

    private static final int MOST_FAILED = 12;

    private final Placer placer;
    private final Nearby near;
    private final Meeting meeting = new Meeting();
    private final LeafColumn before = new LeafColumn(1);
    private final LeafColumn after = new LeafColumn(1);
    private final double[] place = new double[Pose.PLACE];
    private final double[] turn = new double[9];
    private final double[] rotation = new double[9];
    private final double[] up = new double[3];

    /** By how much less than it was lifted a body is let down. */
    private double stay;

    /** By how much at most it has moved since what is near was found. */
    private double passed;

    /** By how much one direction separates a piece from the body before and after a part of the way. */
    private double room;

    private double[] begins = new double[0];
    private double[] ends = new double[0];
    private double[] rooms = new double[0];
    private boolean[] isNear = new boolean[0];

    /** Parts of the way that have been made, and before which of them the distance of a piece was measured. */
    private int parts;

    private int[] measured = new int[0];

    /** The share of what was tried that may be free, where it was not. */
    private double hope;

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
        passed = 0;
        parts++;
        if (rooms.length < near.count) {
            begins = new double[2 * near.count];
            ends = new double[2 * near.count];
            rooms = new double[2 * near.count];
            isNear = new boolean[2 * near.count];
            measured = new int[2 * near.count];
        }
        double rest = 1;
        double step = Math.min(1, TURN / turned);
        double least = LEAST / (way + body.reach * turned);
        int failed = 0;
        for (int tries = 0; rest > 0 && tries < MOST_TRIES; tries++) {
            step = Math.min(step, rest);
            if (isMade(body, d, angle, turned, step)) {
                rest = step == rest ? 0 : rest - step;
            } else {
                step *= hope;
                failed++;
                if (step < least || failed > MOST_FAILED) {
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
        if (!isFree(sagitta, moved) && !isFreeAbove(sagitta)) {
            return false;
        }
        if (!placer.isFree(body.id, place)) {
            return false;
        }
        System.arraycopy(place, 0, body.place, 0, Pose.PLACE);
        placer.put(body.id, body.place);
        passed += moved + stay;
        parts++;
        return true;
    }

    /** Whether the way is free as it is; if not, {@link #up} is the way off what is touched. */
    private boolean isFree(double sagitta, double moved) {
        boolean isFree = true;
        hope = 0.25;
        stay = 0;
        up[0] = 0;
        up[1] = 0;
        up[2] = 0;
        for (int k = 0; k < near.count; k++) {
            if (!isPast(k, sagitta, moved)) {
                if (!(room > -2 * sagitta - 2 * GAP)) {
                    // Along the direction that is known, the most that may be free.
                    double share = (begins[k] - 2 * sagitta - GAP) / (begins[k] - ends[k]);
                    hope = room == Double.NEGATIVE_INFINITY ? 0.25 : Math.max(0x1p-6, Math.min(0.9, share));
                    up[0] = 0;
                    up[1] = 0;
                    up[2] = 0;
                    return false; // a collision
                }
                isFree = false;
                for (int axis = 0; axis < 3; axis++) {
                    up[axis] += near.direction[3 * k + axis];
                }
            }
        }
        return isFree;
    }

    /**
     * Whether the way is free if the body is lifted before it and let down after it; what is let down a little less, so that it
     * does not touch, is where it then comes to.
     */
    private boolean isFreeAbove(double sagitta) {
        double size = Rigid.length(up, 0);
        if (size < 0.1) {
            return false;
        }
        for (int axis = 0; axis < 3; axis++) {
            up[axis] /= size;
        }
        double lift = 0;
        for (int k = 0; k < near.count; k++) {
            if (isNear[k] && rooms[k] <= sagitta) {
                double steep = steep(k);
                if (steep < 0.2) {
                    return false;
                }
                lift = Math.max(lift, (1.5 * sagitta + GAP - rooms[k]) / steep);
                if (ends[k] < GAP / 2) {
                    stay = Math.max(stay, (GAP - ends[k]) / steep);
                }
            }
        }
        if (stay > 2 * sagitta + 4 * GAP) {
            return false;
        }
        for (int k = 0; k < near.count; k++) {
            if (isNear[k]) {
                double rise = steep(k) * (1 - 1e-9);
                // The bounds are lower ones, and rounding of what is added is far below the room that is asked for.
                boolean stands = begins[k] > 0 && ends[k] + stay * rise > GAP / 8;
                if (!stands || rooms[k] + lift * rise <= sagitta + GAP / 8) {
                    return false;
                }
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            place[axis] += stay * up[axis];
        }
        return true;
    }

    private double steep(int k) {
        return near.direction[3 * k] * up[0] + near.direction[3 * k + 1] * up[1] + near.direction[3 * k + 2] * up[2];
    }

    /**
     * Whether one direction separates the body from a piece before and after by more than the sagitta; if not, {@link #room} is
     * the most that one was found to separate them by.
     */
    private boolean isPast(int k, double sagitta, double moved) {
        isNear[k] = near.apart[k] - passed <= moved;
        if (!isNear[k]) {
            return true;
        }
        room = Double.NEGATIVE_INFINITY;
        if (near.isKnown[k]) {
            take(k, begin(k), end(k));
            if (room > sagitta) {
                return true;
            }
        }
        if (measured[k] != parts) {
            measured[k] = parts;
            near.apart[k] = Double.NEGATIVE_INFINITY;
            if (!meets(before, k)) {
                return false;
            }
            near.apart[k] = meeting.apart + passed;
            near.most[k] = meeting.most;
            adopt(k);
            isNear[k] = meeting.apart <= moved;
            if (!isNear[k] || room > sagitta) {
                return true;
            }
        }
        // No direction separates them by more than they are apart.
        if (near.most[k] > sagitta && meets(after, k)) {
            adopt(k);
        }
        return room > sagitta;
    }

    private void take(int k, double begin, double end) {
        begins[k] = begin;
        ends[k] = end;
        room = Math.min(begin, end);
        rooms[k] = room;
    }

    /** Takes over the direction that was measured last, if it separates by more than the one that is known. */
    private void adopt(int k) {
        double[] n = near.direction;
        double x = n[3 * k];
        double y = n[3 * k + 1];
        double z = n[3 * k + 2];
        n[3 * k] = meeting.nx;
        n[3 * k + 1] = meeting.ny;
        n[3 * k + 2] = meeting.nz;
        double begin = begin(k);
        double end = end(k);
        if (Math.min(begin, end) > room) {
            near.isKnown[k] = true;
            take(k, begin, end);
        } else {
            n[3 * k] = x;
            n[3 * k + 1] = y;
            n[3 * k + 2] = z;
        }
    }

    private double begin(int k) {
        return along(before, k);
    }

    private double end(int k) {
        return along(after, k);
    }

    private boolean meets(LeafColumn leaf, int k) {
        return meeting.measure(leaf.kind(0), leaf.rows(), 0, near.kind[k], near.rows, k * Leaf.STRIDE);
    }

    private double along(LeafColumn leaf, int k) {
        double[] n = near.direction;
        return meeting.along(
                leaf.kind(0),
                leaf.rows(),
                0,
                near.kind[k],
                near.rows,
                k * Leaf.STRIDE,
                n[3 * k],
                n[3 * k + 1],
                n[3 * k + 2]);
    }
}
