package robosim.geometry.narrow.mesh;

import java.util.Arrays;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.distance.ContactPoint;
import robosim.geometry.narrow.distance.DistanceScratch;
import robosim.geometry.narrow.leaf.BoxGap;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.ConvexOverlap;

/**
 * The pairs of convex leaves and triangles of two objects that have a point in common, found by descending both trees
 * at once. Which pairs are found first does not depend on the order of the two objects. An instance belongs to one
 * owner of queries; nothing is allocated once its arrays have grown, except in exact decisions.
 */
public final class ContactPairs {
    private static final int NO_SIDE = 0;
    private static final int FIRST_HOLDS = 1;
    private static final int SECOND_HOLDS = 2;

    private final DistanceScratch s;
    private final ObjectTree first = new ObjectTree();
    private final ObjectTree second = new ObjectTree();
    private final double[] boxA = new double[6];
    private final double[] boxB = new double[6];
    private final double[] childBox = new double[6];
    private Dimension dimension = Dimension.SPATIAL;
    private boolean isReversed;
    private int limit;

    private long[] stackA = new long[64];
    private long[] stackB = new long[64];
    private int depth;

    /**
     * Five numbers per pair: part and triangle (-1 if none) of the first, then of the second, then which contains the
     * other.
     */
    private int[] found = new int[80];

    private boolean[] certain = new boolean[16];
    private int count;

    public ContactPairs(DistanceScratch scratch) {
        s = scratch;
    }

    /** Whether two parts have a point in common: stops at the first pair. */
    public boolean touch(Dimension dimension, LeafColumn a, int i, LeafColumn b, int j) {
        this.dimension = dimension;
        limit = 1;
        isReversed = false;
        first.openPart(a, i, dimension);
        second.openPart(b, j, dimension);
        count = 0;
        depth = 0;
        if (rootsOverlap()) {
            findInParts(first.root(), second.root());
        }
        return count > 0;
    }

    /** Finds all pairs, up to the limit, which must be at least 1. */
    public void find(Dimension dimension, LeafColumn a, LeafColumn b, int limit) {
        this.dimension = dimension;
        this.limit = limit;
        isReversed = ObjectTree.isReversed(a, b);
        first.open(isReversed ? b : a, dimension);
        second.open(isReversed ? a : b, dimension);
        count = 0;
        depth = 0;
        if (rootsOverlap()) {
            push(first.root(), second.root());
        }
        while (depth > 0 && count < limit) {
            s.leaf.work.take();
            depth--;
            long p = stackA[depth];
            long q = stackB[depth];
            if (ObjectTree.isPart(p) && ObjectTree.isPart(q)) {
                findInParts(p, q);
            } else {
                open(p, q);
            }
        }
    }

    private boolean rootsOverlap() {
        first.box(first.root(), boxA);
        second.box(second.root(), boxB);
        return BoxGap.hit(boxA, boxB);
    }

    /** Releases the objects and the pairs. */
    public void close() {
        first.close();
        second.close();
        count = 0;
    }

    public int count() {
        return count;
    }

    /** The part of the object that was given first. */
    public int partA(int k) {
        return found[5 * k + (isReversed ? 2 : 0)];
    }

    public int partB(int k) {
        return found[5 * k + (isReversed ? 0 : 2)];
    }

    /** The face of that part; -1 if it is not a mesh or is in contact by its inside. */
    public int faceA(int k) {
        return face(isReversed ? second : first, partA(k), found[5 * k + (isReversed ? 3 : 1)]);
    }

    public int faceB(int k) {
        return face(isReversed ? first : second, partB(k), found[5 * k + (isReversed ? 1 : 3)]);
    }

    /** Which triangle of the face it is, 0 or 1; -1 if there is no face. */
    public int halfA(int k) {
        return half(isReversed ? second : first, partA(k), found[5 * k + (isReversed ? 3 : 1)]);
    }

    public int halfB(int k) {
        return half(isReversed ? first : second, partB(k), found[5 * k + (isReversed ? 1 : 3)]);
    }

    /** Whether it is proven that the pair touches. */
    public boolean isCertain(int k) {
        return certain[k];
    }

    private static int face(ObjectTree of, int part, int triangle) {
        return triangle < 0 ? -1 : of.column().mesh(part).face(triangle);
    }

    private static int half(ObjectTree of, int part, int triangle) {
        if (triangle < 0) {
            return -1;
        }
        TriangleMesh mesh = of.column().mesh(part);
        return triangle > 0 && mesh.face(triangle - 1) == mesh.face(triangle) ? 1 : 0;
    }

