package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Radians;
import robosim.geometry.narrow.leaf.ProjectedPolygon;
import robosim.geometry.narrow.sat.AxisBody;

/**
 * A point going round a pivot against a polygon rounded by a radius: a disc turned about a pivot off its centre, or, seen
 * from the mover, a disc at rest against a polygon that turns. Closed form.
 *
 * <p>From outside the rounded polygon is first met at a corner's circle or at an edge's offset line beside that edge.
 * Coordinates are relative to the pivot, and so mirrored that the point goes from x towards z. Margins as in
 * {@link TurningPolygon}.
 */
final class TurningDisc {
    private static final double ROUNDOFF = 128 * 0x1p-53;
    private static final double FULL = 2 * Math.PI;

    /** Distance of the point from the polygon at the start, 0 inside it. */
    double distance;

    /** The error of that distance. */
    double error;

    /** Whether the point lies outside the polygon at the start. */
    boolean outside;

    private double px;
    private double pz;
    private double rho;
    private double limit;
    private boolean closed;

    /** Places the point, and finds its {@link #distance} and whether it is {@link #outside}. */
    void load(double x, double z, ProjectedPolygon o) {
        px = x;
        pz = z;
        rho = TurningPolygon.length(x, z);
        error = ROUNDOFF * (rho + o.size) + AxisBody.TINY;
        double least = Double.POSITIVE_INFINITY;
        outside = o.normals == 0;
        for (int k = 0; k < o.corners; k++) {
            int next = k + 1 == o.corners ? 0 : k + 1;
            double ex = o.x[next] - o.x[k];
            double ez = o.z[next] - o.z[k];
            double ax = x - o.x[k];
            double az = z - o.z[k];
            double square = ex * ex + ez * ez;
            double share = square > 0 ? Math.max(0, Math.min(1, (ax * ex + az * ez) / square)) : 0;
            double bx = ax - share * ex;
            double bz = az - share * ez;
            least = Math.min(least, TurningPolygon.length(bx, bz));
            outside |= k < o.normals && o.nx[k] * ax + o.nz[k] * az > 0;
        }
        distance = outside ? least : 0;
    }

    /**
     * How far the point goes before it comes within the radius, radians; infinite if it never does.
     *
     * @param from the distance from the polygon at which features count as met: the sum of radii, or the distance at the
     *     start where the turn begins in contact
     * @param active whether the point begins on that boundary, so that features there are judged by where the point goes
     */
    double free(ProjectedPolygon o, double from, boolean active) {
        if (rho == 0) {
            return Double.POSITIVE_INFINITY;
        }
        limit = from;
        closed = active;
        double first = Double.POSITIVE_INFINITY;
        for (int k = 0; k < o.corners; k++) {
            first = Math.min(first, circle(o.x[k], o.z[k]));
        }
        for (int k = 0; k < o.normals; k++) {
            int next = k + 1 == o.corners ? 0 : k + 1;
            first = Math.min(first, edge(o.x[k], o.z[k], o.x[next], o.z[next], o.nx[k], o.nz[k]));
        }
        return first;
    }

    private double circle(double vx, double vz) {
        double v = TurningPolygon.length(vx, vz);
        double cross = px * vz - pz * vx;
        double dot = px * vx + pz * vz;
        double ax = px - vx;
        double az = pz - vz;
        if (closed && TurningPolygon.length(ax, az) <= limit + 2 * error) {
            // The distance grows as -cos(t - phase) does.
            return TurningPolygon.rising(-dot, -cross, error * Math.max(rho, v));
        }
        return entry(vx, vz, limit + error);
    }

    /** When the point comes within a distance of a corner, for a turn that begins beyond it. */
    private double entry(double vx, double vz, double reach) {
        double v = TurningPolygon.length(vx, vz);
        double cross = px * vz - pz * vx;
        double dot = px * vx + pz * vz;
        double off = Math.abs(v - rho);
        if (off > reach) {
            return Double.POSITIVE_INFINITY;
        }
        // |v - p(t)|^2 = (|v| - rho)^2 + 4 rho |v| sin^2((t - phase) / 2)
        double half = Math.sqrt(Math.min(1, (reach - off) * (reach + off) / (4 * rho * v)));
        double arc = 2 * StrictMath.asin(Math.min(1, half));
        return ahead(StrictMath.atan2(cross, dot) - arc);
    }

