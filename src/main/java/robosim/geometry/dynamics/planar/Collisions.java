package robosim.geometry.dynamics.planar;

/** A collision: who takes part, what velocities come of it, and what drives make of these. */
final class Collisions {
    /** So often drives make up for what a collision has cost them. */
    private static final int MOST_PUSHES = 16;

    /** Angular momentum smaller than this share of its parts is rounding. */
    private static final double ROUNDING = 0x1p-48;

    /** What drives do. */
    PlanarStepper.Pushes pushes = (body, angle, round) -> false;

    /** A number of the round of pushes at hand; after those of one collision one is left out. */
    private long pushing;

    /** Whether the world has carried the bodies to where they are, and has turned them. */
    boolean isCarried;

    /** A number of the collision at hand: pairs and bodies that belong to it are marked with it. */
    int mark;

    private final MovingBodies bodies;
    private final ConvexPieces pieces;
    private final CollisionQueue pairs;
    private final CollisionPrediction meetings;
    private final PlanarTimeOfImpact impact;
    private final Island island;
    private final ContactSolver solver;
    private final FloorFriction floor;
    private int[] bodyMark = new int[8];

    Collisions(PlanarScene scene, CollisionQueue pairs, CollisionPrediction meetings, FloorFriction floor) {
        this.pairs = pairs;
        this.meetings = meetings;
        this.floor = floor;
        bodies = scene.bodies;
        pieces = scene.pieces;
        impact = meetings.impact;
        island = meetings.island;
        solver = meetings.solver;
    }

    private void begin() {
        mark++;
        if (bodyMark.length < bodies.count) {
            bodyMark = new int[2 * bodies.count];
        }
        island.begin();
    }

    /** Makes a collision an island, with all that touch there, and what these touch. */
    void gather(int hit, double now) {
        begin();
        pairs.mark[hit] = 0;
        join(pieces.body[pairs.a[hit]], now);
        int other = pieces.body[pairs.b[hit]];
        if (other >= 0) {
            join(other, now);
        }
        for (int k = 0; k < island.bodyCount; k++) {
            bodies.betweenParts.run();
            int body = island.bodyList[k];
            if (bodies.lightness[body] == 0) {
                continue;
            }
            for (int link = pairs.heads[body]; link >= 0; link = pairs.links[link]) {
                int pair = link >> 1;
                if (!pairs.touches[pair] || pairs.mark[pair] == mark) {
                    continue;
                }
                pairs.mark[pair] = mark;
                int first = pieces.body[pairs.a[pair]];
                int second = pieces.body[pairs.b[pair]];
                join(first, now);
                if (second >= 0) {
                    join(second, now);
                }
                double distance = impact.measure(pairs.a[pair], pairs.b[pair], now);
                if (meetings.isTouch(pair, distance)) {
                    meetings.addContacts(pair, now);
                } else if (pair != hit) {
                    pairs.touches[pair] = false;
                }
            }
        }
    }

    /** Solves what has been gathered, and lets drives make up for what it has cost them. */
    boolean settle(ContactLog touches, boolean isBouncing) {
        boolean isSolved = solver.solve(isBouncing);
        meetings.tell(touches);
        pushing++;
        for (int round = 0; round < MOST_PUSHES && isSolved && push(); round++) {
            isSolved = solver.solveAgain();
            meetings.tell(touches);
        }
        for (int c = 0; c < island.count; c++) {
            if (island.b[c] >= 0 && solver.push[c] > 0) {
                floor.press(island.a[c]);
                floor.press(island.b[c]);
            }
        }
        return isSolved;
    }

    /** Lets the drives push on those whom something that can be moved is in the way of; whether any does. */
    private boolean push() {
        boolean isPushed = false;
        pushing++;
        for (int c = 0; c < island.count; c++) {
            if (island.b[c] >= 0 && solver.push[c] > 0) {
                isPushed |= push(island.a[c]);
                isPushed |= push(island.b[c]);
            }
        }
        return isPushed;
    }

    private boolean push(int body) {
        double turned = isCarried ? 0 : bodies.angle[body];
        return bodies.lightness[body] > 0 && solver.isChanged(body) && pushes.push(body, turned, pushing);
    }

    /** Whether the second body of a pair recedes from the first, which follows it: then it is carried first. */
    boolean isFollowed(int b, int a, int pair, double now) {
        impact.measure(pairs.a[pair], pairs.b[pair], now);
        double nx = impact.separation.nx;
        double nz = impact.separation.nz;
        return bodies.vx[b] * nx + bodies.vz[b] * nz < 0 && bodies.vx[a] * nx + bodies.vz[a] * nz < 0;
    }

    /** Whether the velocity of one of a pair has been changed. */
    boolean isChanged(int pair) {
        int other = pieces.body[pairs.b[pair]];
        return solver.isChanged(pieces.body[pairs.a[pair]]) || (other >= 0 && solver.isChanged(other));
    }

    /**
     * Restores the angular momentum of free bodies that touched nothing but each other, where some of them are not where they
     * were to be, but have the velocities that they were to have there.
     */
    void keepAngularMomentum(MotionOrder carrying) {
        begin();
        int lastMark = mark;
        for (int b = 0; b < bodies.count; b++) {
            boolean isElsewhere = carrying.atX[b] != bodies.x[b] || carrying.atZ[b] != bodies.z[b];
            if (isElsewhere && bodyMark[b] <= lastMark && gatherFree(b, carrying)) {
                double extra = 0;
                double most = 0;
                for (int k = 0; k < island.bodyCount; k++) {
                    int body = island.bodyList[k];
                    double vx = bodies.vx[body] / bodies.lightness[body];
                    double vz = bodies.vz[body] / bodies.lightness[body];
                    extra += (bodies.z[body] - carrying.atZ[body]) * vx - (bodies.x[body] - carrying.atX[body]) * vz;
                    most += Math.abs(bodies.z[body] * vx) + Math.abs(bodies.x[body] * vz);
                    bodies.x[body] = carrying.atX[body];
                    bodies.z[body] = carrying.atZ[body];
                }
                if (Math.abs(extra) > ROUNDING * most) {
                    bodies.turnTogether(island.bodyList, island.bodyCount, extra);
                }
            }
        }
    }

    /** Makes a body an island with all that it has met or waited for since the run began, and so on; whether all of them are
     * free. */
    private boolean gatherFree(int first, MotionOrder carrying) {
        begin();
        join(first, bodies.time[first]);
        boolean areFree = true;
        for (int k = 0; k < island.bodyCount; k++) {
            int body = island.bodyList[k];
            boolean isStopped = carrying.isBlocked[body] && bodies.isStill(body);
            areFree &= bodies.lightness[body] > 0 && !bodies.isDriven[body] && !isStopped;
            for (int link = pairs.heads[body]; link >= 0; link = pairs.links[link]) {
                int pair = link >> 1;
                int one = pieces.body[pairs.a[pair]];
                int other = pieces.body[pairs.b[pair]];
                boolean haveMet = pairs.isNear[pair] || pairs.solved[pair] >= 0;
                areFree &= other >= 0 || !haveMet;
                if (other >= 0 && (haveMet || (carrying.hasWaited[one] && carrying.hasWaited[other]))) {
                    join(one, bodies.time[one]);
                    join(other, bodies.time[other]);
                }
            }
        }
        return areFree;
    }

    private void join(int body, double now) {
        if (bodyMark[body] == mark) {
            return;
        }
        bodyMark[body] = mark;
        bodies.advance(body, now);
        island.addBody(body);
    }
}
