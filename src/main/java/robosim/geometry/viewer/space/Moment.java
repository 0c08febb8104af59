package robosim.geometry.viewer.space;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.viewer.scene.Scene;

/**
 * What a viewer shows at one moment.
 *
 * @param world     identifies the world: of two moments with the same number only what is moveable differs
 * @param dimension whether sonars look up and down too
 * @param border    the part of the world that stands on the floor
 * @param statics   the static objects
 * @param life      the moveable objects with what happened to them
 */
public record Moment(int world, Dimension dimension, Scene.View border, List<Scene.Thing> statics, Scene life) {
    public Moment {
        Checks.present("dimension", dimension);
        Checks.present("border", border);
        statics = Checks.list("statics", statics);
        Checks.present("life", life);
    }

    /** Whether a picture of it would be the same, apart from what is drawn over it. */
    boolean looksLike(Moment other) {
        return world == other.world && life.things().equals(other.life.things());
    }

    /** The moveable object of a name; null for none. */
    @Nullable
    GeometryObject mover(String name) {
        for (Scene.Thing thing : life.things()) {
            if (name.equals(thing.object().name())) {
                return thing.object();
            }
        }
        return null;
    }

    /** What a camera has to show. */
    public Bounds bounds() {
        return Stage.bounds(this);
    }
}
