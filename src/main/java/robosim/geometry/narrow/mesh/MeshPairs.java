package robosim.geometry.narrow.mesh;

import java.util.Arrays;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.index.meshes.BoxTree;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.MeshWalk;
import robosim.geometry.narrow.overlap.OverlapScratch;
import robosim.geometry.narrow.overlap.SpatialOverlap;

/**
 * Whether the surfaces of two placed meshes have a point in common: both trees are descended together, the more likely
 * pair of nodes first, until the exact kernel finds a pair of triangles that meet.
 *
 * <p>Boxes are in their meshes' own frames and so are rotated relative to each other, by one rotation for all pairs:
 * b's boxes are transformed to a's frame, and a pair is skipped if an own axis of either separates it (six of the
 * fifteen axes of Gottschalk, Lin and Manocha 1996; the other nine cost more than they save). {@link #pad} is more than
 * all rounding errors, including those of the placed corners, so that no pair that meets is missed. An instance belongs
 * to one owner of queries; nothing is allocated once the stacks have grown, except in exact decisions.
 */
public final class MeshPairs {
    private static final double APART = Double.POSITIVE_INFINITY;

    /** A box smaller than this fraction of the other is not split yet. */
    private static final double ALIKE = 0.5;

    /** So many pairs are counted together. */
    private static final int TOGETHER = 64;

    private static final double FARTHEST = Double.MAX_VALUE;

    private final OverlapScratch s;

    private int[] stackA = new int[128];
    private int[] stackB = new int[128];
    private double[] keys = new double[128];
    private int depth;

    // The rotation of b in a's frame, and its magnitudes.
    private double r00;
    private double r01;
    private double r02;
    private double r10;
    private double r11;
    private double r12;
    private double r20;
    private double r21;
    private double r22;
    private double m00;
    private double m01;
    private double m02;
    private double m10;
    private double m11;
    private double m12;
    private double m20;
    private double m21;
    private double m22;

    /** The origins of b's own frame, and of its tree, in a's own frame and in the units of a's tree. */
    private double ownX;

    private double ownY;
    private double ownZ;
    private double treeX;
    private double treeY;
    private double treeZ;

    /** Units of a's tree per unit of b's. */
    private double ratio;

    /**
     * An upper bound of the error of coordinates transformed from b's frame to a's; in a's own lengths and in its
     * tree's units.
     */
    private double pad;

    private double treePad;

    /** The corners of b's triangles of a leaf in a's own frame. */
    private final double[] taken = new double[9 * BoxTree.LEAF];

    /** Two boxes of a and two of b, nine numbers each. */
    private final double[] partA = new double[18];

    private final double[] partB = new double[18];

    private final double[] one = new double[9];

    private final double[] planeA = new double[4];
    private final double[] planeB = new double[4];
    private double doubt;

    MeshPairs(OverlapScratch scratch) {
        s = scratch;
    }

    public boolean touch(LeafColumn a, int i, LeafColumn b, int j) {
        // In the units of the larger one, so that transformed numbers stay within about 1.
        return a.mesh(i).tree().scale() <= b.mesh(j).tree().scale() ? descend(a, i, b, j) : descend(b, j, a, i);
    }

