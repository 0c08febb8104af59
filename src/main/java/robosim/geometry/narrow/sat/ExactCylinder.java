package robosim.geometry.narrow.sat;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * A cylinder {@code |(x - c).a| <= h a.a, |(x - c) x a| <= r |a|} against boxes and triangles in exact arithmetic.
 * Slow.
 *
 * <p>They meet where an edge meets the cylinder, where a side cuts it without an edge doing so, or where the cylinder
 * is wholly inside the box. In the second case the whole cut lies in the side, so one point of the cut is enough: where
 * the axis passes through the plane, or else the middle of the chord that the plane cuts from a cap.
 */
public final class ExactCylinder {
    final ExactVector centre;
    final ExactVector axis;
    final Dyadic radius;

    /** The half height times a.a: what (x - c).a is compared with. */
    final Dyadic half;

    final Dyadic axisSquare;
    final Dyadic halfHeight;
    private final Dyadic reach;

    public ExactCylinder(Leaf leaf) {
        centre = ExactVector.at(leaf.row, leaf.at);
        axis = leaf.kind.isTurned()
                ? ExactVector.column(leaf.row, leaf.at + Leaf.ROTATION + 1)
                : ExactVector.of(0, 1, 0);
        radius = Dyadic.of(leaf.get(3));
        halfHeight = Dyadic.of(leaf.get(4));
        axisSquare = axis.square();
        half = halfHeight.multiply(axisSquare);
        reach = radius.square().multiply(axisSquare);
    }

    boolean contains(ExactVector point) {
        ExactVector w = point.minus(centre);
        return w.dot(axis).abs().compareTo(half) <= 0 && w.cross(axis).square().compareTo(reach) <= 0;
    }

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
            if (axisHits(side)
                    || capHits(side, centre.plus(axis.times(halfHeight)))
                    || capHits(side, centre.minus(axis.times(halfHeight)))) {
                return true;
            }
        }
        return false;
    }

    /** Whether {@code q(t) <= 0} for a t in [0, 1] between the caps, where q is the squared distance from the axis less r^2. */
    private boolean touchesEdge(ExactPolytope.Edge edge) {
        ExactVector w = edge.from().minus(centre);
        Dyadic start = w.dot(axis);
        Dyadic slope = edge.along().dot(axis);
        // The fraction of the edge between the caps, as fractions with positive denominators.
        Dyadic lowNumerator = Dyadic.ZERO;
        Dyadic lowDenominator = Dyadic.ONE;
        Dyadic highNumerator = Dyadic.ONE;
        Dyadic highDenominator = Dyadic.ONE;
        if (slope.signum() == 0) {
            if (start.abs().compareTo(half) > 0) {
                return false;
            }
        } else {
            Dyadic steep = slope.abs();
            Dyadic towards = slope.signum() > 0 ? start.negate() : start;
            Dyadic enter = towards.subtract(half);
            Dyadic leave = towards.add(half);
            if (enter.signum() > 0) {
                lowNumerator = enter;
                lowDenominator = steep;
            }
            if (leave.compareTo(steep) < 0) {
                highNumerator = leave;
                highDenominator = steep;
            }
            if (lowNumerator.multiply(highDenominator).compareTo(highNumerator.multiply(lowDenominator)) > 0) {
                return false;
            }
        }
        ExactVector u = w.cross(axis);
        ExactVector v = edge.along().cross(axis);
        Dyadic a = v.square();
        Dyadic b = u.dot(v);
        Dyadic c = u.square().subtract(reach);
        Dyadic lowest = b.negate(); // divided by a: where q is least
        if (lowest.multiply(lowDenominator).compareTo(a.multiply(lowNumerator)) <= 0) {
            return isInside(a, b, c, lowNumerator, lowDenominator);
        }
        if (lowest.multiply(highDenominator).compareTo(a.multiply(highNumerator)) >= 0) {
            return isInside(a, b, c, highNumerator, highDenominator);
        }
        return a.multiply(c).compareTo(b.square()) <= 0;
    }

    /** Whether a t^2 + 2 b t + c is at most 0 at a fraction. */
    private static boolean isInside(Dyadic a, Dyadic b, Dyadic c, Dyadic numerator, Dyadic denominator) {
        return a.multiply(numerator.square())
                        .add(b.multiply(numerator).multiply(denominator).scale(1))
                        .add(c.multiply(denominator.square()))
                        .signum()
                <= 0;
    }

    private boolean axisHits(ExactPolytope.Side side) {
        Dyadic numerator = side.normal().dot(side.corner().minus(centre));
        Dyadic denominator = side.normal().dot(axis);
        if (denominator.signum() == 0) {
            return numerator.signum() == 0 && side.coversFootOf(centre, Dyadic.ONE);
        }
        if (denominator.signum() < 0) {
            numerator = numerator.negate();
            denominator = denominator.negate();
        }
        return numerator.abs().compareTo(halfHeight.multiply(denominator)) <= 0
                && side.coversFootOf(centre.times(denominator).plus(axis.times(numerator)), denominator);
    }

    /** The middle of the chord that the side's plane cuts from a cap: from the cap's centre along the plane's slope. */
    private boolean capHits(ExactPolytope.Side side, ExactVector cap) {
        ExactVector normal = side.normal();
        ExactVector slope = normal.times(axisSquare).minus(axis.times(normal.dot(axis)));
        Dyadic denominator = normal.dot(slope);
        if (denominator.signum() <= 0) {
            return false; // the plane is parallel to the cap
        }
        ExactVector offset = slope.times(normal.dot(side.corner().minus(cap)));
        return offset.square().compareTo(radius.square().multiply(denominator.square())) <= 0
                && side.coversFootOf(cap.times(denominator).plus(offset), denominator);
    }
}
