package robosim.geometry.narrow.mesh;

import java.util.Arrays;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.index.meshes.BoxTree;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.BoxGap;
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

    /** The error of a height above a plane, as a share of its edges and offset. */
    private static final double OFF = 0x1p-48;

    private final LeafScratch s;
    private final ObjectTree mover = new ObjectTree();
    private final ObjectTree other = new ObjectTree();
    private final double[] boxA = new double[6];
    private final double[] boxB = new double[6];
    private final double[] childBox = new double[6];
    private final double[] way = new double[3];

    /** The boxes of the triangles of a node. */
    private final double[][] triangles = new double[BoxTree.LEAF][6];

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
            if (mover.holdsTriangles(p) && other.holdsTriangles(q)) {
                least = judgeAll(p, q, least, judge);
            } else {
                open(p, q, least);
            }
        }
    }

    /** Shows the triangles of two nodes, and returns the least share since. */
    private double judgeAll(long a, long b, double before, Judge judge) {
        double least = before;
        int count = other.children(b);
        for (int k = 0; k < count; k++) {
            other.box(other.child(b, k), triangles[k]);
        }
        for (int i = 0; i < mover.children(a) && least >= 0; i++) {
            long t = mover.child(a, i);
            mover.box(t, childBox);
            for (int k = 0; k < count && least >= 0; k++) {
                double key = meets(childBox, triangles[k]);
                if (key != NEVER && key <= least) {
                    least = judge.judge(ObjectTree.position(t), ObjectTree.position(other.child(b, k)));
                }
            }
        }
        return least;
    }

    private void open(long a, long b, double least) {
        mover.box(a, boxA);
        other.box(b, boxB);
        boolean opensMover =
                other.holdsTriangles(b) || (!mover.holdsTriangles(a) && BoxGap.size(boxA) >= BoxGap.size(boxB));
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

    /**
     * Whether a translated triangle certainly keeps on one side of the plane of one at rest, or the one at rest on one side of
     * the plane that moves: so for nearly all pairs whose boxes meet. Their corners are nine numbers each.
     *
     * <p>An edge, an offset and a displacement are off by u = 2^-53 of themselves, a normal by 5u of the product of its edges,
     * and a height above the plane by less than 10u of that times the offset, sums of magnitudes; 32u are taken.
     */
    public static boolean keepApart(double[] moving, double[] resting, double[] way) {
        return isBeside(resting, moving, way[0], way[1], way[2])
                || isBeside(moving, resting, -way[0], -way[1], -way[2]);
    }

    private static boolean isBeside(double[] plane, double[] t, double dx, double dy, double dz) {
        double ex = plane[3] - plane[0];
        double ey = plane[4] - plane[1];
        double ez = plane[5] - plane[2];
        double fx = plane[6] - plane[0];
        double fy = plane[7] - plane[1];
        double fz = plane[8] - plane[2];
        double nx = ey * fz - ez * fy;
        double ny = ez * fx - ex * fz;
        double nz = ex * fy - ey * fx;
        double rise = nx * dx + ny * dy + nz * dz;
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        double far = 0;
        for (int k = 0; k < 9; k += 3) {
            double x = t[k] - plane[0];
            double y = t[k + 1] - plane[1];
            double z = t[k + 2] - plane[2];
            double height = nx * x + ny * y + nz * z;
            low = Math.min(low, height);
            high = Math.max(high, height);
            far = Math.max(far, Math.abs(x) + Math.abs(y) + Math.abs(z));
        }
        double edges = (Math.abs(ex) + Math.abs(ey) + Math.abs(ez)) * (Math.abs(fx) + Math.abs(fy) + Math.abs(fz));
        double reach = far + Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
        double doubt = FilterBound.bound(OFF * edges * reach) + VectorMath.UNDERFLOW;
        return Math.min(low, low + rise) > doubt || Math.max(high, high + rise) < -doubt;
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
