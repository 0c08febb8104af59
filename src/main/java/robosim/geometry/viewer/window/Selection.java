package robosim.geometry.viewer.window;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.viewer.scene.Scene;

/** The selected object; if it can move it is tracked by its name. */
final class Selection {
    private @Nullable GeometryObject object;

    /** The number of the world in which it was selected. */
    private int world;

    void select(@Nullable GeometryObject selected, int inWorld) {
        object = selected;
        world = inWorld;
    }

    /**
     * The selected object at its present place; null if nothing is selected or it no longer exists.
     *
     * @param movers the moveable objects at their present places
     * @param now    the number of the world shown
     */
    @Nullable
    GeometryObject present(List<Scene.Thing> movers, int now) {
        GeometryObject before = object;
        if (before == null || !before.isMoveable()) {
            return before != null && world == now ? before : null;
        }
        for (Scene.Thing thing : movers) {
            if (Objects.equals(thing.object().name(), before.name())) {
                return thing.object();
            }
        }
        return null;
    }
}
