package robosim.geometry.narrow.normal;

import static robosim.geometry.exact.VectorMath.U;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The outward surface normal of a leaf where a ray hits it.
 *
 * <p>The normal belongs to the face, among those towards the ray, whose plane or round side the point is nearest to or
 * farthest outside of: on the surface of a convex leaf, that is the face entered. The point is accurate to a rounding
 * of the distance travelled, which may exceed the leaf's thickness, so a face counts as near if it is within that. If
 * no face is that near, the ray started inside. The normal is then opposite to the ray's direction; so it is where
 * there is no normal (a segment hit end on, a point). If the ray grazes a round side to within rounding, the normal is
 * perpendicular to the ray. An instance belongs to one owner of queries.
 */
public final class Normals {
    /** How far rounding may put a hit below the surface, as a share of the coordinates and the distance: 2^-46. */
    private static final double DEPTH = 128 * U;

    private final NearestFace face = new NearestFace();

    /**
     * Writes the normal.
     *
     * @param ray its height is ignored in {@code PLANAR}
     * @param distance how far the ray travelled; 0 where it started on the leaf
     * @param normal receives three numbers, a unit vector; in {@code PLANAR} that of the projected leaf, horizontal
     */
    public void at(
            BeamAxis ray, double distance, LeafKind kind, double[] row, int j, double[] normal, Dimension dimension) {
        boolean isPlanar = dimension == Dimension.PLANAR;
        double px = ray.ox + distance * ray.ux();
        double py = isPlanar ? 0 : ray.oy + distance * ray.uy();
        double pz = ray.oz + distance * ray.uz();
        double size = VectorMath.largest(ray.ux(), ray.uy(), ray.uz());
        face.reset(px, py, pz, ray.ux() / size, isPlanar ? 0 : ray.uy() / size, ray.uz() / size);
        if (isPlanar) {
            PlanarFaces.offer(face, kind, row, j);
        } else {
            SpatialFaces.offer(face, kind, row, j);
        }
        double extent = VectorMath.largest(px, py, pz) + extent(kind, row, j) + distance;
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
