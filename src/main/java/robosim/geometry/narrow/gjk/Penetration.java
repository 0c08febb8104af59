package robosim.geometry.narrow.gjk;

import robosim.geometry.narrow.leaf.FeatureDirections;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.PairOrder;

/**
 * The penetration depth of two leaves, and the directions of the shortest translations that separate them.
 *
 * <p>Between boxes, triangles and prisms the directions are those of separating axes (the sides of the difference set),
 * all of them where several tie; for a sphere or disc whose centre is outside the other it is the direction to the
 * nearest point. If a cylinder's rim is involved, the directions of flat sides and straight edges, of the widest slab
 * that {@link Gjk} saw and of the centres are refined by a search ({@link DepthSearch}), and a polytope expanded inside the
 * difference set ({@link ExpandingPolytope}) proves that there is nothing shallower, or leads the search there.
 *
 * <p>On the safe side: a turn that starts in contact may go on as long as no depth on the arc is above the one at the
 * start, so a depth must not be too large. The result is proven to be at most the least depth plus 2^-34 of the sizes
 * and the offset. It is also at least the least depth, unless the proof runs out of room, which takes hundreds of
 * directions that tie to 2^-34, as between coaxial cylinders that are parallel to 10^-3 but not to 10^-11. Then it is
 * smaller by the part not proven, and a turn may be refused that just keeps its depth.
 *
 * <p>Accurate to within rounding, some 2^-48 of sizes and offset; no overlap is decided by it. (a, b) and (b, a) give
 * the same bits. A query allocates nothing.
 */
public final class Penetration {
    /** How much more than the proven depth may be returned, as a fraction of the sizes and the offset. */
    private static final double PROVEN = 0x1p-34;

    /** Maximum number of places of the hull from which tying directions are searched. */
    private static final int MOST_TIES = 8;

    /** Directions this close (1 minus their cosine) lead to the same minimum. */
    private static final double SAME_VALLEY = 0x1p-12;

    private final Gjk gjk = new Gjk();
    private final Gjk plane = new Gjk();
    private final Support first = new Support();
    private final Support second = new Support();
    private final ExpandingPolytope hull = new ExpandingPolytope(first, second);
    private final FeatureDirections facetsA = new FeatureDirections();
    private final FeatureDirections facetsB = new FeatureDirections();

    private final Directions directions = new Directions();
    private final DepthSearch search = new DepthSearch(first, second, directions);
    private double margins;
    private boolean flat;
    private double proven;

    /** The depth in space; if the two are apart, minus their distance. */
    public double spatial(Leaf a, Leaf b) {
        flat = false;
        return ordered(a, b);
    }

    /** The depth of the projections on XZ; if the two are apart, minus their distance. All directions have y = 0. */
    public double planar(Leaf a, Leaf b) {
        flat = true;
        return ordered(a, b);
    }

    /** The distance query with which the last one began; its a and b may be exchanged. */
    public Gjk bracket() {
        return gjk;
    }

    /** A proven lower bound of the depth; at most the depth returned. */
    public double proven() {
        return proven;
    }

    /** How many directions the search of the last query tried. */
    int tries() {
        return search.tries;
    }

    /** The number of directions that tie; at least 1. */
    public int count() {
        return directions.count();
    }

    /** A unit direction in which a has to move to get out. */
    public double nx(int k) {
        return directions.x(k);
    }

    public double ny(int k) {
        return directions.y(k);
    }

    public double nz(int k) {
        return directions.z(k);
    }

    private double ordered(Leaf a, Leaf b) {
        if (!PairOrder.isReversed(a, b)) {
            return solve(a, b);
        }
        double depth = solve(b, a);
        directions.reverse();
        return depth;
    }