    private boolean descend(LeafColumn columnA, int i, LeafColumn columnB, int j) {
        TriangleMesh meshA = columnA.mesh(i);
        TriangleMesh meshB = columnB.mesh(j);
        BoxTree a = meshA.tree();
        BoxTree b = meshB.tree();
        s.leaf.outer.open(columnA, i);
        s.leaf.inner.open(columnB, j);
        place(columnA.rows(), i * Leaf.STRIDE, a, columnB.rows(), j * Leaf.STRIDE, b);
        float[] nodesA = a.numbers();
        float[] nodesB = b.numbers();
        depth = 0;
        loadA(nodesA, a.root(), 0);
        loadB(nodesB, b.root(), 0);
        pushAll(0, 1, 0, 1);
        int looked = 0;
        while (depth > 0) {
            if ((++looked & TOGETHER - 1) == 0) {
                s.leaf.work.take(TOGETHER);
            }
            depth--;
            int p = stackA[depth];
            int q = stackB[depth];
            int linkP = number(nodesA, p, BoxTree.LINK);
            int linkQ = number(nodesB, q, BoxTree.LINK);
            int countP = number(nodesA, p, BoxTree.COUNT);
            int countQ = number(nodesB, q, BoxTree.COUNT);
            if (countP > 0 && countQ > 0) {
                double reach = size(nodesA, p) / a.scale() + size(nodesB, q) / b.scale();
                if (leavesTouch(meshA, linkP, countP, meshB, linkQ, countQ, reach)) {
                    s.leaf.work.take(looked & TOGETHER - 1);
                    return true;
                }
                continue;
            }
            int partsA = 2;
            int partsB = 2;
            if (countP > 0 || (countQ == 0 && size(nodesA, p) < ALIKE * ratio * size(nodesB, q))) {
                linkP = p;
                partsA = 1;
            } else if (countQ > 0 || ratio * size(nodesB, q) < ALIKE * size(nodesA, p)) {
                linkQ = q;
                partsB = 1;
            }
            for (int k = 0; k < partsA; k++) {
                loadA(nodesA, linkP + k, 9 * k);
            }
            for (int k = 0; k < partsB; k++) {
                loadB(nodesB, linkQ + k, 9 * k);
            }
            pushAll(linkP, partsA, linkQ, partsB);
        }
        s.leaf.work.take(looked & TOGETHER - 1);
        return false;
    }

    private static double size(float[] nodes, int node) {
        int at = BoxTree.STRIDE * node + BoxTree.HALF;
        return (double) nodes[at] + nodes[at + 1] + nodes[at + 2];
    }

    /** Loads a box of a: centre, half sizes, and half of its extents along b's axes. */
    private void loadA(float[] nodes, int node, int to) {
        int at = BoxTree.STRIDE * node;
        double x = nodes[at + 3];
        double y = nodes[at + 4];
        double z = nodes[at + 5];
        partA[to] = nodes[at];
        partA[to + 1] = nodes[at + 1];
        partA[to + 2] = nodes[at + 2];
        partA[to + 3] = x;
        partA[to + 4] = y;
        partA[to + 5] = z;
        partA[to + 6] = m00 * x + m10 * y + m20 * z + treePad;
        partA[to + 7] = m01 * x + m11 * y + m21 * z + treePad;
        partA[to + 8] = m02 * x + m12 * y + m22 * z + treePad;
    }

    /**
     * Loads a box of b in the frame and units of a's tree: centre, half sizes, and half of its extents along a's axes.
     */
    private void loadB(float[] nodes, int node, int to) {
        int at = BoxTree.STRIDE * node;
        double px = nodes[at] * ratio;
        double py = nodes[at + 1] * ratio;
        double pz = nodes[at + 2] * ratio;
        double x = nodes[at + 3] * ratio;
        double y = nodes[at + 4] * ratio;
        double z = nodes[at + 5] * ratio;
        partB[to] = r00 * px + r01 * py + r02 * pz + treeX;
        partB[to + 1] = r10 * px + r11 * py + r12 * pz + treeY;
        partB[to + 2] = r20 * px + r21 * py + r22 * pz + treeZ;
        partB[to + 3] = x;
        partB[to + 4] = y;
        partB[to + 5] = z;
        partB[to + 6] = m00 * x + m01 * y + m02 * z + treePad;
        partB[to + 7] = m10 * x + m11 * y + m12 * z + treePad;
        partB[to + 8] = m20 * x + m21 * y + m22 * z + treePad;
    }

    /** Pushes the pairs of children that may meet, the one with the nearest centres last. */
    private void pushAll(int a, int partsA, int b, int partsB) {
        int base = depth;
        if (depth + 4 > stackA.length) {
            stackA = Arrays.copyOf(stackA, 2 * depth);
            stackB = Arrays.copyOf(stackB, 2 * depth);
            keys = Arrays.copyOf(keys, 2 * depth);
        }
        for (int i = 0; i < partsA; i++) {
            for (int j = 0; j < partsB; j++) {
                double key = apart(9 * i, 9 * j);
                if (key < APART) {
                    int to = depth++;
                    while (to > base && keys[to - 1] < key) {
                        keys[to] = keys[to - 1];
                        stackA[to] = stackA[to - 1];
                        stackB[to] = stackB[to - 1];
                        to--;
                    }
                    keys[to] = key;
                    stackA[to] = a + i;
                    stackB[to] = b + j;
                }
            }
        }
    }

