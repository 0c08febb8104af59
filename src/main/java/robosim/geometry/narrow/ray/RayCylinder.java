package robosim.geometry.narrow.ray;

import static robosim.geometry.exact.VectorMath.UNDERFLOW;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;

/**
 * A ray against a solid cylinder {@code |(x-c) x a| <= r|a|}, {@code |(x-c).a| <= h a.a} about its stored axis a, which
 * is a unit vector only up to rounding. The verdict is exact.
 *
 * <p>With m the start relative to the centre and {@code p = d x a}, the line is inside the infinite cylinder where
 * {@code |p|^2 t^2 + 2 t p.(m x a) + |m x a|^2 - r^2 |a|^2 <= 0}. A quarter of the discriminant is {@code |a|^2 (r^2
 * |p|^2 - (p.m)^2)}, which does not contain the squared distance.
 */
final class RayCylinder {
    private static final int SIDE = 0;
    private static final double U = FilterBound.bound(VectorMath.U);
    private static final StageCounters.Counter EXACT = StageCounters.counter("RayCylinder");

    private RayCylinder() {}

    static double distance(BeamAxis ray, PlacedCylinder c, RayScratch s) {
        double plain = plain(ray, c, s);
        return plain >= 0 ? plain : inBounds(ray, c, s);
    }

    /** The distance where plain numbers are sure of it, the same to the bit as of {@link #inBounds}; else below 0. */
    static double plain(BeamAxis ray, PlacedCylinder c, RayScratch s) {
        PlainCylinderFace plain = s.plainCylinder;
        return switch (plain.face(ray, c)) {
            case PlainCylinderFace.MISSED -> Double.POSITIVE_INFINITY;
            case PlainCylinderFace.INSIDE -> 0;
            case PlainCylinderFace.SIDE -> CylinderEntry.side(ray, c, plain.enter, s);
            case PlainCylinderFace.CAP -> cap(ray, c, enterCap(ray, c), s);
            default -> -1;
        };
    }

    /** Where the ray enters the heights, as {@link #inBounds} has it. */
    private static double enterCap(BeamAxis ray, PlacedCylinder c) {
        if (c.isUpright) {
            return RayBox.enterHeights(ray, c.cy, c.h);
        }
        double along = (ray.ox - c.cx) * c.ax + (ray.oy - c.cy) * c.ay + (ray.oz - c.cz) * c.az;
        double half = c.h * c.square();
        double slope = ray.dx * c.ax + ray.dy * c.ay + ray.dz * c.az;
        return (slope > 0 ? -half - along : half - along) / slope;
    }

    private static double cap(BeamAxis ray, PlacedCylinder c, double t, RayScratch s) {
        return c.isUpright ? RayBox.heightPlane(ray, c.cy, c.h, t) : CylinderEntry.cap(ray, c, t, s);
    }

    static double inBounds(BeamAxis ray, PlacedCylinder c, RayScratch s) {
        RayInterval in = s.interval;
        in.reset();
        clipHeights(in, ray, c);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        clipSide(in, ray, c);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        double distance = !in.isCertain()
                ? -1
                : in.face < 0
                        ? 0
                        : in.face == SIDE ? CylinderEntry.side(ray, c, in.enter, s) : cap(ray, c, in.enter, s);
        return distance >= 0 ? distance : exact(ray, c);
    }

    private static void clipHeights(RayInterval in, BeamAxis ray, PlacedCylinder c) {
        if (c.isUpright) {
            RayBox.clipHeights(in, ray, c.cy, c.h);
            return;
        }
        double mx = ray.ox - c.cx;
        double my = ray.oy - c.cy;
        double mz = ray.oz - c.cz;
        // Offset 1u, product 1u, sums 2u; the half height's product and the last difference 5u.
        double along = mx * c.ax + my * c.ay + mz * c.az;
        double half = c.h * c.square();
        double size = Math.abs(mx * c.ax) + Math.abs(my * c.ay) + Math.abs(mz * c.az);
        double error = 6 * U * (size + half) + UNDERFLOW;
        double slope = ray.dx * c.ax + ray.dy * c.ay + ray.dz * c.az;
        double slopeError = 4 * U * (Math.abs(ray.dx * c.ax) + Math.abs(ray.dy * c.ay) + Math.abs(ray.dz * c.az));
        in.clip(-half - along, error, half - along, error, slope, slopeError, 1);
    }

