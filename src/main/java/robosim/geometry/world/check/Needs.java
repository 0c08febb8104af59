package robosim.geometry.world.check;

import java.util.List;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/**
 * Which setting is enough.
 *
 * @param dimension the coarsest that answered every question alike; PLANAR in a PLANAR world, and the world's own where
 *                  it cannot be told
 * @param accuracy  the coarsest that did so in that dimension; the world's own where it cannot be told
 * @param isProven  whether PLANAR is enough whatever level moves and sonars are asked for: every object stands upright
 *                  and reaches the height of every robot's centre
 * @param met       how many of the questions met something: a place that is taken, a move that is refused, a sonar that
 *                  hears; none tells nothing
 * @param seed      of the questions
 * @param settings  what each setting answered, PLANAR before SPATIAL and the coarsest first
 */
public record Needs(
        Dimension dimension, Accuracy accuracy, boolean isProven, int met, long seed, List<Setting> settings) {
    /** Copies the list. */
    public Needs {
        settings = List.copyOf(settings);
    }

    /** Whether enough was asked, and enough was there, to tell. */
    public boolean isTold() {
        return met > 0 && settings.stream().allMatch(Setting::isAskedEnough);
    }

    /** What one setting answered. */
    public Setting setting(Dimension wanted, Accuracy level) {
        return settings.stream()
                .filter(setting -> setting.dimension() == wanted && setting.accuracy() == level)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "setting must have been asked (got: " + wanted + ", " + level + ")"));
    }
}
