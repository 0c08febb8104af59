package robosim.geometry.proof;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * The objects that a proof is about, in their order.
 *
 * @param objects   where they stand; at least none
 * @param dimension whether heights count
 * @param size      extents of the world along X, Y and Z, which is centred at the origin; null where nothing bounds it
 */
public record Scene(
        List<GeometryObject> objects,
        Dimension dimension,
        @Nullable Point size) {
    /** Copies the list. */
    public Scene {
        objects = List.copyOf(Checks.present("objects", objects));
        Checks.present("dimension", dimension);
    }

    /** A single object in space without a border, for claims about two objects. */
    public static Scene of(GeometryObject object) {
        return new Scene(List.of(Checks.present("object", object)), Dimension.SPATIAL, null);
    }
}
