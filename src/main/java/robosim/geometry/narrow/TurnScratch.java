package robosim.geometry.narrow;

import org.jspecify.annotations.Nullable;

/** The working memory of turns. */
public class TurnScratch extends SweepScratch {
    private @Nullable TurnKernels turns;

    public TurnKernels turns() {
        if (turns == null) {
            turns = new TurnKernels();
        }
        return turns;
    }
}
