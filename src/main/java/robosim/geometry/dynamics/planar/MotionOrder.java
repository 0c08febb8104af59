package robosim.geometry.dynamics.planar;

import java.util.Arrays;
import robosim.geometry.engine.World;
import robosim.geometry.engine.objects.IgnoredPairs;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.DoubleDouble;

/**
 * Carries bodies in the world along the ways that were found for them. In an exact world all go at once whose ways are proved
 * to keep apart ({@link SimultaneousMotion}); what is left goes as far as is free by a swept move that is exact, and stops.
 *
 * <p>Below exact, where objects collide as what stands for them, one goes after the other, each by swept moves against where
 * all others stand at that moment. Where a body that has yet to move is in the way, it goes first, as far as it was to go by
 * that time; what remains blocked goes as far as is free and stops. Either way nothing ever overlaps and nothing passes through
 * anything, whatever was found.
 */
final class MotionOrder {
    private static final int FIRST = 32;

    /** So often the straight ways are tried. */
    private static final int ROUNDS = 3;

    /** So often those that wait are asked again. */
    private static final int PARTS = 16;

    /** Those that wait go no shorter parts of the time: by less than that they may as well be late. */
    private static final double LEAST_PART = 0x1p-8;

    /** Who gets no farther than in this share of the time is stopped; who does is late, and keeps its velocity. */
    private static final double LEAST_SHARE = 0x1p-3;

    /** Who lacks no more of its way than so many gaps is where it was to be. */
    private static final double MOST_GAPS = 32;

    /** Most bodies that are let go first, for one that waits. */
    private static final int MOST_WAITING = 64;

    /** Most times that a leg is halved. */
    private static final int MOST_HALVES = 2;

    /** Most others that one leg lets go first. */
    private static final int MOST_RETRIES = 4;

    private final World world;
    private final MovingBodies bodies;
    private final double gap;
    private final IgnoredPairs passing;

    private final Trajectories legs = new Trajectories();
    private final Trajectories shortened = new Trajectories();
    private final SimultaneousMotion allAtOnce;

    // By body: its next leg, and where it was to be at the time to which it has been carried.
    private int[] firstLeg = new int[FIRST];
    private double[] done = new double[FIRST];
    double[] atX = new double[FIRST];
    double[] atZ = new double[FIRST];
    private double[] atAngle = new double[FIRST];

    // By body: the same before its last motion, to which it may be taken back.
    private double[] fromTime = new double[FIRST];
    private double[] fromX = new double[FIRST];
    private double[] fromZ = new double[FIRST];
    private double[] fromAngle = new double[FIRST];
    private int[] fromLeg = new int[FIRST];

    /** The bodies that were taken back for the one on its way, and to when they are to be brought again. */
    private final int[] back = new int[16];

    private final double[] backTime = new double[16];
    private int backCount;

    private boolean[] isOnWay = new boolean[FIRST];

    /** Whether a body could not go all of its way at once. */
    boolean[] hasWaited = new boolean[FIRST];

    /** Whether a body waits until all others have gone. */
    private boolean[] isLate = new boolean[FIRST];

    /** Whether a body could not be carried where it was to go. */
    boolean[] isBlocked = new boolean[FIRST];

    /** The object that blocks a body; below 0 for the border. */
    int[] blocker = new int[FIRST];

    /** Whether what blocks a body is another one that moves. */
    boolean[] isBehind = new boolean[FIRST];

    /** The body of an object of the world, by id; -1 for none. */
    private int[] bodyOf = new int[FIRST];

    private int waiting;

    MotionOrder(World world, PlanarScene scene, double gap) {
        this.world = world;
        bodies = scene.bodies;
        passing = scene.passing;
        allAtOnce = new SimultaneousMotion(scene);
        this.gap = gap;
    }

    /** Tells which objects of the world are bodies. */
    void know() {
        int limit = world.objects.limit();
        if (bodyOf.length < limit) {
            bodyOf = new int[2 * limit];
        }
        Arrays.fill(bodyOf, -1);
        for (int b = 0; b < bodies.count; b++) {
            bodyOf[bodies.id[b]] = b;
        }
    }

    /** Begins with all bodies where they stand. */
    void begin() {
        legs.begin(bodies);
        if (done.length < bodies.count) {
            int room = 2 * bodies.count;
            firstLeg = new int[room];
            done = new double[room];
            atX = new double[room];
            atZ = new double[room];
            atAngle = new double[room];
            fromTime = new double[room];
            fromX = new double[room];
            fromZ = new double[room];
            fromAngle = new double[room];
            fromLeg = new int[room];
            isOnWay = new boolean[room];
            hasWaited = new boolean[room];
            isLate = new boolean[room];
            isBlocked = new boolean[room];
            blocker = new int[room];
            isBehind = new boolean[room];
        }
        for (int b = 0; b < bodies.count; b++) {
            firstLeg[b] = -1;
            done[b] = 0;
            fromTime[b] = 0;
            atX[b] = bodies.x[b];
            atZ[b] = bodies.z[b];
            atAngle[b] = 0;
            isBlocked[b] = false;
            isBehind[b] = false;
            isLate[b] = false;
        }
    }

