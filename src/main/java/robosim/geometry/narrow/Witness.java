package robosim.geometry.narrow;

import robosim.geometry.model.Dimension;

/** A point that two leaves which touch have in common, and how far rounding may have moved it off either. */
final class Witness {
    /** Beyond this no point can be told; a placed vertex may be. */
    private static final double MOST = 0x1p100;

    private Witness() {}

    /**
     * Writes a point, the unit normal from b towards a, and a bound of the point's distance from a and from b that was
     * measured, not assumed: opposite for (b, a), the same point and bound.
     *
     * @param out seven numbers
     */
    static void of(
            Dimension dimension, int kindA, double[] a, int i, int kindB, double[] b, int j, double[] out, Scratch s) {
        boolean flat = dimension == Dimension.PLANAR;
        Distance.convexContact(dimension, kindA, a, i, kindB, b, j, out, s);
        for (int axis = 0; axis < 3; axis++) {
            out[axis] = Math.max(-MOST, Math.min(MOST, out[axis]));
        }
        out[6] = Math.max(off(flat, kindA, a, i, out, s), off(flat, kindB, b, j, out, s));
    }

    /** How far the point at the beginning of an array is from a leaf at most. */
    private static double off(boolean flat, int kind, double[] row, int at, double[] point, Scratch s) {
        double[] sphere = s.witness;
        System.arraycopy(point, 0, sphere, 0, 3);
        sphere[Leaf.SIZE] = 0;
        Gjk gjk = s.gjk;
        if (flat) {
            gjk.planar(Leaf.SPHERE, sphere, 0, kind, row, at);
        } else {
            gjk.spatial(Leaf.SPHERE, sphere, 0, kind, row, at);
        }
        return BoxGap.up(gjk.upper() + gjk.error());
    }
}
