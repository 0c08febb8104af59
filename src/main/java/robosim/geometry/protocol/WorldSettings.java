package robosim.geometry.protocol;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/**
 * The size, dimension and accuracy of a world, a box centred at the origin.
 *
 * @param width     extent along X, world units
 * @param height    extent along Y
 * @param length    extent along Z
 * @param dimension whether heights count
 * @param accuracy  what stands for an object in queries that name no accuracy
 */
public record WorldSettings(double width, double height, double length, Dimension dimension, Accuracy accuracy)
        implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses null, and sizes that are not above 0 and at most 2<sup>101</sup>. */
    public WorldSettings {
        Checks.worldSize("width", width);
        Checks.worldSize("height", height);
        Checks.worldSize("length", length);
        Checks.present("dimension", dimension);
        Checks.present("accuracy", accuracy);
    }
}
