package robosim.geometry.index.quadtree;

import java.util.Arrays;

/**
 * A priority queue (binary heap) of items, smallest key first; equal keys come in the order of their items. Grows,
 * never shrinks.
 */
public final class EntryQueue {
    private double[] keys = new double[64];
    private int[] items = new int[64];
    private int size;

    public void clear() {
        size = 0;
    }

    public boolean isEmpty() {
        return size == 0;
    }

    public double leastKey() {
        return size == 0 ? Double.POSITIVE_INFINITY : keys[0];
    }

    public void push(double key, int item) {
        if (size == keys.length) {
            keys = Arrays.copyOf(keys, 2 * size);
            items = Arrays.copyOf(items, 2 * size);
        }
        int at = size++;
        while (at > 0) {
            int up = (at - 1) >> 1;
            if (!isBefore(key, item, up)) {
                break;
            }
            keys[at] = keys[up];
            items[at] = items[up];
            at = up;
        }
        keys[at] = key;
        items[at] = item;
    }

    /** Removes and returns the item with the smallest key; the queue must not be empty. */
    public int pop() {
        int least = items[0];
        size--;
        double key = keys[size];
        int item = items[size];
        int at = 0;
        while (true) {
            int down = 2 * at + 1;
            if (down >= size) {
                break;
            }
            if (down + 1 < size && isBefore(keys[down + 1], items[down + 1], down)) {
                down++;
            }
            if (isBefore(key, item, down)) {
                break;
            }
            keys[at] = keys[down];
            items[at] = items[down];
            at = down;
        }
        keys[at] = key;
        items[at] = item;
        return least;
    }

    private boolean isBefore(double key, int item, int at) {
        return key < keys[at] || (key == keys[at] && item < items[at]);
    }
}
