package robosim.geometry.index;

import java.util.Arrays;

/** Objects that have moved, and their boxes before that, six numbers each: the first box, however often they move. */
final class Moved {
    private int[] ids = new int[4];
    private double[] boxes = new double[6 * ids.length];
    private int count;

    /** A bit for each id, set for those that are here. */
    private long[] present = new long[1];

    boolean isEmpty() {
        return count == 0;
    }

    int count() {
        return count;
    }

    int id(int k) {
        return ids[k];
    }

    /** Copies the k-th object's box. */
    void before(int k, double[] box) {
        System.arraycopy(boxes, 6 * k, box, 0, 6);
    }

    /** Takes note of an object that is about to move from its box, if it is not here yet. */
    void note(int id, double[] from) {
        int word = id >> 6;
        if (word >= present.length) {
            present = Arrays.copyOf(present, word + (word >> 1) + 1);
        }
        if ((present[word] >> id & 1) != 0) {
            return;
        }
        present[word] |= 1L << id;
        if (count == ids.length) {
            ids = Arrays.copyOf(ids, 2 * count);
            boxes = Arrays.copyOf(boxes, 12 * count);
        }
        System.arraycopy(from, 6 * id, boxes, 6 * count, 6);
        ids[count++] = id;
    }

    void clear() {
        for (int k = 0; k < count; k++) {
            present[ids[k] >> 6] = 0;
        }
        count = 0;
    }
}
