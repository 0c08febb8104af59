package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.planar.ExactPolygon;
import robosim.geometry.narrow.planar.PlanarShape;

/** A ray and a convex polygon in the plane: the projection of a box or a triangle. */
final class RayPolygon {
    // Corners are relative to the start, and off by the shape's error; a product with the direction and the sum of two
    // add 2u of the size. A side's direction is off by 1u; it, a product and a sum add 3u.
    private static final double FILTER = FilterBound.bound(1.01);
    private static final double PRODUCT = 2 * 0x1p-53;
    private static final double DOUBTFUL = 4 * 0x1p-53;
    private static final double SIDE_PRODUCT = 3 * 0x1p-53;
    private static final double UNDERFLOW = 0x1p-960;

    private static final StageCounters.Counter EXACT = StageCounters.counter("RayPolygon");

    private RayPolygon() {}

    /** Distance in world units. Whether it hits is exact. */
    static double distance(BeamAxis ray, LeafKind kind, double[] b, int j, RayScratch s) {
        PlanarShape q = s.planar.planarB;
        q.set(kind, b, j, ray.ox, ray.oz);
        double speed = Math.abs(ray.dx) + Math.abs(ray.dz);
        double doubt = FILTER * (q.error + PRODUCT * q.size) * speed + UNDERFLOW;
        double left = -Double.MAX_VALUE;
        double right = Double.MAX_VALUE;
        double nearest = Double.MAX_VALUE;
        double furthest = -Double.MAX_VALUE;
        for (int k = 0; k < q.count; k++) {
            double aside = ray.dx * q.z[k] - ray.dz * q.x[k];
            double ahead = ray.dx * q.x[k] + ray.dz * q.z[k];
            left = Math.max(left, aside);
            right = Math.min(right, aside);
            nearest = Math.min(nearest, ahead);
            furthest = Math.max(furthest, ahead);
        }
        if (left < -doubt || right > doubt || furthest < -doubt) {
            return Double.POSITIVE_INFINITY;
        }
        int verdict = 0;
        if (left > doubt && right < -doubt) { // a ray hits a polygon that lies wholly ahead if its line crosses it
            verdict = nearest > doubt ? 1 : sides(q, ray.dx, ray.dz, speed);
        }
        if (verdict < 0) {
            return Double.POSITIVE_INFINITY;
        }
        if (verdict == 0) {
            EXACT.count();
            ExactPolygon exact = ExactPolygon.of(kind, b, j);
            if (!exact.isHitBy(ray.ox, ray.oz, ray.dx, ray.dz)) {
                return Double.POSITIVE_INFINITY;
            }
            if (exact.contains(ray.ox, ray.oz)) {
                return 0;
            }
        }
        double square = ray.dx * ray.dx + ray.dz * ray.dz;
        double first = kind.isBox() ? RayZonogon.entry(ray, b, j) : lastCrossing(q, ray.dx, ray.dz, speed);
        double share = Math.min(Math.max(first, nearest / square), furthest / square);
        return Math.max(0, share) * Math.sqrt(square);
    }

    // 1 a clear hit, -1 a clear miss, 0 in doubt, from the side normals alone
    private static int sides(PlanarShape q, double ux, double uz, double speed) {
        int verdict = 1;
        for (int k = 0; k < q.count; k++) {
            double nx = q.sideZ[k];
            double nz = -q.sideX[k];
            double beyond = -(nx * q.x[k] + nz * q.z[k]);
            double nearing = -(nx * ux + nz * uz);
            double length = Math.abs(nx) + Math.abs(nz);
            double doubt = FILTER * (q.error + SIDE_PRODUCT * q.size) * length + UNDERFLOW;
            double nearingDoubt = FILTER * SIDE_PRODUCT * length * speed + UNDERFLOW;
            if (beyond > doubt && nearing < -nearingDoubt) {
                return -1;
            }
            if (!(beyond < -doubt || nearing > nearingDoubt)) {
                verdict = 0;
            }
        }
        return verdict;
    }

    // The last of the sides' lines that the ray crosses inward, for a ray that is known to hit. If a triangle's side is
    // parallel to the ray up to rounding, plain doubles cannot decide in which direction the ray crosses it.
    private static double lastCrossing(PlanarShape q, double ux, double uz, double speed) {
        double share = 0;
        int last = q.count - 1;
        for (int k = 0; k <= last; k++) {
            int previous = k == 0 ? last : k - 1;
            double ex = q.sideX[k];
            double ez = q.sideZ[k];
            double ahead = ez * q.x[k] - ex * q.z[k];
            double way = ez * ux - ex * uz;
            double length = Math.abs(ex) + Math.abs(ez);
            if (!(ahead > DOUBTFUL * length * q.size || way > DOUBTFUL * length * speed)) {
                share = Math.max(share, crossing(q, previous, k, ux, uz));
            }
        }
        return share;
    }

    // Where the ray crosses the line of a side: a quotient of two cross products, each accurate to an ulp or two of the
    // stored corners at any angle, however low.
    private static double crossing(PlanarShape q, int from, int to, double ux, double uz) {
        double ex = q.x[to] - q.x[from];
        double ez = q.z[to] - q.z[from];
        double exTail = DoubleDouble.differenceTail(q.x[to], q.x[from], ex) + (q.tailX[to] - q.tailX[from]);
        double ezTail = DoubleDouble.differenceTail(q.z[to], q.z[from], ez) + (q.tailZ[to] - q.tailZ[from]);
        double ahead = cross(q.x[to], q.z[to], ex, ez)
                + ((q.x[to] * ezTail - q.z[to] * exTail) + (q.tailX[to] * ez - q.tailZ[to] * ex));
        double way = cross(ux, uz, ex, ez) + (ux * ezTail - uz * exTail);
        return ahead < 0 && way < 0 ? ahead / way : 0;
    }

    private static double cross(double ax, double az, double bx, double bz) {
        return DoubleDouble.differenceOfProducts(ax, bz, az, bx);
    }
}
