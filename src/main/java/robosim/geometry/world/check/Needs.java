package robosim.geometry.world.check;

import java.util.List;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/**
 * Which setting is sufficient.
 *
 * @param dimension the coarsest that gave the same answer to every query; PLANAR in a PLANAR world, and the world's own
 *                  if undecided
 * @param accuracy  the coarsest that did so in that dimension; the world's own if undecided
 * @param isProven  whether PLANAR is sufficient for all level moves and sonars: every object stands upright and reaches
 *                  the height of every robot's centre
 * @param met       number of queries that hit something: a place that is taken, a move that is refused, a sonar that
 *                  gets an echo; with none, nothing is decided
 * @param seed      seed of the queries
 * @param settings  the answers of each setting, PLANAR before SPATIAL and the coarsest first
 */
public record Needs(
        Dimension dimension, Accuracy accuracy, boolean isProven, int met, long seed, List<Setting> settings) {
    /** Copies the list. */
    public Needs {
        settings = List.copyOf(settings);
    }

    /** Whether enough queries were made, and enough of them hit something, for a decision. */
    public boolean isTold() {
        return met > 0 && settings.stream().allMatch(Setting::isAskedEnough);
    }

    /** The answers of one setting. */
    public Setting setting(Dimension wanted, Accuracy level) {
        return settings.stream()
                .filter(setting -> setting.dimension() == wanted && setting.accuracy() == level)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "setting must be one of those compared (got: " + wanted + ", " + level + ")"));
    }
}
