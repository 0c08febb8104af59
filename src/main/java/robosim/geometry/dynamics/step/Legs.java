package robosim.geometry.dynamics.step;

import java.util.Arrays;

/** The ways of the bodies through a step: places at times, between each two of which a body goes straight and turns evenly. */
final class Legs {
    private static final int FIRST = 32;

    int count;

    /** Whose each leg is. */
    int[] body = new int[FIRST];

    // Where it ends: the time, the centre, and radians since the step began.
    double[] time = new double[FIRST];
    double[] x = new double[FIRST];
    double[] z = new double[FIRST];
    double[] angle = new double[FIRST];

    /** The leg of the same body that comes next, or -1. */
    int[] next = new int[FIRST];

    // By body: its first leg, or -1, and its last one, and where it stood when the step began.
    int[] first = new int[FIRST];
    int[] last = new int[FIRST];
    double[] fromX = new double[FIRST];
    double[] fromZ = new double[FIRST];

    /** Begins with all bodies where they stand. */
    void begin(Bodies bodies) {
        count = 0;
        if (first.length < bodies.count) {
            int room = 2 * bodies.count;
            first = new int[room];
            last = new int[room];
            fromX = new double[room];
            fromZ = new double[room];
        }
        Arrays.fill(first, 0, bodies.count, -1);
        System.arraycopy(bodies.x, 0, fromX, 0, bodies.count);
        System.arraycopy(bodies.z, 0, fromZ, 0, bodies.count);
    }

    /** Adds where a body is at the time it has come to; calls are in the order of times. */
    void add(Bodies bodies, int b) {
        // What stands for now may go later: only the legs of those that never do are left out.
        boolean isStill = first[b] < 0 && bodies.x[b] == fromX[b] && bodies.z[b] == fromZ[b] && bodies.angle[b] == 0;
        if (bodies.time[b] == 0 || (isStill && bodies.isStill(b))) {
            return;
        }
        if (count == body.length) {
            int room = 2 * count;
            body = Arrays.copyOf(body, room);
            time = Arrays.copyOf(time, room);
            x = Arrays.copyOf(x, room);
            z = Arrays.copyOf(z, room);
            angle = Arrays.copyOf(angle, room);
            next = Arrays.copyOf(next, room);
        }
        int leg = count++;
        body[leg] = b;
        time[leg] = bodies.time[b];
        x[leg] = bodies.x[b];
        z[leg] = bodies.z[b];
        angle[leg] = bodies.angle[b];
        next[leg] = -1;
        if (first[b] < 0) {
            first[b] = leg;
        } else {
            next[last[b]] = leg;
        }
        last[b] = leg;
    }
}
