package robosim.geometry.narrow.distance;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.BoxGap;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.sat.ExactCommonPoint;

/** A point that two touching leaves have in common, and how far rounding may have moved it off either. */
public final class ContactPoint {
    /** Coordinates beyond this cannot be returned as a point; a placed vertex may be beyond it. */
    private static final double MOST = 0x1p100;

    /**
     * A point whose error is more than this many times what rounding explains comes from an iteration that did not
     * converge.
     */
    private static final double FAR = 16;

    private ContactPoint() {}

    /**
     * Writes a point, the unit normal from b towards a, and a bound of the point's distance from a and from b that was
     * measured, not assumed. For (b, a) the normal is opposite, the rest the same.
     *
     * @param out seven numbers
     */
    public static void of(
            Dimension dimension,
            LeafKind kindA,
            double[] a,
            int i,
            LeafKind kindB,
            double[] b,
            int j,
            double[] out,
            DistanceScratch s) {
        boolean flat = dimension == Dimension.PLANAR;
        ConvexContact.between(dimension, kindA, a, i, kindB, b, j, out, s);
        double rounding = bound(flat, kindA, a, i, kindB, b, j, out, s);
        if (flat && out[6] > FAR * rounding) {
            // For deep overlaps the middle of the way out may be in neither.
            s.gjk.pair.planar(kindA, a, i, kindB, b, j);
            double x = out[0];
            double z = out[2];
            double before = out[6];
            out[0] = 0.5 * s.gjk.pair.ax() + 0.5 * s.gjk.pair.bx();
            out[2] = 0.5 * s.gjk.pair.az() + 0.5 * s.gjk.pair.bz();
            bound(true, kindA, a, i, kindB, b, j, out, s);
            if (out[6] > before) {
                out[0] = x;
                out[2] = z;
                out[6] = before;
            }
        }
        boolean exactly = !flat && kindA.isPolytope() && kindB.isPolytope();
        if (exactly && out[6] > FAR * rounding && ExactCommonPoint.point(kindA, a, i, kindB, b, j, out)) {
            bound(false, kindA, a, i, kindB, b, j, out, s);
        }
    }

    /** Bounds the point's distances and returns how much of that is rounding for any point. */
    private static double bound(
            boolean flat,
            LeafKind kindA,
            double[] a,
            int i,
            LeafKind kindB,
            double[] b,
            int j,
            double[] out,
            DistanceScratch s) {
        for (int axis = 0; axis < 3; axis++) {
            out[axis] = Math.max(-MOST, Math.min(MOST, out[axis]));
        }
        double fromA = off(flat, kindA, a, i, out, s);
        double rounding = s.gjk.pair.error();
        double fromB = off(flat, kindB, b, j, out, s);
        out[6] = Math.max(fromA, fromB);
        return Math.max(rounding, s.gjk.pair.error());
    }

    /** An upper bound of the distance from a leaf to the point at the beginning of an array. */
    private static double off(boolean flat, LeafKind kind, double[] row, int at, double[] point, DistanceScratch s) {
        double[] sphere = s.witness;
        System.arraycopy(point, 0, sphere, 0, 3);
        sphere[Leaf.SIZE] = 0;
        Gjk gjk = s.gjk.pair;
        if (flat) {
            gjk.planar(LeafKind.SPHERE, sphere, 0, kind, row, at);
        } else {
            gjk.spatial(LeafKind.SPHERE, sphere, 0, kind, row, at);
        }
        return BoxGap.up(gjk.upper() + gjk.error());
    }
}
