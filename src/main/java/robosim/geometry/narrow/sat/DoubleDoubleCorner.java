package robosim.geometry.narrow.sat;

import robosim.geometry.exact.DoubleDoubleSum;
import robosim.geometry.narrow.leaf.Leaf;

/** One corner of a polytope in pairs of doubles. */
public final class DoubleDoubleCorner {
    /**
     * Writes a corner relative to an origin; in the plane the second coordinate is 0.
     *
     * @param source for a box, the columns added, as bits, the others being subtracted; for a triangle, where the
     * corner begins in its row
     */
    public void find(boolean flat, Leaf leaf, int source, double ox, double oy, double oz, DoubleDoubleSum[] out) {
        switch (leaf.kind) {
            case TRIANGLE -> {
                difference(leaf.row[source], ox, out[0]);
                difference(flat ? 0 : leaf.row[source + 1], flat ? 0 : oy, out[1]);
                difference(leaf.row[source + 2], oz, out[2]);
            }
            case SPHERE, UPRIGHT_CYLINDER, UPRIGHT_CAPSULE -> {
                difference(leaf.get(0), ox, out[0]);
                difference(flat ? 0 : leaf.get(1), flat ? 0 : oy, out[1]);
                difference(leaf.get(2), oz, out[2]);
            }
            case UPRIGHT_BOX, BOX -> {
                difference(leaf.get(0), ox, out[0]);
                difference(flat ? 0 : leaf.get(1), flat ? 0 : oy, out[1]);
                difference(leaf.get(2), oz, out[2]);
                for (int k = 0; k < 3; k++) {
                    double half = (source >> k & 1) == 0 ? -leaf.get(3 + k) : leaf.get(3 + k);
                    addProduct(half, leaf.get(6 + k), out[0]);
                    addProduct(half, flat ? 0 : leaf.get(9 + k), out[1]);
                    addProduct(half, leaf.get(12 + k), out[2]);
                }
            }
            case CYLINDER, CAPSULE, PRISM, MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
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
