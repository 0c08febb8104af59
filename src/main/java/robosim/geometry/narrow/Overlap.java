package robosim.geometry.narrow;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.GridWalk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafBoxes;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.UprightRows;
import robosim.geometry.narrow.mesh.PointInMesh;
import robosim.geometry.narrow.overlap.ConvexOverlap;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.planar.DiscDisc;
import robosim.geometry.narrow.planar.DiscRectangle;
import robosim.geometry.narrow.planar.PlainCells;

/** Whether two placed leaves have a point in common, meshes and grids included: the only switch over leaf kinds for overlaps. */
public final class Overlap {
    /** More than the share of their sizes at which two cylinders that are apart may count as touching. */
    private static final double UNCERTAIN = 0x1p-30;

    private Overlap() {}

    /** Whether leaf i of a touches or overlaps leaf j of b. */
    public static boolean test(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j, Scratch s) {
        LeafKind kindA = a.kind(i);
        LeafKind kindB = b.kind(j);
        if (dimension == Dimension.PLANAR && LeafColumn.isUpright(j) && kindA.isDisc()) {
            return disc(a, i, b, j, s);
        }
        if (kindB.isGrid()) {
            return grid(dimension, b, j, kindA, a, i, s);
        }
        if (kindA.isGrid()) {
            return grid(dimension, a, i, kindB, b, j, s);
        }
        if (kindA.isMesh()) {
            return kindB.isMesh()
                    ? meshes(dimension, a, i, b, j, s)
                    : mesh(dimension, a, i, s.leaf.placedB.set(b, j), s);
        }
        if (kindB.isMesh()) {
            return mesh(dimension, b, j, s.leaf.placedA.set(a, i), s);
        }
        return ConvexOverlap.test(dimension, s.leaf.placedA.set(a, i), s.leaf.placedB.set(b, j), s.overlap);
    }

    /** Whether any leaf of a column touches or overlaps one of several leaves of another. */
    public static boolean any(Dimension dimension, LeafColumn a, LeafColumn b, int first, int count, Scratch s) {
        boolean isOne = a.size() == 1;
        LeafBoxes boxes = s.leaf.parts();
        if (!isOne) {
            boxes.setAll(a, 0, a.size(), dimension == Dimension.PLANAR);
        }
        for (int j = first; j < first + count; j++) {
            int near = 1;
            if (!isOne) {
                s.work.take();
                b.bounds(j, boxes.box);
                near = boxes.meeting(uncertain(boxes.box));
            }
            for (int k = 0; k < near; k++) {
                s.work.take();
                if (test(dimension, a, isOne ? 0 : boxes.found(k), b, j, s)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** More than the gap of two leaves, one of them with these bounds, may be where it is not certain that they do not touch. */
    static double uncertain(double[] box) {
        double size = Double.MIN_NORMAL;
        for (double bound : box) {
            size += Math.abs(bound);
        }
        return UNCERTAIN * size;
    }

    /**
     * Tests a disc, seen from above, against a half-row leaf; expands it to a full row only if doubles cannot decide.
     */
    private static boolean disc(LeafColumn a, int i, LeafColumn b, int j, Scratch s) {
        double[] row = a.rows(i);
        int at = a.at(i);
        int sure = sure(row[at], row[at + 2], row[at + Leaf.SIZE], b.uprightRows(), LeafColumn.uprightAt(j));
        return sure == 0 ? PlanarOverlap.test(s.leaf.placedA.set(a, i), s.leaf.placedB.set(b, j), s.overlap) : sure < 0;
    }

    /**
     * Whether a disc touches an object with a half-row leaf, seen from above: below 0 if it does, above 0 if it does
     * not, 0 if doubles cannot decide or the object has other leaves.
     */
    public static int sure(double x, double z, double r, LeafColumn b, int id) {
        return b.isUprightObject(id)
                ? sure(x, z, r, b.uprightRows(), LeafColumn.uprightAt(id | LeafColumn.UPRIGHT))
                : 0;
    }

    private static int sure(double x, double z, double r, double[] row, int at) {
        double sin = row[at + UprightRows.SIN];
        double half = row[at + Leaf.SIZE];
        if (UprightRows.isRound(row, at)) {
            return DiscDisc.touch(x, z, r, row[at], row[at + 2], half) ? -1 : 1;
        }
        return DiscRectangle.sure(
                x, z, r, row[at], row[at + 2], half, row[at + Leaf.SIZE + 2], row[at + UprightRows.COS], sin);
    }

    private static boolean grid(
            Dimension dimension, LeafColumn grid, int leaf, LeafKind kind, LeafColumn other, int k, Scratch s) {
        if (!kind.hasPieces()) {
            int plain = s.planar.plainCells.compare(dimension, s.leaf.placedA.set(other, k), 0, 0, 0, grid, leaf);
            if (plain != PlainCells.UNSURE) {
                return plain == PlainCells.MET;
            }
        }
        GridWalk walk = s.leaf.cells(kind);
        other.bounds(k, s.leaf.box);
        widen(dimension, s.leaf.box);
        walk.startBox(grid, leaf, s.leaf.box);
        for (int cell = walk.nextInBox(); cell >= 0; cell = walk.nextInBox()) {
            if (test(dimension, other, k, walk.piece(cell, kind), 0, s)) {
                return true;
            }
        }
        return false;
    }

    private static boolean meshes(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j, Scratch s) {
        if (dimension == Dimension.PLANAR) {
            return s.mesh.pairs().touch(dimension, a, i, b, j);
        }
        return s.mesh.meshPairs().touch(a, i, b, j)
                || (PointInMesh.counts(dimension, a, i) && PointInMesh.holdsMesh(a, i, b, j, s.leaf))
                || (PointInMesh.counts(dimension, b, j) && PointInMesh.holdsMesh(b, j, a, i, s.leaf));
    }

    private static boolean mesh(Dimension dimension, LeafColumn mesh, int leaf, Leaf piece, Scratch s) {
        bounds(dimension, piece, s.leaf.box);
        s.leaf.outer.startBox(mesh, leaf, s.leaf.box);
        for (int t = s.leaf.outer.next(0); t >= 0; t = s.leaf.outer.next(0)) {
            s.leaf.outer.corners(t, s.leaf.triangleA, 0);
            if (ConvexOverlap.test(dimension, s.leaf.faceA, piece, s.overlap)) {
                return true;
            }
        }
        return PointInMesh.counts(dimension, mesh, leaf) && PointInMesh.holdsLeaf(mesh, leaf, piece, s.leaf);
    }

    /** The bounds of a leaf, over all heights in PLANAR. */
    static void bounds(Dimension dimension, Leaf leaf, double[] out) {
        LeafBounds.of(leaf.kind, leaf.row, leaf.at, out);
        widen(dimension, out);
    }

    private static void widen(Dimension dimension, double[] box) {
        if (dimension == Dimension.PLANAR) {
            box[1] = Double.NEGATIVE_INFINITY;
            box[4] = Double.POSITIVE_INFINITY;
        }
    }

    /**
     * Whether two leaves, neither of them a mesh or a grid, certainly overlap by more than rounding; false if that is not
     * known.
     */
    public static boolean isDeep(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j, Scratch s) {
        return !a.kind(i).hasPieces()
                && !b.kind(j).hasPieces()
                && ConvexOverlap.isDeep(dimension, s.leaf.placedA.set(a, i), s.leaf.placedB.set(b, j), s.overlap);
    }
}
