package robosim.geometry.narrow.cone;

import static robosim.geometry.exact.VectorMath.U;

import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The distance from a cone's apex to the part of a polytope inside the cone. The nearest point is the nearest point in
 * the cone of a face's plane, if the face contains it; otherwise it is on an edge.
 *
 * <p>Whether anything is in the cone is exact for the stored cosine: either the axis meets the polytope, or an edge
 * meets the cone. Distances of clipped edges and of faces are computed in pairs of doubles.
 */
final class ConePolytope {
    /**
     * Roundoff of the greatest depth of an edge, in u = 2^-53 of the distance of its farther end. An end is rounded
     * once, a point between them is off by 6, and depth changes by up to twice that: 12; its own products, sums, root
     * and difference add 9. The point is not quite the deepest: if an edge's direction is off by 4, depth loses 4 of at
     * most twice the distance, 8, and for a foot and a height off by 4 each at most 8 each. In all 45, taken as 48.
     *
     * <p>For a corner alone 5.1 were observed, more than a tenth. The rest is rarely at its worst either: a foot and a
     * height only if the edge's line passes the apex as near as rounding. No verdict was found that a tenth of the
     * bound spoils.
     */
    private static final double FILTER = FilterBound.bound(48 * U);

    /**
     * The share of {@code b^2} down to which {@code b^2 - a c} is taken from pairs of doubles: its root is then off by
     * 2^-60 of b. It is less if the edge's line passes the apex almost, or the cone.
     */
    private static final double CANCELLED = FilterBound.bound(0x1p-80);

    /**
     * So many times as far away as the roundoff of its depth, a point's direction is known to 2^-20, and pairs of doubles
     * find what of an edge that grazes the cone is in it.
     */
    private static final double NEAR = 0x1p20;

    /**
     * If the depth f at the foot, at a distance h, is in doubt by an error, and D at a distance L along the edge is certain,
     * the cone begins within L error / D of the foot, as depth is concave. That is farther away by its square over 2 h: by
     * less than an ulp of h where it is less than h / 2^26.
     */
    private static final double SQUARE_NEAR = 0x1p26;

    /** More than a length loses to underflow. */
    private static final double UNDERFLOW = 0x1p-530;

    private static final StageCounters.Counter EXACT = StageCounters.counter("ConePolytope");

    static final int POINT = Cone.FREE;
    static final int EDGE = POINT + 3;
    static final int OTHER = EDGE + 3;
    static final int NORMAL = OTHER + 3;
    static final int A = NORMAL + 3;
    static final int B = A + 1;
    static final int C = B + 1;
    static final int D = C + 1;
    private static final int SHARE = D + 1;
    static final int TEMPORARY = SHARE + 1;

    /** More than rounding moves a corner or changes a distance, as a share of coordinates. */
    private static final double ROUNDING = 0x1p-40;

    private final ConeCorners corners = new ConeCorners();
    private final ConeFaces faces = new ConeFaces(corners);
    private double extent;

    /** How far the edges of a prism are from the apex, or less; infinite for those that have been looked at. */
    private final double[] gaps = new double[32];

    /** The edge that is looked at: one end, and the way to the other. */
    private double px;

    private double py;
    private double pz;
    private double ex;
    private double ey;
    private double ez;

    /**
     * The distance; {@code axis} is the distance where the axis itself meets the leaf (+Infinity where it does not).
     *
     * @param limit a distance beyond which an answer is not needed
     */
    double distance(Cone cone, double axis, double limit, LeafKind kind, double[] row, int j) {
        corners.set(cone, kind, row, j);
        if (kind == LeafKind.PRISM) {
            return prism(cone, axis, limit);
        }
        double best = edges(cone, ConeCorners.edges(kind), axis);
        if (best == Double.POSITIVE_INFINITY) {
            return best;
        }
        for (int[] face : ConeCorners.faces(kind)) {
            if (corners.isFaceThere(face)) {
                best = Math.min(best, faces.distance(cone, face, extent, best));
            }
        }
        return best;
    }

    /**
     * The same for a prism, of those features only that may be as near as the nearest found. The distance of a feature that is
     * certainly farther cannot be the least.
     */
    private double prism(Cone cone, double axis, double limit) {
        int[] edges = ConeCorners.edges(LeafKind.PRISM);
        double best = nearestEdges(cone, edges, axis, limit);
        double nearest = best;
        int[][] sides = ConeCorners.faces(LeafKind.PRISM);
        for (int k = 0; k < sides.length; k++) {
            double gap = corners.gap(cone, k);
            if (gap > 0 && gap <= Math.min(nearest, limit) && corners.isFaceThere(sides[k])) {
                nearest = Math.min(nearest, faces.distance(cone, sides[k], extent, nearest));
            }
        }
        // A foot on the border of a face does not tell whether there is a hit.
        return best < Double.POSITIVE_INFINITY || (nearest < Double.POSITIVE_INFINITY && isAnyHit(cone, edges))
                ? nearest
                : Double.POSITIVE_INFINITY;
    }

