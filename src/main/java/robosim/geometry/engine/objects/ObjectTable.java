package robosim.geometry.engine.objects;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Attitude;
import robosim.geometry.index.ArrayGrowth;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Pose;

/**
 * The objects of a world by a small number, their id: values, names, order of insertion, and the present places of the
 * moveable ones. Ids of removed objects are reused.
 */
public final class ObjectTable {
    /** Number of doubles in a place, laid out by {@link Pose}. */
    public static final int PLACE = Pose.PLACE;

    /** In a place, the index of its attitude. */
    public static final int ROTATION = 3;

    /** In a place, the index of the compensated heading of an upright object. */
    public static final int HEADING = ROTATION + Attitude.HEADING;

    /** The bit that is set in the id of an object that this world shares with others: see {@link SharedObjectTable}. */
    public static final int SHARED = 1 << 29;

    private final Names names = new Names();
    private @Nullable GeometryObject[] values = new GeometryObject[ArrayGrowth.FIRST];

    /** The static objects that this world shares with others; null if all are its own. */
    private @Nullable SharedObjectTable shared;

    /** The order of insertion by id; empty until an id is reused, since until then ids are in that order. */
    private long[] order = new long[0];

    private boolean isOrdered;

    /** The index of a moveable object in the column of places, -1 for a static object. */
    private int[] slots = new int[0];

    private double[] places = new double[0];
    private int[] movers = new int[4];

    /** The String instances that name the moveable objects, in the order of their slots. */
    private @Nullable String[] moverNames = new String[4];

    private int moverCount;

    /** The moveable object that was last found by name. */
    private int found;

    private int[] free = new int[4];
    private int freeCount;
    private int capacityUsed;
    private long arrivals;
    private int size;
    private long changes;
    private long changesOfStatics;

    /** What does not count for the current query. */
    public final IgnoredObjects ignored = new IgnoredObjects(this);

    public ObjectTable() {}

    /** The objects of a world that shares some of them. */
    public ObjectTable(SharedObjectTable objects) {
        shared = objects;
        isOrdered = true;
        order = new long[values.length];
    }

    /** The number of objects, shared ones included. */
    public int size() {
        return shared == null ? size : size + shared.objects.size;
    }

    /** The number of static objects that belong to this world alone. */
    public int ownStatics() {
        return size - moverCount;
    }

    /** Removes all shared static objects from this world. */
    public void unshare() {
        changes++;
        shared = null;
    }

    /** Whether an object is one that its world shares with others. */
    public static boolean isShared(int id) {
        return id >= SHARED;
    }

    /** An object's number among the shared objects of its world, or among those that are not shared. */
    public static int local(int id) {
        return id & ~SHARED;
    }

    /** The largest id in use among the world's own objects, plus one. */
    public int limit() {
        return capacityUsed;
    }

    public boolean isPresent(int id) {
        return values[id] != null;
    }

    /** The id of a name, or -1. */
    public int find(String name) {
        if (isFound(found, name) || isFound(found + 1, name) || isFound(found - 1, name)) {
            return movers[found];
        }
        int id = names.find(name);
        if (id >= 0 && isMoveable(id)) {
            found = slots[id];
        }
        return id < 0 && shared != null ? shared.find(name) : id;
    }

    /**
     * Whether a moveable object has this very String as its name; callers mostly query moveable objects one after the
     * other.
     */
    @SuppressWarnings("ReferenceEquality") // equal strings are found in the table
    private boolean isFound(int slot, String name) {
        if (slot < 0 || slot >= moverCount || moverNames[slot] != name) {
            return false;
        }
        found = slot;
        return true;
    }

    /** How often an object was added or removed so far. */
    public long changes() {
        return changes;
    }

    /** How often a static object was added or removed so far. */
    public long changesOfStatics() {
        return changesOfStatics;
    }

    /** Adds an object and returns its id. */
    public int add(GeometryObject object) {
        changes++;
        changesOfStatics += object.isMoveable() ? 0 : 1;
        int id = freeCount > 0 ? reuse() : capacityUsed++;
        if (id == values.length) {
            int capacity = ArrayGrowth.of(id);
            values = Arrays.copyOf(values, capacity);
            if (isOrdered) {
                order = Arrays.copyOf(order, capacity);
            }
            if (moverCount > 0) {
                growSlots();
            }
        }
        values[id] = object;
        if (isOrdered) {
            order[id] = arrivals++;
        }
        if (id < slots.length) {
            slots[id] = -1;
        }
        String name = object.name();
        if (name != null) {
            names.put(name, id);
        }
        if (object.isMoveable()) {
            addMover(id, name, object.pose());
        }
        size++;
        return id;
    }

    /** Adds an object at its place among the arrivals, and returns its id. */
    public int addAt(GeometryObject object, long arrival) {
        int id = add(object);
        if (!isOrdered && arrival(id) != arrival) {
            putInOrder();
        }
        if (isOrdered) {
            order[id] = arrival;
        }
        return id;
    }

    /** Sets how many objects count as added before the next one; used where insertion order is recorded. */
    public void arriveAt(long time) {
        arrivals = time;
    }

    /** Number of objects added so far, removed ones included. */
    public long arrivals() {
        return isOrdered ? arrivals : capacityUsed;
    }

    /** Number of objects that were added before this one. */
    public long arrival(int id) {
        if (isShared(id) && shared != null) {
            return shared.arrival(local(id));
        }
        return isOrdered ? order[id] : id;
    }

    /** Reuses an id; from the first time on, the order of insertion is stored for all objects. */
    private int reuse() {
        if (!isOrdered) {
            putInOrder();
        }
        return free[--freeCount];
    }

