package robosim.geometry.engine.objects;

import org.jspecify.annotations.Nullable;

/**
 * The ids of named objects: a hash table with open addressing. Most lookups use the same String instance that was put
 * in.
 */
final class Names {
    private static final int NONE = -1;

    /** The length is a power of two, at least twice the number of names. */
    private @Nullable String[] keys = new String[16];

    private int[] ids = new int[16];
    private int shift = Integer.SIZE - 4;
    private int size;

    /** The id of a name, or -1. */
    int find(String name) {
        @Nullable String[] table = keys;
        int mask = table.length - 1;
        int at = home(name);
        while (true) {
            String key = table[at];
            if (key == null) {
                return NONE;
            }
            if (key.equals(name)) {
                return ids[at];
            }
            at = (at + 1) & mask;
        }
    }

    /** Adds a name that is not in the table. */
    void put(String name, int id) {
        if (2 * ++size > keys.length) {
            grow();
        }
        insert(name, id);
    }

    private void insert(String name, int id) {
        int mask = keys.length - 1;
        int at = home(name);
        while (keys[at] != null) {
            at = (at + 1) & mask;
        }
        keys[at] = name;
        ids[at] = id;
    }

    private void grow() {
        @Nullable String[] oldKeys = keys;
        int[] oldIds = ids;
        keys = new String[2 * oldKeys.length];
        ids = new int[keys.length];
        shift--;
        for (int k = 0; k < oldKeys.length; k++) {
            String name = oldKeys[k];
            if (name != null) {
                insert(name, oldIds[k]);
            }
        }
    }

    /** Removes a name that is in the table, and closes the gap, since later entries may have been displaced by it. */
    void remove(String name) {
        int mask = keys.length - 1;
        int gap = home(name);
        while (!name.equals(keys[gap])) {
            gap = (gap + 1) & mask;
        }
        size--;
        int at = gap;
        while (true) {
            at = (at + 1) & mask;
            String other = keys[at];
            if (other == null) {
                keys[gap] = null;
                return;
            }
            int home = home(other);
            if (((at - home) & mask) >= ((at - gap) & mask)) {
                keys[gap] = other;
                ids[gap] = ids[at];
                gap = at;
            }
        }
    }

    // Names that end in a number have clustered hash codes; multiplying by the golden ratio spreads them evenly.
    private int home(String name) {
        return (name.hashCode() * 0x9E3779B9) >>> shift;
    }
}
