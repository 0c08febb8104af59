package robosim.geometry.narrow.planar;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** Two convex polygons in the plane: the projections of boxes, triangles and octagons. */
public final class PolygonPolygon {
    // With n a side's normal, a corner's coordinates are off by the shape's error, so n . corner by that times |nx| +
    // |nz|; n, the products and their sum add 3u of the shape's size. The true polygons can be separated only along one
    // of their normals: they overlap if they do so along each of these, none of which is off by more.
    private static final double ROUNDING = 1.01;
    private static final double PRODUCT = 3 * 0x1p-53;
    private static final double FILTER = FilterBound.bound(ROUNDING);
    private static final double UNDERFLOW = 0x1p-960;

    private static final StageCounters.Counter EXACT = StageCounters.counter("PolygonPolygon");

    private PolygonPolygon() {}

    /**
     * Whether they touch or overlap. Exact, except that an octagon and another kind count as touching in doubtful
     * cases. Two octagons have sides in the same four directions, one of which separates them if they are apart.
     */
    public static boolean touch(Leaf a, Leaf b, PlanarScratch s) {
        return (a.kind == LeafKind.PRISM && b.kind == LeafKind.PRISM) ? octagonsTouch(a, b) : polygonsTouch(a, b, s);
    }

    private static boolean octagonsTouch(Leaf a, Leaf b) {
        for (int k = 0; k < 8; k += 2) {
            if ((a.get(k) > b.get(k + 1)) || (b.get(k) > a.get(k + 1))) {
                return false;
            }
        }
        return true;
    }

    private static boolean polygonsTouch(Leaf a, Leaf b, PlanarScratch s) {
        PlanarShape p = s.planarA;
        PlanarShape q = s.planarB;
        double ox = PlanarShape.originX(a.kind, a.row, a.at);
        double oz = PlanarShape.originZ(a.kind, a.row, a.at);
        p.set(a.kind, a.row, a.at, ox, oz);
        q.set(b.kind, b.row, b.at, ox, oz);
        // The normals of all sides give the penetration depth of two polygons, unless both are degenerate and parallel.
        // Those, and shapes small compared with the error, never overlap clearly and so take the exact path.
        boolean isEnclosure = a.kind.isEnclosure() || b.kind.isEnclosure();
        double error = (isEnclosure ? ROUNDING : FILTER) * (p.error + q.error + PRODUCT * (p.size + q.size));
        int verdict = Math.max(apart(p, q, error), apart(q, p, error));
        if (verdict == 1) {
            verdict = Math.max(verdict, Math.max(apartAlong(p, q, 1, 0, error), apartAlong(p, q, 0, 1, error)));
        }
        return switch (verdict) {
            case 0 -> true;
            case 1 -> isEnclosure || exactTouch(a, b);
            default -> false;
        };
    }

    private static boolean exactTouch(Leaf a, Leaf b) {
        EXACT.count();
        return ExactPolygon.of(a.kind, a.row, a.at).touches(ExactPolygon.of(b.kind, b.row, b.at));
    }

    // 2 apart along the normal of a side of p, 1 in doubt, 0 overlapping along all normals
    private static int apart(PlanarShape p, PlanarShape q, double error) {
        if (p.count == 1) {
            return q.count == 1 ? 1 : 0;
        }
        if (p.count == 2) {
            return apartAlong(p, q, p.sideZ[1], -p.sideX[1], error);
        }
        int verdict = 0;
        for (int k = 0; k < p.count; k++) {
            // Outward, as the corners are ordered from x to z.
            double nx = p.sideZ[k];
            double nz = -p.sideX[k];
            double slack = error * (Math.abs(nx) + Math.abs(nz)) + UNDERFLOW;
            // Not the level of the side itself: rounding can turn a very short side in any direction.
            double gap = -q.support(-nx, -nz) - p.support(nx, nz);
            if (gap > slack) {
                return 2;
            }
            if (!(gap < -slack)) {
                verdict = 1;
            }
        }
        return verdict;
    }

    private static int apartAlong(PlanarShape p, PlanarShape q, double nx, double nz, double error) {
        double slack = error * (Math.abs(nx) + Math.abs(nz)) + UNDERFLOW;
        double gap = Math.max(-q.support(-nx, -nz) - p.support(nx, nz), -p.support(-nx, -nz) - q.support(nx, nz));
        return gap > slack ? 2 : gap < -slack ? 0 : 1;
    }

    /** The distance; 0 in contact. */
    public static double distance(Leaf a, Leaf b, PlanarScratch s) {
        if (touch(a, b, s)) {
            return 0;
        }
        PlanarShape p = s.planarA;
        PlanarShape q = s.planarB;
        if (a.kind == LeafKind.PRISM && b.kind == LeafKind.PRISM) {
            p.set(
                    a.kind,
                    a.row,
                    a.at,
                    PlanarShape.originX(a.kind, a.row, a.at),
                    PlanarShape.originZ(a.kind, a.row, a.at));
            q.set(
                    b.kind,
                    b.row,
                    b.at,
                    PlanarShape.originX(a.kind, a.row, a.at),
                    PlanarShape.originZ(a.kind, a.row, a.at));
        }
        if (p.isTiny() && q.isTiny()) { // otherwise the squares would underflow
            double power = Math.min(p.enlargement(), q.enlargement());
            p.enlarge(power);
            q.enlarge(power);
            return Math.sqrt(Math.min(cornersToSides(p, q), cornersToSides(q, p))) / power;
        }
        return Math.sqrt(Math.min(cornersToSides(p, q), cornersToSides(q, p)));
    }

    private static double cornersToSides(PlanarShape p, PlanarShape q) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < p.count; k++) {
            least = Math.min(least, PointPolygon.squareToOutline(p.x[k], p.z[k], q));
        }
        return least;
    }
}
