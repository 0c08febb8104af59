package robosim.geometry.narrow.sat;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * A capsule, or a sphere as one of length 0, against capsules, boxes and triangles, and a sphere against cylinders, in exact
 * arithmetic. The squared distance from its segment is compared with the squared radius, without roots. Slow.
 */
public final class ExactCapsule {
    private final ExactVector centre;

    /** From the centre to an end of the segment. */
    private final ExactVector half;

    private final Dyadic radius;

    public ExactCapsule(Leaf leaf) {
        centre = ExactVector.at(leaf.row, leaf.at);
        radius = Dyadic.of(leaf.get(Leaf.SIZE));
        half = switch (leaf.kind) {
            case SPHERE -> ExactVector.of(0, 0, 0);
            case UPRIGHT_CAPSULE -> ExactVector.of(0, leaf.get(Leaf.SIZE + 1), 0);
            case CAPSULE ->
                ExactVector.column(leaf.row, leaf.at + Leaf.ROTATION + 1).times(Dyadic.of(leaf.get(Leaf.SIZE + 1)));
            case UPRIGHT_BOX, BOX, UPRIGHT_CYLINDER, CYLINDER, TRIANGLE, PRISM, MESH, SOLID_MESH, GRID ->
                throw new IllegalArgumentException("leaf.kind must be a capsule or a sphere (got: " + leaf.kind + ")");
        };
    }

    private ExactVector from() {
        return centre.minus(half);
    }

    private ExactVector along() {
        return half.scale(1);
    }

    /** Whether it touches or overlaps another one. */
    public boolean touches(ExactCapsule other) {
        return areNear(
                from(),
                along(),
                other.from(),
                other.along(),
                radius.add(other.radius).square());
    }

    /**
     * Whether it touches or overlaps a box or a triangle: an end of the segment is inside or within the radius of a
     * side, or the segment is within the radius of an edge or passes through a side.
     */
    public boolean touchesPolytope(ExactPolytope polytope) {
        ExactVector from = from();
        ExactVector to = centre.plus(half);
        if (polytope.contains(from) || polytope.contains(to)) {
            return true;
        }
        Dyadic square = radius.square();
        for (ExactPolytope.Edge edge : polytope.outline()) {
            if (areNear(from, along(), edge.from(), edge.along(), square)) {
                return true;
            }
        }
        for (ExactPolytope.Side side : polytope.sides()) {
            Dyadic one = from.minus(side.corner()).dot(side.normal());
            Dyadic two = to.minus(side.corner()).dot(side.normal());
            Dyadic reach = square.multiply(side.normal().square());
            if (isAbove(side, from, one, reach)
                    || (!half.isZero() && isAbove(side, to, two, reach))
                    || crosses(side, from, one, to, two)) {
                return true;
            }
        }
        return false;
    }

    private static boolean isAbove(ExactPolytope.Side side, ExactVector end, Dyadic height, Dyadic reach) {
        return height.square().compareTo(reach) <= 0 && side.coversFootOf(end, Dyadic.ONE);
    }

    /** Whether a segment passes through a side, from the heights of its ends times the length of the normal. */
    private static boolean crosses(ExactPolytope.Side side, ExactVector from, Dyadic one, ExactVector to, Dyadic two) {
        if (one.signum() * two.signum() >= 0) {
            return false; // an end in the plane was tested before
        }
        Dyadic whole = two.subtract(one);
        ExactVector place = from.times(two).minus(to.times(one));
        return whole.signum() > 0 ? side.coversFootOf(place, whole) : side.coversFootOf(place.negate(), whole.negate());
    }

    /**
     * Whether a sphere touches or overlaps a cylinder. Let A = a.a, s the centre's coordinate along a (times A) and q its
     * squared distance from the axis (times A). Beside the cylinder, q is compared with (r + R)^2 A. Beyond a cap, the
     * distance to the disc's interior or rim is compared with R; squaring removes the only root, 2 r sqrt(q).
     */
    public boolean sphereTouches(ExactCylinder cylinder) {
        ExactVector w = centre.minus(cylinder.centre);
        Dyadic beyond = w.dot(cylinder.axis).abs().subtract(cylinder.half);
        Dyadic q = w.cross(cylinder.axis).square();
        Dyadic a = cylinder.axisSquare;
        Dyadic r = cylinder.radius;
        if (beyond.signum() <= 0) {
            return q.compareTo(r.add(radius).square().multiply(a)) <= 0;
        }
        Dyadic square = radius.square();
        Dyadic excess = beyond.square();
        if (q.compareTo(r.square().multiply(a)) <= 0) {
            return excess.compareTo(square.multiply(a)) <= 0;
        }
        // (sqrt(q/A) - r)^2 + excess/A <= R^2
        Dyadic left = q.add(excess).add(r.square().subtract(square).multiply(a));
        Dyadic right = r.square().multiply(q).multiply(a).scale(2);
        return left.signum() <= 0 || left.square().compareTo(right) <= 0;
    }

    /**
     * Whether two segments, each given by a point and a vector, are no farther apart than the root of {@code square}.
     */
    private static boolean areNear(ExactVector p, ExactVector u, ExactVector q, ExactVector v, Dyadic square) {
        if (u.isZero()) {
            return isNear(p, q, v, square);
        }
        if (isNear(p, q, v, square)
                || isNear(p.plus(u), q, v, square)
                || isNear(q, p, u, square)
                || isNear(q.plus(v), p, u, square)) {
            return true;
        }
        ExactVector normal = u.cross(v);
        Dyadic length = normal.square();
        ExactVector w = q.minus(p);
        Dyadic alongU = w.cross(v).dot(normal);
        Dyadic alongV = w.cross(u).dot(normal);
        // Strictly between all ends, which were tested before; nothing is there for parallel segments.
        return isBetween(alongU, length)
                && isBetween(alongV, length)
                && w.dot(normal).square().compareTo(square.multiply(length)) <= 0;
    }

    private static boolean isBetween(Dyadic value, Dyadic most) {
        return value.signum() > 0 && value.compareTo(most) < 0;
    }

    /** Whether a point is no farther from a segment than the root of {@code square}. */
    private static boolean isNear(ExactVector point, ExactVector from, ExactVector along, Dyadic square) {
        ExactVector w = point.minus(from);
        if (w.square().compareTo(square) <= 0 || w.minus(along).square().compareTo(square) <= 0) {
            return true;
        }
        Dyadic ahead = w.dot(along);
        Dyadic length = along.square();
        return isBetween(ahead, length)
                && w.square().multiply(length).subtract(ahead.square()).compareTo(square.multiply(length)) <= 0;
    }
}
