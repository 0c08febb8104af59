package robosim.geometry.dynamics.step;

import java.util.Arrays;

/**
 * The impulses at all contacts of bodies that touch at one time: Newton's restitution, Coulomb's friction, each contact pushing
 * and never pulling. A fixed-point iteration in which all contacts answer the same velocities, each as if a body were divided
 * among its contacts (mass splitting: Tonge, Benevolenski and Voroshilov 2012), carried on by Nesterov's method with restarts
 * (Mazhar, Heyn, Negrut and Tasora 2015); so no order of contacts matters and what is symmetric stays so; sums are carried with their rounding errors for the same reason. If it has not come to rest after a
 * bounded number of rounds, sweeps in order (Guendelman, Bridson and Fedkiw 2003) do the rest.
 *
 * <p>Newton's restitution with friction may add energy (Kane and Levinson 1985). Where it would, the contacts are solved
 * without restitution, and then without friction, which never does.
 */
final class ContactSolver {
    /** Slower approaches do not bounce, m/s. */
    static final double SLOW = 1e-3;

    private static final int ROUNDS = 128;
    private static final int ROUNDS_EACH = 24;
    private static final int MOST_ROUNDS = 1024;
    private static final int SWEEPS = 48;

    /** More contacts pause in each round. */
    private static final int PART = 64;

    /** Velocities that change by less, as a share of the greatest, have come to rest. */
    private static final double RESTS = 0x1p-50;

    private static final int FIRST = 16;

    int count;
    int[] a = new int[FIRST];
    int[] b = new int[FIRST];
    int[] pair = new int[FIRST];
    double[] nx = new double[FIRST];
    double[] nz = new double[FIRST];
    double[] px = new double[FIRST];
    double[] pz = new double[FIRST];
    double[] restitution = new double[FIRST];
    double[] still = new double[FIRST];
    double[] sliding = new double[FIRST];

    /** The least speed of parting that is asked for whatever the restitution. */
    double[] least = new double[FIRST];

    /** The impulse along the normal, newton seconds. */
    double[] push = new double[FIRST];

    private double[] rub = new double[FIRST];
    private double[] goal = new double[FIRST];

    // The impulses after the round before.
    private double[] lastPush = new double[FIRST];
    private double[] lastRub = new double[FIRST];

    /** By how much impulses are carried on in the direction of their last change, and whether that goes the wrong way. */
    private double momentum;

    private double uphill;

    // Torques of unit forces along the normal and along the contact, on a and b.
    private double[] leverA = new double[FIRST];
    private double[] leverB = new double[FIRST];
    private double[] asideA = new double[FIRST];
    private double[] asideB = new double[FIRST];

    private final Bodies bodies;
    private final Floor floor;

    /** The bodies that take part. */
    int bodyCount;

    int[] bodyList = new int[FIRST];

    // By body: the number of its contacts, the velocity before all and before this solution, and what is added to it,
    // with
    // rounding errors.
    private int[] contacts = new int[FIRST];
    private double[] first = new double[3 * FIRST];
    private double[] before = new double[3 * FIRST];
    private double[] sums = new double[3 * FIRST];
    private double[] rests = new double[3 * FIRST];

    ContactSolver(Bodies bodies, Floor floor) {
        this.bodies = bodies;
        this.floor = floor;
    }

    void begin() {
        count = 0;
        bodyCount = 0;
        if (contacts.length < bodies.count) {
            int room = 2 * bodies.count;
            contacts = new int[room];
            first = new double[3 * room];
            before = new double[3 * room];
            sums = new double[3 * room];
            rests = new double[3 * room];
        }
    }

