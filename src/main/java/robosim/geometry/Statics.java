package robosim.geometry;

import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;

/**
 * Static objects that many worlds share, and what is built over them, once for each accuracy that anybody asks for. Nothing
 * that has been built changes any more; every world reads it through a view of its own, with cursors and working memory of
 * its own.
 */
final class Statics {
    /** The objects by their number; read only. */
    final Bodies bodies = new Bodies();

    private final Dimension dimension;
    private final double width;
    private final double length;

    /** When each came, in arrivals before it at the world that they are of; null where that is its number. */
    private final long @Nullable [] arrivals;

    private final Map<Accuracy, Level> levels = new EnumMap<>(Accuracy.class);

    /** Some objects in their order, with when they came. */
    Statics(double width, double length, Dimension dimension, GeometryObject[] objects, long[] arrivals) {
        this.width = width;
        this.length = length;
        this.dimension = dimension;
        boolean isPlain = true;
        for (int id = 0; id < objects.length; id++) {
            bodies.add(objects[id]);
            isPlain &= arrivals[id] == id;
        }
        this.arrivals = isPlain ? null : arrivals;
    }

    /** The number of a name's object as an id, or -1. */
    int find(String name) {
        int id = bodies.find(name);
        return id < 0 ? id : id | Bodies.SHARED;
    }

    /** When the object of a number came. */
    long arrival(int id) {
        return arrivals == null ? id : arrivals[id];
    }

    /** The objects as they are seen at an accuracy, for one more thread to ask; built when anybody first asks. */
    synchronized Level view(Accuracy accuracy) {
        Level built = levels.get(accuracy);
        if (built == null) {
            built = new Level(bodies, accuracy, dimension, width, length, null);
            for (int id = 0; id < bodies.limit(); id++) {
                built.add(id, bodies.value(id));
            }
            built.freeze();
            levels.put(accuracy, built);
        }
        return Objects.requireNonNull(built).view();
    }
}
