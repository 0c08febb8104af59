package robosim.geometry.narrow;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.GridWalk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

/** Visits the pairs of convex pieces of two leaves that may touch; each triangle of a mesh and each cell of a grid is a piece. */
final class PiecePairs {
    /** Receives the pairs. */
    interface Visitor {
        /**
         * Visits a pair; the rows are valid until this method returns.
         *
         * @param t triangle of the first mesh, as a position in the order of the leaves; -1 if it is not a mesh
         * @param u the same for the second, or the cell of a grid
         * @return true to stop
         */
        boolean visit(Leaf a, int t, Leaf b, int u);
    }

    private final Scratch s;
    private double margin;
    private final Leaf first = new Leaf();
    private final Leaf second = new Leaf();
    private final double[] own = new double[6];
    private final double[] other = new double[6];

    PiecePairs(Scratch scratch) {
        s = scratch;
    }

    /** Also visits pieces that are apart by up to a margin along an axis. */
    PiecePairs within(double of) {
        margin = of;
        return this;
    }

    /** Visits pairs until the visitor stops; returns whether it did. */
    boolean any(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j, Visitor visitor) {
        LeafKind kindA = a.kind(i);
        if (!kindA.isMesh()) {
            return anyOf(dimension, first.set(a, i), -1, b, j, visitor);
        }
        b.bounds(j, other);
        widen(dimension, other);
        s.leaf.outer.startBox(a, i, other);
        for (int t = s.leaf.outer.next(0); t >= 0; t = s.leaf.outer.next(0)) {
            s.leaf.outer.corners(t, s.leaf.triangleA, 0);
            if (anyOf(dimension, s.leaf.faceA, t, b, j, visitor)) {
                return true;
            }
        }
        return false;
    }

    private boolean anyOf(Dimension dimension, Leaf leaf, int t, LeafColumn b, int j, Visitor visitor) {
        LeafKind kindB = b.kind(j);
        if (!kindB.hasPieces()) {
            return visitor.visit(leaf, t, second.set(b, j), -1);
        }
        LeafBounds.of(leaf.kind, leaf.row, leaf.at, own);
        widen(dimension, own);
        if (kindB.isGrid()) {
            return anyCell(leaf, t, b, j, visitor);
        }
        s.leaf.inner.startBox(b, j, own);
        for (int u = s.leaf.inner.next(0); u >= 0; u = s.leaf.inner.next(0)) {
            s.leaf.inner.corners(u, s.leaf.triangleB, 0);
            if (visitor.visit(leaf, t, s.leaf.faceB, u)) {
                return true;
            }
        }
        return false;
    }

    private boolean anyCell(Leaf piece, int t, LeafColumn grid, int leaf, Visitor visitor) {
        GridWalk walk = s.leaf.cells(piece.kind);
        walk.startBox(grid, leaf, own);
        for (int cell = walk.nextInBox(); cell >= 0; cell = walk.nextInBox()) {
            LeafColumn box = walk.piece(cell, piece.kind);
            if (visitor.visit(piece, t, second.set(box, 0), cell)) {
                return true;
            }
        }
        return false;
    }

    private void widen(Dimension dimension, double[] box) {
        if (margin > 0) {
            for (int k = 0; k < 3; k++) {
                box[k] -= margin;
                box[3 + k] += margin;
            }
        }
        if (dimension == Dimension.PLANAR) {
            box[1] = Double.NEGATIVE_INFINITY;
            box[4] = Double.POSITIVE_INFINITY;
        }
    }
}
