package robosim.geometry.narrow;

/**
 * The directions in which one leaf gets out of another on the shortest way, for judging a motion that starts in contact.
 *
 * <p>{@link Penetration} knows all flat sides. Where a rim has a part in the contact, one more direction is tried: that of
 * the gap that opens when the cylinders are made a little smaller, which for a light touch is the normal of the contact.
 */
final class LeastWays {
    private static final double FIRST_SHRINKING = 0x1p-26;
    private static final double GROWTH = 8;

    /** How deep the two are in each other; hardly ever negative. */
    double depth;

    private final Support first = new Support();
    private final Support second = new Support();
    private final double[] smallA = new double[Leaf.STRIDE];
    private final double[] smallB = new double[Leaf.STRIDE];
    private int single;
    private double nx;
    private double ny;
    private double nz;

    void find(boolean planar, int kindA, double[] a, int i, int kindB, double[] b, int j, Scratch s) {
        Penetration sides = s.penetration;
        depth = planar ? sides.planar(kindA, a, i, kindB, b, j) : sides.spatial(kindA, a, i, kindB, b, j);
        single = 0;
        if (!isCylinder(kindA) && !isCylinder(kindB)) {
            return;
        }
        for (double share = FIRST_SHRINKING; share < 1; share *= GROWTH) {
            shrink(kindA, a, i, share, smallA);
            shrink(kindB, b, j, share, smallB);
            Gjk gjk = s.gjk;
            double gap = planar
                    ? gjk.planar(kindA, smallA, 0, kindB, smallB, 0)
                    : gjk.spatial(kindA, smallA, 0, kindB, smallB, 0);
            if (gap > 0) {
                double other = depth(planar, kindA, a, i, kindB, b, j, gjk);
                if (other < depth - 2 * gjk.error()) {
                    depth = other;
                    single = 1;
                    nx = gjk.nx();
                    ny = gjk.ny();
                    nz = gjk.nz();
                }
                return;
            }
        }
    }

    int count(Scratch s) {
        return single > 0 ? 1 : s.penetration.count();
    }

    /** The unit direction in which a has to move to get out. */
    double nx(int k, Scratch s) {
        return single > 0 ? nx : s.penetration.nx(k);
    }

    double ny(int k, Scratch s) {
        return single > 0 ? ny : s.penetration.ny(k);
    }

    double nz(int k, Scratch s) {
        return single > 0 ? nz : s.penetration.nz(k);
    }

    private static boolean isCylinder(int kind) {
        return kind == Leaf.CYLINDER || kind == Leaf.UPRIGHT_CYLINDER;
    }

    private static void shrink(int kind, double[] row, int at, double share, double[] out) {
        System.arraycopy(row, at, out, 0, Leaf.STRIDE);
        if (isCylinder(kind)) {
            out[3] *= 1 - share;
            out[4] *= 1 - share;
        }
    }

    private double depth(boolean planar, int kindA, double[] a, int i, int kindB, double[] b, int j, Gjk gjk) {
        double ox = Support.originX(kindA, a, i);
        double oz = Support.originZ(kindA, a, i);
        if (planar) {
            first.planar(kindA, a, i, ox, oz, 1);
            second.planar(kindB, b, j, ox, oz, 1);
        } else {
            double oy = Support.originY(kindA, a, i);
            first.spatial(kindA, a, i, ox, oy, oz, 1);
            second.spatial(kindB, b, j, ox, oy, oz, 1);
        }
        first.find(-gjk.nx(), -gjk.ny(), -gjk.nz());
        second.find(gjk.nx(), gjk.ny(), gjk.nz());
        return gjk.nx() * (second.x - first.x)
                + gjk.ny() * (second.y - first.y)
                + gjk.nz() * (second.z - first.z)
                + first.margin
                + second.margin;
    }
}
