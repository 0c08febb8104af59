package robosim.geometry.narrow.ray;

import static robosim.geometry.exact.VectorMath.UNDERFLOW;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;

/**
 * A ray against a solid capsule: the nearest of the cylinder about its segment and the spheres about the segment's
 * ends. The verdict is exact.
 *
 * <p>The ends {@code c + h a} are not representable as doubles. Relative to the ray's start, they are computed in
 * doubles with a bound, then in pairs of doubles, then exactly.
 */
final class RayCapsule {
    private static final double U = FilterBound.bound(VectorMath.U);

    /**
     * The error of a sum of products in pairs of doubles, as a share of its terms: about ten steps of 2^-102 to 2^-100.
     */
    private static final double PAIRS_ERROR = FilterBound.bound(0x1p-94);

    /** The bounding sphere of a capsule is enlarged by this factor, for its own rounding and that of the test. */
    private static final double AROUND = 1 + 0x1p-40;

    private static final StageCounters.Counter PAIRS = StageCounters.counter("RayCapsule.pairs");
    private static final StageCounters.Counter EXACT = StageCounters.counter("RayCapsule");

    private static final int PLACE = 0;
    private static final int WAY = 3;
    private static final int CROSS = 6;
    private static final int OUTSIDE = 9;
    private static final int AHEAD = 10;
    private static final int CHORD = 11;
    private static final int SQUARE = 12;
    private static final int TEMPORARY = 13; // uses the next pair too

    /** How many pairs of doubles the ends need. */
    static final int PAIRS_NEEDED = 16;

    private RayCapsule() {}

    static double distance(BeamAxis ray, PlacedCylinder c, RayScratch s) {
        if (missesAround(ray, c)) {
            return Double.POSITIVE_INFINITY;
        }
        double side = RayCylinder.distance(ray, c, s);
        if (side == 0) {
            return 0;
        }
        double end = end(ray, c, c.h, side, s);
        if (end == 0) {
            return 0;
        }
        double nearest = Math.min(side, end);
        return Math.min(nearest, end(ray, c, -c.h, nearest, s));
    }

    /** Whether a ray certainly misses the bounding sphere of a capsule, whose centre is at m from the ray's start. */
    private static boolean missesAround(BeamAxis ray, PlacedCylinder c) {
        double mx = c.cx - ray.ox;
        double my = c.cy - ray.oy;
        double mz = c.cz - ray.oz;
        double reach = (c.h * (Math.abs(c.ax) + Math.abs(c.ay) + Math.abs(c.az)) + c.r) * AROUND;
        double mm = mx * mx + my * my + mz * mz;
        if (!(mm > reach * reach * AROUND + UNDERFLOW)) {
            return false;
        }
        double ahead = mx * ray.dx + my * ray.dy + mz * ray.dz;
        double wx = my * ray.dz - mz * ray.dy;
        double wy = mz * ray.dx - mx * ray.dz;
        double wz = mx * ray.dy - my * ray.dx;
        double dd = ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz;
        // The cross product is off by a few roundings of m d, so its square by twice as many of m d times the product.
        return (ahead < 0 && ahead * ahead > 0x1p-80 * mm * dd)
                || wx * wx + wy * wy + wz * wz > reach * reach * dd * AROUND + 0x1p-40 * mm * dd + UNDERFLOW;
    }

    /**
     * The sphere about one end of the segment.
     *
     * @param along   from the centre to the end, signed, in lengths of the axis
     * @param nearest anything farther than this does not matter
     */
    private static double end(BeamAxis ray, PlacedCylinder c, double along, double nearest, RayScratch s) {
        double mx = c.cx - ray.ox + along * c.ax;
        double my = c.cy - ray.oy + along * c.ay;
        double mz = c.cz - ray.oz + along * c.az;
        double r = c.r;
        // A coordinate: offset 1u, product 1u, sum 1u of the magnitudes; all of them together, as a length.
        double off = 3
                * U
                * (Math.abs(c.cx - ray.ox)
                        + Math.abs(c.cy - ray.oy)
                        + Math.abs(c.cz - ray.oz)
                        + Math.abs(along) * (Math.abs(c.ax) + Math.abs(c.ay) + Math.abs(c.az)));
        double mm = mx * mx + my * my + mz * mz;
        double m = Math.sqrt(mm) + off;
        double outside = mm - r * r;
        double outsideError = off * (2 * m + off) + 5 * U * (mm + r * r) + UNDERFLOW;
        if (outside < -outsideError) {
            return 0;
        }
        boolean isOutside = outside > outsideError;
        double dd = ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz;
        double d = Math.sqrt(dd);
        double ahead = mx * ray.dx + my * ray.dy + mz * ray.dz;
        double aheadError = (off + 4 * U * m) * d + UNDERFLOW;
        if (isOutside && ahead < -aheadError) {
            return Double.POSITIVE_INFINITY;
        }
        double wx = my * ray.dz - mz * ray.dy;
        double wy = mz * ray.dx - mx * ray.dz;
        double wz = mx * ray.dy - my * ray.dx;
        double ww = wx * wx + wy * wy + wz * wz;
        double chord = r * r * dd - ww;
        double crossError = (off + 4 * U * m) * d;
        double chordError = crossError * (2 * Math.sqrt(ww) + crossError) + 7 * U * (r * r * dd + ww) + UNDERFLOW;
        if (isOutside && chord < -chordError) {
            return Double.POSITIVE_INFINITY;
        }
        if (isOutside && ahead > aheadError && nearest < Double.POSITIVE_INFINITY) {
            // The entry is no nearer than this.
            double first = ahead - aheadError - Math.sqrt(Math.max(0, chord + chordError));
            if (first * (1 - 8 * U) > nearest * d) {
                return Double.POSITIVE_INFINITY;
            }
        }
        double distance = isOutside ? inPairs(ray, c, along, m, d, s) : -1;
        return distance >= 0 ? distance : exact(ray, c, along);
    }

