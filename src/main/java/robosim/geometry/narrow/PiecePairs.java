package robosim.geometry.narrow;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

/** The pairs of convex pieces of two leaves that may touch: a mesh's triangles are pieces of their own. */
final class PiecePairs {
    /** What is done with a pair. */
    interface Visitor {
        /**
         * Looks at a pair; their rows are good until it returns.
         *
         * @param t the place, in the order of the leaves, of the first mesh's triangle; -1 where it is no mesh
         * @param u the same of the second
         * @return whether that was enough
         */
        boolean visit(LeafKind kindA, double[] a, int i, int t, LeafKind kindB, double[] b, int j, int u);
    }

    private final Scratch s;
    private final double[] own = new double[6];
    private final double[] other = new double[6];

    PiecePairs(Scratch scratch) {
        s = scratch;
    }

    /** Visits pairs until one is enough; answers whether one was. */
    boolean any(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j, Visitor visitor) {
        LeafKind kindA = a.kind(i);
        if (!kindA.isMesh()) {
            return anyOf(dimension, kindA, a.rows(i), a.at(i), -1, b, j, visitor);
        }
        b.bounds(j, other);
        widen(dimension, other);
        s.outer.startBox(a, i, other);
        for (int t = s.outer.next(0); t >= 0; t = s.outer.next(0)) {
            s.outer.corners(t, s.triangleA, 0);
            if (anyOf(dimension, LeafKind.TRIANGLE, s.triangleA, 0, t, b, j, visitor)) {
                return true;
            }
        }
        return false;
    }

    private boolean anyOf(
            Dimension dimension, LeafKind kind, double[] row, int at, int t, LeafColumn b, int j, Visitor visitor) {
        LeafKind kindB = b.kind(j);
        if (!kindB.isMesh()) {
            return visitor.visit(kind, row, at, t, kindB, b.rows(j), b.at(j), -1);
        }
        LeafBounds.of(kind, row, at, own);
        widen(dimension, own);
        s.inner.startBox(b, j, own);
        for (int u = s.inner.next(0); u >= 0; u = s.inner.next(0)) {
            s.inner.corners(u, s.triangleB, 0);
            if (visitor.visit(kind, row, at, t, LeafKind.TRIANGLE, s.triangleB, 0, u)) {
                return true;
            }
        }
        return false;
    }

    private static void widen(Dimension dimension, double[] box) {
        if (dimension == Dimension.PLANAR) {
            box[1] = Double.NEGATIVE_INFINITY;
            box[4] = Double.POSITIVE_INFINITY;
        }
    }
}
