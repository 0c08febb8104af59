package robosim.geometry.world.check;

import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/**
 * What one setting answered, beside EXACT in the world's own dimension.
 *
 * @param places            how often it was asked whether a robot may stand somewhere
 * @param placesOtherwise   how often it said something else
 * @param moves             moves and turns
 * @param movesOtherwise    of them answered otherwise
 * @param distances         of sonars
 * @param distancesOtherwise of them off by more than a billionth of the world's diagonal
 * @param shortest          by how much a distance fell short at most, world units; {@code +Infinity} where it heard
 *                          something where there is no echo
 */
public record Setting(
        Dimension dimension,
        Accuracy accuracy,
        int places,
        int placesOtherwise,
        int moves,
        int movesOtherwise,
        int distances,
        int distancesOtherwise,
        double shortest) {
    /** Minimum number of moves, and of distances, that must be queried to call a setting enough. */
    public static final int MIN_ANSWERS = 50;

    /** Whether there were enough moves and distances to compare. */
    public boolean isAskedEnough() {
        return moves >= MIN_ANSWERS && distances >= MIN_ANSWERS;
    }

    /** Whether enough was asked and everything was answered alike. */
    public boolean isSame() {
        return isAskedEnough() && placesOtherwise + movesOtherwise + distancesOtherwise == 0;
    }
}
