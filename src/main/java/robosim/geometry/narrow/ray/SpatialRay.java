package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * A ray in space against one leaf.
 *
 * <p>Whether it hits is decided exactly for the stored numbers (of a direction as {@link BeamAxis} holds it). A distance is within 4 ulp of the largest of itself and the coordinates that it was computed from.
 */
public final class SpatialRay {
    private SpatialRay() {}

    /**
     * The distance in world units from the start to the nearest point of the leaf along the ray.
     *
     * @param j where the leaf's row begins
     * @return 0 where the ray starts inside a solid or on a triangle; {@code +Infinity} on a miss
     */
    public static double distance(BeamAxis ray, LeafKind kind, double[] row, int j, RayScratch s) {
        return switch (kind) {
            case UPRIGHT_BOX -> RayBox.upright(ray, row, j, s);
            case UPRIGHT_CYLINDER -> RayCylinder.distance(ray, s.cylinder.upright(row, j), s);
            case SPHERE -> RaySphere.distance(ray, row, j, s);
            case BOX -> RayBox.distance(ray, row, j, s);
            case CYLINDER -> RayCylinder.distance(ray, s.cylinder.turned(row, j), s);
            case TRIANGLE -> RayTriangle.distance(ray, row, j, s);
            case PRISM -> RayPrism.distance(ray, row, j, s);
            case UPRIGHT_CAPSULE -> RayCapsule.distance(ray, s.cylinder.about(row, j, 0, 1, 0), s);
            case CAPSULE -> RayCapsule.distance(ray, s.cylinder.turned(row, j), s);
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }
}
