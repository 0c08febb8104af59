package robosim.geometry.narrow.mesh;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.index.meshes.BoxTree;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.MeshWalk;

/**
 * Casts a planar line, a sector or a cone through the tree of a placed mesh, nearest first: passes the triangles that
 * may be hit within a limit to the exact kernel, and skips boxes and triangles that are certainly outside the beam or
 * its limit. The bounds are conservative.
 *
 * <p>In the plane a beam is a sector, of width zero for a line. Each of its directions g is transformed once to the
 * tree's frame: with {@code x = R v + c - o} relative to the start, {@code g.x = (R'g).v + g.(c - o)} for every point v
 * of the mesh, whatever R is. In space the cone is transformed to the own frame, see {@link #isBeyondCone}. {@link
 * #pad} is more than the difference between the numbers here and those of the kernel. An instance belongs to one owner
 * of queries and allocates nothing.
 */
public final class MeshBeamSearch {
    /** The offsets of a planar direction's numbers: three in the own frame, and its product with {@code c - o}. */
    private static final int AHEAD = 0;

    private static final int LEFT = 4;
    private static final int RIGHT = 8;

    /** The directions of X and Z. */
    private static final int EAST = 12;

    private static final int SOUTH = 16;

    /** If squares may overflow, nothing is skipped. */
    private static final double HUGE = 0x1p400;

    /** Below this a square may have lost bits to underflow. */
    private static final double TINY_SQUARE = 0x1p-900;

    private final int[] stack = new int[BoxTree.MAX_DEPTH + 2];
    private final double[] keys = new double[BoxTree.MAX_DEPTH + 2];

    private final double[] directions = new double[20];

    /** The same in a tree's units, for a line: what its nodes' numbers are multiplied by. */
    private final double[] inTree = new double[8];

    private float[] nodes = new float[0];
    private boolean isPlanar;
    private boolean isLine;

    // The apex and the unit axis of a cone in space, in the own frame, and the cone.
    private double ox;
    private double oy;
    private double oz;
    private double ux;
    private double uy;
    private double uz;
    private double cos;
    private double sin;

    /**
     * The largest difference between a number computed here for a point and that of the kernel. With u = 2^-53,
     * relative to all operands, a planar product is off by 10 u, its direction by 8 u, a placed corner by 16 u and the
     * kernel's distance by 8 ulp, 16 u; 128 u are used. In space a rotation that is not exactly orthonormal adds to it,
     * see {@link #isBeyondCone}.
     */
    private double pad;

    /** The factor that makes distances in the own frame lower bounds in the world. */
    private double shrink;

    /** Starts a line or a sector in the plane, defined by the cosine of its half angle, from which the sine is computed. */
    public void startSector(LeafColumn column, int leaf, BeamAxis beam) {
        isPlanar = true;
        isLine = !beam.isCone;
        double dx = beam.ux();
        double dz = beam.uz();
        double halfCos = beam.isCone ? beam.cos : 1;
        double[] place = column.rows();
        int at = leaf * Leaf.STRIDE;
        double cx = place[at] - beam.ox;
        double cz = place[at + 2] - beam.oz;
        double halfSin = Math.sqrt((1 - halfCos) * (1 + halfCos));
        direction(AHEAD, dx, dz, place, at, cx, cz);
        // Pointing away from the sector.
        direction(LEFT, -(dx * halfSin + dz * halfCos), dx * halfCos - dz * halfSin, place, at, cx, cz);
        direction(RIGHT, dz * halfCos - dx * halfSin, -(dx * halfCos + dz * halfSin), place, at, cx, cz);
        direction(EAST, 1, 0, place, at, cx, cz);
        direction(SOUTH, 0, 1, place, at, cx, cz);
        double size = Math.abs(beam.ox)
                + Math.abs(beam.oz)
                + Math.abs(place[at])
                + Math.abs(place[at + 2])
                + column.mesh(leaf).tree().reach();
        pad = pad(size, 0);
    }

    private void direction(int to, double gx, double gz, double[] place, int at, double cx, double cz) {
        int r = at + Leaf.ROTATION;
        directions[to] = gx * place[r] + gz * place[r + 6];
        directions[to + 1] = gx * place[r + 1] + gz * place[r + 7];
        directions[to + 2] = gx * place[r + 2] + gz * place[r + 8];
        directions[to + 3] = gx * cx + gz * cz;
    }

