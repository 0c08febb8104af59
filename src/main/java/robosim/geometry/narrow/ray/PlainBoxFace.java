package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * Which face of a box a ray enters by, in plain numbers, where these are sure of it by a wide margin: the first stage of
 * {@link RayBox}, which most rays need no other than.
 */
final class PlainBoxFace {
    static final int UNKNOWN = -1;
    static final int MISSED = -2;

    /**
     * The share of all coordinates that covers the roundings of this stage and how far columns are from orthonormal: up to 1e-9
     * for each product of two columns, hence less than 1e-8 of what is taken to the box's own frame.
     */
    private static final double ERROR = FilterBound.bound(0x1p-25);

    private static final double UNDERFLOW = FilterBound.bound(0x1p-800);

    private PlainBoxFace() {}

    /** The face, by the number of its axis. */
    static int turned(BeamAxis ray, double[] b, int j) {
        double mx = ray.ox - b[j];
        double my = ray.oy - b[j + 1];
        double mz = ray.oz - b[j + 2];
        int r = j + Leaf.ROTATION;
        double alongX = ray.dx * b[r] + ray.dy * b[r + 3] + ray.dz * b[r + 6];
        double alongY = ray.dx * b[r + 1] + ray.dy * b[r + 4] + ray.dz * b[r + 7];
        double alongZ = ray.dx * b[r + 2] + ray.dy * b[r + 5] + ray.dz * b[r + 8];
        if (isFlat(alongX, alongY, alongZ, ray)
                && (isInDoubt(alongX, ray, b, r + 1, r + 2)
                        || isInDoubt(alongY, ray, b, r + 2, r)
                        || isInDoubt(alongZ, ray, b, r, r + 1))) {
            return UNKNOWN;
        }
        return inOwnFrame(
                mx * b[r] + my * b[r + 3] + mz * b[r + 6],
                mx * b[r + 1] + my * b[r + 4] + mz * b[r + 7],
                mx * b[r + 2] + my * b[r + 5] + mz * b[r + 8],
                alongX,
                alongY,
                alongZ,
                b,
                j + Leaf.SIZE,
                slack(ray, b, j));
    }

    /** The same of a box whose own Y is the world's. */
    static int upright(BeamAxis ray, double[] b, int j) {
        double mx = ray.ox - b[j];
        double mz = ray.oz - b[j + 2];
        double alongX = ray.dx * b[j + 6] + ray.dz * b[j + 12];
        double alongZ = ray.dx * b[j + 8] + ray.dz * b[j + 14];
        if (isFlat(alongX, ray.dy, alongZ, ray)
                && (isInDoubt(alongX, ray, ray.dx * b[j + 14], 0, ray.dz * b[j + 8])
                        || isInDoubt(alongZ, ray, ray.dx * b[j + 12], 0, ray.dz * b[j + 6]))) {
            return UNKNOWN;
        }
        return inOwnFrame(
                mx * b[j + 6] + mz * b[j + 12],
                ray.oy - b[j + 1],
                mx * b[j + 8] + mz * b[j + 14],
                alongX,
                ray.dy,
                alongZ,
                b,
                j + Leaf.SIZE,
                slack(ray, b, j));
    }

    private static double slack(BeamAxis ray, double[] b, int j) {
        return ERROR
                        * (size(ray.ox, ray.oy, ray.oz)
                                + size(b[j], b[j + 1], b[j + 2])
                                + size(b[j + 3], b[j + 4], b[j + 5]))
                + UNDERFLOW;
    }

    /** Whether a ray may be parallel to a slab: whether one of its slopes is nearly 0. */
    private static boolean isFlat(double x, double y, double z, BeamAxis ray) {
        return !(Math.min(Math.min(Math.abs(x), Math.abs(y)), Math.abs(z)) > ERROR * size(ray.dx, ray.dy, ray.dz));
    }

    /** The same for one slope to a slab, whose normal is the cross product of two columns. */
    private static boolean isInDoubt(double slope, BeamAxis ray, double[] b, int k, int l) {
        return isInDoubt(
                slope,
                ray,
                ray.dx * size(b[k + 3] * b[l + 6], b[k + 6] * b[l + 3], 0),
                ray.dy * size(b[k + 6] * b[l], b[k] * b[l + 6], 0),
                ray.dz * size(b[k] * b[l + 3], b[k + 3] * b[l], 0));
    }

    /** Whether a slope is nearly 0 and something was rounded, which the slabs leave to exact numbers. */
    private static boolean isInDoubt(double slope, BeamAxis ray, double partX, double partY, double partZ) {
        return !(Math.abs(slope) > ERROR * size(ray.dx, ray.dy, ray.dz)) && size(partX, partY, partZ) != 0;
    }

    private static double size(double x, double y, double z) {
        return Math.abs(x) + Math.abs(y) + Math.abs(z);
    }

    /**
     * The slab that a ray certainly enters last, from outside, in the box's own frame, to which the stored columns take it as
     * if they were orthonormal: all half sizes are taken larger and smaller by more than that and the roundings may matter.
     *
     * @param x the start
     * @param dx the direction
     * @param at where the half sizes begin
     */
    private static int inOwnFrame(
            double x, double y, double z, double dx, double dy, double dz, double[] b, int at, double slack) {
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        // How far the centre is ahead along each axis. Where the ray is parallel to a slab, a quotient is infinite or
        // no
        // number, which is never certain.
        double aheadX = dx > 0 ? -x : x;
        double aheadY = dy > 0 ? -y : y;
        double aheadZ = dz > 0 ? -z : z;
        double nearX = aheadX - b[at];
        double nearY = aheadY - b[at + 1];
        double nearZ = aheadZ - b[at + 2];
        double farX = aheadX + b[at];
        double farY = aheadY + b[at + 1];
        double farZ = aheadZ + b[at + 2];
        double earlyX = (nearX - slack) * ix;
        double earlyY = (nearY - slack) * iy;
        double earlyZ = (nearZ - slack) * iz;
        double first = Math.max(Math.max(earlyX, earlyY), Math.max(earlyZ, 0));
        if (first > Math.min(Math.min((farX + slack) * ix, (farY + slack) * iy), (farZ + slack) * iz)) {
            return MISSED;
        }
        double leave = Math.min(Math.min((farX - slack) * ix, (farY - slack) * iy), (farZ - slack) * iz);
        double lateX = (nearX + slack) * ix;
        double lateY = (nearY + slack) * iy;
        double lateZ = (nearZ + slack) * iz;
        if (!(first > 0 && Math.max(Math.max(lateX, lateY), lateZ) <= leave)) {
            return UNKNOWN;
        }
        if (earlyX >= Math.max(lateY, lateZ)) {
            return 0;
        }
        if (earlyY >= Math.max(lateX, lateZ)) {
            return 1;
        }
        return earlyZ >= Math.max(lateX, lateY) ? 2 : UNKNOWN;
    }
}
