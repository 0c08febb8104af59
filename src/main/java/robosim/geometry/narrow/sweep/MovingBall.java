package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.DoubleDoubleSum;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactMath;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.sat.AxisBody;
import robosim.geometry.narrow.sat.DoubleDoubleCorner;

/**
 * The time at which a translated sphere hits a sphere, a box, a triangle or an upright cylinder: the second stage, for
 * cases that {@link TranslationAdvancement} could not prove free, from a time shortly before contact.
 *
 * <p>The nearest corner, edge or side at that time is chosen in plain doubles and its time of contact found by
 * {@link DoubleDoubleBall}. What makes it certain is the proof at that time: the foot lies on the edge or side, and all that is
 * left of the body is beyond it. A place is off by at most 32 units of roundoff 2^-53 of the magnitudes, as in
 * {@link MovingDisc}. What cannot be proven goes to {@link ExactBall}.
 */
final class MovingBall {
    private static final double ROUNDOFF = AxisBody.ROUNDOFF;

    /** Most of the magnitude of a box's columns, of length 1 to 1e-9. */
    private static final double UNIT = 1.01;

    private final DoubleDoubleBall ball = new DoubleDoubleBall();
    private final DoubleDoubleCorner corner = new DoubleDoubleCorner();

    private Leaf rest = new Leaf();
    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;

    /** At least the magnitudes that any place relative to the sphere's centre is made of. */
    private double size;

    /** The corners relative to the sphere's centre, and what each is made of, see {@link DoubleDoubleCorner}. */
    private int corners;

    private final double[] x = new double[8];
    private final double[] y = new double[8];
    private final double[] z = new double[8];
    private final int[] source = new int[8];

    /** The foot of the sphere's centre, and the way from it to the centre. */
    private double fx;

    private double fy;
    private double fz;
    private double wx;
    private double wy;
    private double wz;

    /**
     * The time of contact, rounded down, +Infinity where that is after 1, NaN in doubt.
     *
     * @param near a time shortly before contact; at the start the two are apart
     */
    double time(Leaf a, double moveX, double moveY, double moveZ, Leaf b, double near) {
        rest = b;
        ox = a.get(0);
        oy = a.get(1);
        oz = a.get(2);
        dx = moveX;
        dy = moveY;
        dz = moveZ;
        ball.move(a.get(3), b.kind.isDisc() ? b.get(3) : 0, dx, dy, dz);
        double time = switch (b.kind) {
            case SPHERE -> sphere();
            case UPRIGHT_CYLINDER -> cylinder(near, a);
            case TRIANGLE -> triangle(near);
            case UPRIGHT_BOX, BOX -> box(near);
            case CYLINDER, PRISM, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw b.kind.refused();
        };
        return time > 1 ? Double.POSITIVE_INFINITY : time == 1 ? Double.NaN : time;
    }

    /** Whether a sphere is above the top of an upright box for certain and does not move down: free, in contact or not. */
    static boolean isAbove(Leaf a, double dy, Leaf b) {
        if (dy < 0 || Dyadic.signOfSum(a.get(1), -b.get(1), -b.get(4)) < 0) {
            return false;
        }
        double x = a.get(0) - b.get(0);
        double z = a.get(2) - b.get(2);
        double e = ROUNDOFF * (Math.abs(x) + Math.abs(z)) + AxisBody.TINY;
        double alongX = Math.abs(x * b.get(6) + z * b.get(12));
        double alongZ = Math.abs(x * b.get(8) + z * b.get(14));
        return alongX + e < b.get(3) / UNIT && alongZ + e < b.get(5) / UNIT;
    }

    private double sphere() {
        corner.find(false, rest, 0, ox, oy, oz, ball.point);
        ball.size = Math.abs(rest.get(0) - ox) + Math.abs(rest.get(1) - oy) + Math.abs(rest.get(2) - oz);
        return ball.corner();
    }

    /** Against the side or a cap; on the rim, or near it, as early as the certified time. */
    private double cylinder(double near, Leaf a) {
        double radius = a.get(3);
        double height = oy + near * dy - rest.get(1);
        double e = 2 * ROUNDOFF * (Math.abs(oy) + Math.abs(rest.get(1)) + rest.get(4) + Math.abs(dy));
        if (Math.abs(height) < rest.get(4)) {
            corner.find(true, rest, 0, ox, 0, oz, ball.point);
            ball.move(radius, rest.get(3), dx, 0, dz);
            ball.size = Math.abs(rest.get(0) - ox) + Math.abs(rest.get(2) - oz);
            double time = ball.corner();
            if (Double.isNaN(time)) {
                time = ExactDisc.of(a, dx, dz, rest, null).time();
            }
            if (time > 1) {
                return time; // not even a cylinder without ends is met
            }
            return Math.abs(oy + time * dy - rest.get(1)) + e < rest.get(4) ? time : near;
        }
        ball.move(radius, 0, dx, dy, dz);
        DoubleDoubleSum[] top = ball.point;
        top[0].clear();
        top[2].clear();
        DoubleDoubleCorner.difference(rest.get(1), oy, top[1]);
        top[1].add(height > 0 ? rest.get(4) : -rest.get(4), 0);
        DoubleDoubleBall.set(ball.along[0], 0);
        DoubleDoubleBall.set(ball.along[1], height > 0 ? 1 : -1);
        DoubleDoubleBall.set(ball.along[2], 0);
        ball.size = Math.abs(oy) + Math.abs(rest.get(1)) + rest.get(4);
        ball.alongSize = 1;
        double time = ball.face();
        if (Double.isNaN(time)) {
            time = exactCapTime(radius);
        }
        double px = ox - rest.get(0) + time * dx;
        double pz = oz - rest.get(2) + time * dz;
        double span = Math.abs(ox) + Math.abs(rest.get(0)) + Math.abs(oz) + Math.abs(rest.get(2));
        double reach = Math.sqrt(px * px + pz * pz) + 2 * ROUNDOFF * (span + time * (Math.abs(dx) + Math.abs(dz)));
        return reach < rest.get(3) ? time : near;
    }

