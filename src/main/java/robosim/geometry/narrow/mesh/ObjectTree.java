package robosim.geometry.narrow.mesh;

import robosim.geometry.index.meshes.BoxTree;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.BoxGap;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.leaf.MeshWalk;
import robosim.geometry.narrow.overlap.SpatialOverlap;

/**
 * An object's leaves and the triangles of its meshes as one tree: at the top a tree over its parts (the leaves of the
 * column), if there is more than one; below each part that is a mesh, the mesh's own tree.
 *
 * <p>A place in the tree is a {@code long}: in the upper half the part, or -1 above the parts; in the lower half a
 * node, or ~position for a triangle. Boxes are in world axes and strictly enclose everything below them: those of a
 * mesh are in its own frame and are transformed as its vertices are placed, so that nothing is missed even if the
 * rotation is orthonormal only to 1e-9.
 */
final class ObjectTree {
    /** Widening relative to the numbers that a box is computed from; see {@link LeafColumn}. */
    private static final double WIDEN = MeshWalk.WIDEN;

    /**
     * The largest gap of two cylinders, as a fraction of their size, at which {@link SpatialOverlap} may be uncertain.
     */
    private static final double DOUBTFUL = 0x1p-40;

    private static final BoxTree NO_PARTS = new BoxTree(new double[6]);

    private static final LeafColumn NO_LEAVES = new LeafColumn(1);

    private LeafColumn column = NO_LEAVES;
    private boolean flat;
    private BoxTree parts = NO_PARTS;
    private long root;

    // The leaf loaded last: a row of the column, or a triangle.
    private final double[] triangle = new double[Leaf.STRIDE];
    private final Leaf leaf = new Leaf(LeafKind.TRIANGLE, triangle, 0);

    /** Opens an object. */
    void open(LeafColumn leaves, Dimension dimension) {
        column = leaves;
        flat = dimension == Dimension.PLANAR;
        if (leaves.size() > 1) {
            double[] boxes = new double[6 * leaves.size()];
            double[] one = new double[6];
            for (int part = 0; part < leaves.size(); part++) {
                box(place(part, 0), one);
                System.arraycopy(one, 0, boxes, 6 * part, 6);
            }
            parts = new BoxTree(boxes);
            root = place(-1, parts.root());
        } else {
            root = place(0, 0);
        }
    }

    /** Opens one part of an object. */
    void openPart(LeafColumn leaves, int part, Dimension dimension) {
        column = leaves;
        flat = dimension == Dimension.PLANAR;
        root = place(part, 0);
    }

    /** Releases the object. */
    void close() {
        column = NO_LEAVES;
        parts = NO_PARTS;
    }

    long root() {
        return root;
    }

    private static long place(int part, int code) {
        return ((long) part << 32) | (code & 0xffffffffL);
    }

    static int part(long place) {
        return (int) (place >> 32);
    }

    /** Of a triangle, its position in the order of the leaves. */
    static int position(long place) {
        return ~code(place);
    }

    private static int code(long place) {
        return (int) place;
    }

    /** Whether the place is a part as a whole. */
    static boolean isPart(long place) {
        return part(place) >= 0 && code(place) == 0;
    }

    static boolean isAboveParts(long place) {
        return part(place) < 0;
    }

    /** Whether the place is a convex leaf or a triangle. */
    boolean isLeaf(long place) {
        return part(place) >= 0 && (code(place) < 0 || !column.kind(part(place)).isMesh());
    }

    /** Whether the place is a node of a mesh's tree below which there are triangles only. */
    boolean holdsTriangles(long place) {
        return code(place) >= 0 && tree(place).isLeaf(code(place));
    }

    private BoxTree tree(long place) {
        return isAboveParts(place) ? parts : column.mesh(part(place)).tree();
    }

    int children(long place) {
        int count = tree(place).count(code(place));
        return count > 0 ? count : 2;
    }

    long child(long place, int k) {
        BoxTree tree = tree(place);
        int node = code(place);
        if (!tree.isLeaf(node)) {
            return place(part(place), k == 0 ? tree.left(node) : tree.right(node));
        }
        int item = tree.first(node) + k;
        return isAboveParts(place) ? place(tree.item(item), 0) : place(part(place), ~item);
    }

    /** The triangle of a place; -1 if it is not a triangle. */
    int triangle(long place) {
        int code = code(place);
        return code < 0 ? column.mesh(part(place)).tree().item(~code) : -1;
    }

