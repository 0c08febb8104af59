package robosim.geometry.dynamics.planar;

import java.util.Arrays;
import robosim.geometry.exact.SinCos;

/**
 * Proves that two bodies stay apart on their ways, each going straight and turning evenly from place to place, both at once;
 * or going along a parabola, which leaves the straight line by at most a bulge, in the middle.
 *
 * <p>Between two times, along a direction n that turns evenly by an angle t, the gap of two convex pieces is at least
 * (1 - s) g0 + s g1 - K s (1 - s), where s runs from 0 to 1, g0 and g1 are the gaps at both ends, and 2 K is a bound of the
 * second derivative: seen in axes that turn with n, that of a corner at a distance of at most r from the centre of a body that
 * turns by u is at most r (u - t)^2, and that of the offset of the two bodies, at most d and changing by v, is at most
 * d t^2 + 2 v t, less eight times the bulge along n. The directions begin or end with that across which the two are furthest
 * apart; they stand still, turn with the one body or the other, or turn from the first to the last; where none will do, the
 * time is halved. Two discs on straight ways are solved in closed form. All that is left has to exceed {@link #slack}, many
 * times what is lost in rounding, here and when places are stored.
 */
final class SeparationProof {
    /** Squared, the least cosine of the angle between a normal and a velocity along which two are shifted instead. */
    private static final double LEAST_ALONG = 0x1p-4;

    /** Most times that a time is halved. */
    private static final int MOST_HALVES = 6;

    /** Most that a way may bulge, as a share of the size. */
    static final double MOST_BULGE = 0x1p-4;

    /** Most that an end may be shifted in one go, as a share of the size. */
    private static final double MOST_SHIFT = 1e-2;

    /** By body: how far its way leaves the straight line in the middle, along X and Z. */
    double[] bulgeX = new double[8];

    double[] bulgeZ = new double[8];

    private final ConvexPieces pieces;
    private final MovingBodies bodies;
    private final PieceSeparation from = new PieceSeparation();
    private final PieceSeparation to = new PieceSeparation();
    private final SinCos turned = new SinCos();
    private final PieceSeparation.Places begin = new PieceSeparation.Places();
    private final PieceSeparation.Places end = new PieceSeparation.Places();

    /** By depth, the middles of what has been halved. */
    private final PieceSeparation.Places[] middles = new PieceSeparation.Places[MOST_HALVES];

    // The bulges of the two that are asked about.
    private double bulgeAx;
    private double bulgeAz;
    private double bulgeBx;
    private double bulgeBz;

    /**
     * By how much more the two have to bulge apart so that they pass, or to end apart, as far as one direction tells; and that
     * direction.
     */
    private double missing;

    private boolean isMissingAtEnd;

    private double missingX;
    private double missingZ;

    SeparationProof(ConvexPieces pieces, MovingBodies bodies) {
        this.pieces = pieces;
        this.bodies = bodies;
        Arrays.setAll(middles, k -> new PieceSeparation.Places());
    }

    /** Lets no body bulge. */
    void begin() {
        if (bulgeX.length < bodies.count) {
            bulgeX = new double[2 * bodies.count];
            bulgeZ = new double[2 * bodies.count];
        }
        Arrays.fill(bulgeX, 0, bodies.count, 0);
        Arrays.fill(bulgeZ, 0, bodies.count, 0);
    }

    /**
     * What is more than all that is lost in rounding between coordinates of at most a size. A corner is put by some ten
     * operations, a gap measured by as many, and a place stored within a few units in the last place: 2^-53 each.
     */
    static double slack(double size) {
        return 0x1p-45 * size;
    }

