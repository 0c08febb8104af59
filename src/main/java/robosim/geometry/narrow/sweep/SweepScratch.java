package robosim.geometry.narrow.sweep;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.overlap.OverlapScratch;

/** The working memory of sweeps. */
public final class SweepScratch {
    public final OverlapScratch overlap;
    public final LeafScratch leaf;

    private @Nullable SweepWorkspace sweep;

    public SweepScratch(OverlapScratch overlap, LeafScratch leaf) {
        this.overlap = overlap;
        this.leaf = leaf;
    }

    public SweepWorkspace sweep() {
        if (sweep == null) {
            sweep = new SweepWorkspace();
        }
        return sweep;
    }
}
