package robosim.geometry.narrow.leaf;

import java.util.Arrays;
import robosim.geometry.exact.Rotations;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.exact.WorkCounter;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.TriangleMesh;

/**
 * The single leaf that stands for an object at an accuracy other than EXACT. Every enclosure is rounded outward by more
 * than the rounding of the numbers that it is computed from, so that it meets everything that the object itself meets.
 */
public final class Enclosure {
    /** Outward rounding, relative to the numbers used: at most some 30 roundings of 2^-53, times eight. */
    private static final double WIDEN = 0x1p-45;

    /** More than some 30 products lose to underflow. */
    private static final double UNDERFLOW = 64 * Double.MIN_VALUE;

    private static final double ROOT_TWO = 1.4142135623730951; // rounded up: the root of two is below

    private final LocalLeaves leaves;

    /** Minimum and maximum along the object's own axes. */
    private final double[] box = new double[6];

    private final double radius;
    private final double levelRadius;

    /** Measures an object in its own frame, once. */
    public Enclosure(LocalLeaves own) {
        leaves = own;
        LeafColumn column = own.own();
        double[] part = new double[6];
        Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
        for (int leaf = 0; leaf < column.size(); leaf++) {
            bounds(column, leaf, part);
            for (int k = 0; k < 3; k++) {
                box[k] = Math.min(box[k], part[k]);
                box[3 + k] = Math.max(box[3 + k], part[3 + k]);
            }
        }
        double farthest = 0;
        double farthestLevel = 0;
        for (int leaf = 0; leaf < column.size(); leaf++) {
            farthest = Math.max(farthest, reach(column, leaf, false));
            farthestLevel = Math.max(farthestLevel, reach(column, leaf, true));
        }
        double widen = WIDEN * size() + UNDERFLOW;
        radius = farthest + widen;
        levelRadius = farthestLevel + widen;
    }

    private static void bounds(LeafColumn column, int leaf, double[] out) {
        if (column.kind(leaf).isMesh()) {
            new MeshWalk(new WorkCounter()).tightBounds(column, leaf, out);
        } else {
            LeafBounds.of(column.kind(leaf), column.rows(), leaf * Leaf.STRIDE, out);
        }
    }

    private double middle(int axis) {
        return box[axis] / 2 + box[3 + axis] / 2;
    }

    private double size() {
        double size = 0;
        for (double b : box) {
            size += Math.abs(b);
        }
        return size;
    }

    /** How far a leaf extends from the centre of the box, in all directions or only horizontally. */
    private double reach(LeafColumn column, int leaf, boolean level) {
        double[] row = column.rows();
        int at = leaf * Leaf.STRIDE;
        LeafKind kind = column.kind(leaf);
        double dx = row[at] - middle(0);
        double dy = level ? 0 : row[at + 1] - middle(1);
        double dz = row[at + 2] - middle(2);
        double centre = VectorMath.anyLength(dx, dy, dz);
        return switch (kind) {
            case SPHERE -> centre + row[at + 3];
            case CYLINDER -> {
                double ay = row[at + Leaf.ROTATION + 4];
                double half = row[at + 4];
                yield level && Math.abs(ay) == 1
                        ? centre + row[at + 3]
                        : cylinderReach(dx, dy, dz, row, at, half, row[at + 3]);
            }
            case CAPSULE -> capsuleReach(dx, dy, dz, row, at, level) + row[at + 3];
            case UPRIGHT_BOX, BOX -> boxReach(row, at, level);
            case MESH, SOLID_MESH -> meshReach(column.mesh(leaf), row, at, level);
            case UPRIGHT_CYLINDER, TRIANGLE, PRISM, UPRIGHT_CAPSULE, GRID -> throw kind.refused(); // nothing enclosed
        };
    }

    private static double cylinderReach(
            double dx, double dy, double dz, double[] row, int at, double half, double radius) {
        int r = at + Leaf.ROTATION + 1;
        double axial = Math.abs(dx * row[r] + dy * row[r + 3] + dz * row[r + 6]);
        double across = crossLength(dx, dy, dz, row, r);
        return VectorMath.legs(axial + half, across + radius);
    }

    /** How far the ends of a capsule's segment are from a point. */
    private static double capsuleReach(double dx, double dy, double dz, double[] row, int at, boolean level) {
        int r = at + Leaf.ROTATION + 1;
        double hx = row[at + 4] * row[r];
        double hy = level ? 0 : row[at + 4] * row[r + 3];
        double hz = row[at + 4] * row[r + 6];
        double one = VectorMath.anyLength(dx + hx, dy + hy, dz + hz);
        double two = VectorMath.anyLength(dx - hx, dy - hy, dz - hz);
        return Math.max(one, two);
    }

