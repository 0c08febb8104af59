package robosim.geometry.narrow.cone;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.ray.ExactRay;

/**
 * The distance of an edge or a face of a polytope in a cone, from exact numbers: what {@link ConePolytope} and {@link ConeFaces}
 * leave in doubt. Whether a point is in the cone, and in the face, is exact. Roots and quotients have {@link #BITS} bits, and
 * are only added where none cancels.
 *
 * <p>All vectors are relative to the apex, in the scale of its ray.
 */
final class ExactCone {
    /** More than three times the bits of a double. */
    private static final int BITS = 192;

    private final ExactRay ray;

    /** The axis, at its own length, and its square. */
    private final ExactVector axis;

    private final Dyadic square;
    private final Dyadic squareCos;

    /**
     * A cone for what is no larger, and no farther from the origin, than {@code extent}.
     */
    ExactCone(Cone cone, double extent) {
        ray = new ExactRay(cone.ox, cone.oy, cone.oz, cone.dx, cone.dy, cone.dz, extent);
        axis = ray.direction;
        square = axis.square();
        squareCos = Dyadic.of(cone.cos).square();
    }

    /** Whether a corner is in the cone. */
    boolean holds(ConeCorners corners, int corner) {
        return Cone.holds(corners.exact(ray, corner), axis, squareCos);
    }

    /** Whether any point of an edge is in the cone. */
    boolean touches(ConeCorners corners, int from, int to) {
        return Cone.touches(corners.exact(ray, from), corners.exact(ray, to), axis, squareCos);
    }

    /** The distance of an edge within the cone; +Infinity if none of it is. */
    double edge(ConeCorners corners, int from, int to) {
        return edge(corners.exact(ray, from), corners.exact(ray, to));
    }

    private double edge(ExactVector p, ExactVector q) {
        if (!Cone.touches(p, q, axis, squareCos)) {
            return Double.POSITIVE_INFINITY;
        }
        ExactVector e = q.minus(p);
        Dyadic ee = e.square();
        if (ee.signum() == 0) {
            return ray.unscaled(p.square().root(BITS));
        }
        // The nearest point of the segment times the square of its length: the foot, or an end.
        Dyadic foot = p.dot(e).negate().max(Dyadic.ZERO).min(ee);
        ExactVector n = p.times(ee).plus(e.times(foot));
        if (Cone.holds(n, axis, squareCos)) {
            return length(n.square(), ee);
        }
        // From there, (x.d)^2 - cos^2 x^2 d^2 is a t^2 + 2 b t + c along e.
        Dyadic limit = squareCos.multiply(square);
        Dyadic ahead = n.dot(axis);
        Dyadic rise = e.dot(axis);
        Dyadic aside = n.dot(e);
        Dyadic a = rise.square().subtract(limit.multiply(ee));
        Dyadic b = ahead.multiply(rise).subtract(limit.multiply(aside));
        Dyadic c = ahead.square().subtract(limit.multiply(n.square()));
        // What is in the cone is on one side: that of an end in it, or else of the vertex.
        int way = Cone.holds(q, axis, squareCos) ? 1 : Cone.holds(p, axis, squareCos) ? -1 : b.signum();
        Dyadic t = enter(a, b, c, way);
        Dyadic further = t.multiply(t.multiply(ee).add(aside.scale(1)));
        return length(n.square().add(further), ee);
    }

    /**
     * The root of {@code a t^2 + 2 b t + c} at which a line goes into the cone in a direction, 1 or -1: {@code (-b + way
     * root) / a}, or the same without cancellation.
     */
    private static Dyadic enter(Dyadic a, Dyadic b, Dyadic c, int way) {
        Dyadic root = b.square().subtract(a.multiply(c)).max(Dyadic.ZERO).root(BITS);
        Dyadic signed = way < 0 ? root.negate() : root;
        if (b.signum() * way > 0) {
            return c.over(b.add(signed), BITS).negate();
        }
        return a.signum() == 0 ? Dyadic.ZERO : signed.subtract(b).over(a, BITS);
    }

