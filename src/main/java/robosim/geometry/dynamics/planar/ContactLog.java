package robosim.geometry.dynamics.planar;

import java.util.Arrays;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.GeometryObject;

/**
 * Who touched whom in a step, and which bodies were stopped: one entry for each two objects, and of an object that has several faces at once one for each of
 * them, in the order in which they were first told. It keeps the objects themselves, and where they touched: they may be
 * removed, and bodies numbered anew, before anybody asks.
 *
 * <p>What touches at one time is noted first and then told. Of the same two, the same normal is the same face. Another normal
 * is that of a face which turns, if there is one that was like it before and does not touch any more; else it is a new face.
 */
public final class ContactLog {
    /** Why a body was stopped. */
    public enum Cause {
        COLLISIONS,
        BLOCKED,
        OVERLAP
    }

    private static final int FIRST = 64;

    /** The cosine of the angle between two normals of one face: they differ in rounding. */
    private static final double SAME = 1 - 1e-9;

    /** The cosine of 30 degrees: from one time to the next, the normal of a face that turns does so by less. */
    private static final double TURNED = 0.866;

    private final ObjectTable objects;
    private int count;

    /** The object of the body, and the other one as they were added; null for the border of the world. */
    private @Nullable GeometryObject[] body = new GeometryObject[FIRST];

    private @Nullable GeometryObject[] other = new GeometryObject[FIRST];

    /** Three numbers each: where the two touched with the greatest impulse, and the unit normal there, towards the body. */
    private double[] point = new double[3 * FIRST];

    private double[] normal = new double[3 * FIRST];

    /** What the body was given along its normals, newton seconds, by all impulses, and by the greatest of them. */
    private double[] impulse = new double[FIRST];

    private double[] most = new double[FIRST];

    /** The normal when the entry was last told, and when it was last seen to touch, by the number of that time. */
    private double[] latest = new double[3 * FIRST];

    private long[] seen = new long[FIRST];

    /** Whether it goes on from the step before, and into the step after. */
    private boolean[] isOld = new boolean[FIRST];

    private boolean[] goesOn = new boolean[FIRST];

    /** The ids of both objects as one number, whichever is the body, and the next entry with the same; -1 for none. */
    private long[] keys = new long[FIRST];

    private int[] next = new int[FIRST];

    /** The first entries of keys, by their hash; -1 for none. */
    private int[] table = new int[4 * FIRST];

    private long time;
    private @Nullable ContactLog before;

    // What touches now.
    private int notes;
    private int[] noteBody = new int[FIRST];
    private int[] noteOther = new int[FIRST];
    private double[] notePoint = new double[3 * FIRST];
    private double[] noteNormal = new double[3 * FIRST];
    private double[] noteImpulse = new double[FIRST];

    // Who was stopped, in the order of the indices of the bodies, by which object, and why.
    private int stops;
    private int[] stoppedIndex = new int[4];
    private @Nullable GeometryObject[] stopped = new GeometryObject[4];
    private @Nullable GeometryObject[] stopper = new GeometryObject[4];
    private @Nullable Cause[] causes = new Cause[4];

    public ContactLog(ObjectTable objects) {
        this.objects = objects;
        Arrays.fill(table, -1);
    }

    /** Begins a step anew, after another one. */
    public void begin(ContactLog after) {
        if (count > 0) {
            Arrays.fill(table, -1);
            Arrays.fill(body, 0, count, null);
            Arrays.fill(other, 0, count, null);
        }
        Arrays.fill(stopped, 0, stops, null);
        Arrays.fill(stopper, 0, stops, null);
        stops = 0;
        count = 0;
        notes = 0;
        before = after;
        time = after.time;
        Arrays.fill(after.goesOn, 0, after.count, false);
    }

    /** Takes back what a step after has noted. */
    public void forgetNext() {
        Arrays.fill(goesOn, 0, count, false);
    }

    public int count() {
        return count;
    }

    /** The name of the body. */
    public String body(int entry) {
        return Objects.requireNonNull(Objects.requireNonNull(body[entry]).name());
    }

    /** The other object as it was added; null for the border of the world. */
    public @Nullable GeometryObject other(int entry) {
        return other[entry];
    }

    /** A coordinate of the point of contact. */
    public double point(int entry, int axis) {
        return point[3 * entry + axis];
    }

    /** A coordinate of the unit normal towards the body. */
    public double normal(int entry, int axis) {
        return normal[3 * entry + axis];
    }

    /** What the body was given along normals, newton seconds. */
    public double impulse(int entry) {
        return impulse[entry];
    }

    /** Whether there was such a contact in the step before. */
    public boolean isOld(int entry) {
        return isOld[entry];
    }

