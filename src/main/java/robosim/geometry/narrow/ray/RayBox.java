package robosim.geometry.narrow.ray;

import static robosim.geometry.exact.VectorMath.UNDERFLOW;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.Filter;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * A ray against a box: the parallelepiped of its stored columns, which is the intersection of three slabs. The normal
 * of a slab is the cross product of the other two columns; its half width is the half size times the columns'
 * determinant.
 *
 * <p>The verdict is exact. Plain doubles have these bounds, in units of rounding u and of the sums of magnitudes: a
 * normal 2u, its product with the offset of the start 7u, with the direction 5u, the half width 6u. Cases left in doubt
 * go to {@link ExactSlabs}; so does a distance whose last correction is not certainly accurate.
 */
final class RayBox {
    private static final double U = Filter.bound(VectorMath.U);
    private static final double OFFSET_ERROR = 7 * U;
    private static final double SLOPE_ERROR = 5 * U;
    private static final double REST_ERROR = 10 * U;

    private static final StageCounters.Counter EXACT = StageCounters.counter("RayBox");

    private RayBox() {}

    static double distance(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        double plain = plain(ox, oy, oz, dx, dy, dz, b, j, s);
        return plain >= 0 ? plain : inSlabs(ox, oy, oz, dx, dy, dz, b, j, s);
    }

    /** The distance where plain numbers are sure of it, the same to the bit as of {@link #inSlabs}; else below 0. */
    static double plain(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        int face = PlainBoxFace.turned(ox, oy, oz, dx, dy, dz, b, j);
        return switch (face) {
            case PlainBoxFace.MISSED -> Double.POSITIVE_INFINITY;
            case PlainBoxFace.UNKNOWN -> -1;
            default -> turnedPlane(ox, oy, oz, dx, dy, dz, b, j, face, enter(ox, oy, oz, dx, dy, dz, b, j, face), s);
        };
    }

    /** Where the ray enters a slab, as {@link #inSlabs} computes it. */
    private static double enter(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, int i) {
        int r = j + Leaf.ROTATION;
        int k = r + (i == 2 ? 0 : i + 1);
        int l = r + (i == 0 ? 2 : i - 1);
        double nx = b[k + 3] * b[l + 6] - b[k + 6] * b[l + 3];
        double ny = b[k + 6] * b[l] - b[k] * b[l + 6];
        double nz = b[k] * b[l + 3] - b[k + 3] * b[l];
        double det = b[r + i] * nx + b[r + i + 3] * ny + b[r + i + 6] * nz;
        double half = b[j + Leaf.SIZE + i] * det;
        double offset = (ox - b[j]) * nx + (oy - b[j + 1]) * ny + (oz - b[j + 2]) * nz;
        double slope = dx * nx + dy * ny + dz * nz;
        return (slope > 0 ? -half - offset : half - offset) / slope;
    }

    static double inSlabs(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        RayInterval in = s.interval;
        in.reset();
        int r = j + Leaf.ROTATION;
        double mx = ox - b[j];
        double my = oy - b[j + 1];
        double mz = oz - b[j + 2];
        for (int i = 0; i < 3; i++) {
            int k = i == 2 ? 0 : i + 1;
            int l = i == 0 ? 2 : i - 1;
            double kx = b[r + k];
            double ky = b[r + k + 3];
            double kz = b[r + k + 6];
            double lx = b[r + l];
            double ly = b[r + l + 3];
            double lz = b[r + l + 6];
            double nx = ky * lz - kz * ly;
            double ny = kz * lx - kx * lz;
            double nz = kx * ly - ky * lx;
            double px = Math.abs(ky * lz) + Math.abs(kz * ly);
            double py = Math.abs(kz * lx) + Math.abs(kx * lz);
            double pz = Math.abs(kx * ly) + Math.abs(ky * lx);
            double det = b[r + i] * nx + b[r + i + 3] * ny + b[r + i + 6] * nz;
            double detSize = Math.abs(b[r + i]) * px + Math.abs(b[r + i + 3]) * py + Math.abs(b[r + i + 6]) * pz;
            double half = b[j + Leaf.SIZE + i] * det;
            double offset = mx * nx + my * ny + mz * nz;
            double offsetSize = Math.abs(mx) * px + Math.abs(my) * py + Math.abs(mz) * pz;
            double error = OFFSET_ERROR * (offsetSize + b[j + Leaf.SIZE + i] * detSize) + UNDERFLOW;
            double slope = dx * nx + dy * ny + dz * nz;
            double slopeSize = Math.abs(dx) * px + Math.abs(dy) * py + Math.abs(dz) * pz;
            in.clip(-half - offset, error, half - offset, error, slope, SLOPE_ERROR * slopeSize, i);
            if (in.isEmpty()) {
                return Double.POSITIVE_INFINITY;
            }
        }
        if (!in.isCertain()) {
            return exact(ox, oy, oz, dx, dy, dz, b, j);
        }
        if (in.face < 0) {
            return 0;
        }
        double distance = turnedPlane(ox, oy, oz, dx, dy, dz, b, j, in.face, in.enter, s);
        return distance >= 0 ? distance : exact(ox, oy, oz, dx, dy, dz, b, j);
    }