    private double solve(Leaf a, Leaf b) {
        if (flat) {
            gjk.planar(a, b);
        } else {
            gjk.spatial(a, b);
        }
        directions.clear();
        if (gjk.coreReach() > gjk.error()) {
            take(gjk.nx(), gjk.ny(), gjk.nz(), -gjk.reach());
            proven = -gjk.reach() - (gjk.coreUpper() - gjk.coreReach()) - gjk.error();
            return Math.min(-gjk.reach(), proven + gjk.error() * (PROVEN / Gjk.ROUNDOFF));
        }
        load(a, b);
        if (!flat && a.kind.isVerticalPrism() && b.kind.isVerticalPrism()) {
            level(a, b);
        } else {
            candidates();
            if (!first.isPolytope() || !second.isPolytope()) {
                directions.beginSearch();
                refine();
                prove(flat ? 0 : ParallelDepth.atLeast(a, b));
                return kept(proven + PROVEN * (first.extent + second.extent));
            }
        }
        proven = directions.least() - gjk.error();
        return kept(Double.POSITIVE_INFINITY);
    }

    private double kept(double most) {
        double depth = directions.least();
        directions.keepTies(depth + 2 * gjk.error());
        return Math.min(depth, most);
    }

    /**
     * Expands the hull to the least depth known; if it shows that there may be a shallower one, searches for that
     * first.
     */
    private void prove(double known) {
        double slack = PROVEN * (first.extent + second.extent);
        proven = known - gjk.error();
        if (proven >= directions.least() - slack) {
            return;
        }
        for (int round = 0; round < MOST_TIES; round++) {
            double core = directions.least() - margins;
            if (flat) {
                hull.growPlanar(core - slack);
            } else {
                hull.grow(core - slack);
            }
            if (!(hull.upper() < core - slack)) {
                break;
            }
            searchFromHull(hull.x(), hull.y(), hull.z());
        }
        proven = Math.max(proven, Math.max(0, hull.lower()) + margins - gjk.error());
        double least = directions.least() - margins;
        int looked = 0;
        for (int k = 0; k < hull.sides() && looked < MOST_TIES; k++) {
            if (hull.reach(k) <= least && isElsewhere(hull.x(k), hull.y(k), hull.z(k), least + margins + slack)) {
                searchFromHull(hull.x(k), hull.y(k), hull.z(k));
                looked++;
            }
        }
    }

    private void searchFromHull(double dx, double dy, double dz) {
        double up = flat ? 0 : dy;
        double length = Math.sqrt(dx * dx + up * up + dz * dz);
        if (length > 0) {
            searchFrom(dx / length, up / length, dz / length, depth(dx / length, up / length, dz / length));
        }
    }

    /** Whether a direction is not near any of the shallow directions known. */
    private boolean isElsewhere(double dx, double dy, double dz, double shallow) {
        for (int k = 0; k < directions.count(); k++) {
            double cosine = dx * directions.x(k) + dy * directions.y(k) + dz * directions.z(k);
            if (directions.depth(k) <= shallow && cosine > 1 - SAME_VALLEY) {
                return false;
            }
        }
        return true;
    }

    private void load(Leaf a, Leaf b) {
        double ox = Support.originX(a.kind, a.row, a.at);
        double oz = Support.originZ(a.kind, a.row, a.at);
        if (flat) {
            first.planar(a.kind, a.row, a.at, ox, oz, 1);
            second.planar(b.kind, b.row, b.at, ox, oz, 1);
            facetsA.planar(a);
            facetsB.planar(b);
        } else {
            double oy = Support.originY(a.kind, a.row, a.at);
            first.spatial(a.kind, a.row, a.at, ox, oy, oz, 1);
            second.spatial(b.kind, b.row, b.at, ox, oy, oz, 1);
            facetsA.spatial(a);
            facetsB.spatial(b);
        }
        margins = first.margin + second.margin;
        search.flat = flat;
        search.tries = 0;
    }

    /**
     * For upright leaves: up and down, the sides of both bases, and, if a disc's centre is outside, the direction to
     * the nearest point in the plane. These are all, as the difference set is upright too.
     */
    private void level(Leaf a, Leaf b) {
        both(0, 1, 0);
        facetsA.planar(a);
        facetsB.planar(b);
        sides(facetsA);
        sides(facetsB);
        plane.planar(a, b);
        if (plane.coreReach() > plane.error()) {
            take(plane.nx(), 0, plane.nz(), depth(plane.nx(), 0, plane.nz()));
        } else if (facetsA.faces + facetsB.faces == 0) {
            both(1, 0, 0); // two concentric discs
        }
    }

