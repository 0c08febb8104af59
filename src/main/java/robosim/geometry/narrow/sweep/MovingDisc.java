package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.DoubleDoubleSum;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.ProjectedPolygon;
import robosim.geometry.narrow.sat.AxisBody;
import robosim.geometry.narrow.sat.DoubleDoubleCorner;
import robosim.geometry.narrow.sat.MovingAxes;

/**
 * A disc translated against a disc or a convex polygon at rest: a ray against a circle or a rounded polygon.
 *
 * <p>Positions are relative to the disc's centre at the start. Plain doubles are followed by bounds of their error, as
 * in {@link MovingAxes}: a corner carries 8 units of roundoff u = 2^-53 of the outline's size, a product and a sum
 * three more, squaring doubles them: 32 u of the magnitudes covers all; that no tenth of it is seen to fail has the
 * reasons that {@link MovingAxes} gives. A time of contact that is certain is then computed in double-doubles by {@link
 * DoubleDoubleBall}. Cases that both leave open go to {@link ExactDisc}.
 */
final class MovingDisc {
    private static final double ROUNDOFF = AxisBody.ROUNDOFF;
    private static final double TINY = AxisBody.TINY;

    // Where a disc comes to the line of an edge, as the edge sees it.
    private static final int BEFORE = -1;
    private static final int BESIDE = 0;
    private static final int BEYOND = 1;
    private static final int UNCERTAIN = 2;

    /** Below this squares of coordinates would underflow; so would those of a side's normal, however large the rest is. */
    private static final double MINUTE = 0x1p-200;

    /** Whether the last query found the two certainly in contact at the start. */
    boolean contact;

    /** Then: how deep in the plane, within these bounds. */
    double depthLo;

    double depthHi;

    private final DoubleDoubleBall ball = new DoubleDoubleBall();
    private final DoubleDoubleCorner corner = new DoubleDoubleCorner();

    // What the disc is moved against, for the second stage.
    private Leaf rest = new Leaf();
    private double ox;
    private double oz;

    private final double[] length = new double[ProjectedPolygon.MOST_CORNERS];
    private final double[] height = new double[ProjectedPolygon.MOST_CORNERS];

    /** Time of contact of two discs; NaN if double-doubles cannot decide. */
    double discs(Leaf a, double dx, double dz, Leaf b, ProjectedPolygon o) {
        set(b, a.get(0), a.get(2));
        ball.move(a.get(3), b.get(3), dx, 0, dz);
        o.point(b.get(0) - ox, b.get(2) - oz);
        return corner(o, 0, a.get(3) + b.get(3), dx, dz);
    }

    /** Time of contact of a disc with a polygon, whose outline is filled in; NaN if double-doubles cannot decide. */
    double polygon(Leaf a, double dx, double dz, Leaf b, ProjectedPolygon o) {
        set(b, a.get(0), a.get(2));
        ball.move(a.get(3), 0, dx, 0, dz);
        o.load(b, ox, oz);
        return time(o, a.get(3), dx, dz);
    }

    private void set(Leaf leaf, double originX, double originZ) {
        rest = leaf;
        ox = originX;
        oz = originZ;
    }