    /** Whether there is such a contact in the step after, as far as that has come. */
    public boolean goesOn(int entry) {
        return goesOn[entry];
    }

    // ---- who was stopped ----

    /**
     * Notes that a body was stopped; the first cause in a step counts.
     *
     * @param index  of the body
     * @param id     of its object
     * @param object the id of what stopped it; below 0 for the border and where that is unknown
     */
    public void stop(int index, int id, int object, Cause cause) {
        int at = Arrays.binarySearch(stoppedIndex, 0, stops, index);
        if (at >= 0) {
            return;
        }
        at = -1 - at;
        if (stops == stopped.length) {
            stoppedIndex = Arrays.copyOf(stoppedIndex, 2 * stops);
            stopped = Arrays.copyOf(stopped, 2 * stops);
            stopper = Arrays.copyOf(stopper, 2 * stops);
            causes = Arrays.copyOf(causes, 2 * stops);
        }
        System.arraycopy(stoppedIndex, at, stoppedIndex, at + 1, stops - at);
        System.arraycopy(stopped, at, stopped, at + 1, stops - at);
        System.arraycopy(stopper, at, stopper, at + 1, stops - at);
        System.arraycopy(causes, at, causes, at + 1, stops - at);
        stoppedIndex[at] = index;
        stopped[at] = objects.value(id);
        stopper[at] = object < 0 ? null : objects.value(object);
        causes[at] = cause;
        stops++;
    }

    /** How many bodies were stopped. */
    public int stops() {
        return stops;
    }

    /** The name of a body that was stopped. */
    public String stopped(int stop) {
        return Objects.requireNonNull(Objects.requireNonNull(stopped[stop]).name());
    }

    /** What stopped it, as it was added; null for the border, and where it is unknown. */
    public @Nullable GeometryObject stopper(int stop) {
        return stopper[stop];
    }

    public Cause cause(int stop) {
        return Objects.requireNonNull(causes[stop]);
    }

    // ---- what touches at one time ----

    /**
     * Notes that a body touches another object or is given an impulse by it now.
     *
     * @param id     of the body's object
     * @param object the id of the other one; -1 for the border
     * @param by     newton seconds along the normal; below 0 for what is near but is no contact
     */
    public void note(int id, int object, double x, double y, double z, double nx, double ny, double nz, double by) {
        if (notes == noteBody.length) {
            noteBody = Arrays.copyOf(noteBody, 2 * notes);
            noteOther = Arrays.copyOf(noteOther, 2 * notes);
            notePoint = Arrays.copyOf(notePoint, 6 * notes);
            noteNormal = Arrays.copyOf(noteNormal, 6 * notes);
            noteImpulse = Arrays.copyOf(noteImpulse, 2 * notes);
        }
        int k = notes++;
        noteBody[k] = id;
        noteOther[k] = object;
        notePoint[3 * k] = x;
        notePoint[3 * k + 1] = y;
        notePoint[3 * k + 2] = z;
        noteNormal[3 * k] = nx;
        noteNormal[3 * k + 1] = ny;
        noteNormal[3 * k + 2] = nz;
        noteImpulse[k] = by;
    }

    /** Tells all that has been noted, which is of one time. */
    public void tell() {
        time++;
        for (int k = 0; k < notes; k++) {
            if (hasFaces(noteBody[k], noteOther[k])) {
                see(k);
            }
        }
        for (int k = 0; k < notes; k++) {
            if (noteImpulse[k] >= 0) {
                add(k);
            }
        }
        notes = 0;
    }

    /**
     * Takes back what was told to act on a body all through a time, as far as it does not: along the normal that is most like
     * the one it was told with.
     *
     * @param by newton seconds, at least 0
     */
    public void takeBack(int id, int object, double[] along, int at, double by) {
        GeometryObject own = objects.value(id);
        double closest = TURNED;
        int found = -1;
        for (int entry = find(key(id, object)); entry >= 0; entry = next[entry]) {
            double same = dot(latest, 3 * entry, along, at);
            same = body[entry] == own ? same : -same;
            if (same > closest) {
                closest = same;
                found = entry;
            }
        }
        if (found >= 0) {
            impulse[found] -= by;
        }
    }

    /** Whether two may touch along several normals at once: two convex objects do not. */
    private boolean hasFaces(int id, int object) {
        return object < 0
                || !objects.value(id).kind().isSized()
                || !objects.value(object).kind().isSized();
    }

    /** Keeps the face of what touches now from being taken for another one that has turned. */
    private void see(int k) {
        int entry = match(this, k, true);
        if (entry >= 0) {
            seen[entry] = time;
        }
        ContactLog last = before;
        int old = last == null ? -1 : last.match(this, k, true);
        if (last != null && old >= 0) {
            last.seen[old] = time;
        }
    }

