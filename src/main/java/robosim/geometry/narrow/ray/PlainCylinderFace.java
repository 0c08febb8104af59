package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.FilterBound;

/**
 * Which face of a cylinder a ray enters by, in plain numbers, where these are sure of it by a wide margin: the first
 * stage of {@link RayCylinder}, which most rays need no other than.
 *
 * <p>With S = {@link #SLACK} of all coordinates and sizes, u = 2^-53, and what the conditions below leave (a slope of
 * the side {@code |p| >= 2^-5 |d|}, half a chord of at least 2^-10 r): {@code p.m} is off by at most 14u |d||m|, so the
 * line's distance from the axis by 2^-44 |m|; half the chord by 2^10 times that, and 2^-34 r; where the ray meets the
 * side by 2^-33 of the sizes over {@code |p|}; the height there by 2^-28 of them, and as much for an axis whose
 * square is 1 but for {@link #UNIT}. All of this is less than S, and the intervals of {@link RayCylinder} are narrower still, so that it comes to
 * the same verdict.
 */
final class PlainCylinderFace {
    static final int UNKNOWN = -1;
    static final int MISSED = -2;
    static final int INSIDE = 0;
    static final int SIDE = 1;
    static final int CAP = 2;

    private static final double SLACK = FilterBound.bound(0x1p-24);

    /** Below this, squares and their products with squared slopes might underflow. */
    private static final double SMALLEST = 0x1p-300;

    /** An axis whose square differs from 1 by more, which no rotation's does, is left to the other stages. */
    private static final double UNIT = 0x1p-28;

    /** The least squared sine of the angle between the ray and the axis. */
    private static final double STEEPEST = 0x1p-10;

    /** The least slope against the axis, as a share of the direction, that is certainly not 0. */
    private static final double LEVEL = FilterBound.bound(0x1p-40);

    /** The least share of the radius, squared, that half the chord is. */
    private static final double GRAZING = 0x1p-20;

    /** Where the ray enters the side, after {@link #SIDE}: to the bit what {@link RayCylinder} computes. */
    double enter;

    /** The face that a ray enters by. */
    int face(BeamAxis ray, PlacedCylinder c) {
        double mx = ray.ox - c.cx;
        double my = ray.oy - c.cy;
        double mz = ray.oz - c.cz;
        double r = c.r;
        // At least the sum of the magnitudes of all that enters.
        double size = Math.abs(ray.ox)
                + Math.abs(ray.oy)
                + Math.abs(ray.oz)
                + (Math.abs(c.cx) + Math.abs(c.cy) + Math.abs(c.cz))
                + (r + c.h);
        double slack = SLACK * size;
        double px = ray.dy * c.az - ray.dz * c.ay;
        double py = ray.dz * c.ax - ray.dx * c.az;
        double pz = ray.dx * c.ay - ray.dy * c.ax;
        double pp = px * px + py * py + pz * pz;
        double dd = ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz;
        double aa = c.square();
        if (!(pp > STEEPEST * dd && size > SMALLEST && Math.abs(aa - 1) < UNIT)) {
            return UNKNOWN;
        }
        double g = px * mx + py * my + pz * mz;
        double reach = r + slack;
        if (g * g > reach * reach * pp) {
            return MISSED;
        }
        double slope = ray.dx * c.ax + ray.dy * c.ay + ray.dz * c.az;
        double chord = r * r * pp - g * g;
        if (!(chord > GRAZING * (r * r * pp) && r > slack && isSure(slope, ray.dy, dd, c.ax, c.az))) {
            return UNKNOWN;
        }
        double wx = my * c.az - mz * c.ay;
        double wy = mz * c.ax - mx * c.az;
        double wz = mx * c.ay - my * c.ax;
        double middle = -(px * wx + py * wy + pz * wz);
        double root = Math.sqrt(aa * chord);
        double first = (middle - root) / pp;
        double last = (middle + root) / pp;
        double tie = slack * slack / pp;
        boolean isClear = first * first > tie && last * last > tie;
        if (!isClear) {
            return UNKNOWN;
        }
        return last < 0 ? MISSED : between(mx * c.ax + my * c.ay + mz * c.az, slope, first, last, c.h, slack);
    }

    /** Whether a ray certainly rises or falls along an axis, or is at a right angle to it and nothing was rounded. */
    private static boolean isSure(double slope, double dy, double dd, double ax, double az) {
        return slope * slope > LEVEL * LEVEL * dd || (dy == 0 && ax == 0 && az == 0);
    }

    /** The face of a ray that is inside the infinite cylinder between two parameters. */
    private int between(double along, double slope, double first, double last, double h, double slack) {
        // Heights as the ray goes through them, rising.
        double from = first > 0 ? along + first * slope : along;
        double to = along + last * slope;
        double low = slope > 0 ? from : -from;
        double high = slope > 0 ? to : -to;
        if (low > h + slack || high < -h - slack) {
            return MISSED;
        }
        if (Math.abs(low) < h - slack) {
            enter = first;
            return first > 0 ? SIDE : INSIDE;
        }
        return h > slack && low < -h - slack && high > slack - h ? CAP : UNKNOWN;
    }
}