    private double boxReach(double[] row, int at, boolean level) {
        double[] offset = new double[3];
        double farthest = 0;
        for (int corner = 0; corner < 8; corner++) {
            for (int axis = 0; axis < 3; axis++) {
                int r = at + Leaf.ROTATION + 3 * axis;
                double p = row[at + axis] - middle(axis);
                p += (corner & 1) == 0 ? -row[r] * row[at + 3] : row[r] * row[at + 3];
                p += (corner & 2) == 0 ? -row[r + 1] * row[at + 4] : row[r + 1] * row[at + 4];
                p += (corner & 4) == 0 ? -row[r + 2] * row[at + 5] : row[r + 2] * row[at + 5];
                offset[axis] = level && axis == 1 ? 0 : p;
            }
            farthest = Math.max(farthest, VectorMath.anyLength(offset[0], offset[1], offset[2]));
        }
        return farthest;
    }

    private double meshReach(TriangleMesh mesh, double[] row, int at, boolean level) {
        double farthest = 0;
        for (int t = 0; t < mesh.size(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                int v = mesh.vertex(t, corner);
                double dx = mesh.placed(v, 0, row, at) - middle(0);
                double dy = level ? 0 : mesh.placed(v, 1, row, at) - middle(1);
                double dz = mesh.placed(v, 2, row, at) - middle(2);
                farthest = Math.max(farthest, VectorMath.anyLength(dx, dy, dz));
            }
        }
        return farthest;
    }

    /**
     * Writes the leaf that encloses the placed object.
     *
     * @param placed   the object's own leaves at that place, in a column of their own
     * @param rotation its attitude: nine numbers from {@code at} on
     */
    public void place(
            Accuracy accuracy,
            Dimension dimension,
            LeafColumn placed,
            double cx,
            double cy,
            double cz,
            double[] rotation,
            int at,
            LeafColumn out,
            int leaf) {
        if (isItsOwn(accuracy, placed)) {
            out.setKind(leaf, placed.kind(0));
            System.arraycopy(placed.rows(), 0, out.rows(), leaf * Leaf.STRIDE, Leaf.STRIDE);
            return;
        }
        double[] row = out.rows();
        int to = leaf * Leaf.STRIDE;
        switch (accuracy) {
            case SPHERE -> {
                out.setKind(leaf, LeafKind.SPHERE);
                placeMiddle(cx, cy, cz, rotation, at, row, to);
                boolean flat = dimension == Dimension.PLANAR && Rotations.isUpright(rotation, at);
                row[to + 3] = (flat ? levelRadius : radius) + widen(row, to);
            }
            case OBB -> {
                placeMiddle(cx, cy, cz, rotation, at, row, to);
                double widen = widen(row, to);
                for (int k = 0; k < 3; k++) {
                    row[to + 3 + k] = Math.max(box[3 + k] - middle(k), middle(k) - box[k]) + widen;
                }
                System.arraycopy(rotation, at, row, to + Leaf.ROTATION, 9);
                out.setKind(leaf, UprightDetection.kind(LeafKind.BOX, row, to));
            }
            case AABB -> axisBox(placed, out, leaf);
            case DOP -> prism(placed, out, leaf);
            case EXACT -> throw new IllegalArgumentException("accuracy must be below EXACT (got: EXACT)");
        }
    }

    /** Whether the object is a single leaf that already is the enclosure of this accuracy. */
    private static boolean isItsOwn(Accuracy accuracy, LeafColumn placed) {
        if (placed.size() != 1) {
            return false;
        }
        LeafKind kind = placed.kind(0);
        return switch (accuracy) {
            case SPHERE -> kind == LeafKind.SPHERE;
            case OBB -> kind.isBox();
            case AABB ->
                kind == LeafKind.UPRIGHT_BOX
                        && (placed.rows()[Leaf.ROTATION] == 0 || placed.rows()[Leaf.ROTATION + 2] == 0);
            case DOP, EXACT -> false;
        };
    }

    private void placeMiddle(double cx, double cy, double cz, double[] rotation, int at, double[] row, int to) {
        double x = middle(0);
        double y = middle(1);
        double z = middle(2);
        row[to] = rotation[at] * x + rotation[at + 1] * y + rotation[at + 2] * z + cx;
        row[to + 1] = rotation[at + 3] * x + rotation[at + 4] * y + rotation[at + 5] * z + cy;
        row[to + 2] = rotation[at + 6] * x + rotation[at + 7] * y + rotation[at + 8] * z + cz;
    }

    private double widen(double[] row, int to) {
        return WIDEN * (size() + Math.abs(row[to]) + Math.abs(row[to + 1]) + Math.abs(row[to + 2])) + UNDERFLOW;
    }

    private static void axisBox(LeafColumn placed, LeafColumn out, int leaf) {
        double[] bounds = new double[6];
        bounds(placed, bounds);
        double[] row = out.rows();
        int to = leaf * Leaf.STRIDE;
        for (int k = 0; k < 3; k++) {
            row[to + k] = bounds[k] / 2 + bounds[3 + k] / 2;
            row[to + 3 + k] = Math.nextUp(Math.max(bounds[3 + k] - row[to + k], row[to + k] - bounds[k]));
        }
        Rotations.identity(row, to + Leaf.ROTATION);
        out.setKind(leaf, LeafKind.UPRIGHT_BOX);
    }

