package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.planar.PlanarShape;

/**
 * A ray and the outline of a turned cylinder or capsule seen from above: two ellipses and the rectangle between them.
 *
 * <p>Certified: no touch is missed, and no distance is above the truth. The rectangle is made larger by the error. An ellipse
 * is not, since a thin one does not grow by as much between its ends: instead the line is moved aside by up to the error, to
 * where it enters first, and enters earlier by the error. So a hit may be a miss by less than 2^-47 of the coordinates.
 */
final class RayOval {
    /** The error of the line in the oval's frame is not more than that of the oval. */
    private static final double ERROR = 2;

    private RayOval() {}

    /** Distance in world units. */
    static double distance(BeamAxis ray, LeafKind kind, double[] row, int at, PlanarShape q) {
        q.set(kind, row, at, ray.ox, ray.oz);
        double length = Math.sqrt(ray.dx * ray.dx + ray.dz * ray.dz);
        double wayX = ray.dx / length;
        double wayZ = ray.dz / length;
        // Measured from the ray's point nearest to the centre, so that a distant start costs no accuracy.
        double ahead = q.centerX * wayX + q.centerZ * wayZ;
        double aside = DoubleDouble.differenceOfProducts(wayX, q.centerZ, wayZ, q.centerX);
        double startX = aside * wayZ;
        double startZ = -aside * wayX;
        double along = startX * q.axisX + startZ * q.axisZ;
        double across = startZ * q.axisX - startX * q.axisZ;
        double wayAlong = wayX * q.axisX + wayZ * q.axisZ;
        double wayAcross = wayZ * q.axisX - wayX * q.axisZ;
        double error = ERROR * q.error;
        double ahead1 = (along - q.reach) * wayAlong + across * wayAcross;
        double ahead2 = (along + q.reach) * wayAlong + across * wayAcross;
        double aside1 = wayAlong * across - wayAcross * (along - q.reach);
        double aside2 = wayAlong * across - wayAcross * (along + q.reach);
        double first = Math.min(
                enter(aside1, wayAlong, wayAcross, q.minor, q.radius, error) - ahead1,
                enter(aside2, wayAlong, wayAcross, q.minor, q.radius, error) - ahead2);
        double last = -Math.min(
                enter(-aside1, wayAlong, wayAcross, q.minor, q.radius, error) + ahead1,
                enter(-aside2, wayAlong, wayAcross, q.minor, q.radius, error) + ahead2);
        double radius = q.radius + error;
        double reach = q.reach + error;
        double in = Math.max(slab(along, wayAlong, reach, -1), slab(across, wayAcross, radius, -1));
        double out = Math.min(slab(along, wayAlong, reach, 1), slab(across, wayAcross, radius, 1));
        if (in <= out) {
            first = Math.min(first, in);
            last = Math.max(last, out);
        }
        if (!(first <= last) || last < -ahead) {
            return Double.POSITIVE_INFINITY;
        }
        return Math.max(0, ahead + first);
    }

    // Where the line enters (side -1) or leaves (side 1) the strip of half width h; an empty interval where it is
    // parallel and outside.
    private static double slab(double start, double way, double h, int side) {
        if (way == 0) {
            double within = Math.abs(start) <= h ? 1 : -1;
            return within * side * Double.POSITIVE_INFINITY;
        }
        return (-start + side * (way > 0 ? h : -h)) / way;
    }

    /**
     * Where a line enters an ellipse about 0, from its point beside 0; +Infinity on a miss. Of all lines beside it, up to an
     * error, the one that enters first is taken, and the error is subtracted.
     *
     * <p>With the half axes a and b, at a distance s aside, the ellipse is from {@code (-s g - a b root(l^2 - s^2)) / l^2} on,
     * where {@code l^2 = a^2 wz^2 + b^2 wx^2} and {@code g = wx wz (a^2 - b^2)}. That is least, -n, at {@code s = g / n},
     * where {@code n^2 = a^2 wx^2 + b^2 wz^2}; to both sides of it the ellipse begins farther on.
     */
    private static double enter(double aside, double wx, double wz, double a, double b, double error) {
        double px = a * wx;
        double pz = b * wz;
        double qx = b * wx;
        double qz = a * wz;
        double l = Math.sqrt(qx * qx + qz * qz);
        if (!(Math.abs(aside) <= l + error)) {
            return Double.POSITIVE_INFINITY;
        }
        double n = Math.sqrt(px * px + pz * pz);
        double g = px * qz - pz * qx;
        double least = n > 0 ? g / n : aside;
        if (Math.abs(least - aside) <= error) {
            return -n - error;
        }
        double s = least < aside ? aside - error : aside + error;
        double rest = Math.max(0, (l - s) * (l + s));
        return (-s * g - a * b * Math.sqrt(rest)) / (l * l) - error;
    }
}
