package robosim.geometry.engine.objects;

import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** The objects that do not count for the current query; mostly none. */
public final class IgnoredObjects {
    private static final int[] NONE = new int[0];

    private final ObjectTable objects;
    private final BitSet own = new BitSet();
    private final BitSet shared = new BitSet();
    private boolean isEmpty = true;

    /** The ids of the objects in each layer; null until a layer is first looked up. */
    private @Nullable Map<String, int[]> layers;

    /** The number of changes of the table when the layers were listed. */
    private long listed;

    IgnoredObjects(ObjectTable objects) {
        this.objects = objects;
    }

    /** Whether every object counts. */
    public boolean isEmpty() {
        return isEmpty;
    }

    /** Leaves out one more object. */
    public void add(int id) {
        isEmpty = false;
        (ObjectTable.isShared(id) ? shared : own).set(ObjectTable.local(id));
    }

    /** Leaves out those that another list leaves out, too. */
    void addAll(IgnoredObjects others) {
        isEmpty &= others.isEmpty;
        own.or(others.own);
        shared.or(others.shared);
    }

    /** Leaves out all objects of a layer; false if there are none. */
    public boolean addLayer(String name) {
        int[] members = layer(name);
        for (int id : members) {
            add(id);
        }
        return members.length > 0;
    }

    /** The ids of the objects of a layer; none if there is no such layer. */
    int[] layer(String name) {
        Map<String, int[]> known = layers;
        if (known == null || listed != objects.changes()) {
            known = list();
            layers = known;
            listed = objects.changes();
        }
        return known.getOrDefault(name, NONE);
    }

    private Map<String, int[]> list() {
        Map<String, BitSet> found = new HashMap<>();
        objects.ids().forEach(id -> {
            for (String layer : objects.value(id).layers()) {
                found.computeIfAbsent(layer, name -> new BitSet()).set(id);
            }
        });
        Map<String, int[]> lists = new HashMap<>();
        found.forEach((layer, ids) -> lists.put(layer, ids.stream().toArray()));
        return lists;
    }

    /** Whether an object does not count. */
    public boolean has(int id) {
        return !isEmpty && (ObjectTable.isShared(id) ? shared : own).get(ObjectTable.local(id));
    }

    /** All objects count again. */
    public void clear() {
        if (!isEmpty) {
            own.clear();
            shared.clear();
            isEmpty = true;
        }
    }
}
