package robosim.geometry.narrow.ray;

import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.narrow.overlap.OverlapScratch;

/** The working memory of rays. */
public class RayScratch extends OverlapScratch {
    public final RayInterval ray = new RayInterval();
    final PlainCylinderFace plainCylinder = new PlainCylinderFace();
    final DoubleDoubles capsuleEnds = new DoubleDoubles(RayCapsule.PAIRS_NEEDED);
    public final RayRefine refine = new RayRefine();
}