    /** A box whose own Y is the world's: two slabs in the plane, and an interval of heights. */
    static double upright(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        double plain = plainUpright(ox, oy, oz, dx, dy, dz, b, j, s);
        return plain >= 0 ? plain : inUprightSlabs(ox, oy, oz, dx, dy, dz, b, j, s);
    }

    /** The distance where plain numbers are sure of it, the same to the bit as of {@link #inUprightSlabs}; else below 0. */
    static double plainUpright(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        int face = PlainBoxFace.upright(ox, oy, oz, dx, dy, dz, b, j);
        return switch (face) {
            case PlainBoxFace.MISSED -> Double.POSITIVE_INFINITY;
            case PlainBoxFace.UNKNOWN -> -1;
            case 1 -> heightPlane(oy, b[j + 1], b[j + 4], dx, dy, dz, enterHeights(oy, b[j + 1], b[j + 4], dy));
            default -> uprightPlane(ox, oy, oz, dx, dy, dz, b, j, face, enterPlan(ox, oz, dx, dz, b, j, face), s);
        };
    }

    /** The same for a ray that certainly enters a box across one of its vertical faces, 0 or 2, from outside. */
    static double uprightFace(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double[] b,
            int j,
            int face,
            RayScratch s) {
        double t = enterPlan(ox, oz, dx, dz, b, j, face);
        return uprightPlane(ox, oy, oz, dx, dy, dz, b, j, face, t, s);
    }

    /** Where the ray enters an interval of heights, as {@link #clipHeights} has it. */
    static double enterHeights(double oy, double c, double h, double dy) {
        double offset = oy - c;
        return (dy > 0 ? -h - offset : h - offset) / dy;
    }

    /** Where the ray enters one of the two slabs in the plane, as {@link #clipPlan} has it. */
    private static double enterPlan(double ox, double oz, double dx, double dz, double[] b, int j, int face) {
        double nx = face == 0 ? b[j + 14] : -b[j + 12];
        double nz = face == 0 ? -b[j + 8] : b[j + 6];
        double det = b[j + 6] * b[j + 14] - b[j + 8] * b[j + 12];
        double half = b[j + Leaf.SIZE + face] * det;
        double offset = (ox - b[j]) * nx + (oz - b[j + 2]) * nz;
        double slope = dx * nx + dz * nz;
        return (slope > 0 ? -half - offset : half - offset) / slope;
    }

    static double inUprightSlabs(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        RayInterval in = s.interval;
        in.reset();
        if (!clipHeights(in, oy, b[j + 1], b[j + 4], dy)) {
            return Double.POSITIVE_INFINITY;
        }
        double mx = ox - b[j];
        double mz = oz - b[j + 2];
        double xx = b[j + 6];
        double xz = b[j + 12];
        double zx = b[j + 8];
        double zz = b[j + 14];
        double det = xx * zz - zx * xz;
        double detSize = Math.abs(xx * zz) + Math.abs(zx * xz);
        clipPlan(in, mx, mz, dx, dz, zz, -zx, b[j + 3], det, detSize, 0);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        clipPlan(in, mx, mz, dx, dz, -xz, xx, b[j + 5], det, detSize, 2);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        if (!in.isCertain()) {
            return exact(ox, oy, oz, dx, dy, dz, b, j);
        }
        if (in.face < 0) {
            return 0;
        }
        double distance = in.face == 1
                ? heightPlane(oy, b[j + 1], b[j + 4], dx, dy, dz, in.enter)
                : uprightPlane(ox, oy, oz, dx, dy, dz, b, j, in.face, in.enter, s);
        return distance >= 0 ? distance : exact(ox, oy, oz, dx, dy, dz, b, j);
    }