    /** The leaf at a place, valid until the next one. */
    Leaf leaf(long place) {
        return leaf(part(place), triangle(place));
    }

    /** The same, given the part and the triangle of the mesh, -1 if the part is not a mesh. */
    Leaf leaf(int part, int ofMesh) {
        if (ofMesh < 0) {
            return leaf.set(column.kind(part), column.rows(), part * Leaf.STRIDE);
        }
        TriangleMesh mesh = column.mesh(part);
        for (int corner = 0; corner < 3; corner++) {
            vertex(part, mesh.vertex(ofMesh, corner), triangle, 3 * corner);
        }
        return leaf.set(LeafKind.TRIANGLE, triangle, 0);
    }

    /**
     * Whether a solid mesh contains a point of a part: the given vertex of a mesh, or for other parts (vertex 0) their
     * reference point.
     */
    boolean holds(int solid, ObjectTree other, int part, int vertex, LeafScratch s) {
        double[] point = other.triangle;
        if (other.kindOf(part).isMesh()) {
            other.vertex(part, vertex, point, 0);
        } else {
            System.arraycopy(other.column.rows(), part * Leaf.STRIDE, point, 0, 3);
        }
        return PointInMesh.holds(column, solid, point[0], point[1], point[2], s);
    }

    /** The vertex (0 if there are none) by which {@link #holds} finds a part inside; -1 if it is not inside. */
    int heldVertex(int solid, ObjectTree other, int part, LeafScratch s) {
        if (!other.kindOf(part).isMesh()) {
            return holds(solid, other, part, 0, s) ? 0 : -1;
        }
        for (int seed : other.column.mesh(part).seeds()) {
            if (holds(solid, other, part, seed, s)) {
                return seed;
            }
        }
        return -1;
    }

    /** The first triangle with a corner at a vertex; -1 if the part is not a mesh. */
    int triangleAt(int part, int vertex) {
        if (!column.kind(part).isMesh()) {
            return -1;
        }
        TriangleMesh mesh = column.mesh(part);
        for (int t = 0; t < mesh.size(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                if (isAt(mesh, mesh.vertex(t, corner), vertex)) {
                    return t;
                }
            }
        }
        throw new IllegalStateException("vertex must be a corner (got: " + vertex + ")");
    }

    private static boolean isAt(TriangleMesh mesh, int p, int q) {
        return mesh.coordinate(p, 0) == mesh.coordinate(q, 0)
                && mesh.coordinate(p, 1) == mesh.coordinate(q, 1)
                && mesh.coordinate(p, 2) == mesh.coordinate(q, 2);
    }

    /** Writes a vertex of a part that is a mesh. */
    void vertex(int part, int vertex, double[] out, int to) {
        TriangleMesh mesh = column.mesh(part);
        for (int axis = 0; axis < 3; axis++) {
            out[to + axis] = mesh.placed(vertex, axis, column.rows(), part * Leaf.STRIDE);
        }
    }

    /** Writes a point that is certainly below a place: of a convex leaf its centre, else a corner. */
    void point(long place, double[] out) {
        int part = part(place);
        int code = code(place);
        if (part < 0) {
            part = parts.item(firstItem(parts, code));
            code = 0;
        }
        if (column.kind(part) == LeafKind.PRISM) {
            prismPoint(column.rows(), part * Leaf.STRIDE, out);
            return;
        }
        if (!column.kind(part).isMesh()) {
            System.arraycopy(column.rows(), part * Leaf.STRIDE, out, 0, 3);
            return;
        }
        TriangleMesh mesh = column.mesh(part);
        int item = code < 0 ? ~code : firstItem(mesh.tree(), code);
        vertex(part, mesh.vertex(mesh.tree().item(item), 0), out, 0);
    }

    /** Half-way along X, and there half-way along Z and in height: a prism is given by ranges, and has no centre. */
    private static void prismPoint(double[] row, int at, double[] out) {
        double x = row[at] / 2 + row[at + 1] / 2;
        double least = Math.max(row[at + 2], Math.max(row[at + 4] - x, x - row[at + 7]));
        double most = Math.min(row[at + 3], Math.min(row[at + 5] - x, x - row[at + 6]));
        out[0] = x;
        out[1] = row[at + 8] / 2 + row[at + 9] / 2;
        out[2] = least / 2 + most / 2;
    }

    private static int firstItem(BoxTree tree, int node) {
        int leaf = node;
        while (!tree.isLeaf(leaf)) {
            leaf = tree.left(leaf);
        }
        return tree.first(leaf);
    }

