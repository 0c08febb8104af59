package robosim.geometry.dynamics.planar;

import java.util.Arrays;
import robosim.geometry.exact.SinCos;

/**
 * How far two convex pieces are apart where they have been put, and along which direction. Plain doubles: what is decided here
 * is when bodies meet; whether they may go there is decided exactly by the world.
 *
 * <p>Neither the order in which corners are told matters, to the bit, nor which piece is called a: so what is mirrored, whose
 * corners are told the other way round, is apart as far. Where
 * two directions are equally good, to the bit, and mirror images of each other, as between two corners that meet head-on, the
 * one in the middle is taken.
 */
final class PieceSeparation {
    /** A corner that is past the end of an edge by no more, metres, is across it: near contact rounding would turn the normal. */
    private static final double BESIDE = 1e-9;

    /** Distances that differ by less, as a share of the coordinates, are the same up to rounding. */
    private static final double TIED = 0x1p-48;

    /** The corners of both, as they have been put. */
    double[] ax = new double[8];

    double[] az = new double[8];
    double[] bx = new double[8];
    double[] bz = new double[8];
    int an;
    int bn;

    /** The sum of both radii. */
    double radius;

    /** Unit direction from b towards a. */
    double nx;

    double nz;

    /** Whose edge the direction is across: 1 for a, 2 for b, 0 where it is that of two corners; and which edge. */
    private int faceOf;

    private int face;

    /** How far the line of an edge keeps the other away at most, whose nearest corner is not across the edge. */
    private double best;

    /**
     * The same of edges that are across the nearest corner, by how much less it may be and is taken, and which edge it is; of
     * several that keep the other equally far away, the least and the greatest parts of their directions.
     */
    private double bestAcross;

    private double tiedAcross;
    private double leastX;
    private double mostX;
    private double leastZ;
    private double mostZ;
    private int sideAcross;
    private int faceAcross;

    /** The square of the least distance of a corner and an edge. */
    private double nearest;

    private final SinCos turned = new SinCos();

    void putA(MovingBodies bodies, ConvexPieces pieces, int piece, double t) {
        int n = pieces.corners(piece);
        if (n > ax.length) {
            ax = new double[n];
            az = new double[n];
        }
        an = n;
        put(bodies, pieces, piece, t, ax, az);
    }

    void putB(MovingBodies bodies, ConvexPieces pieces, int piece, double t) {
        int n = pieces.corners(piece);
        if (n > bx.length) {
            bx = new double[n];
            bz = new double[n];
        }
        bn = n;
        put(bodies, pieces, piece, t, bx, bz);
    }

    /** Where the centres of two bodies are, and by what angles the bodies have turned since the step began. */
    static final class Places {
        double ax;
        double az;
        double angleA;
        double bx;
        double bz;
        double angleB;

        Places a(double x, double z, double angle) {
            ax = x;
            az = z;
            angleA = angle;
            return this;
        }

        Places b(double x, double z, double angle) {
            bx = x;
            bz = z;
            angleB = angle;
            return this;
        }
    }

    /** Puts two pieces where their bodies are. */
    void put(ConvexPieces pieces, int a, int b, Places places) {
        an = pieces.corners(a);
        bn = pieces.corners(b);
        if (an > ax.length) {
            ax = new double[an];
            az = new double[an];
        }
        if (bn > bx.length) {
            bx = new double[bn];
            bz = new double[bn];
        }
        radius = pieces.radius[a] + pieces.radius[b];
        put(pieces, a, places.ax, places.az, places.angleA, ax, az);
        put(pieces, b, places.bx, places.bz, places.angleB, bx, bz);
    }

    private void put(MovingBodies bodies, ConvexPieces pieces, int piece, double t, double[] toX, double[] toZ) {
        int body = pieces.body[piece];
        if (body < 0) {
            put(pieces, piece, 0, 0, 0, toX, toZ);
        } else {
            put(pieces, piece, bodies.xAt(body, t), bodies.zAt(body, t), bodies.angleAt(body, t), toX, toZ);
        }
    }

    private void put(ConvexPieces pieces, int piece, double cx, double cz, double angle, double[] toX, double[] toZ) {
        int from = pieces.firstCorner[piece];
        int n = pieces.corners(piece);
        if (angle == 0 || pieces.reach[piece] == 0) {
            for (int k = 0; k < n; k++) {
                toX[k] = cx + pieces.x[from + k];
                toZ[k] = cz + pieces.z[from + k];
            }
            return;
        }
        turned.by(angle);
        double cos = turned.cos;
        double sin = turned.sin;
        for (int k = 0; k < n; k++) {
            double px = pieces.x[from + k];
            double pz = pieces.z[from + k];
            toX[k] = cx + (px * cos + pz * sin);
            toZ[k] = cz + (pz * cos - px * sin);
        }
    }

