package robosim.geometry.narrow;

/**
 * Whether the hull of some leaves certainly overlaps that of others by more than rounding, so that no plane is between them.
 *
 * <p>Simplices of the difference set as in {@link Gjk} (Gilbert, Johnson and Keerthi 1988); of what is round the cores alone. In
 * the plane all are taken for prisms of one height, as high as they are wide.
 */
final class HullOverlap {
    /** More steps are seldom worth what they find. */
    private static final int MOST_STEPS = 24;

    /** Below this size cubes may underflow: nothing is certain. */
    private static final double SMALL = 0x1p-240;

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

    /** Forgets all leaves. */
    void clear(boolean inPlane) {
        isFlat = inPlane;
        above = 0;
        below = 0;
        extentAbove = 0;
        extentBelow = 0;
    }

    /** Takes in one of up to four leaves on the one side; there must be one before any of the other. */
    void above(int kind, double[] row, int at) {
        if (above == 0) {
            ox = Support.originX(kind, row, at);
            oy = Support.originY(kind, row, at);
            oz = Support.originZ(kind, row, at);
        }
        Support support = upper[above++];
        load(support, kind, row, at);
        extentAbove = Math.max(extentAbove, support.extent);
    }

    /** Takes in one of up to two leaves on the other side. */
    void below(int kind, double[] row, int at) {
        Support support = lower[below++];
        load(support, kind, row, at);
        extentBelow = Math.max(extentBelow, support.extent);
    }

    private void load(Support support, int kind, double[] row, int at) {
        if (isFlat) {
            support.planar(kind, row, at, ox, oz, 1);
        } else {
            support.spatial(kind, row, at, ox, oy, oz, 1);
        }
    }

    /** Whether a point is certainly inside of both hulls. */
    boolean areDeep() {
        double extent = extentAbove + extentBelow;
        if (extent < SMALL) {
            return false;
        }
        double height = isFlat ? 0.5 * extent : 0;
        double enough = Gjk.DEEP * extent * extent * extent;
        double vx = upper[0].centreX - lower[0].centreX;
        double vy = upper[0].centreY - lower[0].centreY;
        double vz = upper[0].centreZ - lower[0].centreZ;
        if (vx == 0 && vy == 0 && vz == 0) {
            vx = 1;
        }
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
        }
        return false;
    }

    private static Support farthest(Support[] leaves, int count, double x, double y, double z, double height) {
        Support best = leaves[0];
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < count; k++) {
            Support leaf = leaves[k];
            leaf.find(x, y, z);
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
