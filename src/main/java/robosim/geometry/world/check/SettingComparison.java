package robosim.geometry.world.check;

import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/**
 * The answers of one setting, compared with EXACT in the world's own dimension.
 *
 * @param places             number of queries whether a robot may stand somewhere
 * @param placesOtherwise    number of these with another answer
 * @param moves              number of moves and turns
 * @param movesOtherwise     number of these with another answer
 * @param distances          number of sonar distances
 * @param distancesOtherwise number of these that differ by more than a billionth of the world's diagonal
 * @param shortest           the most by which a distance was too short, world units; {@code +Infinity} if there was an
 *                           echo where there should be none
 */
public record SettingComparison(
        Dimension dimension,
        Accuracy accuracy,
        int places,
        int placesOtherwise,
        int moves,
        int movesOtherwise,
        int distances,
        int distancesOtherwise,
        double shortest) {
    /** Minimum number of moves, and of distances, that must be queried to call a setting sufficient. */
    public static final int MIN_ANSWERS = 50;

    /** Whether there were enough moves and distances to compare. */
    public boolean isAskedEnough() {
        return moves >= MIN_ANSWERS && distances >= MIN_ANSWERS;
    }

    /** Whether any answer was another one. */
    public boolean isRefuted() {
        return placesOtherwise + movesOtherwise + distancesOtherwise > 0;
    }

    /** Whether enough was asked and all answers were the same. */
    public boolean isSame() {
        return isAskedEnough() && !isRefuted();
    }
}