    /** Whether two bodies stay apart, each of which goes its way or stands where it is. */
    boolean isClear(Trajectories legs, int a, boolean aGoes, int b, boolean bGoes) {
        int legA = aGoes ? legs.first[a] : -1;
        int legB = bGoes ? legs.first[b] : -1;
        bulgeAx = legA < 0 ? 0 : bulgeX[a];
        bulgeAz = legA < 0 ? 0 : bulgeZ[a];
        bulgeBx = legB < 0 ? 0 : bulgeX[b];
        bulgeBz = legB < 0 ? 0 : bulgeZ[b];
        double radii = bodies.size[a] + bodies.size[b] + Math.abs(bulgeAx - bulgeBx) + Math.abs(bulgeAz - bulgeBz);
        PieceSeparation.Places at = begin.a(legs.fromX[a], legs.fromZ[a], legs.fromAngle[a])
                .b(legs.fromX[b], legs.fromZ[b], legs.fromAngle[b]);
        PieceSeparation.Places next = end;
        double time = 0;
        while (legA >= 0 || legB >= 0) {
            double until = legA < 0 ? legs.time[legB] : legs.time[legA];
            until = legB < 0 ? until : Math.min(until, legs.time[legB]);
            double shareA = share(legs, legA, time, until);
            next.ax = shareA == 0 ? at.ax : at.ax + shareA * (legs.x[legA] - at.ax);
            next.az = shareA == 0 ? at.az : at.az + shareA * (legs.z[legA] - at.az);
            next.angleA = shareA == 0 ? at.angleA : at.angleA + shareA * (legs.angle[legA] - at.angleA);
            double shareB = share(legs, legB, time, until);
            next.bx = shareB == 0 ? at.bx : at.bx + shareB * (legs.x[legB] - at.bx);
            next.bz = shareB == 0 ? at.bz : at.bz + shareB * (legs.z[legB] - at.bz);
            next.angleB = shareB == 0 ? at.angleB : at.angleB + shareB * (legs.angle[legB] - at.angleB);
            double far =
                    radii + slack(Math.abs(at.ax) + Math.abs(at.az) + Math.abs(next.ax) + Math.abs(next.az) + radii);
            if (!ConvexPieces.isFar(at.ax - at.bx, at.az - at.bz, next.ax - next.bx, next.az - next.bz, far)) {
                for (int p = bodies.firstPiece[a]; p < bodies.firstPiece[a] + bodies.pieces[a]; p++) {
                    for (int q = bodies.firstPiece[b]; q < bodies.firstPiece[b] + bodies.pieces[b]; q++) {
                        if (!isClear(p, q, at, next, 0)) {
                            return false;
                        }
                    }
                }
            }
            PieceSeparation.Places before = at;
            at = next;
            next = before;
            legA = shareA == 1 ? legs.next[legA] : legA;
            legB = shareB == 1 ? legs.next[legB] : legB;
            time = until;
        }
        return true;
    }

    /** Whether a body that goes its way stays apart from a piece that stands still. */
    boolean isClearOf(Trajectories legs, int body, int still) {
        bulgeAx = bulgeX[body];
        bulgeAz = bulgeZ[body];
        bulgeBx = 0;
        bulgeBz = 0;
        PieceSeparation.Places at = begin.a(legs.fromX[body], legs.fromZ[body], legs.fromAngle[body])
                .b(0, 0, 0);
        PieceSeparation.Places next = end.b(0, 0, 0);
        for (int leg = legs.first[body]; leg >= 0; leg = legs.next[leg]) {
            for (int p = bodies.firstPiece[body]; p < bodies.firstPiece[body] + bodies.pieces[body]; p++) {
                if (!isClear(p, still, at, next.a(legs.x[leg], legs.z[leg], legs.angle[leg]), 0)) {
                    return false;
                }
            }
            at.a(legs.x[leg], legs.z[leg], legs.angle[leg]);
        }
        return true;
    }

    /**
     * Lets a body, and another one that goes too, bulge apart or end apart by what was missing when they were asked about last.
     *
     * @param other a body that goes, or -1
     */
    boolean part(Trajectories legs, int body, int other) {
        if (!(missing > 0 && missing < Double.POSITIVE_INFINITY)) {
            return false;
        }
        double light = bodies.ownLightness[body] + (other < 0 ? 0 : bodies.ownLightness[other]);
        double share = other < 0 || light == 0 ? 1 : bodies.ownLightness[body] / light;
        double rest = share - 1;
        if (isMissingAtEnd) {
            if (other >= 0 && !bodies.isDriven[body] && !bodies.isDriven[other]) {
                turnAlong(body, other);
            }
            return shift(legs, body, share * missing) && (other < 0 || shift(legs, other, rest * missing));
        }
        return bulge(body, share * missing) && (other < 0 || bulge(other, rest * missing));
    }

    /** Lets two end apart along the velocity of one as seen from the other if that parts them: so their angular momentum stays. */
    private void turnAlong(int body, int other) {
        double vx = bodies.vx[body] - bodies.vx[other];
        double vz = bodies.vz[body] - bodies.vz[other];
        double along = vx * missingX + vz * missingZ;
        double square = vx * vx + vz * vz;
        if (along * along >= LEAST_ALONG * square && square > 0) {
            missingX = vx / along;
            missingZ = vz / along;
        }
    }

    private boolean shift(Trajectories legs, int body, double by) {
        if (Math.abs(by) > MOST_SHIFT * bodies.size[body]) {
            return false;
        }
        int leg = legs.last[body];
        legs.x[leg] += by * missingX;
        legs.z[leg] += by * missingZ;
        return true;
    }

    private boolean bulge(int body, double by) {
        double x = bulgeX[body] + by * missingX;
        double z = bulgeZ[body] + by * missingZ;
        double most = MOST_BULGE * bodies.size[body];
        if (x * x + z * z > most * most) {
            return false;
        }
        bulgeX[body] = x;
        bulgeZ[body] = z;
        return true;
    }

    /** The share of a leg, from a time on, that is over at another one: exactly 1 at its end, 0 where there is none. */
    private static double share(Trajectories legs, int leg, double time, double until) {
        return leg < 0 ? 0 : legs.time[leg] == until ? 1 : (until - time) / (legs.time[leg] - time);
    }