    /** Whose edge the direction is across: 1 for a, 2 for b, 0 where it is that of two corners. */
    int edgeOf() {
        return faceOf;
    }

    /** The distance of the two; at most 0 where they meet, then with the direction of least depth where that is easy. */
    double distance() {
        faceOf = 0;
        if (an == 1 && bn == 1) {
            return points(ax[0] - bx[0], az[0] - bz[0]) - radius;
        }
        best = Double.NEGATIVE_INFINITY;
        bestAcross = Double.NEGATIVE_INFINITY;
        nx = 0;
        nz = 0;
        edges(1, ax, az, an, bx, bz, bn);
        edges(2, bx, bz, bn, ax, az, an);
        if (bestAcross > best - tiedAcross) {
            return byEdges();
        }
        if (best <= 0) {
            return best - radius;
        }
        faceOf = 0;
        return byCorners() - radius;
    }

    /**
     * Looks for an edge of p whose line keeps q further away than the best one so far. Where two edges are parallel up to
     * rounding, the one that is across the nearest corner is taken: its distance is that of the pieces, whereas the
     * direction from corner to corner is noise when the two nearly touch.
     */
    private void edges(int side, double[] px, double[] pz, int pn, double[] qx, double[] qz, int qn) {
        for (int k = 0; pn > 1 && k < pn; k++) {
            int next = k + 1 == pn ? 0 : k + 1;
            double dx = px[next] - px[k];
            double dz = pz[next] - pz[k];
            double length = Math.sqrt(dx * dx + dz * dz);
            if (length == 0) {
                continue;
            }
            double ex = dz / length;
            double ez = -dx / length;
            double midX = 0.5 * (px[k] + px[next]);
            double midZ = 0.5 * (pz[k] + pz[next]);
            double tied = TIED * (Math.abs(midX) + Math.abs(midZ) + length);
            double most = Math.max(best, bestAcross) - tied;
            double least = Double.POSITIVE_INFINITY;
            int support = 0;
            for (int j = 0; j < qn; j++) {
                double s = ex * (qx[j] - midX) + ez * (qz[j] - midZ);
                if (s < least) {
                    least = s;
                    support = j;
                    if (s <= most) {
                        break;
                    }
                }
            }
            if (least <= most) {
                continue;
            }
            double half = (0.5 * length + BESIDE * Math.max(1, length)) * length;
            boolean across = Math.abs(dx * (qx[support] - midX) + dz * (qz[support] - midZ)) <= half;
            for (int j = 0; j < qn && !across; j++) {
                across = ex * (qx[j] - midX) + ez * (qz[j] - midZ) <= least + tied
                        && Math.abs(dx * (qx[j] - midX) + dz * (qz[j] - midZ)) <= half;
            }
            take(side, k, across, least, side == 1 ? -ex : ex, side == 1 ? -ez : ez, tied);
        }
    }

    /** Takes an edge if it keeps the other further away than the best of its kind so far. */
    private void take(int side, int edge, boolean across, double least, double outX, double outZ, double tied) {
        if (!across) {
            // Of equals the one more across X, so that it does not matter which comes first.
            if (least > best || (least == best && Math.abs(outX) > Math.abs(nx))) {
                best = least;
                nx = outX;
                nz = outZ;
                face = edge;
                faceOf = side;
            }
        } else if (least > bestAcross || (least == bestAcross && Math.abs(outX) > Math.max(mostX, -leastX))) {
            bestAcross = least;
            tiedAcross = tied;
            leastX = outX;
            mostX = outX;
            leastZ = outZ;
            mostZ = outZ;
            faceAcross = edge;
            sideAcross = side;
        } else if (least == bestAcross && Math.abs(outX) == Math.max(mostX, -leastX)) {
            leastX = Math.min(leastX, outX);
            mostX = Math.max(mostX, outX);
            leastZ = Math.min(leastZ, outZ);
            mostZ = Math.max(mostZ, outZ);
        }
    }

    /** The distance across the edges that are across; where these are mirror images of each other, along the middle. */
    private double byEdges() {
        if (leastX == mostX && leastZ == mostZ) {
            nx = mostX;
            nz = mostZ;
            face = faceAcross;
            faceOf = sideAcross;
            return bestAcross - radius;
        }
        points(leastX + mostX, leastZ + mostZ);
        faceOf = 0;
        return along(nx, nz);
    }

    /**
     * How far the two, put elsewhere since, are apart along the direction that was found: that across the same edge, or the
     * same in the world where it was that of two corners. Never more than their distance.
     */
    double along() {
        if (faceOf == 0) {
            return along(nx, nz);
        }
        double[] px = faceOf == 1 ? ax : bx;
        double[] pz = faceOf == 1 ? az : bz;
        double[] qx = faceOf == 1 ? bx : ax;
        double[] qz = faceOf == 1 ? bz : az;
        int next = face + 1 == (faceOf == 1 ? an : bn) ? 0 : face + 1;
        double dx = px[next] - px[face];
        double dz = pz[next] - pz[face];
        double midX = 0.5 * (px[face] + px[next]);
        double midZ = 0.5 * (pz[face] + pz[next]);
        double length = Math.sqrt(dx * dx + dz * dz);
        double least = Double.POSITIVE_INFINITY;
        for (int j = 0; j < (faceOf == 1 ? bn : an); j++) {
            least = Math.min(least, dz * (qx[j] - midX) - dx * (qz[j] - midZ));
        }
        return least / length - radius;
    }

