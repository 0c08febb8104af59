package robosim.geometry.dynamics.step;

import java.util.Arrays;
import robosim.geometry.exact.Turned;

/**
 * How far two convex pieces are apart where they have been put, and along which direction. Plain doubles: what is decided here
 * is when bodies meet; whether they may go there is decided exactly by the world.
 */
final class Separation {
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

    /** How far the line of that edge keeps the other away, and whether the corner nearest to it is across the edge. */
    private double best;

    private boolean isAcross;

    private final Turned turned = new Turned();

    void putA(Bodies bodies, Pieces pieces, int piece, double t) {
        int n = pieces.corners(piece);
        if (n > ax.length) {
            ax = new double[n];
            az = new double[n];
        }
        an = n;
        put(bodies, pieces, piece, t, ax, az);
    }

    void putB(Bodies bodies, Pieces pieces, int piece, double t) {
        int n = pieces.corners(piece);
        if (n > bx.length) {
            bx = new double[n];
            bz = new double[n];
        }
        bn = n;
        put(bodies, pieces, piece, t, bx, bz);
    }

    /** Puts two pieces with the centres of their bodies at given points, turned by given angles since the step began. */
    void put(
            Pieces pieces, int a, double x, double z, double angle, int b, double otherX, double otherZ, double other) {
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
        put(pieces, a, x, z, angle, ax, az);
        put(pieces, b, otherX, otherZ, other, bx, bz);
    }

    private void put(Bodies bodies, Pieces pieces, int piece, double t, double[] toX, double[] toZ) {
        int body = pieces.body[piece];
        if (body < 0) {
            put(pieces, piece, 0, 0, 0, toX, toZ);
        } else {
            put(pieces, piece, bodies.xAt(body, t), bodies.zAt(body, t), bodies.angleAt(body, t), toX, toZ);
        }
    }

    private void put(Pieces pieces, int piece, double cx, double cz, double angle, double[] toX, double[] toZ) {
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

    /** The distance of the two; at most 0 where they meet, then with the direction of least depth where that is easy. */
    double distance() {
        faceOf = 0;
        if (an == 1 && bn == 1) {
            return points(ax[0] - bx[0], az[0] - bz[0]) - radius;
        }
        best = Double.NEGATIVE_INFINITY;
        isAcross = false;
        nx = 0;
        nz = 0;
        edges(1, ax, az, an, bx, bz, bn);
        edges(2, bx, bz, bn, ax, az, an);
        if (best <= 0 || isAcross) {
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
            double tied = TIED * (Math.abs(px[k]) + Math.abs(pz[k]) + length);
            double least = Double.POSITIVE_INFINITY;
            int support = 0;
            for (int j = 0; j < qn; j++) {
                double s = ex * (qx[j] - px[k]) + ez * (qz[j] - pz[k]);
                if (s < least) {
                    least = s;
                    support = j;
                    if (s - best <= -tied) {
                        break;
                    }
                }
            }
            double lead = least - best;
            if (lead <= -tied) {
                continue;
            }
            double past = BESIDE * Math.max(1, length) * length;
            double along = dx * (qx[support] - px[k]) + dz * (qz[support] - pz[k]);
            boolean across = along >= -past && along <= length * length + past;
            for (int j = 0; j < qn && !across; j++) {
                if (ex * (qx[j] - px[k]) + ez * (qz[j] - pz[k]) <= least + tied) {
                    along = dx * (qx[j] - px[k]) + dz * (qz[j] - pz[k]);
                    across = along >= -past && along <= length * length + past;
                }
            }
            if (across == isAcross ? lead > 0 : across || lead > tied) {
                best = least;
                isAcross = across;
                nx = side == 1 ? -ex : ex;
                nz = side == 1 ? -ez : ez;
                face = k;
                faceOf = side;
            }
        }
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
        double length = Math.sqrt(dx * dx + dz * dz);
        double least = Double.POSITIVE_INFINITY;
        for (int j = 0; j < (faceOf == 1 ? bn : an); j++) {
            least = Math.min(least, dz * (qx[j] - px[face]) - dx * (qz[j] - pz[face]));
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
        double least = Double.POSITIVE_INFINITY;
        double toX = 0;
        double toZ = 0;
        for (int i = 0; i < an; i++) {
            for (int j = 0; j < bn; j++) {
                int next = j + 1 == bn ? 0 : j + 1;
                double share = foot(ax[i], az[i], bx[j], bz[j], bx[next], bz[next]);
                double dx = ax[i] - (bx[j] + share * (bx[next] - bx[j]));
                double dz = az[i] - (bz[j] + share * (bz[next] - bz[j]));
                double square = dx * dx + dz * dz;
                if (square < least) {
                    least = square;
                    toX = dx;
                    toZ = dz;
                }
            }
        }
        for (int j = 0; j < bn; j++) {
            for (int i = 0; an > 1 && i < an; i++) {
                int next = i + 1 == an ? 0 : i + 1;
                double share = foot(bx[j], bz[j], ax[i], az[i], ax[next], az[next]);
                double dx = ax[i] + share * (ax[next] - ax[i]) - bx[j];
                double dz = az[i] + share * (az[next] - az[i]) - bz[j];
                double square = dx * dx + dz * dz;
                if (square < least) {
                    least = square;
                    toX = dx;
                    toZ = dz;
                }
            }
        }
        return points(toX, toZ);
    }

    /** The share of an edge at which it is nearest to a point. */
    private static double foot(double px, double pz, double fromX, double fromZ, double toX, double toZ) {
        double dx = toX - fromX;
        double dz = toZ - fromZ;
        double square = dx * dx + dz * dz;
        return square == 0 ? 0 : Math.max(0, Math.min(1, (dx * (px - fromX) + dz * (pz - fromZ)) / square));
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
