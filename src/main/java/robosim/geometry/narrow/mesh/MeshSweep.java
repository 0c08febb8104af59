package robosim.geometry.narrow.mesh;

import java.util.Arrays;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafScratch;

/**
 * The pairs of triangles of two meshes that may meet while one is translated: both trees are descended together, the pair of nodes
 * first that may meet first, and no pair that meets later than what was found already is looked at. Boxes are those of {@link
 * ObjectTree}, in world axes. An instance belongs to one owner of queries; nothing is allocated once the stacks have grown.
 */
public final class MeshSweep {
    /** Decides when two triangles meet, given as positions in the order of the leaves. */
    public interface Judge {
        /**
         * The least share of the motion at which any pair judged so far meets.
         *
         * @return below 0 where no more need be judged
         */
        double judge(int t, int u);
    }

    private static final double NEVER = Double.POSITIVE_INFINITY;

    /** More than the rounding of a difference of two bounds, as a share of them; and of a quotient. */
    private static final double ROUNDED = 0x1p-45;

    private final LeafScratch s;
    private final ObjectTree mover = new ObjectTree();
    private final ObjectTree other = new ObjectTree();
    private final double[] boxA = new double[6];
    private final double[] boxB = new double[6];
    private final double[] childBox = new double[6];
    private final double[] way = new double[3];
    private long[] stackA = new long[64];
    private long[] stackB = new long[64];
    private double[] keys = new double[64];
    private int depth;

    MeshSweep(LeafScratch scratch) {
        s = scratch;
    }

    /** Shows a judge the pairs of triangles of leaf i of a, translated, and of leaf j of b, at rest. */
    public void descend(
            Dimension dimension, LeafColumn a, int i, double[] translation, LeafColumn b, int j, Judge judge) {
        mover.openPart(a, i, dimension);
        other.openPart(b, j, dimension);
        System.arraycopy(translation, 0, way, 0, 3);
        if (dimension == Dimension.PLANAR) {
            way[1] = 0;
        }
        depth = 0;
        mover.box(mover.root(), boxA);
        other.box(other.root(), boxB);
        push(0, mover.root(), other.root(), meets(boxA, boxB));
        double least = NEVER;
        while (depth > 0 && least >= 0) {
            s.work.take();
            depth--;
            if (keys[depth] > least) {
                continue;
            }
            long p = stackA[depth];
            long q = stackB[depth];
            if (mover.isLeaf(p) && other.isLeaf(q)) {
                least = judge.judge(ObjectTree.position(p), ObjectTree.position(q));
            } else {
                open(p, q, least);
            }
        }
    }

    private void open(long a, long b, double least) {
        mover.box(a, boxA);
        other.box(b, boxB);
        boolean opensMover = NearestPairs.opensFirst(mover, a, boxA, other, b, boxB);
        ObjectTree opened = opensMover ? mover : other;
        long parent = opensMover ? a : b;
        int base = depth;
        for (int k = opened.children(parent) - 1; k >= 0; k--) {
            long child = opened.child(parent, k);
            opened.box(child, childBox);
            double key = opensMover ? meets(childBox, boxB) : meets(boxA, childBox);
            if (key <= least) {
                push(base, opensMover ? child : a, opensMover ? b : child, key);
            }
        }
    }

    /** When two boxes may meet: never after that, or +Infinity. */
    private double meets(double[] a, double[] b) {
        double enter = 0;
        double leave = 1;
        for (int k = 0; k < 3; k++) {
            double slack = ROUNDED * (Math.abs(a[k]) + Math.abs(a[3 + k]) + Math.abs(b[k]) + Math.abs(b[3 + k]));
            double ahead = b[k] - a[3 + k] - slack;
            double behind = a[k] - b[3 + k] - slack;
            double d = way[k];
            if (ahead > 0) {
                enter = d > 0 ? Math.max(enter, ahead / d) : NEVER;
                leave = Math.min(leave, d > 0 ? -behind / d : 1);
            } else if (behind > 0) {
                enter = d < 0 ? Math.max(enter, behind / -d) : NEVER;
                leave = Math.min(leave, d < 0 ? -ahead / -d : 1);
            } else if (d != 0) {
                leave = Math.min(leave, d > 0 ? -behind / d : -ahead / -d);
            }
        }
        double sure = enter * (1 - ROUNDED);
        return sure > leave * (1 + ROUNDED) ? NEVER : sure;
    }

    /** Pushes a pair onto those above a base, the one that may meet first last. */
    private void push(int base, long a, long b, double key) {
        if (key == NEVER) {
            return;
        }
        if (depth == stackA.length) {
            stackA = Arrays.copyOf(stackA, 2 * depth);
            stackB = Arrays.copyOf(stackB, 2 * depth);
            keys = Arrays.copyOf(keys, 2 * depth);
        }
        int to = depth++;
        while (to > base && keys[to - 1] < key) {
            keys[to] = keys[to - 1];
            stackA[to] = stackA[to - 1];
            stackB[to] = stackB[to - 1];
            to--;
        }
        keys[to] = key;
        stackA[to] = a;
        stackB[to] = b;
    }
}