    private static void clipPlan(
            RayInterval in,
            double mx,
            double mz,
            double dx,
            double dz,
            double nx,
            double nz,
            double size,
            double det,
            double detSize,
            int id) {
        double half = size * det;
        double offset = mx * nx + mz * nz;
        double error = OFFSET_ERROR * (Math.abs(mx * nx) + Math.abs(mz * nz) + size * detSize) + UNDERFLOW;
        double slope = dx * nx + dz * nz;
        double slopeError = SLOPE_ERROR * (Math.abs(dx * nx) + Math.abs(dz * nz));
        in.clip(-half - offset, error, half - offset, error, slope, slopeError, id);
    }

    /** Clips by the heights {@code c - h <= y <= c + h}; false where nothing is left. The slab's number is 1. */
    static boolean clipHeights(RayInterval in, double oy, double c, double h, double dy) {
        double offset = oy - c;
        double low = -h - offset;
        double high = h - offset;
        boolean isExact = DoubleDouble.differenceTail(oy, c, offset) == 0
                && DoubleDouble.differenceTail(-h, offset, low) == 0
                && DoubleDouble.differenceTail(h, offset, high) == 0;
        double error = isExact ? 0 : 2 * U * (Math.abs(offset) + h);
        in.clip(low, error, high, error, dy, 0, 1);
        return !in.isEmpty();
    }

    /** The distance in world units to the horizontal plane at {@code c - h} or {@code c + h} that faces the ray. */
    static double heightPlane(double oy, double c, double h, double dx, double dy, double dz, double t) {
        double face = dy > 0 ? -h : h;
        double at = c + face;
        double way = at - oy;
        // The remainder keeps every rounding error, so the quotient is accurate for any slope.
        double wayTail = DoubleDouble.differenceTail(at, oy, way) + DoubleDouble.sumTail(c, face, at);
        double rest = Math.fma(-t, dy, way) + wayTail;
        return VectorMath.along(t, rest / dy, dx, dy, dz);
    }

    // The normal is (zz, -zx) or (-xz, xx) in the plane; nothing cancels in it.
    private static double uprightPlane(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double[] b,
            int j,
            int face,
            double t,
            RayScratch s) {
        double nx = face == 0 ? b[j + 14] : -b[j + 12];
        double nz = face == 0 ? -b[j + 8] : b[j + 6];
        double size = b[j + Leaf.SIZE + face];
        double det = b[j + 6] * b[j + 14] - b[j + 8] * b[j + 12];
        double detSize = Math.abs(b[j + 6] * b[j + 14]) + Math.abs(b[j + 8] * b[j + 12]);
        double slope = dx * nx + dz * nz;
        double slopeSize = Math.abs(dx * nx) + Math.abs(dz * nz);
        double qx = moved(ox, b[j], t, dx);
        double qz = moved(oz, b[j + 2], t, dz);
        double half = slope > 0 ? -size * det : size * det;
        double rest = qx * nx + qz * nz - half;
        double restSize = Math.abs(qx * nx) + Math.abs(qz * nz) + size * detSize;
        double correction = -rest / slope;
        double error = (REST_ERROR * restSize + Math.abs(correction) * SLOPE_ERROR * slopeSize) / Math.abs(slope);
        double distance = settled(ox, oy, oz, dx, dy, dz, b, j, t, correction, error);
        return distance >= 0
                ? distance
                : inPairs(ox, oy, oz, dx, dy, dz, b, j, face, t, correction, slope, slopeSize, restSize, s);
    }

