package robosim.geometry.dynamics.planar;

import java.util.Arrays;

/**
 * The pairs of pieces that may meet in a step, the time at which each will next, and a queue of these times. The first piece
 * of a pair is that of a body. Each body has a list of its pairs.
 */
final class CollisionQueue {
    private static final int FIRST = 32;

    int count;
    int[] a = new int[FIRST];
    int[] b = new int[FIRST];

    /** Whether the two touched when last asked. */
    boolean[] touches = new boolean[FIRST];

    /** The time at which the velocities of the two were last made such that they do not approach; -1 for not yet. */
    double[] solved = new double[FIRST];

    /** When the two last met themselves, not only others whom one of them touches; minus infinity for not yet. */
    double[] met = new double[FIRST];

    /** A number that tells who has looked at a pair. */
    int[] mark = new int[FIRST];

    /** How often the two have met slowly. */
    int[] slowMeetings = new int[FIRST];

    /** Whether the two touch at the end, and then the direction from the second towards the first. */
    boolean[] isNear = new boolean[FIRST];

    double[] nx = new double[FIRST];
    double[] nz = new double[FIRST];

    /** Until when the two are left alone. */
    double[] pause = new double[FIRST];

    /** Which entry of the queue is the one that counts. */
    private int[] version = new int[FIRST];

    /** The first link of each body, or -1; a link is twice a pair, and one more for the list of its second body. */
    int[] heads = new int[FIRST];

    int[] links = new int[2 * FIRST];

    // The queue: a heap of times, then of pairs.
    private double[] times = new double[FIRST];
    private int[] queued = new int[FIRST];
    private int[] queuedVersion = new int[FIRST];
    private int length;

    void clear(int bodies) {
        count = 0;
        length = 0;
        if (heads.length < bodies) {
            heads = new int[2 * bodies];
        }
        Arrays.fill(heads, 0, bodies, -1);
    }

    /** Whether a body has a pair of two pieces. */
    boolean has(int body, int pieceA, int pieceB) {
        for (int link = heads[body]; link >= 0; link = links[link]) {
            int pair = link >> 1;
            if ((a[pair] == pieceA && b[pair] == pieceB) || (a[pair] == pieceB && b[pair] == pieceA)) {
                return true;
            }
        }
        return false;
    }

    int add(int pieceA, int bodyA, int pieceB, int bodyB) {
        if (count == a.length) {
            int room = 2 * count;
            a = Arrays.copyOf(a, room);
            b = Arrays.copyOf(b, room);
            touches = Arrays.copyOf(touches, room);
            solved = Arrays.copyOf(solved, room);
            met = Arrays.copyOf(met, room);
            mark = Arrays.copyOf(mark, room);
            slowMeetings = Arrays.copyOf(slowMeetings, room);
            pause = Arrays.copyOf(pause, room);
            isNear = Arrays.copyOf(isNear, room);
            nx = Arrays.copyOf(nx, room);
            nz = Arrays.copyOf(nz, room);
            version = Arrays.copyOf(version, room);
            links = Arrays.copyOf(links, 2 * room);
        }
        int pair = count++;
        a[pair] = pieceA;
        b[pair] = pieceB;
        touches[pair] = false;
        solved[pair] = -1;
        met[pair] = Double.NEGATIVE_INFINITY;
        mark[pair] = 0;
        slowMeetings[pair] = 0;
        pause[pair] = 0;
        isNear[pair] = false;
        version[pair] = 0;
        links[2 * pair] = heads[bodyA];
        heads[bodyA] = 2 * pair;
        if (bodyB >= 0) {
            links[2 * pair + 1] = heads[bodyB];
            heads[bodyB] = 2 * pair + 1;
        }
        return pair;
    }

    /** Sets when a pair will meet next; what was set before counts no more. */
    void expect(int pair, double time) {
        version[pair]++;
        if (time == PlanarTimeOfImpact.NEVER) {
            return;
        }
        if (length == times.length) {
            times = Arrays.copyOf(times, 2 * length);
            queued = Arrays.copyOf(queued, 2 * length);
            queuedVersion = Arrays.copyOf(queuedVersion, 2 * length);
        }
        int at = length++;
        while (at > 0) {
            int parent = (at - 1) >> 1;
            if (!isBefore(time, pair, times[parent], queued[parent])) {
                break;
            }
            copy(parent, at);
            at = parent;
        }
        set(at, time, pair, version[pair]);
    }

    private static boolean isBefore(double time, int pair, double otherTime, int otherPair) {
        return time < otherTime || (time == otherTime && pair < otherPair);
    }

    private void copy(int from, int to) {
        set(to, times[from], queued[from], queuedVersion[from]);
    }

    private void set(int at, double time, int pair, int itsVersion) {
        times[at] = time;
        queued[at] = pair;
        queuedVersion[at] = itsVersion;
    }

    /** The time of what comes next; never if nothing does. */
    double nextTime() {
        while (length > 0 && queuedVersion[0] != version[queued[0]]) {
            drop();
        }
        return length == 0 ? PlanarTimeOfImpact.NEVER : times[0];
    }

    /** Takes the pair that meets next, after {@link #nextTime}. */
    int take() {
        int pair = queued[0];
        drop();
        return pair;
    }

    private void drop() {
        length--;
        double time = times[length];
        int pair = queued[length];
        int itsVersion = queuedVersion[length];
        int at = 0;
        while (2 * at + 1 < length) {
            int child = 2 * at + 1;
            if (child + 1 < length && isBefore(times[child + 1], queued[child + 1], times[child], queued[child])) {
                child++;
            }
            if (!isBefore(times[child], queued[child], time, pair)) {
                break;
            }
            copy(child, at);
            at = child;
        }
        set(at, time, pair, itsVersion);
    }
}
