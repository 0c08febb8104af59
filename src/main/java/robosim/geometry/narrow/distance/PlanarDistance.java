package robosim.geometry.narrow.distance;

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
    public static double between(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, DistanceScratch s) {
        if (PairOrder.isReversed(kindA, a, i, kindB, b, j)) {
            return ordered(kindB, b, j, kindA, a, i, s);
        }
        return ordered(kindA, a, i, kindB, b, j, s);
    }

    private static double ordered(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, DistanceScratch s) {
        return switch (kindA.fromAbove()) {
            case DISC -> disc(kindA, a, i, kindB, b, j, s);
            case POLYGON -> polygon(kindA, a, i, kindB, b, j, s);
            case OVAL -> oval(kindA, a, i, kindB, b, j, s);
            case TRIANGLES, CELLS -> throw kindA.refused();
        };
    }

    private static double disc(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, DistanceScratch s) {
        return switch (kindB.fromAbove()) {
            case DISC -> DiscDisc.distance(a[i], a[i + 2], a[i + 3], b[j], b[j + 2], b[j + 3]);
            case POLYGON -> discPolygon(a, i, kindB, b, j, s);
            case OVAL -> oval(kindA, a, i, kindB, b, j, s);
            case TRIANGLES, CELLS -> throw kindB.refused();
        };
    }

    private static double polygon(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, DistanceScratch s) {
        return switch (kindB.fromAbove()) {
            case DISC -> discPolygon(b, j, kindA, a, i, s);
            case POLYGON -> PolygonPolygon.distance(kindA, a, i, kindB, b, j, s.planar);
            case OVAL -> oval(kindA, a, i, kindB, b, j, s);
            case TRIANGLES, CELLS -> throw kindB.refused();
        };
    }

    /** Two projections of which one at least is an oval. */
    private static double oval(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, DistanceScratch s) {
        double ox = PlanarShape.originX(kindA, a, i);
        double oz = PlanarShape.originZ(kindA, a, i);
        s.planar.planarA.set(kindA, a, i, ox, oz);
        s.planar.planarB.set(kindB, b, j, ox, oz);
        s.planar.planarBracket.find(s.planar.planarA, s.planar.planarB, false);
        return s.planar.planarBracket.distance();
    }

    private static double discPolygon(double[] disc, int i, LeafKind kind, double[] b, int j, DistanceScratch s) {
        return kind == LeafKind.UPRIGHT_BOX && DiscRectangle.isSquare(b, j)
                ? DiscRectangle.distance(disc[i], disc[i + 2], disc[i + 3], b, j, s.planar)
                : DiscPolygon.distance(disc[i], disc[i + 2], disc[i + 3], kind, b, j, s.planar);
    }
}
