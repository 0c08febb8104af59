package robosim.geometry.narrow.cone;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.ray.ExactRay;
import robosim.geometry.narrow.ray.RayTriangle;

/**
 * The corners of a box, a triangle or a prism relative to a cone's apex, in pairs of doubles, and the corner indices of
 * its edges and faces. A face is the list of its edges.
 *
 * <p>A prism has four corners for each edge of its octagon: the two ends at the bottom, then at the top. An edge that
 * the others cut off is absent.
 */
final class ConeCorners {
    private static final int[] TRIANGLE_EDGES = {0, 1, 1, 2, 2, 0};
    private static final int[][] TRIANGLE_FACES = {TRIANGLE_EDGES};
    private static final int[] BOX_EDGES = {0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7};
    /** For a box of height 0, whose corners coincide in pairs: its sides once, and its corners. */
    private static final int[] FLAT_EDGES = {0, 1, 4, 5, 0, 4, 1, 5, 0, 2, 1, 3, 4, 6, 5, 7};

    private static final int[][] BOX_FACES = {
        {0, 1, 1, 3, 3, 2, 2, 0},
        {4, 5, 5, 7, 7, 6, 6, 4},
        {0, 1, 1, 5, 5, 4, 4, 0},
        {2, 3, 3, 7, 7, 6, 6, 2},
        {0, 2, 2, 6, 6, 4, 4, 0},
        {1, 3, 3, 7, 7, 5, 5, 1}
    };

    /** The index in a prism's row of the bound that each edge of the octagon lies on. */
    private static final int[] FORM = {1, 5, 3, 6, 0, 4, 2, 7};

    private static final int[] PRISM_EDGES = new int[64];
    private static final int[] FLAT_PRISM_EDGES = new int[16];
    private static final int[][] PRISM_FACES = new int[10][];

    static {
        int[] bottom = new int[16];
        int[] top = new int[16];
        for (int k = 0; k < 8; k++) {
            int p = 4 * k;
            int[] edges = {p, p + 1, p + 2, p + 3, p, p + 2, p + 1, p + 3};
            System.arraycopy(edges, 0, PRISM_EDGES, 8 * k, 8);
            PRISM_FACES[k] = new int[] {p, p + 1, p + 1, p + 3, p + 3, p + 2, p + 2, p};
            FLAT_PRISM_EDGES[2 * k] = p;
            FLAT_PRISM_EDGES[2 * k + 1] = p + 1;
            bottom[2 * k] = p;
            bottom[2 * k + 1] = p + 1;
            top[2 * k] = p + 2;
            top[2 * k + 1] = p + 3;
        }
        PRISM_FACES[8] = bottom;
        PRISM_FACES[9] = top;
    }

    final double[] hi = new double[96];
    private final double[] lo = new double[96];
    private final boolean[] isAbsent = new boolean[8];
    private boolean hasAbsent;
    private final double[] pair = new double[4];

    // Of a box that is taken corner by corner: its half axes in pairs, and vectors of pairs: its centre, that and one
    // half axis
    // less or more, and two, and three, which are the corners; and which of these have been computed, as bits.
    private final double[] halves = new double[18];
    private final double[] sums = new double[90];
    private int done;

    /** The largest coordinate or size. */
    double extent;

    /** The leaf, for exact numbers. */
    private LeafKind leaf = LeafKind.BOX;

    private double[] rows = new double[0];
    private int at;

    void set(Cone cone, LeafKind kind, double[] row, int j) {
        hasAbsent = false;
        leaf = kind;
        rows = row;
        at = j;
        switch (kind) {
            case TRIANGLE -> triangle(cone, row, j);
            case PRISM -> prism(cone, row, j);
            case UPRIGHT_BOX, BOX -> box(cone, row, j);
            case UPRIGHT_CYLINDER, SPHERE, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID ->
                throw kind.refused();
        }
    }

    static int[] edges(LeafKind kind) {
        return switch (kind) {
            case UPRIGHT_BOX, BOX -> BOX_EDGES;
            case TRIANGLE -> TRIANGLE_EDGES;
            case PRISM -> PRISM_EDGES;
            case UPRIGHT_CYLINDER, SPHERE, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID ->
                throw kind.refused();
        };
    }

