package robosim.geometry.narrow.sweep;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.distance.DistanceScratch;

/** The working memory of straight sweeps. */
public class SweepScratch extends DistanceScratch {
    private @Nullable SweepKernels sweep;

    public SweepKernels sweep() {
        if (sweep == null) {
            sweep = new SweepKernels();
        }
        return sweep;
    }
}