    private double exactCapTime(double radius) {
        Dyadic height = Dyadic.difference(oy, rest.get(1)).abs();
        Dyadic gap = height.subtract(Dyadic.of(rest.get(4))).subtract(Dyadic.of(radius));
        boolean meets =
                gap.signum() >= 0 && dy != 0 && gap.compareTo(Dyadic.of(dy).abs()) <= 0;
        return meets ? ExactMath.floorQuotient(gap, Dyadic.of(dy).abs()) : Double.NaN;
    }

    private double box(double near) {
        double px = ox - rest.get(0) + near * dx;
        double py = oy - rest.get(1) + near * dy;
        double pz = oz - rest.get(2) + near * dz;
        int beyond = 0;
        int bits = 0;
        int axes = 0;
        double halves = rest.get(3) + rest.get(4) + rest.get(5);
        size = Math.abs(px - near * dx) + Math.abs(py - near * dy) + Math.abs(pz - near * dz) + 2 * UNIT * halves;
        for (int k = 0; k < 3; k++) {
            double along = px * rest.get(6 + k) + py * rest.get(9 + k) + pz * rest.get(12 + k);
            if (Math.abs(along) > rest.get(3 + k)) {
                beyond |= 1 << k;
                axes++;
                bits |= along > 0 ? 1 << k : 0;
            }
        }
        corners = 8;
        for (int c = 0; c < 8; c++) {
            source[c] = c;
            double sx = (c & 1) == 0 ? -rest.get(3) : rest.get(3);
            double sy = (c & 2) == 0 ? -rest.get(4) : rest.get(4);
            double sz = (c & 4) == 0 ? -rest.get(5) : rest.get(5);
            x[c] = rest.get(0) - ox + sx * rest.get(6) + sy * rest.get(7) + sz * rest.get(8);
            y[c] = rest.get(1) - oy + sx * rest.get(9) + sy * rest.get(10) + sz * rest.get(11);
            z[c] = rest.get(2) - oz + sx * rest.get(12) + sy * rest.get(13) + sz * rest.get(14);
        }
        return switch (axes) {
            case 1 -> {
                int p = beyond == 1 ? 2 : 1;
                yield side(bits, bits | p, bits | (7 & ~beyond & ~p), true);
            }
            case 2 -> edge(bits, bits | (7 & ~beyond));
            case 3 -> corner(bits);
            default -> Double.NaN;
        };
    }

    private double triangle(double near) {
        corners = 3;
        size = 0;
        for (int c = 0; c < 3; c++) {
            source[c] = rest.at + 3 * c;
            x[c] = rest.get(3 * c) - ox;
            y[c] = rest.get(3 * c + 1) - oy;
            z[c] = rest.get(3 * c + 2) - oz;
            size = Math.max(size, Math.abs(x[c]) + Math.abs(y[c]) + Math.abs(z[c]));
        }
        size *= 2;
        double nx = cross(y, z, 0);
        double ny = cross(z, x, 0);
        double nz = cross(x, y, 0);
        // Beyond which edges the place lies, as seen along the normal.
        int outside = 0;
        int count = 0;
        for (int c = 0; c < 3; c++) {
            int d = (c + 1) % 3;
            double ex = x[d] - x[c];
            double ey = y[d] - y[c];
            double ez = z[d] - z[c];
            double px = near * dx - x[c];
            double py = near * dy - y[c];
            double pz = near * dz - z[c];
            double side = nx * (ey * pz - ez * py) + ny * (ez * px - ex * pz) + nz * (ex * py - ey * px);
            if (!(side > 0)) {
                outside = c;
                count++;
                double share = px * ex + py * ey + pz * ez;
                double square = ex * ex + ey * ey + ez * ez;
                if (share > 0 && share < square) {
                    return edge(c, d);
                }
            }
        }
        return count == 0 ? side(0, 1, 2, false) : corner(nearestCorner(near, outside));
    }

    private static double cross(double[] p, double[] q, int k) {
        return (p[k + 1] - p[k]) * (q[k + 2] - q[k]) - (q[k + 1] - q[k]) * (p[k + 2] - p[k]);
    }