    /** The edges of a leaf flattened into a plane. */
    static int[] flatEdges(LeafKind kind) {
        return switch (kind) {
            case UPRIGHT_BOX -> FLAT_EDGES;
            case PRISM -> FLAT_PRISM_EDGES;
            default -> edges(kind);
        };
    }

    static int[][] faces(LeafKind kind) {
        return switch (kind) {
            case UPRIGHT_BOX, BOX -> BOX_FACES;
            case TRIANGLE -> TRIANGLE_FACES;
            case PRISM -> PRISM_FACES;
            case UPRIGHT_CYLINDER, SPHERE, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID ->
                throw kind.refused();
        };
    }

    /** The low (0) or the high (1) face of a box across one of its axes. */
    static int[] boxFace(int axis, int side) {
        return BOX_FACES[2 * (2 - axis) + side];
    }

    boolean isThere(int corner) {
        return !hasAbsent || !isAbsent[corner / 4];
    }

    /**
     * A lower bound of the distance of the apex from a face of a prism, in the order of {@link #faces}; 0 where the apex is
     * certainly not outside of it, as then other faces are nearer.
     */
    double gap(Cone cone, int face) {
        int number = face < FORM.length ? FORM[face] : face;
        double o = switch (number / 2) {
            case 0 -> cone.ox;
            case 1 -> cone.oz;
            case 2 -> cone.ox + cone.oz;
            case 3 -> cone.ox - cone.oz;
            default -> cone.oy;
        };
        double bound = rows[at + number];
        double size = Math.abs(cone.ox) + Math.abs(cone.oy) + Math.abs(cone.oz) + Math.abs(bound);
        double gap = (number & 1) == 0 ? bound - o : o - bound;
        double sure = gap + 0x1p-40 * size;
        return sure > 0 ? Math.max(Double.MIN_VALUE, 0.7 * gap - 0x1p-40 * size) : 0;
    }

    /** Whether they are of an enclosure, not of an object itself. */
    boolean isEnclosure() {
        return leaf.isEnclosure();
    }

    /** A side of a prism is present if its edge is; the top and the bottom always are. */
    boolean isFaceThere(int[] face) {
        return face.length > 8 || isThere(face[0]);
    }

    /** Prepares a box, of which only some corners will be asked for. */
    void setBox(Cone cone, double[] row, int j) {
        hasAbsent = false;
        leaf = LeafKind.BOX;
        rows = row;
        at = j;
        extent = boxExtent(row, j);
        done = 0;
        for (int axis = 0; axis < 3; axis++) {
            double apex = axis == 0 ? cone.ox : axis == 1 ? cone.oy : cone.oz;
            DoubleDouble.sum(row[j + axis], -apex, sums, 2 * axis);
            for (int i = 0; i < 3; i++) {
                DoubleDouble.product(row[j + 3 + i], row[j + Leaf.ROTATION + 3 * axis + i], halves, 2 * (3 * i + axis));
            }
        }
    }

    /** Computes one corner after {@link #setBox}, to the bit as {@link #set} computes all. */
    void take(int corner) {
        // The sums up to each half axis, of which corners share the first ones.
        add(0, 1 + (corner & 1), 0, corner & 1);
        add(1 + (corner & 1), 3 + (corner & 3), 1, corner >> 1 & 1);
        add(3 + (corner & 3), 7 + corner, 2, corner >> 2);
        int from = 6 * (7 + corner);
        for (int axis = 0; axis < 3; axis++) {
            hi[3 * corner + axis] = sums[from + 2 * axis];
            lo[3 * corner + axis] = sums[from + 2 * axis + 1];
        }
    }

    /** Adds a half axis to a sum, or subtracts it, unless that has been done. */
    private void add(int from, int to, int half, int isPlus) {
        if ((done >> to & 1) != 0) {
            return;
        }
        done |= 1 << to;
        double sign = isPlus == 0 ? -1 : 1;
        for (int k = 0; k < 6; k += 2) {
            DoubleDouble.add(
                    sums[6 * from + k],
                    sums[6 * from + k + 1],
                    sign * halves[6 * half + k],
                    sign * halves[6 * half + k + 1],
                    sums,
                    6 * to + k);
        }
    }

