package robosim.geometry.narrow.sat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;

/**
 * Whether a plane (in the plane: a line) separates the convex hull of some points from that of others, where both may
 * touch it; for hulls that touch or overlap.
 *
 * <p>Any such plane can be rotated about the common points until it contains three points that are not on one line. So
 * planes through three points are tried; doubles reject most.
 */
public final class ExactSeparatingPlane {
    /** More than the differences, a cross product and a dot product lose, as a share of their magnitudes. */
    private static final double ROUNDOFF = 16 * 0x1p-53;

    private final ExactVector[] points;
    private final double[] rough;
    private final int above;
    private final boolean flat;

    private ExactSeparatingPlane(List<ExactVector> upper, List<ExactVector> lower, boolean inPlane) {
        flat = inPlane;
        above = upper.size();
        points = new ExactVector[above + lower.size()];
        rough = new double[3 * points.length];
        for (int k = 0; k < points.length; k++) {
            points[k] = (k < above ? upper.get(k) : lower.get(k - above)).minus(upper.get(0));
            rough[3 * k] = points[k].x().doubleValue();
            rough[3 * k + 1] = points[k].y().doubleValue();
            rough[3 * k + 2] = points[k].z().doubleValue();
        }
    }

    /**
     * Whether there is one; if all points are in one plane, that plane is one.
     *
     * @param pivot one of the upper points that all such planes are known to contain; -1 where none is known
     */
    public static boolean exists(List<ExactVector> upper, List<ExactVector> lower, boolean inPlane, int pivot) {
        List<ExactVector> first = new ArrayList<>(upper);
        if (pivot > 0) {
            Collections.swap(first, 0, pivot);
        }
        return new ExactSeparatingPlane(first, lower, inPlane).exists(pivot >= 0);
    }

    private boolean exists(boolean hasPivot) {
        for (int p = 0; p < (hasPivot ? 1 : points.length); p++) {
            for (int q = p + 1; q < points.length; q++) {
                if (flat) {
                    if (isBetween(p, q, -1)) {
                        return true;
                    }
                    continue;
                }
                for (int r = q + 1; r < points.length; r++) {
                    if (isBetween(p, q, r)) {
                        return true;
                    }
                }
            }
        }
        return isFlat();
    }

    /** Whether the plane through three points is one; false for points on one line. */
    private boolean isBetween(int p, int q, int r) {
        if (!mayBeBetween(p, q, r)) {
            return false;
        }
        ExactVector first = points[q].minus(points[p]);
        ExactVector normal = flat
                ? new ExactVector(first.z().negate(), Dyadic.ZERO, first.x())
                : first.cross(points[r].minus(points[p]));
        if (normal.isZero()) {
            return false;
        }
        Dyadic place = normal.dot(points[p]);
        int upper = 0;
        for (int k = 0; k < points.length; k++) {
            int side = normal.dot(points[k]).compareTo(place) * (k < above ? 1 : -1);
            if (side * upper < 0) {
                return false;
            }
            upper = upper == 0 ? side : upper;
        }
        return true;
    }

    private boolean mayBeBetween(int p, int q, int r) {
        double ux = rough[3 * q] - rough[3 * p];
        double uy = rough[3 * q + 1] - rough[3 * p + 1];
        double uz = rough[3 * q + 2] - rough[3 * p + 2];
        double nx = -uz;
        double ny = 0;
        double nz = ux;
        double sx = Math.abs(rough[3 * q + 2]) + Math.abs(rough[3 * p + 2]);
        double sy = 0;
        double sz = Math.abs(rough[3 * q]) + Math.abs(rough[3 * p]);
        if (!flat) {
            double vx = rough[3 * r] - rough[3 * p];
            double vy = rough[3 * r + 1] - rough[3 * p + 1];
            double vz = rough[3 * r + 2] - rough[3 * p + 2];
            nx = uy * vz - uz * vy;
            ny = uz * vx - ux * vz;
            nz = ux * vy - uy * vx;
            double mx = Math.abs(rough[3 * r]) + Math.abs(rough[3 * p]);
            double my = Math.abs(rough[3 * r + 1]) + Math.abs(rough[3 * p + 1]);
            double mz = Math.abs(rough[3 * r + 2]) + Math.abs(rough[3 * p + 2]);
            double ly = Math.abs(rough[3 * q + 1]) + Math.abs(rough[3 * p + 1]);
            double lx = sz;
            double lz = sx;
            sx = ly * mz + lz * my;
            sy = lz * mx + lx * mz;
            sz = lx * my + ly * mx;
        }
        double side = 0;
        for (int k = 0; k < points.length; k++) {
            double x = rough[3 * k] - rough[3 * p];
            double y = rough[3 * k + 1] - rough[3 * p + 1];
            double z = rough[3 * k + 2] - rough[3 * p + 2];
            double value = nx * x + ny * y + nz * z;
            double error = ROUNDOFF
                            * (sx * (Math.abs(rough[3 * k]) + Math.abs(rough[3 * p]))
                                    + sy * (Math.abs(rough[3 * k + 1]) + Math.abs(rough[3 * p + 1]))
                                    + sz * (Math.abs(rough[3 * k + 2]) + Math.abs(rough[3 * p + 2])))
                    + AxisBody.TINY;
            if (Math.abs(value) > error) {
                double upper = k < above ? Math.signum(value) : -Math.signum(value);
                if (upper * side < 0) {
                    return false;
                }
                side = upper;
            }
        }
        return true;
    }

    /** Whether all points are in one plane, or on one line. */
    private boolean isFlat() {
        ExactVector along = null;
        ExactVector normal = null;
        for (ExactVector point : points) {
            if (point.isZero()) {
                continue;
            }
            if (along == null) {
                along = point;
            } else if (normal == null) {
                ExactVector cross = along.cross(point);
                normal = cross.isZero() ? null : cross;
            } else if (normal.dot(point).signum() != 0) {
                return false;
            }
        }
        return flat ? normal == null : true;
    }
}
