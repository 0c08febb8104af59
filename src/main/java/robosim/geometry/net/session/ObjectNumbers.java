package robosim.geometry.net.session;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.model.GeometryObject;

/**
 * The numbers by which a peer is told which object is meant: an object of the init has its index there, and those that are
 * added later are counted on from the end of that list. The tables are built when first needed: most sessions never ask.
 */
final class ObjectNumbers {
    /** Additions before the tables are built anyhow: a peer may add and remove objects for days. */
    private static final int MANY = 1024;

    private List<GeometryObject> given = List.of();

    /** What was added since, removed or not: a name that is given again means the last. */
    private final List<GeometryObject> later = new ArrayList<>();

    private final BitSet leftOut = new BitSet();
    private boolean isBuilt;
    private long next;

    private final Map<String, Long> named = new HashMap<>();

    /** Objects without names are static, and the world answers with the very values that it was given. */
    private final IdentityHashMap<GeometryObject, Long> nameless = new IdentityHashMap<>();

    /** A world of these objects begins. */
    void begin(List<GeometryObject> objects) {
        given = objects;
        later.clear();
        leftOut.clear();
        isBuilt = false;
        named.clear();
        nameless.clear();
        next = objects.size();
    }

    /** An object of the list is not in the world. */
    void leftOut(int index) {
        leftOut.set(index);
    }

    /** An object was added to the world. */
    void added(GeometryObject object) {
        if (isBuilt) {
            put(object, next++);
            return;
        }
        later.add(object);
        if (later.size() > MANY) {
            build();
        }
    }

    /** An object was removed. */
    void removed(String name) {
        named.remove(name);
    }

    /** The number of an object of the world. */
    long of(GeometryObject object) {
        build();
        String name = object.name();
        Long number = name == null ? nameless.get(object) : named.get(name);
        if (number == null) {
            throw new IllegalStateException("an object of the world must have been added to it (got: " + object + ")");
        }
        return number;
    }

    private void build() {
        if (isBuilt) {
            return;
        }
        for (int k = 0; k < given.size(); k++) {
            if (!leftOut.get(k)) {
                put(given.get(k), k);
            }
        }
        for (GeometryObject object : later) {
            put(object, next++);
        }
        given = List.of();
        later.clear();
        isBuilt = true;
    }

    private void put(GeometryObject object, long number) {
        String name = object.name();
        if (name == null) {
            nameless.putIfAbsent(
                    object, number); // one value that is sent twice is two objects at one place: the first is met
        } else {
            named.put(name, number);
        }
    }
}
