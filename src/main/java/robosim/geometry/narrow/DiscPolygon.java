package robosim.geometry.narrow;

import robosim.geometry.exact.Filter;
import robosim.geometry.exact.Stages;

/** A disc and a convex polygon: what a box, a triangle or an octagon throws. */
final class DiscPolygon {
    // The distance to a side is off by the corners' error in both coordinates and, seen along a side of any length, by
    // no more than 16 roundings of the largest coordinate; the polygon's error is nine roundings of that.
    private static final double ROUNDING = 8;
    private static final double FILTER = Filter.bound(ROUNDING);
    private static final double U = 0x1p-53;

    private static final Stages.Counter EXACT = Stages.counter("DiscPolygon");

    private DiscPolygon() {}

    /** Whether they touch or overlap; exact, but for octagons, which touch where it is in doubt. */
    static boolean touch(double px, double pz, double r, int kind, double[] b, int j, Scratch s) {
        PlanarShape q = s.planarB;
        q.set(kind, b, j, px, pz);
        if (q.isTiny()) {
            return doubtfulTouch(px, pz, r, kind, b, j);
        }
        double error = (kind == Leaf.PRISM ? ROUNDING : FILTER) * (q.error + U * r);
        double outline = Math.sqrt(PointPolygon.squareToOutline(0, 0, q));
        if (outline < r - error) {
            return true;
        }
        int side = PointPolygon.side(0, 0, q, error);
        if (side > 0) {
            return true;
        }
        if (side < 0 && outline > r + error) {
            return false;
        }
        return doubtfulTouch(px, pz, r, kind, b, j);
    }

    private static boolean doubtfulTouch(double px, double pz, double r, int kind, double[] b, int j) {
        if (kind == Leaf.PRISM) {
            return true;
        }
        EXACT.count();
        return ExactPlanar.of(kind, b, j).touchesDisc(px, pz, r);
    }

    /** The least distance, 0 in contact. */
    static double distance(double px, double pz, double r, int kind, double[] b, int j, Scratch s) {
        if (touch(px, pz, r, kind, b, j, s)) {
            return 0;
        }
        return Math.max(0, Math.sqrt(PointPolygon.squareToOutline(0, 0, s.planarB)) - r);
    }
}
