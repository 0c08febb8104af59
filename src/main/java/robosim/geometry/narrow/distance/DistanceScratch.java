package robosim.geometry.narrow.distance;

import robosim.geometry.narrow.gjk.GjkScratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.overlap.OverlapScratch;
import robosim.geometry.narrow.planar.PlanarScratch;
import robosim.geometry.narrow.ray.RayScratch;
import robosim.geometry.narrow.sat.SatScratch;

/** The working memory of distances. */
public final class DistanceScratch {
    public final RayScratch ray;
    public final OverlapScratch overlap;
    public final SatScratch sat;
    public final GjkScratch gjk;
    public final PlanarScratch planar;
    public final LeafScratch leaf;

    public final SphereDistance sphereDistance = new SphereDistance();

    /** A point as a sphere. */
    public final Leaf witness = new Leaf(LeafKind.SPHERE);

    public DistanceScratch(
            RayScratch ray,
            OverlapScratch overlap,
            SatScratch sat,
            GjkScratch gjk,
            PlanarScratch planar,
            LeafScratch leaf) {
        this.ray = ray;
        this.overlap = overlap;
        this.sat = sat;
        this.gjk = gjk;
        this.planar = planar;
        this.leaf = leaf;
    }
}