    /** The squared distance of the centres of two boxes, or {@link #APART} if a side of one separates them. */
    private double apart(int i, int j) {
        double x = partB[j] - partA[i];
        double y = partB[j + 1] - partA[i + 1];
        double z = partB[j + 2] - partA[i + 2];
        if (Math.abs(x) > partA[i + 3] + partB[j + 6]
                || Math.abs(y) > partA[i + 4] + partB[j + 7]
                || Math.abs(z) > partA[i + 5] + partB[j + 8]
                || Math.abs(x * r00 + y * r10 + z * r20) > partB[j + 3] + partA[i + 6]
                || Math.abs(x * r01 + y * r11 + z * r21) > partB[j + 4] + partA[i + 7]
                || Math.abs(x * r02 + y * r12 + z * r22) > partB[j + 5] + partA[i + 8]) {
            return APART;
        }
        double square = x * x + y * y + z * z;
        return square < FARTHEST ? square : FARTHEST; // if beyond that or NaN, nothing is known
    }

    private static int number(float[] nodes, int node, int which) {
        return Float.floatToRawIntBits(nodes[BoxTree.STRIDE * node + which]);
    }

    private void place(double[] a, int i, BoxTree treeA, double[] b, int j, BoxTree treeB) {
        int p = i + Leaf.ROTATION;
        int q = j + Leaf.ROTATION;
        r00 = a[p] * b[q] + a[p + 3] * b[q + 3] + a[p + 6] * b[q + 6];
        r01 = a[p] * b[q + 1] + a[p + 3] * b[q + 4] + a[p + 6] * b[q + 7];
        r02 = a[p] * b[q + 2] + a[p + 3] * b[q + 5] + a[p + 6] * b[q + 8];
        r10 = a[p + 1] * b[q] + a[p + 4] * b[q + 3] + a[p + 7] * b[q + 6];
        r11 = a[p + 1] * b[q + 1] + a[p + 4] * b[q + 4] + a[p + 7] * b[q + 7];
        r12 = a[p + 1] * b[q + 2] + a[p + 4] * b[q + 5] + a[p + 7] * b[q + 8];
        r20 = a[p + 2] * b[q] + a[p + 5] * b[q + 3] + a[p + 8] * b[q + 6];
        r21 = a[p + 2] * b[q + 1] + a[p + 5] * b[q + 4] + a[p + 8] * b[q + 7];
        r22 = a[p + 2] * b[q + 2] + a[p + 5] * b[q + 5] + a[p + 8] * b[q + 8];
        m00 = Math.abs(r00);
        m01 = Math.abs(r01);
        m02 = Math.abs(r02);
        m10 = Math.abs(r10);
        m11 = Math.abs(r11);
        m12 = Math.abs(r12);
        m20 = Math.abs(r20);
        m21 = Math.abs(r21);
        m22 = Math.abs(r22);
        double x = b[j] - a[i];
        double y = b[j + 1] - a[i + 1];
        double z = b[j + 2] - a[i + 2];
        ownX = a[p] * x + a[p + 3] * y + a[p + 6] * z;
        ownY = a[p + 1] * x + a[p + 4] * y + a[p + 7] * z;
        ownZ = a[p + 2] * x + a[p + 5] * y + a[p + 8] * z;
        double scale = treeA.scale();
        double ox = treeB.origin(0);
        double oy = treeB.origin(1);
        double oz = treeB.origin(2);
        treeX = (r00 * ox + r01 * oy + r02 * oz + ownX - treeA.origin(0)) * scale;
        treeY = (r10 * ox + r11 * oy + r12 * oz + ownY - treeA.origin(1)) * scale;
        treeZ = (r20 * ox + r21 * oy + r22 * oz + ownZ - treeA.origin(2)) * scale;
        ratio = scale / treeB.scale();
        double size = treeA.reach() + treeB.reach();
        for (int k = 0; k < 3; k++) {
            size += Math.abs(a[i + k]) + Math.abs(b[j + k]);
        }
        double skew = MeshWalk.skew(a, p) + MeshWalk.skew(b, q);
        pad = 4 * (MeshWalk.WIDEN + skew) * size + MeshWalk.UNDERFLOW;
        treePad = pad * scale;
    }

