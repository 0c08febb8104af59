package robosim.geometry.narrow.sat;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.leaf.Leaf;

/** A sphere against the other shapes in exact arithmetic: squares are compared, without roots. Slow. */
public final class ExactSphere {
    private final ExactVector centre;
    private final Dyadic radius;
    private final Dyadic square;

    public ExactSphere(double[] row, int at) {
        centre = ExactVector.at(row, at);
        radius = Dyadic.of(row[at + Leaf.SIZE]);
        square = radius.square();
    }

    public boolean touchesSphere(double[] row, int at) {
        Dyadic reach = radius.add(Dyadic.of(row[at + Leaf.SIZE]));
        return ExactVector.at(row, at).minus(centre).square().compareTo(reach.square()) <= 0;
    }

    /** The centre is inside, or within the radius of an edge or a side. */
    public boolean touchesPolytope(ExactPolytope polytope) {
        if (polytope.contains(centre)) {
            return true;
        }
        for (ExactPolytope.Edge edge : polytope.outline()) {
            if (touchesEdge(edge)) {
                return true;
            }
        }
        for (ExactPolytope.Side side : polytope.sides()) {
            Dyadic height = centre.minus(side.corner()).dot(side.normal());
            if (height.square().compareTo(square.multiply(side.normal().square())) <= 0
                    && side.coversFootOf(centre, Dyadic.ONE)) {
                return true;
            }
        }
        return false;
    }

    private boolean touchesEdge(ExactPolytope.Edge edge) {
        ExactVector w = centre.minus(edge.from());
        if (w.square().compareTo(square) <= 0 || w.minus(edge.along()).square().compareTo(square) <= 0) {
            return true;
        }
        Dyadic ahead = w.dot(edge.along());
        Dyadic length = edge.along().square();
        // Strictly between the ends, which were tested before; nothing is there for an edge of length 0.
        return ahead.signum() > 0
                && ahead.compareTo(length) < 0
                && w.square().multiply(length).subtract(ahead.square()).compareTo(square.multiply(length)) <= 0;
    }

    /**
     * Let A = a.a, s the centre's coordinate along a (times A) and q its squared distance from the axis (times A).
     * Beside the cylinder, q is compared with (r + R)^2 A. Beyond a cap, the distance to the disc's interior or rim is
     * compared with R; squaring removes the only root, 2 r sqrt(q).
     */
    public boolean touchesCylinder(ExactCylinder cylinder) {
        ExactVector w = centre.minus(cylinder.centre);
        Dyadic s = w.dot(cylinder.axis).abs();
        Dyadic beyond = s.subtract(cylinder.half);
        Dyadic q = w.cross(cylinder.axis).square();
        Dyadic a = cylinder.axisSquare;
        Dyadic r = cylinder.radius;
        if (beyond.signum() <= 0) {
            return q.compareTo(r.add(radius).square().multiply(a)) <= 0;
        }
        Dyadic excess = beyond.square();
        if (q.compareTo(r.square().multiply(a)) <= 0) {
            return excess.compareTo(square.multiply(a)) <= 0;
        }
        // (sqrt(q/A) - r)^2 + excess/A <= R^2
        Dyadic left = q.add(excess).add(r.square().subtract(square).multiply(a));
        Dyadic right = r.square().multiply(q).multiply(a).scale(2);
        return left.signum() <= 0 || left.square().compareTo(right) <= 0;
    }
}
