package robosim.geometry.narrow.mesh;

import java.util.Arrays;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.distance.ConvexSeparation;
import robosim.geometry.narrow.distance.DistanceScratch;
import robosim.geometry.narrow.leaf.BoxGap;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Finds step by step the signed distance of two objects: pairs of boxes are opened, the nearest or deepest first, down to
 * the leaves, and after each step a bracket contains the signed distance. More steps never widen it.
 *
 * <p>Two objects that overlap have to be moved apart by at least the depth of their deepest pair of pieces, and by at
 * most the least translation found that separates all of them: out of each other's boxes, or along the direction of that
 * pair. A point of an object inside a solid mesh counts with its distance from the surface, and a ball around the centre of a convex piece
 * with its radius too.
 *
 * <p>(a, b) and (b, a) give the same bits, exchanged. An instance belongs to one owner of queries.
 */
public final class SignedPairs {
    private static final int COMPARE = 0;

    /** Rotations are orthonormal to 1e-9, so a shape has a ball inside it at least so large. */
    private static final double INNER = 1 - 0x1p-28;

    private static final double DOWN = 1 - 0x1p-50;

    private final DistanceScratch s;
    private final ConvexSeparation pair;
    private final ObjectTree first = new ObjectTree();
    private final ObjectTree second = new ObjectTree();
    private final PairQueue queue = new PairQueue();
    private final double[] boxA = new double[6];
    private final double[] boxB = new double[6];
    private final double[] childBox = new double[6];
    private final double[] point = new double[3];
    private final double[] onA = new double[3];
    private final double[] onB = new double[3];
    private final double[] direction = new double[3];
    private final Leaf spot = new Leaf(LeafKind.SPHERE);
    private final Leaf leafA = new Leaf();
    private final Leaf leafB = new Leaf();
    private long[] stack = new long[64];
    private Dimension dimension = Dimension.SPATIAL;
    private boolean isReversed;
    private boolean isSimple;
    private double exit;
    private double measured;
    private double best;
    private double low;
    private double high;
    private long steps;

    public SignedPairs(DistanceScratch scratch) {
        s = scratch;
        pair = new ConvexSeparation(scratch);
    }

    /** Begins a query; the bracket is then that of the two boxes and of a point on each object. */
    public void start(Dimension dimension, LeafColumn a, LeafColumn b) {
        this.dimension = dimension;
        isReversed = ObjectTree.isReversed(a, b);
        first.open(isReversed ? b : a, dimension);
        second.open(isReversed ? a : b, dimension);
        isSimple = first.isLeaf(first.root()) && second.isLeaf(second.root());
        queue.clear();
        measured = Double.POSITIVE_INFINITY;
        best = Double.POSITIVE_INFINITY;
        high = Double.POSITIVE_INFINITY;
        steps = 0;
        first.box(first.root(), boxA);
        second.box(second.root(), boxB);
        double key = key(boxA, boxB);
        exit = Math.max(0, -key);
        low = key;
        sample(first.root(), second.root());
        queue.push(key, first.root(), second.root(), COMPARE);
    }

    /** Answers a query for two convex leaves in one step, without boxes; false, and nothing is done, for other objects. */
    public boolean isAnswered(Dimension dimension, LeafColumn a, LeafColumn b) {
        if (a.size() != 1 || b.size() != 1 || a.kind(0).hasPieces() || b.kind(0).hasPieces()) {
            return false;
        }
        s.leaf.work.take();
        pair.measure(dimension, leafA.set(a, 0), leafB.set(b, 0));
        isReversed = false;
        measured = Double.POSITIVE_INFINITY;
        best = Double.POSITIVE_INFINITY;
        high = Double.POSITIVE_INFINITY;
        take(pair.low, pair.high);
        low = Math.min(pair.low, high) + 0.0;
        steps = 1;
        return true;
    }

    /** Whether further steps could not narrow the bracket. */
    public boolean isMeasured() {
        return queue.leastKey() >= Math.min(measured, best);
    }

    /** Steps since the start. */
    public long steps() {
        return steps;
    }

    /** The ends of the bracket; after {@link #finish}. */
    public double low() {
        return low;
    }

    public double high() {
        return high;
    }

    /** Writes the points on a and on b and the unit direction from b towards a: nine numbers. */
    public void witness(double[] out) {
        System.arraycopy(isReversed ? onB : onA, 0, out, 0, 3);
        System.arraycopy(isReversed ? onA : onB, 0, out, 3, 3);
        for (int axis = 0; axis < 3; axis++) {
            out[6 + axis] = (isReversed ? -direction[axis] : direction[axis]) + 0.0;
        }
    }

    /** Ends the query: bounds what separates objects of several pieces, and releases them. */
    public void finish() {
        double most = exit;
        if (low < 0 && best < Double.POSITIVE_INFINITY && !isSimple) {
            double along = reach(second, 1) + reach(first, -1);
            most = Math.min(most, Math.max(0, along));
        }
        if (low < 0 && !isSimple) {
            low = -Math.max(most, -high);
        }
        low = Math.min(low, high) + 0.0;
        first.close();
        second.close();
    }

