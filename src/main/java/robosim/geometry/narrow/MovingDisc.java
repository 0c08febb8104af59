package robosim.geometry.narrow;

/**
 * A disc moved straight on against a disc or a convex polygon at rest: a ray against a circle or a rounded polygon.
 *
 * <p>Positions are relative to the disc's centre at the start. Plain doubles are followed by bounds of their error, as
 * in {@link MovingAxes}: a corner carries 8 units of roundoff u = 2^-53 of the outline's size, a product and a sum three
 * more, squaring doubles them: 32 u of the magnitudes covers all. What that leaves open goes to {@link ExactDisc}.
 */
final class MovingDisc {
    private static final double ROUNDOFF = MovingAxes.ROUNDOFF;
    private static final double TINY = MovingAxes.TINY;

    /** Below this squares of coordinates would underflow. */
    private static final double MINUTE = 0x1p-200;

    /** Whether the last question found the two in contact at the start, for certain. */
    boolean contact;

    /** Then: how deep in the plane, within these bounds. */
    double depthLo;

    double depthHi;

    private final double[] length = new double[Outline.MOST_CORNERS];
    private final double[] height = new double[Outline.MOST_CORNERS];

    /** Time of contact with a polygon; NaN where plain doubles cannot tell. */
    double time(Outline o, double radius, double dx, double dz) {
        contact = false;
        if (o.size + radius < MINUTE) {
            return Double.NaN;
        }
        double enterLo = 0;
        double enterHi = 0;
        double leaveHi = Double.POSITIVE_INFINITY;
        int face = -1;
        boolean outside = false;
        for (int k = 0; k < o.corners; k++) {
            double nx = o.nx[k];
            double nz = o.nz[k];
            double l = Math.sqrt(nx * nx + nz * nz);
            double h = -(nx * o.x[k] + nz * o.z[k]);
            double g = h - radius * l;
            double e = ROUNDOFF * ((Math.abs(nx) + Math.abs(nz)) * o.size + radius * l) + TINY;
            double v = nx * dx + nz * dz;
            double ev = ROUNDOFF * (Math.abs(nx * dx) + Math.abs(nz * dz)) + TINY;
            if (g > e && g + v > e + ev) {
                return Double.POSITIVE_INFINITY;
            }
            length[k] = l;
            height[k] = h;
            outside |= h > e;
            if (g > e) {
                double lo = (g - e) / (ev - v);
                enterHi = Math.max(enterHi, -v > ev ? (g + e) / (-v - ev) : Double.POSITIVE_INFINITY);
                if (lo >= enterLo) {
                    enterLo = lo;
                    face = k;
                }
            } else if (v > ev) {
                leaveHi = Math.min(leaveHi, Math.max(0, e - g) / (v - ev));
            }
        }
        if (face < 0) {
            return outside ? besideOrIn(o, radius, dx, dz) : inside(o, radius, dx, dz);
        }
        if (enterLo > 1 || enterLo > leaveHi) {
            return Double.POSITIVE_INFINITY;
        }
        return through(o, face, enterLo, enterHi, radius, dx, dz);
    }

    /** Enters the offset lines through one of them: beside its edge, or past an end, where the corner is round. */
    private double through(Outline o, int k, double lo, double hi, double radius, double dx, double dz) {
        int next = k + 1 == o.corners ? 0 : k + 1;
        double ex = o.x[next] - o.x[k];
        double ez = o.z[next] - o.z[k];
        double square = ex * ex + ez * ez;
        if (square == 0) {
            return corner(o.x[k], o.z[k], o.size, radius, dx, dz);
        }
        double share = (lo * dx - o.x[k]) * ex + (lo * dz - o.z[k]) * ez;
        double e = (Math.abs(ex) + Math.abs(ez))
                        * (2 * ROUNDOFF * (o.size + lo * (Math.abs(dx) + Math.abs(dz)))
                                + (hi - lo) * (Math.abs(dx) + Math.abs(dz)))
                + TINY;
        if (share < -e) {
            return corner(o.x[k], o.z[k], o.size, radius, dx, dz);
        }
        if (share > square + e) {
            return corner(o.x[next], o.z[next], o.size, radius, dx, dz);
        }
        boolean sure = share > e && share < square - e && hi <= 1 && MovingAxes.isNarrow(lo, hi);
        return sure ? lo : Double.NaN;
    }

