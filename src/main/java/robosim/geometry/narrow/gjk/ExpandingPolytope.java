package robosim.geometry.narrow.gjk;

import robosim.geometry.exact.DoubleDoubles;

/**
 * A polytope inside the difference set of two leaves, expanded where the set's boundary is nearest to the origin (the
 * expanding polytope of van den Bergen 2001): its nearest side gives a lower bound of the penetration depth, and every
 * supporting plane tried an upper bound.
 *
 * <p>The lower bound is proven. The sides form a closed oriented surface of points of the set, and so cover every
 * direction from the origin once the origin is on the inner side of all of them. No ray from the origin then leaves the
 * surface nearer than the nearest plane. The planes are computed in double-doubles, however thin a side is, and the
 * error of the points ({@link Gjk#ROUNDOFF}) is subtracted. It does not matter how the points were found.
 *
 * <p>Only the first query allocates; most worlds never need one.
 */
public final class ExpandingPolytope {
    /** Maximum number of points: in a smooth area the bracket shrinks to a quarter with some ten points. */
    private static final int MOST_POINTS = 240;

    private static final int MOST_SIDES = 2 * MOST_POINTS;

    /**
     * Rounding error of the distance from a side's plane in doubles, relative to the three lengths that it is computed
     * from: 8u.
     */
    private static final double PLANE_ERROR = 8 * 0x1p-53;

    /** The same in double-doubles, with a margin. */
    private static final double PAIRS_ERROR = 0x1p-92;

    // Indexes of the registers for a side's edges, its normal, and the vector to a point.
    private static final int ALONG = 0;
    private static final int ACROSS = 3;
    private static final int NORMAL = 6;
    private static final int WAY = 9;
    private static final int VALUE = 12;
    private static final int TEMPORARY = 13;

    private final DoubleDoubles pairs = new DoubleDoubles(16);
    private double[] x = {};
    private double[] y = {};
    private double[] z = {};
    private int points;

    private int[] cornerP = {};
    private int[] cornerQ = {};
    private int[] cornerR = {};
    private double[] sideX = {};
    private double[] sideY = {};
    private double[] sideZ = {};
    private double[] sideReach = {};

    /** The product of the lengths of the two edges from which a side's normal is computed. */
    private double[] sideSize = {};

    /** That normal, not of unit length, in double-doubles: the high parts, then the low parts. */
    private double[] normal = {};

    private double[] normalRest = {};

    private int sides;

    private int[] edgeFrom = {};
    private int[] edgeTo = {};
    private int edges;

    private final Support first;
    private final Support second;
    private double height;
    private double error;
    private double lower;
    private double upper;
    private double bestX;
    private double bestY;
    private double bestZ;

    /**
     * For two leaves that are loaded relative to the same origin and at the same scale before each query; the first is
     * the one to move.
     */
    ExpandingPolytope(Support first, Support second) {
        this.first = first;
        this.second = second;
    }

    /**
     * The proven lower bound of the origin's depth in the set; {@code -Infinity} if nothing is proven. Without margins.
     */
    public double lower() {
        return lower;
    }

    /** The least distance of a supporting plane tried, to within rounding; without margins. */
    public double upper() {
        return upper;
    }

    /** The rounding error of {@link #upper}; already subtracted from {@link #lower}. */
    public double error() {
        return error;
    }

    /** The unit normal of that plane, in which the first leaf has to move to get out. */
    public double x() {
        return bestX;
    }

    public double y() {
        return bestY;
    }

    public double z() {
        return bestZ;
    }

    /** The number of sides of the hull. */
    int sides() {
        return sides;
    }

    /** The approximate distance of a side's plane; also sets its unit normal. */
    double reach(int side) {
        return sideReach[side];
    }

    public double x(int side) {
        return sideX[side];
    }

    public double y(int side) {
        return sideY[side];
    }

    public double z(int side) {
        return sideZ[side];
    }

    /**
     * Expands the polytope until the proven depth reaches a goal, the bracket is as narrow as doubles allow, the two
     * turn out to be apart, or the maximum number of points is reached.
     *
     * @param goal the depth that is enough; the query ends when it is proven
     */
    public void grow(double goal) {
        grow(goal, 0);
    }

    /**
     * The same for two leaves loaded in the plane, which are treated as prisms so high that no way out leads up or
     * down.
     */
    public void growPlanar(double goal) {
        grow(goal, 4 * (first.extent + second.extent));
    }