    private static void clipSide(RayInterval in, BeamAxis ray, PlacedCylinder c) {
        double mx = ray.ox - c.cx;
        double my = ray.oy - c.cy;
        double mz = ray.oz - c.cz;
        double r = c.r;
        double px = ray.dy * c.az - ray.dz * c.ay;
        double py = ray.dz * c.ax - ray.dx * c.az;
        double pz = ray.dx * c.ay - ray.dy * c.ax;
        double sx = Math.abs(ray.dy * c.az) + Math.abs(ray.dz * c.ay);
        double sy = Math.abs(ray.dz * c.ax) + Math.abs(ray.dx * c.az);
        double sz = Math.abs(ray.dx * c.ay) + Math.abs(ray.dy * c.ax);
        double wx = my * c.az - mz * c.ay;
        double wy = mz * c.ax - mx * c.az;
        double wz = mx * c.ay - my * c.ax;
        double ux = Math.abs(my * c.az) + Math.abs(mz * c.ay);
        double uy = Math.abs(mz * c.ax) + Math.abs(mx * c.az);
        double uz = Math.abs(mx * c.ay) + Math.abs(my * c.ax);
        double aa = c.square();
        if (sx + sy + sz == 0) {
            parallel(in, wx * wx + wy * wy + wz * wz, ux * ux + uy * uy + uz * uz, r * r * aa);
            return;
        }
        // Each component of p is off by 2u of s, so its square by 4u |p|s, plus the square's own 3u.
        double pp = px * px + py * py + pz * pz;
        double ppError = 5 * U * (Math.abs(px) * sx + Math.abs(py) * sy + Math.abs(pz) * sz)
                + 6 * U * U * (sx * sx + sy * sy + sz * sz)
                + 3 * U * pp
                + UNDERFLOW;
        if (!(pp > 4 * ppError)) {
            in.doubt();
            return;
        }
        // p.m: p 2u, offset 1u, product and sums 3u. p.(m x a): 2u, 3u, 3u.
        double g = px * mx + py * my + pz * mz;
        double gError = 7 * U * (sx * Math.abs(mx) + sy * Math.abs(my) + sz * Math.abs(mz)) + UNDERFLOW;
        double middle = -(px * wx + py * wy + pz * wz);
        double middleError = 9 * U * (sx * ux + sy * uy + sz * uz) + UNDERFLOW;
        double chord = r * r * pp - g * g;
        double chordError = r * r * (ppError + 3 * U * pp) + gError * (2 * Math.abs(g) + gError) + 3 * U * g * g;
        chordError += UNDERFLOW;
        if (chord < -chordError) {
            in.none();
            return;
        }
        if (chord < chordError) {
            in.doubt();
        }
        double least = Math.sqrt(Math.max(0, aa * (chord - chordError)));
        double most = Math.sqrt(aa * (chord + chordError));
        double root = Math.sqrt(aa * Math.max(0, chord));
        // The error of a root is at most the larger side of its bracket plus 4u of itself.
        double rootError = Math.max(most - root, root - least) + 8 * U * most;
        double first = (middle - root) / pp;
        double last = (middle + root) / pp;
        double share = ppError / pp + 4 * U;
        double error = 1.5 * (middleError + rootError) / pp;
        in.clip(first, error + 1.5 * share * Math.abs(first), last, error + 1.5 * share * Math.abs(last), SIDE);
    }

    // The ray is parallel to the axis: all of it is inside the infinite cylinder, or none.
    private static void parallel(RayInterval in, double square, double squareSize, double limit) {
        double error = 12 * U * (squareSize + limit) + UNDERFLOW;
        if (square - limit > error) {
            in.none();
        } else if (!(square - limit <= -error)) {
            in.doubt();
        }
    }

    private static double exact(BeamAxis ray, PlacedCylinder c) {
        EXACT.count();
        return new ExactRayCylinder(new ExactRay(ray, c.extent()), c).distance();
    }
}
