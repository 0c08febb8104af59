package robosim.geometry.world.check;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.world.World;

/**
 * Which setting is sufficient.
 *
 * @param dimension the coarsest that gave the same answer to every query; PLANAR in a PLANAR world, and the world's own
 *                  if undecided
 * @param accuracy  the coarsest that did so in that dimension; the world's own if undecided
 * @param isProven  whether PLANAR is sufficient for all level moves and sonars: every object stands upright and reaches
 *                  the height of every robot's centre
 * @param met       number of queries that hit something: a place that is taken, a move that is refused, a sonar that
 *                  gets an echo; with fewer than {@link SettingComparison#MIN_ANSWERS}, nothing is decided
 * @param seed      seed of the queries
 * @param settings  the answers of each setting, PLANAR before SPATIAL and the coarsest first. One that was seen to answer
 *                  otherwise is asked no more than the first queries
 * @param standIn   what was asked in the place of a robot, in a world without one; null if there is a robot, or nothing
 *                  that a stand-in could meet
 */
public record RecommendedSetting(
        Dimension dimension,
        Accuracy accuracy,
        boolean isProven,
        int met,
        long seed,
        List<SettingComparison> settings,
        @Nullable SubstituteRobot standIn) {

    /** Copies the list. */
    public RecommendedSetting {
        settings = List.copyOf(settings);
    }

    /** What an incomplete world gets: nothing was queried, and the world's own setting is kept. */
    static RecommendedSetting undecided(World world) {
        List<SettingComparison> settings = new ArrayList<>();
        for (Dimension dimension : Dimension.values()) {
            for (Accuracy accuracy : Accuracy.values()) {
                settings.add(new SettingComparison(dimension, accuracy, 0, 0, 0, 0, 0, 0, 0));
            }
        }
        return new RecommendedSetting(
                world.dimension(), world.accuracy(), false, 0, SampleQueries.SEED, settings, null);
    }

    /** Whether enough queries were made, and enough of them hit something, for a decision. */
    public boolean isTold() {
        return met >= SettingComparison.MIN_ANSWERS
                && settings.stream().allMatch(setting -> setting.isAskedEnough() || setting.isRefuted());
    }

    /** The answers of one setting. */
    public SettingComparison setting(Dimension wanted, Accuracy level) {
        return settings.stream()
                .filter(setting -> setting.dimension() == wanted && setting.accuracy() == level)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "setting must be one of those compared (got: " + wanted + ", " + level + ")"));
    }
}
