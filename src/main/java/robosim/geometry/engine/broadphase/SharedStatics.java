package robosim.geometry.engine.broadphase;

import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import robosim.geometry.engine.objects.SharedObjects;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;

/**
 * Static objects that many worlds share, with what is built over them, once for each accuracy that anybody asks for. Nothing
 * that has been built changes any more; every world reads it through a view of its own, with cursors and working memory of
 * its own.
 */
public final class SharedStatics extends SharedObjects {
    private final Dimension dimension;
    private final double width;
    private final double length;
    private final Map<Accuracy, AccuracyView> levels = new EnumMap<>(Accuracy.class);

    /** Some objects in their order, with when they came. */
    public SharedStatics(double width, double length, Dimension dimension, GeometryObject[] objects, long[] arrivals) {
        super(objects, arrivals);
        this.width = width;
        this.length = length;
        this.dimension = dimension;
    }

    /** The objects as they are seen at an accuracy, for one more thread to ask; built when anybody first asks. */
    public synchronized AccuracyView view(Accuracy accuracy) {
        AccuracyView built = levels.get(accuracy);
        if (built == null) {
            built = new AccuracyView(bodies, accuracy, dimension, width, length, null);
            for (int id = 0; id < bodies.limit(); id++) {
                built.add(id, bodies.value(id));
            }
            built.freeze();
            levels.put(accuracy, built);
        }
        return Objects.requireNonNull(built).view();
    }
}