    /** The least distance of edges, starting with the nearest; those are left out that are farther than the least or the limit. */
    private double nearestEdges(Cone cone, int[] edges, double axis, double limit) {
        extent = Math.max(corners.extent, VectorMath.largest(cone.ox, cone.oy, cone.oz));
        for (int k = 0; k < edges.length / 2; k++) {
            gaps[k] = corners.isThere(edges[2 * k]) ? gap(edges[2 * k], edges[2 * k + 1]) : Double.POSITIVE_INFINITY;
        }
        double best = axis;
        while (true) {
            int next = 0;
            for (int k = 1; k < edges.length / 2; k++) {
                next = gaps[k] < gaps[next] ? k : next;
            }
            if (!(gaps[next] <= Math.min(best, limit)) || gaps[next] == Double.POSITIVE_INFINITY) {
                return best;
            }
            gaps[next] = Double.POSITIVE_INFINITY;
            best = Math.min(best, edge(cone, edges[2 * next], edges[2 * next + 1]));
        }
    }

    /** Whether the cone holds a point of an edge that was left out. */
    private boolean isAnyHit(Cone cone, int[] edges) {
        for (int k = 0; k < edges.length / 2; k++) {
            if (gaps[k] < Double.POSITIVE_INFINITY
                    && edge(cone, edges[2 * k], edges[2 * k + 1]) < Double.POSITIVE_INFINITY) {
                return true;
            }
        }
        return false;
    }

    /** A lower bound of the distance of an edge. */
    private double gap(int from, int to) {
        double[] v = corners.hi;
        double x = v[3 * from];
        double y = v[3 * from + 1];
        double z = v[3 * from + 2];
        double dx = v[3 * to] - x;
        double dy = v[3 * to + 1] - y;
        double dz = v[3 * to + 2] - z;
        double length = dx * dx + dy * dy + dz * dz;
        double ahead = -(x * dx + y * dy + z * dz);
        double share = ahead > 0 && length > 0 ? Math.min(1, ahead / length) : 0;
        double size = Math.abs(x) + Math.abs(y) + Math.abs(z) + Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
        x += share * dx;
        y += share * dy;
        z += share * dz;
        return Math.sqrt(x * x + y * y + z * z) - ROUNDING * size;
    }

    /**
     * The same for a box, of those features only that are near a plain solution; below 0 where that is not confirmed.
     */
    double near(Cone cone, PlainConeBox plain, double axis, LeafKind kind, double[] row, int j) {
        corners.setBox(cone, row, j);
        extent = Math.max(corners.extent, VectorMath.largest(cone.ox, cone.oy, cone.oz));
        double best = axis;
        int near = 0;
        for (int i = 0; i < 3; i++) {
            for (int side = 0; side < 2; side++) {
                if (plain.isNear(i, side)) {
                    near++;
                    best = Math.min(best, nearEdges(cone, plain, i, side));
                }
            }
        }
        if (near > 1 && best == Double.POSITIVE_INFINITY) {
            return -1; // a foot on the border of a face does not tell whether there is a hit
        }
        for (int i = 0; i < 3; i++) {
            for (int side = 0; side < 2; side++) {
                if (plain.isNear(i, side) && plain.isFootNear(i, side)) {
                    best = Math.min(best, faces.near(cone, ConeCorners.boxFace(i, side), near == 1, extent, best));
                }
            }
        }
        return best <= plain.atMost() ? best : -1;
    }

    /** The edges of a face and of faces across later axes. */
    private double nearEdges(Cone cone, PlainConeBox plain, int i, int side) {
        double best = Double.POSITIVE_INFINITY;
        for (int other = i + 1; other < 3; other++) {
            for (int otherSide = 0; otherSide < 2; otherSide++) {
                if (plain.isNear(other, otherSide)) {
                    int from = side << i | otherSide << other;
                    int to = from | 1 << (3 - i - other);
                    corners.take(from);
                    corners.take(to);
                    best = Math.min(best, edge(cone, from, to));
                }
            }
        }
        return best;
    }

