package robosim.geometry.narrow.turn;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.sweep.SweepScratch;

/** The working memory of turns. */
public class TurnScratch extends SweepScratch {
    private @Nullable TurnWorkspace turns;

    public TurnWorkspace turns() {
        if (turns == null) {
            turns = new TurnWorkspace();
        }
        return turns;
    }
}
