package robosim.geometry.narrow.sat;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Whether two boxes or triangles, at any attitude, touch or overlap in space: separating axes in doubles, then exactly
 * in doubtful cases. An instance holds the working memory. {@link MovingAxes} with a motion of zero would answer the same,
 * but this ends at the first axis that separates: {@code robosim.geometry.bench.SeparatingAxes} tells what that is worth.
 *
 * <p>The axes are the side normals of both and the cross products of their edges: 15, 13 or 11. With these few, doubt
 * always remains for a shape that is flat in the plane of the other, or for a degenerate triangle.
 *
 * <p>The bounds, with u = 2^-53, n the axis and E the sums of the magnitudes that the coordinates come from. A point
 * relative to a's origin is off by u a coordinate, its projection by 3u more of |n|.E. A box's half width is the sum of
 * three, 2u, and is added to the other's, 1u; so are the middles: 7u of |n|.E. A triangle's middle and half width each
 * come from two of three projections, which count in both: twice 4 + 1 + 1, so 12u. The axis itself is off by 2u of the
 * permanent P of its cross products, by 4u where the edges are differences: 9u and 16u of P.E. An axis remains an axis
 * however it was rounded, so a gap beyond the first bound is a proof; that an axis does not separate needs the second.
 */
public final class PolytopePolytope {
    private static final double PROJECTED = FilterBound.bound(7.01 * 0x1p-53);
    private static final double WITH_AXIS = FilterBound.bound(9.01 * 0x1p-53);
    private static final double TRIANGLE_PROJECTED = FilterBound.bound(12.01 * 0x1p-53);
    private static final double TRIANGLE_WITH_AXIS = FilterBound.bound(16.01 * 0x1p-53);

    /** An upper bound, with a generous margin, of what underflow may add to a gap. */
    private static final double UNDERFLOW = 0x1p-1000;

    /** Below this, underflow could matter and doubles are not used. */
    private static final double SMALL = FilterBound.bound(0x1p-900);

    private static final StageCounters.Counter EXACT = StageCounters.counter("PolytopePolytope");

    private final Sides first = new Sides();
    private final Sides second = new Sides();

    // The bounds for the current pair.
    private double projected;
    private double withAxis;

    // The current axis and the permanents of its coordinates.
    private double nx;
    private double ny;
    private double nz;
    private double px;
    private double py;
    private double pz;

    public boolean touch(Leaf a, Leaf b) {
        first.load(a, a.get(0), a.get(1), a.get(2));
        second.load(b, a.get(0), a.get(1), a.get(2));
        boolean isTriangle = a.kind == LeafKind.TRIANGLE || b.kind == LeafKind.TRIANGLE;
        projected = isTriangle ? TRIANGLE_PROJECTED : PROJECTED;
        withAxis = isTriangle ? TRIANGLE_WITH_AXIS : WITH_AXIS;
        int doubts = 0;
        int bit = 1;
        for (int k = 0; k < first.faces + second.faces; k++, bit <<= 1) {
            face(k < first.faces ? first : second, k < first.faces ? k : k - first.faces);
            double gap = gap();
            if (gap > bound(projected, nx, ny, nz) + UNDERFLOW) {
                return false;
            }
            doubts |= isDoubtful(gap) ? bit : 0;
        }
        for (int k = 0; k < 9; k += 3) {
            for (int m = 0; m < 9; m += 3, bit <<= 1) {
                if (!cross(first.edges, k, second.edges, m)) {
                    continue;
                }
                double gap = gap();
                if (gap > bound(projected, nx, ny, nz) + UNDERFLOW) {
                    return false;
                }
                doubts |= isDoubtful(gap) ? bit : 0;
            }
        }
        if (doubts == 0) {
            return true;
        }
        EXACT.count();
        return !ExactPolytope.apart(a, b, doubts);
    }

    private double bound(double factor, double x, double y, double z) {
        return factor
                * (Math.abs(x) * (first.extentX + second.extentX)
                        + Math.abs(y) * (first.extentY + second.extentY)
                        + Math.abs(z) * (first.extentZ + second.extentZ));
    }

    private boolean isDoubtful(double gap) {
        double bound = bound(withAxis, px, py, pz);
        return !(gap < -bound) || bound < SMALL || bound == Double.POSITIVE_INFINITY;
    }

    private double gap() {
        first.project(nx, ny, nz);
        second.project(nx, ny, nz);
        return Math.abs(first.middle - second.middle) - (first.half + second.half);
    }

    private void face(Sides sides, int k) {
        if (sides.faces == 1) {
            cross(sides.edges, 0, sides.edges, 3);
        } else {
            cross(sides.edges, (3 * k + 3) % 9, sides.edges, (3 * k + 6) % 9);
        }
    }

