package robosim.geometry.narrow.mesh;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.index.meshes.BoxTree;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.index.meshes.WideTree;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.MeshWalk;

/**
 * Casts a line through the tree of a placed mesh, front to back: finds the triangles that may be the nearest, and
 * passes each of them to the exact kernel. Most others are ruled out by conservative bounds.
 *
 * <p>The tree and the triangles are in the mesh's own frame, to which the line is transformed; the exact kernel uses
 * the placed corners in the world. {@link #pad} is more than the two can differ by, see {@link MeshWalk}. An instance
 * belongs to one owner of queries and allocates nothing.
 */
public final class MeshRay {
    /** The exact kernel. */
    public interface Judge {
        /**
         * Passes a triangle, given its position in the order of the leaves, to the exact kernel and returns the nearest
         * distance so far.
         */
        double judge(int place);
    }

    /**
     * How much the boxes are widened, in the tree's units, for the errors of computing in floats. The coordinates of boxes are
     * below 1.1 there and those of the start below 4.1: with u = 2^-24, the inverse is off by u of the centre, the start times
     * the inverse by u of itself, their sum by u of 5.2, the half size and the widening times the inverse by 2u of 1.2 and
     * their sum by u of 1.2, and the last sum or difference by u of 6.4: less than 21u of the inverse. This is 32u.
     */
    private static final double FLOAT_PAD = 0x1p-19;

    /** The smallest direction component along an axis; a smaller one does not leave its slab anywhere near the mesh. */
    private static final double FLATTEST = 0x1p-60;

    /**
     * A start no farther than this from the centre, on each axis and in the tree's units, needs not be advanced; and a line
     * enters the tree's box, which is widened by at most 1, within it.
     */
    private static final double NEAR = 4;

    /** Offsets in {@link #line}; the start is at 0. */
    static final int WAY = 3;

    static final int INVERSE = 6;
    static final int ENTRY = 9;

    private static final int INFINITE = Float.floatToRawIntBits(Float.POSITIVE_INFINITY);

    private static final long MISSED = (long) Integer.MAX_VALUE << 32;

    private final long[] stack = new long[3 * BoxTree.MAX_DEPTH];

    /**
     * The line: its start in the own frame; its unit direction, one world unit long, there; the reciprocal of that; and a
     * point of it in the tree's units, at the distance {@link #ahead}.
     */
    private final double[] line = new double[12];

    /** Whether heights do not count, and the mesh stands upright: then the line is seen from above in the own frame too. */
    private boolean isFlat;

    /** An upper bound of the error of any coordinate of the line or of a placed corner transformed to the own frame. */
    private double pad;

    /** An upper bound of the distance of any point of the mesh from the start, on any axis. */
    private double farthest;

    private double ahead;

    // For the box tests: the inverse direction and its magnitude, the widening times that, and the start times the
    // inverse, negated.
    private float fx;
    private float fy;
    private float fz;
    private float gx;
    private float gy;
    private float gz;
    private float wx;
    private float wy;
    private float wz;
    private float cx;
    private float cy;
    private float cz;

    private final TriangleLineFilter sieve = new TriangleLineFilter();

    /** Whether a line in a plane can be cast through the tree of a mesh: where the mesh stands upright. */
    public static boolean castsInPlane(LeafColumn column, int leaf) {
        double[] place = column.rows();
        int r = leaf * Leaf.STRIDE + Leaf.ROTATION;
        return place[r + 1] == 0 && place[r + 3] == 0 && place[r + 5] == 0 && place[r + 7] == 0;
    }

