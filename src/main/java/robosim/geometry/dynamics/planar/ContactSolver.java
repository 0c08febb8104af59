package robosim.geometry.dynamics.planar;

import java.util.Arrays;

/**
 * The impulses at all contacts of bodies that touch at one time: Newton's restitution, Coulomb's friction, each contact pushing
 * and never pulling. A fixed-point iteration in which all contacts answer the same velocities, each as if a body were divided
 * among its contacts (mass splitting: Tonge, Benevolenski and Voroshilov 2012), carried on by Nesterov's method with restarts
 * (Mazhar, Heyn, Negrut and Tasora 2015); so no order of contacts matters and what is symmetric stays so; sums are carried with
 * their rounding errors for the same reason. If it has not come to rest after a bounded number of rounds, sweeps in order
 * (Guendelman, Bridson and Fedkiw 2003) do the rest; a single contact begins with these, which come to rest sooner.
 *
 * <p>A contact that slides rubs less than one that sticks, so it might go from the one to the other for ever. After a number of
 * rounds one that slides goes on to slide.
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

    /** From this round on what slides goes on to slide. */
    private static final int DECIDED = 32;

    /** More contacts pause in each round. */
    private static final int PART = 64;

    /** Velocities that change by less, as a share of the greatest, have come to rest. */
    private static final double RESTS = 0x1p-50;

    private static final int FIRST = 16;

    /** The impulse of each contact along the normal, newton seconds. */
    double[] push = new double[FIRST];

    /** The impulse of each contact along it, newton seconds. */
    double[] rub = new double[FIRST];

    private double[] goal = new double[FIRST];
    private boolean[] isSliding = new boolean[FIRST];

    // The impulses after the round before.
    private double[] lastPush = new double[FIRST];
    private double[] lastRub = new double[FIRST];

    // By how much the speeds along the normal and along the contact change with an impulse along the same, and with one
    // along the other.
    private double[] soft = new double[FIRST];
    private double[] softAside = new double[FIRST];
    private double[] coupled = new double[FIRST];

    /** By how much impulses are carried on in the direction of their last change, and whether that goes the wrong way. */
    private double momentum;

    private double uphill;

    private final MovingBodies bodies;
    private final FloorFriction floor;
    private final Island island;

    // By body: the velocity before all and before this solution, and what is added to it, with rounding errors.
    private double[] first = new double[3 * FIRST];
    private double[] before = new double[3 * FIRST];
    private double[] sums = new double[3 * FIRST];
    private double[] rests = new double[3 * FIRST];

    ContactSolver(MovingBodies bodies, FloorFriction floor, Island island) {
        this.bodies = bodies;
        this.floor = floor;
        this.island = island;
    }

    /** Whether the velocity of a body has been changed since {@link #solve}. */
    boolean isChanged(int body) {
        return bodies.vx[body] != first[3 * body]
                || bodies.vz[body] != first[3 * body + 1]
                || bodies.w[body] != first[3 * body + 2];
    }

    /** Solves all contacts; false where even without restitution and friction energy would grow, and nothing has changed. */
    boolean solve(boolean isBouncing) {
        makeRoom();
        for (int k = 0; k < island.bodyCount; k++) {
            keep(island.bodyList[k], first);
        }
        return solve(isBouncing ? 0 : 1);
    }

    /** Solves all contacts again for other velocities, without restitution. */
    boolean solveAgain() {
        return solve(1);
    }

    private void makeRoom() {
        if (first.length < 3 * bodies.count) {
            int room = 6 * bodies.count;
            first = new double[room];
            before = new double[room];
            sums = new double[room];
            rests = new double[room];
        }
        if (push.length < island.count) {
            int room = 2 * island.count;
            push = new double[room];
            rub = new double[room];
            goal = new double[room];
            isSliding = new boolean[room];
            lastPush = new double[room];
            lastRub = new double[room];
            soft = new double[room];
            softAside = new double[room];
            coupled = new double[room];
        }
    }

    private void keep(int body, double[] velocities) {
        velocities[3 * body] = bodies.vx[body];
        velocities[3 * body + 1] = bodies.vz[body];
        velocities[3 * body + 2] = bodies.w[body];
    }

    private boolean solve(int firstAttempt) {
        double energy = 0;
        for (int k = 0; k < island.bodyCount; k++) {
            int body = island.bodyList[k];
            energy += bodies.energy(body);
            keep(body, before);
        }
        double most = energy * (1 + 0x1p-42);
        for (int attempt = firstAttempt; attempt < 3; attempt++) {
            boolean isRubbing = attempt < 2;
            double given = prepare(attempt == 0);
            iterate(isRubbing);
            double after = 0;
            for (int k = 0; k < island.bodyCount; k++) {
                after += bodies.energy(island.bodyList[k]);
            }
            if (after <= most + given) {
                for (int k = 0; k < island.bodyCount; k++) {
                    floor.take(island.bodyList[k]);
                }
                return true;
            }
            for (int k = 0; k < island.bodyCount; k++) {
                int body = island.bodyList[k];
                bodies.vx[body] = before[3 * body];
                bodies.vz[body] = before[3 * body + 1];
                bodies.w[body] = before[3 * body + 2];
            }
        }
        Arrays.fill(push, 0, island.count, 0);
        Arrays.fill(rub, 0, island.count, 0);
        return false;
    }

    /** Sets the speeds of parting that contacts are to reach; answers the energy that drives give for it, joules at most. */
    private double prepare(boolean isBouncing) {
        double given = 0;
        for (int k = 0; k < island.bodyCount; k++) {
            floor.begin(island.bodyList[k]);
        }
        for (int c = 0; c < island.count; c++) {
            double parting = island.parting(c);
            double bounce = isBouncing && parting < -SLOW ? -island.restitution[c] * parting : 0;
            double rise = isBouncing ? island.rise[c] : 0;
            if (rise > -parting && !island.isDriven(c)) {
                rise = -parting; // free bodies have no energy to part faster than they approached
            } else if (rise > 0 && island.softness(c) > 0) {
                given += 0.5 * rise * rise / island.softness(c);
            }
            goal[c] = isBouncing ? Math.max(Math.max(bounce, rise), island.least[c]) : 0;
            push[c] = 0;
            rub[c] = 0;
            lastPush[c] = 0;
            lastRub[c] = 0;
            isSliding[c] = false;
        }
        return given;
    }

    /** Works out how the speeds at each contact change with impulses there; of bodies that are divided or not. */
    private void soften(boolean isSplit) {
        for (int c = 0; c < island.count; c++) {
            int one = island.a[c];
            int second = island.b[c];
            double partsA = isSplit ? island.parts[one] : 1;
            double partsB = second < 0 ? 0 : isSplit ? island.parts[second] : 1;
            double easeA = partsA * bodies.ease[one];
            double easeB = second < 0 ? 0 : partsB * bodies.ease[second];
            double light = partsA * bodies.lightness[one] + (second < 0 ? 0 : partsB * bodies.lightness[second]);
            double leverA = island.leverA[c];
            double leverB = island.leverB[c];
            double asideA = island.asideA[c];
            double asideB = island.asideB[c];
            soft[c] = light + (easeA * leverA * leverA + easeB * leverB * leverB);
            softAside[c] = light + (easeA * asideA * asideA + easeB * asideB * asideB);
            coupled[c] = easeA * leverA * asideA + easeB * leverB * asideB;
        }
    }

    private void iterate(boolean isRubbing) {
        double scale = 0;
        for (int k = 0; k < island.bodyCount; k++) {
            int body = island.bodyList[k];
            scale = Math.max(
                    scale,
                    Math.abs(bodies.vx[body])
                            + Math.abs(bodies.vz[body])
                            + Math.abs(bodies.w[body]) * bodies.size[body]);
        }
        double rest = RESTS * scale;
        int count = island.count;
        if (count == 1) {
            soften(false);
            guess(isRubbing);
            if (sweep(isRubbing, rest)) { // one contact and the floor: no order to keep out of the result
                return;
            }
        }
        soften(true);
        int rounds = Math.min(MOST_ROUNDS, ROUNDS + ROUNDS_EACH * count);
        double theta = 1;
        momentum = 0;
        for (int round = 0; round < rounds; round++) {
            if (round(isRubbing, round >= DECIDED) <= rest) {
                return;
            }
            double nextTheta = uphill > 0 || count == 1 ? 1 : 0.5 * (1 + Math.sqrt(1 + 4 * theta * theta));
            momentum = uphill > 0 || count == 1 ? 0 : (theta - 1) / nextTheta;
            theta = nextTheta;
        }
        soften(false);
        sweep(isRubbing, rest);
    }

    /** Sweeps until all has come to rest; false if that takes too long. */
    private boolean sweep(boolean isRubbing, double rest) {
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            if (sweepOnce(isRubbing, island.count > 1 || sweep >= DECIDED) <= rest) {
                return true;
            }
        }
        return false;
    }

    /** Lets all contacts answer the same velocities; tells by how much speeds change at most. */
    private double round(boolean isRubbing, boolean isDecided) {
        breathe();
        for (int k = 0; k < island.bodyCount; k++) {
            int at = 3 * island.bodyList[k];
            Arrays.fill(sums, at, at + 3, 0);
            Arrays.fill(rests, at, at + 3, 0);
        }
        uphill = 0;
        double change = 0;
        for (int c = 0; c < island.count; c++) {
            change = Math.max(change, answer(c, isRubbing, isDecided, true));
        }
        for (int k = 0; k < island.bodyCount; k++) {
            int body = island.bodyList[k];
            if (floor.holds(body)) {
                change = Math.max(change, floor.answer(body, island.parts[body], momentum));
                MovingBodies.add(sums, rests, 3 * body, floor.changeX);
                MovingBodies.add(sums, rests, 3 * body + 1, floor.changeZ);
                MovingBodies.add(sums, rests, 3 * body + 2, floor.changeTurn);
            }
            bodies.vx[body] += sums[3 * body] + rests[3 * body];
            bodies.vz[body] += sums[3 * body + 1] + rests[3 * body + 1];
            bodies.w[body] += sums[3 * body + 2] + rests[3 * body + 2];
        }
        return change;
    }

    /** Lets each contact answer what those before it have left; tells by how much speeds change at most. */
    private double sweepOnce(boolean isRubbing, boolean isDecided) {
        breathe();
        double change = 0;
        for (int c = 0; c < island.count; c++) {
            change = Math.max(change, answer(c, isRubbing, isDecided, false));
        }
        for (int k = 0; k < island.bodyCount; k++) {
            int body = island.bodyList[k];
            if (floor.holds(body)) {
                change = Math.max(change, floor.answer(body, 1, 0));
                bodies.vx[body] += floor.changeX;
                bodies.vz[body] += floor.changeZ;
                bodies.w[body] += floor.changeTurn;
            }
        }
        return change;
    }

    private void breathe() {
        if (island.count > PART) {
            bodies.betweenParts.run();
        }
    }

    /** Begins with what is the answer of a single contact mostly: it sticks, or slides the way that it would have to be held. */
    private void guess(boolean isRubbing) {
        double closing = goal[0] - island.parting(0);
        if (!(soft[0] > 0 && closing > 0)) {
            return;
        }
        double pushed = closing / soft[0];
        double rubbed = 0;
        if (isRubbing && island.still[0] > 0) {
            double aside = island.aside(0);
            double both = soft[0] * softAside[0] - coupled[0] * coupled[0];
            pushed = (closing * softAside[0] + aside * coupled[0]) / both;
            rubbed = -(aside * soft[0] + closing * coupled[0]) / both;
            if (!(pushed > 0 && Math.abs(rubbed) <= island.still[0] * pushed)) {
                double drag = Math.copySign(island.sliding[0], rubbed);
                pushed = closing / (soft[0] + drag * coupled[0]);
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
    private double answer(int c, boolean isRubbing, boolean isDecided, boolean isSplit) {
        if (soft[c] == 0) {
            return 0;
        }
        double pushed = Math.max(0, push[c] + (goal[c] - island.parting(c)) / soft[c]);
        double by = pushed - push[c];
        double rubBy = 0;
        double change = Math.abs(by) * soft[c];
        if (isRubbing && island.still[c] > 0) {
            double rubbed = rub[c] - (island.aside(c) + by * coupled[c]) / softAside[c];
            if (Math.abs(rubbed) > (isSliding[c] ? island.sliding[c] : island.still[c]) * pushed) {
                rubbed = Math.copySign(island.sliding[c] * pushed, rubbed);
                isSliding[c] = isDecided;
            }
            rubBy = rubbed - rub[c];
            change = Math.max(change, Math.abs(rubBy) * softAside[c]);
        }
        if (isSplit) {
            double pushedBefore = lastPush[c];
            double rubbedBefore = lastRub[c];
            lastPush[c] = push[c] + by;
            lastRub[c] = rub[c] + rubBy;
            uphill -= by * soft[c] * (lastPush[c] - pushedBefore) + rubBy * softAside[c] * (lastRub[c] - rubbedBefore);
            by += momentum * (lastPush[c] - pushedBefore);
            rubBy += momentum * (lastRub[c] - rubbedBefore);
        }
        push[c] += by;
        rub[c] += rubBy;
        give(c, by, rubBy, isSplit);
        return change;
    }

    private void give(int c, double along, double aside, boolean isSplit) {
        double jx = along * island.nx[c] - aside * island.nz[c];
        double jz = along * island.nz[c] + aside * island.nx[c];
        give(island.a[c], jx, jz, along * island.leverA[c] + aside * island.asideA[c], isSplit);
        if (island.b[c] >= 0) {
            give(island.b[c], -jx, -jz, -(along * island.leverB[c] + aside * island.asideB[c]), isSplit);
        }
    }

    private void give(int body, double jx, double jz, double torque, boolean isSplit) {
        double light = bodies.lightness[body];
        double turn = torque * bodies.ease[body];
        if (isSplit) {
            MovingBodies.add(sums, rests, 3 * body, jx * light);
            MovingBodies.add(sums, rests, 3 * body + 1, jz * light);
            MovingBodies.add(sums, rests, 3 * body + 2, turn);
        } else {
            bodies.vx[body] += jx * light;
            bodies.vz[body] += jz * light;
            bodies.w[body] += turn;
        }
    }
}