    /** Starts a cone in space, defined by the cosine of its half angle. */
    public void startCone(LeafColumn column, int leaf, BeamAxis beam) {
        isPlanar = false;
        double dx = beam.ux();
        double dy = beam.uy();
        double dz = beam.uz();
        double[] place = column.rows();
        int at = leaf * Leaf.STRIDE;
        int r = at + Leaf.ROTATION;
        double x = beam.ox - place[at];
        double y = beam.oy - place[at + 1];
        double z = beam.oz - place[at + 2];
        ox = place[r] * x + place[r + 3] * y + place[r + 6] * z;
        oy = place[r + 1] * x + place[r + 4] * y + place[r + 7] * z;
        oz = place[r + 2] * x + place[r + 5] * y + place[r + 8] * z;
        double ax = place[r] * dx + place[r + 3] * dy + place[r + 6] * dz;
        double ay = place[r + 1] * dx + place[r + 4] * dy + place[r + 7] * dz;
        double az = place[r + 2] * dx + place[r + 5] * dy + place[r + 8] * dz;
        double length = VectorMath.length(ax, ay, az);
        ux = ax / length;
        uy = ay / length;
        uz = az / length;
        cos = beam.cos;
        sin = Math.sqrt((1 - cos) * (1 + cos));
        double size = Math.abs(beam.ox)
                + Math.abs(beam.oy)
                + Math.abs(beam.oz)
                + Math.abs(place[at])
                + Math.abs(place[at + 1])
                + Math.abs(place[at + 2])
                + column.mesh(leaf).tree().reach();
        double skew = MeshWalk.skew(place, r);
        pad = pad(size, 16 * skew);
        shrink = 1 - 0x1p-50 - 2 * skew;
    }

    private static double pad(double size, double share) {
        return size < HUGE ? (MeshWalk.WIDEN + share) * size + MeshWalk.UNDERFLOW : Double.POSITIVE_INFINITY;
    }

    /** Puts the triangles that may be nearest within a limit, at least 0, to the judge; all of these that are. */
    public void find(TriangleMesh mesh, double limit, MeshRay.Judge judge) {
        BoxTree tree = mesh.tree();
        if (isPlanar && isLine) {
            takeToTree(tree);
        }
        double[] corners = mesh.leafCorners();
        double reach = limit;
        int depth = 0;
        int node = tree.root();
        double key = boxKey(tree, node);
        while (true) {
            if (key <= reach) {
                if (!tree.isLeaf(node)) {
                    int near = tree.left(node);
                    int far = tree.right(node);
                    double nearKey = boxKey(tree, near);
                    double farKey = boxKey(tree, far);
                    boolean isSwapped = farKey < nearKey;
                    stack[depth] = isSwapped ? near : far;
                    keys[depth++] = isSwapped ? nearKey : farKey;
                    node = isSwapped ? far : near;
                    key = isSwapped ? farKey : nearKey;
                    continue;
                }
                int first = tree.first(node);
                for (int k = first; k < first + tree.count(node); k++) {
                    if (triangleKey(corners, 9 * k) <= reach) {
                        reach = Math.min(reach, judge.judge(k));
                    }
                }
            }
            if (depth == 0) {
                return;
            }
            node = stack[--depth];
            key = keys[depth];
        }
    }

    /** Takes the directions of a line to the tree's units. */
    private void takeToTree(BoxTree tree) {
        nodes = tree.numbers();
        double unit = 1 / tree.scale(); // a power of two
        for (int direction = AHEAD; direction <= LEFT; direction += LEFT) {
            double sum = directions[direction + 3];
            for (int axis = 0; axis < 3; axis++) {
                sum += directions[direction + axis] * tree.origin(axis);
                inTree[direction + axis] = directions[direction + axis] * unit;
            }
            inTree[direction + 3] = sum;
        }
    }

