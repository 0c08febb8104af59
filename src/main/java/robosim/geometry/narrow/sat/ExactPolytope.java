package robosim.geometry.narrow.sat;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * A box or triangle in exact arithmetic, for separating axes and distances that doubles could not decide. Slow.
 *
 * <p>A degenerate shape counts as thickened infinitesimally: a triangle as a prism across its plane, a segment as a box
 * along it. The axes of the thick bodies separate these for any thickness, however small. As the sets are closed and
 * bounded, they also separate the degenerate ones whenever these are apart.
 */
public final class ExactPolytope {
    private static final ExactVector UNIT_X = ExactVector.of(1, 0, 0);
    private static final ExactVector UNIT_Y = ExactVector.of(0, 1, 0);
    private static final ExactVector UNIT_Z = ExactVector.of(0, 0, 1);

    final boolean isBox;

    /** A box's half vectors, or a triangle's corners. */
    final List<ExactVector> spans = new ArrayList<>();

    /** A box's centre, or a triangle's first corner. */
    public final ExactVector centre;

    private final List<ExactVector> faces = new ArrayList<>();
    private final List<ExactVector> edges = new ArrayList<>();

    public ExactPolytope(Leaf leaf) {
        isBox = switch (leaf.kind.polytope()) {
            case BOX -> true;
            case TRIANGLE -> false;
        };
        centre = ExactVector.at(leaf.row, leaf.at);
        if (isBox) {
            for (int k = 0; k < 3; k++) {
                ExactVector column = ExactVector.column(leaf.row, leaf.at + Leaf.ROTATION + k);
                edges.add(column);
                spans.add(column.times(Dyadic.of(leaf.get(Leaf.SIZE + k))));
            }
            thicken();
        } else {
            for (int k = 0; k < 9; k += 3) {
                spans.add(ExactVector.at(leaf.row, leaf.at + k));
            }
            triangle();
        }
    }

    /** The side normals of the parallelepiped spanned by the three edges. */
    private void thicken() {
        faces.add(edges.get(1).cross(edges.get(2)));
        faces.add(edges.get(2).cross(edges.get(0)));
        faces.add(edges.get(0).cross(edges.get(1)));
    }

    private void triangle() {
        ExactVector longest = null;
        for (int k = 0; k < 3; k++) {
            ExactVector edge = spans.get((k + 1) % 3).minus(spans.get(k));
            if (!edge.isZero()) {
                longest = edge;
                edges.add(edge);
            }
        }
        if (longest == null) {
            edges.add(UNIT_X);
            edges.add(UNIT_Y);
            edges.add(UNIT_Z);
            thicken();
            return;
        }
        ExactVector normal = edges.get(0).cross(edges.get(1));
        if (normal.isZero()) {
            chooseAcross(longest);
            thicken();
            return;
        }
        faces.add(normal);
        for (ExactVector edge : edges) {
            faces.add(edge.cross(normal));
        }
        edges.add(normal);
    }

    /** Two unit directions that span space together with the direction of a segment. */
    private void chooseAcross(ExactVector along) {
        edges.clear();
        edges.add(along);
        if (along.x().signum() == 0) {
            edges.add(UNIT_X);
            edges.add(along.y().signum() == 0 ? UNIT_Y : UNIT_Z);
        } else {
            edges.add(UNIT_Y);
            edges.add(UNIT_Z);
        }
    }

    /**
     * Whether an axis separates two.
     *
     * @param doubts for two boxes, only these axes are tested, in the order of {@link PolytopePolytope}
     */
    static boolean apart(Leaf a, Leaf b, int doubts) {
        ExactPolytope p = new ExactPolytope(a);
        ExactPolytope q = new ExactPolytope(b);
        List<ExactVector> axes = new ArrayList<>(p.faces);
        axes.addAll(q.faces);
        for (ExactVector e : p.edges) {
            for (ExactVector f : q.edges) {
                axes.add(e.cross(f));
            }
        }
        boolean all = !(p.isBox && q.isBox);
        for (int k = 0; k < axes.size(); k++) {
            if ((all || (doubts >> k & 1) != 0) && separates(axes.get(k), p, q)) {
                return true;
            }
        }
        return false;
    }