    private double edge(double x0, double z0, double x1, double z1, double normalX, double normalZ) {
        double ex = x1 - x0;
        double ez = z1 - z0;
        double length = TurningPolygon.length(ex, ez);
        if (length == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double l = TurningPolygon.length(normalX, normalZ);
        double nx = normalX / l;
        double nz = normalZ / l;
        double c = nx * x0 + nz * z0;
        double a = nx * px + nz * pz;
        double b = nz * px - nx * pz;
        double phase = StrictMath.atan2(b, a);
        double t;
        double slack;
        boolean isOn = closed && Math.abs(a - c - limit) <= 2 * error;
        boolean isPast = isOn && !isBeside(px, pz, x0, z0, ex, ez, length, 2 * error);
        if (isPast) {
            double first = intoEdge(x0, z0, -ex / length, -ez / length, a, b);
            double into = Math.min(first, intoEdge(x1, z1, ex / length, ez / length, a, b));
            if (into < Double.POSITIVE_INFINITY) {
                return into;
            }
        }
        if (isOn && !isPast) {
            double free = TurningPolygon.rising(a, b, error);
            if (free == 0 || free >= FULL) {
                return free;
            }
            t = free; // back on this line, perhaps no more beside the edge
            slack = 8 * error;
        } else {
            double h = (c + limit + error) / rho;
            if (h > 1 + 8 * error / rho || h < -1) {
                return Double.POSITIVE_INFINITY;
            }
            double arc = StrictMath.acos(Math.min(1, h)); // 0 where it hardly reaches the line
            t = phase + arc;
            slack = rho * (StrictMath.acos(Math.max(-1, h - 4 * error / rho)) - arc) + 2 * error;
        }
        double cos = Radians.cos(t);
        double sin = Radians.sin(t);
        double x = px * cos - pz * sin;
        double z = px * sin + pz * cos;
        if (isBeside(x, z, x0, z0, ex, ez, length, Math.min(slack, 8 * error))) {
            return ahead(t);
        }
        return isBeside(x, z, x0, z0, ex, ez, length, slack)
                ? pastEnd(t, x0, z0, x0 + ex, z0 + ez)
                : Double.POSITIVE_INFINITY;
    }

    /**
     * A point that grazes an edge's offset line is as high as the edge for a while, in which it comes past an end of it: at
     * that end it is within reach of the corner.
     */
    private double pastEnd(double t, double x0, double z0, double x1, double z1) {
        double reach = limit + 8 * error;
        double near = Math.min(TurningPolygon.length(px - x0, pz - z0), TurningPolygon.length(px - x1, pz - z1));
        return near <= reach ? ahead(t) : Math.min(entry(x0, z0, reach), entry(x1, z1, reach));
    }

    /**
     * A point on an edge's offset line hardly past an end of it, where the corner is as near as the edge: it goes deeper
     * where the line falls and it comes back beside the edge. (ux, uz) leads out past that end.
     */
    private double intoEdge(double vx, double vz, double ux, double uz, double a, double b) {
        double along = ux * px + uz * pz;
        double rate = uz * px - ux * pz;
        boolean isCorner = along > ux * vx + uz * vz && TurningPolygon.length(px - vx, pz - vz) <= limit + 2 * error;
        return isCorner && rate < 0 && TurningPolygon.rising(a, b, error) == 0
                ? TurningPolygon.beyond(along, rate, ux * vx + uz * vz + error, 0)
                : Double.POSITIVE_INFINITY;
    }

    private static boolean isBeside(
            double x, double z, double x0, double z0, double ex, double ez, double length, double slack) {
        double share = ((x - x0) * ex + (z - z0) * ez) / length;
        return share >= -slack && share <= length + slack;
    }

    /** The next time that an angle comes up, a margin early; one that rounding has put just behind is now. */
    private static double ahead(double t) {
        double turned = Math.IEEEremainder(t, FULL);
        double next = turned < -8 * TurningPolygon.MARGIN ? turned + FULL : turned;
        return Math.max(0, next - TurningPolygon.MARGIN);
    }
}
