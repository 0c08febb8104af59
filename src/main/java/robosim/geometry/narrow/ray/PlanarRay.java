package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** A ray on the XZ plane against the projection of a leaf. */
public final class PlanarRay {
    private PlanarRay() {}

    /**
     * Distance along a ray, whose direction is level, to the nearest point of the leaf's projection.
     *
     * <p>Whether it hits is exact, except for turned cylinders, for which it is certified (no touch is missed).
     *
     * @return world units; 0 where the start is inside or on it, {@code +Infinity} on a miss
     */
    public static double distance(BeamAxis ray, LeafKind kind, double[] b, int j, RayScratch s) {
        return switch (kind) {
            case UPRIGHT_BOX -> RayRectangle.distance(ray, b, j);
            case UPRIGHT_CYLINDER, SPHERE, UPRIGHT_CAPSULE -> RayDisc.distance(ray, b[j], b[j + 2], b[j + Leaf.SIZE]);
            case CYLINDER -> RayOval.distance(ray, kind, b, j, s.planar.planarB);
            case CAPSULE -> stadium(ray, b, j, s);
            case BOX, TRIANGLE -> RayPolygon.distance(ray, kind, b, j, s);
            case PRISM -> RayPrism.flatDistance(ray, b, j, s);
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /** A capsule seen from above is a level capsule, hit at its own height. */
    private static double stadium(BeamAxis ray, double[] b, int j, RayScratch s) {
        double ax = b[j + 7];
        double az = b[j + 13];
        return ax == 0 && az == 0
                ? RayDisc.distance(ray, b[j], b[j + 2], b[j + Leaf.SIZE])
                : RayCapsule.distance(
                        s.level.from(ray, ray.ox, b[j + 1], ray.oz), s.cylinder.about(b, j, ax, 0, az), s);
    }
}
