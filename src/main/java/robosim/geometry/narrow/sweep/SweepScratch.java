package robosim.geometry.narrow.sweep;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.leaf.ProjectedPolygon;
import robosim.geometry.narrow.overlap.OverlapScratch;
import robosim.geometry.narrow.sat.MovingAxes;

/** The working memory of sweeps. */
public final class SweepScratch {
    public final OverlapScratch overlap;
    public final LeafScratch leaf;

    private @Nullable Kernels sweep;

    public SweepScratch(OverlapScratch overlap, LeafScratch leaf) {
        this.overlap = overlap;
        this.leaf = leaf;
    }

    public Kernels sweep() {
        if (sweep == null) {
            sweep = new Kernels();
        }
        return sweep;
    }

    /** Created on first use: many queries need none of them. */
    static final class Kernels {
        final MovingAxes axes = new MovingAxes();
        final MovingDisc disc = new MovingDisc();
        final ProjectedPolygon outline = new ProjectedPolygon();
        final MovingBall ball = new MovingBall();
        final TranslationAdvancement move = new TranslationAdvancement();
        final VerticalTurn vertical = new VerticalTurn();
        final TurningLeaf body = new TurningLeaf();
        final TurnAdvancement turning = new TurnAdvancement();
    }
}