    /** The key of a node for a line, from the node's own numbers. */
    private double lineKey(int node) {
        float[] n = nodes;
        double[] d = inTree;
        int at = BoxTree.STRIDE * node;
        double x = n[at];
        double y = n[at + 1];
        double z = n[at + 2];
        double hx = n[at + BoxTree.HALF];
        double hy = n[at + BoxTree.HALF + 1];
        double hz = n[at + BoxTree.HALF + 2];
        double aside = d[LEFT] * x + d[LEFT + 1] * y + d[LEFT + 2] * z + d[LEFT + 3];
        double across = Math.abs(d[LEFT]) * hx + Math.abs(d[LEFT + 1]) * hy + Math.abs(d[LEFT + 2]) * hz;
        double ahead = d[AHEAD] * x + d[AHEAD + 1] * y + d[AHEAD + 2] * z + d[AHEAD + 3];
        double along = Math.abs(d[AHEAD]) * hx + Math.abs(d[AHEAD + 1]) * hy + Math.abs(d[AHEAD + 2]) * hz;
        return Math.abs(aside) - across > pad || ahead + along < -pad
                ? Double.POSITIVE_INFINITY
                : notBelow0(ahead - along - pad);
    }

    /** A lower bound of the distance of everything in a node; infinite if that is certainly outside the beam. */
    private double boxKey(BoxTree tree, int node) {
        if (isPlanar && isLine) {
            return lineKey(node);
        }
        double mx = tree.middle(node, 0);
        double my = tree.middle(node, 1);
        double mz = tree.middle(node, 2);
        double hx = tree.half(node, 0);
        double hy = tree.half(node, 1);
        double hz = tree.half(node, 2);
        return isPlanar ? planarKey(mx, my, mz, hx, hy, hz) : spatialKey(mx, my, mz, hx, hy, hz);
    }

    private double planarKey(double mx, double my, double mz, double hx, double hy, double hz) {
        if (middle(LEFT, mx, my, mz) - half(LEFT, hx, hy, hz) > pad
                || middle(RIGHT, mx, my, mz) - half(RIGHT, hx, hy, hz) > pad) {
            return Double.POSITIVE_INFINITY;
        }
        double ahead = middle(AHEAD, mx, my, mz);
        double along = half(AHEAD, hx, hy, hz);
        if (ahead + along < -pad) {
            return Double.POSITIVE_INFINITY;
        }
        double key = ahead - along - pad;
        // At least its distance along the direction of its centre.
        double east = middle(EAST, mx, my, mz);
        double south = middle(SOUTH, mx, my, mz);
        double square = east * east + south * south;
        if (square < TINY_SQUARE) {
            return notBelow0(key);
        }
        double distance = Math.sqrt(square);
        double gx = east / distance;
        double gz = south / distance;
        double[] d = directions;
        double radius = Math.abs(gx * d[EAST] + gz * d[SOUTH]) * hx
                + Math.abs(gx * d[EAST + 1] + gz * d[SOUTH + 1]) * hy
                + Math.abs(gx * d[EAST + 2] + gz * d[SOUTH + 2]) * hz;
        double radial = distance - radius - pad;
        return notBelow0(radial > key ? radial : key);
    }

    private double middle(int direction, double x, double y, double z) {
        double[] d = directions;
        return d[direction] * x + d[direction + 1] * y + d[direction + 2] * z + d[direction + 3];
    }

    private double half(int direction, double hx, double hy, double hz) {
        double[] d = directions;
        return Math.abs(d[direction]) * hx + Math.abs(d[direction + 1]) * hy + Math.abs(d[direction + 2]) * hz;
    }

    /** The key, or 0 if it is negative or NaN. */
    private static double notBelow0(double key) {
        return key > 0 ? key : 0;
    }

    private double spatialKey(double mx, double my, double mz, double hx, double hy, double hz) {
        double x = mx - ox;
        double y = my - oy;
        double z = mz - oz;
        double ahead = x * ux + y * uy + z * uz;
        double along = Math.abs(ux) * hx + Math.abs(uy) * hy + Math.abs(uz) * hz;
        if (ahead + along < -pad || isBeyondCone(x, y, z, ahead, hx, hy, hz)) {
            return Double.POSITIVE_INFINITY;
        }
        double dx = Math.max(0, Math.abs(x) - hx);
        double dy = Math.max(0, Math.abs(y) - hy);
        double dz = Math.max(0, Math.abs(z) - hz);
        double square = dx * dx + dy * dy + dz * dz;
        return square < TINY_SQUARE ? 0 : notBelow0(Math.sqrt(square) * shrink - pad);
    }

