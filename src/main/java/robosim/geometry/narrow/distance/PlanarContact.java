package robosim.geometry.narrow.distance;

import robosim.geometry.exact.Radians;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.PairOrder;
import robosim.geometry.narrow.planar.PlanarBracket;
import robosim.geometry.narrow.planar.PlanarShape;

/** The contact point and normal of the projections of two leaves. */
public final class PlanarContact {
    // Directions tried for the least penetration of a curved outline, before the best is refined.
    private static final int DIRECTIONS = 64;
    private static final int REFINEMENTS = 60;

    // The direction between curved outlines is known to half the digits: points that are foremost to within that count
    // as one side.
    private static final double SIDE = 0x1p27;

    private PlanarContact() {}

    /**
     * Writes a contact point (its y is the middle of the common height range) and the unit normal from b towards a,
     * whose y is 0: the direction of separation if the two are apart, of least penetration if they overlap.
     *
     * <p>A witness in plain doubles, for leaves that touch or nearly do; no decision depends on it.
     */
    public static void between(Leaf a, Leaf b, double[] out, DistanceScratch s) {
        boolean reversed = PairOrder.isReversed(a, b);
        if (reversed) {
            ordered(b, a, out, s);
            out[3] = 0 - out[3];
            out[5] = 0 - out[5];
        } else {
            ordered(a, b, out, s);
        }
        out[1] = height(a, b, s);
        out[4] = 0;
    }

    /** Writes the contact point alone, for a known unit normal from b towards a, the last three of six numbers. */
    public static void point(Leaf a, Leaf b, double[] out, DistanceScratch s) {
        PlanarShape p = s.planar.planarA;
        PlanarShape q = s.planar.planarB;
        double nx = out[3];
        double nz = out[5];
        double ox = PlanarShape.originX(a.kind, a.row, a.at);
        double oz = PlanarShape.originZ(a.kind, a.row, a.at);
        p.set(a.kind, a.row, a.at, ox, oz);
        q.set(b.kind, b.row, b.at, ox, oz);
        point(p, q, nx, nz, ox, oz, out);
        // The direction between a corner and a curve is known to half the digits, and the corner to all.
        if (p.outline == PlanarShape.Outline.POLYGON && q.outline != PlanarShape.Outline.POLYGON) {
            clamp(p, -nx, -nz, ox, oz, out);
        } else if (q.outline == PlanarShape.Outline.POLYGON && p.outline != PlanarShape.Outline.POLYGON) {
            clamp(q, nx, nz, ox, oz, out);
        }
        out[1] = height(a, b, s);
    }

    /** Moves a point along the foremost side of a polygon onto it, or to its foremost corner. */
    private static void clamp(PlanarShape shape, double nx, double nz, double ox, double oz, double[] out) {
        double slack = SIDE * shape.error;
        double least = end(shape, nx, nz, -nz, nx, -1, slack);
        double most = end(shape, nx, nz, -nz, nx, 1, slack);
        double along = nx * (out[2] - oz) - nz * (out[0] - ox);
        double by = Math.max(least, Math.min(most, along)) - along;
        out[0] -= by * nz;
        out[2] += by * nx;
    }

    private static void ordered(Leaf a, Leaf b, double[] out, DistanceScratch s) {
        PlanarShape p = s.planar.planarA;
        PlanarShape q = s.planar.planarB;
        double ox = PlanarShape.originX(a.kind, a.row, a.at);
        double oz = PlanarShape.originZ(a.kind, a.row, a.at);
        p.set(a.kind, a.row, a.at, ox, oz);
        q.set(b.kind, b.row, b.at, ox, oz);
        PlanarBracket bracket = s.planar.planarBracket;
        bracket.find(q, p, false);
        double nx = bracket.normalX;
        double nz = bracket.normalZ;
        if (!bracket.isApart()) {
            leastPenetration(p, q, s.planar.planarNormal);
            nx = s.planar.planarNormal[0];
            nz = s.planar.planarNormal[1];
        }
        point(p, q, nx, nz, ox, oz, out);
        out[3] = nx + 0.0; // no -0.0
        out[5] = nz + 0.0;
    }

