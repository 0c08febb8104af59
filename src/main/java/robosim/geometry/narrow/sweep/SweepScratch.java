package robosim.geometry.narrow.sweep;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.leaf.ProjectedPolygon;
import robosim.geometry.narrow.overlap.OverlapScratch;
import robosim.geometry.narrow.sat.AxisBody;
import robosim.geometry.narrow.sat.ExactAxes;
import robosim.geometry.narrow.sat.MovingAxes;

/** The working memory of sweeps. */
public final class SweepScratch {
    public final OverlapScratch overlap;
    public final LeafScratch leaf;

    /** What a straight sweep of two polytopes must return. */
    public enum Need {
        /** When they meet. */
        TIME,
        /** Whether they meet: any time will do. */
        VERDICT,
        /** Whether doubles show that they meet: NaN where they cannot tell. */
        SURE_VERDICT
    }

    public Need need = Need.TIME;

    /** A contact after this does not matter and may count as none. */
    public double latest = Double.POSITIVE_INFINITY;

    private @Nullable Kernels sweep;

    public SweepScratch(OverlapScratch overlap, LeafScratch leaf) {
        this.overlap = overlap;
        this.leaf = leaf;
    }

    /** When two polytopes meet: as {@link PlanarSweep#translation} and {@link SpatialSweep#translation}, as far as that is needed. */
    double polytopes(AxisBody.Mode mode, Leaf a, double dx, double dy, double dz, Leaf b) {
        double time = sweep().axes.needing(need != Need.TIME, latest).time(mode, a, dx, dy, dz, b);
        return Double.isNaN(time) && need != Need.SURE_VERDICT ? ExactAxes.time(mode, a, dx, dy, dz, b) : time;
    }

    /** Begins to turn the triangles of a mesh; in the plane about the vertical. */
    public void turnTriangles(PivotTurn turn, boolean inPlane) {
        sweep().sieve.begin(turn, inPlane);
    }

    /** Takes the next triangle that turns. */
    public void turnTriangle(double[] corners) {
        sweep().sieve.mover(corners);
    }

    /** Whether the triangle that turns clearly keeps off one at rest; most that do are found. */
    public boolean isClearOf(double[] corners, double[] moving) {
        return sweep().sieve.isClear(corners, moving);
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
        final TurnSieve sieve = new TurnSieve();
    }
}