    private void putInOrder() {
        isOrdered = true;
        order = new long[values.length];
        for (int id = 0; id < capacityUsed; id++) {
            order[id] = id;
        }
        arrivals = capacityUsed;
    }

    private void growSlots() {
        int from = slots.length;
        slots = Arrays.copyOf(slots, values.length);
        Arrays.fill(slots, from, slots.length, -1);
    }

    private void addMover(int id, @Nullable String name, Pose pose) {
        if (moverCount == movers.length) {
            movers = Arrays.copyOf(movers, 2 * moverCount);
            moverNames = Arrays.copyOf(moverNames, movers.length);
        }
        if ((moverCount + 1) * PLACE > places.length) {
            places = Arrays.copyOf(places, 2 * (moverCount + 1) * PLACE);
        }
        if (id >= slots.length) {
            growSlots();
        }
        slots[id] = moverCount;
        movers[moverCount] = id;
        moverNames[moverCount] = name;
        moverCount++;
        put(id, pose);
    }

    /** Sets the place of a moveable object to a pose. */
    public void put(int id, Pose pose) {
        pose.place(places, place(id));
    }

    /** Sets the place of a moveable object to {@link #PLACE} doubles. */
    public void put(int id, double[] place) {
        System.arraycopy(place, 0, places, place(id), PLACE);
    }

    /** Sets the centre of a moveable object: six numbers, of which the last three are its rounding errors. */
    public void shift(int id, double[] centre) {
        shift(places, place(id), centre);
    }

    /** The same for a place that begins at an element of an array. */
    public static void shift(double[] place, int at, double[] centre) {
        for (int k = 0; k < 3; k++) {
            place[at + k] = centre[k];
            place[at + Pose.LOST + k] = centre[3 + k];
        }
    }

    public void remove(int id) {
        changes++;
        String name = value(id).name();
        if (name != null) {
            names.remove(name);
        }
        if (isMoveable(id)) {
            removeMover(slots[id]);
        } else {
            changesOfStatics++;
        }
        values[id] = null;
        if (freeCount == free.length) {
            free = Arrays.copyOf(free, 2 * freeCount);
        }
        free[freeCount++] = id;
        size--;
    }

    /** Removes a mover from the list of movers, where the last one takes its slot. */
    private void removeMover(int slot) {
        moverCount--;
        movers[slot] = movers[moverCount];
        moverNames[slot] = moverNames[moverCount];
        moverNames[moverCount] = null;
        System.arraycopy(places, moverCount * PLACE, places, slot * PLACE, PLACE);
        slots[movers[slot]] = slot;
    }

    /** The ids of all objects, in the order in which they were added. */
    public IntStream ids() {
        int others = shared == null ? 0 : shared.objects.limit();
        return inOrder(IntStream.concat(IntStream.range(0, others).map(id -> id | SHARED), own()));
    }

    /** The ids of the moveable objects, in the order in which they were added. */
    public IntStream moverIds() {
        return inOrder(IntStream.range(0, moverCount).map(this::mover));
    }

    private IntStream own() {
        return IntStream.range(0, capacityUsed).filter(this::isPresent);
    }

    private IntStream inOrder(IntStream ids) {
        return ids.boxed().sorted(Comparator.comparingLong(this::arrival)).mapToInt(Integer::intValue);
    }

    /** The object as it was added. */
    public GeometryObject value(int id) {
        if (isShared(id) && shared != null) {
            return shared.objects.value(local(id));
        }
        GeometryObject value = values[id];
        if (value == null) {
            throw new IllegalStateException("id must be in use (got: " + id + ")");
        }
        return value;
    }

    /** The object as it is now. */
    public GeometryObject present(int id) {
        GeometryObject value = value(id);
        return isMoveable(id) ? value.at(Pose.of(places, place(id))) : value;
    }

    public boolean isMoveable(int id) {
        return id < slots.length && slots[id] >= 0;
    }

    /** Whether a was added before b, and so wins a tie: of objects met at the same distance or share, it is the one named. */
    public boolean isEarlier(int a, int b) {
        return isOrdered ? arrival(a) < arrival(b) : a < b;
    }

    /** Sorts ids by the order in which the objects were added; by heaps, so that many take no longer than they must. */
    public void sort(int[] ids, int count) {
        for (int root = count / 2 - 1; root >= 0; root--) {
            sift(ids, root, count);
        }
        for (int end = count - 1; end > 0; end--) {
            int last = ids[0];
            ids[0] = ids[end];
            ids[end] = last;
            sift(ids, 0, end);
        }
    }

    private void sift(int[] ids, int from, int end) {
        int root = from;
        for (int child = 2 * root + 1; child < end; child = 2 * root + 1) {
            if (child + 1 < end && isEarlier(ids[child], ids[child + 1])) {
                child++;
            }
            if (!isEarlier(ids[root], ids[child])) {
                return;
            }
            int moved = ids[root];
            ids[root] = ids[child];
            ids[child] = moved;
            root = child;
        }
    }

    public int moverCount() {
        return moverCount;
    }

    /** The id of the k-th moveable object, in order of insertion. */
    public int mover(int k) {
        return movers[k];
    }

    /** All places; that of a mover begins at {@link #place}. Valid until the next addition. */
    public double[] places() {
        return places;
    }

    /** The index at which a moveable object's place begins. */
    public int place(int id) {
        return slots[id] * PLACE;
    }

    /** Transforms a vector from a moveable object's own axes to the world's. */
    public void toWorld(int id, double x, double y, double z, double[] out) {
        int at = place(id) + 3;
        out[0] = places[at] * x + places[at + 1] * y + places[at + 2] * z;
        out[1] = places[at + 3] * x + places[at + 4] * y + places[at + 5] * z;
        out[2] = places[at + 6] * x + places[at + 7] * y + places[at + 8] * z;
    }
}
