package robosim.geometry.narrow.overlap;

import robosim.geometry.exact.ExactVector;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.sat.ExactExtent;

/** A capsule and a cylinder in space, where {@link Gjk} found neither a slab between them nor a common point. */
final class CapsuleCylinder {
    private CapsuleCylinder() {}

    /**
     * Whether the two touch or overlap, certified: apart only with a slab between them, touching with a common point so deep
     * that no rounding matters, and where neither is found touching, and {@link OverlapScratch#uncertain} set.
     */
    static boolean touch(Leaf a, Leaf b, OverlapScratch s) {
        Gjk gjk = s.gjk.pair;
        gjk.spatial(a, b);
        s.gjk.hull.grow(Double.MIN_VALUE);
        if (s.gjk.hull.lower() > 0) {
            return true;
        }
        // The hull's own bound from above is that of the segment, without the radius.
        if (isBetween(gjk.nx(), gjk.ny(), gjk.nz(), a, b)
                || isBetween(s.gjk.hull.x(), s.gjk.hull.y(), s.gjk.hull.z(), a, b)) {
            return false;
        }
        // Trees go by bounds: what these prove apart is, or an answer would depend on which tree was asked.
        if (LeafBounds.areApart(Dimension.SPATIAL, a, b, s.leaf.boundsA, s.leaf.boundsB)) {
            return false;
        }
        s.uncertain = true;
        return true;
    }

    /** Whether there is a slab between the two across a direction, without rounding. */
    private static boolean isBetween(double nx, double ny, double nz, Leaf a, Leaf b) {
        ExactVector n = ExactVector.of(nx, ny, nz);
        ExactExtent one = ExactExtent.of(n, a);
        ExactExtent two = ExactExtent.of(n, b);
        return one.gapTo(two) > 0 || two.gapTo(one) > 0;
    }
}