    /** Writes the box of a place: minimum x, y, z, then maximum; in PLANAR all have the same heights. */
    void box(long place, double[] out) {
        int part = part(place);
        if (part < 0) {
            partsBox(code(place), out);
        } else if (!column.kind(part).isMesh()) {
            LeafBounds.of(column.kind(part), column.rows(), part * Leaf.STRIDE, out);
            widenUncertain(column.kind(part), out);
        } else if (code(place) < 0) {
            leaf(place);
            LeafBounds.of(LeafKind.TRIANGLE, triangle, 0, out);
        } else {
            meshBox(part, code(place), out);
        }
        if (flat) {
            out[1] = 0;
            out[4] = 0;
        }
    }

    /** Widens the box of a cylinder so that a box never decides a case in which {@link SpatialOverlap} is uncertain. */
    private static void widenUncertain(LeafKind kind, double[] box) {
        boolean isUncertain = switch (kind) {
            case UPRIGHT_CYLINDER, CYLINDER -> true;
            case UPRIGHT_BOX, SPHERE, BOX, TRIANGLE, PRISM, UPRIGHT_CAPSULE, CAPSULE -> false;
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
        if (isUncertain) {
            double pad = DOUBTFUL * BoxGap.size(box);
            for (int axis = 0; axis < 3; axis++) {
                box[axis] -= pad;
                box[3 + axis] += pad;
            }
        }
    }

    private void partsBox(int node, double[] out) {
        for (int axis = 0; axis < 3; axis++) {
            double middle = parts.middle(node, axis);
            double half = parts.half(node, axis);
            double pad = WIDEN * (Math.abs(middle) + half) + MeshWalk.UNDERFLOW;
            out[axis] = middle - half - pad;
            out[3 + axis] = middle + half + pad;
        }
    }

    private void meshBox(int part, int node, double[] out) {
        BoxTree tree = column.mesh(part).tree();
        double[] frame = column.rows();
        int c = part * Leaf.STRIDE;
        double middleX = tree.middle(node, 0);
        double middleY = tree.middle(node, 1);
        double middleZ = tree.middle(node, 2);
        double halfX = tree.half(node, 0);
        double halfY = tree.half(node, 1);
        double halfZ = tree.half(node, 2);
        double reach = Math.abs(middleX) + Math.abs(middleY) + Math.abs(middleZ) + halfX + halfY + halfZ;
        for (int axis = 0; axis < 3; axis++) {
            int r = c + Leaf.ROTATION + 3 * axis;
            double middle = frame[r] * middleX + frame[r + 1] * middleY + frame[r + 2] * middleZ + frame[c + axis];
            double half = Math.abs(frame[r]) * halfX + Math.abs(frame[r + 1]) * halfY + Math.abs(frame[r + 2]) * halfZ;
            double pad = WIDEN * (reach + Math.abs(frame[c + axis])) + MeshWalk.UNDERFLOW;
            out[axis] = middle - half - pad;
            out[3 + axis] = middle + half + pad;
        }
    }

    /** The kind of a part. */
    LeafKind kindOf(int part) {
        return column.kind(part);
    }

    LeafColumn column() {
        return column;
    }

    /** Whether two objects have to be swapped so that (a, b) and (b, a) become the same query. */
    static boolean isReversed(LeafColumn a, LeafColumn b) {
        int order = Integer.compare(a.size(), b.size());
        for (int part = 0; order == 0 && part < a.size(); part++) {
            order = a.kind(part).compareTo(b.kind(part));
            for (int k = part * Leaf.STRIDE; order == 0 && k < (part + 1) * Leaf.STRIDE; k++) {
                order = Double.compare(a.rows()[k], b.rows()[k]);
            }
        }
        for (int part = 0; order == 0 && part < a.size(); part++) {
            order = a.kind(part).isMesh() ? compare(a.mesh(part), b.mesh(part)) : 0;
        }
        return order > 0;
    }

    private static int compare(TriangleMesh a, TriangleMesh b) {
        int order = Integer.compare(a.size(), b.size());
        for (int t = 0; order == 0 && t < a.size(); t++) {
            for (int k = 0; order == 0 && k < 9; k++) {
                order = Double.compare(
                        a.coordinate(a.vertex(t, k / 3), k % 3), b.coordinate(b.vertex(t, k / 3), k % 3));
            }
        }
        return order;
    }
}
