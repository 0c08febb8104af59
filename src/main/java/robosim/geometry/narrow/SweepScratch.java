package robosim.geometry.narrow;

import org.jspecify.annotations.Nullable;

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
