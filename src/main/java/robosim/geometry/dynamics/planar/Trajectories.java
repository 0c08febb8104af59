package robosim.geometry.dynamics.planar;

import java.util.Arrays;

/** The ways of the bodies through a step: places at times, between each two of which a body goes straight and turns evenly. */
final class Trajectories {
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
    double[] fromAngle = new double[FIRST];

    /** Begins with all bodies where they are. */
    void begin(MovingBodies bodies) {
        makeRoom(bodies.count);
        for (int b = 0; b < bodies.count; b++) {
            begin(b, bodies.x[b], bodies.z[b], bodies.angle[b]);
        }
    }

    /** Begins with a body that stands at a place; has to be called for all. */
    void begin(int b, double startX, double startZ, double startAngle) {
        first[b] = -1;
        fromX[b] = startX;
        fromZ[b] = startZ;
        fromAngle[b] = startAngle;
    }

    /** Empties it and makes room for a number of bodies. */
    void makeRoom(int bodies) {
        count = 0;
        if (first.length < bodies) {
            int room = 2 * bodies;
            first = new int[room];
            last = new int[room];
            fromX = new double[room];
            fromZ = new double[room];
            fromAngle = new double[room];
        }
    }

    /** Adds where a body is at the time it has come to; calls are in the order of times. */
    void add(MovingBodies bodies, int b) {
        // What stands for now may go later: only the legs of those that never do are left out.
        boolean isStill = first[b] < 0 && bodies.x[b] == fromX[b] && bodies.z[b] == fromZ[b] && bodies.angle[b] == 0;
        if (bodies.time[b] == 0 || (isStill && bodies.isStill(b))) {
            return;
        }
        add(b, bodies.time[b], bodies.x[b], bodies.z[b], bodies.angle[b]);
    }

    /** Adds a leg of a body. */
    void add(int b, double until, double toX, double toZ, double toAngle) {
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
        time[leg] = until;
        x[leg] = toX;
        z[leg] = toZ;
        angle[leg] = toAngle;
        next[leg] = -1;
        if (first[b] < 0) {
            first[b] = leg;
        } else {
            next[last[b]] = leg;
        }
        last[b] = leg;
    }

    /** Adds one leg to where a body is at a time on other legs, which are not all over before. */
    void addPart(int b, Trajectories of, double until, double end) {
        int leg = of.first[b];
        double from = 0;
        double x0 = of.fromX[b];
        double z0 = of.fromZ[b];
        double angle0 = of.fromAngle[b];
        while (of.time[leg] < until) {
            from = of.time[leg];
            x0 = of.x[leg];
            z0 = of.z[leg];
            angle0 = of.angle[leg];
            leg = of.next[leg];
        }
        if (of.time[leg] == until) {
            add(b, end, of.x[leg], of.z[leg], of.angle[leg]);
            return;
        }
        double share = (until - from) / (of.time[leg] - from);
        add(
                b,
                end,
                x0 + share * (of.x[leg] - x0),
                z0 + share * (of.z[leg] - z0),
                angle0 + share * (of.angle[leg] - angle0));
    }
}
