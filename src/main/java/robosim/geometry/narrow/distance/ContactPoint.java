package robosim.geometry.narrow.distance;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.BoxGap;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.sat.ExactCommon;
import robosim.geometry.narrow.sat.ExactPolytope;

/** A point that two leaves which touch have in common, and how far rounding may have moved it off either. */
public final class ContactPoint {
    /** Beyond this no point can be told; a placed vertex may be. */
    private static final double MOST = 0x1p100;

    /** A point that is off by so many times what rounding explains is that of an iteration that came to no end. */
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
            // Deep in each other the middle of the way out need not be in either.
            s.gjk.planar(kindA, a, i, kindB, b, j);
            double x = out[0];
            double z = out[2];
            double before = out[6];
            out[0] = 0.5 * s.gjk.ax() + 0.5 * s.gjk.bx();
            out[2] = 0.5 * s.gjk.az() + 0.5 * s.gjk.bz();
            bound(true, kindA, a, i, kindB, b, j, out, s);
            if (out[6] > before) {
                out[0] = x;
                out[2] = z;
                out[6] = before;
            }
        }
        boolean exactly = !flat && ExactPolytope.isKnown(kindA) && ExactPolytope.isKnown(kindB);
        if (exactly && out[6] > FAR * rounding && ExactCommon.point(kindA, a, i, kindB, b, j, out)) {
            bound(false, kindA, a, i, kindB, b, j, out, s);
        }
    }

    /** Bounds the point's distances and answers how much of that is rounding, whatever the point. */
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
        double rounding = s.gjk.error();
        double fromB = off(flat, kindB, b, j, out, s);
        out[6] = Math.max(fromA, fromB);
        return Math.max(rounding, s.gjk.error());
    }

    /** How far the point at the beginning of an array is from a leaf at most. */
    private static double off(boolean flat, LeafKind kind, double[] row, int at, double[] point, DistanceScratch s) {
        double[] sphere = s.witness;
        System.arraycopy(point, 0, sphere, 0, 3);
        sphere[Leaf.SIZE] = 0;
        Gjk gjk = s.gjk;
        if (flat) {
            gjk.planar(LeafKind.SPHERE, sphere, 0, kind, row, at);
        } else {
            gjk.spatial(LeafKind.SPHERE, sphere, 0, kind, row, at);
        }
        return BoxGap.up(gjk.upper() + gjk.error());
    }
}
