package robosim.geometry.dynamics.space;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.ObjectTable;

/** Who touched whom in a step: one entry for each body and what it touched, in the order in which they were first told. */
public final class Touched {
    private final Map<Long, Integer> entries = new HashMap<>();
    private final Contacts all = new Contacts();
    private final List<Long> keys = new ArrayList<>();
    private final List<@Nullable String> names = new ArrayList<>();

    void clear() {
        entries.clear();
        all.clear();
        keys.clear();
        names.clear();
    }

    public int count() {
        return all.count;
    }

    private static long key(int body, int object) {
        return ((long) body << 32) | (object & 0xffff_ffffL);
    }

    /** The entry of the same two in another step, or -1. */
    public int find(Touched of, int entry) {
        return entries.getOrDefault(of.keys.get(entry), -1);
    }

    /**
     * Adds a contact; of two bodies, the first is told to touch the other one.
     *
     * @param id      the id of the body
     * @param objects who they are, which is kept: they may be removed before anybody asks
     */
    void add(Contacts of, int k, int id, ObjectTable objects) {
        boolean isSecond = of.other[k] >= 0 && of.other[k] < of.body[k];
        int body = isSecond ? of.object[k] : id;
        int object = isSecond ? id : of.object[k];
        long key = key(body, object);
        Integer known = entries.putIfAbsent(key, all.count);
        if (known != null) {
            all.impulse[known] += of.impulse[k];
            return;
        }
        int c = 3 * k;
        double sign = isSecond ? -1 : 1;
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
        all.impulse[all.count - 1] = of.impulse[k];
        keys.add(key);
        names.add(objects.value(body).name());
        names.add(object < 0 ? null : objects.value(object).name());
    }

    /** The name of the body. */
    public String body(int entry) {
        return String.valueOf(names.get(2 * entry));
    }

    /** The name of the other object; null for one without a name and for the border of the world. */
    public @Nullable String other(int entry) {
        return names.get(2 * entry + 1);
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
