package robosim.geometry.dynamics.step;

/**
 * Proves that two bodies stay apart on their ways, each going straight and turning evenly from place to place, both at once.
 *
 * <p>Between two times, along any fixed direction n the gap of two convex pieces is at least
 * (1 - s) g0 + s g1 - K s (1 - s), where s runs from 0 to 1, g0 and g1 are the gaps at both ends, and
 * K = (r_a t_a^2 + r_b t_b^2) / 2 for turns by t of corners at a distance of at most r from the centre: the second derivative
 * of a corner's way is at most r t^2. The directions tried are those across which the two are furthest apart at either end;
 * where neither will do, the time is halved. Two discs are solved in closed form. All that is left has to exceed
 * {@link #slack}, many times what is lost in rounding, here and when places are stored.
 */
final class Passing {
    /** Most times that a time is halved. */
    private static final int MOST_HALVES = 6;

    private final Pieces pieces;
    private final Bodies bodies;
    private final Separation from = new Separation();
    private final Separation to = new Separation();

    Passing(Pieces pieces, Bodies bodies) {
        this.pieces = pieces;
        this.bodies = bodies;
    }

    /**
     * What is more than all that is lost in rounding between coordinates of at most a size. A corner is put by some ten
     * operations, a gap measured by as many, and a place stored within a few units in the last place: 2^-53 each.
     */
    static double slack(double size) {
        return 0x1p-45 * size;
    }

    /** Whether two bodies stay apart, each of which goes its way or stands where it is. */
    boolean isClear(Legs legs, int a, boolean aGoes, int b, boolean bGoes) {
        int legA = aGoes ? legs.first[a] : -1;
        int legB = bGoes ? legs.first[b] : -1;
        double ax = legs.fromX[a];
        double az = legs.fromZ[a];
        double angleA = 0;
        double bx = legs.fromX[b];
        double bz = legs.fromZ[b];
        double angleB = 0;
        double time = 0;
        while (legA >= 0 || legB >= 0) {
            double until = legA < 0 ? legs.time[legB] : legs.time[legA];
            until = legB < 0 ? until : Math.min(until, legs.time[legB]);
            double shareA = share(legs, legA, time, until);
            double nextAx = shareA == 0 ? ax : ax + shareA * (legs.x[legA] - ax);
            double nextAz = shareA == 0 ? az : az + shareA * (legs.z[legA] - az);
            double nextAngleA = shareA == 0 ? angleA : angleA + shareA * (legs.angle[legA] - angleA);
            double shareB = share(legs, legB, time, until);
            double nextBx = shareB == 0 ? bx : bx + shareB * (legs.x[legB] - bx);
            double nextBz = shareB == 0 ? bz : bz + shareB * (legs.z[legB] - bz);
            double nextAngleB = shareB == 0 ? angleB : angleB + shareB * (legs.angle[legB] - angleB);
            double sizes = bodies.size[a] + bodies.size[b];
            double most = Math.max(span(ax, az, bx, bz), span(nextAx, nextAz, nextBx, nextBz));
            if (!isFar(ax - bx, az - bz, nextAx - nextBx, nextAz - nextBz, sizes + slack(2 * (most + sizes)))) {
                for (int p = bodies.firstPiece[a]; p < bodies.firstPiece[a] + bodies.pieces[a]; p++) {
                    for (int q = bodies.firstPiece[b]; q < bodies.firstPiece[b] + bodies.pieces[b]; q++) {
                        if (!isClear(
                                p,
                                ax,
                                az,
                                angleA,
                                nextAx,
                                nextAz,
                                nextAngleA,
                                q,
                                bx,
                                bz,
                                angleB,
                                nextBx,
                                nextBz,
                                nextAngleB,
                                0)) {
                            return false;
                        }
                    }
                }
            }
            ax = nextAx;
            az = nextAz;
            angleA = nextAngleA;
            bx = nextBx;
            bz = nextBz;
            angleB = nextAngleB;
            legA = shareA == 1 ? legs.next[legA] : legA;
            legB = shareB == 1 ? legs.next[legB] : legB;
            time = until;
        }
        return true;
    }

