package robosim.geometry.dynamics.planar;

import java.util.Arrays;

/**
 * Finds who may go all of its way while all others go theirs: for each two whose ways come near each other it is proved that
 * they stay apart at every time ({@link SeparationProof}). Where that cannot be proved, both wait where they stand; who cannot be
 * proved to pass one who waits, waits too. What is left goes at once, each to where its last leg ends.
 *
 * <p>Nothing here relies on how the ways were found.
 */
final class SimultaneousMotion {
    private static final int FIRST = 32;

    /** So often those that do not pass each other are parted more, and once more for each of them: a row of bodies needs that. */
    private static final int ROUNDS = 48;

    private static final int MOST_ROUNDS = 64;

    /** By how much ends may be shifted in all these rounds, as a share of the size; beyond the way may not go. */
    private static final double MOST_SHIFT = 0x1p-3;

    private final PlanarScene scene;
    private final MovingBodies bodies;
    private final SeparationProof passing;
    private final CellGrid grid = new CellGrid();
    private final double[] box = new double[4];
    private Trajectories legs = new Trajectories();
    private boolean[] goes = new boolean[FIRST];

    /** By body: the last round in which it has been parted from another one. */
    private int[] parted = new int[FIRST];

    // Pairs of bodies whose ways come near, in a list for each body: a link is twice a pair, and one more for the
    // second.
    // What stands still is told as -1 less its piece.
    private int pairs;
    private int[] a = new int[FIRST];
    private int[] b = new int[FIRST];
    private int[] heads = new int[FIRST];
    private int[] links = new int[2 * FIRST];

    /** Those that wait and whose neighbours have not been asked yet. */
    private int[] waiting = new int[FIRST];

    private int waitingCount;

    SimultaneousMotion(PlanarScene scene) {
        this.scene = scene;
        bodies = scene.bodies;
        passing = new SeparationProof(scene.pieces, bodies);
    }

    /** Whether a body may go all of its way. */
    boolean goes(int body) {
        return goes[body];
    }

    /** Finds who may go along straight legs. */
    void find(Trajectories ways) {
        begin(ways, 0);
        decide();
    }

    /**
     * Finds who may go to the end of its only leg, along a parabola where something is in the way of the straight line; ends
     * that are in each other are put apart.
     */
    void findBulging(Trajectories ways) {
        begin(ways, SeparationProof.MOST_BULGE + MOST_SHIFT);
        boolean isChanged = true;
        Arrays.fill(parted, 0, bodies.count, 0);
        int rounds = ROUNDS;
        for (int body = 0; body < bodies.count && rounds < MOST_ROUNDS; body++) {
            rounds += goes[body] ? 1 : 0;
        }
        for (int round = 0; round < rounds && isChanged; round++) {
            isChanged = false;
            for (int pair = 0; pair < pairs; pair++) {
                int one = a[pair];
                int other = b[pair] < 0 || !goes[b[pair]] ? -1 : b[pair];
                boolean isOld = parted[one] < round - 1 && (other < 0 || parted[other] < round - 1);
                if (!isOld && !passes(pair) && passing.part(legs, one, other)) {
                    isChanged = true;
                    parted[one] = round;
                    if (other >= 0) {
                        parted[other] = round;
                    }
                }
            }
        }
        for (int body = 0; body < bodies.count; body++) {
            if (goes[body]) {
                hold(body, SeparationProof.MOST_BULGE);
                if (!grid.holds(body, box[0], box[1], box[2], box[3])) {
                    letWait(body); // shifted so far that there may be others of whom nobody has asked
                }
            }
        }
        decide();
    }

    private void decide() {
        for (int pair = 0; pair < pairs; pair++) {
            if ((goes[a[pair]] || (b[pair] >= 0 && goes[b[pair]])) && !passes(pair)) {
                letWait(a[pair]);
                if (b[pair] >= 0) {
                    letWait(b[pair]);
                }
            }
        }
        while (waitingCount > 0) {
            askNeighbours(waiting[--waitingCount]);
        }
    }

