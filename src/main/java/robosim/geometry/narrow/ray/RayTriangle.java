package robosim.geometry.narrow.ray;

import static robosim.geometry.exact.VectorMath.UNDERFLOW;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;

/**
 * A ray against a two-sided triangle; a degenerate one counts as a segment or a point.
 *
 * <p>With a, b, c relative to the start, the line d passes inside where no two of the volumes {@code d (a x b)}, {@code
 * d (b x c)}, {@code d (c x a)} have opposite signs. The verdict is exact, so no ray slips through an edge that two
 * triangles share. Two of the volumes are computed as {@code (d x a) . edge}, off by 8u of the sum of their magnitudes
 * (offset 1u, two products and a difference 2u, edge 1u, product and sum 3u); the third is the determinant minus both.
 * Doubtful cases are decided by {@link ExactTriangle}.
 */
public final class RayTriangle {
    private static final double U = FilterBound.bound(VectorMath.U);
    private static final double VOLUME_ERROR = 8 * U;
    private static final double LAST_VOLUME_ERROR = 11 * U;
    private static final double REST_ERROR = 11 * U;

    private static final StageCounters.Counter EXACT = StageCounters.counter("RayTriangle");

    private RayTriangle() {}

    static double distance(BeamAxis ray, double[] t, int j, RayScratch s) {
        double ax = t[j] - ray.ox;
        double ay = t[j + 1] - ray.oy;
        double az = t[j + 2] - ray.oz;
        double ex = t[j + 3] - t[j];
        double ey = t[j + 4] - t[j + 1];
        double ez = t[j + 5] - t[j + 2];
        double fx = t[j + 6] - t[j];
        double fy = t[j + 7] - t[j + 1];
        double fz = t[j + 8] - t[j + 2];
        // The moment of the line about a, and the volumes of the edges that meet there.
        double mx = ray.dy * az - ray.dz * ay;
        double my = ray.dz * ax - ray.dx * az;
        double mz = ray.dx * ay - ray.dy * ax;
        double px = Math.abs(ray.dy * az) + Math.abs(ray.dz * ay);
        double py = Math.abs(ray.dz * ax) + Math.abs(ray.dx * az);
        double pz = Math.abs(ray.dx * ay) + Math.abs(ray.dy * ax);
        double v = mx * ex + my * ey + mz * ez;
        double vSize = px * Math.abs(ex) + py * Math.abs(ey) + pz * Math.abs(ez);
        double w = -(mx * fx + my * fy + mz * fz);
        double wSize = px * Math.abs(fx) + py * Math.abs(fy) + pz * Math.abs(fz);
        int vSign = sign(v, VOLUME_ERROR * vSize + UNDERFLOW);
        int wSign = sign(w, VOLUME_ERROR * wSize + UNDERFLOW);
        if (vSign * wSign < 0) {
            return Double.POSITIVE_INFINITY;
        }
        double nx = ey * fz - ez * fy;
        double ny = ez * fx - ex * fz;
        double nz = ex * fy - ey * fx;
        double qx = Math.abs(ey * fz) + Math.abs(ez * fy);
        double qy = Math.abs(ez * fx) + Math.abs(ex * fz);
        double qz = Math.abs(ex * fy) + Math.abs(ey * fx);
        double det = ray.dx * nx + ray.dy * ny + ray.dz * nz;
        double detSize = Math.abs(ray.dx) * qx + Math.abs(ray.dy) * qy + Math.abs(ray.dz) * qz;
        double third = det - v - w;
        int thirdSign = sign(third, LAST_VOLUME_ERROR * (detSize + vSize + wSize) + UNDERFLOW);
        int side = vSign != 0 ? vSign : wSign;
        if (thirdSign * side < 0) {
            return Double.POSITIVE_INFINITY;
        }
        double height = nx * ax + ny * ay + nz * az;
        double heightSize = qx * Math.abs(ax) + qy * Math.abs(ay) + qz * Math.abs(az);
        int heightSign = sign(height, REST_ERROR * heightSize + UNDERFLOW);
        int detSign = sign(det, VOLUME_ERROR * detSize + UNDERFLOW);
        if (heightSign * detSign < 0) {
            return Double.POSITIVE_INFINITY;
        }
        if (vSign * wSign * thirdSign * heightSign * detSign == 0) {
            return ExactTriangle.distance(ray, t, j);
        }
        // The plane again, relative to a point near the hit, so that the distance no longer magnifies errors.
        double at = height / det;
        double hx = Math.fma(-at, ray.dx, ax) + DoubleDouble.differenceTail(t[j], ray.ox, ax);
        double hy = Math.fma(-at, ray.dy, ay) + DoubleDouble.differenceTail(t[j + 1], ray.oy, ay);
        double hz = Math.fma(-at, ray.dz, az) + DoubleDouble.differenceTail(t[j + 2], ray.oz, az);
        double rest = nx * hx + ny * hy + nz * hz;
        double restSize = qx * Math.abs(hx) + qy * Math.abs(hy) + qz * Math.abs(hz);
        double correction = rest / det;
        double error = (REST_ERROR * restSize + Math.abs(correction) * VOLUME_ERROR * detSize) / Math.abs(det);
        double distance = ray.along(at, correction);
        double inWorldUnits = error * ray.length();
        if (VectorMath.isFine(
                inWorldUnits, distance, 0)) { // the usual case: the coordinates only make the test pass more often
            return distance;
        }
        double largest = Math.max(ray.largest(), extent(t, j));
        if (VectorMath.isFine(inWorldUnits, distance, largest)) {
            return distance;
        }
        RayRefine refine = s.refine;
        refine.place(ray, t[j], t[j + 1], t[j + 2], at, correction);
        double left = refine.trianglePlane(t, j);
        double size = restSize + 2 * Math.abs(at) * detSize;
        distance = refine.settled(left, size, det, VOLUME_ERROR * detSize, 0, largest);
        return distance >= 0 ? distance : ExactTriangle.distance(ray, t, j);
    }

