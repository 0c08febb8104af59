package robosim.geometry.dynamics.step;

/**
 * When two pieces come as near as a gap, both translating and turning at constant speeds: conservative advancement (Mirtich
 * 1996) with a bound of second order. Along the direction in which the two are apart each corner goes
 * {@code a + a' t} to within {@code w^2 r t^2 / 2} for a body that turns by w and a corner r from its centre, so until the
 * first time at which two corners could have come to the gap by that bound there is no contact. Without turns the bound is exact
 * for the pair of features that is nearest, and two discs are solved in closed form.
 */
final class TimeOfImpact {
    /** Never, within the time asked. */
    static final double NEVER = Double.POSITIVE_INFINITY;

    private static final int MOST_ROUNDS = 48;

    /** Nearer than so much more than the gap counts as there. */
    private static final double THERE = 1 + 0x1p-10;

    /** Below this share of the speed the one passes the other, and the gap may become smaller. */
    private static final double GRAZING = 1e-4;

    final Separation separation = new Separation();

    private final Bodies bodies;
    private final Pieces pieces;
    private double gap;

    /** How far the two were apart when last asked. */
    double apart;

    TimeOfImpact(Bodies bodies, Pieces pieces) {
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
        double wa = pieces.reach[a] == 0 ? 0 : bodies.w[bodyA];
        double wb = bodyB < 0 || pieces.reach[b] == 0 ? 0 : bodies.w[bodyB];
        double distance = measure(a, b, from);
        apart = distance;
        if (distance <= 0 || (vx == 0 && vz == 0 && wa == 0 && wb == 0)) {
            return NEVER;
        }
        double speed = Math.sqrt(vx * vx + vz * vz)
                + Math.abs(wa) * pieces.reach[a]
                + Math.abs(wb) * (bodyB < 0 ? 0 : pieces.reach[b]);
        double target = Math.min(gap, 0.5 * distance);
        if (distance - target > speed * (to - from)) {
            return NEVER;
        }
        double bend = wa * wa * pieces.reach[a] + (wb == 0 ? 0 : wb * wb * pieces.reach[b]);
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
            double by = separation.an == 1 && separation.bn == 1 && wa == 0 && wb == 0
                    ? discs(vx, vz, separation.radius + target, to - t)
                    : safely(bodyA, bodyB, vx, vz, wa, wb, distance - target, bend, t, to - t);
            if (by == NEVER) {
                return NEVER;
            }
            double next = t + by;
            if (next == t) {
                return t;
            }
            t = Math.min(next, to);
            distance = measure(a, b, t);
        }
        return t;
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

    /** A time within which the two cannot come nearer than the gap by the bound; never if that is all the time there is. */
    private double safely(
            int bodyA,
            int bodyB,
            double vx,
            double vz,
            double wa,
            double wb,
            double free,
            double bend,
            double t,
            double most) {
        Separation s = separation;
        double nx = s.nx;
        double nz = s.nz;
        if (wa == 0 && wb == 0) {
            double closing = -(vx * nx + vz * nz);
            return free < closing * most ? free / closing : NEVER;
        }
        double across = vx * nx + vz * nz;
        double sa = bodies.zAt(bodyA, t) * nx - bodies.xAt(bodyA, t) * nz;
        double sb = bodyB < 0 ? 0 : bodies.zAt(bodyB, t) * nx - bodies.xAt(bodyB, t) * nz;
        double firstA = Double.POSITIVE_INFINITY;
        for (int i = 0; i < s.an; i++) {
            firstA = Math.min(firstA, s.ax[i] * nx + s.az[i] * nz);
        }
        double lastB = Double.NEGATIVE_INFINITY;
        for (int j = 0; j < s.bn; j++) {
            lastB = Math.max(lastB, s.bx[j] * nx + s.bz[j] * nz);
        }
        double by = most;
        boolean isMet = false;
        for (int i = 0; i < s.an; i++) {
            double a = s.ax[i] * nx + s.az[i] * nz - firstA;
            double turnA = wa * (s.az[i] * nx - s.ax[i] * nz - sa);
            for (int j = 0; j < s.bn; j++) {
                double g = free + a + (lastB - (s.bx[j] * nx + s.bz[j] * nz));
                double rate = across + turnA - wb * (s.bz[j] * nx - s.bx[j] * nz - sb);
                if (g + rate * by - 0.5 * bend * by * by < 0) {
                    double root = Math.sqrt(rate * rate + 2 * bend * g);
                    by = rate < 0 ? 2 * g / (root - rate) : (rate + root) / bend;
                    isMet = true;
                }
            }
        }
        return isMet ? by : NEVER;
    }
}
