package robosim.geometry.narrow.cone;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.ray.SpatialRay;

/**
 * A cone in space against one leaf: the nearest point of the leaf inside the closed cone, not a fan of rays.
 *
 * <p>Boxes, triangles and prisms: whether anything is in the cone is exact for the stored cosine, and the distance is
 * within 8 ulp of the largest coordinate. Spheres: equally exact, within 2^-90. Cylinders: a lower bound of the
 * distance, within 2^-40 of it (nearer than 2^-44 of offset and sizes: within as much); infinite only where they are
 * proved apart, while a cylinder that passes closer than 2^-44 of offset and sizes may count as a hit. Capsules: also a
 * lower bound, see {@link ConeCapsule}.
 */
public final class SpatialCone {
    private SpatialCone() {}

    /**
     * World units from the apex to the nearest point of the leaf inside the cone.
     *
     * @param beam its direction decides, not that of a rounded unit vector; and the cosine alone
     * @param limit a distance beyond which an answer is not needed
     * @return 0 where the apex is in the leaf; {@code +Infinity} where nothing of it is in the cone, and also where all that is
     *     is certainly beyond the limit
     */
    public static double distance(BeamAxis beam, LeafKind kind, double[] row, int j, double limit, ConeScratch s) {
        if (kind.isBox() && beam.sin > 0 && beam.cos < 1) {
            PlainConeBox box = s.cones().box;
            Cone cone = s.cones().cone;
            cone.set(beam, beam.oy);
            int known = box.look(cone, row, j, limit);
            if (known == PlainConeBox.BEYOND) {
                return Double.POSITIVE_INFINITY;
            }
            if (known == PlainConeBox.FOUND) {
                double axis =
                        box.isAxisNear() ? SpatialRay.distance(beam, kind, row, j, s.ray) : Double.POSITIVE_INFINITY;
                double near = s.cones().polytope.near(cone, box, axis, kind, row, j);
                if (near >= 0) {
                    return near;
                }
            }
        }
        if (kind == LeafKind.PRISM && beam.sin > 0 && beam.cos < 1) {
            ConeWorkspace w = s.cones();
            w.cone.set(beam, beam.oy);
            if (w.box.look(w.cone, w.around(row, j), 0, limit) == PlainConeBox.BEYOND
                    || w.box.look(w.cone, w.aroundDiagonally(row, j), 0, limit) == PlainConeBox.BEYOND) {
                return Double.POSITIVE_INFINITY;
            }
        }
        if (kind == LeafKind.SPHERE && isSurelyFarther(beam, row, j, limit)) {
            return Double.POSITIVE_INFINITY;
        }
        return all(beam, kind, row, j, limit, s);
    }

    /** Whether a ball is certainly farther than a limit, with the margin of {@link #isSurelyBeyond}. */
    private static boolean isSurelyFarther(BeamAxis beam, double[] row, int j, double limit) {
        double mx = row[j] - beam.ox;
        double my = row[j + 1] - beam.oy;
        double mz = row[j + 2] - beam.oz;
        double r = row[j + 3];
        double size = Math.abs(mx) + Math.abs(my) + Math.abs(mz) + r;
        return size < 0x1p400 && size > 0x1p-400 && VectorMath.length(mx, my, mz) - r - limit > 0x1p-28 * size;
    }

