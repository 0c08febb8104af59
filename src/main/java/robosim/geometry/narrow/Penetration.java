package robosim.geometry.narrow;

/**
 * How deep one leaf is in another, and in which directions it gets out on the shortest way.
 *
 * <p>Between boxes, triangles and prisms the directions are those of separating axes (the sides of the difference set),
 * all of them where several tie; for a sphere or disc whose centre is outside the other it is the direction to the
 * nearest point. Where a cylinder's rim counts, the directions of flat sides and straight edges, of the widest slab that
 * {@link Gjk} saw and of the centres are refined by a pattern search: the depth answered is then a depth in which the
 * leaf does get out, hence never too small, but it is a local minimum and not proven to be the least.
 *
 * <p>To rounding, some 2^-48 of sizes and offset; it decides no overlap. (a, b) and (b, a) give the same bits. Nothing is
 * allocated by a question.
 */
final class Penetration {
    private static final int MOST_PROBES = 600;
    private static final double FIRST_STEP = 0.5;
    private static final double LAST_STEP = 0x1p-30;

    /** Directions tried around an edge before the best is refined, a 15-8-17 triangle's angle apart: 28 degrees. */
    private static final int SPREAD = 13;

    private static final double SPREAD_COS = 15 / 17.0;
    private static final double SPREAD_SIN = 8 / 17.0;

    private final Gjk gjk = new Gjk();
    private final Gjk plane = new Gjk();
    private final Support first = new Support();
    private final Support second = new Support();
    private final Facets facetsA = new Facets();
    private final Facets facetsB = new Facets();

    private final Directions directions = new Directions();
    private double margins;
    private boolean flat;

    // Where the pattern search stands.
    private double searchX;
    private double searchY;
    private double searchZ;
    private double searchDepth;
    private int probes;

    /** Depth in space; negative, the distance, where the two are apart. */
    double spatial(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        flat = false;
        return ordered(kindA, a, i, kindB, b, j);
    }

    /** Depth of the projections on XZ; negative, the distance, where the two are apart. All directions have y = 0. */
    double planar(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        flat = true;
        return ordered(kindA, a, i, kindB, b, j);
    }

    /**
     * The width of the widest slab between two leaves, to rounding, from where {@link Gjk} ends: close to contact it knows
     * a direction no better than a rounding is large beside the distance, which counts where a flat side or a straight
     * edge meets something.
     *
     * @param x a unit direction to start from besides
     */
    double slab(int kindA, double[] a, int i, int kindB, double[] b, int j, double x, double y, double z) {
        flat = false;
        gjk.spatial(kindA, a, i, kindB, b, j);
        directions.clear();
        load(kindA, a, i, kindB, b, j);
        candidates();
        searchFrom(x, y, z, depth(x, y, z));
        refine();
        return Math.max(gjk.reach(), -directions.least());
    }

    /** The distance question that the last one began with; its a and b may be exchanged. */
    Gjk bracket() {
        return gjk;
    }

    /** How many directions tie; at least 1. */
    int count() {
        return directions.count();
    }

    /** A unit direction in which a has to move to get out. */
    double nx(int k) {
        return directions.x(k);
    }

    double ny(int k) {
        return directions.y(k);
    }

    double nz(int k) {
        return directions.z(k);
    }

    private double ordered(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        if (!Order.isReversed(kindA, a, i, kindB, b, j)) {
            return solve(kindA, a, i, kindB, b, j);
        }
        double depth = solve(kindB, b, j, kindA, a, i);
        directions.reverse();
        return depth;
    }

    private double solve(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        if (flat) {
            gjk.planar(kindA, a, i, kindB, b, j);
        } else {
            gjk.spatial(kindA, a, i, kindB, b, j);
        }
        directions.clear();
        if (gjk.coreReach() > gjk.error()) {
            take(gjk.nx(), gjk.ny(), gjk.nz(), -gjk.reach());
            return -gjk.reach();
        }
        load(kindA, a, i, kindB, b, j);
        if (!flat && Leaf.isUpright(kindA) && Leaf.isUpright(kindB)) {
            level(kindA, a, i, kindB, b, j);
        } else {
            candidates();
            if (!first.isPolytope() || !second.isPolytope()) {
                directions.beginSearch();
                refine();
            }
        }
        double depth = directions.least();
        directions.keepTies(depth + 2 * gjk.error());
        return depth;
    }

    private void load(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        double ox = Support.originX(kindA, a, i);
        double oz = Support.originZ(kindA, a, i);
        if (flat) {
            first.planar(kindA, a, i, ox, oz, 1);
            second.planar(kindB, b, j, ox, oz, 1);
            facetsA.planar(kindA, a, i);
            facetsB.planar(kindB, b, j);
        } else {
            double oy = Support.originY(kindA, a, i);
            first.spatial(kindA, a, i, ox, oy, oz, 1);
            second.spatial(kindB, b, j, ox, oy, oz, 1);
            facetsA.spatial(kindA, a, i);
            facetsB.spatial(kindB, b, j);
        }
        margins = first.margin + second.margin;
    }

