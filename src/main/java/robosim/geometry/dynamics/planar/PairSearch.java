package robosim.geometry.dynamics.planar;

/** Finds the pairs that may meet. */
final class PairSearch {
    /** Most pairs of a time in which many bodies go far, and more for each body: a few hundred bytes are kept for a pair. */
    private static final int MOST_PAIRS = 1 << 16;

    private static final int MOST_EACH = 16;

    /** Who goes so many times its own size goes far. */
    private static final double FAR = 4;

    private final PlanarScene scene;
    private final MovingBodies bodies;
    private final CollisionQueue pairs;
    private final CollisionPrediction meetings;
    private final CellGrid grid = new CellGrid();
    private final double[] own = new double[4];
    private double end;

    PairSearch(PlanarScene scene, CollisionQueue pairs, CollisionPrediction meetings) {
        this.scene = scene;
        this.pairs = pairs;
        this.meetings = meetings;
        bodies = scene.bodies;
    }

    /** CollisionQueue up all bodies for a time that begins; false where there are so many pairs that a shorter time is better. */
    boolean spread(double seconds) {
        end = seconds;
        double cell = 0;
        int far = 0;
        for (int b = 0; b < bodies.count; b++) {
            cell += 2 * bodies.size[b];
            double way = (Math.abs(bodies.vx[b]) + Math.abs(bodies.vz[b])) * end;
            far += way > FAR * bodies.size[b] ? 1 : 0;
        }
        // Where few go far, a shorter time has hardly fewer pairs.
        int most = far < bodies.count / 4 ? Integer.MAX_VALUE : MOST_PAIRS + MOST_EACH * bodies.count;
        grid.clear(bodies.count, bodies.count == 0 || cell == 0 ? 1 : 1.5 * cell / bodies.count);
        for (int b = 0; b < bodies.count; b++) {
            bodies.betweenParts.run(); // a box of a long way covers many cells
            sweep(b, 0);
            double margin = 0.0625 * bodies.size[b];
            grid.put(b, own[0] - margin, own[1] - margin, own[2] + margin, own[3] + margin);
        }
        for (int b = 0; b < bodies.count; b++) {
            bodies.betweenParts.run();
            findOthers(b, 0, true);
            if (pairs.count > most) {
                return false;
            }
        }
        return true;
    }

    /** Writes the box that holds a body from a time on to the end. */
    private void sweep(int b, double now) {
        double size = bodies.size[b] + 4 * meetings.gap() + 0x1p-40 * (Math.abs(bodies.x[b]) + Math.abs(bodies.z[b]));
        double dx = bodies.vx[b] * (end - now);
        double dz = bodies.vz[b] * (end - now);
        own[0] = bodies.x[b] - size + Math.min(0, dx);
        own[1] = bodies.z[b] - size + Math.min(0, dz);
        own[2] = bodies.x[b] + size + Math.max(0, dx);
        own[3] = bodies.z[b] + size + Math.max(0, dz);
    }

    private void findOthers(int b, double now, boolean isFirst) {
        sweep(b, now);
        boolean canMove = bodies.ownLightness[b] > 0;
        grid.findAbove(
                isFirst ? b : -1, own[0], own[1], own[2], own[3]); // in the first round each pair is found by both
        int found = grid.foundCount;
        for (int k = 0; k < found; k++) {
            int other = grid.found[k];
            if (other != b
                    && (canMove || bodies.ownLightness[other] > 0)
                    && !scene.passing.has(bodies.id[b], bodies.id[other])) {
                pairUp(b, other, isFirst, now);
            }
        }
        if (!canMove) {
            return;
        }
        scene.stillGrid.find(own[0], own[1], own[2], own[3]);
        for (int k = 0; k < scene.stillGrid.foundCount; k++) {
            int piece = scene.firstStill + scene.stillGrid.found[k];
            if (scene.passing.has(bodies.id[b], scene.pieces.object[piece])) {
                continue;
            }
            for (int p = bodies.firstPiece[b]; p < bodies.firstPiece[b] + bodies.pieces[b]; p++) {
                if (isFirst || !pairs.has(b, p, piece)) {
                    int pair = pairs.add(p, b, piece, -1);
                    if (!isFirst) {
                        meetings.predict(pair, now);
                    }
                }
            }
        }
    }

    private void pairUp(int b, int other, boolean isFirst, double now) {
        int first = Math.min(b, other);
        int second = Math.max(b, other);
        if (bodies.ownLightness[first] == 0) {
            int held = first;
            first = second;
            second = held;
        }
        for (int p = bodies.firstPiece[first]; p < bodies.firstPiece[first] + bodies.pieces[first]; p++) {
            for (int q = bodies.firstPiece[second]; q < bodies.firstPiece[second] + bodies.pieces[second]; q++) {
                if (isFirst || !pairs.has(b, p, q)) {
                    int pair = pairs.add(p, first, q, second);
                    if (!isFirst) {
                        meetings.predict(pair, now);
                    }
                }
            }
        }
    }

    /** Looks for others again where a body has left the box that held it. */
    void follow(int body, double now) {
        sweep(body, now);
        if (!grid.holds(body, own[0], own[1], own[2], own[3])) {
            grid.put(body, own[0], own[1], own[2], own[3]);
            findOthers(body, now, false);
        }
    }
}
