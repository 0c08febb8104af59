package robosim.geometry.dynamics.space;

import java.util.HashMap;
import java.util.Map;

/** Who touched whom in a step: one entry for each body and what it touched, in the order in which they were first told. */
public final class Touched {
    private final Map<Long, Integer> entries = new HashMap<>();
    private final Contacts all = new Contacts();

    void clear() {
        entries.clear();
        all.clear();
    }

    public int count() {
        return all.count;
    }

    private static long key(int body, int object) {
        return ((long) body << 32) | (object & 0xffff_ffffL);
    }

    /** The entry of the same two in another step, or -1. */
    public int find(Touched of, int entry) {
        return entries.getOrDefault(key(of.all.body[entry], of.all.object[entry]), -1);
    }

    /**
     * Adds a contact; of two bodies, the first is told to touch the other one.
     *
     * @param id the id of the body
     */
    void add(Contacts of, int k, int id) {
        boolean isSecond = of.other[k] >= 0 && of.other[k] < of.body[k];
        int body = isSecond ? of.other[k] : of.body[k];
        int object = isSecond ? id : of.object[k];
        Integer known = entries.putIfAbsent(key(body, object), all.count);
        if (known != null) {
            all.impulse[known] += of.impulse[k];
            return;
        }
        int c = 3 * k;
        double sign = isSecond ? -1 : 1;
        all.add(
                body,
                isSecond ? of.body[k] : of.other[k],
                object,
                of.point[c],
                of.point[c + 1],
                of.point[c + 2],
                sign * of.normal[c] + 0.0,
                sign * of.normal[c + 1] + 0.0,
                sign * of.normal[c + 2] + 0.0,
                of.apart[k]);
        all.impulse[all.count - 1] = of.impulse[k];
    }

    public int body(int entry) {
        return all.body[entry];
    }

    /** The id of the other object; -1 for the border of the world. */
    public int object(int entry) {
        return all.object[entry];
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
