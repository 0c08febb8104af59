package robosim.geometry.narrow;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.distance.ConvexContact;
import robosim.geometry.narrow.distance.PlanarDistance;
import robosim.geometry.narrow.distance.SpatialDistance;
import robosim.geometry.narrow.gjk.Support;
import robosim.geometry.narrow.leaf.GridWalk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.UnderflowScaling;
import robosim.geometry.narrow.mesh.PointInMesh;

/**
 * The distance of two placed leaves, meshes and grids included, and their nearest points: the only switch over leaf kinds for
 * distances. An instance belongs to one owner of queries.
 */
public final class Distance {
    /**
     * More than the error of any distance of two convex leaves, relative to the distance and their sizes; it is always
     * downward. Bounds are more accurate, so they may rule out only what is farther by this margin; otherwise an answer
     * would depend on what was found before.
     */
    private static final double SHORT = 0x1p-40;

    /** By how much the distance of two enclosures is shortened, as a share of it and of their sizes. */
    private static final double SHORTER = 0x1p-42;

    private final Scratch s;
    private final Leaf leafA = new Leaf();
    private final Leaf leafB = new Leaf();
    private final Support support = new Support();

    /** Cells of grids in contact. */
    private final LeafColumn piece = new LeafColumn(1);

    private final LeafColumn otherPiece = new LeafColumn(1);

    /**
     * The pieces that gave the last answer: triangles as positions in the order of the leaves, and cells of grids; -1 if a
     * leaf is not made of pieces or contains the other one.
     */
    private int triangleA;

    private int triangleB;

    public Distance(Scratch scratch) {
        s = scratch;
    }

    /**
     * The distance, 0 in contact; the kernels state its error. Results up to the limit do not depend on the limit.
     *
     * @param limit a larger distance may be returned as +Infinity or as any number above the limit
     */
    public double between(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j, double limit) {
        s.work.take();
        triangleA = -1;
        triangleB = -1;
        LeafKind kindA = a.kind(i);
        LeafKind kindB = b.kind(j);
        if (kindB.isGrid()) {
            return grid(dimension, b, j, kindA, a, i, limit);
        }
        if (kindA.isGrid()) {
            double distance = grid(dimension, a, i, kindB, b, j, limit);
            int cell = triangleB;
            triangleB = triangleA;
            triangleA = cell;
            return distance;
        }
        if (kindA.isMesh() && kindB.isMesh()) {
            return meshes(dimension, a, i, b, j, limit);
        }
        if (kindA.isMesh()) {
            double distance = mesh(dimension, a, i, leafB.set(b, j), limit);
            triangleA = triangleB;
            triangleB = -1;
            return distance;
        }
        if (kindB.isMesh()) {
            return mesh(dimension, b, j, leafA.set(a, i), limit);
        }
        return convex(dimension, leafA.set(a, i), leafB.set(b, j));
    }

    /** Afterwards the other leaf's piece is in the first place, the cell in the second one. */
    private double grid(
            Dimension dimension, LeafColumn grid, int leaf, LeafKind kind, LeafColumn other, int k, double limit) {
        GridWalk walk = s.leaf.cells(kind);
        other.bounds(k, s.leaf.box);
        walk.startNearest(grid, leaf, s.leaf.box);
        double sizes = walk.sides() + sides(s.leaf.box);
        double best = Double.POSITIVE_INFINITY;
        int nearest = -1;
        int piece = -1;
        for (int cell = walk.nextAround(reach(limit, sizes));
                cell >= 0;
                cell = walk.nextAround(reach(Math.min(limit, best), sizes))) {
            double distance = between(dimension, other, k, walk.piece(cell, kind), 0, Math.min(limit, best));
            if (distance < best || (distance == best && cell < nearest)) {
                best = distance;
                nearest = cell;
                piece = triangleA;
            }
        }
        triangleA = piece;
        triangleB = nearest;
        return best;
    }

    private double convex(Dimension dimension, Leaf a, Leaf b) {
        if (!s.leaf.scaling.take(dimension, a, b)) {
            return asStored(dimension, a, b);
        }
        UnderflowScaling m = s.leaf.scaling;
        return m.down(asStored(dimension, m.first, m.second));
    }

    private double asStored(Dimension dimension, Leaf a, Leaf b) {
        return dimension == Dimension.PLANAR
                ? PlanarDistance.between(a, b, s.distance)
                : SpatialDistance.between(a, b, s.distance);
    }

    private double mesh(Dimension dimension, LeafColumn mesh, int leaf, Leaf piece, double limit) {
        if (PointInMesh.counts(dimension, mesh, leaf) && PointInMesh.holdsLeaf(mesh, leaf, piece, s.leaf)) {
            return 0;
        }
        LeafBounds.of(piece.kind, piece.row, piece.at, s.leaf.box);
        overMesh(dimension, mesh, leaf, s.leaf.box);
        s.leaf.outer.startNearest(mesh, leaf, s.leaf.box);
        double sizes = s.leaf.outer.size() + sides(s.leaf.box);
        double best = Double.POSITIVE_INFINITY;
        for (int t = s.leaf.outer.next(reach(limit, sizes));
                t >= 0;
                t = s.leaf.outer.next(reach(Math.min(limit, best), sizes))) {
            s.leaf.outer.corners(t, s.leaf.triangleA, 0);
            double distance = convex(dimension, s.leaf.faceA, piece);
            if (distance < best || (distance == best && isLower(t))) {
                best = distance;
                triangleB = t;
            }
        }
        return best;
    }

    /**
     * How far a search by bounds must reach to include every leaf whose computed distance may be at most a given one.
     */
    public static double reach(double distance, double sizes) {
        return distance + SHORT * (distance + sizes);
    }

