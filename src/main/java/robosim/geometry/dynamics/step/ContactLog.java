package robosim.geometry.dynamics.step;

import java.util.Arrays;

/** Who touched whom in a step: one entry for each two objects, in the order in which they were first told. */
public final class ContactLog {
    private static final int FIRST = 16;

    /** Added to the id of an object without a body, so that it is told from the index of one. */
    private static final int STILL = 0x40000001;

    public int count;

    /** The index of the body, and of the other one or -1. */
    public int[] body = new int[FIRST];

    public int[] otherBody = new int[FIRST];

    /** The id of the other object; -1 for the border of the world. */
    public int[] otherObject = new int[FIRST];

    public double[] x = new double[FIRST];
    public double[] z = new double[FIRST];

    /** Unit normal towards the body. */
    public double[] nx = new double[FIRST];

    public double[] nz = new double[FIRST];

    /** What the body was given along the normal, newton seconds, by all of their impulses. */
    public double[] impulse = new double[FIRST];

    // The greatest of the impulses.
    private double[] most = new double[FIRST];

    private long[] keys = new long[FIRST];
    private int[] table = new int[4 * FIRST];

    ContactLog() {
        Arrays.fill(table, -1);
    }

    void clear() {
        if (count > 0) {
            Arrays.fill(table, -1);
        }
        count = 0;
    }

    /** The entry of the same two in another step, or -1. */
    public int find(ContactLog of, int entry) {
        return find(of.keys[entry]);
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

    /** Adds to what one was pushed by another; where and along what is that of the greatest impulse. */
    void add(int ofBody, int other, int object, double px, double pz, double normalX, double normalZ, double by) {
        long key = ((long) ofBody << 32) | (other >= 0 ? other : object + STILL);
        int entry = find(key);
        if (entry < 0) {
            entry = enter(key);
            body[entry] = ofBody;
            otherBody[entry] = other;
            otherObject[entry] = object;
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
            otherBody = Arrays.copyOf(otherBody, room);
            otherObject = Arrays.copyOf(otherObject, room);
            x = Arrays.copyOf(x, room);
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
