package robosim.geometry.narrow.sweep;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.distance.DistanceScratch;

/** The working memory of straight sweeps. */
public class SweepScratch extends DistanceScratch {
    private @Nullable SweepWorkspace sweep;

    public SweepWorkspace sweep() {
        if (sweep == null) {
            sweep = new SweepWorkspace();
        }
        return sweep;
    }
}