    private static boolean separates(ExactVector axis, ExactPolytope p, ExactPolytope q) {
        return p.least(axis).compareTo(q.greatest(axis)) > 0 || q.least(axis).compareTo(p.greatest(axis)) > 0;
    }

    private Dyadic greatest(ExactVector axis) {
        if (isBox) {
            Dyadic sum = centre.dot(axis);
            for (ExactVector half : spans) {
                sum = sum.add(half.dot(axis).abs());
            }
            return sum;
        }
        return spans.get(0)
                .dot(axis)
                .max(spans.get(1).dot(axis))
                .max(spans.get(2).dot(axis));
    }

    private Dyadic least(ExactVector axis) {
        return greatest(axis.negate()).negate();
    }

    /** The straight edges, each once: its start and the vector along it. */
    public List<Edge> outline() {
        List<Edge> outline = new ArrayList<>();
        if (!isBox) {
            for (int k = 0; k < 3; k++) {
                outline.add(new Edge(spans.get(k), spans.get((k + 1) % 3).minus(spans.get(k))));
            }
            return outline;
        }
        Dyadic two = Dyadic.of(2);
        for (int k = 0; k < 3; k++) {
            ExactVector along = spans.get(k).times(two);
            ExactVector p = spans.get((k + 1) % 3);
            ExactVector q = spans.get((k + 2) % 3);
            ExactVector base = centre.minus(spans.get(k));
            outline.add(new Edge(base.plus(p).plus(q), along));
            outline.add(new Edge(base.plus(p).minus(q), along));
            outline.add(new Edge(base.minus(p).plus(q), along));
            outline.add(new Edge(base.minus(p).minus(q), along));
        }
        return outline;
    }

    /** The flat sides that have an area: six parallelograms, or the triangle. */
    public List<Side> sides() {
        List<Side> sides = new ArrayList<>();
        if (!isBox) {
            addSide(
                    sides,
                    spans.get(0),
                    spans.get(1).minus(spans.get(0)),
                    spans.get(2).minus(spans.get(0)));
            return sides;
        }
        Dyadic two = Dyadic.of(2);
        for (int k = 0; k < 3; k++) {
            ExactVector p = spans.get((k + 1) % 3);
            ExactVector q = spans.get((k + 2) % 3);
            ExactVector corner = centre.minus(p).minus(q);
            addSide(sides, corner.plus(spans.get(k)), p.times(two), q.times(two));
            addSide(sides, corner.minus(spans.get(k)), p.times(two), q.times(two));
        }
        return sides;
    }

    private void addSide(List<Side> sides, ExactVector corner, ExactVector p, ExactVector q) {
        ExactVector normal = p.cross(q);
        if (!normal.isZero()) {
            sides.add(new Side(corner, p, q, normal, isBox));
        }
    }

    /** Whether a point lies in a box; always false for a triangle. */
    public boolean contains(ExactVector point) {
        if (!isBox) {
            return false;
        }
        ExactVector w = point.minus(centre);
        for (int k = 0; k < 3; k++) {
            ExactVector normal = faces.get(k);
            if (w.dot(normal).abs().compareTo(spans.get(k).dot(normal).abs()) > 0) {
                return false;
            }
        }
        return true;
    }

    /** A straight edge, given by a point and a vector. */
    public record Edge(ExactVector from, ExactVector along) {}

    /** A triangle or parallelogram with one corner given. */
    public record Side(ExactVector corner, ExactVector p, ExactVector q, ExactVector normal, boolean isParallelogram) {
        /**
         * Whether the foot of the point {@code numerator / denominator} (denominator positive) on the side's plane is
         * in the side.
         */
        public boolean coversFootOf(ExactVector numerator, Dyadic denominator) {
            ExactVector w = numerator.minus(corner.times(denominator));
            Dyadic alongP = w.cross(q).dot(normal);
            Dyadic alongQ = p.cross(w).dot(normal);
            if (alongP.signum() < 0 || alongQ.signum() < 0) {
                return false;
            }
            Dyadic whole = normal.square().multiply(denominator);
            return isParallelogram
                    ? alongP.compareTo(whole) <= 0 && alongQ.compareTo(whole) <= 0
                    : alongP.add(alongQ).compareTo(whole) <= 0;
        }
    }
}