    /**
     * The line in the world, with its unit direction, or with its own where that has length 1 but for 2^-50, by which distances
     * along it are off. {@link #pad} is 16 times that of all coordinates, and no distance is more than twice these.
     *
     * @param dimension in PLANAR the line is level, and {@link #castsInPlane} holds
     */
    public void start(Dimension dimension, LeafColumn column, int leaf, BeamAxis beam) {
        isFlat = dimension == Dimension.PLANAR;
        boolean isUnit = Math.abs(beam.dx * beam.dx + beam.dy * beam.dy + beam.dz * beam.dz - 1) <= 0x1p-50;
        double ux = isUnit ? beam.dx : beam.ux();
        double uy = isUnit ? beam.dy : beam.uy();
        double uz = isUnit ? beam.dz : beam.uz();
        double[] place = column.rows();
        int at = leaf * Leaf.STRIDE;
        int r = at + Leaf.ROTATION;
        double x = beam.ox - place[at];
        double y = isFlat ? 0 : beam.oy - place[at + 1];
        double z = beam.oz - place[at + 2];
        double size = Math.abs(beam.ox) + Math.abs(beam.oz) + Math.abs(place[at]) + Math.abs(place[at + 2]);
        if (!isFlat) {
            size += Math.abs(beam.oy) + Math.abs(place[at + 1]);
        }
        double meshSize = column.mesh(leaf).tree().reach();
        double skew = 0;
        if (isUnturned(place, r)) {
            line[0] = x;
            line[1] = y;
            line[2] = z;
            line[WAY] = ux;
            line[WAY + 1] = uy;
            line[WAY + 2] = uz;
        } else {
            line[0] = place[r] * x + place[r + 3] * y + place[r + 6] * z;
            line[1] = place[r + 1] * x + place[r + 4] * y + place[r + 7] * z;
            line[2] = place[r + 2] * x + place[r + 5] * y + place[r + 8] * z;
            line[WAY] = place[r] * ux + place[r + 3] * uy + place[r + 6] * uz;
            line[WAY + 1] = place[r + 1] * ux + place[r + 4] * uy + place[r + 7] * uz;
            line[WAY + 2] = place[r + 2] * ux + place[r + 5] * uy + place[r + 8] * uz;
            skew = MeshWalk.skew(place, r);
        }
        farthest = size + meshSize;
        pad = MeshWalk.WIDEN * (size + meshSize) + skew * (size + meshSize) + MeshWalk.UNDERFLOW;
    }

    private static boolean isUnturned(double[] place, int r) {
        return place[r] == 1
                && place[r + 4] == 1
                && place[r + 8] == 1
                && place[r + 1] == 0
                && place[r + 2] == 0
                && place[r + 3] == 0
                && place[r + 5] == 0
                && place[r + 6] == 0
                && place[r + 7] == 0;
    }

    /** Passes all triangles that may be the nearest within a limit, at least 0, to the judge. */
    public void find(TriangleMesh mesh, double limit, Judge judge) {
        BoxTree tree = mesh.tree();
        double scale = tree.scale();
        if (!(pad * scale < 1)) { // the mesh is smaller than the rounding error of the query
            for (int k = 0; k < tree.size(); k++) {
                judge.judge(k);
            }
            return;
        }
        for (int axis = 0; axis < 3; axis++) {
            line[INVERSE + axis] = inverse(line[WAY + axis]);
        }
        if (!enter(tree)) {
            return;
        }
        double widened = (pad * scale + FLOAT_PAD) * (1 + 0x1p-20);
        if (isFlat) {
            sieve.aimInPlane(line, pad);
        } else {
            sieve.aim(line, pad, farthest);
        }
        sieve.open(mesh, limit, judge);
        setLine((float) widened);
        descend(mesh.wide().numbers(), scale);
        sieve.finish();
    }

    /** Converts the line to floats for the box tests. */
    private void setLine(float widen) {
        double ix = line[INVERSE];
        double iy = line[INVERSE + 1];
        double iz = line[INVERSE + 2];
        fx = (float) ix;
        fy = (float) iy;
        fz = (float) iz;
        gx = Math.abs(fx);
        gy = Math.abs(fy);
        gz = Math.abs(fz);
        wx = widen * gx;
        wy = widen * gy;
        wz = widen * gz;
        cx = (float) (-line[ENTRY] * ix);
        cy = (float) (-line[ENTRY + 1] * iy);
        cz = (float) (-line[ENTRY + 2] * iz);
        if (isFlat) { // at all heights at once
            fy = 0;
            gy = 0;
            cy = 0;
            wy = Float.POSITIVE_INFINITY;
        }
    }

    private void descend(float[] nodes, double scale) {
        long[] stack = this.stack;
        int within = within(scale);
        int depth = 0;
        int link = 0;
        while (true) {
            if (link >= 0) {
                long a = key(nodes, link, within);
                long b = key(nodes, link + WideTree.PART, within);
                long c = key(nodes, link + 2 * WideTree.PART, within);
                long d = key(nodes, link + 3 * WideTree.PART, within);
                // The nearest is found without branches, which would be unpredictable; the others are roughly in order,
                // which is good enough.
                long ab = lesser(a, b);
                long cd = lesser(c, d);
                long nearest = lesser(ab, cd);
                long third = greater(c, d);
                long fourth = greater(a, b);
                long second = greater(ab, cd);
                stack[depth] = fourth;
                depth += isHit(fourth);
                stack[depth] = third;
                depth += isHit(third);
                stack[depth] = second;
                depth += isHit(second);
                if (nearest < MISSED) {
                    link = (int) nearest;
                    continue;
                }
            } else {
                double before = sieve.reach();
                sieve.sift(WideTree.first(link), WideTree.last(link));
                if (sieve.reach() < before) {
                    within = within(scale);
                }
            }
            do {
                if (depth == 0) {
                    return;
                }
                depth--;
            } while ((int) (stack[depth] >>> 32) > within);
            link = (int) stack[depth];
        }
    }

