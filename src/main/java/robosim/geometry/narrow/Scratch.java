package robosim.geometry.narrow;

import robosim.geometry.exact.WorkCounter;
import robosim.geometry.narrow.cone.ConeScratch;
import robosim.geometry.narrow.distance.DistanceScratch;
import robosim.geometry.narrow.gjk.GjkScratch;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.mesh.MeshScratch;
import robosim.geometry.narrow.overlap.OverlapScratch;
import robosim.geometry.narrow.planar.PlanarScratch;
import robosim.geometry.narrow.ray.RayScratch;
import robosim.geometry.narrow.sweep.SweepScratch;

/**
 * The working memory of all kernels, so that a query allocates nothing: one object for each package, which holds those of other
 * packages that it needs. One for each owner of queries; never shared between threads.
 */
public final class Scratch {
    public final LeafScratch leaf = new LeafScratch();
    public final PlanarScratch planar = new PlanarScratch();
    public final GjkScratch gjk = new GjkScratch();
    public final OverlapScratch overlap = new OverlapScratch(gjk, planar, leaf);
    public final RayScratch ray = new RayScratch(planar);
    public final DistanceScratch distance = new DistanceScratch(overlap, gjk, planar, leaf);
    public final SweepScratch sweep = new SweepScratch(overlap, leaf);
    public final MeshScratch mesh = new MeshScratch(distance, overlap, leaf);
    public final ConeScratch cone = new ConeScratch(ray, planar, leaf);

    /** Counts what the kernels do. */
    public final WorkCounter work = leaf.work;
}