    /** Time of contact with a circle around a point that carries 8 units of roundoff of a size; NaN in doubt. */
    double corner(double qx, double qz, double size, double radius, double dx, double dz) {
        contact = false;
        if (size + radius < MINUTE) {
            return Double.NaN;
        }
        double span = Math.abs(dx) + Math.abs(dz);
        double beyond = qx * qx + qz * qz - radius * radius;
        double e = ROUNDOFF * ((Math.abs(qx) + Math.abs(qz)) * size + radius * radius) + TINY;
        double ahead = qx * dx + qz * dz;
        double eAhead = ROUNDOFF * size * span;
        if (beyond < -e) {
            contact = true;
            double distance = Math.sqrt(qx * qx + qz * qz);
            depthLo = radius - distance - ROUNDOFF * (radius + 2 * size);
            depthHi = radius - distance + ROUNDOFF * (radius + 2 * size);
            return blockedWhere(ahead, eAhead, span);
        }
        if (!(beyond > e)) {
            return Double.NaN;
        }
        if (ahead < -eAhead || span == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double square = dx * dx + dz * dz;
        double aside = qx * dz - qz * dx;
        double chord = radius * radius * square - aside * aside;
        double eAside = ROUNDOFF * size * span;
        double eChord =
                ROUNDOFF * (radius * radius * square + aside * aside) + (2 * Math.abs(aside) + eAside) * eAside + TINY;
        if (chord < -eChord) {
            return Double.POSITIVE_INFINITY;
        }
        if (!(chord > eChord && ahead > eAhead)) {
            return Double.NaN;
        }
        double lo = (beyond - e) / (ahead + eAhead + Math.sqrt(chord + eChord));
        double hi = (beyond + e) / (ahead - eAhead + Math.sqrt(chord - eChord));
        if (lo > 1) {
            return Double.POSITIVE_INFINITY;
        }
        return hi <= 1 && MovingAxes.isNarrow(lo, hi) ? lo : Double.NaN;
    }

    /** Between the offset lines but outside the polygon: near an edge, or at a corner and perhaps clear of it. */
    private double besideOrIn(Outline o, double radius, double dx, double dz) {
        double nearest = Double.POSITIVE_INFINITY;
        int at = 0;
        boolean face = false;
        for (int k = 0; k < o.corners; k++) {
            int next = k + 1 == o.corners ? 0 : k + 1;
            double ex = o.x[next] - o.x[k];
            double ez = o.z[next] - o.z[k];
            double square = ex * ex + ez * ez;
            double share = -(o.x[k] * ex + o.z[k] * ez);
            double fromCorner = o.x[k] * o.x[k] + o.z[k] * o.z[k];
            boolean beside = share > 0 && share < square;
            double cross = ex * o.z[k] - ez * o.x[k];
            double distance = beside ? cross * cross / square : fromCorner;
            if (distance < nearest) {
                nearest = distance;
                at = k;
                face = beside;
            }
        }
        if (!face) {
            return corner(o.x[at], o.z[at], o.size, radius, dx, dz);
        }
        // In contact with this edge: its offset line was not beyond doubt, and it is the nearest thing.
        double l = length[at];
        double e = ROUNDOFF * ((Math.abs(o.nx[at]) + Math.abs(o.nz[at])) * o.size + radius * l) + TINY;
        if (!(height[at] - radius * l < -e && height[at] > e)) {
            return Double.NaN;
        }
        contact = true;
        depthLo = radius - (height[at] + e) / l * (1 + ROUNDOFF);
        depthHi = radius - (height[at] - e) / l * (1 - ROUNDOFF);
        double span = Math.abs(o.nx[at] * dx) + Math.abs(o.nz[at] * dz);
        return blockedWhere(-(o.nx[at] * dx + o.nz[at] * dz), ROUNDOFF * span, span);
    }

    private double inside(Outline o, double radius, double dx, double dz) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < o.corners; k++) {
            double e = ROUNDOFF * (Math.abs(o.nx[k]) + Math.abs(o.nz[k])) * o.size + TINY;
            if (!(height[k] < -e)) {
                return Double.NaN;
            }
            least = Math.min(least, (e - height[k]) / length[k]);
        }
        contact = true;
        depthHi = radius + least * (1 + ROUNDOFF);
        depthLo = radius;
        boolean into = false;
        boolean away = false;
        for (int k = 0; k < o.corners; k++) {
            double e = ROUNDOFF * (Math.abs(o.nx[k]) + Math.abs(o.nz[k])) * o.size + TINY;
            if ((-height[k] - e) / length[k] <= least * (1 + ROUNDOFF)) {
                double span = Math.abs(o.nx[k] * dx) + Math.abs(o.nz[k] * dz);
                double verdict = blockedWhere(-(o.nx[k] * dx + o.nz[k] * dz), ROUNDOFF * span, span);
                if (Double.isNaN(verdict)) {
                    return verdict;
                }
                into |= verdict == 0;
                away |= verdict > 0;
            }
        }
        return into ? away ? Double.NaN : 0 : Double.POSITIVE_INFINITY;
    }

    // 0 where a motion goes inward for certain, infinite where it does not, NaN in doubt.
    private static double blockedWhere(double inward, double error, double span) {
        if (span == 0) {
            return Double.POSITIVE_INFINITY;
        }
        return inward > error + TINY ? 0 : inward < -error - TINY ? Double.POSITIVE_INFINITY : Double.NaN;
    }
}