    /** Whether two pieces stay apart between two places of their bodies, also in halves of the path. */
    private boolean isClear(int a, int b, PieceSeparation.Places start, PieceSeparation.Places stop, int halves) {
        from.put(pieces, a, b, start);
        to.put(pieces, a, b, stop);
        double share = 1.0 / (1 << (2 * halves));
        double bulge = share * ((Math.abs(bulgeAx) + Math.abs(bulgeAz)) + (Math.abs(bulgeBx) + Math.abs(bulgeBz)));
        double slack = slack(from.span() + to.span());
        boolean areDiscs = from.an == 1 && from.bn == 1 && pieces.reach[a] == 0;
        if (areDiscs && bulge == 0 && (pieces.reach[b] == 0 || pieces.body[b] < 0)) {
            double x = from.ax[0] - from.bx[0];
            double z = from.az[0] - from.bz[0];
            if (ConvexPieces.isFar(x, z, to.ax[0] - to.bx[0], to.az[0] - to.bz[0], from.radius + slack)) {
                return true;
            }
        }
        if (halves == 0) {
            missing = Double.POSITIVE_INFINITY;
            isMissingAtEnd = false;
        }
        if (!(from.distance() > slack)) {
            return false;
        }
        double atEnd = to.distance();
        if (!(atEnd > slack)) {
            if (halves == 0) {
                missing = Math.max(CollisionPrediction.GAP, 8 * slack) - atEnd;
                missingX = to.nx;
                missingZ = to.nz;
                isMissingAtEnd = true;
            }
            return false;
        }
        double fromX = start.ax - start.bx;
        double fromZ = start.az - start.bz;
        double toX = stop.ax - stop.bx;
        double toZ = stop.az - stop.bz;
        double turnA = stop.angleA - start.angleA;
        double turnB = pieces.body[b] < 0 ? 0 : stop.angleB - start.angleB;
        double reachA = pieces.reach[a];
        double reachB = pieces.body[b] < 0 ? 0 : pieces.reach[b];
        double offset = pieces.body[b] < 0
                ? Math.max(from.farthest(start.ax, start.az), to.farthest(stop.ax, stop.az))
                : Math.max(length(fromX, fromZ), length(toX, toZ));
        double change = length(toX - fromX, toZ - fromZ) + 4 * bulge;
        double sine = to.nx * from.nz - to.nz * from.nx;
        for (int k = 0; k < 4; k++) {
            double turn = k == 0 ? 0 : k == 1 ? turnA : k == 2 ? turnB : sine;
            if (k > 0 && turn == 0) {
                continue;
            }
            double bend = (turn * turn * (offset + bulge) + 2 * Math.abs(turn) * change)
                    + (reachA * (turnA - turn) * (turnA - turn) + reachB * (turnB - turn) * (turnB - turn));
            if (isClearAlong(turn, 0.5 * bend + 4 * bulge * Math.abs(turn), share, slack, halves == 0)) {
                return true;
            }
        }
        if (halves == MOST_HALVES) {
            return false;
        }
        PieceSeparation.Places middle = middles[halves]
                .a(
                        0.5 * (start.ax + stop.ax) + share * bulgeAx,
                        0.5 * (start.az + stop.az) + share * bulgeAz,
                        0.5 * (start.angleA + stop.angleA))
                .b(
                        0.5 * (start.bx + stop.bx) + share * bulgeBx,
                        0.5 * (start.bz + stop.bz) + share * bulgeBz,
                        0.5 * (start.angleB + stop.angleB));
        return isClear(a, b, start, middle, halves + 1) && isClear(a, b, middle, stop, halves + 1);
    }

    /**
     * Whether the two stay apart along one of the directions found at both ends, which turns by an angle from the one end to
     * the other.
     *
     * @param bend what K is without a bulge
     * @param share the share of the bulges that belongs to the time
     */
    private boolean isClearAlong(double turn, double bend, double share, double slack, boolean isMissingWanted) {
        for (int side = 0; side < 2; side++) {
            double nx = side == 0 ? from.nx : to.nx;
            double nz = side == 0 ? from.nz : to.nz;
            turned.by(side == 0 ? turn : -turn);
            double otherX = nx * turned.cos + nz * turned.sin;
            double otherZ = nz * turned.cos - nx * turned.sin;
            double first = side == 0 ? from.along(nx, nz) : from.along(otherX, otherZ);
            double last = side == 0 ? to.along(otherX, otherZ) : to.along(nx, nz);
            if (first > slack && last > slack) {
                double k = bend - 4 * share * ((bulgeAx - bulgeBx) * nx + (bulgeAz - bulgeBz) * nz);
                if (least(first, last, k) > slack) {
                    return true;
                }
                double more = 0.25 * (k - Math.abs(last - first)) * (1 + Math.abs(turn) + 0x1p-20);
                if (isMissingWanted && more < missing) {
                    missing = more;
                    missingX = nx;
                    missingZ = nz;
                }
            }
        }
        return false;
    }

    private static double length(double x, double z) {
        return Math.sqrt(x * x + z * z);
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