    /** The same for a leaf that is flat in a plane through the apex and the axis: all faces are edge on and ignored. */
    double flat(Cone cone, double axis, double limit, LeafKind kind, double[] row, int j) {
        corners.set(cone, kind, row, j);
        if (kind == LeafKind.PRISM) {
            return nearestEdges(cone, ConeCorners.flatEdges(kind), axis, limit);
        }
        return edges(cone, ConeCorners.flatEdges(kind), axis);
    }

    /** The same for one edge of a box. */
    double flatEdge(Cone cone, int from, int to, LeafKind kind, double[] row, int j) {
        corners.setBox(cone, row, j);
        corners.take(from);
        corners.take(to);
        extent = Math.max(corners.extent, VectorMath.largest(cone.ox, cone.oy, cone.oz));
        return edge(cone, from, to);
    }

    private double edges(Cone cone, int[] edges, double axis) {
        extent = Math.max(corners.extent, VectorMath.largest(cone.ox, cone.oy, cone.oz));
        double best = axis;
        for (int i = 0; i < edges.length; i += 2) {
            if (corners.isThere(edges[i])) {
                best = Math.min(best, edge(cone, edges[i], edges[i + 1]));
            }
        }
        return best;
    }

    private double edge(Cone cone, int from, int to) {
        double[] v = corners.hi;
        px = v[3 * from];
        py = v[3 * from + 1];
        pz = v[3 * from + 2];
        ex = v[3 * to] - px;
        ey = v[3 * to + 1] - py;
        ez = v[3 * to + 2] - pz;
        double ee = ex * ex + ey * ey + ez * ez;
        double foot = ee > 0 ? -(px * ex + py * ey + pz * ez) / ee : 0;
        double deepest = ee > 0 ? deepest(cone, foot, Math.sqrt(ee)) : 0;
        double depth = depth(cone, deepest);
        double farther =
                Math.max(VectorMath.length(px, py, pz), VectorMath.length(v[3 * to], v[3 * to + 1], v[3 * to + 2]));
        double error = FILTER * farther + UNDERFLOW;
        if (depth < -error) {
            return Double.POSITIVE_INFINITY;
        }
        if (!(depth > error)) {
            if (!(distance(deepest) > NEAR * error)) {
                return exactly(cone, from, to);
            }
            if (!isExactlyHit(cone, from, to)) {
                return Double.POSITIVE_INFINITY;
            }
        }
        double nearest = Math.max(0, Math.min(1, foot));
        double there = depth(cone, nearest);
        boolean isIn = there >= 0;
        if (Math.abs(there) <= error) {
            if (nearest == 0 || nearest == 1) {
                // Along the edge, the slope of the distance is 0 at the foot, but not at a corner.
                isIn = isExactlyHeld(cone, nearest == 0 ? from : to);
            } else if (!(distance(nearest) * depth
                    > SQUARE_NEAR * error * (Math.abs(deepest - nearest) * Math.sqrt(ee)))) {
                return exactly(cone, from, to);
            }
        }
        return isIn ? distance(nearest) : entry(cone, from, to, nearest, deepest);
    }

    private double distance(double share) {
        return VectorMath.length(px + share * ex, py + share * ey, pz + share * ez);
    }

    /**
     * Where the depth is greatest along a segment: it decreases to both sides of the point past the foot by {@code h k
     * / sqrt(cos^2 - k^2)}, if k, the cosine of the line's direction, is below the cone's; h is the line's distance.
     */
    private double deepest(Cone cone, double foot, double length) {
        double k = (ex * cone.ux + ey * cone.uy + ez * cone.uz) / length;
        double across = (cone.cos - k) * (cone.cos + k);
        double place;
        if (across > 0) {
            double h = VectorMath.length(px + foot * ex, py + foot * ey, pz + foot * ez);
            place = foot + h * k / Math.sqrt(across) / length;
        } else {
            place = k;
        }
        double best = Math.max(0, Math.min(1, place));
        double depth = depth(cone, best);
        if (cone.depth(px, py, pz) > depth) {
            return 0;
        }
        return cone.depth(px + ex, py + ey, pz + ez) > depth ? 1 : best;
    }

    private double depth(Cone cone, double share) {
        return cone.depth(px + share * ex, py + share * ey, pz + share * ez);
    }

    private boolean isExactlyHit(Cone cone, int from, int to) {
        EXACT.count();
        return new ExactCone(cone, extent).touches(corners, from, to);
    }

    private boolean isExactlyHeld(Cone cone, int corner) {
        EXACT.count();
        return new ExactCone(cone, extent).holds(corners, corner);
    }

