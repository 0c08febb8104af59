package robosim.geometry.narrow.mesh;

import robosim.geometry.exact.Filter;
import robosim.geometry.index.boxes.BoxTree;
import robosim.geometry.index.boxes.WideTree;
import robosim.geometry.model.TriangleMesh;
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
     * How much the boxes are widened, in the tree's units, for the errors of computing in floats. All coordinates are
     * below 1.1 there: with u = 2^-24, the inverse is off by u of an offset of 2.2, the start times the inverse by u of
     * 1.1, the two sums by u of 2.2 and 3.4, the half size times the inverse by 2u of 1.1: less than 12u, this is 16u.
     */
    private static final double FLOAT_PAD = 0x1p-19;

    /** The smallest direction component along an axis; a smaller one does not leave its slab anywhere near the mesh. */
    private static final double FLATTEST = 0x1p-60;

    /** A bound of the distance from the centre at which a line enters the tree's box, which is widened by at most 1. */
    private static final double FARTHEST = 4;

    private static final int INFINITE = Float.floatToRawIntBits(Float.POSITIVE_INFINITY);

    private static final long MISSED = (long) Integer.MAX_VALUE << 32;

    private final long[] stack = new long[3 * BoxTree.MAX_DEPTH];

    // The line in the own frame; its unit direction is one world unit long.
    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;

    /** The reciprocal of the direction. */
    private double ix;

    private double iy;
    private double iz;

    /** An upper bound of the error of any coordinate of the line or of a placed corner transformed to the own frame. */
    private double pad;

    /** An upper bound of the distance of any point of the mesh from the start, on any axis. */
    private double farthest;

    /** An upper bound of any triangle's {@link #doubt}. */
    private double mostDoubt;

    // The line in the tree's units, from its entry into the root's box, at the distance `ahead`.
    private double ahead;
    private double startX;
    private double startY;
    private double startZ;

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

    // Two directions perpendicular to the line, and the line's position along them.
    private double px;
    private double py;
    private double pz;
    private double pLine;
    private double qx;
    private double qy;
    private double qz;
    private double qLine;
    private double dLine;

    // The nearest triangle so far that is certainly hit, between two bounds, and has not been passed to the exact
    // kernel.
    private int pending;
    private double pendingFrom;

    private double reach;

    /**
     * The line in the world; the direction has length 1.
     */
    public void start(LeafColumn column, int leaf, double wx, double wy, double wz, double ux, double uy, double uz) {
        double[] place = column.rows();
        int at = leaf * Leaf.STRIDE;
        int r = at + Leaf.ROTATION;
        double x = wx - place[at];
        double y = wy - place[at + 1];
        double z = wz - place[at + 2];
        double size = Math.abs(wx)
                + Math.abs(wy)
                + Math.abs(wz)
                + Math.abs(place[at])
                + Math.abs(place[at + 1])
                + Math.abs(place[at + 2]);
        double meshSize = column.mesh(leaf).tree().reach();
        double skew = 0;
        if (isUnturned(place, r)) {
            ox = x;
            oy = y;
            oz = z;
            dx = ux;
            dy = uy;
            dz = uz;
        } else {
            ox = place[r] * x + place[r + 3] * y + place[r + 6] * z;
            oy = place[r + 1] * x + place[r + 4] * y + place[r + 7] * z;
            oz = place[r + 2] * x + place[r + 5] * y + place[r + 8] * z;
            dx = place[r] * ux + place[r + 3] * uy + place[r + 6] * uz;
            dy = place[r + 1] * ux + place[r + 4] * uy + place[r + 7] * uz;
            dz = place[r + 2] * ux + place[r + 5] * uy + place[r + 8] * uz;
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

    /** Computes two directions perpendicular to the line and to each other, without a branch (Duff and others 2017). */
    private void setAcross() {
        double sign = Math.copySign(1, dz);
        double a = -1 / (sign + dz);
        double b = dx * dy * a;
        px = 1 + sign * dx * dx * a;
        py = sign * b;
        pz = -sign * dx;
        qx = b;
        qy = sign + dy * dy * a;
        qz = -dy;
        pLine = px * ox + py * oy + pz * oz;
        qLine = qx * ox + qy * oy + qz * oz;
        mostDoubt = doubt(12 * farthest);
        dLine = dx * ox + dy * oy + dz * oz;
    }

    /** Passes all triangles that may be the nearest within a limit, at least 0, to the judge. */
    public void find(TriangleMesh mesh, double limit, Judge judge) {
        BoxTree tree = mesh.tree();
        double scale = tree.scale();
        reach = limit;
        pending = -1;
        if (!(pad * scale < 1)) { // the mesh is smaller than the rounding error of the query
            for (int k = 0; k < tree.size(); k++) {
                judge.judge(k);
            }
            return;
        }
        ix = inverse(dx);
        iy = inverse(dy);
        iz = inverse(dz);
        enter(tree);
        if (Math.abs(startX) > FARTHEST || Math.abs(startY) > FARTHEST || Math.abs(startZ) > FARTHEST) {
            return;
        }
        setAcross();
        setLine((float) ((pad * scale + FLOAT_PAD) * (1 + 0x1p-20)));
        descend(tree, mesh.leafCorners(), judge);
        if (pending >= 0) {
            judge.judge(pending);
        }
    }

    /** Converts the line to floats for the box tests. */
    private void setLine(float widen) {
        fx = (float) ix;
        fy = (float) iy;
        fz = (float) iz;
        gx = Math.abs(fx);
        gy = Math.abs(fy);
        gz = Math.abs(fz);
        wx = widen * gx;
        wy = widen * gy;
        wz = widen * gz;
        cx = (float) (-startX * ix);
        cy = (float) (-startY * iy);
        cz = (float) (-startZ * iz);
    }

    private void descend(BoxTree tree, double[] corners, Judge judge) {
        double scale = tree.scale();
        float[] nodes = tree.wide().numbers();
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
                depth += isMet(fourth);
                stack[depth] = third;
                depth += isMet(third);
                stack[depth] = second;
                depth += isMet(second);
                if (nearest < MISSED) {
                    link = (int) nearest;
                    continue;
                }
            } else {
                double before = reach;
                int end = WideTree.last(link);
                for (int k = WideTree.first(link); k <= end; k++) {
                    tryTriangle(corners, k, judge);
                }
                if (reach < before) {
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

    private static int isMet(long key) {
        return (int) ((key - MISSED) >>> 63);
    }

    private static double inverse(double slope) {
        return Math.abs(slope) < FLATTEST ? Math.copySign(1 / FLATTEST, slope) : 1 / slope;
    }

    /** Advances to the root's box, so that the floats are small. */
    private void enter(BoxTree tree) {
        float[] nodes = tree.numbers();
        double scale = tree.scale();
        double x = (ox - tree.origin(0)) * scale;
        double y = (oy - tree.origin(1)) * scale;
        double z = (oz - tree.origin(2)) * scale;
        double slack = 2 * pad * scale;
        long farX = positive((Math.abs(x) - nodes[3] - slack) * Math.abs(ix));
        long farY = positive((Math.abs(y) - nodes[4] - slack) * Math.abs(iy));
        long farZ = positive((Math.abs(z) - nodes[5] - slack) * Math.abs(iz));
        // If the box is hit at all, the line enters it only after reaching each of its slabs; if it is then already
        // past the point nearest to the centre, it is no farther from the centre than the corners.
        long nearest = positive(-(x * dx + y * dy + z * dz));
        ahead = Double.longBitsToDouble(lesser(greater(greater(farX, farY), farZ), nearest));
        startX = x + ahead * dx;
        startY = y + ahead * dy;
        startZ = z + ahead * dz;
    }

    /**
     * The reach in the tree's units, rounded up, as the bits of a float of at least 0; -1 if it ends before the box.
     */
    private int within(double scale) {
        double left = ((reach + 4 * pad) * scale - ahead) * (1 + 0x1p-20) + FLOAT_PAD;
        return left >= 0 ? left < 0x1p100 ? Float.floatToRawIntBits((float) left) : INFINITE : -1;
    }

    private void tryTriangle(double[] c, int place, Judge judge) {
        int k = 9 * place;
        double ax = Math.fma(px, c[k], Math.fma(py, c[k + 1], Math.fma(pz, c[k + 2], -pLine)));
        double ay = Math.fma(qx, c[k], Math.fma(qy, c[k + 1], Math.fma(qz, c[k + 2], -qLine)));
        double bx = Math.fma(px, c[k + 3], Math.fma(py, c[k + 4], Math.fma(pz, c[k + 5], -pLine)));
        double by = Math.fma(qx, c[k + 3], Math.fma(qy, c[k + 4], Math.fma(qz, c[k + 5], -qLine)));
        double cx = Math.fma(px, c[k + 6], Math.fma(py, c[k + 7], Math.fma(pz, c[k + 8], -pLine)));
        double cy = Math.fma(qx, c[k + 6], Math.fma(qy, c[k + 7], Math.fma(qz, c[k + 8], -qLine)));
        double u = bx * cy - by * cx;
        double v = cx * ay - cy * ax;
        double w = ax * by - ay * bx;
        double most = mostDoubt;
        long below = sign(u + most) | sign(v + most) | sign(w + most); // one is certainly below 0
        long above = sign(most - u) | sign(most - v) | sign(most - w);
        if ((below & above) < 0) {
            return;
        }
        double doubt = doubt(Math.abs(ax) + Math.abs(ay) + Math.abs(bx) + Math.abs(by) + Math.abs(cx) + Math.abs(cy));
        boolean isBelow = u < -doubt || v < -doubt || w < -doubt;
        boolean isAbove = u > doubt || v > doubt || w > doubt;
        if (isBelow && isAbove) {
            return;
        }
        boolean isMet = (u > doubt && v > doubt && w > doubt) || (u < -doubt && v < -doubt && w < -doubt);
        if (!isMet) {
            reach = Math.min(reach, judge.judge(place));
            return;
        }
        double a = dx * c[k] + dy * c[k + 1] + dz * c[k + 2] - dLine;
        double b = dx * c[k + 3] + dy * c[k + 4] + dz * c[k + 5] - dLine;
        double e = dx * c[k + 6] + dy * c[k + 7] + dz * c[k + 8] - dLine;
        double whole = u + v + w;
        double distance = (u * a + v * b + w * e) / whole;
        double spread = Math.abs(a - b) + Math.abs(b - e) + Math.abs(e - a);
        double error = Filter.bound(8 * pad + spread * (16 * doubt / Math.abs(whole)));
        if (distance - error > reach || distance + error < 0) {
            return;
        }
        if (!(distance - error >= 0)) { // the line may start beyond it
            reach = Math.min(reach, judge.judge(place));
            return;
        }
        if (pending >= 0 && distance + error >= pendingFrom) {
            judge.judge(pending);
            pending = -1;
            reach = Math.min(reach, judge.judge(place));
            return;
        }
        pending = place;
        pendingFrom = distance - error;
        reach = Math.min(reach, distance + error);
    }

    /**
     * The error of the area spanned by two of a triangle's corners, given the sum of all six coordinates across the
     * line: each of these is off by 4 pads at most, and the two products and their difference by 3u of a quarter of the
     * sum's square.
     */
    private double doubt(double sum) {
        return Filter.bound(sum * (4 * pad + 0x1p-51 * sum) + 32 * pad * pad);
    }

    private static long sign(double value) {
        return Double.doubleToRawLongBits(value);
    }
}
