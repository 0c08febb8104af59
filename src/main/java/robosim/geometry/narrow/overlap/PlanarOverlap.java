package robosim.geometry.narrow.overlap;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PairOrder;
import robosim.geometry.narrow.leaf.UnderflowScaling;
import robosim.geometry.narrow.planar.DiscDisc;
import robosim.geometry.narrow.planar.DiscPolygon;
import robosim.geometry.narrow.planar.DiscRectangle;
import robosim.geometry.narrow.planar.PlanarShape;
import robosim.geometry.narrow.planar.PolygonPolygon;
import robosim.geometry.narrow.planar.RectangleRectangle;
import robosim.geometry.narrow.planar.ZonogonZonogon;

/** Whether the projections of two leaves on the XZ plane touch or overlap. */
public final class PlanarOverlap {
    private PlanarOverlap() {}

    /**
     * Whether the projections of two leaves touch or overlap; the same for (a, b) and (b, a).
     *
     * <p>Exact for the stored numbers of boxes, triangles, spheres and upright cylinders, and for two octagons. Other
     * pairs with an octagon (an enclosure) and turned cylinders are certified: apart only if a line separates the two
     * by more than the rounding error, some 2^-46 of the sizes and the offset. For a turned cylinder {@link
     * OverlapScratch#uncertain} is set if the answer is touching and the overlap is not so deep that rounding cannot
     * matter; octagons only must not miss anything.
     */
    public static boolean test(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        if (PairOrder.isReversed(kindA, a, i, kindB, b, j)) {
            return ordered(kindB, b, j, kindA, a, i, s);
        }
        return ordered(kindA, a, i, kindB, b, j, s);
    }

    private static boolean ordered(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        return switch (kindA.fromAbove()) {
            case DISC -> disc(kindA, a, i, kindB, b, j, s);
            case POLYGON -> polygon(kindA, a, i, kindB, b, j, s);
            case OVAL -> oval(kindA, a, i, kindB, b, j, s);
            case TRIANGLES, CELLS -> throw kindA.refused();
        };
    }

    private static boolean disc(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        return switch (kindB.fromAbove()) {
            case DISC -> DiscDisc.touch(a[i], a[i + 2], a[i + 3], b[j], b[j + 2], b[j + 3]);
            case POLYGON -> discPolygon(a, i, kindB, b, j, s);
            case OVAL -> oval(kindA, a, i, kindB, b, j, s);
            case TRIANGLES, CELLS -> throw kindB.refused();
        };
    }

    private static boolean polygon(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        return switch (kindB.fromAbove()) {
            case DISC -> discPolygon(b, j, kindA, a, i, s);
            case POLYGON -> polygons(kindA, a, i, kindB, b, j, s);
            case OVAL -> oval(kindA, a, i, kindB, b, j, s);
            case TRIANGLES, CELLS -> throw kindB.refused();
        };
    }

    private static boolean polygons(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        if (!kindA.isBox() || !kindB.isBox()) {
            return PolygonPolygon.touch(kindA, a, i, kindB, b, j, s.planar);
        }
        return kindB == LeafKind.UPRIGHT_BOX
                ? RectangleRectangle.touch(a, i, b, j, s.planar.fine)
                : ZonogonZonogon.touch(kindA, a, i, kindB, b, j, s.planar.fine);
    }

    private static boolean discPolygon(double[] disc, int i, LeafKind kind, double[] b, int j, OverlapScratch s) {
        return kind == LeafKind.UPRIGHT_BOX
                ? DiscRectangle.touch(disc[i], disc[i + 2], disc[i + 3], b, j, s.planar.fine)
                : DiscPolygon.touch(disc[i], disc[i + 2], disc[i + 3], kind, b, j, s.planar);
    }

    private static boolean oval(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        UnderflowScaling m = s.ovals;
        return m.take(Dimension.PLANAR, kindA, a, i, kindB, b, j)
                ? storedOval(kindA, m.a, 0, kindB, m.b, 0, s)
                : storedOval(kindA, a, i, kindB, b, j, s);
    }

    private static boolean storedOval(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        double ox = PlanarShape.originX(kindA, a, i);
        double oz = PlanarShape.originZ(kindA, a, i);
        s.planar.planarA.set(kindA, a, i, ox, oz);
        s.planar.planarB.set(kindB, b, j, ox, oz);
        s.planar.planarBracket.find(s.planar.planarA, s.planar.planarB, true);
        if (s.planar.planarBracket.isApart()) {
            return false;
        }
        if (isDeep(kindA, a, i, kindB, b, j, s)) {
            return true;
        }
        // If bounds prove them apart, they are: otherwise an answer would depend on which tree was used.
        if (LeafBounds.areApart(Dimension.PLANAR, kindA, a, i, kindB, b, j, s.leaf.boundsA, s.leaf.boundsB)) {
            return false;
        }
        s.uncertain = true;
        return true;
    }

    /** Whether the two certainly have a point in common, despite rounding. */
    private static boolean isDeep(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        s.gjk.pair.planar(kindA, a, i, kindB, b, j);
        if (s.gjk.pair.isDeep()) {
            return true;
        }
        s.gjk.hull.growPlanar(Double.MIN_VALUE);
        return s.gjk.hull.lower() > 0;
    }
}
