package robosim.geometry.narrow.sat;

import robosim.geometry.exact.DoubleDoubleSum;
import robosim.geometry.narrow.leaf.LeafKind;

/** One corner of a polytope in pairs of doubles. */
public final class DoubleDoubleCorner {
    /**
     * Writes a corner relative to an origin; in the plane the second coordinate is 0.
     *
     * @param source for a box, the columns added, as bits, the others being subtracted; for a triangle, where the
     * corner begins in its row
     */
    public void find(
            boolean flat,
            LeafKind kind,
            double[] row,
            int at,
            int source,
            double ox,
            double oy,
            double oz,
            DoubleDoubleSum[] out) {
        switch (kind) {
            case TRIANGLE -> {
                difference(row[source], ox, out[0]);
                difference(flat ? 0 : row[source + 1], flat ? 0 : oy, out[1]);
                difference(row[source + 2], oz, out[2]);
            }
            case SPHERE, UPRIGHT_CYLINDER, UPRIGHT_CAPSULE -> {
                difference(row[at], ox, out[0]);
                difference(flat ? 0 : row[at + 1], flat ? 0 : oy, out[1]);
                difference(row[at + 2], oz, out[2]);
            }
            case UPRIGHT_BOX, BOX -> {
                difference(row[at], ox, out[0]);
                difference(flat ? 0 : row[at + 1], flat ? 0 : oy, out[1]);
                difference(row[at + 2], oz, out[2]);
                for (int k = 0; k < 3; k++) {
                    double half = (source >> k & 1) == 0 ? -row[at + 3 + k] : row[at + 3 + k];
                    addProduct(half, row[at + 6 + k], out[0]);
                    addProduct(half, flat ? 0 : row[at + 9 + k], out[1]);
                    addProduct(half, row[at + 12 + k], out[2]);
                }
            }
            case CYLINDER, CAPSULE, PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        }
    }

    public static void difference(double p, double q, DoubleDoubleSum out) {
        out.clear();
        out.add(p, 0);
        out.add(-q, 0);
    }

    private static void addProduct(double p, double q, DoubleDoubleSum out) {
        if (p != 0 && q != 0) {
            out.addProduct(p, 0, q, 0);
        }
    }
}