    /** Adds where a body is at the time it has come to; calls are in the order of times. */
    void leg(int b) {
        legs.add(bodies, b);
    }

    /**
     * Carries all bodies to where their last legs end: at once those for which the straight way is free, in an order that is
     * given, and along all their legs, in the order of times, the others.
     */
    void carry(int[] order, double end) {
        for (int b = 0; b < bodies.count; b++) {
            firstLeg[b] = legs.first[b];
        }
        if (world.isExact()) {
            carryAtOnce(end);
        } else {
            carryInTurns(order);
        }
        for (int k = 0; k < bodies.count; k++) {
            int b = order[k];
            if (firstLeg[b] >= 0 && !isBlocked[b]) {
                settle(b);
            }
        }
    }

    /**
     * Lets all go at once that can. Those that wait go on when the others have gone, together from time to time: where none
     * can, for half as long, since bodies that touch on their ways are not free on the straight line between.
     */
    private void carryAtOnce(double end) {
        allAtOnce.find(legs);
        for (int b = 0; b < bodies.count; b++) {
            if (firstLeg[b] >= 0 && allAtOnce.goes(b)) {
                put(b, legs, end);
            }
        }
        noteWaiting();
        double most = end;
        for (int round = 0; round < PARTS && isLeft() && most >= LEAST_PART * end; round++) {
            shortened.makeRoom(bodies.count);
            for (int b = 0; b < bodies.count; b++) {
                shortened.begin(b, atX[b], atZ[b], atAngle[b]);
                if (firstLeg[b] >= 0) {
                    shortened.addPart(b, legs, Math.min(end, done[b] + most), end);
                }
            }
            allAtOnce.findBulging(shortened);
            boolean isAny = false;
            for (int b = 0; b < bodies.count; b++) {
                if (firstLeg[b] >= 0 && allAtOnce.goes(b)) {
                    put(b, shortened, Math.min(end, done[b] + most));
                    isAny = true;
                }
            }
            most = isAny ? most : 0.5 * most;
        }
        for (int b = 0; b < bodies.count; b++) {
            if (firstLeg[b] >= 0 && done[b] >= LEAST_SHARE * end) {
                firstLeg[b] = -1;
            }
        }
    }

    private void noteWaiting() {
        for (int b = 0; b < bodies.count; b++) {
            hasWaited[b] = firstLeg[b] >= 0;
        }
    }

    private boolean isLeft() {
        for (int b = 0; b < bodies.count; b++) {
            if (firstLeg[b] >= 0) {
                return true;
            }
        }
        return false;
    }

    /** Puts a body where its last leg ends. */
    private void put(int b, Trajectories of, double until) {
        int leg = of.last[b];
        double degrees = Degrees.toDegrees(of.angle[leg] - atAngle[b]);
        double dx = of.x[leg] - atX[b] - swingX(b, degrees);
        double dz = of.z[leg] - atZ[b] - swingZ(b, degrees);
        world.put(bodies.id[b], dx, dz, degrees);
        arrive(b, until, of.x[leg], of.z[leg], of.angle[leg]);
        if (until == legs.time[legs.last[b]]) {
            firstLeg[b] = -1;
        }
    }

    /** How far a turn takes the centre of mass along X if the object's own centre stays where it is. */
    private double swingX(int b, double degrees) {
        if (degrees == 0 || !bodies.isOffset(b)) {
            return 0;
        }
        return bodies.asideX(b, cos(b, degrees), sin(b, degrees)) - bodies.asideX(b, cos(b, 0), sin(b, 0));
    }

    private double swingZ(int b, double degrees) {
        if (degrees == 0 || !bodies.isOffset(b)) {
            return 0;
        }
        return bodies.asideZ(b, cos(b, degrees), sin(b, degrees)) - bodies.asideZ(b, cos(b, 0), sin(b, 0));
    }

    private double cos(int b, double degrees) {
        int at = world.objects.place(bodies.id[b]) + ObjectTable.HEADING;
        double heading = world.objects.places()[at];
        double sum = heading + degrees;
        return Degrees.cos(sum, world.objects.places()[at + 1] + DoubleDouble.sumTail(heading, degrees, sum));
    }

    private double sin(int b, double degrees) {
        int at = world.objects.place(bodies.id[b]) + ObjectTable.HEADING;
        double heading = world.objects.places()[at];
        double sum = heading + degrees;
        return Degrees.sin(sum, world.objects.places()[at + 1] + DoubleDouble.sumTail(heading, degrees, sum));
    }