    void addBody(int body) {
        if (bodyCount == bodyList.length) {
            bodyList = Arrays.copyOf(bodyList, 2 * bodyCount);
        }
        bodyList[bodyCount++] = body;
        contacts[body] = floor.holds(body) ? 1 : 0;
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
        contacts[bodyA]++;
        if (bodyB >= 0) {
            contacts[bodyB]++;
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
        push = Arrays.copyOf(push, room);
        rub = Arrays.copyOf(rub, room);
        goal = Arrays.copyOf(goal, room);
        lastPush = Arrays.copyOf(lastPush, room);
        lastRub = Arrays.copyOf(lastRub, room);
        leverA = Arrays.copyOf(leverA, room);
        leverB = Arrays.copyOf(leverB, room);
        asideA = Arrays.copyOf(asideA, room);
        asideB = Arrays.copyOf(asideB, room);
    }

    private double lever(int body, double x, double z, double dx, double dz) {
        return body < 0 ? 0 : (z - bodies.z[body]) * dx - (x - bodies.x[body]) * dz;
    }

    /** The speed at which the two part along the normal. */
    double parting(int c) {
        return speed(a[c], nx[c], nz[c], leverA[c]) - speed(b[c], nx[c], nz[c], leverB[c]);
    }

    private double speed(int body, double dx, double dz, double lever) {
        return body < 0 ? 0 : (bodies.vx[body] * dx + bodies.vz[body] * dz) + bodies.w[body] * lever;
    }

    /** Whether the velocity of a body has been changed since {@link #solve}. */
    boolean isChanged(int body) {
        return bodies.vx[body] != first[3 * body]
                || bodies.vz[body] != first[3 * body + 1]
                || bodies.w[body] != first[3 * body + 2];
    }

    /** Solves all contacts; false where even without restitution and friction energy would grow, and nothing has changed. */
    boolean solve() {
        for (int k = 0; k < bodyCount; k++) {
            keep(bodyList[k], first);
        }
        return solve(0);
    }

    /** Solves all contacts again for other velocities, without restitution. */
    boolean solveAgain() {
        return solve(1);
    }

    private void keep(int body, double[] velocities) {
        velocities[3 * body] = bodies.vx[body];
        velocities[3 * body + 1] = bodies.vz[body];
        velocities[3 * body + 2] = bodies.w[body];
    }

    private boolean solve(int firstAttempt) {
        double energy = 0;
        for (int k = 0; k < bodyCount; k++) {
            int body = bodyList[k];
            energy += bodies.energy(body);
            keep(body, before);
        }
        double most = energy * (1 + 0x1p-42);
        for (int attempt = firstAttempt; attempt < 3; attempt++) {
            boolean isRubbing = attempt < 2;
            prepare(attempt == 0);
            iterate(isRubbing);
            double after = 0;
            for (int k = 0; k < bodyCount; k++) {
                after += bodies.energy(bodyList[k]);
            }
            if (after <= most) {
                for (int k = 0; k < bodyCount; k++) {
                    floor.take(bodyList[k]);
                }
                return true;
            }
            for (int k = 0; k < bodyCount; k++) {
                int body = bodyList[k];
                bodies.vx[body] = before[3 * body];
                bodies.vz[body] = before[3 * body + 1];
                bodies.w[body] = before[3 * body + 2];
            }
        }
        return false;
    }

    private void prepare(boolean isBouncing) {
        for (int k = 0; k < bodyCount; k++) {
            floor.begin(bodyList[k]);
        }
        for (int c = 0; c < count; c++) {
            double parting = parting(c);
            double bounce = isBouncing && parting < -SLOW ? -restitution[c] * parting : 0;
            goal[c] = isBouncing ? Math.max(bounce, least[c]) : 0;
            push[c] = 0;
            rub[c] = 0;
            lastPush[c] = 0;
            lastRub[c] = 0;
        }
    }

    private void iterate(boolean isRubbing) {
        double scale = 0;
        for (int k = 0; k < bodyCount; k++) {
            int body = bodyList[k];
            scale = Math.max(
                    scale,
                    Math.abs(bodies.vx[body])
                            + Math.abs(bodies.vz[body])
                            + Math.abs(bodies.w[body]) * bodies.size[body]);
        }
        double rest = RESTS * scale;
        if (count == 1) {
            guess(isRubbing);
        }
        int rounds = Math.min(MOST_ROUNDS, ROUNDS + ROUNDS_EACH * count);
        double theta = 1;
        momentum = 0;
        for (int round = 0; round < rounds; round++) {
            breathe();
            for (int k = 0; k < bodyCount; k++) {
                int at = 3 * bodyList[k];
                Arrays.fill(sums, at, at + 3, 0);
                Arrays.fill(rests, at, at + 3, 0);
            }
            uphill = 0;
            double change = 0;
            for (int c = 0; c < count; c++) {
                change = Math.max(change, answer(c, isRubbing, true));
            }
            for (int k = 0; k < bodyCount; k++) {
                int body = bodyList[k];
                if (floor.holds(body)) {
                    change = Math.max(change, floor.answer(body, contacts[body], momentum));
                    Bodies.add(sums, rests, 3 * body, floor.changeX);
                    Bodies.add(sums, rests, 3 * body + 1, floor.changeZ);
                    Bodies.add(sums, rests, 3 * body + 2, floor.changeTurn);
                }
                bodies.vx[body] += sums[3 * body] + rests[3 * body];
                bodies.vz[body] += sums[3 * body + 1] + rests[3 * body + 1];
                bodies.w[body] += sums[3 * body + 2] + rests[3 * body + 2];
            }
            if (change <= rest) {
                return;
            }
            double nextTheta = uphill > 0 || count == 1 ? 1 : 0.5 * (1 + Math.sqrt(1 + 4 * theta * theta));
            momentum = uphill > 0 || count == 1 ? 0 : (theta - 1) / nextTheta;
            theta = nextTheta;
        }
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            breathe();
            double change = 0;
            for (int c = 0; c < count; c++) {
                change = Math.max(change, answer(c, isRubbing, false));
            }
            for (int k = 0; k < bodyCount; k++) {
                int body = bodyList[k];
                if (floor.holds(body)) {
                    change = Math.max(change, floor.answer(body, 1, 0));
                    bodies.vx[body] += floor.changeX;
                    bodies.vz[body] += floor.changeZ;
                    bodies.w[body] += floor.changeTurn;
                }
            }
            if (change <= rest) {
                return;
            }
        }
    }

    private void breathe() {
        if (count > PART) {
            bodies.breath.run();
        }
    }

