package robosim.geometry.narrow.overlap;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.Leaf;
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
    public static boolean test(Leaf a, Leaf b, OverlapScratch s) {
        if (PairOrder.isReversed(a, b)) {
            return ordered(b, a, s);
        }
        return ordered(a, b, s);
    }

    private static boolean ordered(Leaf a, Leaf b, OverlapScratch s) {
        return switch (a.kind.fromAbove()) {
            case DISC -> disc(a, b, s);
            case POLYGON -> polygon(a, b, s);
            case OVAL -> oval(a, b, s);
            case TRIANGLES, CELLS -> throw a.kind.refused();
        };
    }

    private static boolean disc(Leaf a, Leaf b, OverlapScratch s) {
        return switch (b.kind.fromAbove()) {
            case DISC -> DiscDisc.touch(a.get(0), a.get(2), a.get(3), b.get(0), b.get(2), b.get(3));
            case POLYGON -> discPolygon(a, b, s);
            case OVAL -> oval(a, b, s);
            case TRIANGLES, CELLS -> throw b.kind.refused();
        };
    }

    private static boolean polygon(Leaf a, Leaf b, OverlapScratch s) {
        return switch (b.kind.fromAbove()) {
            case DISC -> discPolygon(b, a, s);
            case POLYGON -> polygons(a, b, s);
            case OVAL -> oval(a, b, s);
            case TRIANGLES, CELLS -> throw b.kind.refused();
        };
    }

    private static boolean polygons(Leaf a, Leaf b, OverlapScratch s) {
        if (!a.kind.isBox() || !b.kind.isBox()) {
            return PolygonPolygon.touch(a, b, s.planar);
        }
        return b.kind == LeafKind.UPRIGHT_BOX
                ? RectangleRectangle.touch(a.row, a.at, b.row, b.at, s.planar.fine)
                : ZonogonZonogon.touch(a, b, s.planar.fine);
    }

    private static boolean discPolygon(Leaf disc, Leaf b, OverlapScratch s) {
        return b.kind == LeafKind.UPRIGHT_BOX
                ? DiscRectangle.touch(disc.get(0), disc.get(2), disc.get(3), b.row, b.at, s.planar.fine)
                : DiscPolygon.touch(disc.get(0), disc.get(2), disc.get(3), b, s.planar);
    }

    private static boolean oval(Leaf a, Leaf b, OverlapScratch s) {
        UnderflowScaling m = s.ovals;
        return m.take(Dimension.PLANAR, a, b) ? storedOval(m.first, m.second, s) : storedOval(a, b, s);
    }

    private static boolean storedOval(Leaf a, Leaf b, OverlapScratch s) {
        double ox = PlanarShape.originX(a.kind, a.row, a.at);
        double oz = PlanarShape.originZ(a.kind, a.row, a.at);
        s.planar.planarA.set(a.kind, a.row, a.at, ox, oz);
        s.planar.planarB.set(b.kind, b.row, b.at, ox, oz);
        s.planar.planarBracket.find(s.planar.planarA, s.planar.planarB, true);
        if (s.planar.planarBracket.isApart()) {
            return false;
        }
        if (isDeep(a, b, s)) {
            return true;
        }
        // If bounds prove them apart, they are: otherwise an answer would depend on which tree was used.
        if (LeafBounds.areApart(Dimension.PLANAR, a, b, s.leaf.boundsA, s.leaf.boundsB)) {
            return false;
        }
        s.uncertain = true;
        return true;
    }

    /** Whether the two certainly have a point in common, despite rounding. */
    private static boolean isDeep(Leaf a, Leaf b, OverlapScratch s) {
        s.gjk.pair.planar(a, b);
        if (s.gjk.pair.isDeep()) {
            return true;
        }
        s.gjk.hull.growPlanar(Double.MIN_VALUE);
        return s.gjk.hull.lower() > 0;
    }
}