    /**
     * Writes the contact of a pair.
     *
     * @param out seven numbers: a point, a unit normal from b towards a, and an upper bound of the point's distance
     *     from either
     */
    public void witness(int k, double[] out) {
        int at = 5 * k;
        int side = found[at + 4];
        if (side != NO_SIDE) {
            inside(side == FIRST_HOLDS ? second : first, at + (side == FIRST_HOLDS ? 2 : 0), out);
            out[4] = (side == FIRST_HOLDS) == isReversed ? 1 : -1;
            return;
        }
        ObjectTree a = isReversed ? second : first;
        ObjectTree b = isReversed ? first : second;
        Leaf leafA = a.leaf(partA(k), found[at + (isReversed ? 3 : 1)]);
        Leaf leafB = b.leaf(partB(k), found[at + (isReversed ? 1 : 3)]);
        ContactPoint.of(dimension, leafA, leafB, out, s);
    }

    /** Writes a point of a piece inside a solid, which is a point of both. */
    private void inside(ObjectTree held, int at, double[] out) {
        Leaf leaf = held.leaf(found[at], found[at + 1]);
        System.arraycopy(leaf.row, leaf.at, out, 0, 3);
        Arrays.fill(out, 3, 7, 0);
    }

    private void findInParts(long a, long b) {
        int before = count;
        int base = depth;
        push(a, b);
        while (depth > base && count < limit) {
            s.leaf.work.take();
            depth--;
            long p = stackA[depth];
            long q = stackB[depth];
            if (first.isLeaf(p) && second.isLeaf(q)) {
                test(p, q);
            } else {
                open(p, q);
            }
        }
        if (count == before && dimension == Dimension.SPATIAL) {
            findInside(ObjectTree.part(a), ObjectTree.part(b));
        }
    }

    private void test(long a, long b) {
        s.overlap.uncertain = false;
        if (ConvexOverlap.test(dimension, first.leaf(a), second.leaf(b), s.overlap)) {
            add(
                    ObjectTree.part(a),
                    first.triangle(a),
                    ObjectTree.part(b),
                    second.triangle(b),
                    NO_SIDE,
                    !s.overlap.uncertain);
        }
    }

    /** For two parts whose surfaces do not meet, finds whether one is inside the other. */
    private void findInside(int a, int b) {
        if (first.kindOf(a) == LeafKind.SOLID_MESH) {
            int vertex = first.heldVertex(a, second, b, s.leaf);
            if (vertex >= 0) {
                add(a, -1, b, second.triangleAt(b, vertex), FIRST_HOLDS, true);
                return;
            }
        }
        if (second.kindOf(b) == LeafKind.SOLID_MESH) {
            int vertex = second.heldVertex(b, first, a, s.leaf);
            if (vertex >= 0) {
                add(a, first.triangleAt(a, vertex), b, -1, SECOND_HOLDS, true);
            }
        }
    }

    private void add(int partA, int triangleA, int partB, int triangleB, int side, boolean isCertain) {
        if (count == certain.length) {
            certain = Arrays.copyOf(certain, 2 * count);
            found = Arrays.copyOf(found, 10 * count);
        }
        certain[count] = isCertain;
        int at = 5 * count++;
        found[at] = partA;
        found[at + 1] = triangleA;
        found[at + 2] = partB;
        found[at + 3] = triangleB;
        found[at + 4] = side;
    }

    private void open(long a, long b) {
        first.box(a, boxA);
        second.box(b, boxB);
        boolean opensFirst = NearestPairs.opensFirst(first, a, boxA, second, b, boxB);
        ObjectTree opened = opensFirst ? first : second;
        long parent = opensFirst ? a : b;
        double[] other = opensFirst ? boxB : boxA;
        for (int k = opened.children(parent) - 1; k >= 0; k--) {
            long child = opened.child(parent, k);
            opened.box(child, childBox);
            if (BoxGap.hit(childBox, other)) {
                push(opensFirst ? child : a, opensFirst ? b : child);
            }
        }
    }

    private void push(long a, long b) {
        if (depth == stackA.length) {
            stackA = Arrays.copyOf(stackA, 2 * depth);
            stackB = Arrays.copyOf(stackB, 2 * depth);
        }
        stackA[depth] = a;
        stackB[depth++] = b;
    }
}
