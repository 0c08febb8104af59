package robosim.geometry.engine.objects;

import java.util.BitSet;

/** The objects that do not count for the current query; mostly none. */
public final class IgnoredObjects {
    private final BitSet own = new BitSet();
    private final BitSet shared = new BitSet();
    private boolean isEmpty = true;

    /** Whether every object counts. */
    public boolean isEmpty() {
        return isEmpty;
    }

    /** Leaves out one more object. */
    public void add(int id) {
        isEmpty = false;
        (ObjectTable.isShared(id) ? shared : own).set(ObjectTable.local(id));
    }

    /** Whether an object does not count. */
    public boolean has(int id) {
        return !isEmpty && (ObjectTable.isShared(id) ? shared : own).get(ObjectTable.local(id));
    }

    /** All objects count again. */
    public void clear() {
        own.clear();
        shared.clear();
        isEmpty = true;
    }
}
