package robosim.geometry.narrow.distance;

import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The least distance from a sphere to another sphere, a cylinder, a box or a triangle in closed form, in
 * double-doubles: the distance from its centre less its radius, with an error of a few ulp of the distance itself
 * however close the two are.
 *
 * <p>A double-double operation is off by 2^-100 of its terms, and no distance here has more than 50 in a row: 2^-92 of
 * the sizes and offsets is subtracted, so that the result is at most the truth.
 */
final class SphereDistance {
    private static final double PAIRS_ERROR = 0x1p-92;

    /** Below this the pairs' products could vanish. */
    private static final double SMALL = 0x1p-200;

    /** A triangle whose two edges span less than this sine is told by its edges, between which it is as thin as that. */
    private static final double NEEDLE = 0x1p-46;

    private static final int AWAY = 0;
    private static final int AXIS = 3;
    private static final int CROSS = 6;
    private static final int SQUARE = 9;
    private static final int LENGTH = 10;
    private static final int ALONG = 11;
    private static final int ACROSS = 12;
    private static final int TEMPORARY = 13; // and the next
    private static final int EDGE = 15;
    private static final int OTHER = 18;
    private static final int NORMAL = 21;
    private static final int PART = 24;
    private static final int SPAN = 27; // three
    private static final int LEAST = 30;
    private static final int VECTOR = 31;

    private final DoubleDoubles p = new DoubleDoubles(36);
    private double extent;
    private double doubt;

    /** Whether the kernel is for this leaf, and large enough for it. */
    static boolean isFor(Leaf sphere, Leaf leaf) {
        return switch (leaf.kind) {
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, SPHERE, BOX, CYLINDER, TRIANGLE -> size(sphere, leaf) > SMALL;
            case PRISM, UPRIGHT_CAPSULE, CAPSULE -> false;
            case MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        };
    }

    private static double size(Leaf sphere, Leaf leaf) {
        double size = 0;
        if (leaf.kind.layout() == LeafKind.Layout.CORNERS) {
            for (int k = 0; k < 9; k += 3) {
                size = Math.max(size, offset(sphere, leaf, k));
            }
        } else {
            size = offset(sphere, leaf, 0);
            for (int k = Leaf.SIZE; k < leaf.kind.lengths(); k++) {
                size += leaf.get(k);
            }
        }
        return size + sphere.get(Leaf.SIZE);
    }

    private static double offset(Leaf sphere, Leaf leaf, int k) {
        return VectorMath.largest(
                leaf.get(k) - sphere.get(0), leaf.get(k + 1) - sphere.get(1), leaf.get(k + 2) - sphere.get(2));
    }

    /**
     * At most 4 ulp of the distance, or 2^-60 of the sizes and the offset, below the truth, never above it, and 0 in
     * contact; for a triangle whose edges span a sine below 2^-30 at most 2^-44 of them below.
     */
    double between(Leaf sphere, Leaf leaf) {
        extent = size(sphere, leaf);
        doubt = PAIRS_ERROR * extent;
        for (int k = 0; k < 3; k++) {
            p.difference(AWAY + k, sphere.get(k), leaf.get(k));
        }
        switch (leaf.kind) {
            case SPHERE -> centre();
            case UPRIGHT_CYLINDER -> cylinder(leaf.row, leaf.at, 0, 1, 0);
            case CYLINDER -> cylinder(leaf.row, leaf.at, leaf.get(7), leaf.get(10), leaf.get(13));
            case TRIANGLE -> triangle(leaf.row, leaf.at);
            case UPRIGHT_BOX, BOX -> box(leaf.row, leaf.at);
            case PRISM, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        }
        p.difference(TEMPORARY, sphere.get(Leaf.SIZE), leaf.kind == LeafKind.SPHERE ? -leaf.get(Leaf.SIZE) : 0);
        p.subtract(LEAST, LEAST, TEMPORARY);
        double distance = p.get(LEAST) - doubt;
        return Math.max(0, Math.nextDown(Math.nextDown(distance)));
    }

    private void centre() {
        p.dot(LEAST, AWAY, AWAY, TEMPORARY);
        p.root(LEAST, LEAST);
    }

    /** Beyond a cap by {@code |x.a| / |a| - h |a|}, beyond the side by {@code |x cross a| / |a| - r}; either may be none. */
    private void cylinder(double[] row, int j, double ax, double ay, double az) {
        p.set(AXIS, ax);
        p.set(AXIS + 1, ay);
        p.set(AXIS + 2, az);
        p.dot(SQUARE, AXIS, AXIS, TEMPORARY);
        p.root(LENGTH, SQUARE);
        p.dot(ALONG, AWAY, AXIS, TEMPORARY);
        if (p.get(ALONG) < 0) {
            p.negate(ALONG);
        }
        p.multiply(TEMPORARY, SQUARE, row[j + 4]);
        p.subtract(ALONG, ALONG, TEMPORARY);
        p.divide(ALONG, ALONG, LENGTH);
        p.cross(CROSS, AWAY, AXIS, TEMPORARY);
        p.dot(ACROSS, CROSS, CROSS, TEMPORARY);
        p.root(ACROSS, ACROSS);
        p.divide(ACROSS, ACROSS, LENGTH);
        p.set(TEMPORARY, row[j + 3]);
        p.subtract(ACROSS, ACROSS, TEMPORARY);
        square(ALONG);
        square(ACROSS);
        p.add(LEAST, ALONG, ACROSS);
        p.root(LEAST, LEAST);
    }

    /** Squares a number, or makes it 0 where it is negative. */
    private void square(int i) {
        if (p.get(i) > 0) {
            p.multiply(i, i, i);
        } else {
            p.set(i, 0);
        }
    }