    /** The same, of all features of a leaf; of a prism those within the limit. */
    static double all(BeamAxis beam, LeafKind kind, double[] row, int j, double limit, ConeScratch s) {
        if ((kind.isBox() || kind.isRound()) && isSurelyBeyond(beam, kind, row, j)) {
            return Double.POSITIVE_INFINITY;
        }
        double axis = SpatialRay.distance(beam, kind, row, j, s.ray);
        if (axis == 0 || !(beam.sin > 0) || !(beam.cos < 1)) {
            return axis; // or so narrow that its stored cosine is that of a line
        }
        Cone cone = s.cones().cone;
        cone.set(beam, beam.oy);
        double nearest = switch (kind) {
            case UPRIGHT_BOX, BOX, TRIANGLE, PRISM -> s.cones().polytope.distance(cone, axis, limit, kind, row, j);
            case SPHERE -> ConeSphere.distance(cone, row, j);
            case UPRIGHT_CYLINDER -> s.cones().cylinder.distance(cone, row, j, 0, 1, 0);
            case CYLINDER -> s.cones().cylinder.distance(cone, row, j, row[j + 7], row[j + 10], row[j + 13]);
            case UPRIGHT_CAPSULE -> s.cones().capsule.distance(cone, row, j, 0, 1, 0);
            case CAPSULE -> s.cones().capsule.distance(cone, row, j, row[j + 7], row[j + 10], row[j + 13]);
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
        return Math.min(axis, nearest);
    }

    /**
     * The upper end of the bracket whose lower end was the last distance to a cylinder in a cone; meaningless where the
     * cone's axis itself hit the nearest leaf.
     */
    public static double upperEnd(ConeScratch s) {
        return s.cones().cylinder.upper();
    }

    /**
     * Whether a box or a round leaf certainly lies beyond the plane that touches the cone along the line
     * nearest to its centre m: with e the unit vector from the axis to m, the plane's normal is {@code n = e cos - u
     * sin}.
     *
     * <p>As m is not almost on the axis, e is off by at most 2^-30 of itself along the axis; u, sin, m and all else are
     * off by a few roundings of 2^-53. The leaf's own axes are of length 1 to 2^-30. The margin is 2^-28 of all
     * summands.
     */
    private static boolean isSurelyBeyond(BeamAxis beam, LeafKind kind, double[] row, int j) {
        double mx = row[j] - beam.ox;
        double my = row[j + 1] - beam.oy;
        double mz = row[j + 2] - beam.oz;
        // for leaves of two sizes, the sixth number only adds
        double sizes = row[j + 3] + (kind == LeafKind.SPHERE ? 0 : row[j + 4] + row[j + 5]);
        double size = Math.abs(mx) + Math.abs(my) + Math.abs(mz) + sizes;
        if (!(size < 0x1p400 && size > 0x1p-400)) { // where no square loses bits or overflows
            return false;
        }
        double ux = beam.ux();
        double uy = beam.uy();
        double uz = beam.uz();
        double cos = beam.cos;
        double ahead = mx * ux + my * uy + mz * uz;
        double ex = mx - ahead * ux;
        double ey = my - ahead * uy;
        double ez = mz - ahead * uz;
        double aside = VectorMath.length(ex, ey, ez);
        if (!(aside > 0x1p-20 * size)) {
            return false;
        }
        double sin = Math.sqrt((1 - cos) * (1 + cos));
        double nx = ex / aside * cos - ux * sin;
        double ny = ey / aside * cos - uy * sin;
        double nz = ez / aside * cos - uz * sin;
        double gap = nx * mx + ny * my + nz * mz - reach(nx, ny, nz, kind, row, j);
        return gap > 0x1p-28 * size;
    }

    /** The extent of a box or a round leaf from its centre along a unit vector. */
    private static double reach(double nx, double ny, double nz, LeafKind kind, double[] row, int j) {
        int r = j + Leaf.ROTATION;
        return switch (kind) {
            case UPRIGHT_BOX, BOX ->
                row[j + 3] * Math.abs(nx * row[r] + ny * row[r + 3] + nz * row[r + 6])
                        + row[j + 4] * Math.abs(nx * row[r + 1] + ny * row[r + 4] + nz * row[r + 7])
                        + row[j + 5] * Math.abs(nx * row[r + 2] + ny * row[r + 5] + nz * row[r + 8]);
            case UPRIGHT_CYLINDER -> row[j + 3] * Math.sqrt(nx * nx + nz * nz) + row[j + 4] * Math.abs(ny);
            case CYLINDER -> {
                double along = Math.abs(nx * row[r + 1] + ny * row[r + 4] + nz * row[r + 7]);
                // The axis is of length 1 to 2^-30, so that much is added to the square of the sine.
                double across = Math.sqrt(Math.max(0, (1 - along) * (1 + along)) + 0x1p-29);
                yield row[j + 3] * across + row[j + 4] * along;
            }
            case SPHERE -> row[j + 3];
            case UPRIGHT_CAPSULE -> row[j + 3] + row[j + 4] * Math.abs(ny);
            case CAPSULE -> row[j + 3] + row[j + 4] * Math.abs(nx * row[r + 1] + ny * row[r + 4] + nz * row[r + 7]);
            case TRIANGLE, PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }
}
