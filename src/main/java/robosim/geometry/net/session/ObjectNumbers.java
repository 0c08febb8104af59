package robosim.geometry.net.session;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;

/**
 * The numbers by which a peer is told which object is meant: an object of the init has its index there, and those that are
 * added later are counted on from the end of that list. The tables are built when first needed: most sessions never ask, and add nothing.
 */
final class ObjectNumbers {
    private List<GeometryObject> given = List.of();

    private final BitSet leftOut = new BitSet();
    private boolean isBuilt;
    private long next;

    private final Map<String, Long> named = new HashMap<>();

    /** Objects without names are static, and the world answers with the very values that it was given. */
    private final IdentityHashMap<GeometryObject, Long> nameless = new IdentityHashMap<>();

    /** The numbers of the second of such values and of those after it. */
    private final IdentityHashMap<GeometryObject, List<Long>> again = new IdentityHashMap<>();

    /** What was added and removed since the last {@link #keep}. */
    private final List<Change> changes = new ArrayList<>();

    /**
     * An object that came or went.
     *
     * @param number of one that went
     * @param added  null for one that went
     */
    private record Change(
            String name, @Nullable Long number, @Nullable GeometryObject added, boolean isMoveable) {}

    /** An object of the world and its number. */
    record Numbered(long number, GeometryObject object) {}

    /** A world of these objects begins. */
    void begin(List<GeometryObject> objects) {
        given = objects;
        changes.clear();
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
        build();
        put(object, next++);
        String name = object.name();
        changes.add(new Change(name == null ? "" : name, null, object, object.isMoveable() && name != null));
    }

    /** An object was removed; whether it could move. */
    void removed(String name, boolean isMoveable) {
        build();
        Long number = named.remove(name);
        changes.add(new Change(name, number, null, isMoveable));
    }

    /** Begins what may be taken back. */
    void keep() {
        changes.clear();
    }

    /** Takes back what was added and removed since, the last first. */
    void undo(Set<String> moveable) {
        for (int k = changes.size() - 1; k >= 0; k--) {
            Change change = changes.get(k);
            GeometryObject added = change.added;
            if (added == null) {
                if (change.number != null) { // loads of an object are not numbered
                    named.put(change.name, change.number);
                }
            } else {
                next--;
                forget(added);
            }
            if (change.isMoveable && added == null) {
                moveable.add(change.name);
            } else if (change.isMoveable) {
                moveable.remove(change.name);
            }
        }
        changes.clear();
    }

    private void forget(GeometryObject added) {
        String name = added.name();
        List<Long> later = name == null ? again.get(added) : null;
        if (name != null) {
            named.remove(name);
        } else if (later == null) {
            nameless.remove(added);
        } else if (later.size() == 1) {
            again.remove(added);
        } else {
            later.remove(later.size() - 1);
        }
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
        given = List.of();
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
