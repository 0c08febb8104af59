package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Radians;
import robosim.geometry.narrow.leaf.ProjectedPolygon;
import robosim.geometry.narrow.sat.AxisBody;

/**
 * A polygon (or a point) turned about a pivot against one at rest, in the plane: closed form.
 *
 * <p>Two convex polygons are apart exactly while some edge normal of either separates them. A normal of the polygon at
 * rest stays fixed in the world while the mover's corners go round; a normal of the mover stays fixed in the mover, for
 * which the other's corners go round backwards. Either way each corner is beyond the normal's line while {@code rho
 * cos(t - phase) > c}: an arc of angles. The turn is free up to the first angle that no normal covers.
 *
 * <p>All coordinates are relative to the pivot, and so mirrored that the turn goes from x towards z. A margin of 128 units
 * of roundoff (2^-53) of all sizes is kept from every line, and {@link #MARGIN} from every end of an arc: coordinates carry
 * 8 units, unit normals 3, dot products 3, sines and angles 4 each, on either side; that several times over. Corners that are nearer to their line than that when
 * the turn begins are judged by where they go from there: by the first derivative, or the second where that is zero.
 */
final class TurningPolygon {
    /** Radians by which every arc is shortened. */
    static final double MARGIN = 0x1p-48;

    /** A turn asked for may be stored as one that is larger by this factor: its angle is off by a few roundings. */
    private static final double STORED = 1 + 0x1p-50;

    /**
     * A fraction is smaller by this factor than an arc allows, so that the product of it and the turn is free: in that
     * product, in both conversions to radians, in this fraction and in {@link #covers} there are six roundings, and
     * {@link #STORED} is eight more.
     */
    private static final double USABLE = 1 - 0x1p-49;

    private static final double ROUNDOFF = 128 * 0x1p-53;
    private static final double FULL = 2 * Math.PI;
    private static final int MOST_NORMALS = 2 * ProjectedPolygon.MOST_CORNERS;
    private static final int MOST_STEPS = 4 * MOST_NORMALS * ProjectedPolygon.MOST_CORNERS;

    /** Whether the last query found contact, or less than a safe gap, at the start. */
    boolean near;

    /** The greatest gap along a normal at the start; below 0 the depth. */
    double gap;

    /** The error of that gap. */
    double error;

    // Along normal k the corner m of the other polygon is cosine cos t + sine sin t - offset beyond the line.
    private int normals;
    private final double[] offset = new double[MOST_NORMALS];
    private final double[] gaps = new double[MOST_NORMALS];
    private final int[] corners = new int[MOST_NORMALS];
    private final double[] cosine = new double[MOST_NORMALS * ProjectedPolygon.MOST_CORNERS];
    private final double[] sine = new double[MOST_NORMALS * ProjectedPolygon.MOST_CORNERS];
    private final double[] unitX = new double[MOST_NORMALS];
    private final double[] unitZ = new double[MOST_NORMALS];
    private final boolean[] usable = new boolean[MOST_NORMALS];

