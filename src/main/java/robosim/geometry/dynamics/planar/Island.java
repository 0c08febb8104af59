package robosim.geometry.dynamics.planar;

import java.util.Arrays;

/** MovingBodies that touch each other at one time, and the contacts between them and with what stands still. */
final class Island {
    private static final int FIRST = 16;

    /** How many contacts there are. */
    int count;

    /** The bodies of each contact; the second is -1 for what stands still. */
    int[] a = new int[FIRST];

    int[] b = new int[FIRST];
    int[] pair = new int[FIRST];

    /** Unit normal towards the first body, and where the two touch. */
    double[] nx = new double[FIRST];

    double[] nz = new double[FIRST];
    double[] px = new double[FIRST];
    double[] pz = new double[FIRST];

    double[] restitution = new double[FIRST];
    double[] still = new double[FIRST];
    double[] sliding = new double[FIRST];

    /** The least speed of parting that is asked for whatever the restitution. */
    double[] least = new double[FIRST];

    /** The same, but of free bodies no more than the speed at which they approached. */
    double[] rise = new double[FIRST];

    // Torques of unit forces along the normal and along the contact, on a and b.
    double[] leverA = new double[FIRST];
    double[] leverB = new double[FIRST];
    double[] asideA = new double[FIRST];
    double[] asideB = new double[FIRST];

    /** The bodies that take part. */
    int bodyCount;

    int[] bodyList = new int[FIRST];

    /** By body: among how many a body is divided, its contacts and the floor if that holds it. */
    int[] parts = new int[FIRST];

    private final MovingBodies bodies;
    private final FloorFriction floor;

    Island(MovingBodies bodies, FloorFriction floor) {
        this.bodies = bodies;
        this.floor = floor;
    }

    void begin() {
        count = 0;
        bodyCount = 0;
        if (parts.length < bodies.count) {
            parts = new int[2 * bodies.count];
        }
    }

    void addBody(int body) {
        if (bodyCount == bodyList.length) {
            bodyList = Arrays.copyOf(bodyList, 2 * bodyCount);
        }
        bodyList[bodyCount++] = body;
        parts[body] = floor.holds(body) ? 1 : 0;
    }

    /** Adds a contact of two bodies that take part; the second is -1 for what stands still. */
    int add(int ofPair, int bodyA, int bodyB, double x, double z, double normalX, double normalZ) {
        if (count == a.length) {
            grow();
        }
        int c = count++;
        pair[c] = ofPair;
        a[c] = bodyA;
        b[c] = bodyB;
        px[c] = x;
        pz[c] = z;
        nx[c] = normalX;
        nz[c] = normalZ;
        leverA[c] = lever(bodyA, x, z, normalX, normalZ);
        leverB[c] = lever(bodyB, x, z, normalX, normalZ);
        asideA[c] = lever(bodyA, x, z, -normalZ, normalX);
        asideB[c] = lever(bodyB, x, z, -normalZ, normalX);
        parts[bodyA]++;
        if (bodyB >= 0) {
            parts[bodyB]++;
        }
        return c;
    }

    private void grow() {
        int room = 2 * count;
        pair = Arrays.copyOf(pair, room);
        a = Arrays.copyOf(a, room);
        b = Arrays.copyOf(b, room);
        px = Arrays.copyOf(px, room);
        pz = Arrays.copyOf(pz, room);
        nx = Arrays.copyOf(nx, room);
        nz = Arrays.copyOf(nz, room);
        restitution = Arrays.copyOf(restitution, room);
        still = Arrays.copyOf(still, room);
        sliding = Arrays.copyOf(sliding, room);
        least = Arrays.copyOf(least, room);
        rise = Arrays.copyOf(rise, room);
        leverA = Arrays.copyOf(leverA, room);
        leverB = Arrays.copyOf(leverB, room);
        asideA = Arrays.copyOf(asideA, room);
        asideB = Arrays.copyOf(asideB, room);
    }

    private double lever(int body, double x, double z, double dx, double dz) {
        return body < 0 ? 0 : (z - bodies.z[body]) * dx - (x - bodies.x[body]) * dz;
    }

    /** The speed at which the two of a contact part along its normal. */
    double parting(int c) {
        return speed(a[c], nx[c], nz[c], leverA[c]) - speed(b[c], nx[c], nz[c], leverB[c]);
    }

    /** The speed of the first of a contact as seen from the other, along the contact. */
    double aside(int c) {
        return speed(a[c], -nz[c], nx[c], asideA[c]) - speed(b[c], -nz[c], nx[c], asideB[c]);
    }

    /** Whether a drive pushes one of the two of a contact. */
    boolean isDriven(int c) {
        return bodies.isDriven[a[c]] || (b[c] >= 0 && bodies.isDriven[b[c]]);
    }

    /** By how much an impulse along the normal of a contact changes the speed there; 0 where nothing moves either of the two. */
    double softness(int c) {
        double second = b[c] < 0 ? 0 : bodies.lightness[b[c]] + bodies.ease[b[c]] * leverB[c] * leverB[c];
        return bodies.lightness[a[c]] + bodies.ease[a[c]] * leverA[c] * leverA[c] + second;
    }

    private double speed(int body, double dx, double dz, double lever) {
        return body < 0 ? 0 : (bodies.vx[body] * dx + bodies.vz[body] * dz) + bodies.w[body] * lever;
    }
}
