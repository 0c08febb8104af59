package robosim.geometry.narrow.ray;

import static robosim.geometry.exact.VectorMath.U;

import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The outward surface normal of a leaf where a ray meets it.
 *
 * <p>The normal belongs to the face, facing the ray, whose plane (or round side) the point is nearest to or farthest
 * outside of: on the surface of a convex leaf that is the face entered. The place is known to a rounding of the way to it,
 * which may be more than the leaf is thick; so a face counts as near that is within that. A point that no face is that near
 * to is one from which a ray started inside; it gets the opposite of the ray's direction, and so does a place that has no
 * normal (a segment met end on, a point). Of a round side that only grazes the ray to rounding, the normal is square to it.
 */
public final class Normals {
    /** How far below the surface rounding may put a hit, as a share of the coordinates and the way: a generous 2^-46. */
    private static final double DEPTH = 128 * U;

    private Normals() {}

    /**
     * Writes the normal.
     *
     * @param px the place that was hit
     * @param distance how far the ray came; 0 where it started there
     * @param ux direction of the ray, any length but zero; its height is not looked at in {@code PLANAR}
     * @param normal gets three numbers, a unit vector; in {@code PLANAR} that of the projected leaf, horizontal
     */
    public static void at(
            double px,
            double py,
            double pz,
            double distance,
            double ux,
            double uy,
            double uz,
            LeafKind kind,
            double[] row,
            int j,
            double[] normal,
            Dimension dimension,
            RayScratch s) {
        boolean isPlanar = dimension == Dimension.PLANAR;
        NearestFace face = s.face;
        double size = VectorMath.largest(ux, uy, uz);
        face.reset(px, isPlanar ? 0 : py, pz, ux / size, isPlanar ? 0 : uy / size, uz / size);
        if (isPlanar) {
            PlanarFaces.offer(face, kind, row, j);
        } else {
            SpatialFaces.offer(face, kind, row, j);
        }
        double extent = VectorMath.largest(px, isPlanar ? 0 : py, pz) + extent(kind, row, j) + distance;
        face.answer(-DEPTH * extent, distance > 0, normal);
    }

    private static double extent(LeafKind kind, double[] row, int j) {
        double extent = 0;
        for (int i = 0; i < kind.lengths(); i++) {
            extent = Math.max(extent, Math.abs(row[j + i]));
        }
        return extent;
    }
}
