package robosim.geometry.narrow.cone;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.planar.DiscDisc;
import robosim.geometry.narrow.planar.PlanarBracket;
import robosim.geometry.narrow.planar.PlanarShape;
import robosim.geometry.narrow.planar.PointPolygon;
import robosim.geometry.narrow.ray.PlanarRay;

/**
 * A sector of the XZ plane (the beam of a sonar) against the projection of a leaf.
 *
 * <p>Doubles decide the certain cases: a shape that lies beyond one edge of the sector, and one whose nearest point
 * lies within. Shapes that the edges cut are computed in pairs of doubles, as flat shapes in the spatial cone whose
 * section the sector is. So the plane and space give the same verdicts, exact for the stored cosine.
 */
public final class PlanarCone {
    private static final double FILTER = FilterBound.bound(1.01);

    /** The square of a side that is negligible beside anything that is not tiny itself. */
    private static final double SHORT = 0x1p-900;

    private PlanarCone() {}

    /**
     * Distance from the apex to the nearest point of the leaf's projection within the sector about a level beam.
     *
     * <p>Never more than what {@link PlanarRay} answers for the axis, bit for bit, and exactly that where the cosine is
     * 1. Whether anything is within is exact for the stored cosine, except for a turned cylinder. Distances of boxes,
     * triangles, octagons and discs are within 8 ulp of the largest of the distance and the coordinates and sizes that
     * it was computed from.
     *
     * @param beam its cosine alone decides what is within
     * @param limit a distance beyond which an answer is not needed
     * @return world units; 0 where the apex is inside or on it, {@code +Infinity} where nothing is within, and also where all
     *     that is within is certainly beyond the limit
     */
    public static double distance(BeamAxis beam, LeafKind kind, double[] b, int j, double limit, ConeScratch s) {
        if (beam.cos >= 1) { // narrower than a cosine can express: only its axis
            return PlanarRay.distance(beam, kind, b, j, s.ray);
        }
        if (kind == LeafKind.UPRIGHT_BOX) {
            double known = plainBox(beam, b, j, limit, s);
            if (known >= 0) {
                return known;
            }
        }
        if (kind == LeafKind.PRISM) {
            ConeWorkspace w = s.cones();
            w.cone.set(beam, 0);
            if (w.sectorBox.look(w.cone, w.around(b, j), 0, limit) == PlainSectorBox.BEYOND
                    || w.sectorBox.look(w.cone, w.aroundDiagonally(b, j), 0, limit) == PlainSectorBox.BEYOND) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return all(beam, kind, b, j, limit, s);
    }

    /** The distance of an upright box, where plain numbers know which of its points is nearest; else below 0. */
    private static double plainBox(BeamAxis beam, double[] b, int j, double limit, ConeScratch s) {
        Cone cone = s.cones().cone;
        cone.set(beam, 0);
        PlainSectorBox box = s.cones().sectorBox;
        return switch (box.look(cone, b, j, limit)) {
            case PlainSectorBox.BEYOND -> Double.POSITIVE_INFINITY;
            case PlainSectorBox.HELD -> {
                s.sector.set(beam);
                double within = plainPolygon(beam, LeafKind.UPRIGHT_BOX, b, j, s);
                yield within < 0 ? clipped(beam, LeafKind.UPRIGHT_BOX, b, j, limit, s) : within;
            }
            case PlainSectorBox.CROSSED -> {
                flatten(LeafKind.UPRIGHT_BOX, b, j, s.leaf.flat);
                double crossed =
                        s.cones().polytope.flatEdge(cone, box.from(), box.to(), LeafKind.UPRIGHT_BOX, s.leaf.flat, 0);
                yield crossed <= box.atMost() ? crossed : -1;
            }
            default -> -1;
        };
    }

    /** The same, of all points of a leaf; of an octagon those within the limit. */
    static double all(BeamAxis beam, LeafKind kind, double[] b, int j, double limit, ConeScratch s) {
        s.sector.set(beam);
        double within = switch (kind.fromAbove()) {
            case DISC -> disc(beam, b, j, s);
            case POLYGON -> plainPolygon(beam, kind, b, j, s);
            case OVAL -> oval(beam, kind, b, j, s);
            case TRIANGLES, CELLS -> throw kind.refused();
        };
        if (within < 0) {
            return clipped(beam, kind, b, j, limit, s); // that of the axis is one of these
        }
        // A miss by the exact shapes holds for the axis too; for a turned cylinder each is certified separately.
        boolean isCertain =
                within == 0 || (within == Double.POSITIVE_INFINITY && kind.fromAbove() != LeafKind.FromAbove.OVAL);
        return isCertain ? within : Math.min(within, PlanarRay.distance(beam, kind, b, j, s.ray));
    }

    private static double disc(BeamAxis beam, double[] b, int j, ConeScratch s) {
        PlanarSector sector = s.sector;
        double mx = b[j] - beam.ox;
        double mz = b[j + 2] - beam.oz;
        double r = b[j + Leaf.SIZE];
        if (sector.surelyHolds(mx, mz, 0) || DiscDisc.touch(beam.ox, beam.oz, 0, b[j], b[j + 2], r)) {
            return DiscDisc.distance(beam.ox, beam.oz, 0, b[j], b[j + 2], r);
        }
        if (sector.isSurelyBeyond(mx, mz, r)) {
            return Double.POSITIVE_INFINITY;
        }
        flatten(LeafKind.SPHERE, b, j, s.leaf.flat);
        s.cones().cone.set(beam, 0);
        return ConeSphere.distance(s.cones().cone, s.leaf.flat, 0);
    }

    /** The distance of a polygon where doubles are sure of it, or below 0; not that along the axis. */
    private static double plainPolygon(BeamAxis beam, LeafKind kind, double[] b, int j, ConeScratch s) {
        PlanarSector sector = s.sector;
        PlanarShape q = s.planar.planarB;
        q.set(kind, b, j, beam.ox, beam.oz);
        if (!q.isTiny()) {
            int side = PointPolygon.side(q, FILTER * q.error);
            if (side > 0) {
                return 0;
            }
            if (side < 0 && sector.isSurelyBeyond(q)) {
                return Double.POSITIVE_INFINITY;
            }
            if (side < 0) {
                nearest(q);
                if (sector.surelyHolds(q.pointX, q.pointZ, q.error)) {
                    return Math.sqrt(q.pointX * q.pointX + q.pointZ * q.pointZ);
                }
            }
        }
        return -1;
    }

    /** The distance of a polygon that an edge of the sector may cut. */
    private static double clipped(BeamAxis beam, LeafKind kind, double[] b, int j, double limit, ConeScratch s) {
        double axis = PlanarRay.distance(beam, kind, b, j, s.ray);
        if (axis == 0) {
            return 0;
        }
        flatten(kind, b, j, s.leaf.flat);
        s.cones().cone.set(beam, 0);
        return s.cones().polytope.flat(s.cones().cone, axis, limit, kind, s.leaf.flat, 0);
    }

    /** The projection as a leaf of height 0 in the plane y = 0. */
    private static void flatten(LeafKind kind, double[] b, int j, double[] out) {
        System.arraycopy(b, j, out, 0, Leaf.STRIDE);
        switch (kind) {
            case TRIANGLE -> {
                out[1] = 0;
                out[4] = 0;
                out[7] = 0;
            }
            case PRISM -> {
                out[8] = 0;
                out[9] = 0;
            }
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, SPHERE, BOX, CYLINDER, UPRIGHT_CAPSULE, CAPSULE -> {
                out[1] = 0;
                for (int k = Leaf.ROTATION + 3; k < Leaf.ROTATION + 6; k++) {
                    out[k] = 0;
                }
            }
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        }
    }

    // Stores the point of the outline nearest to the apex in q's point.
    private static void nearest(PlanarShape q) {
        q.pointX = q.x[0];
        q.pointZ = q.z[0];
        double least = q.pointX * q.pointX + q.pointZ * q.pointZ;
        int last = q.count - 1;
        for (int k = 0; k <= last; k++) {
            int previous = k == 0 ? last : k - 1;
            double ax = q.x[previous];
            double az = q.z[previous];
            double bx = q.x[k];
            double bz = q.z[k];
            double square = bx * bx + bz * bz;
            if (square < least) {
                least = square;
                q.pointX = bx;
                q.pointZ = bz;
            }
            double ex = q.sideX[k];
            double ez = q.sideZ[k];
            double length = ex * ex + ez * ez;
            // The foot of the apex on the side's line, if it is on the side.
            if (ex * ax + ez * az < 0 && ex * bx + ez * bz > 0 && length > SHORT) {
                double past = ax * ez - az * ex;
                double turn = past / length;
                if (past * turn < least) {
                    least = past * turn;
                    q.pointX = ez * turn;
                    q.pointZ = -ex * turn;
                }
            }
        }
    }

    private static double oval(BeamAxis beam, LeafKind kind, double[] b, int j, ConeScratch s) {
        PlanarShape apex = s.planar.planarA;
        PlanarShape q = s.planar.planarB;
        apex.point();
        q.set(kind, b, j, beam.ox, beam.oz);
        PlanarBracket bracket = s.planar.planarBracket;
        bracket.find(apex, q, false);
        if (!bracket.isApart()) {
            return 0;
        }
        return s.cones().oval.distance(beam, b, j, q, bracket.distance());
    }
}
