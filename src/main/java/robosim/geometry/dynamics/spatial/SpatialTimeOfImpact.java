package robosim.geometry.dynamics.spatial;

import java.util.List;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * When two bodies that both move will meet in a slice, so that the slice ends there with both where they are at that time. Of
 * two spheres it is a root; of anything else it is found by conservative advancement (Mirtich 1996): a direction that separates
 * the two goes on to do so for as long as the speed along it, turns included, needs for the gap. Bodies that turn on each other
 * hardly come nearer than they are, and would advance by tiny steps, so a longer step is tried first. Two separated at both of
 * its ends, by one direction or by two, are separated all along it but for the curves of both, as {@link TurningSweep} has it.
 *
 * <p>Nothing relies on it but how well a collision is resolved: the world decides what is free.
 */
final class SpatialTimeOfImpact {
    /** The share of a slice by the end of which nothing meets. */
    static final double NEVER = 1;

    /** Two meet where they are this near, in metres: what sweeps leave, and half as much. */
    private static final double MET = 1.5 * TurningSweep.GAP;

    /** An advance by less than so much of the gap is the last. */
    private static final double CLOSE = 1e-3 * TurningSweep.GAP;

    private static final int MOST_STEPS = 64;

    /** So many longer steps are tried before the one that is certain. */
    private static final int MOST_TRIES = 8;

    private final List<RigidBody> bodies;
    private final NearbyPieces near;
    private final RotationVectors turning = new RotationVectors();
    private final ContactGeometry meeting = new ContactGeometry();
    private final LeafColumn leafA = new LeafColumn(1);
    private final LeafColumn leafB = new LeafColumn(1);
    private final double[] placeA = new double[Pose.PLACE];
    private final double[] placeB = new double[Pose.PLACE];
    private final double[] wayA = new double[3];
    private final double[] wayB = new double[3];
    private final double[] turnA = new double[3];
    private final double[] turnB = new double[3];
    private final double[] far = new double[3];
    private final double[] apart = new double[3];
    private final double[] spin = new double[3];
    private final double[] across = new double[3];

    /** The direction at the beginning of a step, and by how much it separates the two. */
    private final double[] first = new double[3];

    private double begins;

    /** Whether the end of the last step that was tried has been measured, and the share of it that may be free. */
    private boolean isMeasured;

    private double hope;

    SpatialTimeOfImpact(List<RigidBody> bodies, NearbyPieces near) {
        this.bodies = bodies;
        this.near = near;
    }

    /** The least share of a slice after which two bodies meet, each going on from its velocity at the start to that at the end. */
    double first(Clusters cluster, double seconds) {
        double first = NEVER;
        for (int k = 0; k < cluster.count; k++) {
            RigidBody one = bodies.get(cluster.member[k]);
            if (!one.isAsleep) {
                motion(one, seconds, wayA, turnA);
                for (int m = k + 1; m < cluster.count; m++) {
                    RigidBody other = bodies.get(cluster.member[m]);
                    if (!other.isAsleep && !near.arePassing(one, other)) {
                        first = Math.min(first, impact(one, other, seconds, first));
                    }
                }
            }
        }
        return first;
    }

    /** Translation and turn in a slice. */
    private static void motion(RigidBody body, double seconds, double[] translation, double[] turn) {
        for (int axis = 0; axis < 3; axis++) {
            translation[axis] = 0.5 * (body.v[axis] + body.u[axis]) * seconds;
            turn[axis] = 0.5 * (body.v[3 + axis] + body.u[3 + axis]) * seconds;
        }
    }

    private double impact(RigidBody a, RigidBody b, double seconds, double before) {
        motion(b, seconds, wayB, turnB);
        double px = b.place[0] - a.place[0];
        double py = b.place[1] - a.place[1];
        double pz = b.place[2] - a.place[2];
        double wx = wayB[0] - wayA[0];
        double wy = wayB[1] - wayA[1];
        double wz = wayB[2] - wayA[2];
        double reach = a.reach + b.reach + MET;
        double within = spheres(px, py, pz, wx, wy, wz, reach);
        boolean isOnlySpheres = a.isBall && b.isBall;
        if (within >= before || isOnlySpheres) {
            // Those that touch have been resolved when the slice began.
            return isOnlySpheres && within == 0 ? NEVER : within;
        }
        return advance(a, b, within, before);
    }

    /** When two spheres that reach so far meet, 0 where they do at the start. */
    private static double spheres(double px, double py, double pz, double wx, double wy, double wz, double reach) {
        double apart = px * px + py * py + pz * pz - reach * reach;
        if (apart <= 0) {
            return 0;
        }
        double closing = -(px * wx + py * wy + pz * wz);
        double square = wx * wx + wy * wy + wz * wz;
        double root = closing * closing - square * apart;
        if (!(closing > 0) || root < 0) {
            return NEVER;
        }
        return Math.min(NEVER, apart / (closing + Math.sqrt(root)));
    }

