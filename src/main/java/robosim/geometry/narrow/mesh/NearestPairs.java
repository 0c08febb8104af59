package robosim.geometry.narrow.mesh;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.BoxGap;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.ConvexOverlap;
import robosim.geometry.narrow.overlap.OverlapScratch;

/**
 * Finds step by step whether two objects touch and how far apart they are: pairs of boxes are opened, nearest first,
 * down to the leaves, and after each step a bracket contains the distance. More steps never widen it.
 *
 * <p>The lower end is the minimum distance of the pairs that are still to be opened or have been measured; the upper
 * end that of two points, one on each object. (a, b) and (b, a) give the same bits after each step. An instance belongs
 * to one owner of queries; a step allocates nothing once the queue has grown, except in exact decisions.
 */
public final class NearestPairs {
    private static final int COMPARE = 0;

    private final OverlapScratch s;
    private final ObjectTree first = new ObjectTree();
    private final ObjectTree second = new ObjectTree();
    private final PairQueue queue = new PairQueue();
    private final double[] boxA = new double[6];
    private final double[] boxB = new double[6];
    private final double[] childBox = new double[6];
    private final double[] pointA = new double[3];
    private final double[] pointB = new double[3];
    private Dimension dimension = Dimension.SPATIAL;
    private boolean flat;
    private boolean certain;
    private boolean uncertain;
    private double measured;
    private double low;
    private double high;
    private long steps;

    public NearestPairs(OverlapScratch scratch) {
        s = scratch;
    }

    /** Begins a query; the bracket is then that of the two boxes and of a point on each object. */
    public void start(Dimension dimension, LeafColumn a, LeafColumn b) {
        this.dimension = dimension;
        flat = dimension == Dimension.PLANAR;
        boolean reversed = ObjectTree.isReversed(a, b);
        first.open(reversed ? b : a, dimension);
        second.open(reversed ? a : b, dimension);
        queue.clear();
        certain = false;
        uncertain = false;
        measured = Double.POSITIVE_INFINITY;
        low = 0;
        high = Double.POSITIVE_INFINITY;
        steps = 0;
        first.box(first.root(), boxA);
        second.box(second.root(), boxB);
        sample(first.root(), second.root());
        queue.push(BoxGap.atLeast(boxA, boxB), first.root(), second.root(), COMPARE);
        bracket();
    }

    /** Releases the objects; the results stay. */
    public void close() {
        first.close();
        second.close();
    }

    /** Whether it is known whether the two touch. */
    public boolean isDecided() {
        return certain || queue.leastKey() > 0;
    }

    /** Whether further steps could not narrow the bracket. */
    public boolean isMeasured() {
        return isDecided() && queue.leastKey() >= measured;
    }

    /** Whether a pair was found that touches. */
    public boolean touches() {
        return certain || uncertain;
    }

    /** Whether it was proven that the pair touches. */
    public boolean isCertain() {
        return certain;
    }

    /** The lower end of the bracket. */
    public double low() {
        return low;
    }

    /** The upper end of the bracket. */
    public double high() {
        return high;
    }

    /** Steps since the start. */
    public long steps() {
        return steps;
    }

    /** Opens the nearest pair, measures it if both are leaves, or tests whether a point lies inside a solid mesh. */
    public void step() {
        steps++;
        s.leaf.work.take();
        queue.take();
        long a = queue.first;
        long b = queue.second;
        if (queue.task != COMPARE) {
            contain(ObjectTree.part(a), ObjectTree.part(b), queue.task);
        } else if (first.isLeaf(a) && second.isLeaf(b)) {
            measure(a, b);
        } else {
            if (ObjectTree.isPart(a) && ObjectTree.isPart(b)) {
                plan(a, b);
            }
            sample(a, b);
            open(a, b);
        }
        bracket();
    }

    private void bracket() {
        if (certain) {
            low = 0;
            high = 0;
        } else {
            low = Math.max(low, Math.min(high, Math.min(measured, queue.leastKey())));
        }
    }

    private void sample(long a, long b) {
        first.point(a, pointA);
        second.point(b, pointB);
        high = Math.min(high, BoxGap.atMost(pointA, pointB, flat));
    }

    private void measure(long a, long b) {
        Leaf leafA = first.leaf(a);
        Leaf leafB = second.leaf(b);
        Gjk gjk = s.gjk.pair;
        double lower = flat ? gjk.planar(leafA, leafB) : gjk.spatial(leafA, leafB);
        if (!gjk.isClosed()) {
            lower = gjk.close();
        }
        high = Math.min(high, BoxGap.up(gjk.upper() + gjk.error()));
        if (gjk.isDeep() && !FilterBound.isDoubting()) {
            certain = true;
        } else if (lower == 0 || FilterBound.isDoubting()) {
            s.uncertain = false;
            if (ConvexOverlap.test(dimension, leafA, leafB, s)) {
                certain |= !s.uncertain;
                uncertain |= s.uncertain;
            }
        }
        measured = Math.min(measured, lower);
    }

    private void open(long a, long b) {
        first.box(a, boxA);
        second.box(b, boxB);
        boolean opensFirst = opensFirst(first, a, boxA, second, b, boxB);
        ObjectTree opened = opensFirst ? first : second;
        long parent = opensFirst ? a : b;
        double[] other = opensFirst ? boxB : boxA;
        for (int k = opened.children(parent) - 1; k >= 0; k--) {
            long child = opened.child(parent, k);
            opened.box(child, childBox);
            double key = BoxGap.atLeast(childBox, other);
            if (key <= high) {
                queue.push(key, opensFirst ? child : a, opensFirst ? b : child, COMPARE);
            }
        }
    }

    /**
     * Whether to open the first place: both sides are descended to parts before any part is opened; then the larger box
     * is opened.
     */
    static boolean opensFirst(ObjectTree p, long a, double[] boxA, ObjectTree q, long b, double[] boxB) {
        if (ObjectTree.isAboveParts(a) != ObjectTree.isAboveParts(b)) {
            return ObjectTree.isAboveParts(a);
        }
        if (p.isLeaf(a) || q.isLeaf(b)) {
            return q.isLeaf(b);
        }
        return BoxGap.size(boxA) >= BoxGap.size(boxB);
    }

    /** Plans the tests of points inside solid meshes. */
    private void plan(long a, long b) {
        plan(first, a, second, b, 1);
        plan(second, b, first, a, -1);
    }

    private void plan(ObjectTree solid, long a, ObjectTree other, long b, int sign) {
        if (flat || solid.kindOf(ObjectTree.part(a)) != LeafKind.SOLID_MESH) {
            return;
        }
        solid.box(a, boxA);
        int part = ObjectTree.part(b);
        if (!other.kindOf(part).isMesh()) {
            other.point(b, pointB);
            plan(a, b, 0, sign);
            return;
        }
        for (int seed : other.column().mesh(part).seeds()) {
            other.vertex(part, seed, pointB, 0);
            plan(a, b, seed, sign);
        }
    }

    private void plan(long solid, long other, int vertex, int sign) {
        for (int axis = 0; axis < 3; axis++) {
            if (pointB[axis] < boxA[axis] || pointB[axis] > boxA[3 + axis]) {
                return;
            }
        }
        queue.push(0, sign > 0 ? solid : other, sign > 0 ? other : solid, sign * (vertex + 1));
    }

    private void contain(int partA, int partB, int task) {
        certain |= task > 0
                ? first.holds(partA, second, partB, task - 1, s.leaf)
                : second.holds(partB, first, partA, -task - 1, s.leaf);
    }
}
