package robosim.geometry.engine.objects;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;

/** Static objects that many worlds share, by their number, and when each of them came. Read only. */
public class SharedObjects {
    /** The objects by their number. */
    public final ObjectTable objects = new ObjectTable();

    /** When each came, in arrivals before it at the world that they are of; null where that is its number. */
    private final long @Nullable [] arrivals;

    /** Some objects in their order, with when they came. */
    public SharedObjects(GeometryObject[] values, long[] arrivals) {
        boolean isPlain = true;
        for (int id = 0; id < values.length; id++) {
            objects.add(values[id]);
            isPlain &= arrivals[id] == id;
        }
        this.arrivals = isPlain ? null : arrivals;
    }

    /** The number of a name's object as an id, or -1. */
    int find(String name) {
        int id = objects.find(name);
        return id < 0 ? id : id | ObjectTable.SHARED;
    }

    /** When the object of a number came. */
    public long arrival(int id) {
        return arrivals == null ? id : arrivals[id];
    }
}
