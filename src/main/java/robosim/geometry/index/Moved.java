package robosim.geometry.index;

import java.util.Arrays;

/** The objects that have moved, each with its box before its first move, six numbers. */
final class Moved {
    private int[] ids = new int[4];
    private double[] boxes = new double[6 * ids.length];
    private int count;

    /** One bit per id, set for the objects recorded here. */
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

    /** Records an object that is about to move, with its box, unless it is recorded already. */
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