    /** The distance where doubles leave open what of an edge is in the cone, as they do if it all but meets the apex. */
    private double exactly(Cone cone, int from, int to) {
        EXACT.count();
        return new ExactCone(cone, extent).edge(corners, from, to);
    }

    /**
     * The distance at which the segment enters the cone between a share outside and one inside. Relative to the latter,
     * {@code (x.u)^2 - cos^2 x^2} is {@code a t^2 + 2 b t + c} with c at least 0; its first root is needed.
     */
    private double entry(Cone cone, int from, int to, double outside, double deepest) {
        DoubleDoubles p = cone.pairs;
        double inside = deepest;
        seen(cone, from, to, inside);
        if (p.get(C) < 0) {
            inside = certain(cone, from, to, deepest);
            seen(cone, from, to, inside);
        }
        double way = outside < inside ? -1 : 1;
        if (way < 0) {
            p.negate(B);
        }
        if (p.get(C) < 0) {
            p.set(C, 0);
        }
        p.multiply(D, B, B);
        p.multiply(SHARE, A, C);
        p.subtract(D, D, SHARE);
        if (!(p.get(D) > CANCELLED * (p.get(B) * p.get(B)))) {
            return exactly(cone, from, to);
        }
        p.root(D, D);
        if (p.get(B) <= 0) {
            p.subtract(D, D, B);
            if (p.get(D) > 0) {
                p.divide(SHARE, C, D);
            } else {
                p.set(SHARE, 0);
            }
        } else {
            p.add(D, D, B);
            p.negate(A);
            p.divide(SHARE, D, A);
        }
        double most = Math.abs(inside - outside);
        if (!(p.get(SHARE) <= most)) {
            p.set(SHARE, most);
        }
        if (way < 0) {
            p.negate(SHARE);
        }
        p.advance(POINT, POINT, SHARE, EDGE, TEMPORARY);
        p.dot(D, POINT, POINT, TEMPORARY);
        p.root(D, D);
        return p.get(D);
    }

    /** The quadratic relative to a share of the segment, whose point is stored in {@code POINT}. */
    private void seen(Cone cone, int from, int to, double share) {
        DoubleDoubles p = cone.pairs;
        corners.load(p, POINT, from);
        corners.load(p, OTHER, to);
        p.subtractVector(EDGE, OTHER, POINT);
        p.set(SHARE, share);
        p.advance(POINT, POINT, SHARE, EDGE, TEMPORARY);
        // NORMAL: x.u, e.u, cos^2
        p.dot(NORMAL, POINT, Cone.AXIS, TEMPORARY);
        p.dot(NORMAL + 1, EDGE, Cone.AXIS, TEMPORARY);
        p.product(NORMAL + 2, cone.cos, cone.cos);
        quadratic(p, A, EDGE, EDGE, NORMAL + 1, NORMAL + 1);
        quadratic(p, B, POINT, EDGE, NORMAL, NORMAL + 1);
        quadratic(p, C, POINT, POINT, NORMAL, NORMAL);
    }

    /**
     * The deepest share in pairs of doubles, where the one from doubles is outside: a short edge along the border is
     * equally deep everywhere within their accuracy.
     */
    private double certain(Cone cone, int from, int to, double deepest) {
        double best = deepest;
        double most = angle(cone, from, to, deepest);
        double vertex = -cone.pairs.get(B) / cone.pairs.get(A) + deepest;
        for (int k = 0; k < 3; k++) {
            double share = k == 2 ? vertex : k;
            double angle = share >= 0 && share <= 1 ? angle(cone, from, to, share) : Double.NEGATIVE_INFINITY;
            if (angle > most) {
                most = angle;
                best = share;
            }
        }
        return best;
    }

    // How far a share is within the cone: cos^2 of its own angle minus that of the cone's; -1 behind the apex.
    private double angle(Cone cone, int from, int to, double share) {
        seen(cone, from, to, share);
        DoubleDoubles p = cone.pairs;
        p.dot(D, POINT, POINT, TEMPORARY);
        return p.get(NORMAL) < 0 ? -1 : p.get(C) / p.get(D);
    }

    // out = ahead1 ahead2 - cos^2 (x.y)
    private static void quadratic(DoubleDoubles p, int out, int x, int y, int ahead1, int ahead2) {
        p.dot(out, x, y, TEMPORARY);
        p.multiply(out, out, NORMAL + 2);
        p.multiply(TEMPORARY, ahead1, ahead2);
        p.subtract(out, TEMPORARY, out);
    }
}