    /** Opens the nearest or deepest pair, measures it if both are leaves, or tests a point inside a solid mesh. */
    public void step() {
        steps++;
        s.leaf.work.take();
        queue.take();
        long a = queue.first;
        long b = queue.second;
        if (queue.task != COMPARE) {
            contain(a, b, queue.task);
        } else if (first.isLeaf(a) && second.isLeaf(b)) {
            pair.measure(dimension, first.leaf(a), second.leaf(b));
            take(pair.low, pair.high);
        } else {
            if (ObjectTree.isPart(a) && ObjectTree.isPart(b)) {
                plan(first, a, second, b, 1);
                plan(second, b, first, a, -1);
            }
            sample(a, b);
            open(a, b);
        }
        low = Math.max(low, Math.min(high, Math.min(measured, queue.leastKey())));
    }

    /** Takes the bracket of a pair of pieces; if it is the nearest or deepest so far, its points and direction too. */
    private void take(double lower, double upper) {
        measured = Math.min(measured, lower);
        if (upper < best) {
            best = upper;
            System.arraycopy(pair.onA, 0, onA, 0, 3);
            System.arraycopy(pair.onB, 0, onB, 0, 3);
            System.arraycopy(pair.direction, 0, direction, 0, 3);
        }
        high = Math.min(high, upper);
    }

