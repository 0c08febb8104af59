package robosim.geometry.dynamics.planar;

/**
 * When two pieces come as near as a gap, both translating and turning at constant speeds: conservative advancement (Mirtich
 * 1996) along the direction in which the two are apart. Without turns the bound is exact for the pair of features that is
 * nearest, and two discs are solved in closed form; a turn is followed across the nearest edge, a small angle at a time, as in
 * Catto 2013.
 */
final class PlanarTimeOfImpact {
    /** Never, within the time asked. */
    static final double NEVER = Double.POSITIVE_INFINITY;

    private static final int MOST_ROUNDS = 48;

    /** Rounds after which a root that is not found yet is looked for otherwise. */
    private static final int ILLINOIS = 8;

    /** Radians of a turn that are looked at in one go. */
    private static final double TURN = 0.25;

    /** Nearer than so much more than the gap counts as there. */
    private static final double THERE = 1 + 0x1p-6;

    /** Below this share of the speed the one passes the other, and the gap may become smaller. */
    private static final double GRAZING = 1e-4;

    /** So many gaps are more than what counts as touching, and all that is lost in rounding: a gap is at least 2^-42 of what coordinates are. */
    private static final double FAR = 64;

    final PieceSeparation separation = new PieceSeparation();

    private final MovingBodies bodies;
    private final ConvexPieces pieces;
    private double gap;

    /** How far the two were apart when last asked. */
    double apart;

    PlanarTimeOfImpact(MovingBodies bodies, ConvexPieces pieces) {
        this.bodies = bodies;
        this.pieces = pieces;
    }

    /** The gap at which pieces count as having met, metres. */
    void stayApart(double by) {
        gap = by;
    }

    /** Puts both pieces where they are at a time, and measures. */
    double measure(int a, int b, double t) {
        separation.radius = pieces.radius[a] + pieces.radius[b];
        separation.putA(bodies, pieces, a, t);
        separation.putB(bodies, pieces, b, t);
        return separation.distance();
    }

    /**
     * The time from one time on up to another one at which a and b come to the gap; if they are nearer already, at which they
     * have halved their distance. Pieces that overlap from the start never do.
     */
    double first(int a, int b, double from, double to) {
        int bodyA = pieces.body[a];
        int bodyB = pieces.body[b];
        double vx = bodies.vx[bodyA] - (bodyB < 0 ? 0 : bodies.vx[bodyB]);
        double vz = bodies.vz[bodyA] - (bodyB < 0 ? 0 : bodies.vz[bodyB]);
        if (isOff(a, b, vx * (to - from), vz * (to - from), from)) {
            apart = Double.POSITIVE_INFINITY;
            return NEVER;
        }
        double wa = pieces.reach[a] == 0 ? 0 : bodies.w[bodyA];
        double wb = bodyB < 0 || pieces.reach[b] == 0 ? 0 : bodies.w[bodyB];
        double distance = measure(a, b, from);
        apart = distance;
        if (distance <= 0 || (vx == 0 && vz == 0 && wa == 0 && wb == 0)) {
            return NEVER;
        }
        double speed = Math.sqrt(vx * vx + vz * vz)
                + (Math.abs(wa) * pieces.reach[a] + Math.abs(wb) * (bodyB < 0 ? 0 : pieces.reach[b]));
        double target = Math.min(gap, 0.5 * distance);
        if (distance - target > speed * (to - from)) {
            return NEVER;
        }
        double t = from;
        double least = 0x1p-6 * target;
        for (int round = 0; round < MOST_ROUNDS; round++) {
            if (distance <= target * THERE) {
                double closing = -(vx * separation.nx + vz * separation.nz);
                boolean isGrazing = wa == 0 && wb == 0 && Math.abs(closing) <= GRAZING * speed && target > least;
                if (!isGrazing || distance <= 0) {
                    return t;
                }
                target = Math.min(0.5 * target, 0.5 * distance);
            }
            double by;
            if (wa != 0 || wb != 0) {
                by = turning(a, b, distance - target, target, t, to - t, Math.max(Math.abs(wa), Math.abs(wb)));
            } else if (separation.an == 1 && separation.bn == 1) {
                by = discs(vx, vz, separation.radius + target, to - t);
            } else {
                double closing = -(vx * separation.nx + vz * separation.nz);
                by = distance - target < closing * (to - t) ? (distance - target) / closing : NEVER;
            }
            double next = t + by;
            if (next >= to) {
                return NEVER;
            }
            if (next == t) {
                return distance <= 4 * target ? t : NEVER;
            }
            t = next;
            distance = measure(a, b, t);
        }
        return distance <= 4 * target ? t : NEVER;
    }