    /**
     * Where the line enters a child, as the bits of a float of at least 0, with the link in the lower half; or {@link
     * #MISSED} in place of the former.
     */
    private long key(float[] nodes, int at, int within) {
        float tx = Math.fma(nodes[at], fx, cx);
        float ty = Math.fma(nodes[at + 1], fy, cy);
        float tz = Math.fma(nodes[at + 2], fz, cz);
        float hx = Math.fma(nodes[at + 3], gx, wx);
        float hy = Math.fma(nodes[at + 4], gy, wy);
        float hz = Math.fma(nodes[at + 5], gz, wz);
        int enter = Math.max(
                Math.max(Float.floatToRawIntBits(tx - hx), Float.floatToRawIntBits(ty - hy)),
                Math.max(Float.floatToRawIntBits(tz - hz), 0));
        int leave = Math.min(
                Math.min(Float.floatToRawIntBits(tx + hx), Float.floatToRawIntBits(ty + hy)),
                Math.min(Float.floatToRawIntBits(tz + hz), within));
        int missed = ((leave - enter) | leave) >> 31; // the difference can overflow only if `leave` is below 0
        return (((long) (enter | (missed >>> 1))) << 32)
                | (Float.floatToRawIntBits(nodes[at + WideTree.LINK]) & 0xffffffffL);
    }

    /** The bits of a number, which sort like the number; those of 0 if it is negative. */
    private static long positive(double value) {
        long bits = Double.doubleToRawLongBits(value);
        return bits & ~(bits >> 63);
    }

    private static long lesser(long a, long b) {
        return b + ((a - b) & ((a - b) >> 63));
    }

    private static long greater(long a, long b) {
        return a - ((a - b) & ((a - b) >> 63));
    }

    private static int isHit(long key) {
        return (int) ((key - MISSED) >>> 63);
    }

    private static double inverse(double slope) {
        return Math.abs(slope) < FLATTEST ? Math.copySign(1 / FLATTEST, slope) : 1 / slope;
    }

    /**
     * Takes the start in the tree's units, and advances from afar to the root's box, so that the floats are small.
     *
     * @return false if the line certainly misses that box
     */
    private boolean enter(BoxTree tree) {
        double scale = tree.scale();
        double x = (line[0] - tree.origin(0)) * scale;
        double y = isFlat ? 0 : (line[1] - tree.origin(1)) * scale;
        double z = (line[2] - tree.origin(2)) * scale;
        ahead = 0;
        line[ENTRY] = x;
        line[ENTRY + 1] = y;
        line[ENTRY + 2] = z;
        if (!isNear()) {
            advance(tree, x, y, z);
            return isNear();
        }
        return true;
    }

    private boolean isNear() {
        return Math.abs(line[ENTRY]) <= NEAR && Math.abs(line[ENTRY + 1]) <= NEAR && Math.abs(line[ENTRY + 2]) <= NEAR;
    }

    private void advance(BoxTree tree, double x, double y, double z) {
        float[] nodes = tree.numbers();
        double scale = tree.scale();
        double slack = 2 * pad * scale;
        long farX = positive((Math.abs(x) - nodes[3] - slack) * Math.abs(line[INVERSE]));
        long farY = positive((Math.abs(y) - nodes[4] - slack) * Math.abs(line[INVERSE + 1]));
        long farZ = positive((Math.abs(z) - nodes[5] - slack) * Math.abs(line[INVERSE + 2]));
        // If the box is hit at all, the line enters it only after reaching each of its slabs; if it is then already
        // past the point nearest to the centre, it is no farther from the centre than the corners.
        long nearest = positive(-(x * line[WAY] + y * line[WAY + 1] + z * line[WAY + 2]));
        ahead = Double.longBitsToDouble(lesser(greater(greater(farX, farY), farZ), nearest));
        line[ENTRY] = x + ahead * line[WAY];
        line[ENTRY + 1] = y + ahead * line[WAY + 1];
        line[ENTRY + 2] = z + ahead * line[WAY + 2];
    }

    /**
     * The reach in the tree's units, rounded up, as the bits of a float of at least 0; -1 if it ends before the box.
     */
    private int within(double scale) {
        double left = ((sieve.reach() + 4 * pad) * scale - ahead) * (1 + 0x1p-20) + FLOAT_PAD;
        return left >= 0 ? left < 0x1p100 ? Float.floatToRawIntBits((float) left) : INFINITE : -1;
    }
}