    /** The directions of the flat sides of the difference set; in a difference set without any, two across it. */
    private void candidates() {
        sides(facetsA);
        sides(facetsB);
        for (int k = 0; k < facetsA.edges; k++) {
            for (int m = 0; m < facetsB.edges; m++) {
                cross(
                        facetsA.edgeX[k],
                        facetsA.edgeY[k],
                        facetsA.edgeZ[k],
                        facetsB.edgeX[m],
                        facetsB.edgeY[m],
                        facetsB.edgeZ[m]);
            }
        }
        if (directions.count() == 0) {
            across();
        }
    }

    private void sides(FeatureDirections facets) {
        for (int k = 0; k < facets.faces; k++) {
            both(facets.faceX[k], facets.faceY[k], facets.faceZ[k]);
        }
    }

    private void across() {
        FeatureDirections facets = facetsA.edges > 0 ? facetsA : facetsB;
        if (flat || facets.edges == 0) {
            both(1, 0, 0);
            return;
        }
        // Perpendicular to the remaining segment, using the world axis that is furthest from it.
        double ex = facets.edgeX[0];
        double ey = facets.edgeY[0];
        double ez = facets.edgeZ[0];
        if (Math.abs(ey) <= Math.abs(ex) && Math.abs(ey) <= Math.abs(ez)) {
            cross(ex, ey, ez, 0, 1, 0);
        } else if (Math.abs(ex) <= Math.abs(ez)) {
            cross(ex, ey, ez, 1, 0, 0);
        } else {
            cross(ex, ey, ez, 0, 0, 1);
        }
    }

    private void cross(double px, double py, double pz, double qx, double qy, double qz) {
        double cx = py * qz - pz * qy;
        double cy = pz * qx - px * qz;
        double cz = px * qy - py * qx;
        double square = cx * cx + cy * cy + cz * cz;
        if (square > 0x1p-80) { // the cross product of nearly parallel edges is rounding, not a side
            double length = Math.sqrt(square);
            both(cx / length, cy / length, cz / length);
        }
    }

    private void both(double dx, double dy, double dz) {
        take(dx, dy, dz, depth(dx, dy, dz));
        take(0 - dx, 0 - dy, 0 - dz, depth(-dx, -dy, -dz));
    }

    private void take(double dx, double dy, double dz, double depth) {
        directions.take(dx, dy, dz, depth);
    }

    private double depth(double dx, double dy, double dz) {
        return search.depth(dx, dy, dz);
    }

    private void searchFrom(double dx, double dy, double dz, double depth) {
        search.from(dx, dy, dz, depth);
    }

    /**
     * Searches for a shallower direction between the flat sides: perpendicular to each straight edge, where valleys are
     * sharp, then freely from the best of the flat sides, GJK's slab and the centres.
     */
    private void refine() {
        if (flat) {
            search.circle(0, 1, 0);
        } else {
            around(facetsA);
            around(facetsB);
        }
        int best = directions.best();
        searchFrom(directions.x(best), directions.y(best), directions.z(best), directions.depth(best));
        double length = Math.sqrt(gjk.nx() * gjk.nx() + gjk.ny() * gjk.ny() + gjk.nz() * gjk.nz());
        if (length > 0.5) {
            searchFrom(gjk.nx(), gjk.ny(), gjk.nz(), depth(gjk.nx(), gjk.ny(), gjk.nz()));
        }
        double cx = first.centreX - second.centreX;
        double cy = first.centreY - second.centreY;
        double cz = first.centreZ - second.centreZ;
        length = Math.sqrt(cx * cx + cy * cy + cz * cz);
        if (length > 0) {
            searchFrom(cx / length, cy / length, cz / length, depth(cx / length, cy / length, cz / length));
        }
    }

    private void around(FeatureDirections facets) {
        for (int k = 0; k < facets.edges; k++) {
            search.circle(facets.edgeX[k], facets.edgeY[k], facets.edgeZ[k]);
        }
    }
}
