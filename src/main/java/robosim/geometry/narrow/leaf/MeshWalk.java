package robosim.geometry.narrow.leaf;

import java.util.Arrays;
import robosim.geometry.exact.WorkCounter;
import robosim.geometry.index.meshes.BoxTree;
import robosim.geometry.index.meshes.TriangleMesh;

/**
 * Walks the triangles of a placed mesh that may be relevant for a region or a nearest distance, nearest first.
 *
 * <p>The tree is in the mesh's own frame, so the query is transformed there, widened by more than the rounding: no
 * relevant triangle is missed. Decisions are then made on the placed triangles.
 */
public final class MeshWalk {
    /**
     * How much a query is widened, relative to the coordinates that it was computed from. Transforming a point to the
     * own frame takes 3 products and 5 sums of unit-length rows, off by less than 16 u; so is the placed triangle.
     */
    public static final double WIDEN = 0x1p-46;

    /** Several times the error that underflow may add. */
    public static final double UNDERFLOW = 0x1p-1060;

    private final double[] low = new double[3];
    private final double[] high = new double[3];
    private final double[] box = new double[6];
    private final double[] triangle = new double[9];

    private final WorkCounter work;
    private TriangleMesh mesh;
    private BoxTree tree;
    private double[] place;
    private int at;
    private double pad;

    /**
     * How far the rotation, kept as given, is from orthonormal: the relative error of transforming a point back to the
     * own frame.
     */
    private double skew;

    private int[] stack = new int[64];
    private double[] keys = new double[64];
    private int depth;
    private int item;
    private int end;
    private double itemKey;

    @SuppressWarnings("NullAway.Init") // start sets the query
    public MeshWalk(WorkCounter work) {
        this.work = work;
    }

    /** Opens a mesh, for its corners alone or for a query. */
    public void open(LeafColumn column, int leaf) {
        mesh = column.mesh(leaf);
        tree = mesh.tree();
        place = column.rows();
        at = leaf * Leaf.STRIDE;
        depth = 0;
        item = 0;
        end = 0;
    }

    /** An upper bound of the size of the opened mesh. */
    public double size() {
        return tree.reach();
    }

    /** Tight bounds of the placed vertices that faces use. */
    void tightBounds(LeafColumn column, int leaf, double[] out) {
        open(column, leaf);
        Arrays.fill(out, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(out, 3, 6, Double.NEGATIVE_INFINITY);
        for (int t = 0; t < mesh.size(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                for (int axis = 0; axis < 3; axis++) {
                    double value = mesh.placed(mesh.vertex(t, corner), axis, place, at);
                    out[axis] = Math.min(out[axis], value);
                    out[3 + axis] = Math.max(out[3 + axis], value);
                }
            }
        }
    }

    /**
     * How far the corners of a placed mesh extend along (x, y, z): the largest dot product, rounded up by more than the
     * rounding of the corners and of the product. Numbers are at most 1.
     */
    double farthest(LeafColumn column, int leaf, double x, double y, double z) {
        open(column, leaf);
        int r = at + Leaf.ROTATION;
        double ux = place[r] * x + place[r + 3] * y + place[r + 6] * z;
        double uy = place[r + 1] * x + place[r + 4] * y + place[r + 7] * z;
        double uz = place[r + 2] * x + place[r + 5] * y + place[r + 8] * z;
        double size = tree.reach() + Math.abs(place[at]) + Math.abs(place[at + 1]) + Math.abs(place[at + 2]);
        double widen = WIDEN * size + UNDERFLOW;
        double offset = place[at] * x + place[at + 1] * y + place[at + 2] * z;
        double most = Double.NEGATIVE_INFINITY;
        push(tree.root(), 0);
        while (depth > 0) {
            int node = stack[--depth];
            if (along(node, ux, uy, uz) + offset + 4 * widen <= most) {
                continue; // what is there lies farther in, whatever is rounded
            }
            if (tree.isLeaf(node)) {
                for (int k = tree.first(node); k < tree.first(node) + tree.count(node); k++) {
                    most = Math.max(most, farthestOf(k, x, y, z));
                }
            } else if (along(tree.left(node), ux, uy, uz) > along(tree.right(node), ux, uy, uz)) {
                push(tree.right(node), 0);
                push(tree.left(node), 0);
            } else {
                push(tree.left(node), 0);
                push(tree.right(node), 0);
            }
        }
        return most + widen;
    }

    /** How far a node's box extends along a direction in the own frame. */
    private double along(int node, double x, double y, double z) {
        return tree.middle(node, 0) * x
                + tree.middle(node, 1) * y
                + tree.middle(node, 2) * z
                + tree.half(node, 0) * Math.abs(x)
                + tree.half(node, 1) * Math.abs(y)
                + tree.half(node, 2) * Math.abs(z);
    }

    private double farthestOf(int leafPlace, double x, double y, double z) {
        corners(leafPlace, triangle, 0);
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < 9; k += 3) {
            most = Math.max(most, triangle[k] * x + triangle[k + 1] * y + triangle[k + 2] * z);
        }
        return most;
    }

