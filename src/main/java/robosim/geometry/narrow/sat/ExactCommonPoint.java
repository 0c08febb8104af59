package robosim.geometry.narrow.sat;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.PairOrder;

/**
 * A common point of two boxes or triangles, in exact arithmetic. Slow.
 *
 * <p>If the intersection of two convex bodies is not empty, it has a corner. There a corner of one lies in the other,
 * an edge of one passes through a side of the other, or two edges cross. The first of these that is found is the point.
 */
public final class ExactCommonPoint {
    private final ExactPolytope first;
    private final ExactPolytope second;

    private ExactCommonPoint(ExactPolytope first, ExactPolytope second) {
        this.first = first;
        this.second = second;
    }

    /**
     * Writes a common point, each coordinate to two units in the last place; false where there is none. (a, b) and (b,
     * a) give the same bits.
     */
    public static boolean point(Leaf a, Leaf b, double[] out) {
        ExactPolytope p = new ExactPolytope(a);
        ExactPolytope q = new ExactPolytope(b);
        boolean reversed = PairOrder.isReversed(a, b);
        ExactCommonPoint common = reversed ? new ExactCommonPoint(q, p) : new ExactCommonPoint(p, q);
        return common.find(out);
    }

    private boolean find(double[] out) {
        return corner(first, second, out)
                || corner(second, first, out)
                || edgeThroughSide(first, second, out)
                || edgeThroughSide(second, first, out)
                || edges(out);
    }

    private static boolean corner(ExactPolytope of, ExactPolytope in, double[] out) {
        for (ExactVector corner : corners(of)) {
            if (holds(in, corner)) {
                return write(corner, Dyadic.ONE, out);
            }
        }
        return false;
    }

    private static List<ExactVector> corners(ExactPolytope of) {
        if (!of.isBox) {
            return of.spans;
        }
        List<ExactVector> corners = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            ExactVector corner = of.centre;
            for (int axis = 0; axis < 3; axis++) {
                ExactVector half = of.spans.get(axis);
                corner = (k >> axis & 1) == 0 ? corner.minus(half) : corner.plus(half);
            }
            corners.add(corner);
        }
        return corners;
    }

    private static boolean holds(ExactPolytope in, ExactVector point) {
        if (in.contains(point)) {
            return true;
        }
        for (ExactPolytope.Side side : in.sides()) {
            if (side.normal().dot(point.minus(side.corner())).signum() == 0 && side.coversFootOf(point, Dyadic.ONE)) {
                return true;
            }
        }
        for (ExactPolytope.Edge edge : in.outline()) {
            ExactVector w = point.minus(edge.from());
            Dyadic ahead = w.dot(edge.along());
            if (w.cross(edge.along()).isZero()
                    && ahead.signum() >= 0
                    && ahead.compareTo(edge.along().square()) <= 0
                    && (!edge.along().isZero() || w.isZero())) {
                return true;
            }
        }
        return false;
    }

    private static boolean edgeThroughSide(ExactPolytope of, ExactPolytope in, double[] out) {
        List<ExactPolytope.Side> sides = in.sides();
        for (ExactPolytope.Edge edge : of.outline()) {
            for (ExactPolytope.Side side : sides) {
                Dyadic share = side.normal().dot(side.corner().minus(edge.from()));
                Dyadic whole = side.normal().dot(edge.along());
                if (whole.signum() < 0) {
                    share = share.negate();
                    whole = whole.negate();
                }
                if (whole.signum() == 0 || !isShare(share, whole)) {
                    continue;
                }
                ExactVector point = along(edge, share, whole);
                if (side.coversFootOf(point, whole)) {
                    return write(point, whole, out);
                }
            }
        }
        return false;
    }

    private boolean edges(double[] out) {
        List<ExactPolytope.Edge> others = second.outline();
        for (ExactPolytope.Edge p : first.outline()) {
            for (ExactPolytope.Edge q : others) {
                ExactVector across = p.along().cross(q.along());
                ExactVector w = q.from().minus(p.from());
                Dyadic whole = across.square();
                if (whole.signum() == 0 || w.dot(across).signum() != 0) {
                    continue; // parallel or skew
                }
                Dyadic share = w.cross(q.along()).dot(across);
                if (isShare(share, whole) && isShare(w.cross(p.along()).dot(across), whole)) {
                    return write(along(p, share, whole), whole, out);
                }
            }
        }
        return false;
    }

    private static boolean isShare(Dyadic share, Dyadic whole) {
        return share.signum() >= 0 && share.compareTo(whole) <= 0;
    }

    /** The point at a fraction of an edge's length, times {@code whole}. */
    private static ExactVector along(ExactPolytope.Edge edge, Dyadic share, Dyadic whole) {
        return edge.from().times(whole).plus(edge.along().times(share));
    }

    private static boolean write(ExactVector point, Dyadic denominator, double[] out) {
        out[0] = ratio(point.x(), denominator);
        out[1] = ratio(point.y(), denominator);
        out[2] = ratio(point.z(), denominator);
        return true;
    }

    /** Both are scaled to near 1 before they are converted to doubles. */
    private static double ratio(Dyadic numerator, Dyadic denominator) {
        int top = denominator.magnitude();
        return numerator.scale(-top).doubleValue() / denominator.scale(-top).doubleValue();
    }
}
