package robosim.geometry.dynamics.space;

import java.util.Arrays;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.GeometryObject;

/** Who touched whom in a step: one entry for each body and what it touched, in the order in which they were first told. */
public final class ContactLog {
    private static final int FIRST = 64;

    private final Contacts all = new Contacts();

    /** The greatest of the impulses of each entry. */
    private double[] most = new double[FIRST];

    /** The two of each entry as one number. */
    private long[] keys = new long[FIRST];

    /** The two of each entry as they were added to the world; null for its border. */
    private @Nullable GeometryObject[] values = new GeometryObject[2 * FIRST];

    /** Entries by the hash of their keys, each plus one; 0 for none. Twice as long as the keys. */
    private int[] table = new int[2 * FIRST];

    void clear() {
        Arrays.fill(table, 0);
        Arrays.fill(values, 0, 2 * all.count, null);
        all.clear();
    }

    public int count() {
        return all.count;
    }

    private static long key(int body, int object) {
        return ((long) body << 32) | (object & 0xffff_ffffL);
    }

    /** Where a key is in the table, or where it belongs. */
    private int slot(long key) {
        int mask = table.length - 1;
        int slot = (int) ((key * 0x9E37_79B9_7F4A_7C15L) >>> 40) & mask;
        while (table[slot] != 0 && keys[table[slot] - 1] != key) {
            slot = (slot + 1) & mask;
        }
        return slot;
    }

    private void grow() {
        keys = Arrays.copyOf(keys, 2 * keys.length);
        values = Arrays.copyOf(values, 2 * values.length);
        most = Arrays.copyOf(most, keys.length);
        table = new int[2 * table.length];
        for (int entry = 0; entry < all.count; entry++) {
            table[slot(keys[entry])] = entry + 1;
        }
    }

    /** The entry of the same two in another step, or -1. */
    public int find(ContactLog of, int entry) {
        int here = table[slot(of.keys[entry])] - 1;
        // An id is given again once its object is removed.
        boolean isSame = here >= 0
                && values[2 * here] == of.values[2 * entry]
                && values[2 * here + 1] == of.values[2 * entry + 1];
        return isSame ? here : -1;
    }

    /**
     * Adds a contact; of two bodies, the first is told to touch the other one. Of several with the same two, impulses add up,
     * and where and along what they touch is that of the greatest.
     *
     * @param id      the id of the body
     * @param objects who they are, which is kept: they may be removed before anybody asks
     */
    void add(Contacts of, int k, int id, ObjectTable objects) {
        boolean isSecond = of.other[k] >= 0 && of.other[k] < of.body[k];
        int body = isSecond ? of.object[k] : id;
        int object = isSecond ? id : of.object[k];
        long key = key(body, object);
        int slot = slot(key);
        double impulse = of.impulse[k];
        double sign = isSecond ? -1 : 1;
        if (table[slot] != 0) {
            int known = table[slot] - 1;
            all.impulse[known] += impulse;
            if (impulse > most[known]) {
                most[known] = impulse;
                for (int axis = 0; axis < 3; axis++) {
                    all.point[3 * known + axis] = of.point[3 * k + axis];
                    all.normal[3 * known + axis] = sign * of.normal[3 * k + axis] + 0.0;
                }
            }
            return;
        }
        int entry = all.count;
        if (entry == keys.length) {
            grow();
            slot = slot(key);
        }
        table[slot] = entry + 1;
        keys[entry] = key;
        most[entry] = impulse;
        values[2 * entry] = objects.value(body);
        values[2 * entry + 1] = object < 0 ? null : objects.value(object);
        int c = 3 * k;
        all.add(
                body,
                -1,
                object,
                of.point[c],
                of.point[c + 1],
                of.point[c + 2],
                sign * of.normal[c] + 0.0,
                sign * of.normal[c + 1] + 0.0,
                sign * of.normal[c + 2] + 0.0,
                of.apart[k]);
        all.impulse[entry] = impulse;
    }

    /** The name of the body. */
    public String body(int entry) {
        return Objects.requireNonNull(Objects.requireNonNull(values[2 * entry]).name());
    }

    /** The name of the other object; null for one without a name and for the border of the world. */
    public @Nullable String other(int entry) {
        GeometryObject other = values[2 * entry + 1];
        return other == null ? null : other.name();
    }

    /** A coordinate of the point of contact. */
    public double point(int entry, int axis) {
        return all.point[3 * entry + axis];
    }

    /** A coordinate of the unit normal towards the body. */
    public double normal(int entry, int axis) {
        return all.normal[3 * entry + axis];
    }

    /** What the body was given along normals, newton seconds. */
    public double impulse(int entry) {
        return all.impulse[entry];
    }
}
