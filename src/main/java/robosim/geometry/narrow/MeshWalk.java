package robosim.geometry.narrow;

import java.util.Arrays;
import robosim.geometry.index.BoxTree;
import robosim.geometry.model.TriangleMesh;

/**
 * Walks the triangles of a placed mesh that may matter for a region, a ray or a nearest distance, nearest first.
 *
 * <p>The tree stands in the mesh's own frame, so the question is taken there, widened by more than that rounding: a
 * triangle that matters is never left out. What is then decided is decided on the placed triangle.
 */
final class MeshWalk {
    /**
     * How much a question is widened for each unit of the coordinates that it was computed from. Taking a point into
     * the own frame is 3 products and 5 sums of unit-length rows, off by less than 16 u; so is the placed triangle.
     */
    static final double WIDEN = 0x1p-46;

    /** What underflow may add on the way, several times over. */
    static final double UNDERFLOW = 0x1p-1000;

    private final double[] low = new double[3];
    private final double[] high = new double[3];
    private final double[] start = new double[3];
    private final double[] inverse = new double[3];
    private final double[] box = new double[6];

    private TriangleMesh mesh;
    private BoxTree tree;
    private double[] place;
    private int at;
    private boolean isRay;
    private double pad;

    /** How far the rotation, kept as it was given, is from one: a point taken back into the own frame misses by so much. */
    private double skew;

    private int[] stack = new int[64];
    private double[] keys = new double[64];
    private int depth;
    private int item;
    private int end;
    private double itemKey;

    @SuppressWarnings("NullAway.Init") // start sets what is asked
    MeshWalk() {}

    /** Takes a mesh up, for its corners alone or for a question. */
    void open(LeafColumn column, int leaf) {
        mesh = column.mesh(leaf);
        tree = mesh.tree();
        place = column.rows();
        at = leaf * Leaf.STRIDE;
        depth = 0;
        item = 0;
        end = 0;
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
     * Begins with a box in the world: six numbers, least then greatest. In PLANAR its heights do not matter: pass
     * infinite ones.
     */
    void startBox(LeafColumn column, int leaf, double[] world) {
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
        isRay = false;
        push(tree.root(), 0);
    }

    /** Begins with a nearest question from a box in the world: keys are distances, rounded down. */
    void startNearest(LeafColumn column, int leaf, double[] world) {
        open(column, leaf);
        System.arraycopy(world, 0, box, 0, 6);
        takeBox();
        isRay = false;
        push(tree.root(), key(tree.root()));
    }

    /** Begins with a ray in the world; the direction has length 1. Keys are distances along it, rounded down. */
    void startRay(LeafColumn column, int leaf, double ox, double oy, double oz, double ux, double uy, double uz) {
        open(column, leaf);
        double x = ox - place[at];
        double y = oy - place[at + 1];
        double z = oz - place[at + 2];
        for (int j = 0; j < 3; j++) {
            int r = at + Leaf.ROTATION + j;
            start[j] = place[r] * x + place[r + 3] * y + place[r + 6] * z;
            inverse[j] = 1 / (place[r] * ux + place[r + 3] * uy + place[r + 6] * uz);
        }
        pad = WIDEN
                        * (Math.abs(ox)
                                + Math.abs(oy)
                                + Math.abs(oz)
                                + Math.abs(place[at])
                                + Math.abs(place[at + 1])
                                + Math.abs(place[at + 2])
                                + reach())
                + skew() * reach()
                + UNDERFLOW;
        isRay = true;
        push(tree.root(), key(tree.root()));
    }

    private double reach() {
        double[] b = tree.bounds();
        int r = 6 * tree.root();
        double size = 0;
        for (int k = 0; k < 6; k++) {
            size += Math.abs(b[r + k]);
        }
        return size;
    }

    /** At least three times any number of R'R - I, so at least the length of (R'R - I) p for a p of length 1. */
    private double skew() {
        int r = at + Leaf.ROTATION;
        double most = 0;
        for (int i = 0; i < 3; i++) {
            for (int j = i; j < 3; j++) {
                double product = place[r + i] * place[r + j]
                        + place[r + 3 + i] * place[r + 3 + j]
                        + place[r + 6 + i] * place[r + 6 + j];
                most = Math.max(most, Math.abs(product - (i == j ? 1 : 0)));
            }
        }
        skew = 3 * most;
        return skew;
    }

    /** Takes the world's box into the own frame as the box that holds it there. */
    private void takeBox() {
        double size = reach();
        for (int k = 0; k < 3; k++) {
            size += Math.abs(box[k]) + Math.abs(box[3 + k]) + Math.abs(place[at + k]);
        }
        pad = WIDEN * size + skew() * reach() + UNDERFLOW;
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

    /** A lower bound of the answer below a node, +Infinity where there is none. */
    private double key(int node) {
        return isRay ? rayKey(node) : boxKey(node);
    }

    private double boxKey(int node) {
        double[] b = tree.bounds();
        double squared = 0;
        for (int k = 0; k < 3; k++) {
            double gap = Math.max(b[6 * node + k] - high[k], low[k] - b[6 * node + 3 + k]);
            if (gap > 0) {
                squared += gap * gap;
            }
        }
        // Squares of what is tiny may be rounded up by underflow; R' may stretch by half of the skew.
        return squared < 0x1p-900 ? 0 : Math.sqrt(squared) * (1 - 0x1p-50 - skew);
    }

    private double rayKey(int node) {
        double[] b = tree.bounds();
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            double least = b[6 * node + k] - pad - start[k];
            double greatest = b[6 * node + 3 + k] + pad - start[k];
            if (Double.isInfinite(inverse[k])) {
                if (least > 0 || greatest < 0) {
                    return Double.POSITIVE_INFINITY;
                }
            } else {
                double a = least * inverse[k];
                double c = greatest * inverse[k];
                enter = Math.max(enter, Math.min(a, c));
                leave = Math.min(leave, Math.max(a, c));
            }
        }
        // Slopes are off by a few u each, so is what is divided by them.
        return enter * (1 - WIDEN) - pad <= leave * (1 + WIDEN) + pad
                ? Math.max(0, enter * (1 - WIDEN) - pad)
                : Double.POSITIVE_INFINITY;
    }

    /** The next triangle whose key is at most the limit, or -1. A limit only ever shrinks. */
    int next(double limit) {
        while (true) {
            while (item < end) {
                if (itemKey > limit) {
                    item = end;
                    break;
                }
                return tree.item(item++);
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

    /** Writes the placed triangle as a leaf's row. */
    void corners(int triangle, double[] row, int to) {
        for (int corner = 0; corner < 3; corner++) {
            int v = mesh.vertex(triangle, corner);
            for (int axis = 0; axis < 3; axis++) {
                row[to + 3 * corner + axis] = mesh.placed(v, axis, place, at);
            }
        }
    }

    /** The face that a triangle is of. */
    int face(int triangle) {
        return mesh.face(triangle);
    }
}
