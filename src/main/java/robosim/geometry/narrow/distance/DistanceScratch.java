package robosim.geometry.narrow.distance;

import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.ray.RayScratch;

/** The working memory of distances. */
public class DistanceScratch extends RayScratch {
    public final SphereDistance sphereDistance = new SphereDistance();

    /** A point as a sphere's row. */
    public final double[] witness = new double[Leaf.STRIDE];
}