    /** Carries all one after the other. */
    private void carryInTurns(int[] order) {
        carryStraight(order);
        noteWaiting();
        for (int leg = 0; leg < legs.count; leg++) {
            int b = legs.body[leg];
            if (!isLate[b] && !isBlocked[b] && done[b] < legs.time[leg]) {
                isLate[b] = !bringAlone(b, legs.time[leg]);
            }
        }
        carryStraight(order);
    }

    /** Carries those for which the straight way is free to where they end. */
    private void carryStraight(int[] order) {
        boolean isOn = true;
        for (int round = 0; round < ROUNDS && isOn; round++) {
            isOn = false;
            for (int k = 0; k < bodies.count; k++) {
                int b = order[k];
                isOn |= firstLeg[b] >= 0 && isCarriedStraight(b);
            }
        }
    }

    /** Brings a body to where it was to be at a time, and then again those that it made go back. */
    private boolean bringAlone(int b, double until) {
        waiting = 0;
        backCount = 0;
        boolean isThere = bring(b, until);
        while (backCount > 0) {
            int other = back[--backCount];
            if (!bring(other, backTime[backCount])) {
                isLate[other] = true;
            }
        }
        return isThere;
    }

    private boolean isCarriedStraight(int b) {
        int leg = legs.last[b];
        if (!makes(b, legs.x[leg] - atX[b], legs.z[leg] - atZ[b], Degrees.toDegrees(legs.angle[leg] - atAngle[b]))) {
            return false;
        }
        arrive(b, legs.time[leg], legs.x[leg], legs.z[leg], legs.angle[leg]);
        firstLeg[b] = -1;
        return true;
    }

    private void arrive(int b, double until, double toX, double toZ, double toAngle) {
        fromTime[b] = done[b];
        fromX[b] = atX[b];
        fromZ[b] = atZ[b];
        fromAngle[b] = atAngle[b];
        fromLeg[b] = firstLeg[b];
        done[b] = until;
        atX[b] = toX;
        atZ[b] = toZ;
        atAngle[b] = toAngle;
    }

    /** Brings a body to where it was to be at a time; false where it is blocked. */
    private boolean bring(int b, double until) {
        isOnWay[b] = true;
        boolean isThere = true;
        while (isThere && firstLeg[b] >= 0 && done[b] < until && !isBlocked[b]) {
            int leg = firstLeg[b];
            if (legs.time[leg] <= until) {
                isThere = goes(b, legs.time[leg], legs.x[leg], legs.z[leg], legs.angle[leg], 0);
                if (isThere) {
                    firstLeg[b] = legs.next[leg];
                }
            } else {
                double share = (until - done[b]) / (legs.time[leg] - done[b]);
                isThere = goes(
                        b,
                        until,
                        atX[b] + share * (legs.x[leg] - atX[b]),
                        atZ[b] + share * (legs.z[leg] - atZ[b]),
                        atAngle[b] + share * (legs.angle[leg] - atAngle[b]),
                        0);
            }
        }
        isOnWay[b] = false;
        return isThere && !isBlocked[b];
    }

    private boolean goes(int b, double until, double toX, double toZ, double toAngle, int halves) {
        double dx = toX - atX[b];
        double dz = toZ - atZ[b];
        double degrees = Degrees.toDegrees(toAngle - atAngle[b]);
        boolean isMade = makes(b, dx, dz, degrees);
        for (int retry = 0; !isMade && retry < MOST_RETRIES; retry++) {
            if (!letGo(b, until, dx, dz, degrees)) {
                break;
            }
            isMade = makes(b, dx, dz, degrees);
        }
        if (!isMade && halves < MOST_HALVES) {
            double mid = 0.5 * (done[b] + until);
            double midX = 0.5 * (atX[b] + toX);
            double midZ = 0.5 * (atZ[b] + toZ);
            double midAngle = 0.5 * (atAngle[b] + toAngle);
            return done[b] < mid
                    && mid < until
                    && goes(b, mid, midX, midZ, midAngle, halves + 1)
                    && goes(b, until, toX, toZ, toAngle, halves + 1);
        }
        if (isMade) {
            arrive(b, until, toX, toZ, toAngle);
        }
        return isMade;
    }

    /** Makes a translation and a turn, one after the other in one of both orders; nothing if neither is free. */
    private boolean makes(int b, double massX, double massZ, double degrees) {
        bodies.betweenParts.run();
        int id = bodies.id[b];
        passing.begin(id);
        try {
            return translatesAndTurns(id, massX - swingX(b, degrees), massZ - swingZ(b, degrees), degrees);
        } finally {
            passing.end();
        }
    }

