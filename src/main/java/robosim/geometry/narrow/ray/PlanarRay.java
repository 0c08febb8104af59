package robosim.geometry.narrow.ray;

import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** A ray on the XZ plane against the projection of a leaf. */
public final class PlanarRay {
    // Directions in this range are used as given; others are first scaled by a power of two.
    private static final double LEAST = 0x1p-200;
    private static final double MOST = 0x1p200;

    private PlanarRay() {}

    /**
     * Distance from (ox, oz) along (ux, uz), a direction of any length but zero, to the nearest point of the leaf's
     * projection.
     *
     * <p>Whether it hits is exact for boxes, triangles, spheres, capsules and upright cylinders. It is certified (no
     * touch is missed) for octagons and turned cylinders.
     *
     * @return world units; 0 where the start is inside or on it, {@code +Infinity} on a miss
     */
    public static double distance(
            double ox, double oz, double ux, double uz, LeafKind kind, double[] b, int j, RayScratch s) {
        double size = Math.max(Math.abs(ux), Math.abs(uz));
        if (!(size >= LEAST && size <= MOST)) {
            int shift = -Math.getExponent(size);
            // in two steps, as one factor may be outside the range of a double
            ux = Math.scalb(Math.scalb(ux, shift / 2), shift - shift / 2);
            uz = Math.scalb(Math.scalb(uz, shift / 2), shift - shift / 2);
        }
        return scaled(ox, oz, ux, uz, kind, b, j, s);
    }

    /** The same for a direction of moderate length. */
    public static double scaled(
            double ox, double oz, double ux, double uz, LeafKind kind, double[] b, int j, RayScratch s) {
        return switch (kind) {
            case UPRIGHT_BOX -> RayRectangle.distance(ox, oz, ux, uz, b, j);
            case UPRIGHT_CYLINDER, SPHERE, UPRIGHT_CAPSULE ->
                RayDisc.distance(ox, oz, ux, uz, b[j], b[j + 2], b[j + Leaf.SIZE]);
            case CYLINDER -> RayOval.distance(ox, oz, ux, uz, kind, b, j, s.planar.planarB);
            case CAPSULE -> stadium(ox, oz, ux, uz, b, j, s);
            case BOX, TRIANGLE, PRISM -> RayPolygon.distance(ox, oz, ux, uz, kind, b, j, s);
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /** A capsule seen from above is a level capsule, hit at its own height. */
    private static double stadium(double ox, double oz, double ux, double uz, double[] b, int j, RayScratch s) {
        double ax = b[j + 7];
        double az = b[j + 13];
        return ax == 0 && az == 0
                ? RayDisc.distance(ox, oz, ux, uz, b[j], b[j + 2], b[j + Leaf.SIZE])
                : RayCapsule.distance(ox, b[j + 1], oz, ux, 0, uz, b, j, ax, 0, az, s);
    }
}