    private double advance(RigidBody a, RigidBody b, double from, double before) {
        double share = from;
        double length = before - from;
        isMeasured = false;
        for (int step = 0; step < MOST_STEPS; step++) {
            if (!isMeasured && !isApart(a, b, share)) {
                return share == 0 ? NEVER : share;
            }
            double closing = closing(a, b, before - share);
            double gap = meeting.apart - MET;
            if (gap <= CLOSE && closing > 0) {
                // Those that touch have been resolved when the slice began.
                return share == 0 ? NEVER : share;
            }
            double certain = Math.max(0, gap) / closing;
            if (!(closing > 0) || share + certain >= before) {
                return NEVER;
            }
            length = longest(a, b, share, Math.min(length, before - share), certain);
            share += length;
            if (share >= before) {
                return NEVER;
            }
            length *= 4;
        }
        return share;
    }

    /** The longest step from a share that was tried with success, or the one that is certain. */
    private double longest(RigidBody a, RigidBody b, double share, double length, double certain) {
        first[0] = meeting.nx;
        first[1] = meeting.ny;
        first[2] = meeting.nz;
        begins = meeting.apart;
        double by = length;
        for (int tries = 0; tries < MOST_TRIES && by > certain; tries++) {
            if (isPast(a, b, share, by)) {
                return by;
            }
            by *= hope;
        }
        isMeasured = false;
        return certain;
    }

    private boolean isApart(RigidBody a, RigidBody b, double share) {
        place(a, wayA, turnA, share, placeA, leafA);
        place(b, wayB, turnB, share, placeB, leafB);
        return meeting.measure(leafA.kind(0), leafA.rows(), 0, leafB.kind(0), leafB.rows(), 0);
    }

    /** Whether two that are apart at a share come no nearer than contact in a step that ends apart. */
    private boolean isPast(RigidBody a, RigidBody b, double share, double length) {
        double turnsA = a.isBall ? 0 : RigidBody.length(turnA, 0) * length;
        double turnsB = b.isBall ? 0 : RigidBody.length(turnB, 0) * length;
        double curve = (a.reach * turnsA * turnsA + b.reach * turnsB * turnsB) / 8;
        isMeasured = isApart(a, b, share + length);
        double ends = meeting.along(
                leafA.kind(0), leafA.rows(), 0, leafB.kind(0), leafB.rows(), 0, first[0], first[1], first[2]);
        if (isMeasured && ends > MET && Math.min(begins, ends) > curve) {
            return true;
        }
        hope = Math.min(0.99, Math.max(0x1p-4, (begins - MET) / (begins - ends)));
        if (!isMeasured || meeting.apart <= MET) {
            return false;
        }
        double x = meeting.nx - first[0];
        double y = meeting.ny - first[1];
        double z = meeting.nz - first[2];
        double change = Math.sqrt(x * x + y * y + z * z);
        for (int axis = 0; axis < 3; axis++) {
            apart[axis] = (wayA[axis] - wayB[axis]) * length;
        }
        double need = curve + change * (RigidBody.length(apart, 0) + a.reach * turnsA + b.reach * turnsB) / 4;
        double least = Math.min(begins, meeting.apart);
        hope = Math.max(0x1p-4, 0.9 * Math.sqrt(least / need));
        return least > need;
    }

    /**
     * How fast two bodies may close in for a share of the slice, along the direction that separates them as it turns with one of
     * them: for bodies that turn together, only what they move relative to each other counts. With the displacement V, the turn
     * w of that body and x from its centre to the other one, the other moves by V - w x x, which changes by
     * w x (w x x) - 2 w x V.
     */
    private double closing(RigidBody a, RigidBody b, double rest) {
        boolean isA = b.isBall || (!a.isBall && a.reach >= b.reach);
        RigidBody other = isA ? b : a;
        double[] w = isA ? turnA : turnB;
        double[] turn = isA ? turnB : turnA;
        double sign = isA ? -1 : 1;
        for (int axis = 0; axis < 3; axis++) {
            far[axis] = sign * (placeA[axis] - placeB[axis]);
            apart[axis] = sign * (wayA[axis] - wayB[axis]);
            spin[axis] = turn[axis] - w[axis];
        }
        cross(w, far, across);
        for (int axis = 0; axis < 3; axis++) {
            far[axis] = across[axis] - 2 * apart[axis];
            apart[axis] -= across[axis];
        }
        cross(w, far, across);
        double opens = sign * (apart[0] * meeting.nx + apart[1] * meeting.ny + apart[2] * meeting.nz);
        double more = sign * (across[0] * meeting.nx + across[1] * meeting.ny + across[2] * meeting.nz);
        double turns = other.isBall ? 0 : other.reach * RigidBody.length(spin, 0);
        return turns - opens + 0.5 * rest * Math.max(0, -more);
    }

    private static void cross(double[] a, double[] b, double[] out) {
        out[0] = a[1] * b[2] - a[2] * b[1];
        out[1] = a[2] * b[0] - a[0] * b[2];
        out[2] = a[0] * b[1] - a[1] * b[0];
    }

    private void place(
            RigidBody body, double[] translation, double[] turn, double share, double[] place, LeafColumn leaf) {
        turning.turn(body.place, turn, share, place);
        for (int axis = 0; axis < 3; axis++) {
            place[axis] = body.place[axis] + share * translation[axis];
            place[Pose.LOST + axis] = 0;
        }
        near.leaf(body, place, leaf);
    }
}
