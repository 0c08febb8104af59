package robosim.geometry.narrow;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.distance.ConvexContact;
import robosim.geometry.narrow.distance.PlanarDistance;
import robosim.geometry.narrow.distance.SpatialDistance;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.UnderflowScaling;
import robosim.geometry.narrow.mesh.Inside;

/**
 * The least distance of two placed leaves, meshes included, and where they are nearest: the one switch for distances.
 * An instance belongs to one owner of queries.
 */
public final class Distance {
    /**
     * No distance of two convex leaves is answered so far below the truth, as a share of itself and of their sizes. Bounds
     * are finer: what they leave out must be farther by as much, or an answer would depend on what was found before.
     */
    private static final double SHORT = 0x1p-40;

    private final Scratch s;

    /** The places, in the order of the leaves, of the triangles that gave the last answer; -1 where a leaf is no mesh or is met in its inside. */
    private int triangleA;

    private int triangleB;

    public Distance(Scratch scratch) {
        s = scratch;
    }

    /**
     * Least distance, 0 in contact; how far off it may be is said with the kernels. Up to the limit it does not depend on it.
     *
     * @param limit what is farther may be answered as +Infinity, or as more than that
     */
    public double between(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j, double limit) {
        triangleA = -1;
        triangleB = -1;
        LeafKind kindA = a.kind(i);
        LeafKind kindB = b.kind(j);
        if (kindA.isMesh() && kindB.isMesh()) {
            return meshes(dimension, a, i, b, j, limit);
        }
        if (kindA.isMesh()) {
            double distance = mesh(dimension, a, i, kindB, b.rows(j), b.at(j), limit);
            triangleA = triangleB;
            triangleB = -1;
            return distance;
        }
        if (kindB.isMesh()) {
            return mesh(dimension, b, j, kindA, a.rows(i), a.at(i), limit);
        }
        return convex(dimension, kindA, a.rows(i), a.at(i), kindB, b.rows(j), b.at(j));
    }

    private double convex(Dimension dimension, LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        double distance = asStored(dimension, kindA, a, i, kindB, b, j);
        // Only a small distance may have been spoiled by what underflowed.
        if (distance > UnderflowScaling.SMALL || !s.scaling.take(kindA, a, i, kindB, b, j)) {
            return distance;
        }
        UnderflowScaling m = s.scaling;
        return m.down(asStored(dimension, kindA, m.a, 0, kindB, m.b, 0));
    }

    private double asStored(Dimension dimension, LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        return dimension == Dimension.PLANAR
                ? PlanarDistance.between(kindA, a, i, kindB, b, j, s)
                : SpatialDistance.between(kindA, a, i, kindB, b, j, s);
    }

    private double mesh(
            Dimension dimension, LeafColumn mesh, int leaf, LeafKind kind, double[] row, int at, double limit) {
        if (Inside.counts(dimension, mesh, leaf) && Inside.holdsLeaf(mesh, leaf, kind, row, at, s)) {
            return 0;
        }
        LeafBounds.of(kind, row, at, s.box);
        overMesh(dimension, mesh, leaf, s.box);
        s.outer.startNearest(mesh, leaf, s.box);
        double sizes = s.outer.size() + sides(s.box);
        double best = Double.POSITIVE_INFINITY;
        for (int t = s.outer.next(reach(limit, sizes)); t >= 0; t = s.outer.next(reach(Math.min(limit, best), sizes))) {
            s.outer.corners(t, s.triangleA, 0);
            double distance = convex(dimension, LeafKind.TRIANGLE, s.triangleA, 0, kind, row, at);
            if (distance < best || (distance == best && isLower(t))) {
                best = distance;
                triangleB = t;
            }
        }
        return best;
    }

    /** How far bounds have to reach for all that may be answered as no farther than a distance. */
    public static double reach(double distance, double sizes) {
        return distance + SHORT * (distance + sizes);
    }

    /** At least the size of what is in a box. */
    public static double sides(double[] box) {
        return (box[3] - box[0]) + (box[4] - box[1]) + (box[5] - box[2]);
    }