    // How far q has to move against n, or p along it, until they are apart.
    private static double depth(PlanarShape p, PlanarShape q, double nx, double nz) {
        return q.support(nx, nz) + p.support(-nx, -nz);
    }

    private static void leastPenetration(PlanarShape p, PlanarShape q, double[] normal) {
        normal[0] = 1;
        normal[1] = 0;
        normal[2] = Double.POSITIVE_INFINITY;
        sides(q, 1, p, q, normal);
        sides(p, -1, p, q, normal);
        switch (p.outline) {
            case OVAL -> around(p, q, normal);
            case DISC -> fromDisc(p, q, normal);
            case POLYGON -> fromPolygon(p, q, normal);
        }
        if (normal[2] == Double.POSITIVE_INFINITY) {
            // two coincident points, or two concentric discs: any direction will do
            offer(p, q, 1, 0, normal);
        }
    }

    private static void fromDisc(PlanarShape p, PlanarShape q, double[] normal) {
        switch (q.outline) {
            case OVAL -> around(p, q, normal);
            case DISC -> offer(p, q, p.centerX - q.centerX, p.centerZ - q.centerZ, normal);
            case POLYGON -> corners(q, p, 1, p, q, normal);
        }
    }

    private static void fromPolygon(PlanarShape p, PlanarShape q, double[] normal) {
        switch (q.outline) {
            case OVAL -> around(p, q, normal);
            case DISC -> corners(p, q, -1, p, q, normal);
            case POLYGON -> {} // the sides are all there is
        }
    }

    private static void sides(PlanarShape of, int sign, PlanarShape p, PlanarShape q, double[] normal) {
        switch (of.outline) {
            case DISC -> {}
            case OVAL -> {
                offer(p, q, of.axisZ, -of.axisX, normal);
                offer(p, q, -of.axisZ, of.axisX, normal);
            }
            case POLYGON -> edges(of, sign, p, q, normal);
        }
    }

    private static void edges(PlanarShape of, int sign, PlanarShape p, PlanarShape q, double[] normal) {
        int last = of.count - 1;
        for (int k = 0; k <= last; k++) {
            int previous = k == 0 ? last : k - 1;
            double nx = of.z[k] - of.z[previous];
            double nz = of.x[previous] - of.x[k];
            offer(p, q, sign * nx, sign * nz, normal);
        }
        if (of.count == 2) {
            // a flat shape may also be left at its ends
            offer(p, q, of.x[1] - of.x[0], of.z[1] - of.z[0], normal);
            offer(p, q, of.x[0] - of.x[1], of.z[0] - of.z[1], normal);
        }
    }

    private static void corners(
            PlanarShape of, PlanarShape disc, int sign, PlanarShape p, PlanarShape q, double[] normal) {
        for (int k = 0; k < of.count; k++) {
            offer(p, q, sign * (disc.centerX - of.x[k]), sign * (disc.centerZ - of.z[k]), normal);
        }
    }

    private static void offer(PlanarShape p, PlanarShape q, double dx, double dz, double[] normal) {
        double length = Math.sqrt(dx * dx + dz * dz);
        if (!(length > 0)) {
            return;
        }
        double nx = dx / length;
        double nz = dz / length;
        double depth = depth(p, q, nx, nz);
        if (depth < normal[2]) {
            normal[0] = nx;
            normal[1] = nz;
            normal[2] = depth;
        }
    }