    /**
     * Begins a query for a box in the world: six numbers, minimum then maximum. In PLANAR pass infinite heights.
     */
    public void startBox(LeafColumn column, int leaf, double[] world) {
        open(column, leaf);
        column.bounds(leaf, box);
        for (int k = 0; k < 3; k++) {
            box[k] = Math.max(box[k], world[k]);
            box[3 + k] = Math.min(box[3 + k], world[3 + k]);
            if (box[k] > box[3 + k]) {
                return; // apart: nothing on the stack
            }
        }
        takeBox();
        push(tree.root(), 0);
    }

    /** Begins a nearest query from a box in the world: keys are distances, rounded down. */
    public void startNearest(LeafColumn column, int leaf, double[] world) {
        open(column, leaf);
        System.arraycopy(world, 0, box, 0, 6);
        takeBox();
        push(tree.root(), key(tree.root()));
    }

    /** At least three times any number of R'R - I, so at least the length of (R'R - I) p for a p of length 1. */
    public static double skew(double[] place, int r) {
        double most = 0;
        for (int i = 0; i < 3; i++) {
            for (int j = i; j < 3; j++) {
                double product = place[r + i] * place[r + j]
                        + place[r + 3 + i] * place[r + 3 + j]
                        + place[r + 6 + i] * place[r + 6 + j];
                most = Math.max(most, Math.abs(product - (i == j ? 1 : 0)));
            }
        }
        return 3 * most;
    }

    /** Transforms the box to the own frame, as the box that encloses it there. */
    private void takeBox() {
        double size = tree.reach();
        for (int k = 0; k < 3; k++) {
            size += Math.abs(box[k]) + Math.abs(box[3 + k]) + Math.abs(place[at + k]);
        }
        skew = skew(place, at + Leaf.ROTATION);
        pad = WIDEN * size + skew * tree.reach() + UNDERFLOW;
        for (int j = 0; j < 3; j++) {
            double middle = 0;
            double half = 0;
            for (int k = 0; k < 3; k++) {
                double turn = place[at + Leaf.ROTATION + 3 * k + j];
                middle += turn * (box[k] / 2 + box[3 + k] / 2 - place[at + k]);
                half += Math.abs(turn) * (box[3 + k] / 2 - box[k] / 2);
            }
            low[j] = middle - half - pad;
            high[j] = middle + half + pad;
        }
    }

    private void push(int node, double key) {
        if (key == Double.POSITIVE_INFINITY) {
            return;
        }
        if (depth == stack.length) {
            stack = Arrays.copyOf(stack, 2 * depth);
            keys = Arrays.copyOf(keys, 2 * depth);
        }
        stack[depth] = node;
        keys[depth++] = key;
    }

    /** A lower bound of the distance of everything below a node; 0 if it meets the box. */
    private double key(int node) {
        double squared = 0;
        for (int k = 0; k < 3; k++) {
            double middle = tree.middle(node, k);
            double gap = Math.max(middle - high[k], low[k] - middle) - tree.half(node, k);
            if (gap > 0) {
                squared += gap * gap;
            }
        }
        // Squares of tiny numbers may be rounded up by underflow; R' may stretch by half of the skew.
        return squared < 0x1p-900 ? 0 : Math.sqrt(squared) * (1 - 0x1p-50 - skew);
    }

    /**
     * The next triangle whose key is at most the limit, as a position in the order of the leaves, or -1. The limit may
     * only shrink.
     */
    public int next(double limit) {
        while (true) {
            work.take();
            while (item < end) {
                if (itemKey > limit) {
                    item = end;
                    break;
                }
                return item++;
            }
            if (depth == 0) {
                return -1;
            }
            int node = stack[--depth];
            double key = keys[depth];
            if (key > limit) {
                continue;
            }
            if (tree.isLeaf(node)) {
                item = tree.first(node);
                end = item + tree.count(node);
                itemKey = key;
            } else {
                pushChildren(tree.left(node), tree.right(node), limit);
            }
        }
    }

    private void pushChildren(int left, int right, double limit) {
        double leftKey = worth(key(left), limit);
        double rightKey = worth(key(right), limit);
        if (leftKey <= rightKey) {
            push(right, rightKey);
            push(left, leftKey);
        } else {
            push(left, leftKey);
            push(right, rightKey);
        }
    }

    private static double worth(double key, double limit) {
        return key <= limit ? key : Double.POSITIVE_INFINITY;
    }

    /** Writes a placed triangle, given its position in the order of the leaves, as a leaf row. */
    public void corners(int leafPlace, double[] row, int to) {
        mesh.placedAt(leafPlace, place, at, row, to);
    }

    /** The triangle at a position in the order of the leaves. */
    public int triangle(int leafPlace) {
        return tree.item(leafPlace);
    }
}
