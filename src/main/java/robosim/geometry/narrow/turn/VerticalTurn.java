package robosim.geometry.narrow.turn;

import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.ProjectedPolygon;
import robosim.geometry.narrow.planar.ExactPlanar;
import robosim.geometry.narrow.sat.ExactExtent;
import robosim.geometry.narrow.sweep.ExactDisc;

/**
 * A leaf turned about a vertical line against one at rest, in the plane: chooses between polygons and discs, and
 * decides contacts at the start.
 */
final class VerticalTurn {
    private final ProjectedPolygon mover = new ProjectedPolygon();
    private final ProjectedPolygon rest = new ProjectedPolygon();
    private final ProjectedPolygon point = new ProjectedPolygon();
    private final TurningPolygon polygons = new TurningPolygon();
    private final TurningDisc disc = new TurningDisc();

    /** The free arc of the last turn, radians. */
    double arc;

    /** Whether the two were certainly apart when the last turn began. */
    boolean isApart;

    // -1 where the plane is mirrored, so that the turn goes from x towards z.
    private int sign;

    static boolean isCovered(LeafKind kind) {
        return kind.isPolytope() || kind.isDisc();
    }

    /**
     * As {@link PlanarTurnSweep#free}, by {@code degrees} about the upward vertical through (px, pz).
     *
     * @param heightDepth how far the heights overlap, which a turn does not change: where that is the lesser depth at the
     *     start, nothing gets deeper; infinite where heights do not count
     */
    double free(
            LeafKind kindA,
            double[] a,
            int i,
            double px,
            double pz,
            double degrees,
            LeafKind kindB,
            double[] b,
            int j,
            double heightDepth) {
        double angle = Degrees.toRadians(Math.abs(degrees));
        isApart = false;
        // From x towards z is clockwise as seen from above.
        sign = degrees > 0 ? -1 : 1;
        load(mover, kindA, a, i, px, pz);
        load(rest, kindB, b, j, px, pz);
        double free;
        if (kindA.isDisc()) {
            double radius = a[i + 3] + (kindB.isDisc() ? b[j + 3] : 0);
            free = round(mover.x[0], mover.z[0], rest, radius, a, i, kindB, b, j, heightDepth);
        } else if (kindB.isDisc()) {
            // As the mover sees it, the disc goes round the other way.
            mover.mirror(-1);
            rest.mirror(-1);
            free = round(rest.x[0], rest.z[0], mover, b[j + 3], b, j, kindA, a, i, heightDepth);
        } else {
            free = polygons(angle, kindA, a, i, kindB, b, j, heightDepth);
        }
        arc = free;
        return TurningPolygon.covers(free, angle) ? Double.POSITIVE_INFINITY : TurningPolygon.fraction(free, angle);
    }

    private void load(ProjectedPolygon outline, LeafKind kind, double[] row, int at, double px, double pz) {
        if (kind.isDisc()) {
            outline.point(row[at] - px, row[at + 2] - pz);
        } else {
            outline.load(kind, row, at, px, pz);
        }
        outline.mirror(sign);
    }

    private double polygons(
            double angle, LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, double heightDepth) {
        polygons.load(mover, rest);
        if (!polygons.near) {
            isApart = true;
            return polygons.free(angle);
        }
        boolean apart =
                polygons.gap > -polygons.error && !ExactPlanar.of(kindA, a, i).touches(ExactPlanar.of(kindB, b, j));
        if (!apart) {
            return -polygons.gap >= heightDepth - polygons.error ? Double.POSITIVE_INFINITY : polygons.free(angle);
        }
        isApart = true;
        for (int k = 0; k < polygons.normals(); k++) {
            if (polygons.isLeading(k)
                    && !isBeyond(kindA, a, i, polygons.unitX(k), sign * polygons.unitZ(k), kindB, b, j)) {
                polygons.reject(k);
            }
        }
        return polygons.free(angle);
    }

    /** Whether a lies wholly beyond b in a direction; (nx, nz) is used as given, of any length. */
    private static boolean isBeyond(
            LeafKind kindA, double[] a, int i, double nx, double nz, LeafKind kindB, double[] b, int j) {
        ExactVector n = ExactVector.of(nx, 0, nz);
        return ExactExtent.of(n, kindB, b, j).gapTo(ExactExtent.of(n, kindA, a, i)) > 0;
    }

    private double round(
            double x,
            double z,
            ProjectedPolygon outline,
            double radius,
            double[] a,
            int i,
            LeafKind kindB,
            double[] b,
            int j,
            double heightDepth) {
        disc.load(x, z, outline);
        double gap = disc.distance - radius;
        double error = disc.error + 32 * 0x1p-53 * radius;
        if (gap > error) {
            isApart = true;
            return disc.free(outline, radius, false);
        }
        boolean apart =
                gap >= -error && !ExactDisc.of(a, i, 0, 0, kindB, b, j, null).touches();
        isApart = apart;
        if (disc.distance > disc.error || outline.normals == 0) {
            boolean shallow = !apart && -gap >= heightDepth - error;
            return shallow ? Double.POSITIVE_INFINITY : disc.free(outline, disc.distance, true);
        }
        // The centre inside the polygon (or too near its edge to tell): the depth counts from the edges.
        point.point(x, z);
        polygons.load(point, outline);
        return radius - polygons.gap >= heightDepth - error ? Double.POSITIVE_INFINITY : polygons.free(2 * Math.PI);
    }
}