    /** Not above the signed distance of anything in two boxes: their gap, or minus the way out of each other. */
    private double key(double[] a, double[] b) {
        double gap = BoxGap.atLeast(a, b);
        if (gap > 0) {
            return gap;
        }
        double out = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis += dimension == Dimension.PLANAR ? 2 : 1) {
            out = Math.min(out, Math.min(a[3 + axis] - b[axis], b[3 + axis] - a[axis]));
        }
        return -BoxGap.up(Math.max(0, out));
    }

    /** A point of each object, for as long as no pair has been measured. */
    private void sample(long a, long b) {
        if (best < Double.POSITIVE_INFINITY) {
            return;
        }
        double before = high;
        first.point(a, pair.onA);
        second.point(b, pair.onB);
        high = Math.min(high, BoxGap.atMost(pair.onA, pair.onB, dimension == Dimension.PLANAR));
        if (high < before) {
            System.arraycopy(pair.onA, 0, onA, 0, 3);
            System.arraycopy(pair.onB, 0, onB, 0, 3);
            between(onB, onA, direction);
        }
    }

    /** The unit direction from one point to another; along X if they are the same. */
    private void between(double[] from, double[] to, double[] out) {
        double x = to[0] - from[0];
        double y = dimension == Dimension.PLANAR ? 0 : to[1] - from[1];
        double z = to[2] - from[2];
        double most = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (most == 0) {
            x = 1;
            most = 1;
        }
        double length = Math.sqrt((x / most) * (x / most) + (y / most) * (y / most) + (z / most) * (z / most));
        out[0] = x / most / length;
        out[1] = y / most / length;
        out[2] = z / most / length;
    }

    private void open(long a, long b) {
        first.box(a, boxA);
        second.box(b, boxB);
        boolean opensFirst = NearestPairs.opensFirst(first, a, boxA, second, b, boxB);
        ObjectTree opened = opensFirst ? first : second;
        long parent = opensFirst ? a : b;
        double[] other = opensFirst ? boxB : boxA;
        for (int k = opened.children(parent) - 1; k >= 0; k--) {
            long child = opened.child(parent, k);
            opened.box(child, childBox);
            double key = key(childBox, other);
            if (key <= high) {
                queue.push(key, opensFirst ? child : a, opensFirst ? b : child, COMPARE);
            }
        }
    }

    /** Plans the tests of points inside solid meshes. */
    private void plan(ObjectTree solid, long a, ObjectTree other, long b, int sign) {
        if (dimension == Dimension.PLANAR || solid.kindOf(ObjectTree.part(a)) != LeafKind.SOLID_MESH) {
            return;
        }
        solid.box(a, boxA);
        other.box(b, boxB);
        double key = key(boxA, boxB);
        int part = ObjectTree.part(b);
        int[] seeds = other.kindOf(part).isMesh() ? other.column().mesh(part).seeds() : new int[] {0};
        for (int seed : key > 0 ? new int[0] : seeds) {
            queue.push(key, sign > 0 ? a : b, sign > 0 ? b : a, sign * (seed + 1));
        }
    }

    private void contain(long a, long b, int task) {
        int partA = ObjectTree.part(a);
        int partB = ObjectTree.part(b);
        if (task > 0 && first.holds(partA, second, partB, task - 1, s.leaf)) {
            within(first, a, second, partB, task - 1, pair.onA, pair.onB, -1);
        } else if (task < 0 && second.holds(partB, first, partA, -task - 1, s.leaf)) {
            within(second, b, first, partA, -task - 1, pair.onB, pair.onA, 1);
        }
    }

    /**
     * A point of a part that a solid mesh contains: as deep as it is far from the surface, and the ball around it that is
     * part of a convex piece as much deeper as its radius.
     *
     * @param sign of the direction from the point to the surface: 1 if the part belongs to the first object
     */
    private void within(
            ObjectTree solid,
            long place,
            ObjectTree other,
            int part,
            int vertex,
            double[] onSolid,
            double[] on,
            int sign) {
        double radius = 0;
        if (other.kindOf(part).isMesh()) {
            other.vertex(part, vertex, spot.row, 0);
        } else {
            System.arraycopy(other.column().rows(), part * Leaf.STRIDE, spot.row, 0, 3);
            radius = innerRadius(other.kindOf(part), other.column().rows(), part * Leaf.STRIDE);
        }
        spot.row[Leaf.SIZE] = 0;
        double deep = surface(solid, place, sign < 0);
        System.arraycopy(sign < 0 ? pair.onA : pair.onB, 0, point, 0, 3);
        System.arraycopy(point, 0, onSolid, 0, 3);
        between(spot.row, point, pair.direction);
        for (int axis = 0; axis < 3; axis++) {
            on[axis] = spot.row[axis] - radius * pair.direction[axis];
            pair.direction[axis] *= sign;
        }
        double upper = -(deep + radius) * DOWN;
        take(Double.NEGATIVE_INFINITY, upper);
    }

    private static double innerRadius(LeafKind kind, double[] row, int at) {
        return switch (kind) {
            case SPHERE -> row[at + 3];
            case UPRIGHT_CAPSULE, CAPSULE -> row[at + 3];
            case UPRIGHT_CYLINDER, CYLINDER -> INNER * Math.min(row[at + 3], row[at + 4]);
            case UPRIGHT_BOX, BOX -> INNER * Math.min(row[at + 3], Math.min(row[at + 4], row[at + 5]));
            case PRISM, TRIANGLE, MESH, SOLID_MESH, GRID -> 0;
        };
    }

    /** A lower bound of the distance from the spot to the triangles below a place; leaves the nearest points in the pair. */
    private double surface(ObjectTree solid, long place, boolean isFirst) {
        double nearest = Double.POSITIVE_INFINITY;
        double least = Double.POSITIVE_INFINITY;
        int depth = 0;
        System.arraycopy(spot.row, 0, boxB, 0, 3);
        System.arraycopy(spot.row, 0, boxB, 3, 3);
        stack[depth++] = place;
        while (depth > 0) {
            long at = stack[--depth];
            solid.box(at, boxA);
            if (BoxGap.atLeast(boxA, boxB) > nearest) {
                continue;
            }
            if (!solid.isLeaf(at)) {
                depth = push(solid, at, depth);
                continue;
            }
            if (isFirst) {
                pair.measure(Dimension.SPATIAL, solid.leaf(at), spot);
            } else {
                pair.measure(Dimension.SPATIAL, spot, solid.leaf(at));
            }
            least = Math.min(least, Math.max(0, pair.low));
            if (pair.high < nearest) {
                nearest = pair.high;
                System.arraycopy(isFirst ? pair.onA : pair.onB, 0, point, 0, 3);
            }
        }
        System.arraycopy(point, 0, isFirst ? pair.onA : pair.onB, 0, 3);
        return least;
    }

    private int push(ObjectTree tree, long place, int depth) {
        int next = depth;
        for (int k = tree.children(place) - 1; k >= 0; k--) {
            if (next == stack.length) {
                stack = Arrays.copyOf(stack, 2 * next);
            }
            stack[next++] = tree.child(place, k);
        }
        return next;
    }

    /** The greatest reach of an object along the direction, or against it, rounded up. */
    private double reach(ObjectTree tree, int sign) {
        double most = Double.NEGATIVE_INFINITY;
        int depth = 0;
        stack[depth++] = tree.root();
        while (depth > 0) {
            long at = stack[--depth];
            tree.box(at, boxA);
            double bound = 0;
            double size = 0;
            for (int axis = 0; axis < 3; axis += dimension == Dimension.PLANAR ? 2 : 1) {
                double along = sign * direction[axis];
                bound += along * (along > 0 ? boxA[3 + axis] : boxA[axis]);
                size += Math.max(Math.abs(boxA[axis]), Math.abs(boxA[3 + axis]));
            }
            if (bound + 0x1p-48 * size <= most) {
                continue;
            }
            if (tree.isLeaf(at)) {
                double exact = pair.reach(dimension, tree.leaf(at), direction, sign);
                most = Math.max(most, Math.min(exact, bound) + 0x1p-48 * size);
            } else {
                depth = push(tree, at, depth);
            }
        }
        return most;
    }
}