    private boolean leavesTouch(
            TriangleMesh meshA, int firstA, int countA, TriangleMesh meshB, int firstB, int countB, double reach) {
        double[] corners = meshA.leafCorners();
        int k = 9 * firstA;
        take(meshB.leafCorners(), 9 * firstB, 9 * countB, corners[k], corners[k + 1], corners[k + 2]);
        // Since the boxes meet, no two corners of the two leaves are farther apart than the sum of both boxes' lengths.
        double d = 4 * reach + pad;
        // A volume is a normal's dot product with an offset. Each coordinate is off by a quarter of a pad, a
        // side and an offset by twice that; so the normal by 2 pads d, the volume by 3 pads d^2, and by less
        // than 30u d^3 of rounding.
        doubt = FilterBound.bound((16 * pad + 0x1p-46 * d) * d * d + VectorMath.UNDERFLOW);
        for (int p = firstA; p < firstA + countA; p++) {
            for (int c = 0; c < 9; c += 3) {
                one[c] = corners[9 * p + c] - corners[k];
                one[c + 1] = corners[9 * p + c + 1] - corners[k + 1];
                one[c + 2] = corners[9 * p + c + 2] - corners[k + 2];
            }
            plane(one, 0, planeA);
            for (int q = 0; q < countB; q++) {
                if (!isBeside(planeA, taken, 9 * q) && !isBesideOf(q) && hit(p, firstB + q)) {
                    return true;
                }
            }
        }
        return false;
    }

    private void take(double[] corners, int from, int count, double fromX, double fromY, double fromZ) {
        double ox = ownX - fromX;
        double oy = ownY - fromY;
        double oz = ownZ - fromZ;
        for (int k = 0; k < count; k += 3) {
            double x = corners[from + k];
            double y = corners[from + k + 1];
            double z = corners[from + k + 2];
            taken[k] = r00 * x + r01 * y + r02 * z + ox;
            taken[k + 1] = r10 * x + r11 * y + r12 * z + oy;
            taken[k + 2] = r20 * x + r21 * y + r22 * z + oz;
        }
    }

    private boolean hit(int p, int q) {
        s.leaf.outer.corners(p, s.leaf.triangleA, 0);
        s.leaf.inner.corners(q, s.leaf.triangleB, 0);
        return SpatialOverlap.test(s.leaf.faceA, s.leaf.faceB, s);
    }

    /** Whether the current triangle of a is certainly on one side of the plane of one of b's. */
    private boolean isBesideOf(int q) {
        plane(taken, 9 * q, planeB);
        return isBeside(planeB, one, 0);
    }

    private static void plane(double[] t, int i, double[] out) {
        double ex = t[i + 3] - t[i];
        double ey = t[i + 4] - t[i + 1];
        double ez = t[i + 5] - t[i + 2];
        double fx = t[i + 6] - t[i];
        double fy = t[i + 7] - t[i + 1];
        double fz = t[i + 8] - t[i + 2];
        double nx = ey * fz - ez * fy;
        double ny = ez * fx - ex * fz;
        double nz = ex * fy - ey * fx;
        out[0] = nx;
        out[1] = ny;
        out[2] = nz;
        out[3] = nx * t[i] + ny * t[i + 1] + nz * t[i + 2];
    }

    private boolean isBeside(double[] plane, double[] t, int i) {
        double nx = plane[0];
        double ny = plane[1];
        double nz = plane[2];
        double low = plane[3] - doubt;
        double high = plane[3] + doubt;
        double u = nx * t[i] + ny * t[i + 1] + nz * t[i + 2];
        double v = nx * t[i + 3] + ny * t[i + 4] + nz * t[i + 5];
        double w = nx * t[i + 6] + ny * t[i + 7] + nz * t[i + 8];
        return (u > high && v > high && w > high) || (u < low && v < low && w < low);
    }
}