    private int nearestCorner(double near, int first) {
        int best = first;
        double least = Double.POSITIVE_INFINITY;
        for (int c = 0; c < corners; c++) {
            double px = near * dx - x[c];
            double py = near * dy - y[c];
            double pz = near * dz - z[c];
            double square = px * px + py * py + pz * pz;
            if (square < least) {
                least = square;
                best = c;
            }
        }
        return best;
    }

    private double corner(int c) {
        find(c, ball.point);
        ball.size = size;
        double time = ball.corner();
        fx = x[c];
        fy = y[c];
        fz = z[c];
        return isNearest(time, c, c) ? time : Double.NaN;
    }

    private double edge(int c, int d) {
        find(c, ball.point);
        find(d, ball.along);
        for (int k = 0; k < 3; k++) {
            ball.along[k].subtract(ball.point[k]);
        }
        ball.size = size;
        ball.alongSize = 2 * size;
        double ex = x[d] - x[c];
        double ey = y[d] - y[c];
        double ez = z[d] - z[c];
        double time = ball.edge();
        double share = (time * dx - x[c]) * ex + (time * dy - y[c]) * ey + (time * dz - z[c]) * ez;
        double square = ex * ex + ey * ey + ez * ez;
        // A short edge has the roundings of its corners in its direction.
        double e = 8 * ROUNDOFF * reach(time) * (Math.abs(ex) + Math.abs(ey) + Math.abs(ez) + size);
        if (!(share > e && share < square - e)) {
            return Double.NaN;
        }
        fx = x[c] + ex * (share / square);
        fy = y[c] + ey * (share / square);
        fz = z[c] + ez * (share / square);
        // The foot is off by no more than the place, and by the edge's direction: well within the bound below.
        return isNearest(time, c, d) ? time : Double.NaN;
    }

    /** A side with a corner c, from which two of its edges go to p and q. */
    private double side(int c, int p, int q, boolean isParallelogram) {
        find(c, ball.point);
        find(p, along);
        find(q, across);
        for (int k = 0; k < 3; k++) {
            along[k].subtract(ball.point[k]);
            across[k].subtract(ball.point[k]);
        }
        ball.cross(along, across, ball.along);
        double nx = ball.along[0].hi;
        double ny = ball.along[1].hi;
        double nz = ball.along[2].hi;
        if (nx * x[c] + ny * y[c] + nz * z[c] > 0) { // the sphere's centre starts behind
            for (int k = 0; k < 3; k++) {
                ball.along[k].negate();
            }
        }
        ball.size = size;
        ball.alongSize = 4 * size * size;
        double time = ball.face();
        double px = time * dx - x[c];
        double py = time * dy - y[c];
        double pz = time * dz - z[c];
        // Shares of the two edges, times n.n.
        double alongP = triple(px, py, pz, across, nx, ny, nz);
        double alongQ = -triple(px, py, pz, along, nx, ny, nz);
        double square = nx * nx + ny * ny + nz * nz;
        double lengths = sum(along) * sum(across) * (sum(along) + sum(across));
        double e = 16 * ROUNDOFF * reach(time) * lengths;
        boolean on = alongP > e
                && alongQ > e
                && (isParallelogram ? alongP < square - e && alongQ < square - e : alongP + alongQ < square - 2 * e);
        return on ? time : Double.NaN;
    }

    private final DoubleDoubleSum[] along = DoubleDoubleSum.array(3);
    private final DoubleDoubleSum[] across = DoubleDoubleSum.array(3);

    // (p x v).n
    private static double triple(
            double px, double py, double pz, DoubleDoubleSum[] v, double nx, double ny, double nz) {
        return (py * v[2].hi - pz * v[1].hi) * nx
                + (pz * v[0].hi - px * v[2].hi) * ny
                + (px * v[1].hi - py * v[0].hi) * nz;
    }

    private static double sum(DoubleDoubleSum[] v) {
        return Math.abs(v[0].hi) + Math.abs(v[1].hi) + Math.abs(v[2].hi);
    }

    private void find(int c, DoubleDoubleSum[] out) {
        corner.find(false, rest, source[c], ox, oy, oz, out);
    }

    /** Whether, seen from the foot, all corners but two lie strictly on the far side from the sphere's centre. */
    private boolean isNearest(double time, int c, int d) {
        wx = time * dx - fx;
        wy = time * dy - fy;
        wz = time * dz - fz;
        double reach = 16 * ROUNDOFF * reach(time);
        for (int k = 0; k < corners; k++) {
            double ex = x[k] - fx;
            double ey = y[k] - fy;
            double ez = z[k] - fz;
            double e = reach
                    * (Math.abs(wx) + Math.abs(wy) + Math.abs(wz) + Math.abs(ex) + Math.abs(ey) + Math.abs(ez) + reach);
            if (k != c && k != d && !(wx * ex + wy * ey + wz * ez < -e)) {
                return false;
            }
        }
        return true;
    }

    private double reach(double time) {
        return size + time * (Math.abs(dx) + Math.abs(dy) + Math.abs(dz));
    }
}
