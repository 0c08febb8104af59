package robosim.geometry.engine.broadphase;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import robosim.geometry.engine.objects.SharedObjectTable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;

/**
 * Static objects that many worlds share, with what is built over them, once for each accuracy that anybody asks for. Nothing
 * that has been built changes any more; every world reads it through a view of its own, with cursors and working memory of
 * its own.
 */
public final class SharedIndex extends SharedObjectTable {
    private final Dimension dimension;
    private final double width;
    private final double length;
    private final Map<Sight, LeafTable> tables = new HashMap<>();

    /** How objects are seen. */
    private record Sight(Accuracy accuracy, Dimension dimension) {}

    /** Some objects in their order, with when they came. */
    public SharedIndex(double width, double length, Dimension dimension, GeometryObject[] objects, long[] arrivals) {
        super(objects, arrivals);
        this.width = width;
        this.length = length;
        this.dimension = dimension;
    }

    /** The objects as the world sees them at an accuracy, for one more thread to ask; built when anybody first asks. */
    public LeafTable table(Accuracy accuracy) {
        return table(accuracy, dimension);
    }

    /** The same in a dimension, which is another than the world's where a PLANAR one is seen with heights. */
    synchronized LeafTable table(Accuracy accuracy, Dimension seen) {
        Sight sight = new Sight(accuracy, seen);
        LeafTable built = tables.get(sight);
        if (built == null) {
            built = new LeafTable(objects, accuracy, seen, width, length);
            for (int id = 0; id < objects.limit(); id++) {
                built.add(id, objects.value(id));
            }
            built.freeze();
            tables.put(sight, built);
        }
        return Objects.requireNonNull(built).view();
    }
}