    public static double extent(double[] t, int j) {
        return Math.max(
                VectorMath.largest(t[j], t[j + 1], t[j + 2]),
                Math.max(
                        VectorMath.largest(t[j + 3], t[j + 4], t[j + 5]),
                        VectorMath.largest(t[j + 6], t[j + 7], t[j + 8])));
    }

    private static int sign(double value, double error) {
        return value > error ? 1 : value < -error ? -1 : 0;
    }

    /** The slow path: every sign exact; coplanar rays and degenerate triangles by their edges. */
    private static final class ExactTriangle {
        private ExactTriangle() {}

        static double distance(BeamAxis ray, double[] t, int j) {
            EXACT.count();
            ExactRay exact = new ExactRay(ray, extent(t, j));
            ExactVector a = exact.point(t, j).minus(exact.start);
            ExactVector b = exact.point(t, j + 3).minus(exact.start);
            ExactVector c = exact.point(t, j + 6).minus(exact.start);
            ExactVector d = exact.direction;
            Dyadic ab = d.dot(a.cross(b));
            Dyadic bc = d.dot(b.cross(c));
            Dyadic ca = d.dot(c.cross(a));
            int least = Math.min(ab.signum(), Math.min(bc.signum(), ca.signum()));
            int most = Math.max(ab.signum(), Math.max(bc.signum(), ca.signum()));
            if (least < 0 && most > 0) {
                return Double.POSITIVE_INFINITY;
            }
            if (least == 0 && most == 0) {
                return flat(exact, a, b, c);
            }
            Dyadic volume = a.dot(b.cross(c));
            int side = least + most;
            if (volume.signum() * side < 0) {
                return Double.POSITIVE_INFINITY;
            }
            return volume.signum() == 0
                    ? 0
                    : exact.distance(volume.abs(), ab.add(bc).add(ca).abs());
        }

        // The exact lies in the plane, or the triangle is degenerate.
        private static double flat(ExactRay ray, ExactVector a, ExactVector b, ExactVector c) {
            ExactVector normal = b.minus(a).cross(c.minus(a));
            if (!normal.isZero()) {
                int ab = normal.dot(a.cross(b)).signum();
                int bc = normal.dot(b.cross(c)).signum();
                int ca = normal.dot(c.cross(a)).signum();
                if (ab >= 0 && bc >= 0 && ca >= 0) {
                    return 0;
                }
            }
            return Math.min(segment(ray, a, b), Math.min(segment(ray, b, c), segment(ray, c, a)));
        }

        private static double segment(ExactRay ray, ExactVector p, ExactVector q) {
            ExactVector d = ray.direction;
            ExactVector edge = q.minus(p);
            ExactVector cross = d.cross(edge);
            if (cross.isZero()) {
                return p.cross(d).isZero() && q.cross(d).isZero()
                        ? onLine(ray, p.dot(d), q.dot(d))
                        : Double.POSITIVE_INFINITY;
            }
            if (p.dot(cross).signum() != 0) {
                return Double.POSITIVE_INFINITY;
            }
            Dyadic square = cross.square();
            Dyadic share = p.cross(d).dot(cross);
            Dyadic way = p.cross(edge).dot(cross);
            boolean isMissed = share.signum() < 0 || share.compareTo(square) > 0 || way.signum() < 0;
            return isMissed ? Double.POSITIVE_INFINITY : way.signum() == 0 ? 0 : ray.distance(way, square);
        }

        private static double onLine(ExactRay ray, Dyadic p, Dyadic q) {
            if (p.max(q).signum() < 0) {
                return Double.POSITIVE_INFINITY;
            }
            Dyadic nearer = p.min(q);
            return nearer.signum() <= 0 ? 0 : ray.distance(nearer, ray.direction.square());
        }
    }
}