    /** Begins with what is the answer of a single contact mostly: it sticks, or slides the way that it would have to be held. */
    private void guess(boolean isRubbing) {
        int one = a[0];
        int second = b[0];
        double light = bodies.lightness[one] + (second < 0 ? 0 : bodies.lightness[second]);
        double easeA = bodies.ease[one];
        double easeB = second < 0 ? 0 : bodies.ease[second];
        double soft = light + (easeA * leverA[0] * leverA[0] + easeB * leverB[0] * leverB[0]);
        double closing = goal[0] - parting(0);
        if (!(soft > 0 && closing > 0)) {
            return;
        }
        double pushed = closing / soft;
        double rubbed = 0;
        if (isRubbing && still[0] > 0) {
            double coupled = easeA * leverA[0] * asideA[0] + easeB * leverB[0] * asideB[0];
            double softAside = light + (easeA * asideA[0] * asideA[0] + easeB * asideB[0] * asideB[0]);
            double aside = speed(one, -nz[0], nx[0], asideA[0]) - speed(second, -nz[0], nx[0], asideB[0]);
            double both = soft * softAside - coupled * coupled;
            pushed = (closing * softAside + aside * coupled) / both;
            rubbed = -(aside * soft + closing * coupled) / both;
            if (!(pushed > 0 && Math.abs(rubbed) <= still[0] * pushed)) {
                double drag = Math.copySign(sliding[0], rubbed);
                pushed = closing / (soft + drag * coupled);
                rubbed = drag * pushed;
            }
            if (!(pushed > 0 && pushed < Double.POSITIVE_INFINITY)) {
                return;
            }
        }
        push[0] = pushed;
        rub[0] = rubbed;
        lastPush[0] = pushed;
        lastRub[0] = rubbed;
        give(0, pushed, rubbed, false);
    }

    /** Changes the impulse of a contact as the velocities ask; answers by how much the speeds there change. */
    private double answer(int c, boolean isRubbing, boolean isSplit) {
        int one = a[c];
        int second = b[c];
        double partsA = isSplit ? contacts[one] : 1;
        double partsB = second < 0 ? 0 : isSplit ? contacts[second] : 1;
        double lightA = partsA * bodies.lightness[one];
        double easeA = partsA * bodies.ease[one];
        double lightB = second < 0 ? 0 : partsB * bodies.lightness[second];
        double easeB = second < 0 ? 0 : partsB * bodies.ease[second];
        double light = lightA + lightB;
        double soft = light + (easeA * leverA[c] * leverA[c] + easeB * leverB[c] * leverB[c]);
        if (soft == 0) {
            return 0;
        }
        double pushed = Math.max(0, push[c] + (goal[c] - parting(c)) / soft);
        double by = pushed - push[c];
        double rubBy = 0;
        double softAside = 0;
        if (isRubbing && still[c] > 0) {
            double coupled = easeA * leverA[c] * asideA[c] + easeB * leverB[c] * asideB[c];
            softAside = light + (easeA * asideA[c] * asideA[c] + easeB * asideB[c] * asideB[c]);
            double aside = speed(one, -nz[c], nx[c], asideA[c]) - speed(second, -nz[c], nx[c], asideB[c]);
            double rubbed = rub[c] - (aside + by * coupled) / softAside;
            if (Math.abs(rubbed) > still[c] * pushed) {
                rubbed = Math.copySign(sliding[c] * pushed, rubbed);
            }
            rubBy = rubbed - rub[c];
        }
        double change = Math.max(Math.abs(by) * soft, Math.abs(rubBy) * softAside);
        if (isSplit) {
            double pushedBefore = lastPush[c];
            double rubbedBefore = lastRub[c];
            lastPush[c] = push[c] + by;
            lastRub[c] = rub[c] + rubBy;
            uphill -= by * soft * (lastPush[c] - pushedBefore) + rubBy * softAside * (lastRub[c] - rubbedBefore);
            by += momentum * (lastPush[c] - pushedBefore);
            rubBy += momentum * (lastRub[c] - rubbedBefore);
        }
        push[c] += by;
        rub[c] += rubBy;
        give(c, by, rubBy, isSplit);
        return change;
    }

    private void give(int c, double along, double aside, boolean isSplit) {
        double jx = along * nx[c] - aside * nz[c];
        double jz = along * nz[c] + aside * nx[c];
        give(a[c], jx, jz, along * leverA[c] + aside * asideA[c], isSplit);
        if (b[c] >= 0) {
            give(b[c], -jx, -jz, -(along * leverB[c] + aside * asideB[c]), isSplit);
        }
    }

    private void give(int body, double jx, double jz, double torque, boolean isSplit) {
        double light = bodies.lightness[body];
        double turn = torque * bodies.ease[body];
        if (isSplit) {
            Bodies.add(sums, rests, 3 * body, jx * light);
            Bodies.add(sums, rests, 3 * body + 1, jz * light);
            Bodies.add(sums, rests, 3 * body + 2, turn);
        } else {
            bodies.vx[body] += jx * light;
            bodies.vz[body] += jz * light;
            bodies.w[body] += turn;
        }
    }
}