    /**
     * Whether a box, given by its centre relative to the apex, lies beyond the plane that touches the cone along the
     * line nearest to the centre: with e the unit vector from the axis to the centre, the plane's normal is {@code n =
     * e cos - u sin}.
     *
     * <p>Let a placed point x be in the cone: {@code x.u >= cos |x|} and no farther than {@code sin |x|} from the axis. In
     * the own frame it is y; there {@code R'x - y} is as long as {@code (R'R - I) v} at most, and with s the most that
     * R'R - I stretches, products of R'x and R'u are off by s |x| each: as R'u is brought to length 1, y is no farther
     * than {@code (sin + 4s) |x|} from the axis and {@code (cos - 3s) |x|} ahead, so that {@code n.y} is at most 7s of |x|
     * and s of the mesh's size. The skew is at least s, and the pad has 16 of it. As the middle is not all but on the
     * axis, e is off by 2^-30 of itself along the axis at most, and else by roundings of 2^-53: 2^-28 are taken.
     */
    private boolean isBeyondCone(double x, double y, double z, double ahead, double hx, double hy, double hz) {
        double ex = x - ahead * ux;
        double ey = y - ahead * uy;
        double ez = z - ahead * uz;
        double square = ex * ex + ey * ey + ez * ez;
        double aside = Math.sqrt(square);
        double size = Math.abs(x) + Math.abs(y) + Math.abs(z) + hx + hy + hz;
        if (square < TINY_SQUARE || !(aside > 0x1p-20 * size)) {
            return false;
        }
        double across = cos / aside;
        double nx = ex * across - ux * sin;
        double ny = ey * across - uy * sin;
        double nz = ez * across - uz * sin;
        double gap = nx * x + ny * y + nz * z - (Math.abs(nx) * hx + Math.abs(ny) * hy + Math.abs(nz) * hz);
        return gap > 0x1p-28 * size + pad;
    }

    /** The same bound for a triangle, given its corners: all beyond one side of the beam, or by its box. */
    private double triangleKey(double[] c, int k) {
        if (isPlanar && isLine) {
            return triangleLineKey(c, k);
        }
        if (isPlanar && (isBeyond(LEFT, c, k) || isBeyond(RIGHT, c, k))) {
            return Double.POSITIVE_INFINITY;
        }
        double lowX = Math.min(c[k], Math.min(c[k + 3], c[k + 6]));
        double lowY = Math.min(c[k + 1], Math.min(c[k + 4], c[k + 7]));
        double lowZ = Math.min(c[k + 2], Math.min(c[k + 5], c[k + 8]));
        double hx = (Math.max(c[k], Math.max(c[k + 3], c[k + 6])) - lowX) / 2;
        double hy = (Math.max(c[k + 1], Math.max(c[k + 4], c[k + 7])) - lowY) / 2;
        double hz = (Math.max(c[k + 2], Math.max(c[k + 5], c[k + 8])) - lowZ) / 2;
        return isPlanar
                ? planarKey(lowX + hx, lowY + hy, lowZ + hz, hx, hy, hz)
                : spatialKey(lowX + hx, lowY + hy, lowZ + hz, hx, hy, hz);
    }

    private double triangleLineKey(double[] c, int k) {
        double a = middle(LEFT, c[k], c[k + 1], c[k + 2]);
        double b = middle(LEFT, c[k + 3], c[k + 4], c[k + 5]);
        double d = middle(LEFT, c[k + 6], c[k + 7], c[k + 8]);
        if (Math.min(a, Math.min(b, d)) > pad || Math.max(a, Math.max(b, d)) < -pad) {
            return Double.POSITIVE_INFINITY;
        }
        a = middle(AHEAD, c[k], c[k + 1], c[k + 2]);
        b = middle(AHEAD, c[k + 3], c[k + 4], c[k + 5]);
        d = middle(AHEAD, c[k + 6], c[k + 7], c[k + 8]);
        return Math.max(a, Math.max(b, d)) < -pad
                ? Double.POSITIVE_INFINITY
                : notBelow0(Math.min(a, Math.min(b, d)) - pad);
    }

    private boolean isBeyond(int direction, double[] c, int k) {
        return middle(direction, c[k], c[k + 1], c[k + 2]) > pad
                && middle(direction, c[k + 3], c[k + 4], c[k + 5]) > pad
                && middle(direction, c[k + 6], c[k + 7], c[k + 8]) > pad;
    }
}
