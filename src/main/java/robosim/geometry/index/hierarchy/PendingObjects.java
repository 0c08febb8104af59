package robosim.geometry.index.hierarchy;

import java.util.Arrays;
import robosim.geometry.index.ArrayGrowth;

/** Objects that have been added to a {@link Hierarchy} but do not hang in it yet, each with its box. */
final class PendingObjects {
    private static final int PART = Hierarchy.PART;

    private int[] ids = new int[0];
    private float[] boxes = new float[0];
    private int size;

    int size() {
        return size;
    }

    int id(int place) {
        return ids[place];
    }

    void copyBox(int place, float[] to, int at) {
        System.arraycopy(boxes, PART * place, to, at, PART);
    }

    void add(int id, float[] box) {
        if (size == ids.length) {
            ids = Arrays.copyOf(ids, ArrayGrowth.of(size));
            boxes = Arrays.copyOf(boxes, PART * ids.length);
        }
        ids[size] = id;
        System.arraycopy(box, 0, boxes, PART * size, PART);
        size++;
    }

    /** Removes the object that was added last; writes its box. */
    int takeLast(float[] box) {
        size--;
        copyBox(size, box, 0);
        return ids[size];
    }

    /** Forgets all objects and gives up the memory. */
    void forget() {
        size = 0;
        ids = new int[0];
        boxes = new float[0];
    }
}