    private static double boxExtent(double[] row, int j) {
        return Math.max(VectorMath.largest(row[j], row[j + 1], row[j + 2]), row[j + 3] + row[j + 4] + row[j + 5]);
    }

    void load(DoubleDoubles p, int vector, int corner) {
        for (int k = 0; k < 3; k++) {
            p.set(vector + k, hi[3 * corner + k], lo[3 * corner + k]);
        }
    }

    private void triangle(Cone cone, double[] row, int j) {
        for (int i = 0; i < 3; i++) {
            put(i, 0, row[j + 3 * i], 0, cone.ox);
            put(i, 1, row[j + 3 * i + 1], 0, cone.oy);
            put(i, 2, row[j + 3 * i + 2], 0, cone.oz);
        }
        extent = RayTriangle.extent(row, j);
    }

    private void put(int corner, int axis, double value, double tail, double apex) {
        DoubleDouble.add(value, tail, -apex, 0, pair, 0);
        hi[3 * corner + axis] = pair[0];
        lo[3 * corner + axis] = pair[1];
    }

    private void box(Cone cone, double[] row, int j) {
        extent = boxExtent(row, j);
        // Corner by corner, the same sums would be computed many times.
        for (int axis = 0; axis < 3; axis++) {
            double apex = axis == 0 ? cone.ox : axis == 1 ? cone.oy : cone.oz;
            DoubleDouble.sum(row[j + axis], -apex, pair, 0);
            hi[axis] = pair[0];
            lo[axis] = pair[1];
            for (int i = 0; i < 3; i++) {
                DoubleDouble.product(row[j + 3 + i], row[j + Leaf.ROTATION + 3 * axis + i], pair, 2);
                for (int corner = 0; corner < 1 << i; corner++) {
                    spread(3 * corner + axis, 3 << i);
                }
            }
        }
    }

    /**
     * Adds the second pair to a corner coordinate and stores the sum {@code further} on; subtracts the pair in place.
     */
    private void spread(int at, int further) {
        double high = hi[at];
        double low = lo[at];
        DoubleDouble.add(high, low, pair[2], pair[3], pair, 0);
        hi[at + further] = pair[0];
        lo[at + further] = pair[1];
        DoubleDouble.add(high, low, -pair[2], -pair[3], pair, 0);
        hi[at] = pair[0];
        lo[at] = pair[1];
    }

    private void prism(Cone cone, double[] row, int j) {
        hasAbsent = true;
        extent = 0;
        for (int i = 0; i < 10; i++) {
            extent = Math.max(extent, Math.abs(row[j + i]));
        }
        for (int k = 0; k < 8; k++) {
            isAbsent[k] = false;
            for (int end = 0; end < 2; end++) {
                double x = along(row, j, k, isDownward(k) ? 1 - end : end);
                for (int above = 0; above < 2; above++) {
                    int corner = 4 * k + 2 * above + end;
                    place(cone, row, j, k, corner, x);
                    put(corner, 1, row[j + 8 + above], 0, cone.oy);
                }
            }
            isAbsent[k] = along(row, j, k, 0) > along(row, j, k, 1);
        }
    }

    // The octagon's edges in order: x high, x+z high, z high, x-z low, x low, x+z low, z low, x-z high. The free
    // coordinate is z on the first and fifth and x on the others; the other bounds limit it.
    private static double along(double[] b, int j, int k, int end) {
        double low;
        double high;
        double at = b[j + FORM[k]];
        switch (k) {
            case 0, 4 -> {
                low = Math.max(b[j + 2], Math.max(b[j + 4] - at, at - b[j + 7]));
                high = Math.min(b[j + 3], Math.min(b[j + 5] - at, at - b[j + 6]));
            }
            case 2, 6 -> {
                low = Math.max(b[j], Math.max(b[j + 4] - at, b[j + 6] + at));
                high = Math.min(b[j + 1], Math.min(b[j + 5] - at, b[j + 7] + at));
            }
            case 1, 5 -> {
                low = Math.max(b[j], Math.max(at - b[j + 3], (at + b[j + 6]) / 2));
                high = Math.min(b[j + 1], Math.min(at - b[j + 2], (at + b[j + 7]) / 2));
            }
            default -> {
                low = Math.max(b[j], Math.max(at + b[j + 2], (at + b[j + 4]) / 2));
                high = Math.min(b[j + 1], Math.min(at + b[j + 3], (at + b[j + 5]) / 2));
            }
        }
        return end == 0 ? low : high;
    }

