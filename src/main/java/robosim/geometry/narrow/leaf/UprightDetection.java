package robosim.geometry.narrow.leaf;

import robosim.geometry.exact.Rotations;

/**
 * Finds leaves that are upright, so that they can be handled as prisms: a box or cylinder with an axis exactly along
 * the world's vertical. A box that lies on its side is rewritten as the equivalent upright box.
 */
final class UprightDetection {
    private UprightDetection() {}

    /** The kind of a placed leaf; a box or cylinder comes as {@link LeafKind#BOX} or {@link LeafKind#CYLINDER}. */
    static LeafKind kind(LeafKind kind, double[] rows, int at) {
        if (kind == LeafKind.BOX) {
            for (int up = 0; up < 3; up++) {
                if (isVertical(rows, at, up) && stand(rows, at, up)) {
                    return LeafKind.UPRIGHT_BOX;
                }
            }
            return kind;
        }
        LeafKind upright = kind.upright();
        return upright != kind && isVertical(rows, at, 1) ? upright : kind;
    }

    private static boolean isVertical(double[] rows, int at, int axis) {
        int r = at + Leaf.ROTATION + axis;
        return rows[r] == 0 && rows[r + 6] == 0 && Math.abs(rows[r + 3]) == 1;
    }

    /**
     * Rewrites a box with a vertical axis as an upright one, if its other two axes are horizontal and one is exactly
     * the other turned by a right angle, so that the numbers describe the same box.
     */
    private static boolean stand(double[] rows, int at, int up) {
        int forward = up == 0 ? 1 : 0;
        int side = up == 2 ? 1 : 2;
        int r = at + Leaf.ROTATION;
        double cos = rows[r + forward];
        double sin = 0.0 - rows[r + 6 + forward];
        double across = rows[r + side];
        double along = rows[r + 6 + side];
        boolean right = (across == sin && along == cos) || (across == -sin && along == -cos);
        if (rows[r + 3 + forward] != 0 || rows[r + 3 + side] != 0 || !right) {
            return false;
        }
        double x = rows[at + Leaf.SIZE + forward];
        double y = rows[at + Leaf.SIZE + up];
        double z = rows[at + Leaf.SIZE + side];
        rows[at + Leaf.SIZE] = x;
        rows[at + Leaf.SIZE + 1] = y;
        rows[at + Leaf.SIZE + 2] = z;
        Rotations.upright(cos, sin, rows, r);
        return true;
    }
}
