package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.VectorMath;

/**
 * The distance at which a ray enters a cylinder through a face that is known, by a correction of about where that is; below 0
 * where neither doubles nor pairs of them are certainly accurate.
 */
final class CylinderEntry {
    private static final double U = FilterBound.bound(VectorMath.U);

    private CylinderEntry() {}

    /** Through the side: one Newton step from near the entry. */
    static double side(BeamAxis ray, PlacedCylinder c, double t, RayScratch s) {
        double r = c.r;
        double qx = RayBox.moved(ray.ox, c.cx, t, ray.dx);
        double qy = RayBox.moved(ray.oy, c.cy, t, ray.dy);
        double qz = RayBox.moved(ray.oz, c.cz, t, ray.dz);
        double wx = qy * c.az - qz * c.ay;
        double wy = qz * c.ax - qx * c.az;
        double wz = qx * c.ay - qy * c.ax;
        double ux = Math.abs(qy * c.az) + Math.abs(qz * c.ay);
        double uy = Math.abs(qz * c.ax) + Math.abs(qx * c.az);
        double uz = Math.abs(qx * c.ay) + Math.abs(qy * c.ax);
        double px = ray.dy * c.az - ray.dz * c.ay;
        double py = ray.dz * c.ax - ray.dx * c.az;
        double pz = ray.dx * c.ay - ray.dy * c.ax;
        double sx = Math.abs(ray.dy * c.az) + Math.abs(ray.dz * c.ay);
        double sy = Math.abs(ray.dz * c.ax) + Math.abs(ray.dx * c.az);
        double sz = Math.abs(ray.dx * c.ay) + Math.abs(ray.dy * c.ax);
        double limit = r * r * c.square();
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
        double distance = ray.along(t, correction);
        double largest = Math.max(ray.largest(), c.extent());
        double length = ray.length();
        if (certain > 0 && VectorMath.isFine(error * length, distance, largest)) {
            return distance;
        }
        double pp = px * px + py * py + pz * pz;
        if (!(Math.abs(correction) * pp < 0.25 * certain)) {
            return -1;
        }
        RayRefine refine = s.refine;
        refine.place(ray, c.cx, c.cy, c.cz, t, correction);
        double left = refine.side(c);
        double slope = 2 * (inward - correction * pp);
        double size = 4 * (ux * ux + uy * uy + uz * uz + limit) + 8 * Math.abs(t) * length * r;
        return refine.settled(left, size, -slope, 2 * inwardError + 8 * U * inward, pp, largest);
    }

    /** Through a cap. */
    static double cap(BeamAxis ray, PlacedCylinder c, double t, RayScratch s) {
        double slope = ray.dx * c.ax + ray.dy * c.ay + ray.dz * c.az;
        double slopeSize = Math.abs(ray.dx * c.ax) + Math.abs(ray.dy * c.ay) + Math.abs(ray.dz * c.az);
        double qx = RayBox.moved(ray.ox, c.cx, t, ray.dx);
        double qy = RayBox.moved(ray.oy, c.cy, t, ray.dy);
        double qz = RayBox.moved(ray.oz, c.cz, t, ray.dz);
        double half = c.h * c.square();
        double rest = qx * c.ax + qy * c.ay + qz * c.az + (slope > 0 ? half : -half);
        double restSize = Math.abs(qx * c.ax) + Math.abs(qy * c.ay) + Math.abs(qz * c.az) + half;
        double correction = -rest / slope;
        double error = U * (7 * restSize + Math.abs(correction) * 4 * slopeSize) / Math.abs(slope);
        double distance = ray.along(t, correction);
        double largest = Math.max(ray.largest(), c.extent());
        double length = ray.length();
        if (VectorMath.isFine(error * length, distance, largest)) {
            return distance;
        }
        RayRefine refine = s.refine;
        refine.place(ray, c.cx, c.cy, c.cz, t, correction);
        double left = refine.cap(c, slope > 0 ? -c.h : c.h);
        double size = restSize + 2 * Math.abs(t) * slopeSize;
        return refine.settled(left, size, slope, 4 * U * slopeSize, 0, largest);
    }
}
