package robosim.geometry.narrow.gjk;

import robosim.geometry.narrow.leaf.FeatureDirections;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.UprightLeaves;

/**
 * The directions along which two leaves are apart the most: normals of sides, directions across two edges, and the direction
 * between the nearest points of round ones. If the two just touch, these are the separating axes that close last; where
 * edges, corners or flush faces meet, several of them tie to within rounding, and all are found.
 *
 * <p>Two upright leaves that meet side to side are decided in the plane, with the same bits as their projections.
 *
 * <p>A witness in plain doubles; no decision depends on it.
 */
public final class ClosingDirections {
    /** Gaps that differ by less than this many error bounds of {@link Gjk} tie. */
    private static final double TIE = 2;

    /** Below this share of the extents, the direction of {@link Gjk} between curved outlines is refined by a search. */
    private static final double CLOSE = 0x1p-20;

    /** Edges or sides with a smaller sine, squared, are parallel. */
    private static final double PARALLEL = 0x1p-80;

    private final Gjk gjk = new Gjk();
    private final Support first = new Support();
    private final Support second = new Support();
    private final FeatureDirections facetsA = new FeatureDirections();
    private final FeatureDirections facetsB = new FeatureDirections();
    private final Directions directions = new Directions();
    private final DepthSearch search = new DepthSearch(first, second, directions);

    private boolean flat;
    private boolean isLevel;
    private double slack;
    private double gap;
    private double high;
    private double low;

    /** Finds the directions, each a unit vector from b towards a; in the plane with y = 0. */
    public void find(boolean planar, Leaf a, Leaf b) {
        isLevel = false;
        if (planar || !hasUprightCore(a.kind) || !hasUprightCore(b.kind)) {
            solve(planar, a, b);
            return;
        }
        double above = bottom(a) - top(b);
        double below = bottom(b) - top(a);
        low = Math.max(bottom(a), bottom(b));
        high = Math.min(top(a), top(b));
        boolean isPrisms = a.kind.isVerticalPrism() && b.kind.isVerticalPrism();
        if (isPrisms || Math.max(above, below) <= 0) {
            solve(true, a, b);
            if (isPrisms) {
                slack += Gjk.ROUNDOFF * (Math.abs(low) + Math.abs(high));
                combine(Math.max(above, below), above >= below ? 1 : -1);
                return;
            }
            isLevel = gap >= -slack;
            if (isLevel) {
                return;
            }
        }
        solve(false, a, b);
    }

    /** Whether the leaf is all that is within a radius of a prism or a vertical segment. */
    private static boolean hasUprightCore(LeafKind kind) {
        return kind.isVerticalPrism() || kind == LeafKind.SPHERE || kind == LeafKind.UPRIGHT_CAPSULE;
    }

    private static double bottom(Leaf leaf) {
        return leaf.kind == LeafKind.SPHERE ? leaf.get(1) : UprightLeaves.middle(leaf) - UprightLeaves.halfHeight(leaf);
    }

    private static double top(Leaf leaf) {
        return leaf.kind == LeafKind.SPHERE ? leaf.get(1) : UprightLeaves.top(leaf) + UprightLeaves.halfHeight(leaf);
    }

    /** Combines the directions in the plane with the vertical one. */
    private void combine(double vertical, int up) {
        if (vertical > slack && gap > slack) {
            double length = Math.sqrt(gap * gap + vertical * vertical);
            directions.tilt(gap / length, up * vertical / length, -length);
            gap = length;
            return;
        }
        if (vertical > gap + slack) {
            directions.clear();
        }
        isLevel = vertical < gap - slack;
        if (!isLevel) {
            directions.take(0, up, 0, -vertical);
        }
        gap = Math.max(gap, vertical);
    }

    private void solve(boolean planar, Leaf a, Leaf b) {
        slack = load(planar, a, b);
        directions.clear();
        search.flat = flat;
        sides(a, facetsA);
        sides(b, facetsB);
        if (!flat) {
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
            if (isThin(a.kind, facetsA) && isThin(b.kind, facetsB)) {
                inPlane(facetsA);
                inPlane(facetsB);
            }
        }
        boolean isCurved = !first.isPolytope() || !second.isPolytope();
        boolean isRound = isCurved || first.margin > 0 || second.margin > 0;
        if (isRound || directions.count() == 0 || -directions.least() > slack) {
            nearest(isCurved, a, b);
        }
        gap = directions.count() == 0 ? 0 : -directions.least();
        directions.keepTies(slack - gap);
    }

    /** Adds the direction between the nearest points, if it is not that of a side, which is known more accurately. */
    private void nearest(boolean isCurved, Leaf a, Leaf b) {
        if (flat) {
            gjk.planar(a, b);
        } else {
            gjk.spatial(a, b);
        }
        slack = TIE * gjk.error();
        double sides = directions.count() == 0 ? Double.POSITIVE_INFINITY : directions.least();
        boolean isSide = sides <= slack && -sides >= gjk.reach() - slack;
        if (isCurved && !isSide && !(gjk.coreReach() > CLOSE * (first.extent + second.extent))) {
            refine();
            sides = directions.least();
        }
        double length = Math.sqrt(gjk.nx() * gjk.nx() + gjk.ny() * gjk.ny() + gjk.nz() * gjk.nz());
        if (length > 0.5) {
            double depth = search.depth(gjk.nx(), gjk.ny(), gjk.nz());
            if (depth < sides - slack) {
                directions.take(gjk.nx(), gjk.ny(), gjk.nz(), depth);
            }
        }
    }

