package robosim.geometry.narrow.turn;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.gjk.GjkScratch;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.overlap.OverlapScratch;
import robosim.geometry.narrow.planar.PlanarScratch;
import robosim.geometry.narrow.sweep.SweepScratch;

/** The working memory of turns. */
public final class TurnScratch {
    public final SweepScratch sweep;
    public final OverlapScratch overlap;
    public final GjkScratch gjk;
    public final PlanarScratch planar;
    public final LeafScratch leaf;

    private @Nullable TurnWorkspace turns;

    public TurnScratch(
            SweepScratch sweep, OverlapScratch overlap, GjkScratch gjk, PlanarScratch planar, LeafScratch leaf) {
        this.sweep = sweep;
        this.overlap = overlap;
        this.gjk = gjk;
        this.planar = planar;
        this.leaf = leaf;
    }

    public TurnWorkspace turns() {
        if (turns == null) {
            turns = new TurnWorkspace();
        }
        return turns;
    }
}