    /** The same in pairs of doubles, for a start outside; negative in doubt. */
    private static double inPairs(BeamAxis ray, PlacedCylinder c, double along, double m, double d, RayScratch s) {
        PAIRS.count();
        DoubleDoubles p = s.capsuleEnds;
        double r = c.r;
        end(p, PLACE, c.cx, ray.ox, along, c.ax);
        end(p, PLACE + 1, c.cy, ray.oy, along, c.ay);
        end(p, PLACE + 2, c.cz, ray.oz, along, c.az);
        p.set(WAY, ray.dx);
        p.set(WAY + 1, ray.dy);
        p.set(WAY + 2, ray.dz);
        p.product(SQUARE, r, r);
        p.dot(OUTSIDE, PLACE, PLACE, TEMPORARY);
        p.subtract(OUTSIDE, OUTSIDE, SQUARE);
        p.dot(AHEAD, PLACE, WAY, TEMPORARY);
        p.cross(CROSS, PLACE, WAY, TEMPORARY);
        p.dot(CHORD, CROSS, CROSS, TEMPORARY);
        p.dot(TEMPORARY, WAY, WAY, TEMPORARY + 1);
        p.multiply(SQUARE, SQUARE, TEMPORARY);
        p.subtract(CHORD, SQUARE, CHORD);
        double largest = ray.largest()
                + VectorMath.largest(c.cx, c.cy, c.cz)
                + Math.abs(along) * VectorMath.largest(c.ax, c.ay, c.az);
        double size = m + r + largest;
        double outsideError = PAIRS_ERROR * size * size;
        double aheadError = PAIRS_ERROR * size * d;
        double chordError = PAIRS_ERROR * size * size * d * d;
        double outside = p.get(OUTSIDE);
        double ahead = p.get(AHEAD);
        double chord = p.get(CHORD);
        if (!(outside > outsideError && Math.abs(ahead) > aheadError && Math.abs(chord) > chordError)
                || outsideError < 0x1p-900
                || chordError < 0x1p-900) {
            return -1;
        }
        if (ahead < 0 || chord < 0) {
            return Double.POSITIVE_INFINITY;
        }
        p.root(CHORD, CHORD);
        double root = p.get(CHORD);
        p.add(AHEAD, AHEAD, CHORD);
        p.divide(OUTSIDE, OUTSIDE, AHEAD);
        double t = p.get(OUTSIDE);
        double distance = ray.along(t, p.rest(OUTSIDE));
        double share = outsideError / outside + (aheadError + chordError / root) / (ahead + root) + 4 * PAIRS_ERROR;
        return VectorMath.isFine(share * distance, distance, Math.max(largest, r)) ? distance : -1;
    }

    private static void end(DoubleDoubles p, int i, double centre, double start, double along, double axis) {
        p.difference(i, centre, start);
        p.product(TEMPORARY, along, axis);
        p.add(i, i, TEMPORARY);
    }

    private static double exact(BeamAxis ray, PlacedCylinder c, double along) {
        EXACT.count();
        ExactRay exact = new ExactRay(ray, c.extent());
        ExactVector end = exact.point(c.cx, c.cy, c.cz)
                .plus(ExactVector.of(c.ax, c.ay, c.az).times(exact.length(along)));
        ExactVector m = end.minus(exact.start);
        Dyadic outside = m.square().subtract(exact.length(c.r).square());
        return RaySphere.distance(exact, m, outside);
    }
}
