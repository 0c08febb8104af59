package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.planar.DiscRectangle;
import robosim.geometry.narrow.planar.ExactPolygon;

/** A ray and a rectangle, the projection of an upright box. */
public final class RayRectangle {
    // With u = 2^-53: in the rectangle's frame, a coordinate of the start is off by 3u of |dx| + |dz|, one of the
    // direction by 2u. The half size times the squared length is off by 3u; times such a direction and added to
    // another, by 4u. Differences preserve their sign. Directions of the rectangle are no longer than 1 + 1e-9.
    private static final double FILTER = FilterBound.bound(4.01 * 0x1p-53);
    private static final double UNDERFLOW = 0x1p-960;

    // The side that a ray enters is decided by products: how far it starts beyond one side times its speed across the
    // other. Each is off by two of these bounds. The quotients used in their place are off by 6u, less than two more.
    private static final double SURE = 16;

    private static final StageCounters.Counter EXACT = StageCounters.counter("RayRectangle");

    private RayRectangle() {}

    /**
     * Distance in world units; whether it hits is exact. Of the rotation only the first own axis is read, as it
     * determines the other: rows of many objects are far apart in memory.
     */
    static double distance(BeamAxis ray, double[] row, int at) {
        double sure = sure(ray, row[at], row[at + 2], row[at + 3], row[at + 5], row[at + 6], row[at + 8]);
        return Double.isNaN(sure) ? doubtful(ray, row, at) : sure;
    }

    /** The same for a rectangle given by numbers and the cosine and sine of its heading; NaN in doubt. */
    public static double sure(BeamAxis ray, double cx, double cz, double hx, double hz, double cos, double sin) {
        double dx = ray.ox - cx;
        double dz = ray.oz - cz;
        double square = cos * cos + sin * sin;
        double size = Math.abs(dx) + Math.abs(dz) + hx + hz;
        double speed = Math.abs(ray.dx) + Math.abs(ray.dz);
        // The start and the direction in the rectangle's own frame.
        double startX = dx * cos - dz * sin;
        double startZ = dx * sin + dz * cos;
        double wayX = ray.dx * cos - ray.dz * sin;
        double wayZ = ray.dx * sin + ray.dz * cos;
        double doubt = FILTER * size + UNDERFLOW;
        double wayDoubt = FILTER * speed + UNDERFLOW;
        double beyondX = Math.abs(startX) - hx * square;
        double beyondZ = Math.abs(startZ) - hz * square;
        // Positive where the ray approaches the rectangle along each of its axes; not used where the start is at 0.
        double nearingX = VectorMath.signed(-wayX, startX);
        double nearingZ = VectorMath.signed(-wayZ, startZ);
        double past = Math.abs(dx * ray.dz - dz * ray.dx) - (hx * Math.abs(wayZ) + hz * Math.abs(wayX));
        double pastDoubt = doubt * speed + UNDERFLOW;
        // Comparisons by the signs of differences, without branches: half of the branches would be mispredicted.
        long insideX = bits(beyondX + doubt);
        long insideZ = bits(beyondZ + doubt);
        if ((insideX & insideZ) < 0) {
            return 0;
        }
        long leavesX = bits(doubt - beyondX) & bits(nearingX + wayDoubt);
        long leavesZ = bits(doubt - beyondZ) & bits(nearingZ + wayDoubt);
        if ((bits(pastDoubt - past) | leavesX | leavesZ) < 0) {
            return Double.POSITIVE_INFINITY;
        }
        // For an almost degenerate side it may be in doubt on which side of it the ray starts.
        long meetsX = insideX | (bits(wayDoubt - nearingX) & bits(doubt - Math.abs(startX)));
        long meetsZ = insideZ | (bits(wayDoubt - nearingZ) & bits(doubt - Math.abs(startZ)));
        if ((bits(past + pastDoubt) & meetsX & meetsZ) < 0) {
            double later = beyondX * Math.abs(wayZ) - beyondZ * Math.abs(wayX);
            // The side across the own X or the own Z, with the same bits as where both are computed.
            double nx = VectorMath.pick(later, cos, sin);
            double nz = VectorMath.pick(later, -sin, cos);
            double way = Math.abs(DoubleDouble.sumOfProducts(ray.dx, nx, ray.dz, nz));
            double far = DiscRectangle.gap(ray.ox, ray.oz, cx, cz, nx, nz, VectorMath.pick(later, hx, hz))
                    / way
                    * Math.sqrt(ray.dx * ray.dx + ray.dz * ray.dz);
            // Nearer than the centre, so the farthest corner need not be computed. Not above 0 where the start is
            // within
            // the filter's doubt of the side, on it or beyond it.
            return far > 0
                            && Math.abs(later) > SURE * pastDoubt
                            && far * far * (1 + 0x1p-50) + UNDERFLOW < dx * dx + dz * dz
                    ? far
                    : entry(ray, cx, cz, hx, hz, cos, sin);
        }
        return Double.NaN;
    }

    /**
     * The same distance for a ray that certainly enters a rectangle along the axes across one of its sides, from outside.
     *
     * @param isAcrossX whether that is a side across X
     */
    public static double side(BeamAxis ray, double[] row, int at, boolean isAcrossX) {
        double nx = isAcrossX ? 1 : 0;
        double nz = isAcrossX ? 0 : 1;
        double gap = DiscRectangle.gap(ray.ox, ray.oz, row[at], row[at + 2], nx, nz, row[at + (isAcrossX ? 3 : 5)]);
        return gap / Math.abs(isAcrossX ? ray.dx : ray.dz) * Math.sqrt(ray.dx * ray.dx + ray.dz * ray.dz);
    }

    private static long bits(double number) {
        return Double.doubleToRawLongBits(number);
    }

    private static double doubtful(BeamAxis ray, double[] row, int at) {
        EXACT.count();
        ExactPolygon exact = ExactPolygon.of(LeafKind.UPRIGHT_BOX, row, at);
        if (exact.contains(ray.ox, ray.oz)) {
            return 0;
        }
        return exact.isHitBy(ray.ox, ray.oz, ray.dx, ray.dz)
                ? entry(ray, row[at], row[at + 2], row[at + 3], row[at + 5], row[at + 6], row[at + 8])
                : Double.POSITIVE_INFINITY;
    }

    // The later of the two sides that the start is beyond, for a ray that is known to hit.
    private static double entry(BeamAxis ray, double cx, double cz, double hx, double hz, double cos, double sin) {
        double share = 0;
        double gapX = DiscRectangle.gap(ray.ox, ray.oz, cx, cz, cos, -sin, hx);
        if (gapX > 0) {
            double way = Math.abs(DoubleDouble.differenceOfProducts(ray.dx, cos, ray.dz, sin));
            share = way > 0 ? gapX / way : 0;
        }
        double gapZ = DiscRectangle.gap(ray.ox, ray.oz, cx, cz, sin, cos, hz);
        if (gapZ > 0) {
            double way = Math.abs(DoubleDouble.sumOfProducts(ray.dx, sin, ray.dz, cos));
            share = way > 0 ? Math.max(share, gapZ / way) : share;
        }
        // No point of the rectangle is farther than this: it limits the distance of a hit along a side.
        double dx = ray.ox - cx;
        double dz = ray.oz - cz;
        double most = Math.sqrt(dx * dx + dz * dz) + Math.sqrt(hx * hx + hz * hz) * (1 + 0x1p-29);
        return Math.min(share * Math.sqrt(ray.dx * ray.dx + ray.dz * ray.dz), most * (1 + 0x1p-50));
    }
}