    /** Loads two leaves for {@link #gap(double, double, double)} alone; returns the error of that, times some. */
    public double load(boolean planar, Leaf a, Leaf b) {
        flat = planar;
        double ox = Support.originX(a.kind, a.row, a.at);
        double oz = Support.originZ(a.kind, a.row, a.at);
        if (flat) {
            first.planar(a.kind, a.row, a.at, ox, oz, 1);
            second.planar(b.kind, b.row, b.at, ox, oz, 1);
        } else {
            double oy = Support.originY(a.kind, a.row, a.at);
            first.spatial(a.kind, a.row, a.at, ox, oy, oz, 1);
            second.spatial(b.kind, b.row, b.at, ox, oy, oz, 1);
        }
        return TIE * Gjk.ROUNDOFF * (first.extent + second.extent);
    }

    private void sides(Leaf leaf, FeatureDirections facets) {
        if (flat) {
            facets.planar(leaf);
        } else {
            facets.spatial(leaf);
        }
        for (int k = 0; k < facets.faces; k++) {
            both(facets.faceX[k], facets.faceY[k], facets.faceZ[k]);
        }
        if (flat && leaf.kind == LeafKind.TRIANGLE && areParallel(facets)) {
            both(-facets.faceZ[0], 0, facets.faceX[0]); // a segment also ends
        }
    }

    private static boolean areParallel(FeatureDirections facets) {
        for (int k = 1; k < facets.faces; k++) {
            double sine = facets.faceX[0] * facets.faceZ[k] - facets.faceZ[0] * facets.faceX[k];
            if (sine * sine > PARALLEL) {
                return false;
            }
        }
        return facets.faces > 0;
    }

    /** Whether it is a triangle in the plane of one of the other's sides, or a segment. */
    private boolean isThin(LeafKind kind, FeatureDirections facets) {
        if (kind != LeafKind.TRIANGLE) {
            return false;
        }
        if (facetsA.faces == 0 || facetsB.faces == 0) {
            return true;
        }
        FeatureDirections others = facets == facetsA ? facetsB : facetsA;
        double x = facets.faceY[0] * others.faceZ[0] - facets.faceZ[0] * others.faceY[0];
        double y = facets.faceZ[0] * others.faceX[0] - facets.faceX[0] * others.faceZ[0];
        double z = facets.faceX[0] * others.faceY[0] - facets.faceY[0] * others.faceX[0];
        return x * x + y * y + z * z < 0x1p-60;
    }

    /** The normals of a triangle's edges in its plane; of a segment, where it ends. */
    private void inPlane(FeatureDirections facets) {
        for (int k = 0; k < facets.edges; k++) {
            if (facets.faces > 0) {
                cross(
                        facets.edgeX[k],
                        facets.edgeY[k],
                        facets.edgeZ[k],
                        facets.faceX[0],
                        facets.faceY[0],
                        facets.faceZ[0]);
            } else {
                both(facets.edgeX[k], facets.edgeY[k], facets.edgeZ[k]);
            }
        }
    }

    private void cross(double px, double py, double pz, double qx, double qy, double qz) {
        double cx = py * qz - pz * qy;
        double cy = pz * qx - px * qz;
        double cz = px * qy - py * qx;
        double square = cx * cx + cy * cy + cz * cz;
        if (square > PARALLEL) {
            double length = Math.sqrt(square);
            both(cx / length, cy / length, cz / length);
        }
    }

    private void both(double dx, double dy, double dz) {
        directions.take(dx, dy, dz, search.depth(dx, dy, dz));
        directions.take(0 - dx, 0 - dy, 0 - dz, search.depth(-dx, -dy, -dz));
    }

    /** Where a curved outline is involved: across each straight edge, then freely from the best. */
    private void refine() {
        directions.beginSearch();
        if (flat) {
            search.circle(0, 1, 0);
        } else {
            around(facetsA);
            around(facetsB);
        }
        int best = directions.best();
        search.from(directions.x(best), directions.y(best), directions.z(best), directions.depth(best));
        double length = Math.sqrt(gjk.nx() * gjk.nx() + gjk.ny() * gjk.ny() + gjk.nz() * gjk.nz());
        if (length > 0.5) {
            search.from(gjk.nx(), gjk.ny(), gjk.nz(), search.depth(gjk.nx(), gjk.ny(), gjk.nz()));
        }
    }

    private void around(FeatureDirections facets) {
        for (int k = 0; k < facets.edges; k++) {
            search.circle(facets.edgeX[k], facets.edgeY[k], facets.edgeZ[k]);
        }
    }

    /** The number of directions that tie; 0 if the two are concentric and round, so that any direction will do. */
    public int count() {
        return directions.count();
    }

    public double x(int k) {
        return directions.x(k);
    }

    public double y(int k) {
        return directions.y(k);
    }

    public double z(int k) {
        return directions.z(k);
    }

    /** The distance; if the two overlap, minus the least depth along these directions. */
    public double gap() {
        return gap;
    }

    /** Gaps are equal to within this. */
    public double slack() {
        return slack;
    }

    /** The gap along a unit direction between the two leaves loaded last, unless {@link #isLevel}. */
    public double gap(double dx, double dy, double dz) {
        return -search.depth(dx, dy, dz);
    }

    /** Whether they are in space, but were found in the plane. */
    public boolean isLevel() {
        return isLevel;
    }

    /** If {@link #isLevel}, the middle of the heights that the two have in common, radii apart. */
    public double middle() {
        return low / 2 + high / 2;
    }
}
