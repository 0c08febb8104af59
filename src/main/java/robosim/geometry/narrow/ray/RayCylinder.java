package robosim.geometry.narrow.ray;

import static robosim.geometry.exact.VectorMath.UNDERFLOW;

import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.Filter;
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
    private static final double U = Filter.bound(VectorMath.U);
    private static final StageCounters.Counter EXACT = StageCounters.counter("RayCylinder");

    private RayCylinder() {}

    /** Upright: the axis is the world's Y. */
    static double upright(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        double plain = plainUpright(ox, oy, oz, dx, dy, dz, b, j, s);
        return plain >= 0 ? plain : inUprightBounds(ox, oy, oz, dx, dy, dz, b, j, s);
    }

    /** The distance where plain numbers are sure of it, the same to the bit as of {@link #inUprightBounds}; else below 0. */
    static double plainUpright(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        PlainCylinderFace plain = s.plainCylinder;
        int face = plain.face(
                ox - b[j],
                oy - b[j + 1],
                oz - b[j + 2],
                dx,
                dy,
                dz,
                0,
                1,
                0,
                b[j + 3],
                b[j + 4],
                size(ox, oy, oz, b, j));
        return switch (face) {
            case PlainCylinderFace.MISSED -> Double.POSITIVE_INFINITY;
            case PlainCylinderFace.INSIDE -> 0;
            case PlainCylinderFace.SIDE -> CylinderEntry.side(ox, oy, oz, dx, dy, dz, b, j, 0, 1, 0, plain.enter, s);
            case PlainCylinderFace.CAP -> {
                double t = RayBox.enterHeights(oy, b[j + 1], b[j + 4], dy);
                yield RayBox.heightPlane(oy, b[j + 1], b[j + 4], dx, dy, dz, t);
            }
            default -> -1;
        };
    }

    private static double size(double ox, double oy, double oz, double[] b, int j) {
        return Math.abs(ox)
                + Math.abs(oy)
                + Math.abs(oz)
                + (Math.abs(b[j]) + Math.abs(b[j + 1]) + Math.abs(b[j + 2]))
                + (b[j + 3] + b[j + 4]);
    }

    static double inUprightBounds(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        RayInterval in = s.interval;
        in.reset();
        if (!RayBox.clipHeights(in, oy, b[j + 1], b[j + 4], dy)) {
            return Double.POSITIVE_INFINITY;
        }
        clipSide(in, ox - b[j], 0, oz - b[j + 2], dx, dy, dz, 0, 1, 0, b[j + 3]);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        double distance = !in.isCertain()
                ? -1
                : in.face < 0
                        ? 0
                        : in.face == SIDE
                                ? CylinderEntry.side(ox, oy, oz, dx, dy, dz, b, j, 0, 1, 0, in.enter, s)
                                : RayBox.heightPlane(oy, b[j + 1], b[j + 4], dx, dy, dz, in.enter);
        return distance >= 0 ? distance : exact(ox, oy, oz, dx, dy, dz, b, j, 0, 1, 0);
    }

    /** Turned: the axis is the Y axis of the stored rotation. */
    static double distance(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        return about(ox, oy, oz, dx, dy, dz, b, j, b[j + 7], b[j + 10], b[j + 13], s);
    }

    /** A cylinder about the given axis. */
    static double about(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double[] b,
            int j,
            double ax,
            double ay,
            double az,
            RayScratch s) {
        double plain = plain(ox, oy, oz, dx, dy, dz, b, j, ax, ay, az, s);
        return plain >= 0 ? plain : inBounds(ox, oy, oz, dx, dy, dz, b, j, ax, ay, az, s);
    }

    /** The distance where plain numbers are sure of it, the same to the bit as of {@link #inBounds}; else below 0. */
    static double plain(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double[] b,
            int j,
            double ax,
            double ay,
            double az,
            RayScratch s) {
        double mx = ox - b[j];
        double my = oy - b[j + 1];
        double mz = oz - b[j + 2];
        PlainCylinderFace plain = s.plainCylinder;
        int face = plain.face(mx, my, mz, dx, dy, dz, ax, ay, az, b[j + 3], b[j + 4], size(ox, oy, oz, b, j));
        return switch (face) {
            case PlainCylinderFace.MISSED -> Double.POSITIVE_INFINITY;
            case PlainCylinderFace.INSIDE -> 0;
            case PlainCylinderFace.SIDE -> CylinderEntry.side(ox, oy, oz, dx, dy, dz, b, j, ax, ay, az, plain.enter, s);
            case PlainCylinderFace.CAP ->
                CylinderEntry.cap(
                        ox,
                        oy,
                        oz,
                        dx,
                        dy,
                        dz,
                        b,
                        j,
                        ax,
                        ay,
                        az,
                        enterCap(mx, my, mz, dx, dy, dz, b[j + 4], ax, ay, az),
                        s);
            default -> -1;
        };
    }

    /** Where the ray enters the heights, as {@link #inBounds} has it. */
    private static double enterCap(
            double mx,
            double my,
            double mz,
            double dx,
            double dy,
            double dz,
            double h,
            double ax,
            double ay,
            double az) {
        double along = mx * ax + my * ay + mz * az;
        double half = h * (ax * ax + ay * ay + az * az);
        double slope = dx * ax + dy * ay + dz * az;
        return (slope > 0 ? -half - along : half - along) / slope;
    }

    static double inBounds(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double[] b,
            int j,
            double ax,
            double ay,
            double az,
            RayScratch s) {
        double mx = ox - b[j];
        double my = oy - b[j + 1];
        double mz = oz - b[j + 2];
        RayInterval in = s.interval;
        in.reset();
        // The heights: offset 1u, product 1u, sums 2u; the half height's product and the last difference 5u.
        double along = mx * ax + my * ay + mz * az;
        double half = b[j + 4] * (ax * ax + ay * ay + az * az);
        double size = Math.abs(mx * ax) + Math.abs(my * ay) + Math.abs(mz * az);
        double error = 6 * U * (size + half) + UNDERFLOW;
        double slope = dx * ax + dy * ay + dz * az;
        double slopeError = 4 * U * (Math.abs(dx * ax) + Math.abs(dy * ay) + Math.abs(dz * az));
        in.clip(-half - along, error, half - along, error, slope, slopeError, 1);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        clipSide(in, mx, my, mz, dx, dy, dz, ax, ay, az, b[j + 3]);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        double distance = !in.isCertain()
                ? -1
                : in.face < 0
                        ? 0
                        : in.face == SIDE
                                ? CylinderEntry.side(ox, oy, oz, dx, dy, dz, b, j, ax, ay, az, in.enter, s)
                                : CylinderEntry.cap(ox, oy, oz, dx, dy, dz, b, j, ax, ay, az, in.enter, s);
        return distance >= 0 ? distance : exact(ox, oy, oz, dx, dy, dz, b, j, ax, ay, az);
    }

    private static void clipSide(
            RayInterval in,
            double mx,
            double my,
            double mz,
            double dx,
            double dy,
            double dz,
            double ax,
            double ay,
            double az,
            double r) {
        double px = dy * az - dz * ay;
        double py = dz * ax - dx * az;
        double pz = dx * ay - dy * ax;
        double sx = Math.abs(dy * az) + Math.abs(dz * ay);
        double sy = Math.abs(dz * ax) + Math.abs(dx * az);
        double sz = Math.abs(dx * ay) + Math.abs(dy * ax);
        double wx = my * az - mz * ay;
        double wy = mz * ax - mx * az;
        double wz = mx * ay - my * ax;
        double ux = Math.abs(my * az) + Math.abs(mz * ay);
        double uy = Math.abs(mz * ax) + Math.abs(mx * az);
        double uz = Math.abs(mx * ay) + Math.abs(my * ax);
        double aa = ax * ax + ay * ay + az * az;
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

    private static double exact(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double[] b,
            int j,
            double ax,
            double ay,
            double az) {
        EXACT.count();
        ExactRay ray = new ExactRay(ox, oy, oz, dx, dy, dz, CylinderEntry.extent(b, j));
        return new ExactRayCylinder(ray, ray.point(b, j), ExactVector.of(ax, ay, az), b[j + 3], b[j + 4]).distance();
    }
}
