package robosim.geometry.narrow.ray;

import static robosim.geometry.exact.VectorMath.UNDERFLOW;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.FilterBound;
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
public final class RayBox {
    private static final double U = FilterBound.bound(VectorMath.U);
    private static final double OFFSET_ERROR = 7 * U;
    private static final double SLOPE_ERROR = 5 * U;
    private static final double REST_ERROR = 10 * U;

    private static final StageCounters.Counter EXACT = StageCounters.counter("RayBox");

    private RayBox() {}

    static double distance(BeamAxis ray, double[] b, int j, RayScratch s) {
        double plain = plain(ray, b, j, s);
        return plain >= 0 ? plain : inSlabs(ray, b, j, s);
    }

    /** The distance where plain numbers are sure of it, the same to the bit as of {@link #inSlabs}; else below 0. */
    static double plain(BeamAxis ray, double[] b, int j, RayScratch s) {
        int face = PlainBoxFace.turned(ray, b, j);
        return switch (face) {
            case PlainBoxFace.MISSED -> Double.POSITIVE_INFINITY;
            case PlainBoxFace.UNKNOWN -> -1;
            default -> turnedPlane(ray, b, j, face, enter(ray, b, j, face), s);
        };
    }

    /** Where the ray enters a slab, as {@link #inSlabs} computes it. */
    private static double enter(BeamAxis ray, double[] b, int j, int i) {
        int r = j + Leaf.ROTATION;
        int k = r + (i == 2 ? 0 : i + 1);
        int l = r + (i == 0 ? 2 : i - 1);
        double nx = b[k + 3] * b[l + 6] - b[k + 6] * b[l + 3];
        double ny = b[k + 6] * b[l] - b[k] * b[l + 6];
        double nz = b[k] * b[l + 3] - b[k + 3] * b[l];
        double det = b[r + i] * nx + b[r + i + 3] * ny + b[r + i + 6] * nz;
        double half = b[j + Leaf.SIZE + i] * det;
        double offset = (ray.ox - b[j]) * nx + (ray.oy - b[j + 1]) * ny + (ray.oz - b[j + 2]) * nz;
        double slope = ray.dx * nx + ray.dy * ny + ray.dz * nz;
        return (slope > 0 ? -half - offset : half - offset) / slope;
    }

