package robosim.geometry.protocol;

import java.io.Serial;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.GeometryObject;

/**
 * A new world, which replaces the one before. It is not answered.
 *
 * @param objects  what stands in it, in the order of addition
 * @param settings its size and kind; null for the session's own, with room for all objects
 */
public record InitBundle(
        List<GeometryObject> objects, @Nullable WorldSettings settings) implements Bundle {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses a list or an object that is null. */
    public InitBundle {
        objects = Checks.copy("objects", objects, GeometryObject.class);
    }

    /** A world as the session's options have it. */
    public InitBundle(List<GeometryObject> objects) {
        this(objects, null);
    }
}
