package robosim.geometry.narrow.distance;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.BoxGap;
import robosim.geometry.narrow.leaf.Leaf;
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
    public static void of(Dimension dimension, Leaf a, Leaf b, double[] out, DistanceScratch s) {
        boolean flat = dimension == Dimension.PLANAR;
        ConvexContact.between(dimension, a, b, out, s);
        double rounding = bound(flat, a, b, out, s);
        if (flat && out[6] > FAR * rounding) {
            // For deep overlaps the middle of the way out may be in neither.
            s.gjk.pair.planar(a, b);
            double x = out[0];
            double z = out[2];
            double before = out[6];
            out[0] = 0.5 * s.gjk.pair.ax() + 0.5 * s.gjk.pair.bx();
            out[2] = 0.5 * s.gjk.pair.az() + 0.5 * s.gjk.pair.bz();
            bound(true, a, b, out, s);
            if (out[6] > before) {
                out[0] = x;
                out[2] = z;
                out[6] = before;
            }
        }
        boolean exactly = !flat && a.kind.isPolytope() && b.kind.isPolytope();
        if (exactly && out[6] > FAR * rounding && ExactCommonPoint.point(a, b, out)) {
            bound(false, a, b, out, s);
        }
    }

    /** Bounds the point's distances and returns how much of that is rounding for any point. */
    private static double bound(boolean flat, Leaf a, Leaf b, double[] out, DistanceScratch s) {
        for (int axis = 0; axis < 3; axis++) {
            out[axis] = Math.max(-MOST, Math.min(MOST, out[axis]));
        }
        double fromA = off(flat, a, out, s);
        double rounding = s.gjk.pair.error();
        double fromB = off(flat, b, out, s);
        out[6] = Math.max(fromA, fromB);
        return Math.max(rounding, s.gjk.pair.error());
    }

    /** An upper bound of the distance from a leaf to the point at the beginning of an array. */
    private static double off(boolean flat, Leaf leaf, double[] point, DistanceScratch s) {
        Leaf sphere = s.witness;
        System.arraycopy(point, 0, sphere.row, 0, 3);
        sphere.row[Leaf.SIZE] = 0;
        Gjk gjk = s.gjk.pair;
        if (flat) {
            gjk.planar(sphere, leaf);
        } else {
            gjk.spatial(sphere, leaf);
        }
        return BoxGap.up(gjk.upper() + gjk.error());
    }
}