    /** How far the two are apart along a unit direction from b towards a. */
    double along(double dx, double dz) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < an; i++) {
            least = Math.min(least, ax[i] * dx + az[i] * dz);
        }
        double most = Double.NEGATIVE_INFINITY;
        for (int j = 0; j < bn; j++) {
            most = Math.max(most, bx[j] * dx + bz[j] * dz);
        }
        return least - most - radius;
    }

    /** The greatest coordinates of both, and the radii. */
    double span() {
        double most = 0;
        for (int i = 0; i < an; i++) {
            most = Math.max(most, Math.max(Math.abs(ax[i]), Math.abs(az[i])));
        }
        for (int j = 0; j < bn; j++) {
            most = Math.max(most, Math.max(Math.abs(bx[j]), Math.abs(bz[j])));
        }
        return most + radius;
    }

    /** The distance of the furthest corner of b from a point. */
    double farthest(double x, double z) {
        double most = 0;
        for (int j = 0; j < bn; j++) {
            most = Math.max(most, (bx[j] - x) * (bx[j] - x) + (bz[j] - z) * (bz[j] - z));
        }
        return Math.sqrt(most);
    }

    private double points(double dx, double dz) {
        double distance = Math.sqrt(dx * dx + dz * dz);
        nx = distance == 0 ? 1 : dx / distance;
        nz = distance == 0 ? 0 : dz / distance;
        return distance;
    }

    /** The least distance of a corner of one and an edge of the other. */
    private double byCorners() {
        nearest = Double.POSITIVE_INFINITY;
        corners(ax, az, an, bx, bz, bn, 1);
        if (an > 1) {
            corners(bx, bz, bn, ax, az, an, -1);
        }
        return points(0.5 * (leastX + mostX), 0.5 * (leastZ + mostZ));
    }

    /** Looks for a corner of p that is nearer to an edge of q than the nearest so far. */
    private void corners(double[] px, double[] pz, int pn, double[] qx, double[] qz, int qn, int sign) {
        for (int j = 0; j < qn; j++) {
            int next = j + 1 == qn ? 0 : j + 1;
            double ex = qx[next] - qx[j];
            double ez = qz[next] - qz[j];
            double length = ex * ex + ez * ez;
            // From the middle, so that it does not matter in which direction the edge is told.
            double midX = 0.5 * (qx[j] + qx[next]);
            double midZ = 0.5 * (qz[j] + qz[next]);
            for (int i = 0; i < pn; i++) {
                double share = length == 0 ? 0 : (ex * (px[i] - midX) + ez * (pz[i] - midZ)) / length;
                double dx = px[i] - (share >= 0.5 ? qx[next] : share <= -0.5 ? qx[j] : midX + share * ex);
                double dz = pz[i] - (share >= 0.5 ? qz[next] : share <= -0.5 ? qz[j] : midZ + share * ez);
                double square = dx * dx + dz * dz;
                if (square <= nearest) {
                    offset(square, sign * dx, sign * dz);
                }
            }
        }
    }

    /** Takes an offset that is not longer than the shortest so far. */
    private void offset(double square, double dx, double dz) {
        if (square < nearest || Math.abs(dx) > Math.max(mostX, -leastX)) {
            nearest = square;
            leastX = dx;
            mostX = dx;
            leastZ = dz;
            mostZ = dz;
        } else if (Math.abs(dx) == Math.max(mostX, -leastX)) {
            leastX = Math.min(leastX, dx);
            mostX = Math.max(mostX, dx);
            leastZ = Math.min(leastZ, dz);
            mostZ = Math.max(mostZ, dz);
        }
    }

    /** The corners of one that are within a slack of the furthest along the direction towards the other: at most two ends. */
    static int support(double[] x, double[] z, int n, double dx, double dz, double slack, int[] out) {
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < n; k++) {
            most = Math.max(most, dx * x[k] + dz * z[k]);
        }
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        Arrays.fill(out, 0, 2, -1);
        for (int k = 0; k < n; k++) {
            if (dx * x[k] + dz * z[k] >= most - slack) {
                double along = dx * z[k] - dz * x[k];
                if (along < least) {
                    least = along;
                    out[0] = k;
                }
                if (along > greatest) {
                    greatest = along;
                    out[1] = k;
                }
            }
        }
        return out[0] == out[1] ? 1 : 2;
    }
}
