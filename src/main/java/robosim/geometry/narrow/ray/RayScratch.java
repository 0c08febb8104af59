package robosim.geometry.narrow.ray;

import robosim.geometry.narrow.overlap.OverlapScratch;

/** The working memory of rays. */
public class RayScratch extends OverlapScratch {
    public final RayInterval ray = new RayInterval();
    final RayCapsule capsule = new RayCapsule();
    public final RayRefine refine = new RayRefine();
    public final NearestFace face = new NearestFace();
}
