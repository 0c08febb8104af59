package robosim.geometry.narrow.ray;

import robosim.geometry.exact.Filter;
import robosim.geometry.exact.VectorMath;

/**
 * The distance at which a ray enters a cylinder through a face that is known, by a correction of about where that is; below 0
 * where neither doubles nor pairs of them are certainly accurate.
 */
final class CylinderEntry {
    private static final double U = Filter.bound(VectorMath.U);

    private CylinderEntry() {}

    /** Through the side: one Newton step from near the entry. */
    static double side(
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
            double t,
            RayScratch s) {
        double r = b[j + 3];
        double qx = RayBox.moved(ox, b[j], t, dx);
        double qy = RayBox.moved(oy, b[j + 1], t, dy);
        double qz = RayBox.moved(oz, b[j + 2], t, dz);
        double wx = qy * az - qz * ay;
        double wy = qz * ax - qx * az;
        double wz = qx * ay - qy * ax;
        double ux = Math.abs(qy * az) + Math.abs(qz * ay);
        double uy = Math.abs(qz * ax) + Math.abs(qx * az);
        double uz = Math.abs(qx * ay) + Math.abs(qy * ax);
        double px = dy * az - dz * ay;
        double py = dz * ax - dx * az;
        double pz = dx * ay - dy * ax;
        double sx = Math.abs(dy * az) + Math.abs(dz * ay);
        double sy = Math.abs(dz * ax) + Math.abs(dx * az);
        double sz = Math.abs(dx * ay) + Math.abs(dy * ax);
        double limit = r * r * (ax * ax + ay * ay + az * az);
        double square = wx * wx + wy * wy + wz * wz;
        double inward = -(px * wx + py * wy + pz * wz);
        double inwardError = 10 * U * (sx * ux + sy * uy + sz * uz);
        double certain = inward - inwardError;
        double correction = (square - limit) / (2 * inward);
        // Each component of w is off by 4u of its magnitudes.
        double squareError =
                9 * U * (Math.abs(wx) * ux + Math.abs(wy) * uy + Math.abs(wz) * uz) + 3 * U * square + 6 * U * limit;
        double error = (0.5 * squareError
                        + Math.abs(correction) * inwardError
                        + correction * correction * (px * px + py * py + pz * pz))
                / certain;
        double distance = VectorMath.along(t, correction, dx, dy, dz);
        double largest = Math.max(VectorMath.largest(ox, oy, oz), extent(b, j));
        double length = VectorMath.length(dx, dy, dz);
        if (certain > 0 && VectorMath.isFine(error * length, distance, largest)) {
            return distance;
        }
        double pp = px * px + py * py + pz * pz;
        if (!(Math.abs(correction) * pp < 0.25 * certain)) {
            return -1;
        }
        RayRefine refine = s.refine;
        refine.place(ox, oy, oz, dx, dy, dz, b[j], b[j + 1], b[j + 2], t, correction);
        double left = refine.side(ax, ay, az, r);
        double slope = 2 * (inward - correction * pp);
        double size = 4 * (ux * ux + uy * uy + uz * uz + limit) + 8 * Math.abs(t) * length * r;
        error = RayRefine.error(left, size, slope, 2 * inwardError + 8 * U * inward, pp);
        distance = VectorMath.along(t, correction + left / slope, dx, dy, dz);
        return VectorMath.isFine(error * length, distance, largest) ? distance : -1;
    }

    /** Through a cap. */
    static double cap(
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
            double t,
            RayScratch s) {
        double slope = dx * ax + dy * ay + dz * az;
        double slopeSize = Math.abs(dx * ax) + Math.abs(dy * ay) + Math.abs(dz * az);
        double qx = RayBox.moved(ox, b[j], t, dx);
        double qy = RayBox.moved(oy, b[j + 1], t, dy);
        double qz = RayBox.moved(oz, b[j + 2], t, dz);
        double half = b[j + 4] * (ax * ax + ay * ay + az * az);
        double rest = qx * ax + qy * ay + qz * az + (slope > 0 ? half : -half);
        double restSize = Math.abs(qx * ax) + Math.abs(qy * ay) + Math.abs(qz * az) + half;
        double correction = -rest / slope;
        double error = U * (7 * restSize + Math.abs(correction) * 4 * slopeSize) / Math.abs(slope);
        double distance = VectorMath.along(t, correction, dx, dy, dz);
        double largest = Math.max(VectorMath.largest(ox, oy, oz), extent(b, j));
        double length = VectorMath.length(dx, dy, dz);
        if (VectorMath.isFine(error * length, distance, largest)) {
            return distance;
        }
        RayRefine refine = s.refine;
        refine.place(ox, oy, oz, dx, dy, dz, b[j], b[j + 1], b[j + 2], t, correction);
        double left = refine.cap(ax, ay, az, slope > 0 ? -b[j + 4] : b[j + 4]);
        double size = restSize + 2 * Math.abs(t) * slopeSize;
        error = RayRefine.error(left, size, slope, 4 * U * slopeSize, 0);
        distance = VectorMath.along(t, correction - left / slope, dx, dy, dz);
        return VectorMath.isFine(error * length, distance, largest) ? distance : -1;
    }

    /** The largest coordinate or size. */
    static double extent(double[] b, int j) {
        return Math.max(VectorMath.largest(b[j], b[j + 1], b[j + 2]), Math.max(b[j + 3], b[j + 4]));
    }
}