    private double length(Dyadic squared, Dyadic divisor) {
        return ray.unscaled(squared.root(BITS).over(divisor, BITS));
    }

    /**
     * The distance of a face's plane within the cone if the nearest point is in the face; +Infinity if it is not, and where the
     * face is degenerate or edge on.
     *
     * @param first which of its edges are taken for the normal, by where they begin in the list
     */
    double face(ConeCorners corners, int[] face, int first, int second) {
        ExactVector[] sides = new ExactVector[face.length];
        for (int k = 0; k < face.length; k++) {
            sides[k] = corners.exact(ray, face[k]);
        }
        return face(sides[first + 1].minus(sides[first]).cross(sides[second + 1].minus(sides[second])), sides);
    }

    private double face(ExactVector normal, ExactVector[] sides) {
        Dyadic height = normal.dot(sides[0]);
        if (height.signum() == 0) {
            return Double.POSITIVE_INFINITY;
        }
        // Towards the plane: the foot is m h / m^2.
        ExactVector m = height.signum() < 0 ? normal.negate() : normal;
        Dyadic h = height.abs();
        Dyadic mm = m.square();
        if (Cone.holds(m, axis, squareCos)) {
            return isInside(normal, sides, m.times(h), mm)
                    ? length(h.square().multiply(mm), mm)
                    : Double.POSITIVE_INFINITY;
        }
        // The nearest point in the cone is along its border in the plane of d and m, w = root(u) d + root(v) s, where s
        // is the
        // part of m across d, times d^2.
        Dyadic md = m.dot(axis);
        Dyadic cross = mm.multiply(square).subtract(md.square());
        ExactVector s = m.times(square).minus(axis.times(md));
        Dyadic u = squareCos.multiply(cross);
        Dyadic v = Dyadic.ONE.subtract(squareCos);
        // m.w = root(u) m.d + root(v) (m x d)^2
        if (signOfRoots(md, u, cross, v) <= 0) {
            return Double.POSITIVE_INFINITY;
        }
        int left = 0;
        int right = 0;
        for (int k = 0; k < sides.length; k += 2) {
            ExactVector across = normal.cross(sides[k + 1].minus(sides[k]));
            Dyadic own = across.dot(sides[k]);
            int side = signOfRoots(
                    h.multiply(across.dot(axis)).subtract(md.multiply(own)),
                    u,
                    h.multiply(across.dot(s)).subtract(cross.multiply(own)),
                    v);
            left += side > 0 ? 1 : 0;
            right += side < 0 ? 1 : 0;
        }
        if (left > 0 && right > 0) {
            return Double.POSITIVE_INFINITY;
        }
        Dyadic rate = u.root(BITS).multiply(md).add(v.root(BITS).multiply(cross));
        return ray.unscaled(h.multiply(square.multiply(cross).root(BITS)).over(rate, BITS));
    }

    /** Whether a point, given times a positive number, is in a face. */
    private static boolean isInside(ExactVector normal, ExactVector[] sides, ExactVector point, Dyadic times) {
        int left = 0;
        int right = 0;
        for (int k = 0; k < sides.length; k += 2) {
            ExactVector across = normal.cross(sides[k + 1].minus(sides[k]));
            int side = across.dot(point.minus(sides[k].times(times))).signum();
            left += side > 0 ? 1 : 0;
            right += side < 0 ? 1 : 0;
        }
        return left == 0 || right == 0;
    }

    /** The sign of {@code a root(u) + b root(v)}; u and v are at least 0. */
    private static int signOfRoots(Dyadic a, Dyadic u, Dyadic b, Dyadic v) {
        int first = a.signum() * u.signum();
        int second = b.signum() * v.signum();
        if (first == second || second == 0) {
            return first;
        }
        if (first == 0) {
            return second;
        }
        return first * a.square().multiply(u).compareTo(b.square().multiply(v));
    }
}