    private double time(ProjectedPolygon o, double radius, double dx, double dz) {
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
            if (l < MINUTE && (nx != 0 || nz != 0)) {
                return Double.NaN;
            }
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
    private double through(ProjectedPolygon o, int k, double lo, double hi, double radius, double dx, double dz) {
        int next = k + 1 == o.corners ? 0 : k + 1;
        if (o.x[k] == o.x[next] && o.z[k] == o.z[next]) {
            return corner(o, k, radius, dx, dz);
        }
        return switch (place(o, k, lo, hi, dx, dz)) {
            case BEFORE -> pastEnd(o, k == 0 ? o.corners - 1 : k - 1, k, radius, dx, dz);
            case BEYOND -> pastEnd(o, next, next, radius, dx, dz);
            case BESIDE -> beside(o, k, next);
            default -> Double.NaN;
        };
    }

    /**
     * Past an end of the edge whose line seemed the last to be reached: at the corner; or, where two edges lie all but in
     * one line, as those of a tilted box do, beside the other one. What comes from outside and touches an edge between its
     * ends has touched nothing before.
     */
    private double pastEnd(ProjectedPolygon o, int other, int corner, double radius, double dx, double dz) {
        double nx = o.nx[other];
        double nz = o.nz[other];
        double v = nx * dx + nz * dz;
        double ev = ROUNDOFF * (Math.abs(nx * dx) + Math.abs(nz * dz)) + TINY;
        double g = height[other] - radius * length[other];
        double e = ROUNDOFF * ((Math.abs(nx) + Math.abs(nz)) * o.size + radius * length[other]) + TINY;
        boolean enters = g > e && -v > ev;
        return enters && place(o, other, (g - e) / (ev - v), (g + e) / (-v - ev), dx, dz) == BESIDE
                ? beside(o, other, other + 1 == o.corners ? 0 : other + 1)
                : corner(o, corner, radius, dx, dz);
    }

    /** Where the centre is as seen from an edge when it reaches the edge's line, between two times. */
    private static int place(ProjectedPolygon o, int k, double lo, double hi, double dx, double dz) {
        int next = k + 1 == o.corners ? 0 : k + 1;
        double ex = o.x[next] - o.x[k];
        double ez = o.z[next] - o.z[k];
        double square = ex * ex + ez * ez;
        double wx = lo * dx - o.x[k];
        double wz = lo * dz - o.z[k];
        double share = wx * ex + wz * ez;
        // A short edge has the roundings of its corners in its direction.
        double e = (Math.abs(ex) + Math.abs(ez))
                        * (2 * ROUNDOFF * (o.size + lo * (Math.abs(dx) + Math.abs(dz)))
                                + (hi - lo) * (Math.abs(dx) + Math.abs(dz)))
                + ROUNDOFF * o.size * (Math.abs(wx) + Math.abs(wz))
                + TINY;
        if (share < -e) {
            return BEFORE;
        }
        if (share > square + e) {
            return BEYOND;
        }
        return share > e && share < square - e && hi <= 1 ? BESIDE : UNCERTAIN;
    }

    private double beside(ProjectedPolygon o, int k, int next) {
        DoubleDoubleSum[] normal = ball.along;
        find(o.source[k], ball.point);
        if (rest.kind == LeafKind.TRIANGLE) {
            DoubleDoubleCorner.difference(rest.row[o.source[next] + 2], rest.row[o.source[k] + 2], normal[0]);
            DoubleDoubleCorner.difference(rest.row[o.source[k]], rest.row[o.source[next]], normal[2]);
        } else {
            DoubleDoubleBall.set(normal[0], o.nx[k]);
            DoubleDoubleBall.set(normal[2], o.nz[k]);
        }
        normal[1].clear();
        ball.size = 2 * o.size;
        ball.alongSize = Math.abs(o.nx[k]) + Math.abs(o.nz[k]);
        return ball.face();
    }

    private void find(int source, DoubleDoubleSum[] out) {
        corner.find(true, rest, source, ox, 0, oz, out);
    }

    /**
     * Time of contact with the circle around a corner. That no other part of the polygon is met first, or instead, is
     * proven for each answer and not taken from the way to this corner.
     */
    private double corner(ProjectedPolygon o, int k, double radius, double dx, double dz) {
        contact = false;
        double size = o.size;
        if (size + radius < MINUTE) {
            return Double.NaN;
        }
        double qx = o.x[k];
        double qz = o.z[k];
        double span = Math.abs(dx) + Math.abs(dz);
        double beyond = qx * qx + qz * qz - radius * radius;
        double e = ROUNDOFF * ((Math.abs(qx) + Math.abs(qz)) * size + radius * radius) + TINY;
        double ahead = qx * dx + qz * dz;
        double eAhead = ROUNDOFF * size * span;
        if (beyond < -e) {
            if (!isNearest(o, k, -qx, -qz, size)) {
                return Double.NaN;
            }
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
            return freeAlong(o, -qx, -qz, radius, dx, dz);
        }
        double square = dx * dx + dz * dz;
        double aside = qx * dz - qz * dx;
        double chord = radius * radius * square - aside * aside;
        double eAside = ROUNDOFF * size * span;
        double eChord =
                ROUNDOFF * (radius * radius * square + aside * aside) + (2 * Math.abs(aside) + eAside) * eAside + TINY;
        if (chord < -eChord) {
            return aside > 0 ? freeAlong(o, -dz, dx, radius, dx, dz) : freeAlong(o, dz, -dx, radius, dx, dz);
        }
        if (!(chord > eChord && ahead > eAhead)) {
            return Double.NaN;
        }
        if ((beyond - e) / (ahead + eAhead + Math.sqrt(chord + eChord)) > 1) {
            return freeAlong(o, dx - qx, dz - qz, radius, dx, dz);
        }
        if ((beyond + e) / (ahead - eAhead + Math.sqrt(chord - eChord)) > 1) {
            return Double.NaN;
        }
        find(o.source[k], ball.point);
        ball.size = 2 * size;
        double time = ball.corner();
        return isNearest(o, k, time * dx - qx, time * dz - qz, size + time * span) ? time : Double.NaN;
    }

    /** Infinite where the polygon stays beyond the disc in a direction from beginning to end, else NaN. */
    private static double freeAlong(ProjectedPolygon o, double wx, double wz, double radius, double dx, double dz) {
        double l = Math.sqrt(wx * wx + wz * wz);
        double most = Math.min(0, wx * dx + wz * dz) - radius * l;
        double e = ROUNDOFF * ((Math.abs(wx) + Math.abs(wz)) * (o.size + Math.abs(dx) + Math.abs(dz)) + 2 * radius * l)
                + TINY;
        for (int k = 0; k < o.corners; k++) {
            if (!(most - (wx * o.x[k] + wz * o.z[k]) > e)) {
                return Double.NaN;
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    /** Whether a corner is for certain the polygon's nearest point to what lies from it in a direction. */
    private boolean isNearest(ProjectedPolygon o, int k, double wx, double wz, double size) {
        for (int m = 0; m < o.corners; m++) {
            double ex = o.x[m] - o.x[k];
            double ez = o.z[m] - o.z[k];
            double e =
                    ROUNDOFF * ((Math.abs(wx) + Math.abs(wz)) * o.size + (Math.abs(ex) + Math.abs(ez)) * size) + TINY;
            if (m != k && !(wx * ex + wz * ez < -e) && !isSame(o, k, m)) {
                return false;
            }
        }
        return true;
    }

    /** Whether two corners are one and the same point. */
    private boolean isSame(ProjectedPolygon o, int k, int m) {
        if (o.source[k] == o.source[m]) {
            return true;
        }
        find(o.source[k], ball.point);
        find(o.source[m], ball.along);
        double x = ball.point[0].hi - ball.along[0].hi;
        double z = ball.point[2].hi - ball.along[2].hi;
        double e = DoubleDoubleBall.SHARE * o.size;
        return Math.abs(x + (ball.point[0].lo - ball.along[0].lo)) <= e
                && Math.abs(z + (ball.point[2].lo - ball.along[2].lo)) <= e;
    }

    /** Between the offset lines but outside the polygon: near an edge, or at a corner and perhaps clear of it. */
    private double besideOrIn(ProjectedPolygon o, double radius, double dx, double dz) {
        double nearest = Double.POSITIVE_INFINITY;
        int place = 0;
        boolean face = false;
        boolean sure = false;
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
                double e = 2 * ROUNDOFF * (Math.abs(ex) + Math.abs(ez)) * o.size + ROUNDOFF * o.size * o.size + TINY;
                nearest = distance;
                place = k;
                face = beside;
                sure = share > e && share < square - e;
            }
        }
        if (!face) {
            return corner(o, place, radius, dx, dz);
        }
        // In contact with this edge: the foot is on it and the centre beyond it, so that nothing can be nearer.
        double l = length[place];
        double e = ROUNDOFF * ((Math.abs(o.nx[place]) + Math.abs(o.nz[place])) * o.size + radius * l) + TINY;
        if (!(sure && height[place] - radius * l < -e && height[place] > e)) {
            return Double.NaN;
        }
        contact = true;
        depthLo = radius - (height[place] + e) / l * (1 + ROUNDOFF);
        depthHi = radius - (height[place] - e) / l * (1 - ROUNDOFF);
        double span = Math.abs(o.nx[place] * dx) + Math.abs(o.nz[place] * dz);
        return blockedWhere(-(o.nx[place] * dx + o.nz[place] * dz), ROUNDOFF * span, span);
    }

    private double inside(ProjectedPolygon o, double radius, double dx, double dz) {
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