    private void add(int k) {
        int id = noteBody[k];
        int object = noteOther[k];
        int entry = match(this, k, false);
        if (entry < 0) {
            entry = enter(key(id, object));
            body[entry] = objects.value(id);
            other[entry] = object < 0 ? null : objects.value(object);
            ContactLog last = before;
            int old = last == null ? -1 : last.match(this, k, false);
            if (last != null && old >= 0) {
                last.goesOn[old] = true;
                isOld[entry] = true;
            }
        }
        seen[entry] = time;
        boolean isBody = body[entry] == objects.value(id);
        double by = noteImpulse[k];
        boolean isMost = by > most[entry];
        for (int axis = 0; axis < 3; axis++) {
            double along = noteNormal[3 * k + axis];
            along = isBody ? along : 0.0 - along;
            latest[3 * entry + axis] = along;
            if (isMost) {
                point[3 * entry + axis] = notePoint[3 * k + axis];
                normal[3 * entry + axis] = along;
            }
        }
        impulse[entry] += by;
        most[entry] = Math.max(most[entry], by);
    }

    /**
     * The entry of what a log has noted, or -1: with the same normal, or else the nearest of those that have turned.
     *
     * @param isSame whether only one with the same normal counts
     */
    private int match(ContactLog of, int k, boolean isSame) {
        int id = of.noteBody[k];
        int object = of.noteOther[k];
        GeometryObject own = objects.value(id);
        GeometryObject met = object < 0 ? null : objects.value(object);
        boolean hasFaces = hasFaces(id, object);
        double closest = isSame ? SAME : TURNED;
        int found = -1;
        for (int entry = find(key(id, object)); entry >= 0; entry = next[entry]) {
            boolean isBody = body[entry] == own && other[entry] == met;
            // An id is given again once its object is removed.
            if (goesOn[entry] || !(isBody || (body[entry] == met && other[entry] == own))) {
                continue;
            }
            double along = dot(latest, 3 * entry, of.noteNormal, 3 * k);
            along = isBody ? along : -along;
            if (!hasFaces || along > SAME) {
                return entry;
            }
            if (along > closest && seen[entry] != of.time) {
                closest = along;
                found = entry;
            }
        }
        return found;
    }

    private static double dot(double[] a, int at, double[] b, int from) {
        return a[at] * b[from] + a[at + 1] * b[from + 1] + a[at + 2] * b[from + 2];
    }

    private static long key(int id, int object) {
        return ((long) Math.min(id, object) << 32) | (Math.max(id, object) & 0xffff_ffffL);
    }

    /** Where a key is in the table, or where it belongs. */
    private int slot(long key) {
        int at = (int) ((key * 0x9E37_79B9_7F4A_7C15L) >>> 40) & (table.length - 1);
        while (table[at] >= 0 && keys[table[at]] != key) {
            at = (at + 1) & (table.length - 1);
        }
        return at;
    }

    /** The first entry of a key, or -1. */
    private int find(long key) {
        return table[slot(key)];
    }

    private int enter(long key) {
        if (count == keys.length) {
            grow();
        }
        int entry = count++;
        keys[entry] = key;
        next[entry] = -1;
        impulse[entry] = 0;
        most[entry] = -1;
        isOld[entry] = false;
        goesOn[entry] = false;
        link(entry);
        return entry;
    }

    /** Makes an entry the last one of its key. */
    private void link(int entry) {
        int at = slot(keys[entry]);
        int first = table[at];
        if (first < 0) {
            table[at] = entry;
            return;
        }
        while (next[first] >= 0) {
            first = next[first];
        }
        next[first] = entry;
    }

    private void grow() {
        int room = 2 * count;
        keys = Arrays.copyOf(keys, room);
        next = Arrays.copyOf(next, room);
        body = Arrays.copyOf(body, room);
        other = Arrays.copyOf(other, room);
        point = Arrays.copyOf(point, 3 * room);
        normal = Arrays.copyOf(normal, 3 * room);
        latest = Arrays.copyOf(latest, 3 * room);
        impulse = Arrays.copyOf(impulse, room);
        most = Arrays.copyOf(most, room);
        seen = Arrays.copyOf(seen, room);
        isOld = Arrays.copyOf(isOld, room);
        goesOn = Arrays.copyOf(goesOn, room);
        table = new int[4 * room];
        Arrays.fill(table, -1);
        for (int entry = 0; entry < count; entry++) {
            if (find(keys[entry]) < 0) {
                table[slot(keys[entry])] = entry; // the entries after it are linked to it
            }
        }
    }
}
