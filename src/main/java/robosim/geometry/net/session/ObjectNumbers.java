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

    /** The numbers of the second of such values and of those after it. */
    private final IdentityHashMap<GeometryObject, List<Long>> again = new IdentityHashMap<>();

    /** An object of the world and its number. */
    record Numbered(long number, GeometryObject object) {}

    /** A world of these objects begins. */
    void begin(List<GeometryObject> objects) {
        given = objects;
        later.clear();
        leftOut.clear();
        isBuilt = false;
        named.clear();
        nameless.clear();
        again.clear();
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

    /**
     * The objects with the least numbers from one on.
     *
     * @param present all objects of the world in the order in which they were added, which is that of their numbers
     */
    List<Numbered> page(List<GeometryObject> present, long first, int most) {
        build();
        List<Numbered> page = new ArrayList<>();
        IdentityHashMap<GeometryObject, Integer> seen = new IdentityHashMap<>();
        for (int k = again.isEmpty() ? position(present, first) : 0; k < present.size() && page.size() < most; k++) {
            GeometryObject object = present.get(k);
            List<Long> later = again.get(object);
            int times = later == null ? 0 : seen.merge(object, 1, Integer::sum) - 1;
            long number = later == null || times == 0 ? of(object) : later.get(times - 1);
            if (number >= first) {
                page.add(new Numbered(number, object));
            }
        }
        return page;
    }

    /** Where the first object is whose number is at least {@code first}. */
    private int position(List<GeometryObject> present, long first) {
        int low = 0;
        int high = present.size();
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (of(present.get(middle)) < first) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
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
            // One value that is sent twice is two objects at one place: the first is met.
            if (nameless.putIfAbsent(object, number) != null) {
                again.computeIfAbsent(object, twice -> new ArrayList<>()).add(number);
            }
        } else {
            named.put(name, number);
        }
    }
}