    /**
     * The distance of two enclosures that is returned: never above that of what they enclose, whatever the errors of both, which
     * are below 2<sup>-43</sup> of the distance and of the sizes.
     */
    public static double ofEnclosures(double distance, double sizes) {
        return distance < Double.POSITIVE_INFINITY ? Math.max(0, distance - SHORTER * (distance + sizes)) : distance;
    }

    /** An upper bound of the size of the contents of a box. */
    public static double sides(double[] box) {
        return (box[3] - box[0]) + (box[4] - box[1]) + (box[5] - box[2]);
    }

    private boolean isLower(int t) {
        return triangleB >= 0 && s.leaf.outer.triangle(t) < s.leaf.outer.triangle(triangleB);
    }

    private boolean areLower(int t, int u) {
        if (triangleA < 0) {
            return false;
        }
        int order = Integer.compare(s.leaf.outer.triangle(t), s.leaf.outer.triangle(triangleA));
        return order < 0 || (order == 0 && s.leaf.inner.triangle(u) < s.leaf.inner.triangle(triangleB));
    }

    private double meshes(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j, double limit) {
        if ((PointInMesh.counts(dimension, a, i) && PointInMesh.holdsMesh(a, i, b, j, s.leaf))
                || (PointInMesh.counts(dimension, b, j) && PointInMesh.holdsMesh(b, j, a, i, s.leaf))) {
            return 0;
        }
        b.bounds(j, s.leaf.box);
        overMesh(dimension, a, i, s.leaf.box);
        s.leaf.outer.startNearest(a, i, s.leaf.box);
        double sizes = s.leaf.outer.size() + sides(s.leaf.box);
        double best = Double.POSITIVE_INFINITY;
        for (int t = s.leaf.outer.next(reach(limit, sizes));
                t >= 0;
                t = s.leaf.outer.next(reach(Math.min(limit, best), sizes))) {
            s.leaf.outer.corners(t, s.leaf.triangleA, 0);
            LeafBounds.of(LeafKind.TRIANGLE, s.leaf.triangleA, 0, s.leaf.triangleBox);
            overMesh(dimension, b, j, s.leaf.triangleBox);
            s.leaf.inner.startNearest(b, j, s.leaf.triangleBox);
            double left = reach(Math.min(limit, best), sizes);
            for (int u = s.leaf.inner.next(left); u >= 0; u = s.leaf.inner.next(reach(Math.min(limit, best), sizes))) {
                s.leaf.inner.corners(u, s.leaf.triangleB, 0);
                double distance = convex(dimension, s.leaf.faceA, s.leaf.faceB);
                if (distance < best || (distance == best && areLower(t, u))) {
                    best = distance;
                    triangleA = t;
                    triangleB = u;
                }
            }
        }
        return best;
    }

    /** In PLANAR, extends the box over the heights of the mesh, so that heights do not matter. */
    private void overMesh(Dimension dimension, LeafColumn mesh, int leaf, double[] box) {
        if (dimension == Dimension.PLANAR) {
            mesh.bounds(leaf, s.leaf.meshBox);
            box[1] = s.leaf.meshBox[1];
            box[4] = s.leaf.meshBox[4];
        }
    }

    /**
     * Finds where two leaves touch or are nearest: a contact point and the unit normal from b towards a.
     *
     * @param out six numbers: point, normal
     */
    public void contact(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j, double[] out) {
        s.work.take();
        leafA.set(a, i);
        leafB.set(b, j);
        if (leafA.kind.hasPieces() || leafB.kind.hasPieces()) {
            between(dimension, a, i, b, j, Double.POSITIVE_INFINITY);
            piece(a, i, triangleA, piece, s.leaf.faceA, leafA);
            piece(b, j, triangleB, otherPiece, s.leaf.faceB, leafB);
            if (leafA.kind.isMesh() || leafB.kind.isMesh()) {
                inside(leafA, out);
                return;
            }
        }
        ConvexContact.between(dimension, leafA, leafB, out, s.distance);
    }

    /** Sets a leaf to one of another leaf's pieces, or to that leaf if it has none or no piece was found. */
    private void piece(LeafColumn column, int leaf, int number, LeafColumn cell, Leaf face, Leaf out) {
        if (column.kind(leaf).isGrid()) {
            cell.setPiece(column, leaf, number);
            out.set(cell, 0);
        } else if (number >= 0) {
            s.leaf.outer.open(column, leaf);
            s.leaf.outer.corners(number, face.row, 0);
            out.set(face.kind, face.row, 0);
        } else {
            out.set(column, leaf);
        }
    }

    /** The largest of n.x over the points x of a convex leaf, to rounding; heights do not count in PLANAR. */
    public double extent(Dimension dimension, LeafColumn column, int leaf, double nx, double ny, double nz) {
        s.work.take();
        LeafKind kind = column.kind(leaf);
        double[] row = column.rows(leaf);
        int at = column.at(leaf);
        double ox = Support.originX(kind, row, at);
        double oz = Support.originZ(kind, row, at);
        if (dimension == Dimension.PLANAR) {
            support.planar(kind, row, at, ox, oz, 1);
            support.find(nx, 0, nz);
            return (ox + support.x) * nx + (oz + support.z) * nz + support.margin;
        }
        double oy = Support.originY(kind, row, at);
        support.spatial(kind, row, at, ox, oy, oz, 1);
        support.find(nx, ny, nz);
        return (ox + support.x) * nx + (oy + support.y) * ny + (oz + support.z) * nz + support.margin;
    }

    /** The contact if one leaf is wholly inside the other and no surfaces are near: a point of the first one. */
    private static void inside(Leaf leaf, double[] out) {
        System.arraycopy(leaf.row, leaf.at, out, 0, 3);
        out[3] = 0;
        out[4] = 1;
        out[5] = 0;
    }
}
