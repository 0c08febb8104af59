package robosim.geometry.dynamics.step;

import java.util.Arrays;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.GeometryObject;

/**
 * Who touched whom in a step: one entry for each two objects, in the order in which they were first told. It keeps the objects
 * themselves, and where they touched: they may be removed, and bodies numbered anew, before anybody asks.
 */
public final class ContactLog {
    private static final int FIRST = 16;

    public int count;

    /** The object of the body, and the other one as they were added; null for the border of the world. */
    private @Nullable GeometryObject[] body = new GeometryObject[FIRST];

    private @Nullable GeometryObject[] other = new GeometryObject[FIRST];

    public double[] x = new double[FIRST];

    /** Of the body's centre. */
    public double[] y = new double[FIRST];

    public double[] z = new double[FIRST];

    /** Unit normal towards the body. */
    public double[] nx = new double[FIRST];

    public double[] nz = new double[FIRST];

    /** What the body was given along the normal, newton seconds, by all of their impulses. */
    public double[] impulse = new double[FIRST];

    // The greatest of the impulses.
    private double[] most = new double[FIRST];

    /** The ids of both objects as one number, whichever is the body. */
    private long[] keys = new long[FIRST];

    private int[] table = new int[4 * FIRST];
    private final ObjectTable objects;

    ContactLog(ObjectTable objects) {
        this.objects = objects;
        Arrays.fill(table, -1);
    }

    void clear() {
        if (count > 0) {
            Arrays.fill(table, -1);
            Arrays.fill(body, 0, count, null);
            Arrays.fill(other, 0, count, null);
        }
        count = 0;
    }

    /** The name of the body. */
    public String body(int entry) {
        return Objects.requireNonNull(Objects.requireNonNull(body[entry]).name());
    }

    /** The name of the other object; null for one without a name and for the border of the world. */
    public @Nullable String other(int entry) {
        GeometryObject object = other[entry];
        return object == null ? null : object.name();
    }

    /** The entry of the same two in another step, or -1. */
    public int find(ContactLog of, int entry) {
        int here = find(of.keys[entry]);
        return here >= 0 && isSame(here, of, entry) ? here : -1;
    }

    /** An id is given again once its object is removed. */
    private boolean isSame(int here, ContactLog of, int entry) {
        return body[here] == of.body[entry]
                ? other[here] == of.other[entry]
                : body[here] == of.other[entry] && other[here] == of.body[entry];
    }

    private int find(long key) {
        for (int at = slot(key); table[at] >= 0; at = (at + 1) & (table.length - 1)) {
            if (keys[table[at]] == key) {
                return table[at];
            }
        }
        return -1;
    }

    private int slot(long key) {
        return (int) ((key * 0x9E3779B97F4A7C15L) >>> 40) & (table.length - 1);
    }

    /**
     * Adds to what a body was pushed by another object; where and along what is that of the greatest impulse.
     *
     * @param id     of the body's object
     * @param object the id of the other one; -1 for the border
     */
    void add(int id, int object, double px, double pz, double normalX, double normalZ, double by) {
        long key = ((long) Math.min(id, object) << 32) | (Math.max(id, object) & 0xffff_ffffL);
        int entry = find(key);
        if (entry < 0) {
            entry = enter(key);
            body[entry] = objects.value(id);
            other[entry] = object < 0 ? null : objects.value(object);
            y[entry] = objects.places()[objects.place(id) + 1];
        } else if (by <= most[entry]) {
            impulse[entry] += by;
            return;
        }
        most[entry] = by;
        x[entry] = px;
        z[entry] = pz;
        nx[entry] = normalX;
        nz[entry] = normalZ;
        impulse[entry] += by;
    }

    private int enter(long key) {
        if (count == keys.length) {
            int room = 2 * count;
            keys = Arrays.copyOf(keys, room);
            body = Arrays.copyOf(body, room);
            other = Arrays.copyOf(other, room);
            x = Arrays.copyOf(x, room);
            y = Arrays.copyOf(y, room);
            z = Arrays.copyOf(z, room);
            nx = Arrays.copyOf(nx, room);
            nz = Arrays.copyOf(nz, room);
            impulse = Arrays.copyOf(impulse, room);
            most = Arrays.copyOf(most, room);
            table = new int[4 * room];
            Arrays.fill(table, -1);
            for (int k = 0; k < count; k++) {
                insert(k);
            }
        }
        keys[count] = key;
        impulse[count] = 0;
        most[count] = 0;
        insert(count);
        return count++;
    }

    private void insert(int entry) {
        int at = slot(keys[entry]);
        while (table[at] >= 0) {
            at = (at + 1) & (table.length - 1);
        }
        table[at] = entry;
    }
}
