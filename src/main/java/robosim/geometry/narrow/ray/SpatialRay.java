package robosim.geometry.narrow.ray;

import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * A ray in space against one leaf.
 *
 * <p>Whether it hits is decided exactly for the stored numbers (a direction longer than 2^100 is first scaled down by a
 * power of two). A distance is within 4 ulp of the largest of itself and the coordinates that it was computed from.
 */
public final class SpatialRay {
    private SpatialRay() {}

    /**
     * The distance in world units from the start to the nearest point of the leaf along the ray.
     *
     * @param ux direction of any length but zero
     * @param j where the leaf's row begins
     * @return 0 where the ray starts inside a solid or on a triangle; {@code +Infinity} on a miss
     */
    public static double distance(
            double ox,
            double oy,
            double oz,
            double ux,
            double uy,
            double uz,
            LeafKind kind,
            double[] row,
            int j,
            RayScratch s) {
        double size = VectorMath.largest(ux, uy, uz);
        if (size > 0x1p100 || size < 0x1p-100) {
            int power = -Math.getExponent(size);
            return scaled(ox, oy, oz, scale(ux, power), scale(uy, power), scale(uz, power), kind, row, j, s);
        }
        return scaled(ox, oy, oz, ux, uy, uz, kind, row, j, s);
    }

    /**
     * The same for an upright box, and a direction of moderate length, where the ray certainly enters by a vertical face, 0
     * for one across the own X, 2 for one across the own Z.
     */
    public static double uprightFace(
            double ox,
            double oy,
            double oz,
            double ux,
            double uy,
            double uz,
            double[] row,
            int j,
            int face,
            RayScratch s) {
        return RayBox.uprightFace(ox, oy, oz, ux, uy, uz, row, j, face, s);
    }

    public static double scale(double value, int power) {
        if (power == 0) {
            return value;
        }
        // In two steps, because for a subnormal the factor itself may not be representable.
        int first = power / 2;
        return Math.scalb(Math.scalb(value, first), power - first);
    }

    private static double scaled(
            double ox,
            double oy,
            double oz,
            double ux,
            double uy,
            double uz,
            LeafKind kind,
            double[] row,
            int j,
            RayScratch s) {
        return switch (kind) {
            case UPRIGHT_BOX -> RayBox.upright(ox, oy, oz, ux, uy, uz, row, j, s);
            case UPRIGHT_CYLINDER -> RayCylinder.upright(ox, oy, oz, ux, uy, uz, row, j, s);
            case SPHERE -> RaySphere.distance(ox, oy, oz, ux, uy, uz, row, j, s);
            case BOX -> RayBox.distance(ox, oy, oz, ux, uy, uz, row, j, s);
            case CYLINDER -> RayCylinder.distance(ox, oy, oz, ux, uy, uz, row, j, s);
            case TRIANGLE -> RayTriangle.distance(ox, oy, oz, ux, uy, uz, row, j, s);
            case PRISM -> RayPrism.distance(ox, oy, oz, ux, uy, uz, row, j, s);
            case UPRIGHT_CAPSULE -> RayCapsule.distance(ox, oy, oz, ux, uy, uz, row, j, 0, 1, 0, s);
            case CAPSULE ->
                RayCapsule.distance(ox, oy, oz, ux, uy, uz, row, j, row[j + 7], row[j + 10], row[j + 13], s);
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }
}
