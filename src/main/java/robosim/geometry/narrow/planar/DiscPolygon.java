package robosim.geometry.narrow.planar;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.leaf.Leaf;

/** A disc and a convex polygon: the projection of a box, a triangle or an octagon. */
public final class DiscPolygon {
    // Each corner is off by the polygon's error in both coordinates, so the distance to a side by 1.42 times that. Seen
    // from the disc's centre, this distance is a cross product (off by 3u of the side's length times an end's distance,
    // which is at most 1.42 times the size) over the length (4u of the quotient in all, which is no larger). An end is
    // taken for the foot only where the two are within 3u of the end's distance. Subtracting the radius adds 1u.
    private static final double ROUNDING = 1.01;
    private static final double CORNERS = 1.42;
    private static final double SIZE = 10 * 0x1p-53;
    private static final double FILTER = FilterBound.bound(ROUNDING);
    private static final double U = 0x1p-53;

    private static final StageCounters.Counter EXACT = StageCounters.counter("DiscPolygon");

    private DiscPolygon() {}

    /** Whether they touch or overlap. Exact, except that octagons count as touching in doubtful cases. */
    public static boolean touch(double px, double pz, double r, Leaf b, PlanarScratch s) {
        PlanarShape q = s.planarB;
        q.set(b.kind, b.row, b.at, px, pz);
        if (q.isTiny()) {
            return doubtfulTouch(px, pz, r, b);
        }
        double error = (b.kind.isEnclosure() ? ROUNDING : FILTER) * (CORNERS * q.error + SIZE * q.size + U * r);
        double outline = Math.sqrt(PointPolygon.squareToOutline(0, 0, q));
        if (outline < r - error) {
            return true;
        }
        int side = PointPolygon.side(q, error);
        if (side > 0) {
            return true;
        }
        if (side < 0 && outline > r + error) {
            return false;
        }
        return doubtfulTouch(px, pz, r, b);
    }

    private static boolean doubtfulTouch(double px, double pz, double r, Leaf b) {
        if (b.kind.isEnclosure()) {
            return true;
        }
        EXACT.count();
        return ExactPolygon.of(b.kind, b.row, b.at).touchesDisc(px, pz, r);
    }

    /** The distance; 0 in contact. */
    public static double distance(double px, double pz, double r, Leaf b, PlanarScratch s) {
        if (touch(px, pz, r, b, s)) {
            return 0;
        }
        PlanarShape q = s.planarB;
        if (q.isTiny()) { // otherwise the squares would underflow
            double power = q.enlargement();
            q.enlarge(power);
            return Math.max(0, Math.sqrt(PointPolygon.squareToOutline(0, 0, q)) / power - r);
        }
        return Math.max(0, Math.sqrt(PointPolygon.squareToOutline(0, 0, q)) - r);
    }
}