    static double inSlabs(BeamAxis ray, double[] b, int j, RayScratch s) {
        RayInterval in = s.interval;
        in.reset();
        int r = j + Leaf.ROTATION;
        double mx = ray.ox - b[j];
        double my = ray.oy - b[j + 1];
        double mz = ray.oz - b[j + 2];
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
            double slope = ray.dx * nx + ray.dy * ny + ray.dz * nz;
            double slopeSize = Math.abs(ray.dx) * px + Math.abs(ray.dy) * py + Math.abs(ray.dz) * pz;
            in.clip(-half - offset, error, half - offset, error, slope, SLOPE_ERROR * slopeSize, i);
            if (in.isEmpty()) {
                return Double.POSITIVE_INFINITY;
            }
        }
        if (!in.isCertain()) {
            return exact(ray, b, j);
        }
        if (in.face < 0) {
            return 0;
        }
        double distance = turnedPlane(ray, b, j, in.face, in.enter, s);
        return distance >= 0 ? distance : exact(ray, b, j);
    }

    /** A box whose own Y is the world's: two slabs in the plane, and an interval of heights. */
    static double upright(BeamAxis ray, double[] b, int j, RayScratch s) {
        double plain = plainUpright(ray, b, j, s);
        return plain >= 0 ? plain : inUprightSlabs(ray, b, j, s);
    }

    /** The distance where plain numbers are sure of it, the same to the bit as of {@link #inUprightSlabs}; else below 0. */
    static double plainUpright(BeamAxis ray, double[] b, int j, RayScratch s) {
        int face = PlainBoxFace.upright(ray, b, j);
        return switch (face) {
            case PlainBoxFace.MISSED -> Double.POSITIVE_INFINITY;
            case PlainBoxFace.UNKNOWN -> -1;
            case 1 -> heightPlane(ray, b[j + 1], b[j + 4], enterHeights(ray, b[j + 1], b[j + 4]));
            default -> uprightPlane(ray, b, j, face, enterPlan(ray, b, j, face), s);
        };
    }

    /** The same for a ray that certainly enters a box across one of its vertical faces, 0 or 2, from outside. */
    public static double uprightFace(BeamAxis ray, double[] b, int j, int face, RayScratch s) {
        double t = enterPlan(ray, b, j, face);
        return uprightPlane(ray, b, j, face, t, s);
    }

    /** Where the ray enters an interval of heights, as {@link #clipHeights} has it. */
    static double enterHeights(BeamAxis ray, double c, double h) {
        double offset = ray.oy - c;
        return (ray.dy > 0 ? -h - offset : h - offset) / ray.dy;
    }

    /** Where the ray enters one of the two slabs in the plane, as {@link #clipPlan} has it. */
    private static double enterPlan(BeamAxis ray, double[] b, int j, int face) {
        double nx = face == 0 ? b[j + 14] : -b[j + 12];
        double nz = face == 0 ? -b[j + 8] : b[j + 6];
        double det = b[j + 6] * b[j + 14] - b[j + 8] * b[j + 12];
        double half = b[j + Leaf.SIZE + face] * det;
        double offset = (ray.ox - b[j]) * nx + (ray.oz - b[j + 2]) * nz;
        double slope = ray.dx * nx + ray.dz * nz;
        return (slope > 0 ? -half - offset : half - offset) / slope;
    }

    static double inUprightSlabs(BeamAxis ray, double[] b, int j, RayScratch s) {
        RayInterval in = s.interval;
        in.reset();
        clipHeights(in, ray, b[j + 1], b[j + 4]);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        clipPlan(in, ray, b, j, 0);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        clipPlan(in, ray, b, j, 2);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        if (!in.isCertain()) {
            return exact(ray, b, j);
        }
        if (in.face < 0) {
            return 0;
        }
        double distance = in.face == 1
                ? heightPlane(ray, b[j + 1], b[j + 4], in.enter)
                : uprightPlane(ray, b, j, in.face, in.enter, s);
        return distance >= 0 ? distance : exact(ray, b, j);
    }

    private static void clipPlan(RayInterval in, BeamAxis ray, double[] b, int j, int face) {
        double nx = face == 0 ? b[j + 14] : -b[j + 12];
        double nz = face == 0 ? -b[j + 8] : b[j + 6];
        double size = b[j + Leaf.SIZE + face];
        double det = b[j + 6] * b[j + 14] - b[j + 8] * b[j + 12];
        double detSize = Math.abs(b[j + 6] * b[j + 14]) + Math.abs(b[j + 8] * b[j + 12]);
        double mx = ray.ox - b[j];
        double mz = ray.oz - b[j + 2];
        double half = size * det;
        double offset = mx * nx + mz * nz;
        double error = OFFSET_ERROR * (Math.abs(mx * nx) + Math.abs(mz * nz) + size * detSize) + UNDERFLOW;
        double slope = ray.dx * nx + ray.dz * nz;
        double slopeError = SLOPE_ERROR * (Math.abs(ray.dx * nx) + Math.abs(ray.dz * nz));
        in.clip(-half - offset, error, half - offset, error, slope, slopeError, face);
    }

    /** Clips by the heights {@code c - h <= y <= c + h}; the slab's number is 1. */
    static void clipHeights(RayInterval in, BeamAxis ray, double c, double h) {
        double offset = ray.oy - c;
        double low = -h - offset;
        double high = h - offset;
        boolean isExact = DoubleDouble.differenceTail(ray.oy, c, offset) == 0
                && DoubleDouble.differenceTail(-h, offset, low) == 0
                && DoubleDouble.differenceTail(h, offset, high) == 0;
        double error = isExact ? 0 : 2 * U * (Math.abs(offset) + h);
        in.clip(low, error, high, error, ray.dy, 0, 1);
    }

    /** The distance in world units to the horizontal plane at {@code c - h} or {@code c + h} that faces the ray. */
    static double heightPlane(BeamAxis ray, double c, double h, double t) {
        double face = ray.dy > 0 ? -h : h;
        double at = c + face;
        double way = at - ray.oy;
        // The remainder keeps every rounding error, so the quotient is accurate for any slope.
        double wayTail = DoubleDouble.differenceTail(at, ray.oy, way) + DoubleDouble.sumTail(c, face, at);
        double rest = Math.fma(-t, ray.dy, way) + wayTail;
        return ray.along(t, rest / ray.dy);
    }

    // The normal is (zz, -zx) or (-xz, xx) in the plane; nothing cancels in it.
    private static double uprightPlane(BeamAxis ray, double[] b, int j, int face, double t, RayScratch s) {
        double nx = face == 0 ? b[j + 14] : -b[j + 12];
        double nz = face == 0 ? -b[j + 8] : b[j + 6];
        double size = b[j + Leaf.SIZE + face];
        double det = b[j + 6] * b[j + 14] - b[j + 8] * b[j + 12];
        double detSize = Math.abs(b[j + 6] * b[j + 14]) + Math.abs(b[j + 8] * b[j + 12]);
        double slope = ray.dx * nx + ray.dz * nz;
        double slopeSize = Math.abs(ray.dx * nx) + Math.abs(ray.dz * nz);
        double qx = moved(ray.ox, b[j], t, ray.dx);
        double qz = moved(ray.oz, b[j + 2], t, ray.dz);
        double half = slope > 0 ? -size * det : size * det;
        double rest = qx * nx + qz * nz - half;
        double restSize = Math.abs(qx * nx) + Math.abs(qz * nz) + size * detSize;
        double correction = -rest / slope;
        double error = (REST_ERROR * restSize + Math.abs(correction) * SLOPE_ERROR * slopeSize) / Math.abs(slope);
        double distance = settled(ray, b, j, t, correction, error);
        if (distance >= 0) {
            return distance;
        }
        RayRefine refine = s.refine;
        refine.place(ray, b[j], b[j + 1], b[j + 2], t, correction);
        double left = refine.boxFace(b, j, face, slope > 0 ? -size : size);
        double leftSize = restSize + 2 * Math.abs(t) * slopeSize;
        return refine.settled(left, leftSize, slope, SLOPE_ERROR * slopeSize, 0, Math.max(ray.largest(), extent(b, j)));
    }

    private static double turnedPlane(BeamAxis ray, double[] b, int j, int face, double t, RayScratch s) {
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
        double slope = ray.dx * nx + ray.dy * ny + ray.dz * nz;
        double slopeSize = Math.abs(ray.dx) * px + Math.abs(ray.dy) * py + Math.abs(ray.dz) * pz;
        double qx = moved(ray.ox, b[j], t, ray.dx);
        double qy = moved(ray.oy, b[j + 1], t, ray.dy);
        double qz = moved(ray.oz, b[j + 2], t, ray.dz);
        double half = slope > 0 ? -size * det : size * det;
        double rest = qx * nx + qy * ny + qz * nz - half;
        double restSize = Math.abs(qx) * px + Math.abs(qy) * py + Math.abs(qz) * pz + size * detSize;
        double correction = -rest / slope;
        double error = (REST_ERROR * restSize + Math.abs(correction) * SLOPE_ERROR * slopeSize) / Math.abs(slope);
        double distance = settled(ray, b, j, t, correction, error);
        if (distance >= 0) {
            return distance;
        }
        RayRefine refine = s.refine;
        refine.place(ray, b[j], b[j + 1], b[j + 2], t, correction);
        double left = refine.boxFace(b, j, face, slope > 0 ? -size : size);
        double leftSize = restSize + 2 * Math.abs(t) * slopeSize;
        return refine.settled(left, leftSize, slope, SLOPE_ERROR * slopeSize, 0, Math.max(ray.largest(), extent(b, j)));
    }

    /** The coordinate {@code o + t d - c}, off by at most 2u of itself for the given t. */
    static double moved(double o, double c, double t, double d) {
        double offset = o - c;
        return Math.fma(t, d, offset) + DoubleDouble.differenceTail(o, c, offset);
    }

    private static double settled(BeamAxis ray, double[] b, int j, double t, double correction, double error) {
        double distance = ray.along(t, correction);
        double largest = Math.max(ray.largest(), extent(b, j));
        return VectorMath.isFine(error * ray.length(), distance, largest) ? distance : -1;
    }

    private static double extent(double[] b, int j) {
        return Math.max(VectorMath.largest(b[j], b[j + 1], b[j + 2]), VectorMath.largest(b[j + 3], b[j + 4], b[j + 5]));
    }

    private static double exact(BeamAxis ray, double[] b, int j) {
        EXACT.count();
        ExactRay exact = new ExactRay(ray, extent(b, j));
        ExactVector offset = exact.start.minus(exact.point(b, j));
        ExactSlabs slabs = new ExactSlabs(exact, 3);
        for (int i = 0; i < 3; i++) {
            int r = j + Leaf.ROTATION;
            ExactVector own = ExactVector.of(b, r + i, 3);
            ExactVector normal = ExactVector.of(b, r + (i + 1) % 3, 3).cross(ExactVector.of(b, r + (i + 2) % 3, 3));
            Dyadic half = exact.length(b[j + Leaf.SIZE + i]).multiply(own.dot(normal));
            slabs.add(half.negate(), offset.dot(normal), half, exact.direction.dot(normal));
        }
        return slabs.distance();
    }
}
