package robosim.geometry.narrow.gjk;

import robosim.geometry.narrow.leaf.Leaf;

/**
 * Whether the hull of some leaves certainly overlaps that of others by more than rounding, so that no plane separates
 * them.
 *
 * <p>Simplices of the difference set as in {@link Gjk} (Gilbert, Johnson and Keerthi 1988). In the plane all are
 * treated as prisms of one height, as high as they are wide.
 */
public final class HullOverlap {
    /** Maximum number of steps; more are seldom worthwhile. */
    private static final int MOST_STEPS = 24;

    /** Below this size cubes may underflow, so nothing is certain. */
    private static final double SMALL = 0x1p-240;

    private static final double SKEW_X = 0.0625;
    private static final double SKEW_Y = 0.109375;
    private static final double SKEW_Z = 0.0859375;

    private final Support[] upper = {new Support(), new Support(), new Support(), new Support()};
    private final Support[] lower = {new Support(), new Support()};
    private final Simplex simplex = new Simplex();
    private boolean isFlat;
    private int above;
    private int below;
    private double ox;
    private double oy;
    private double oz;
    private double extentAbove;
    private double extentBelow;

    /** Removes all leaves. */
    public void clear(boolean inPlane) {
        isFlat = inPlane;
        above = 0;
        below = 0;
        extentAbove = 0;
        extentBelow = 0;
    }

    /** Adds one of up to four leaves on one side; there must be one before any is added on the other side. */
    public void above(Leaf leaf) {
        if (above == 0) {
            ox = Support.originX(leaf.kind, leaf.row, leaf.at);
            oy = Support.originY(leaf.kind, leaf.row, leaf.at);
            oz = Support.originZ(leaf.kind, leaf.row, leaf.at);
        }
        Support support = upper[above++];
        load(support, leaf);
        extentAbove = Math.max(extentAbove, support.extent);
    }

    /** Adds one of up to two leaves on the other side. */
    public void below(Leaf leaf) {
        Support support = lower[below++];
        load(support, leaf);
        extentBelow = Math.max(extentBelow, support.extent);
    }

    private void load(Support support, Leaf leaf) {
        if (isFlat) {
            support.planar(leaf.kind, leaf.row, leaf.at, ox, oz, 1);
        } else {
            support.spatial(leaf.kind, leaf.row, leaf.at, ox, oy, oz, 1);
        }
    }

    /** Whether a point is certainly inside both hulls. */
    public boolean areDeep() {
        double extent = extentAbove + extentBelow;
        if (extent < SMALL) {
            return false;
        }
        double height = isFlat ? 0.5 * extent : 0;
        double enough = Gjk.DEEP * extent * extent * extent;
        // A skew direction, since leaves of the same height or attitude have simplices with the origin on a side, not
        // inside.
        double vx = upper[0].centreX - lower[0].centreX + SKEW_X * extent;
        double vy = upper[0].centreY - lower[0].centreY + SKEW_Y * extent;
        double vz = upper[0].centreZ - lower[0].centreZ + SKEW_Z * extent;
        simplex.clear();
        for (int step = 0; step < MOST_STEPS; step++) {
            double length = Math.sqrt(vx * vx + vy * vy + vz * vz);
            if (!(length > 0)) {
                return false;
            }
            double x = vx / length;
            double y = vy / length;
            double z = vz / length;
            Support first = farthest(upper, above, -x, -y, -z, height);
            Support second = farthest(lower, below, x, y, z, height);
            double reach = x * (first.x - second.x) + y * (first.y - second.y) + z * (first.z - second.z);
            if (reach >= 0 || !simplex.add(first, second) || !simplex.reduce()) {
                return false;
            }
            if (simplex.depth() > 0) {
                return simplex.depth() > enough;
            }
            vx = simplex.vx;
            vy = simplex.vy;
            vz = simplex.vz;
            if (step == 0) { // skew once more, or spheres would stay in the plane of their centres
                double size = Math.sqrt(vx * vx + vy * vy + vz * vz);
                vx -= SKEW_Z * size;
                vy += SKEW_X * size;
                vz += SKEW_Y * size;
            }
        }
        return false;
    }

    private static Support farthest(Support[] leaves, int count, double x, double y, double z, double height) {
        Support best = leaves[0];
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < count; k++) {
            Support leaf = leaves[k];
            leaf.find(x, y, z);
            if (leaf.margin > 0) {
                double length = height > 0 ? Math.sqrt(x * x + z * z) : 1;
                double outward = length > 0 ? leaf.margin / length : 0;
                leaf.x += outward * x;
                leaf.y += outward * y;
                leaf.z += outward * z;
            }
            if (height > 0) {
                leaf.y = y >= 0 ? height : -height;
            }
            double reach = x * leaf.x + y * leaf.y + z * leaf.z;
            if (reach > most) {
                most = reach;
                best = leaf;
            }
        }
        return best;
    }
}
