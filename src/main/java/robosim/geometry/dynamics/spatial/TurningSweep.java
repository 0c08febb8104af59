package robosim.geometry.dynamics.spatial;

import robosim.geometry.engine.motion.Placer;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * Carries a body straight on while it turns, as far as that is free.
 *
 * <p>What does not turn, or turns in itself as a sphere does, is carried by swept moves. Of anything else no point is farther
 * from the chord between its places before and after than {@code reach * angle^2 / 8}: the sagitta of its arc; and along the axis
 * of the turn not at all. So if one
 * direction separates both poses from a piece by more than that, the motion between them is free. Where a body rests, it is
 * first lifted by that much along the contact, by a swept move, then turned, and then let down by another one. The world
 * decides in the end whether the body is free where it has come to, exactly.
 *
 * <p>What tips over an edge is separated from it by a direction that turns too, from {@code n} to {@code n'}. On a straight line
 * between these the support of the piece is at most that between its ends, as it is convex, and so is that of the body but for
 * the curve that the direction makes in its frame: with the turn {@code t}, {@code e = |n - n'|} and a displacement {@code d},
 * the gap is at least the one between those at the ends less {@code e |d| / 4 + reach (t^2 + 2 t e) / 8}; for e = 0 that is the
 * sagitta.
 */
final class TurningSweep {
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
    private final NearbyPieces near;
    private final ContactGeometry meeting = new ContactGeometry();
    private final LeafColumn before = new LeafColumn(1);
    private final LeafColumn after = new LeafColumn(1);
    private final double[] place = new double[Pose.PLACE];
    private final RotationVectors turner = new RotationVectors();
    private final double[] up = new double[3];

    // A part of the way: the angle, its axis, the displacement, and the reach of the body.
    private double part;

    private final double[] about = new double[3];

    private double displaced;
    private double reach;

    /** By how much less than it was lifted a body is let down. */
    private double stay;

    /** The object because of which it is. */
    private int obstacle;

    /** The object that a body which turns was last kept off on its way, so that it is beside its path; -1 for none. */
    int keptOff = -1;

    /** By how much at most it has moved since what is near was found. */
    private double passed;

    /** By how much one direction separates a piece from the body before and after a part of the way. */
    private double room;

    private double[] begins = new double[0];
    private double[] ends = new double[0];
    private double[] rooms = new double[0];
    private boolean[] isNear = new boolean[0];

    /** Whether a direction that turns separates a piece; that before and after, three numbers each. */
    private boolean[] isTurning = new boolean[0];

    private double[] first = new double[0];
    private double[] second = new double[0];

    /** More than this they have to be separated by. */
    private double[] needs = new double[0];

    /** Parts of the way that have been made, and before which of them the distance of a piece was measured. */
    private int parts;

    private int[] measured = new int[0];

    /** The square of the share that a direction which turns would separate; 0 for none. */
    private double turning;

    /** The share of what was tried that may be free, where it was not. */
    private double hope;

    TurningSweep(Placer placer, NearbyPieces near) {
        this.placer = placer;
        this.near = near;
    }

    /** Goes by a displacement, turning by a vector in radians; answers the share that was made. */
    double go(RigidBody body, double[] d, double[] angle) {
        double way = RigidBody.length(d, 0);
        double turned = RigidBody.length(angle, 0);
        boolean turns = !body.isBall && turned * body.reach > NOTHING;
        keptOff = -1;
        if (!turns) {
            double share = way == 0 ? 1 : placer.toContact(body.id, d[0], d[1], d[2], GAP);
            read(body);
            if (body.isBall && turned > 0) {
                turner.turn(body.place, angle, share, body.place);
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
            isTurning = new boolean[2 * near.count];
            needs = new double[2 * near.count];
            first = new double[6 * near.count];
            second = new double[6 * near.count];
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

    /** Moves a body by a displacement, if that is free up to a gap; answers whether it was. */
    boolean lift(RigidBody body, double x, double y, double z) {
        boolean isFree = placer.toContact(body.id, x, y, z, GAP) >= 1;
        read(body);
        return isFree;
    }

    /** Whether a body overlaps and touches nothing where it is. */
    boolean isFree(RigidBody body) {
        return placer.isFree(body.id, body.place);
    }

    /** Takes over where the world has a body. */
    void read(RigidBody body) {
        System.arraycopy(placer.objects.places(), placer.objects.place(body.id), body.place, 0, Pose.PLACE);
    }

    private boolean isMade(RigidBody body, double[] d, double[] angle, double turned, double share) {
        turner.turn(body.place, angle, share, place);
        for (int axis = 0; axis < 3; axis++) {
            place[axis] = body.place[axis] + share * d[axis];
            place[Pose.LOST + axis] = 0;
        }
        near.leaf(body, body.place, before);
        near.leaf(body, place, after);
        part = turned * share;
        for (int axis = 0; axis < 3; axis++) {
            about[axis] = angle[axis] / turned;
        }
        double sagitta = body.reach * part * part / 8 * (1 + 1e-9);
        double moved = (RigidBody.length(d, 0) + body.reach * turned) * share;
        displaced = RigidBody.length(d, 0) * share;
        reach = body.reach;
        if (!isFree(sagitta, moved) && !isFreeAbove()) {
            return false;
        }
        if (!placer.isFree(body.id, place)) {
            return false;
        }
        System.arraycopy(place, 0, body.place, 0, Pose.PLACE);
        placer.put(body.id, body.place);
        passed += moved + stay;
        parts++;
        keptOff = stay > 0 ? obstacle : keptOff;
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
            isTurning[k] = false;
            needs[k] = sagitta;
            turning = 0;
            if (!isPast(k, sagitta, moved)) {
                double need = needs[k];
                if (turning > 0 || !(room > -2 * need - 2 * GAP)) {
                    // Along the direction that is known, the most that may be free.
                    double share = (begins[k] - 2 * need - GAP) / (begins[k] - ends[k]);
                    share = turning > 0 ? 0.9 * Math.sqrt(turning) : share;
                    hope = room == Double.NEGATIVE_INFINITY && turning == 0
                            ? 0.25
                            : Math.max(0x1p-6, Math.min(0.9, share));
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
    private boolean isFreeAbove() {
        double size = RigidBody.length(up, 0);
        if (size < 0.1) {
            return false;
        }
        for (int axis = 0; axis < 3; axis++) {
            up[axis] /= size;
        }
        double lift = 0;
        double most = 0;
        for (int k = 0; k < near.count; k++) {
            if (isNear[k] && rooms[k] <= needs[k]) {
                double steep = steep(k);
                if (steep < 0.2) {
                    return false;
                }
                most = Math.max(most, needs[k]);
                lift = Math.max(lift, (1.5 * needs[k] + GAP - rooms[k]) / steep);
                double needed = ends[k] < GAP / 2 ? (GAP - ends[k]) / steep : 0;
                if (needed > stay) {
                    stay = needed;
                    obstacle = near.object[k];
                }
            }
        }
        if (stay > 2 * most + 4 * GAP) {
            return false;
        }
        for (int k = 0; k < near.count; k++) {
            if (isNear[k]) {
                double rise = steep(k) * (1 - 1e-9);
                // The bounds are lower ones, and rounding of what is added is far below the room that is asked for.
                boolean stands = begins[k] > 0 && ends[k] + stay * rise > GAP / 8;
                if (!stands || rooms[k] + lift * rise <= needs[k] + GAP / 8) {
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
        return isTurning[k] ? Math.min(steep(first, k), steep(second, k)) : steep(near.direction, k);
    }

    private double steep(double[] n, int k) {
        return n[3 * k] * up[0] + n[3 * k + 1] * up[1] + n[3 * k + 2] * up[2];
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
            take(k, begin(k), end(k), need(k, sagitta));
            if (room > needs[k]) {
                return true;
            }
        }
        if (measured[k] != parts) {
            measured[k] = parts;
            near.apart[k] = Double.NEGATIVE_INFINITY;
            if (!overlaps(before, k)) {
                return false;
            }
            near.apart[k] = meeting.apart + passed;
            near.most[k] = meeting.most;
            adopt(k, sagitta);
            first[3 * k] = meeting.nx;
            first[3 * k + 1] = meeting.ny;
            first[3 * k + 2] = meeting.nz;
            isNear[k] = meeting.apart <= moved;
            if (!isNear[k] || room > needs[k]) {
                return true;
            }
        }
        // No direction separates them by more than they are apart.
        if (near.most[k] > sagitta && overlaps(after, k)) {
            adopt(k, sagitta);
            if (room <= needs[k]) {
                return isPastTurning(k);
            }
        }
        return room > needs[k];
    }

    /** Whether a direction that turns from the one before to the one after does; else {@link #turning} tells by how much. */
    private boolean isPastTurning(int k) {
        int n = 3 * k;
        second[n] = meeting.nx;
        second[n + 1] = meeting.ny;
        second[n + 2] = meeting.nz;
        double x = second[n] - first[n];
        double y = second[n + 1] - first[n + 1];
        double z = second[n + 2] - first[n + 2];
        double change = Math.sqrt(x * x + y * y + z * z);
        double need = (change * displaced / 4 + reach * part * (part + 2 * change) / 8) * (1 + 1e-9);
        double begin = along(before, k, first);
        double end = along(after, k, second);
        double least = Math.min(begin, end);
        if (least > need) {
            isTurning[k] = true;
            take(k, begin, end, need);
            return true;
        }
        turning = least > 0 ? least / need : 0;
        return false;
    }

    /**
     * What the direction of a piece has to separate by: a point leaves its chord only across the axis of the turn, so by less
     * along what lies near the axis. But a body does not come nearer to anything than it has to.
     */
    private double need(int k, double sagitta) {
        double[] n = near.direction;
        double x = n[3 * k + 1] * about[2] - n[3 * k + 2] * about[1];
        double y = n[3 * k + 2] * about[0] - n[3 * k] * about[2];
        double z = n[3 * k] * about[1] - n[3 * k + 1] * about[0];
        double sine = Math.sqrt(x * x + y * y + z * z) * (1 + 1e-9) + 1e-12;
        return Math.min(sagitta, Math.max(sagitta * sine, GAP / 8));
    }

    private void take(int k, double begin, double end, double need) {
        needs[k] = need;
        begins[k] = begin;
        ends[k] = end;
        room = Math.min(begin, end);
        rooms[k] = room;
    }

    /** Takes over the direction that was measured last, if it separates by more than the one that is known. */
    private void adopt(int k, double sagitta) {
        double[] n = near.direction;
        double x = n[3 * k];
        double y = n[3 * k + 1];
        double z = n[3 * k + 2];
        n[3 * k] = meeting.nx;
        n[3 * k + 1] = meeting.ny;
        n[3 * k + 2] = meeting.nz;
        double begin = begin(k);
        double end = end(k);
        double need = need(k, sagitta);
        if (Math.min(begin, end) - need > room - needs[k]) {
            near.isKnown[k] = true;
            take(k, begin, end, need);
        } else {
            n[3 * k] = x;
            n[3 * k + 1] = y;
            n[3 * k + 2] = z;
        }
    }

    private double begin(int k) {
        return along(before, k, near.direction);
    }

    private double end(int k) {
        return along(after, k, near.direction);
    }

    private boolean overlaps(LeafColumn leaf, int k) {
        return meeting.measure(leaf.kind(0), leaf.rows(), 0, near.kind[k], near.rows, k * Leaf.STRIDE);
    }

    private double along(LeafColumn leaf, int k, double[] n) {
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
