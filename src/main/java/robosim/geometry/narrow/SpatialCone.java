package robosim.geometry.narrow;

/**
 * A cone in space against one leaf: the nearest point of the leaf inside the closed cone, never a fan of rays.
 *
 * <p>Boxes, triangles and prisms: whether anything is in the cone is exact for the stored cosine, and the distance is
 * within 8 ulp of the largest coordinate. Spheres: exact likewise, within 2^-90. Cylinders: a lower bound of the distance, within
 * 2^-40 of it; infinite only where they are proved apart.
 */
public final class SpatialCone {
    private SpatialCone() {}

    /**
     * World units from the apex to the nearest point of the leaf inside the cone.
     *
     * @param ux the cone's axis, of any length but zero
     * @param halfCos cosine of half the opening angle, between 0 and 1, both excluded; it is what decides
     * @param halfSin sine of the same
     * @return 0 where the apex is in the leaf; {@code +Infinity} where nothing of it is in the cone
     */
    public static double distance(
            double ox,
            double oy,
            double oz,
            double ux,
            double uy,
            double uz,
            double halfCos,
            double halfSin,
            int kind,
            double[] row,
            int j,
            Scratch s) {
        double axis = SpatialRay.distance(ox, oy, oz, ux, uy, uz, kind, row, j, s);
        if (axis == 0 || !(halfSin > 0)) {
            return axis;
        }
        Cone cone = s.cone;
        double size = RayMath.largest(ux, uy, uz);
        int power = size > 0x1p100 || size < 0x1p-100 ? -Math.getExponent(size) : 0;
        cone.set(
                ox,
                oy,
                oz,
                SpatialRay.scale(ux, power),
                SpatialRay.scale(uy, power),
                SpatialRay.scale(uz, power),
                halfCos);
        double nearest = switch (kind) {
            case Leaf.UPRIGHT_BOX, Leaf.BOX, Leaf.TRIANGLE, Leaf.PRISM ->
                s.conePolytope.distance(cone, axis, kind, row, j);
            case Leaf.SPHERE -> ConeSphere.distance(cone, row, j);
            case Leaf.UPRIGHT_CYLINDER -> s.coneCylinder.distance(cone, row, j, 0, 1, 0);
            case Leaf.CYLINDER -> s.coneCylinder.distance(cone, row, j, row[j + 7], row[j + 10], row[j + 13]);
            default -> throw new IllegalArgumentException("kind must be one of Leaf's (got: " + kind + ")");
        };
        return Math.min(axis, nearest);
    }
}