    // All around in equal steps, then halving the step around the best.
    private static void around(PlanarShape p, PlanarShape q, double[] normal) {
        double stepX = Radians.cos(2 * Math.PI / DIRECTIONS);
        double stepZ = Radians.sin(2 * Math.PI / DIRECTIONS);
        double nx = 1;
        double nz = 0;
        for (int k = 0; k < DIRECTIONS; k++) {
            offer(p, q, nx, nz, normal);
            double turned = nx * stepX - nz * stepZ;
            nz = nx * stepZ + nz * stepX;
            nx = turned;
        }
        double turn = Math.PI / DIRECTIONS;
        for (int k = 0; k < REFINEMENTS; k++) {
            double bestX = normal[0];
            double bestZ = normal[1];
            double depth = normal[2];
            offer(p, q, bestX - turn * bestZ, bestZ + turn * bestX, normal);
            offer(p, q, bestX + turn * bestZ, bestZ - turn * bestX, normal);
            if (normal[2] == depth) {
                turn /= 2;
            }
        }
    }

    // Midway between the two outlines, in the middle of the overlap of the two sides.
    private static void point(PlanarShape p, PlanarShape q, double nx, double nz, double ox, double oz, double[] out) {
        double slack = SIDE * (p.error + q.error);
        double level = (q.support(nx, nz) - p.support(-nx, -nz)) / 2;
        double pLeast = end(p, -nx, -nz, -nz, nx, -1, slack);
        double pMost = end(p, -nx, -nz, -nz, nx, 1, slack);
        double qLeast = end(q, nx, nz, -nz, nx, -1, slack);
        double qMost = end(q, nx, nz, -nz, nx, 1, slack);
        double along = (Math.max(pLeast, qLeast) + Math.min(pMost, qMost)) / 2;
        out[0] = ox + (level * nx - along * nz);
        out[2] = oz + (level * nz + along * nx);
    }

    // How far the foremost points along n extend along t (side 1) or against it (side -1).
    private static double end(PlanarShape shape, double nx, double nz, double tx, double tz, int side, double slack) {
        double most = shape.support(nx, nz);
        return switch (shape.outline) {
            case POLYGON -> farthestCorner(shape, nx, nz, tx, tz, side, most - slack);
            case DISC -> tx * shape.pointX + tz * shape.pointZ;
            case OVAL -> {
                boolean isAcross = Math.abs(nx * shape.axisX + nz * shape.axisZ) * (shape.reach + shape.minor) <= slack;
                boolean isCap =
                        shape.minor <= slack && Math.abs(nx * shape.axisZ - nz * shape.axisX) * shape.radius <= slack;
                if (isCap && !isAcross) { // of a cylinder that lies level
                    double ahead = Math.signum(nx * shape.axisX + nz * shape.axisZ) * shape.reach;
                    double capX = shape.centerX + ahead * shape.axisX;
                    double capZ = shape.centerZ + ahead * shape.axisZ;
                    yield tx * capX + tz * capZ + side * shape.radius;
                }
                if (!isAcross) {
                    yield tx * shape.pointX + tz * shape.pointZ;
                }
                double way = side * Math.signum(tx * shape.axisX + tz * shape.axisZ) * shape.reach;
                double endX = shape.centerX + way * shape.axisX;
                double endZ = shape.centerZ + way * shape.axisZ;
                yield tx * endX + tz * endZ;
            }
        };
    }

    private static double farthestCorner(
            PlanarShape shape, double nx, double nz, double tx, double tz, int side, double least) {
        double end = side * (tx * shape.pointX + tz * shape.pointZ);
        for (int k = 0; k < shape.count; k++) {
            if (nx * shape.x[k] + nz * shape.z[k] >= least) {
                end = Math.max(end, side * (tx * shape.x[k] + tz * shape.z[k]));
            }
        }
        return side * end;
    }

    private static double height(Leaf a, Leaf b, DistanceScratch s) {
        double[] bounds = s.planar.planarBounds;
        LeafBounds.of(a.kind, a.row, a.at, bounds);
        double least = bounds[1];
        double most = bounds[4];
        LeafBounds.of(b.kind, b.row, b.at, bounds);
        return (Math.max(least, bounds[1]) + Math.min(most, bounds[4])) / 2;
    }
}