    private boolean translatesAndTurns(int id, double dx, double dz, double degrees) {
        boolean translates = dx != 0 || dz != 0;
        if (!translates || world.translate(id, dx, 0, dz)) {
            if (degrees == 0 || world.turn(id, degrees)) {
                return true;
            }
            if (!translates || !world.translate(id, -dx, 0, -dz)) {
                return false;
            }
        }
        if (degrees == 0 || !translates || !world.turn(id, degrees)) {
            return false;
        }
        if (world.translate(id, dx, 0, dz)) {
            return true;
        }
        world.turn(id, -degrees);
        return false;
    }

    /**
     * Lets whoever is in the way go first, or back to where it came from last if it has been brought there already; false if
     * there is nobody who could.
     */
    private boolean letGo(int b, double until, double dx, double dz, double degrees) {
        int obstacle = blocker(b, dx - swingX(b, degrees), dz - swingZ(b, degrees), degrees);
        int other = obstacle < 0 || obstacle >= bodyOf.length ? -1 : bodyOf[obstacle];
        if (other < 0 || isOnWay[other] || isBlocked[other] || ++waiting > MOST_WAITING) {
            return false;
        }
        if (done[other] >= until) {
            return backCount < back.length && goesBack(other);
        }
        if (firstLeg[other] < 0) {
            return false;
        }
        double was = done[other];
        return bring(other, until) || done[other] > was;
    }

    private int blocker(int b, double dx, double dz, double degrees) {
        passing.begin(bodies.id[b]);
        try {
            return world.blocker(bodies.id[b], dx, dz, degrees);
        } finally {
            passing.end();
        }
    }

    /** Takes a body back to where it was before its last motion; it is brought forward again when the other has gone. */
    private boolean goesBack(int b) {
        if (!(fromTime[b] < done[b])
                || !makes(b, fromX[b] - atX[b], fromZ[b] - atZ[b], Degrees.toDegrees(fromAngle[b] - atAngle[b]))) {
            return false;
        }
        backTime[backCount] = done[b];
        back[backCount++] = b;
        done[b] = fromTime[b];
        atX[b] = fromX[b];
        atZ[b] = fromZ[b];
        atAngle[b] = fromAngle[b];
        firstLeg[b] = fromLeg[b];
        return true;
    }

    /**
     * Lets a body go as far as it may, where it ends. It is blocked where it gets less than its share of the way and what it
     * lacks is more than the gaps between bodies that touch: one that rests among others may have to make room by as much.
     */
    private void settle(int b) {
        bodies.betweenParts.run();
        int id = bodies.id[b];
        int leg = firstLeg[b];
        double dx = legs.x[leg] - atX[b];
        double dz = legs.z[leg] - atZ[b];
        double by = legs.angle[leg] - atAngle[b];
        double fromX = world.objects.places()[world.objects.place(id)];
        double fromZ = world.objects.places()[world.objects.place(id) + 2];
        double degrees = Degrees.toDegrees(by);
        double cos = bodies.isOffset(b) ? cos(b, 0) : 1;
        double sin = bodies.isOffset(b) ? sin(b, 0) : 0;
        boolean isThere = isThere(id, dx - swingX(b, degrees), dz - swingZ(b, degrees), degrees);
        int obstacle = isThere ? -1 : world.obstacle();
        blocker[b] = obstacle;
        int other = obstacle < 0 || obstacle >= bodyOf.length ? -1 : bodyOf[obstacle];
        isBehind[b] = other >= 0 && bodies.lightness[other] > 0 && !bodies.isStill(other);
        double[] places = world.objects.places();
        int at = world.objects.place(id);
        double madeX = places[at] - fromX;
        double madeZ = places[at + 2] - fromZ;
        if (bodies.isOffset(b)) {
            madeX += bodies.asideX(b, cos(b, 0), sin(b, 0)) - bodies.asideX(b, cos, sin);
            madeZ += bodies.asideZ(b, cos(b, 0), sin(b, 0)) - bodies.asideZ(b, cos, sin);
        }
        atX[b] += madeX;
        atZ[b] += madeZ;
        double lacking = length(dx - madeX, dz - madeZ);
        double turning = Math.abs(by) * bodies.size[b];
        double least = MOST_GAPS * Math.max(gap, 0x1p-42 * (Math.abs(fromX) + Math.abs(fromZ)));
        isBlocked[b] = !isThere && lacking + turning > Math.max(least, (1 - LEAST_SHARE) * (length(dx, dz) + turning));
    }

    private boolean isThere(int id, double dx, double dz, double degrees) {
        passing.begin(id);
        try {
            return world.moveToContact(id, dx, dz, degrees, gap);
        } finally {
            passing.end();
        }
    }

    private static double length(double x, double z) {
        return Math.sqrt(x * x + z * z);
    }
}