    /**
     * The place {@code sum t_k R_k}, |t_k| at most the half size, with the least distance: one t after the other is made
     * the best while the others stay (Gauss and Seidel). Columns that are square to each other to 1e-9 bring each round
     * 10^-18 closer, and the distance by the square of that.
     */
    private void box(double[] row, int j) {
        p.set(SPAN, 0);
        p.set(SPAN + 1, 0);
        p.set(SPAN + 2, 0);
        for (int n = 0; n < 9; n++) {
            int k = n % 3;
            remainder(row, j);
            column(row, j, k);
            p.dot(ALONG, VECTOR, AXIS, TEMPORARY);
            p.dot(SQUARE, AXIS, AXIS, TEMPORARY);
            p.divide(ALONG, ALONG, SQUARE);
            p.add(SPAN + k, SPAN + k, ALONG);
            double half = row[j + Leaf.SIZE + k];
            double t = p.get(SPAN + k);
            double rest = p.rest(SPAN + k);
            if (t > half || (t == half && rest > 0)) {
                p.set(SPAN + k, half);
            } else if (t < -half || (t == -half && rest < 0)) {
                p.set(SPAN + k, -half);
            }
        }
        remainder(row, j);
        p.dot(LEAST, VECTOR, VECTOR, TEMPORARY);
        p.root(LEAST, LEAST);
    }

    // From the place to the sphere's centre.
    private void remainder(double[] row, int j) {
        for (int k = 0; k < 3; k++) {
            p.set(VECTOR + k, p.get(AWAY + k), p.rest(AWAY + k));
        }
        for (int k = 0; k < 3; k++) {
            column(row, j, k);
            for (int m = 0; m < 3; m++) {
                p.multiply(TEMPORARY, SPAN + k, AXIS + m);
                p.subtract(VECTOR + m, VECTOR + m, TEMPORARY);
            }
        }
    }

    private void column(double[] row, int j, int k) {
        p.set(AXIS, row[j + 6 + k]);
        p.set(AXIS + 1, row[j + 9 + k]);
        p.set(AXIS + 2, row[j + 12 + k]);
    }

    private void triangle(double[] row, int j) {
        p.set(LEAST, Double.MAX_VALUE);
        for (int k = 0; k < 3; k++) {
            edge(row, j, k);
        }
        for (int m = 0; m < 3; m++) {
            p.difference(EDGE + m, row[j + 3 + m], row[j + m]);
            p.difference(OTHER + m, row[j + 6 + m], row[j + m]);
        }
        p.cross(NORMAL, EDGE, OTHER, TEMPORARY);
        p.dot(SQUARE, NORMAL, NORMAL, TEMPORARY);
        p.root(LENGTH, SQUARE);
        double spanned = length(EDGE) * length(OTHER);
        double sine = p.get(LENGTH) / spanned;
        if (sine > NEEDLE) {
            doubt += PAIRS_ERROR * extent / sine;
            side();
        } else if (sine > 0) {
            doubt += 2 * sine * extent;
        }
        p.root(LEAST, LEAST);
    }

    private double length(int vector) {
        return VectorMath.length(p.get(vector), p.get(vector + 1), p.get(vector + 2));
    }

    private void edge(double[] row, int j, int k) {
        int from = j + 3 * k;
        int to = j + 3 * ((k + 1) % 3);
        p.set(SQUARE, 0);
        for (int m = 0; m < 3; m++) {
            p.difference(EDGE + m, row[to + m], row[from + m]);
            // The centre from this corner: from the first, less the way between the corners.
            p.difference(VECTOR + m, row[from + m], row[j + m]);
            p.subtract(VECTOR + m, AWAY + m, VECTOR + m);
        }
        p.dot(SQUARE, EDGE, EDGE, TEMPORARY);
        p.dot(ALONG, VECTOR, EDGE, TEMPORARY);
        if (p.get(ALONG) > 0 && p.get(SQUARE) > 0) {
            p.divide(ALONG, ALONG, SQUARE);
            if (p.get(ALONG) > 1) {
                p.set(ALONG, 1);
            }
            p.negate(ALONG);
            p.advance(VECTOR, VECTOR, ALONG, EDGE, TEMPORARY);
        }
        p.dot(ACROSS, VECTOR, VECTOR, TEMPORARY);
        if (p.get(ACROSS) < p.get(LEAST)) {
            p.set(LEAST, p.get(ACROSS), p.rest(ACROSS));
        }
    }

    /** The distance from the plane, where the centre's foot is in the triangle. */
    private void side() {
        // w = s e + t f + n: s = (w x f).n / n.n, t = (e x w).n / n.n.
        p.cross(PART, AWAY, OTHER, TEMPORARY);
        p.dot(ALONG, PART, NORMAL, TEMPORARY);
        p.cross(PART, EDGE, AWAY, TEMPORARY);
        p.dot(ACROSS, PART, NORMAL, TEMPORARY);
        if (p.get(ALONG) < 0 || p.get(ACROSS) < 0) {
            return;
        }
        p.add(TEMPORARY, ALONG, ACROSS);
        p.subtract(TEMPORARY, TEMPORARY, SQUARE);
        if (p.get(TEMPORARY) > 0) {
            return;
        }
        p.dot(ALONG, AWAY, NORMAL, TEMPORARY);
        p.divide(ALONG, ALONG, LENGTH);
        p.multiply(ALONG, ALONG, ALONG);
        if (p.get(ALONG) < p.get(LEAST)) {
            p.set(LEAST, p.get(ALONG), p.rest(ALONG));
        }
    }
}