    private boolean isLower(int t) {
        return triangleB >= 0 && s.outer.triangle(t) < s.outer.triangle(triangleB);
    }

    private boolean areLower(int t, int u) {
        if (triangleA < 0) {
            return false;
        }
        int order = Integer.compare(s.outer.triangle(t), s.outer.triangle(triangleA));
        return order < 0 || (order == 0 && s.inner.triangle(u) < s.inner.triangle(triangleB));
    }

    private double meshes(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j, double limit) {
        if ((Inside.counts(dimension, a, i) && Inside.holdsMesh(a, i, b, j, s))
                || (Inside.counts(dimension, b, j) && Inside.holdsMesh(b, j, a, i, s))) {
            return 0;
        }
        b.bounds(j, s.box);
        overMesh(dimension, a, i, s.box);
        s.outer.startNearest(a, i, s.box);
        double sizes = s.outer.size() + sides(s.box);
        double best = Double.POSITIVE_INFINITY;
        for (int t = s.outer.next(reach(limit, sizes)); t >= 0; t = s.outer.next(reach(Math.min(limit, best), sizes))) {
            s.outer.corners(t, s.triangleA, 0);
            LeafBounds.of(LeafKind.TRIANGLE, s.triangleA, 0, s.triangleBox);
            overMesh(dimension, b, j, s.triangleBox);
            s.inner.startNearest(b, j, s.triangleBox);
            double left = reach(Math.min(limit, best), sizes);
            for (int u = s.inner.next(left); u >= 0; u = s.inner.next(reach(Math.min(limit, best), sizes))) {
                s.inner.corners(u, s.triangleB, 0);
                double distance =
                        convex(dimension, LeafKind.TRIANGLE, s.triangleA, 0, LeafKind.TRIANGLE, s.triangleB, 0);
                if (distance < best || (distance == best && areLower(t, u))) {
                    best = distance;
                    triangleA = t;
                    triangleB = u;
                }
            }
        }
        return best;
    }

    /** In PLANAR, gives the box the heights of the mesh, so that they do not count. */
    private void overMesh(Dimension dimension, LeafColumn mesh, int leaf, double[] box) {
        if (dimension == Dimension.PLANAR) {
            mesh.bounds(leaf, s.meshBox);
            box[1] = s.meshBox[1];
            box[4] = s.meshBox[4];
        }
    }

    /**
     * Where two leaves touch or are nearest: a point of contact and the unit normal from b towards a.
     *
     * @param out six numbers: point, normal
     */
    public void contact(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j, double[] out) {
        LeafKind kindA = a.kind(i);
        LeafKind kindB = b.kind(j);
        double[] rowA = a.rows(i);
        double[] rowB = b.rows(j);
        int atA = a.at(i);
        int atB = b.at(j);
        if (kindA.isMesh() || kindB.isMesh()) {
            between(dimension, a, i, b, j, Double.POSITIVE_INFINITY);
            if (triangleA >= 0) {
                s.outer.open(a, i);
                s.outer.corners(triangleA, s.triangleA, 0);
                kindA = LeafKind.TRIANGLE;
                rowA = s.triangleA;
                atA = 0;
            }
            if (triangleB >= 0) {
                s.outer.open(b, j);
                s.outer.corners(triangleB, s.triangleB, 0);
                kindB = LeafKind.TRIANGLE;
                rowB = s.triangleB;
                atB = 0;
            }
            if (kindA.isMesh() || kindB.isMesh()) {
                inside(rowA, atA, out);
                return;
            }
        }
        ConvexContact.between(dimension, kindA, rowA, atA, kindB, rowB, atB, out, s);
    }

    /** One leaf wholly inside the other: no surface is near; the contact is where the first one stands. */
    private static void inside(double[] row, int at, double[] out) {
        System.arraycopy(row, at, out, 0, 3);
        out[3] = 0;
        out[4] = 1;
        out[5] = 0;
    }
}
