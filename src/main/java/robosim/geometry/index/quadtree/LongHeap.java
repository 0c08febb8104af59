package robosim.geometry.index.quadtree;

import java.util.Arrays;

/**
 * A priority queue (binary heap) of longs, smallest first: of links in their lower halves, by keys above them. Grows, never
 * shrinks.
 */
public final class LongHeap {
    private long[] heap = new long[64];
    private int size;

    public void clear() {
        size = 0;
    }

    public boolean isEmpty() {
        return size == 0;
    }

    /** The smallest entry; the queue must not be empty. */
    public long least() {
        return heap[0];
    }

    /** Adds an entry of a key and a link. */
    public void push(long entry) {
        if (size == heap.length) {
            heap = Arrays.copyOf(heap, 2 * size);
        }
        long[] h = heap;
        int at = size++;
        while (at > 0) {
            int up = (at - 1) >> 1;
            if (h[up] <= entry) {
                break;
            }
            h[at] = h[up];
            at = up;
        }
        h[at] = entry;
    }

    /** Removes and returns the smallest entry; the queue must not be empty. */
    public long pop() {
        long[] h = heap;
        long least = h[0];
        int last = --size;
        long entry = h[last];
        int at = 0;
        for (int down = 1; down < last; down = 2 * at + 1) {
            if (down + 1 < last && h[down + 1] < h[down]) {
                down++;
            }
            if (entry <= h[down]) {
                break;
            }
            h[at] = h[down];
            at = down;
        }
        h[at] = entry;
        return least;
    }
}
