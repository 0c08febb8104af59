package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.leaf.ProjectedPolygon;
import robosim.geometry.narrow.planar.ExactPolygon;
import robosim.geometry.narrow.sat.ExactExtent;

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
     * As {@link PlanarSweep#turn}, about a vertical axis.
     *
     * @param heightDepth how far the heights overlap, which a turn does not change: where that is the lesser depth at the
     *     start, nothing gets deeper; infinite where heights do not count
     */
    double free(Leaf a, PivotTurn turn, Leaf b, double heightDepth) {
        double degrees = turn.wy < 0 ? -turn.degrees : turn.degrees;
        double angle = Degrees.toRadians(Math.abs(degrees));
        isApart = false;
        // From x towards z is clockwise as seen from above.
        sign = degrees > 0 ? -1 : 1;
        load(mover, a, turn);
        load(rest, b, turn);
        double free;
        if (a.kind.isDisc()) {
            double radius = a.get(3) + (b.kind.isDisc() ? b.get(3) : 0);
            free = round(mover.x[0], mover.z[0], rest, radius, a, b, heightDepth);
        } else if (b.kind.isDisc()) {
            // As the mover sees it, the disc goes round the other way.
            mover.mirror(-1);
            rest.mirror(-1);
            free = round(rest.x[0], rest.z[0], mover, b.get(3), b, a, heightDepth);
        } else {
            free = polygons(angle, a, b, heightDepth);
        }
        arc = free;
        return TurningPolygon.covers(free, angle) ? Double.POSITIVE_INFINITY : TurningPolygon.fraction(free, angle);
    }

    private void load(ProjectedPolygon outline, Leaf leaf, PivotTurn turn) {
        if (leaf.kind.isDisc()) {
            outline.point(leaf.get(0) - turn.px, leaf.get(2) - turn.pz);
        } else {
            outline.load(leaf, turn.px, turn.pz);
        }
        outline.mirror(sign);
    }

    private double polygons(double angle, Leaf a, Leaf b, double heightDepth) {
        polygons.load(mover, rest);
        if (!polygons.near) {
            isApart = true;
            return polygons.free(angle);
        }
        boolean apart = polygons.gap > -polygons.error
                && !ExactPolygon.of(a.kind, a.row, a.at).touches(ExactPolygon.of(b.kind, b.row, b.at));
        if (!apart) {
            return -polygons.gap >= heightDepth - polygons.error ? Double.POSITIVE_INFINITY : polygons.free(angle);
        }
        isApart = true;
        for (int k = 0; k < polygons.normals(); k++) {
            if (polygons.isLeading(k) && !isBeyond(a, polygons.unitX(k), sign * polygons.unitZ(k), b)) {
                polygons.reject(k);
            }
        }
        return polygons.free(angle);
    }

    /** Whether a lies wholly beyond b in a direction; (nx, nz) is used as given, of any length. */
    private static boolean isBeyond(Leaf a, double nx, double nz, Leaf b) {
        ExactVector n = ExactVector.of(nx, 0, nz);
        return ExactExtent.of(n, b).gapTo(ExactExtent.of(n, a)) > 0;
    }

    private double round(
            double x, double z, ProjectedPolygon outline, double radius, Leaf a, Leaf b, double heightDepth) {
        disc.load(x, z, outline);
        double gap = disc.distance - radius;
        double error = disc.error + 32 * 0x1p-53 * radius;
        if (gap > error) {
            isApart = true;
            return disc.free(outline, radius, false);
        }
        boolean apart = gap >= -error && !ExactDisc.of(a, 0, 0, b, null).touches();
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
