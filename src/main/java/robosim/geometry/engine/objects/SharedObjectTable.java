package robosim.geometry.engine.objects;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;

/** Static objects that many worlds share, by number, with their order of insertion. Read only. */
public class SharedObjectTable {
    /** The objects by number. */
    public final ObjectTable objects = new ObjectTable();

    /**
     * For each object, how many objects had been added before it to the original world; null if that equals its number.
     */
    private final long @Nullable [] arrivals;

    /** Takes objects in their order, with their order of insertion. */
    public SharedObjectTable(GeometryObject[] values, long[] arrivals) {
        boolean isPlain = true;
        for (int id = 0; id < values.length; id++) {
            objects.add(values[id]);
            isPlain &= arrivals[id] == id;
        }
        this.arrivals = isPlain ? null : arrivals;
    }

    /** The id of the object with a given name, or -1. */
    int find(String name) {
        int id = objects.find(name);
        return id < 0 ? id : id | ObjectTable.SHARED;
    }

    /** How many objects had been added before the object of a given number. */
    public long arrival(int id) {
        return arrivals == null ? id : arrivals[id];
    }
}
