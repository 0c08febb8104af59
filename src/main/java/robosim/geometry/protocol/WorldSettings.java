package robosim.geometry.protocol;

import java.io.Serial;
import java.io.Serializable;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/**
 * The size, dimension and accuracy of a world, a box centred at the origin. Each may be left out; the session then takes its
 * own, and a size that holds all objects: {@code WorldSettings.NONE.withDimension(Dimension.SPATIAL)}.
 *
 * @param width     extent along X, world units; 0 for one that holds all objects
 * @param height    extent along Y; 0 for one that holds all objects
 * @param length    extent along Z; 0 for one that holds all objects
 * @param dimension whether heights count; null for the session's own
 * @param accuracy  what stands for an object in queries that name no accuracy; null for the session's own
 */
public record WorldSettings(
        double width,
        double height,
        double length,
        @Nullable Dimension dimension,
        @Nullable Accuracy accuracy) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** Nothing: all is the session's own. */
    public static final WorldSettings NONE = new WorldSettings(0, 0, 0, null, null);

    /** Refuses sizes that are negative, NaN or above 2<sup>101</sup>. */
    public WorldSettings {
        width = size("width", width);
        height = size("height", height);
        length = size("length", length);
    }

    private static double size(String argument, double value) {
        return value == 0 ? 0 : Checks.worldSize(argument, value);
    }

    /** These with a size. */
    public WorldSettings withSize(double otherWidth, double otherHeight, double otherLength) {
        return new WorldSettings(otherWidth, otherHeight, otherLength, dimension, accuracy);
    }

    /** These with a dimension. */
    public WorldSettings withDimension(Dimension other) {
        return new WorldSettings(width, height, length, Checks.present("dimension", other), accuracy);
    }

    /** These with an accuracy. */
    public WorldSettings withAccuracy(Accuracy other) {
        return new WorldSettings(width, height, length, dimension, Checks.present("accuracy", other));
    }

    /** Whether nothing is left out. */
    public boolean isComplete() {
        return width > 0 && height > 0 && length > 0 && dimension != null && accuracy != null;
    }
}
