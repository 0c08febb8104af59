package robosim.geometry.narrow.mesh;

import java.util.Arrays;

/**
 * A priority queue of pairs of places, smallest key first; of equal keys the one added last, so that among boxes that
 * all meet the descent is depth first. Grows, never shrinks.
 */
final class PairQueue {
    private double[] keys = new double[64];
    private long[] firsts = new long[64];
    private long[] seconds = new long[64];
    private int[] tasks = new int[64];
    private long[] turns = new long[64];
    private int size;
    private long turn;

    // The pair removed last.
    long first;
    long second;
    int task;

    void clear() {
        size = 0;
        turn = 0;
    }

    /** The smallest key; +Infinity if the queue is empty. */
    double leastKey() {
        return size == 0 ? Double.POSITIVE_INFINITY : keys[0];
    }

    void push(double key, long a, long b, int todo) {
        if (size == keys.length) {
            keys = Arrays.copyOf(keys, 2 * size);
            firsts = Arrays.copyOf(firsts, 2 * size);
            seconds = Arrays.copyOf(seconds, 2 * size);
            tasks = Arrays.copyOf(tasks, 2 * size);
            turns = Arrays.copyOf(turns, 2 * size);
        }
        int at = size++;
        keys[at] = key;
        firsts[at] = a;
        seconds[at] = b;
        tasks[at] = todo;
        turns[at] = turn++;
        while (at > 0 && isBefore(at, (at - 1) >> 1)) {
            swap(at, (at - 1) >> 1);
            at = (at - 1) >> 1;
        }
    }

    /** Removes the pair with the smallest key; the queue must not be empty. */
    void take() {
        first = firsts[0];
        second = seconds[0];
        task = tasks[0];
        swap(0, --size);
        int at = 0;
        while (true) {
            int down = 2 * at + 1;
            if (down + 1 < size && isBefore(down + 1, down)) {
                down++;
            }
            if (down >= size || !isBefore(down, at)) {
                return;
            }
            swap(at, down);
            at = down;
        }
    }

    private boolean isBefore(int p, int q) {
        return keys[p] < keys[q] || (keys[p] == keys[q] && turns[p] > turns[q]);
    }

    private void swap(int p, int q) {
        double key = keys[p];
        keys[p] = keys[q];
        keys[q] = key;
        long place = firsts[p];
        firsts[p] = firsts[q];
        firsts[q] = place;
        place = seconds[p];
        seconds[p] = seconds[q];
        seconds[q] = place;
        int todo = tasks[p];
        tasks[p] = tasks[q];
        tasks[q] = todo;
        long came = turns[p];
        turns[p] = turns[q];
        turns[q] = came;
    }
}