    /** Whether a body that goes its way stays apart from a piece that stands still. */
    boolean isClearOf(Legs legs, int body, int still) {
        double x = legs.fromX[body];
        double z = legs.fromZ[body];
        double angle = 0;
        for (int leg = legs.first[body]; leg >= 0; leg = legs.next[leg]) {
            for (int p = bodies.firstPiece[body]; p < bodies.firstPiece[body] + bodies.pieces[body]; p++) {
                if (!isClear(p, x, z, angle, legs.x[leg], legs.z[leg], legs.angle[leg], still, 0, 0, 0, 0, 0, 0, 0)) {
                    return false;
                }
            }
            x = legs.x[leg];
            z = legs.z[leg];
            angle = legs.angle[leg];
        }
        return true;
    }

    /** The share of a leg, from a time on, that is over at another one: exactly 1 at its end, 0 where there is none. */
    private static double share(Legs legs, int leg, double time, double until) {
        return leg < 0 ? 0 : legs.time[leg] == until ? 1 : (until - time) / (legs.time[leg] - time);
    }

    private static double span(double ax, double az, double bx, double bz) {
        return Math.max(Math.max(Math.abs(ax), Math.abs(az)), Math.max(Math.abs(bx), Math.abs(bz)));
    }

    /** Whether the offset of two discs, which goes straight from one to another, stays longer than the sum of their radii. */
    private static boolean isFar(double x, double z, double toX, double toZ, double radii) {
        double dx = toX - x;
        double dz = toZ - z;
        double square = dx * dx + dz * dz;
        double s = square == 0 ? 0 : Math.max(0, Math.min(1, -(x * dx + z * dz) / square));
        double nearX = x + s * dx;
        double nearZ = z + s * dz;
        return Math.sqrt(nearX * nearX + nearZ * nearZ) > radii;
    }

    private boolean isClear(
            int a,
            double ax,
            double az,
            double angleA,
            double toAx,
            double toAz,
            double toAngleA,
            int b,
            double bx,
            double bz,
            double angleB,
            double toBx,
            double toBz,
            double toAngleB,
            int halves) {
        from.put(pieces, a, ax, az, angleA, b, bx, bz, angleB);
        to.put(pieces, a, toAx, toAz, toAngleA, b, toBx, toBz, toAngleB);
        double slack = slack(from.span() + to.span());
        if (from.an == 1 && from.bn == 1 && pieces.reach[a] == 0 && (pieces.reach[b] == 0 || pieces.body[b] < 0)) {
            double x = from.ax[0] - from.bx[0];
            double z = from.az[0] - from.bz[0];
            return isFar(x, z, to.ax[0] - to.bx[0], to.az[0] - to.bz[0], from.radius + slack);
        }
        double bend = 0.5 * (bend(a, toAngleA - angleA) + bend(b, toAngleB - angleB));
        if (!(from.distance() > slack)) {
            return false;
        }
        double nx = from.nx;
        double nz = from.nz;
        if (least(from.along(nx, nz), to.along(nx, nz), bend) > slack) {
            return true;
        }
        if (!(to.distance() > slack)) {
            return false;
        }
        nx = to.nx;
        nz = to.nz;
        if (least(from.along(nx, nz), to.along(nx, nz), bend) > slack) {
            return true;
        }
        if (halves == MOST_HALVES) {
            return false;
        }
        double midAx = 0.5 * (ax + toAx);
        double midAz = 0.5 * (az + toAz);
        double midAngleA = 0.5 * (angleA + toAngleA);
        double midBx = 0.5 * (bx + toBx);
        double midBz = 0.5 * (bz + toBz);
        double midAngleB = 0.5 * (angleB + toAngleB);
        int next = halves + 1;
        return isClear(a, ax, az, angleA, midAx, midAz, midAngleA, b, bx, bz, angleB, midBx, midBz, midAngleB, next)
                && isClear(
                        a, midAx, midAz, midAngleA, toAx, toAz, toAngleA, b, midBx, midBz, midAngleB, toBx, toBz,
                        toAngleB, next);
    }

    private double bend(int piece, double turn) {
        return pieces.reach[piece] * turn * turn;
    }

    /** The least of (1 - s) from + s to - bend s (1 - s). */
    private static double least(double from, double to, double bend) {
        double rise = to - from;
        if (!(Math.abs(rise) < bend)) {
            return Math.min(from, to);
        }
        double below = bend - rise;
        return from - below * below / (4 * bend);
    }
}