    /** Loads the mover and the polygon at rest, relative to the pivot, and finds {@link #gap} and {@link #near}. */
    void load(ProjectedPolygon mover, ProjectedPolygon rest) {
        normals = 0;
        error = ROUNDOFF * (mover.size + rest.size) + AxisBody.TINY;
        gap = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < rest.normals; k++) {
            add(rest, k, mover, 1);
        }
        for (int k = 0; k < mover.normals; k++) {
            add(mover, k, rest, -1);
        }
        near = !(gap > error);
    }

    private void add(ProjectedPolygon holder, int k, ProjectedPolygon other, double turn) {
        double l = Math.sqrt(holder.nx[k] * holder.nx[k] + holder.nz[k] * holder.nz[k]);
        double nx = holder.nx[k] / l;
        double nz = holder.nz[k] / l;
        double reach = Double.NEGATIVE_INFINITY;
        for (int m = 0; m < holder.corners; m++) {
            reach = Math.max(reach, nx * holder.x[m] + nz * holder.z[m]);
        }
        double least = Double.POSITIVE_INFINITY;
        int row = normals * ProjectedPolygon.MOST_CORNERS;
        for (int m = 0; m < other.corners; m++) {
            cosine[row + m] = nx * other.x[m] + nz * other.z[m];
            sine[row + m] = turn * (nz * other.x[m] - nx * other.z[m]);
            least = Math.min(least, cosine[row + m] - reach);
        }
        offset[normals] = reach;
        gaps[normals] = least;
        corners[normals] = other.corners;
        unitX[normals] = turn * nx;
        unitZ[normals] = turn * nz;
        usable[normals] = true;
        gap = Math.max(gap, least);
        normals++;
    }

    int normals() {
        return normals;
    }

    /** The direction of a normal from the polygon at rest towards the mover, in the mirrored plane. */
    double unitX(int k) {
        return unitX[k];
    }

    double unitZ(int k) {
        return unitZ[k];
    }

    /** Whether the gap along a normal is within the error of the greatest. */
    boolean isLeading(int k) {
        return gaps[k] >= gap - 2 * error;
    }

    /** Leaves a normal out at the start of a turn from a gap that is hardly one. */
    void reject(int k) {
        usable[k] = false;
    }

    /** Whether a turn, radians, is free if an arc of it is: the arc, less its margin, holds the turn as stored. */
    static boolean covers(double arc, double turn) {
        return arc >= FULL || arc - MARGIN >= turn * STORED;
    }

    /**
     * The fraction of a turn for which an arc that does not cover it is enough: also where the caller rounds the product
     * of the two, or adds it to a heading, which is what the second margin is for.
     */
    static double fraction(double arc, double turn) {
        return Math.min(Math.nextDown(1.0), Math.max(0, (arc - 2 * MARGIN) / turn * USABLE));
    }

    /** The free part of a turn, radians; infinite if it covers the angle. */
    double free(double angle) {
        double t = near ? fromContact() : 0;
        double threshold = near ? Math.min(gap, 0) : 0;
        boolean begun = !near || t > 0;
        for (int step = 0; begun && step < MOST_STEPS; step++) {
            if (covers(t, angle)) {
                return Double.POSITIVE_INFINITY;
            }
            double best = t;
            for (int k = 0; k < normals; k++) {
                best = Math.max(best, until(k, t, threshold + error));
            }
            if (!(best > t)) {
                return t;
            }
            t = best;
        }
        return t;
    }

    /** The angle up to which a normal that proves enough at t goes on to; t where it does not. */
    private double until(int k, double t, double threshold) {
        int row = k * ProjectedPolygon.MOST_CORNERS;
        double c = offset[k] + threshold;
        double cos = Radians.cos(t);
        double sin = Radians.sin(t);
        for (int m = row; m < row + corners[k]; m++) {
            if (!(cosine[m] * cos + sine[m] * sin > c)) {
                return t;
            }
        }
        double end = Double.POSITIVE_INFINITY;
        for (int m = row; m < row + corners[k]; m++) {
            end = Math.min(end, t + beyond(cosine[m], sine[m], c, t));
        }
        return end;
    }

    /** How long {@code a cos x + b sin x > c}, which holds at x = t, goes on; shortened by the margin. */
    static double beyond(double a, double b, double c, double t) {
        double rho = length(a, b);
        if (c < -rho) {
            return Double.POSITIVE_INFINITY;
        }
        double arc = StrictMath.acos(Math.min(1, c / rho));
        double since = Math.IEEEremainder(t - StrictMath.atan2(b, a), FULL);
        return Math.max(0, arc - since - MARGIN);
    }

    /** The length of a vector of any size. */
    static double length(double x, double z) {
        double square = x * x + z * z;
        return square > 0x1p-900 ? Math.sqrt(square) : StrictMath.hypot(x, z);
    }

    /** From contact, or a gap that is hardly one: no normal of the greatest gap may get deeper than it is. */
    private double fromContact() {
        double best = 0;
        for (int k = 0; k < normals; k++) {
            if (usable[k] && isLeading(k)) {
                best = Math.max(best, notDeeper(k));
            }
        }
        return best;
    }

    private double notDeeper(int k) {
        int row = k * ProjectedPolygon.MOST_CORNERS;
        double end = Double.POSITIVE_INFINITY;
        for (int m = row; m < row + corners[k]; m++) {
            double above = cosine[m] - offset[k] - gaps[k];
            double free = above <= 2 * error
                    ? rising(cosine[m], sine[m], error)
                    : beyond(cosine[m], sine[m], offset[k] + gaps[k] + error, 0);
            end = Math.min(end, free);
        }
        return end;
    }

    /** How long {@code a cos x + b sin x} stays at least what it is at x = 0, where b is off by at most e. */
    static double rising(double a, double b, double e) {
        double rho = length(a, b);
        if (rho <= e) {
            return Double.POSITIVE_INFINITY; // at the pivot
        }
        if (Math.abs(b) <= e) {
            // At the top it can only fall, at the bottom only rise.
            return a > 0 ? 0 : FULL;
        }
        return b < 0 ? 0 : Math.max(0, 2 * (StrictMath.atan2(b, a) - e / rho) - MARGIN);
    }
}
