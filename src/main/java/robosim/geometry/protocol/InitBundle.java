package robosim.geometry.protocol;

import java.io.Serial;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.GeometryObject;

/**
 * A new world, which replaces the previous one. It gets no answer.
 *
 * @param objects  its objects, in the order of addition
 * @param settings its size, dimension and accuracy, each of which may be left out; null for the session's own, with a size
 *                 that holds all objects
 */
public record InitBundle(
        List<GeometryObject> objects, @Nullable WorldSettings settings) implements Bundle {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses a list or an object that is null. */
    public InitBundle {
        objects = Checks.copy("objects", objects, GeometryObject.class);
    }

    /** A world with the session's default settings. */
    public InitBundle(List<GeometryObject> objects) {
        this(objects, null);
    }
}
