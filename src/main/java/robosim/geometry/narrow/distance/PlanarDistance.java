package robosim.geometry.narrow.distance;

import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PairOrder;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.planar.DiscDisc;
import robosim.geometry.narrow.planar.DiscPolygon;
import robosim.geometry.narrow.planar.DiscRectangle;
import robosim.geometry.narrow.planar.PlanarShape;
import robosim.geometry.narrow.planar.PolygonPolygon;

/** The least distance between the projections of two leaves on the XZ plane. */
public final class PlanarDistance {
    private PlanarDistance() {}

    /**
     * The least distance, 0 exactly if {@link PlanarOverlap} says that they touch; the same bits for (a, b) and (b, a).
     *
     * <p>For a turned cylinder the lower end of a bracket, no more than 2^-45 of the sizes and the offset below the truth.
     */
    public static double between(Leaf a, Leaf b, DistanceScratch s) {
        if (PairOrder.isReversed(a, b)) {
            return ordered(b, a, s);
        }
        return ordered(a, b, s);
    }

    private static double ordered(Leaf a, Leaf b, DistanceScratch s) {
        return switch (a.kind.fromAbove()) {
            case DISC -> disc(a, b, s);
            case POLYGON -> polygon(a, b, s);
            case OVAL -> oval(a, b, s);
            case TRIANGLES, CELLS -> throw a.kind.refused();
        };
    }

    private static double disc(Leaf a, Leaf b, DistanceScratch s) {
        return switch (b.kind.fromAbove()) {
            case DISC -> DiscDisc.distance(a.get(0), a.get(2), a.get(3), b.get(0), b.get(2), b.get(3));
            case POLYGON -> discPolygon(a, b, s);
            case OVAL -> oval(a, b, s);
            case TRIANGLES, CELLS -> throw b.kind.refused();
        };
    }

    private static double polygon(Leaf a, Leaf b, DistanceScratch s) {
        return switch (b.kind.fromAbove()) {
            case DISC -> discPolygon(b, a, s);
            case POLYGON -> PolygonPolygon.distance(a, b, s.planar);
            case OVAL -> oval(a, b, s);
            case TRIANGLES, CELLS -> throw b.kind.refused();
        };
    }

    /** Two projections of which one at least is an oval. */
    private static double oval(Leaf a, Leaf b, DistanceScratch s) {
        double ox = PlanarShape.originX(a.kind, a.row, a.at);
        double oz = PlanarShape.originZ(a.kind, a.row, a.at);
        s.planar.planarA.set(a.kind, a.row, a.at, ox, oz);
        s.planar.planarB.set(b.kind, b.row, b.at, ox, oz);
        s.planar.planarBracket.find(s.planar.planarA, s.planar.planarB, false);
        return s.planar.planarBracket.distance();
    }

    private static double discPolygon(Leaf disc, Leaf b, DistanceScratch s) {
        return b.kind == LeafKind.UPRIGHT_BOX && DiscRectangle.isSquare(b.row, b.at)
                ? DiscRectangle.distance(disc.get(0), disc.get(2), disc.get(3), b.row, b.at, s.planar)
                : DiscPolygon.distance(disc.get(0), disc.get(2), disc.get(3), b, s.planar);
    }
}
