package robosim.geometry.narrow.cone;

import robosim.geometry.exact.Rotations;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;

/** Working memory for queries about cones. */
final class ConeWorkspace {
    /** More than rounding moves a side, as a share of the coordinates. */
    private static final double ROUNDING = 0x1p-48;

    final Cone cone = new Cone();
    final PlainConeBox box = new PlainConeBox();
    final PlainSectorBox sectorBox = new PlainSectorBox();
    final ConePolytope polytope = new ConePolytope();
    final ConeCylinder cylinder = new ConeCylinder();
    final SectorOval oval = new SectorOval();
    final ConeCapsule capsule = new ConeCapsule();

    /** Where a prism ends up as a box; see {@link #around} and {@link #aroundDiagonally}. */
    private final double[] upright = new double[Leaf.STRIDE];

    private final double[] diagonal = new double[Leaf.STRIDE];

    ConeWorkspace() {
        Rotations.identity(upright, Leaf.ROTATION);
        Rotations.identity(diagonal, Leaf.ROTATION);
        diagonal[Leaf.ROTATION] = VectorMath.HALF_ROOT;
        diagonal[Leaf.ROTATION + 2] = -VectorMath.HALF_ROOT;
        diagonal[Leaf.ROTATION + 6] = VectorMath.HALF_ROOT;
        diagonal[Leaf.ROTATION + 8] = VectorMath.HALF_ROOT;
    }

    /** The box along the axes that holds a prism. */
    double[] around(double[] row, int j) {
        upright[0] = row[j] / 2 + row[j + 1] / 2;
        upright[1] = row[j + 8] / 2 + row[j + 9] / 2;
        upright[2] = row[j + 2] / 2 + row[j + 3] / 2;
        upright[3] = half(row, j);
        upright[4] = half(row, j + 8);
        upright[5] = half(row, j + 2);
        return upright;
    }

    /** The box at 45 degrees to them. */
    double[] aroundDiagonally(double[] row, int j) {
        double sum = row[j + 4] / 2 + row[j + 5] / 2;
        double difference = row[j + 6] / 2 + row[j + 7] / 2;
        double more =
                ROUNDING * (Math.abs(row[j]) + Math.abs(row[j + 1]) + Math.abs(row[j + 2]) + Math.abs(row[j + 3]));
        diagonal[0] = sum / 2 + difference / 2;
        diagonal[1] = upright[1];
        diagonal[2] = sum / 2 - difference / 2;
        diagonal[3] = half(row, j + 4) * VectorMath.HALF_ROOT + more;
        diagonal[4] = upright[4];
        diagonal[5] = half(row, j + 6) * VectorMath.HALF_ROOT + more;
        return diagonal;
    }

    /** Half a range of coordinates, rounded outward. */
    private static double half(double[] row, int pair) {
        return row[pair + 1] / 2 - row[pair] / 2 + ROUNDING * (Math.abs(row[pair]) + Math.abs(row[pair + 1]));
    }
}
