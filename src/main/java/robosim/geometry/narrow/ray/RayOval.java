package robosim.geometry.narrow.ray;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.planar.PlanarShape;

/**
 * A ray and the outline of a turned cylinder or capsule seen from above: two ellipses and the rectangle between them.
 *
 * <p>The oval's half axes are enlarged by its rounding error, so that no touch is missed; a hit may be a miss by less
 * than 2^-48 of the coordinates. Not certified for a cap seen almost edge on: a thin ellipse does not grow by as much
 * between its ends, see docs/numerics.md.
 */
final class RayOval {
    private RayOval() {}

    /** Distance in world units. */
    static double distance(
            double ox, double oz, double ux, double uz, LeafKind kind, double[] row, int at, PlanarShape q) {
        q.set(kind, row, at, ox, oz);
        double length = Math.sqrt(ux * ux + uz * uz);
        double wayX = ux / length;
        double wayZ = uz / length;
        // Measured from the ray's point nearest to the centre, so that a distant start costs no accuracy.
        double ahead = q.centerX * wayX + q.centerZ * wayZ;
        double aside = DoubleDouble.differenceOfProducts(wayX, q.centerZ, wayZ, q.centerX);
        double startX = aside * wayZ;
        double startZ = -aside * wayX;
        double along = startX * q.axisX + startZ * q.axisZ;
        double across = startZ * q.axisX - startX * q.axisZ;
        double wayAlong = wayX * q.axisX + wayZ * q.axisZ;
        double wayAcross = wayZ * q.axisX - wayX * q.axisZ;
        double radius = q.radius + q.error;
        double minor = q.minor + q.error;
        double first = Math.min(
                ellipse(along - q.reach, across, wayAlong, wayAcross, minor, radius, -1),
                ellipse(along + q.reach, across, wayAlong, wayAcross, minor, radius, -1));
        double last = Math.max(
                -ellipse(along - q.reach, across, wayAlong, wayAcross, minor, radius, 1),
                -ellipse(along + q.reach, across, wayAlong, wayAcross, minor, radius, 1));
        double reach = q.reach + q.error;
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

    // Where the line enters (side -1), or minus where it leaves (side 1), the ellipse; +Infinity on a miss.
    private static double ellipse(double x, double z, double wayX, double wayZ, double halfX, double halfZ, int side) {
        // Scaled by the half axes to a circle of radius halfX halfZ, without division.
        double px = x * halfZ;
        double pz = z * halfX;
        double vx = wayX * halfZ;
        double vz = wayZ * halfX;
        double square = vx * vx + vz * vz;
        double cross = vx * pz - vz * px;
        double reach = halfX * halfZ * Math.sqrt(square);
        double rest = (reach - Math.abs(cross)) * (reach + Math.abs(cross));
        if (!(rest >= 0) || !(square > 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double nearest = -(px * vx + pz * vz);
        double half = Math.sqrt(rest);
        return side < 0 ? (nearest - half) / square : -(nearest + half) / square;
    }
}