    private void begin(Trajectories ways, double bulge) {
        legs = ways;
        int count = bodies.count;
        if (goes.length < count) {
            goes = new boolean[2 * count];
            parted = new int[2 * count];
            heads = new int[2 * count];
            waiting = new int[2 * count];
        }
        passing.begin();
        pairs = 0;
        waitingCount = 0;
        Arrays.fill(heads, 0, count, -1);
        double size = 0;
        for (int body = 0; body < count; body++) {
            size += 2 * bodies.size[body];
        }
        grid.clear(count, size > 0 ? 1.5 * size / count : 1);
        for (int body = 0; body < count; body++) {
            bodies.betweenParts.run();
            goes[body] = legs.first[body] >= 0;
            hold(body, bulge);
            if (goes[body]) {
                findStill(body);
            } else {
                grid.put(body, box[0], box[1], box[2], box[3]);
            }
        }
        for (int body = 0; body < count; body++) {
            if (goes[body]) {
                bodies.betweenParts.run();
                findOthers(body, bulge);
            }
        }
    }

    /** Writes the box that holds a body all the way, which may bulge by a share of the size. */
    private void hold(int body, double bulge) {
        double size = bodies.size[body];
        double x = legs.fromX[body];
        double z = legs.fromZ[body];
        box[0] = x;
        box[1] = z;
        box[2] = x;
        box[3] = z;
        for (int leg = legs.first[body]; leg >= 0; leg = legs.next[leg]) {
            box[0] = Math.min(box[0], legs.x[leg]);
            box[1] = Math.min(box[1], legs.z[leg]);
            box[2] = Math.max(box[2], legs.x[leg]);
            box[3] = Math.max(box[3], legs.z[leg]);
        }
        double most = Math.max(Math.max(-box[0], box[2]), Math.max(-box[1], box[3]));
        double around = size * (1 + bulge) + 4 * SeparationProof.slack(2 * Math.abs(most) + size);
        box[0] -= around;
        box[1] -= around;
        box[2] += around;
        box[3] += around;
    }

    private void findStill(int body) {
        CellGrid still = scene.stillGrid;
        still.find(box[0], box[1], box[2], box[3]);
        for (int k = 0; k < still.foundCount; k++) {
            add(body, -1 - (scene.firstStill + still.found[k]));
        }
    }

    /** CollisionQueue a body up with those that wait and with those who go and came before: so each pair is found once. */
    private void findOthers(int body, double bulge) {
        hold(body, bulge);
        grid.find(box[0], box[1], box[2], box[3]);
        for (int k = 0; k < grid.foundCount; k++) {
            add(body, grid.found[k]);
        }
        grid.put(body, box[0], box[1], box[2], box[3]);
    }

    private void add(int body, int other) {
        int object = other < 0 ? scene.pieces.object[-1 - other] : bodies.id[other];
        if (scene.passing.has(bodies.id[body], object)) {
            return;
        }
        if (pairs == a.length) {
            a = Arrays.copyOf(a, 2 * pairs);
            b = Arrays.copyOf(b, 2 * pairs);
            links = Arrays.copyOf(links, 4 * pairs);
        }
        int pair = pairs++;
        a[pair] = body;
        b[pair] = other;
        links[2 * pair] = heads[body];
        heads[body] = 2 * pair;
        if (other >= 0) {
            links[2 * pair + 1] = heads[other];
            heads[other] = 2 * pair + 1;
        }
    }

    private boolean passes(int pair) {
        bodies.betweenParts.run();
        int one = a[pair];
        int other = b[pair];
        return other < 0
                ? passing.isClearOf(legs, one, -1 - other)
                : passing.isClear(legs, one, goes[one], other, goes[other]);
    }

    private void letWait(int body) {
        if (goes[body]) {
            goes[body] = false;
            waiting[waitingCount++] = body;
        }
    }

    /** Lets those wait that cannot be proved to pass one who stays where it is. */
    private void askNeighbours(int body) {
        for (int link = heads[body]; link >= 0; link = links[link]) {
            int other = (link & 1) == 0 ? b[link >> 1] : a[link >> 1];
            if (other >= 0 && goes[other] && !passes(link >> 1)) {
                letWait(other);
            }
        }
    }
}
