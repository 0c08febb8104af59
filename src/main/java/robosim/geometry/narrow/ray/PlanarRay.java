package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** A ray on the XZ plane against the projection of a leaf. */
public final class PlanarRay {
    /** More than rounding, as a share of coordinates and of distances. */
    private static final double CLEAR = 0x1p-40;

    /** A smaller share of the direction across two sides may have lost too much to rounding. */
    private static final double STEEP = 0x1p-8;

    private PlanarRay() {}

    /**
     * Distance along a ray, whose direction is level, to the nearest point of the leaf's projection.
     *
     * <p>Whether it hits is exact for boxes, triangles, spheres, capsules and upright cylinders. It is certified (no
     * touch is missed) for octagons and turned cylinders.
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
            case PRISM -> missesOctagon(ray, b, j) ? Double.POSITIVE_INFINITY : RayPolygon.distance(ray, kind, b, j, s);
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

    /** Whether a ray passes by an octagon by far more than rounding: by the stretches in which it is between opposite sides. */
    private static boolean missesOctagon(BeamAxis ray, double[] b, int j) {
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        double size = Math.abs(ray.ox) + Math.abs(ray.oz);
        for (int k = 0; k < 4; k++) {
            size += Math.abs(b[j + k]);
        }
        double pad = CLEAR * size;
        double steep = STEEP * (Math.abs(ray.dx) + Math.abs(ray.dz));
        for (int pair = 0; pair < 8; pair += 2) {
            double at = pair == 0 ? ray.ox : pair == 2 ? ray.oz : pair == 4 ? ray.ox + ray.oz : ray.ox - ray.oz;
            double by = pair == 0 ? ray.dx : pair == 2 ? ray.dz : pair == 4 ? ray.dx + ray.dz : ray.dx - ray.dz;
            double low = b[j + pair] - at - pad;
            double high = b[j + pair + 1] - at + pad;
            if (Math.abs(by) > steep) {
                enter = Math.max(enter, (by > 0 ? low : high) / by);
                leave = Math.min(leave, (by > 0 ? high : low) / by);
            } else if (low > 0 || high < 0) {
                return false; // almost along the sides
            }
        }
        return enter - leave > CLEAR * (enter + Math.abs(leave));
    }
}