    /**
     * Makes the cross product of two edges the axis; false where the two are clearly parallel and it is exactly zero.
     */
    private boolean cross(double[] p, int k, double[] q, int m) {
        double yz = p[k + 1] * q[m + 2];
        double zy = p[k + 2] * q[m + 1];
        double zx = p[k + 2] * q[m];
        double xz = p[k] * q[m + 2];
        double xy = p[k] * q[m + 1];
        double yx = p[k + 1] * q[m];
        nx = yz - zy;
        ny = zx - xz;
        nz = xy - yx;
        if (nx == 0 && ny == 0 && nz == 0 && isParallel(p, k, q, m)) {
            return false;
        }
        px = Math.abs(yz) + Math.abs(zy);
        py = Math.abs(zx) + Math.abs(xz);
        pz = Math.abs(xy) + Math.abs(yx);
        return true;
    }

    private static boolean isParallel(double[] p, int k, double[] q, int m) {
        boolean same = p[k] == q[m] && p[k + 1] == q[m + 1] && p[k + 2] == q[m + 2];
        boolean opposite = p[k] == -q[m] && p[k + 1] == -q[m + 1] && p[k + 2] == -q[m + 2];
        return same || opposite || isAlongOneAxis(p, k, q, m);
    }

    private static boolean isAlongOneAxis(double[] p, int k, double[] q, int m) {
        int used = 0;
        for (int axis = 0; axis < 3; axis++) {
            if (p[k + axis] != 0 || q[m + axis] != 0) {
                used++;
            }
        }
        return used <= 1;
    }

    /** One of the two: a box by centre and half vectors, a triangle by corners, relative to an origin. */
    private static final class Sides {
        int faces;

        /** The directions of three edges: a box's columns, a triangle's sides. */
        final double[] edges = new double[9];

        double extentX;
        double extentY;
        double extentZ;
        double middle;
        double half;
        private final double[] centre = new double[3];
        private final double[] points = new double[9];

        void load(Leaf leaf, double ox, double oy, double oz) {
            switch (leaf.kind.polytope()) {
                case BOX -> box(leaf.row, leaf.at, ox, oy, oz);
                case TRIANGLE -> triangle(leaf.row, leaf.at, ox, oy, oz);
            }
        }

        private void triangle(double[] row, int at, double ox, double oy, double oz) {
            faces = 1;
            for (int k = 0; k < 9; k += 3) {
                points[k] = row[at + k] - ox;
                points[k + 1] = row[at + k + 1] - oy;
                points[k + 2] = row[at + k + 2] - oz;
                int next = at + (k + 3) % 9;
                edges[k] = row[next] - row[at + k];
                edges[k + 1] = row[next + 1] - row[at + k + 1];
                edges[k + 2] = row[next + 2] - row[at + k + 2];
            }
            extentX = Math.max(Math.abs(points[0]), Math.max(Math.abs(points[3]), Math.abs(points[6])));
            extentY = Math.max(Math.abs(points[1]), Math.max(Math.abs(points[4]), Math.abs(points[7])));
            extentZ = Math.max(Math.abs(points[2]), Math.max(Math.abs(points[5]), Math.abs(points[8])));
        }

        private void box(double[] row, int at, double ox, double oy, double oz) {
            faces = 3;
            centre[0] = row[at] - ox;
            centre[1] = row[at + 1] - oy;
            centre[2] = row[at + 2] - oz;
            for (int k = 0; k < 3; k++) {
                for (int axis = 0; axis < 3; axis++) {
                    double along = row[at + Leaf.ROTATION + 3 * axis + k];
                    edges[3 * k + axis] = along;
                    points[3 * k + axis] = row[at + Leaf.SIZE + k] * along;
                }
            }
            extentX = Math.abs(centre[0]) + Math.abs(points[0]) + Math.abs(points[3]) + Math.abs(points[6]);
            extentY = Math.abs(centre[1]) + Math.abs(points[1]) + Math.abs(points[4]) + Math.abs(points[7]);
            extentZ = Math.abs(centre[2]) + Math.abs(points[2]) + Math.abs(points[5]) + Math.abs(points[8]);
        }

        void project(double x, double y, double z) {
            double p = x * points[0] + y * points[1] + z * points[2];
            double q = x * points[3] + y * points[4] + z * points[5];
            double r = x * points[6] + y * points[7] + z * points[8];
            if (faces == 1) {
                double least = Math.min(p, Math.min(q, r));
                double greatest = Math.max(p, Math.max(q, r));
                middle = 0.5 * (least + greatest);
                half = 0.5 * (greatest - least);
            } else {
                middle = x * centre[0] + y * centre[1] + z * centre[2];
                half = Math.abs(p) + Math.abs(q) + Math.abs(r);
            }
        }
    }
}