    // In order around the octagon, the free coordinate decreases along these edges.
    private static boolean isDownward(int k) {
        return k >= 1 && k <= 4;
    }

    private void place(Cone cone, double[] row, int j, int k, int corner, double free) {
        double at = row[j + FORM[k]];
        double x = k % 4 == 0 ? at : free;
        put(corner, 0, x, 0, cone.ox);
        if (k % 4 == 0) {
            put(corner, 2, free, 0, cone.oz);
        } else if (k % 4 == 2) {
            put(corner, 2, at, 0, cone.oz);
        } else {
            // z = at - x, or x - at
            double z = k % 4 == 1 ? at - x : x - at;
            double tail = k % 4 == 1 ? DoubleDouble.differenceTail(at, x, z) : DoubleDouble.differenceTail(x, at, z);
            put(corner, 2, z, tail, cone.oz);
        }
    }

    /** A corner in exact arithmetic, in the ray's scale and relative to its start. */
    ExactVector exact(ExactRay ray, int corner) {
        return exact(ray, leaf, rows, at, corner).minus(ray.start);
    }

    private static ExactVector exact(ExactRay ray, LeafKind kind, double[] row, int j, int corner) {
        return switch (kind) {
            case UPRIGHT_BOX, BOX -> exactBox(ray, row, j, corner);
            case TRIANGLE -> ray.point(row, j + 3 * corner);
            case PRISM -> exactPrism(ray, row, j, corner);
            case UPRIGHT_CYLINDER, SPHERE, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID ->
                throw kind.refused();
        };
    }

    private static ExactVector exactBox(ExactRay ray, double[] row, int j, int corner) {
        ExactVector sum = ray.point(row, j);
        for (int i = 0; i < 3; i++) {
            Dyadic half = ray.length(row[j + 3 + i]);
            ExactVector own = ExactVector.of(row, j + Leaf.ROTATION + i, 3);
            sum = sum.plus(own.times((corner >> i & 1) == 0 ? half.negate() : half));
        }
        return sum;
    }

    private static ExactVector exactPrism(ExactRay ray, double[] row, int j, int corner) {
        Dyadic[] b = new Dyadic[10];
        for (int i = 0; i < 10; i++) {
            b[i] = ray.length(row[j + i]);
        }
        int k = corner / 4;
        Dyadic at = b[FORM[k]];
        Dyadic low;
        Dyadic high;
        switch (k) {
            case 0, 4 -> {
                low = b[2].max(b[4].subtract(at)).max(at.subtract(b[7]));
                high = b[3].min(b[5].subtract(at)).min(at.subtract(b[6]));
            }
            case 2, 6 -> {
                low = b[0].max(b[4].subtract(at)).max(b[6].add(at));
                high = b[1].min(b[5].subtract(at)).min(b[7].add(at));
            }
            case 1, 5 -> {
                low = b[0].max(at.subtract(b[3])).max(at.add(b[6]).scale(-1));
                high = b[1].min(at.subtract(b[2])).min(at.add(b[7]).scale(-1));
            }
            default -> {
                low = b[0].max(at.add(b[2])).max(at.add(b[4]).scale(-1));
                high = b[1].min(at.add(b[3])).min(at.add(b[5]).scale(-1));
            }
        }
        // Rounding may have swapped the two ends; in exact arithmetic an absent edge is a point.
        Dyadic free = (corner % 2 == 0) != isDownward(k) ? low.min(high) : low.max(high);
        Dyadic y = b[8 + (corner >> 1 & 1)];
        return switch (k % 4) {
            case 0 -> new ExactVector(at, y, free);
            case 1 -> new ExactVector(free, y, at.subtract(free));
            case 2 -> new ExactVector(free, y, at);
            default -> new ExactVector(free, y, free.subtract(at));
        };
    }
}