    /** The outward bounds of all leaves of a column. */
    static void bounds(LeafColumn placed, double[] bounds) {
        double[] part = new double[6];
        Arrays.fill(bounds, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(bounds, 3, 6, Double.NEGATIVE_INFINITY);
        for (int leaf = 0; leaf < placed.size(); leaf++) {
            bounds(placed, leaf, part);
            for (int k = 0; k < 3; k++) {
                bounds[k] = Math.min(bounds[k], part[k]);
                bounds[3 + k] = Math.max(bounds[3 + k], part[3 + k]);
            }
        }
    }

    /** Writes the prism around all leaves of a column. */
    static void prism(LeafColumn placed, LeafColumn out, int leaf) {
        double[] row = out.rows();
        int to = leaf * Leaf.STRIDE;
        for (int k = 0; k < 10; k += 2) {
            row[to + k] = Double.POSITIVE_INFINITY;
            row[to + k + 1] = Double.NEGATIVE_INFINITY;
        }
        for (int part = 0; part < placed.size(); part++) {
            extend(placed, part, row, to, 0, 1, 0, 0);
            extend(placed, part, row, to, 2, 0, 0, 1);
            extend(placed, part, row, to, 4, 1, 0, 1);
            extend(placed, part, row, to, 6, 1, 0, -1);
            extend(placed, part, row, to, 8, 0, 1, 0);
        }
        out.setKind(leaf, LeafKind.PRISM);
    }

    /** Extends one pair of the prism's bounds to include a leaf along (x, y, z). */
    private static void extend(
            LeafColumn placed, int leaf, double[] prism, int to, int pair, double x, double y, double z) {
        double[] row = placed.rows();
        int at = leaf * Leaf.STRIDE;
        LeafKind kind = placed.kind(leaf);
        if (kind.isMesh()) {
            TriangleMesh mesh = placed.mesh(leaf);
            for (int t = 0; t < mesh.size(); t++) {
                for (int corner = 0; corner < 3; corner++) {
                    int v = mesh.vertex(t, corner);
                    double px = mesh.placed(v, 0, row, at);
                    double py = mesh.placed(v, 1, row, at);
                    double pz = mesh.placed(v, 2, row, at);
                    hold(prism, to + pair, px * x + py * y + pz * z, 0, Math.abs(px) + Math.abs(py) + Math.abs(pz));
                }
            }
            return;
        }
        double middle = row[at] * x + row[at + 1] * y + row[at + 2] * z;
        double length = x != 0 && z != 0 ? ROOT_TWO : 1;
        double half = halfExtent(kind, row, at, x, y, z, length);
        double size = Math.abs(row[at]) + Math.abs(row[at + 1]) + Math.abs(row[at + 2]) + half;
        hold(prism, to + pair, middle, half, size);
    }

    private static double halfExtent(LeafKind kind, double[] row, int at, double x, double y, double z, double length) {
        int r = at + Leaf.ROTATION;
        return switch (kind) {
            case SPHERE -> row[at + 3] * length;
            case UPRIGHT_CYLINDER -> y != 0 ? row[at + 4] : row[at + 3] * length;
            case UPRIGHT_CAPSULE -> (y != 0 ? row[at + 4] : 0) + row[at + 3] * length;
            case CAPSULE ->
                row[at + 4] * Math.abs(row[r + 1] * x + row[r + 4] * y + row[r + 7] * z) + row[at + 3] * length;
            case CYLINDER -> {
                double along = Math.abs(row[r + 1] * x + row[r + 4] * y + row[r + 7] * z);
                yield row[at + 4] * along + row[at + 3] * crossLength(x, y, z, row, r + 1);
            }
            case UPRIGHT_BOX, BOX ->
                row[at + 3] * Math.abs(row[r] * x + row[r + 3] * y + row[r + 6] * z)
                        + row[at + 4] * Math.abs(row[r + 1] * x + row[r + 4] * y + row[r + 7] * z)
                        + row[at + 5] * Math.abs(row[r + 2] * x + row[r + 5] * y + row[r + 8] * z);
            case TRIANGLE, PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /**
     * The length of the component of (x, y, z) perpendicular to an own axis; as a cross product, which does not suffer
     * from cancellation.
     */
    private static double crossLength(double x, double y, double z, double[] row, int axis) {
        double a = y * row[axis + 6] - z * row[axis + 3];
        double b = z * row[axis] - x * row[axis + 6];
        double c = x * row[axis + 3] - y * row[axis];
        return VectorMath.anyLength(a, b, c);
    }

    private static void hold(double[] prism, int pair, double middle, double half, double size) {
        double widen = WIDEN * size + UNDERFLOW;
        prism[pair] = Math.min(prism[pair], middle - half - widen);
        prism[pair + 1] = Math.max(prism[pair + 1], middle + half + widen);
    }

    /** The leaves that are enclosed. */
    public LocalLeaves leaves() {
        return leaves;
    }
}