    private void makeRoom() {
        x = new double[MOST_POINTS];
        y = new double[MOST_POINTS];
        z = new double[MOST_POINTS];
        cornerP = new int[MOST_SIDES];
        cornerQ = new int[MOST_SIDES];
        cornerR = new int[MOST_SIDES];
        sideX = new double[MOST_SIDES];
        sideY = new double[MOST_SIDES];
        sideZ = new double[MOST_SIDES];
        sideReach = new double[MOST_SIDES];
        sideSize = new double[MOST_SIDES];
        normal = new double[3 * MOST_SIDES];
        normalRest = new double[3 * MOST_SIDES];
        edgeFrom = new int[3 * MOST_SIDES];
        edgeTo = new int[3 * MOST_SIDES];
    }

    private void grow(double goal, double height) {
        if (x.length == 0) {
            makeRoom();
        }
        this.height = height;
        error = Gjk.ROUNDOFF * (first.extent + second.extent);
        lower = Double.NEGATIVE_INFINITY;
        upper = Double.POSITIVE_INFINITY;
        points = 0;
        sides = 0;
        if (!begin()) {
            return;
        }
        while (points < MOST_POINTS) {
            int nearest = nearest();
            if (nearest < 0) {
                return;
            }
            prove(nearest);
            if (lower >= goal) {
                return;
            }
            double reach = offer(sideX[nearest], sideY[nearest], sideZ[nearest]);
            if (!(reach - sideReach[nearest] > error) || reach < 0 || !expand()) {
                return;
            }
        }
        int nearest = nearest();
        if (nearest >= 0) {
            prove(nearest);
        }
    }

    /** The side whose plane has the least signed distance from the origin. */
    private int nearest() {
        int nearest = -1;
        for (int k = 0; k < sides; k++) {
            if (nearest < 0 || sideReach[k] < sideReach[nearest]) {
                nearest = k;
            }
        }
        return nearest;
    }

    private void prove(int nearest) {
        double bound = sideReach[nearest] - error;
        if (bound > 0) {
            lower = Math.max(lower, bound);
        }
    }

    /** Adds the set's point furthest in a unit direction; returns how far it is. */
    private double offer(double dx, double dy, double dz) {
        first.find(-dx, -dy, -dz);
        second.find(dx, dy, dz);
        double px = second.x - first.x;
        double py = second.y - first.y + (dy < 0 ? -height : height);
        double pz = second.z - first.z;
        x[points] = px;
        y[points] = py;
        z[points] = pz;
        points++;
        double reach = dx * px + dy * py + dz * pz;
        if (reach < upper) {
            upper = reach;
            bestX = dx;
            bestY = dy;
            bestZ = dz;
        }
        return reach;
    }

