package robosim.geometry.narrow;

/** Whether two leaves touch or overlap in space. */
public final class SpatialOverlap {
    private SpatialOverlap() {}

    /** Whether two leaves touch or overlap; the same for (a, b) and (b, a). */
    public static boolean test(int kindA, double[] a, int i, int kindB, double[] b, int j, Scratch s) {
        if (Leaf.isUpright(kindA) && Leaf.isUpright(kindB)) {
            return Upright.heightsTouch(kindA, a, i, kindB, b, j) && PlanarOverlap.test(kindA, a, i, kindB, b, j, s);
        }
        return s.gjk.spatial(kindA, a, i, kindB, b, j) == 0;
    }
}