    /**
     * Between upright leaves: up and down, the sides of both bases, and the direction to the nearest point of the plane
     * where a disc's centre is outside. That is all, as the difference set stands upright too.
     */
    private void level(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        both(0, 1, 0);
        facetsA.planar(kindA, a, i);
        facetsB.planar(kindB, b, j);
        sides(facetsA);
        sides(facetsB);
        plane.planar(kindA, a, i, kindB, b, j);
        if (plane.coreReach() > plane.error()) {
            take(plane.nx(), 0, plane.nz(), depth(plane.nx(), 0, plane.nz()));
        } else if (facetsA.faces + facetsB.faces == 0) {
            both(1, 0, 0); // one axis in two discs
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

    private void sides(Facets facets) {
        for (int k = 0; k < facets.faces; k++) {
            both(facets.faceX[k], facets.faceY[k], facets.faceZ[k]);
        }
    }

    private void across() {
        Facets facets = facetsA.edges > 0 ? facetsA : facetsB;
        if (flat || facets.edges == 0) {
            both(1, 0, 0);
            return;
        }
        // Across the segment that is left: with the world axis that it is furthest from.
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

    /** How far a has to move along a unit direction until the supporting planes meet. */
    private double depth(double dx, double dy, double dz) {
        first.find(-dx, -dy, -dz);
        second.find(dx, dy, dz);
        return dx * (second.x - first.x) + dy * (second.y - first.y) + dz * (second.z - first.z) + margins;
    }

    /**
     * Looks for a shallower direction between the flat sides: across each straight edge, where valleys are sharp, then
     * freely from the best of the flat sides, GJK's slab and the centres.
     */
    private void refine() {
        if (flat) {
            circle(0, 1, 0);
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

    private void around(Facets facets) {
        for (int k = 0; k < facets.edges; k++) {
            circle(facets.edgeX[k], facets.edgeY[k], facets.edgeZ[k]);
        }
    }

    /** Searches the circle across a unit direction, from the best of some directions spread over it. */
    private void circle(double ex, double ey, double ez) {
        double tx = ez;
        double ty = 0;
        double tz = -ex;
        if (Math.abs(ex) + Math.abs(ez) < 0x1p-10) {
            tx = 1;
            ty = -ex / ey;
            tz = 0;
        }
        double length = Math.sqrt(tx * tx + ty * ty + tz * tz);
        tx /= length;
        ty /= length;
        tz /= length;
        double sx = ey * tz - ez * ty;
        double sy = ez * tx - ex * tz;
        double sz = ex * ty - ey * tx;
        searchDepth = Double.POSITIVE_INFINITY;
        double c = 1;
        double s = 0;
        for (int n = 0; n < SPREAD; n++) {
            tryAt(c * tx + s * sx - searchX, c * ty + s * sy - searchY, c * tz + s * sz - searchZ);
            double turned = c * SPREAD_COS - s * SPREAD_SIN;
            s = s * SPREAD_COS + c * SPREAD_SIN;
            c = turned;
        }
        probes = 0;
        for (double step = SPREAD_SIN; step > LAST_STEP && probes < MOST_PROBES; ) {
            double ax = step * (ey * searchZ - ez * searchY);
            double ay = step * (ez * searchX - ex * searchZ);
            double az = step * (ex * searchY - ey * searchX);
            if (!tryAt(ax, ay, az) && !tryAt(-ax, -ay, -az)) {
                step *= 0.5;
            }
        }
        take(searchX, searchY, searchZ, searchDepth);
    }

    private void searchFrom(double dx, double dy, double dz, double depth) {
        searchX = dx;
        searchY = dy;
        searchZ = dz;
        searchDepth = depth;
        probes = 0;
        double turnC = 1;
        double turnS = 0;
        for (double step = FIRST_STEP; step > LAST_STEP && probes < MOST_PROBES; ) {
            if (!improve(step, turnC, turnS)) {
                step *= 0.5;
                // Another star of directions each time, so that no valley lies between its arms for good.
                double c = 0.8 * turnC - 0.6 * turnS;
                turnS = 0.6 * turnC + 0.8 * turnS;
                turnC = c;
            }
        }
        take(searchX, searchY, searchZ, searchDepth);
    }

    /** One round of tries around the place where the search stands; moves it to the first that is shallower. */
    private boolean improve(double step, double turnC, double turnS) {
        if (flat) {
            return tryAt(-searchZ * step, 0, searchX * step) || tryAt(searchZ * step, 0, -searchX * step);
        }
        // Two directions across: one level, or along X where the search looks straight up.
        double tx = -searchZ;
        double tz = searchX;
        double length = Math.sqrt(tx * tx + tz * tz);
        if (length < 0x1p-10) {
            tx = 1;
            tz = 0;
            length = 1;
        }
        tx /= length;
        tz /= length;
        double sx = searchY * tz;
        double sy = searchZ * tx - searchX * tz;
        double sz = -searchY * tx;
        double c = step * turnC;
        double s = step * turnS;
        for (int arm = 0; arm < 4; arm++) {
            if (tryAt(c * tx + s * sx, s * sy, c * tz + s * sz)) {
                return true;
            }
            double swap = c;
            c = -s;
            s = swap;
        }
        return false;
    }

    private boolean tryAt(double offX, double offY, double offZ) {
        double dx = searchX + offX;
        double dy = searchY + offY;
        double dz = searchZ + offZ;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        dx /= length;
        dy /= length;
        dz /= length;
        probes++;
        double depth = depth(dx, dy, dz);
        if (!(depth < searchDepth)) {
            return false;
        }
        searchX = dx;
        searchY = dy;
        searchZ = dz;
        searchDepth = depth;
        return true;
    }
}