    private static double turnedPlane(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double[] b,
            int j,
            int face,
            double t,
            RayScratch s) {
        int i = j + Leaf.ROTATION + face;
        int k = j + Leaf.ROTATION + (face == 2 ? 0 : face + 1);
        int l = j + Leaf.ROTATION + (face == 0 ? 2 : face - 1);
        double nx = b[k + 3] * b[l + 6] - b[k + 6] * b[l + 3];
        double ny = b[k + 6] * b[l] - b[k] * b[l + 6];
        double nz = b[k] * b[l + 3] - b[k + 3] * b[l];
        double px = Math.abs(b[k + 3] * b[l + 6]) + Math.abs(b[k + 6] * b[l + 3]);
        double py = Math.abs(b[k + 6] * b[l]) + Math.abs(b[k] * b[l + 6]);
        double pz = Math.abs(b[k] * b[l + 3]) + Math.abs(b[k + 3] * b[l]);
        double size = b[j + Leaf.SIZE + face];
        double det = b[i] * nx + b[i + 3] * ny + b[i + 6] * nz;
        double detSize = Math.abs(b[i]) * px + Math.abs(b[i + 3]) * py + Math.abs(b[i + 6]) * pz;
        double slope = dx * nx + dy * ny + dz * nz;
        double slopeSize = Math.abs(dx) * px + Math.abs(dy) * py + Math.abs(dz) * pz;
        double qx = moved(ox, b[j], t, dx);
        double qy = moved(oy, b[j + 1], t, dy);
        double qz = moved(oz, b[j + 2], t, dz);
        double half = slope > 0 ? -size * det : size * det;
        double rest = qx * nx + qy * ny + qz * nz - half;
        double restSize = Math.abs(qx) * px + Math.abs(qy) * py + Math.abs(qz) * pz + size * detSize;
        double correction = -rest / slope;
        double error = (REST_ERROR * restSize + Math.abs(correction) * SLOPE_ERROR * slopeSize) / Math.abs(slope);
        double distance = settled(ox, oy, oz, dx, dy, dz, b, j, t, correction, error);
        return distance >= 0
                ? distance
                : inPairs(ox, oy, oz, dx, dy, dz, b, j, face, t, correction, slope, slopeSize, restSize, s);
    }

    /** The coordinate {@code o + t d - c}, off by at most 2u of itself for the given t. */
    static double moved(double o, double c, double t, double d) {
        double offset = o - c;
        return Math.fma(t, d, offset) + DoubleDouble.differenceTail(o, c, offset);
    }

    private static double settled(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double[] b,
            int j,
            double t,
            double correction,
            double error) {
        double distance = VectorMath.along(t, correction, dx, dy, dz);
        double largest = Math.max(VectorMath.largest(ox, oy, oz), extent(b, j));
        return VectorMath.isFine(error * VectorMath.length(dx, dy, dz), distance, largest) ? distance : -1;
    }

    private static double inPairs(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double[] b,
            int j,
            int face,
            double t,
            double correction,
            double slope,
            double slopeSize,
            double restSize,
            RayScratch s) {
        RayRefine refine = s.refine;
        int r = j + Leaf.ROTATION;
        double half = slope > 0 ? -b[j + Leaf.SIZE + face] : b[j + Leaf.SIZE + face];
        refine.place(ox, oy, oz, dx, dy, dz, b[j], b[j + 1], b[j + 2], t, correction);
        double left = refine.boxFace(b, r + face, r + (face + 1) % 3, r + (face + 2) % 3, half);
        double size = restSize + 2 * Math.abs(t) * slopeSize;
        double error = RayRefine.error(left, size, slope, SLOPE_ERROR * slopeSize, 0);
        return settled(ox, oy, oz, dx, dy, dz, b, j, t, correction - left / slope, error);
    }

    private static double extent(double[] b, int j) {
        return Math.max(VectorMath.largest(b[j], b[j + 1], b[j + 2]), VectorMath.largest(b[j + 3], b[j + 4], b[j + 5]));
    }

    private static double exact(double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j) {
        EXACT.count();
        ExactRay ray = new ExactRay(ox, oy, oz, dx, dy, dz, extent(b, j));
        ExactVector offset = ray.start.minus(ray.point(b, j));
        ExactSlabs slabs = new ExactSlabs(ray, 3);
        for (int i = 0; i < 3; i++) {
            int r = j + Leaf.ROTATION;
            ExactVector own = ExactVector.of(b, r + i, 3);
            ExactVector normal = ExactVector.of(b, r + (i + 1) % 3, 3).cross(ExactVector.of(b, r + (i + 2) % 3, 3));
            Dyadic half = ray.length(b[j + Leaf.SIZE + i]).multiply(own.dot(normal));
            slabs.add(half.negate(), offset.dot(normal), half, ray.direction.dot(normal));
        }
        return slabs.distance();
    }
}