    /**
     * Whether the discs around two, which hold them however they turn, stay apart by more than what counts as touching on a
     * way of one as seen from the other. That is so of most who met once and have gone elsewhere.
     */
    private boolean isOff(int a, int b, double dx, double dz, double t) {
        int bodyA = pieces.body[a];
        int bodyB = pieces.body[b];
        double x = bodies.xAt(bodyA, t);
        double z = bodies.zAt(bodyA, t);
        double by = pieces.reach[a] + pieces.radius[a] + FAR * gap;
        if (bodyB < 0) {
            return pieces.isOff(b, x, z, x + dx, z + dz, by);
        }
        double fromX = x - bodies.xAt(bodyB, t);
        double fromZ = z - bodies.zAt(bodyB, t);
        by += pieces.reach[b] + pieces.radius[b];
        return ConvexPieces.isFar(fromX, fromZ, fromX + dx, fromZ + dz, by);
    }

    /** When two discs come to a distance of their centres. */
    private double discs(double vx, double vz, double reach, double most) {
        double px = separation.ax[0] - separation.bx[0];
        double pz = separation.az[0] - separation.bz[0];
        double closing = -(px * vx + pz * vz);
        if (closing <= 0) {
            return NEVER;
        }
        double square = vx * vx + vz * vz;
        double aside = px * vz - pz * vx;
        double under = reach * reach * square - aside * aside;
        if (under < 0) {
            return NEVER;
        }
        // c / (closing + root) with c = p^2 - reach^2, which loses nothing where the way is short.
        double distance = Math.sqrt(px * px + pz * pz);
        double c = (distance - reach) * (distance + reach);
        double by = c / (closing + Math.sqrt(under));
        return by >= most ? NEVER : Math.max(0, by);
    }

    /**
     * A time within which the two come no nearer than the gap along the direction in which they are apart now; all the time
     * there is if they do not. Looks at the end and the middle of a small turn, and at the least of the parabola through these.
     */
    private double turning(int a, int b, double free, double target, double t, double most, double w) {
        double to = Math.min(most, TURN / w);
        double mid = 0.5 * to;
        double atMid = along(a, b, t + mid) - target;
        if (atMid < 0) {
            return root(a, b, target, t, 0, free, mid, atMid);
        }
        double atEnd = along(a, b, t + to) - target;
        if (atEnd < 0) {
            return root(a, b, target, t, mid, atMid, to, atEnd);
        }
        double bend = 2 * (free - 2 * atMid + atEnd);
        double slope = 4 * atMid - 3 * free - atEnd;
        double lowest = bend > 0 ? -slope / (2 * bend) : 0;
        if (lowest > 0 && lowest < 1) {
            double there = along(a, b, t + lowest * to) - target;
            if (there < 0) {
                return root(a, b, target, t, 0, free, lowest * to, there);
            }
        }
        return to;
    }

    private double along(int a, int b, double t) {
        separation.putA(bodies, pieces, a, t);
        if (pieces.body[b] >= 0) { // else it is where it was when the two were measured
            separation.putB(bodies, pieces, b, t);
        }
        return separation.along();
    }

    /**
     * A time at which the two are apart by the gap, or the last one found at which they are still by more: by the Illinois
     * method (Dowell and Jarratt 1971) first. Where another corner than the nearest one is the first to come, that hardly gets
     * on; then follow in turns the secant through the last two times at which they were nearer, which are of that corner, the
     * chord, and halving.
     */
    private double root(int a, int b, double target, double t, double from, double atFrom, double to, double atTo) {
        double low = from;
        double high = to;
        double above = atFrom;
        double below = atTo;
        double trueAbove = atFrom;
        double trueBelow = atTo;
        double highBefore = Double.NaN;
        double belowBefore = Double.NaN;
        int side = 0;
        for (int k = 0; k < MOST_ROUNDS && above > 0; k++) {
            double mid;
            if (k < ILLINOIS) {
                // Along a bent function one end would stay for long.
                mid = Math.abs(side) > 2 ? 0.5 * (low + high) : low + (high - low) * (above / (above - below));
            } else {
                int turn = (k - ILLINOIS) % 3;
                mid = turn == 0
                        ? high + (high - highBefore) * (trueBelow / (belowBefore - trueBelow))
                        : low + (high - low) * (trueAbove / (trueAbove - trueBelow));
                // Written so that what is not a number fails it.
                mid = turn < 2 && mid > low && mid < high ? mid : 0.5 * (low + high);
            }
            if (!(mid > low && mid < high) || high - low < 0x1p-44 * (t + high)) {
                break;
            }
            double there = along(a, b, t + mid) - target;
            if (Math.abs(there) <= target * 0x1p-7) {
                return mid;
            }
            if (there >= 0) {
                low = mid;
                above = there;
                trueAbove = there;
                below = side > 0 ? 0.5 * below : below;
                side = side < 0 || side > 2 ? 1 : side + 1;
            } else {
                highBefore = high;
                belowBefore = trueBelow;
                high = mid;
                below = there;
                trueBelow = there;
                above = side < 0 ? 0.5 * above : above;
                side = side > 0 || side < -2 ? -1 : side - 1;
            }
        }
        return low;
    }
}
