package robosim.geometry.narrow.distance;

import robosim.geometry.narrow.gjk.GjkScratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.overlap.OverlapScratch;
import robosim.geometry.narrow.planar.PlanarScratch;

/** The working memory of distances. */
public final class DistanceScratch {
    public final OverlapScratch overlap;
    public final GjkScratch gjk;
    public final PlanarScratch planar;
    public final LeafScratch leaf;

    public final SphereDistance sphereDistance = new SphereDistance();

    /** A point as a sphere. */
    public final Leaf witness = new Leaf(LeafKind.SPHERE);

    public DistanceScratch(OverlapScratch overlap, GjkScratch gjk, PlanarScratch planar, LeafScratch leaf) {
        this.overlap = overlap;
        this.gjk = gjk;
        this.planar = planar;
        this.leaf = leaf;
    }
}
