package robosim.geometry.narrow.sat;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.leaf.Leaf;

/** Two cylinders at any attitude in exact arithmetic: what can be decided without the roots of their rims. Slow. */
public final class ExactCylinders {
    private final ExactCylinder first;
    private final ExactCylinder second;
    private final ExactVector between;

    public ExactCylinders(Leaf a, Leaf b) {
        first = new ExactCylinder(a);
        second = new ExactCylinder(b);
        between = second.centre.minus(first.centre);
    }

    /**
     * For parallel axes: intervals along the axis, and discs across it. With a the first axis and w from centre to
     * centre, {@code |w.a| <= h a.a + H |a.b|} (each height is in lengths of its own axis) and {@code |w x a|^2 <= (r +
     * R)^2 a.a}.
     */
    public boolean parallelTouch() {
        ExactVector a = first.axis;
        Dyadic heights =
                first.half.add(second.halfHeight.multiply(a.dot(second.axis).abs()));
        Dyadic reach = first.radius.add(second.radius);
        return between.dot(a).abs().compareTo(heights) <= 0
                && between.cross(a).square().compareTo(reach.square().multiply(first.axisSquare)) <= 0;
    }

    public boolean areParallel() {
        return first.axis.cross(second.axis).isZero();
    }

    /** Whether a slab separates the two: along either axis, across both, or along one of the given directions. */
    public boolean isApart(double px, double py, double pz, double qx, double qy, double qz) {
        return separates(first.axis)
                || separates(second.axis)
                || separates(first.axis.cross(second.axis))
                || separates(ExactVector.of(px, py, pz))
                || separates(ExactVector.of(qx, qy, qz));
    }

    /** Whether both contain the given point, or one contains the centre of the other or of one of the other's caps. */
    public boolean haveInCommon(double x, double y, double z) {
        return bothHold(ExactVector.of(x, y, z)) || holdsMiddle(first, second) || holdsMiddle(second, first);
    }

    private static boolean holdsMiddle(ExactCylinder holder, ExactCylinder held) {
        ExactVector cap = held.axis.times(held.halfHeight);
        return holder.contains(held.centre)
                || holder.contains(held.centre.plus(cap))
                || holder.contains(held.centre.minus(cap));
    }

    private boolean bothHold(ExactVector point) {
        return first.contains(point) && second.contains(point);
    }

    /**
     * Whether {@code |n.w| > h |n.a| + H |n.b| + r sqrt(|n x a|^2 / a.a) + R sqrt(|n x b|^2 / b.b)}. The terms without
     * roots are moved to one side and all is multiplied by (a.a)(b.b), which gives D > sqrt(X) + sqrt(Y), that is
     * {@code D^2 - X - Y > 2 sqrt(X Y)}.
     */
    private boolean separates(ExactVector n) {
        Dyadic gap = n.dot(between)
                .abs()
                .subtract(first.halfHeight.multiply(n.dot(first.axis).abs()))
                .subtract(second.halfHeight.multiply(n.dot(second.axis).abs()));
        if (gap.signum() <= 0) {
            return false;
        }
        Dyadic a = first.axisSquare;
        Dyadic b = second.axisSquare;
        Dyadic x = first.radius
                .multiply(b)
                .square()
                .multiply(n.cross(first.axis).square())
                .multiply(a);
        Dyadic y = second.radius
                .multiply(a)
                .square()
                .multiply(n.cross(second.axis).square())
                .multiply(b);
        Dyadic rest = gap.multiply(a).multiply(b).square().subtract(x).subtract(y);
        return rest.signum() > 0 && rest.square().compareTo(x.multiply(y).scale(2)) > 0;
    }
}