    /** Makes a tetrahedron of points of the set; returns false if it is flat. */
    private boolean begin() {
        offer(1, 0, 0);
        offer(-1, 0, 0);
        offer(0, 1, 0);
        offer(0, -1, 0);
        offer(0, 0, 1);
        offer(0, 0, -1);
        int axis = 0;
        for (int k = 2; k < 6; k += 2) {
            if (distance(k, k + 1) > distance(axis, axis + 1)) {
                axis = k;
            }
        }
        move(axis, 0);
        move(axis + 1, 1);
        points = 2;
        double ex = x[1] - x[0];
        double ey = y[1] - y[0];
        double ez = z[1] - z[0];
        boolean level = Math.abs(ey) <= Math.abs(ex) || Math.abs(ey) <= Math.abs(ez);
        return widen(level ? -ez : 0, level ? 0 : ez, level ? ex : -ey)
                && widen(
                        (y[1] - y[0]) * (z[2] - z[0]) - (z[1] - z[0]) * (y[2] - y[0]),
                        (z[1] - z[0]) * (x[2] - x[0]) - (x[1] - x[0]) * (z[2] - z[0]),
                        (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]))
                && close();
    }

    /** Adds the point furthest from the first along a line, on the side on which it is further. */
    private boolean widen(double dx, double dy, double dz) {
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (!(length > 0)) {
            return false;
        }
        int at = points;
        double base = (dx * x[0] + dy * y[0] + dz * z[0]) / length;
        double there = offer(dx / length, dy / length, dz / length) - base;
        double back = offer(-dx / length, -dy / length, -dz / length) + base;
        if (back > there) {
            move(at + 1, at);
        }
        points = at + 1;
        return Math.max(there, back) > error;
    }

    private boolean close() {
        double depth = inward(0, 1, 2, 3);
        int q = depth > 0 ? 1 : 2;
        int r = depth > 0 ? 2 : 1;
        add(0, q, r);
        add(0, 3, q);
        add(q, 3, r);
        add(r, 3, 0);
        return depth != 0;
    }

    /** Positive if s lies on the inner side of (p, q, r). */
    private double inward(int p, int q, int r, int s) {
        double ax = x[q] - x[p];
        double ay = y[q] - y[p];
        double az = z[q] - z[p];
        double bx = x[r] - x[p];
        double by = y[r] - y[p];
        double bz = z[r] - z[p];
        double cx = x[s] - x[p];
        double cy = y[s] - y[p];
        double cz = z[s] - z[p];
        return -(cx * (ay * bz - az * by) + cy * (az * bx - ax * bz) + cz * (ax * by - ay * bx));
    }

    private double distance(int p, int q) {
        double dx = x[q] - x[p];
        double dy = y[q] - y[p];
        double dz = z[q] - z[p];
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    private void move(int from, int to) {
        x[to] = x[from];
        y[to] = y[from];
        z[to] = z[from];
    }

    /** Expands the surface to the newest point: removes the sides that see it, and joins their boundary to it. */
    private boolean expand() {
        int p = points - 1;
        edges = 0;
        for (int k = sides - 1; k >= 0; k--) {
            if (sees(p, k)) {
                edge(cornerP[k], cornerQ[k]);
                edge(cornerQ[k], cornerR[k]);
                edge(cornerR[k], cornerP[k]);
                drop(k);
            }
        }
        if (edges == 0 || sides + edges > MOST_SIDES) {
            return false;
        }
        for (int k = 0; k < edges; k++) {
            add(edgeFrom[k], edgeTo[k], p);
        }
        return true;
    }

    /** Adds an edge of a removed side to the boundary, or cancels it with its opposite. */
    private void edge(int from, int to) {
        for (int k = 0; k < edges; k++) {
            if (edgeFrom[k] == to && edgeTo[k] == from) {
                edges--;
                edgeFrom[k] = edgeFrom[edges];
                edgeTo[k] = edgeTo[edges];
                return;
            }
        }
        edgeFrom[edges] = from;
        edgeTo[edges] = to;
        edges++;
    }

    private void drop(int k) {
        sides--;
        cornerP[k] = cornerP[sides];
        cornerQ[k] = cornerQ[sides];
        cornerR[k] = cornerR[sides];
        sideX[k] = sideX[sides];
        sideY[k] = sideY[sides];
        sideZ[k] = sideZ[sides];
        sideReach[k] = sideReach[sides];
        sideSize[k] = sideSize[sides];
        for (int axis = 0; axis < 3; axis++) {
            normal[3 * k + axis] = normal[3 * sides + axis];
            normalRest[3 * k + axis] = normalRest[3 * sides + axis];
        }
    }

    /** Whether a point lies beyond the plane of a side; points in the plane to within double-double rounding do not. */
    private boolean sees(int point, int side) {
        int corner = cornerP[side];
        double dx = x[point] - x[corner];
        double dy = y[point] - y[corner];
        double dz = z[point] - z[corner];
        int n = 3 * side;
        double value = normal[n] * dx + normal[n + 1] * dy + normal[n + 2] * dz;
        double size = sideSize[side] * (Math.abs(dx) + Math.abs(dy) + Math.abs(dz));
        if (Math.abs(value) > PLANE_ERROR * size) {
            return value > 0;
        }
        for (int axis = 0; axis < 3; axis++) {
            pairs.set(NORMAL + axis, normal[n + axis], normalRest[n + axis]);
        }
        way(WAY, corner, point);
        pairs.dot(VALUE, NORMAL, WAY, TEMPORARY);
        return pairs.get(VALUE) > PAIRS_ERROR * size;
    }

    private void way(int i, int from, int to) {
        pairs.difference(i, x[to], x[from]);
        pairs.difference(i + 1, y[to], y[from]);
        pairs.difference(i + 2, z[to], z[from]);
    }

    private void add(int p, int q, int r) {
        way(ALONG, p, q);
        way(ACROSS, p, r);
        pairs.cross(NORMAL, ALONG, ACROSS, TEMPORARY);
        int k = sides++;
        cornerP[k] = p;
        cornerQ[k] = q;
        cornerR[k] = r;
        sideSize[k] = distance(p, q) * distance(p, r);
        for (int axis = 0; axis < 3; axis++) {
            normal[3 * k + axis] = pairs.get(NORMAL + axis);
            normalRest[3 * k + axis] = pairs.rest(NORMAL + axis);
        }
        double nx = normal[3 * k];
        double ny = normal[3 * k + 1];
        double nz = normal[3 * k + 2];
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        sideX[k] = nx / length;
        sideY[k] = ny / length;
        sideZ[k] = nz / length;
        sideReach[k] = Math.min(reach(k, p), Math.min(reach(k, q), reach(k, r)));
    }

    private double reach(int side, int point) {
        return sideX[side] * x[point] + sideY[side] * y[point] + sideZ[side] * z[point];
    }
}
