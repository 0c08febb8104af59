package robosim.geometry.narrow.sweep;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.distance.DistanceScratch;
import robosim.geometry.narrow.gjk.GjkScratch;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.overlap.OverlapScratch;
import robosim.geometry.narrow.sat.SatScratch;

/** The working memory of straight sweeps. */
public final class SweepScratch {
    public final DistanceScratch distance;
    public final OverlapScratch overlap;
    public final SatScratch sat;
    public final GjkScratch gjk;
    public final LeafScratch leaf;

    private @Nullable SweepWorkspace sweep;

    public SweepScratch(
            DistanceScratch distance, OverlapScratch overlap, SatScratch sat, GjkScratch gjk, LeafScratch leaf) {
        this.distance = distance;
        this.overlap = overlap;
        this.sat = sat;
        this.gjk = gjk;
        this.leaf = leaf;
    }

    public SweepWorkspace sweep() {
        if (sweep == null) {
            sweep = new SweepWorkspace();
        }
        return sweep;
    }
}
