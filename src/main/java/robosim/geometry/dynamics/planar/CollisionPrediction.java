package robosim.geometry.dynamics.planar;

/** When pairs meet, where they touch, and how far they are kept apart. */
final class CollisionPrediction {
    /** How far apart bodies stop, metres. */
    static final double GAP = 1e-10;

    /** Pieces that touch: nearer than so many gaps. */
    private static final double TOUCH = 20;

    /** Meeting more slowly is slow, m/s. */
    static final double SLOW = 0.05;

    /** Two that were hardly farther apart since they last met do not bounce again, metres: it would be ever faster for ever. */
    private static final double LEAST_FLIGHT = 1e-3;

    /** So often a pair meets slowly before it is left alone for a while. */
    private static final int PATIENCE = 3;

    /** So often the time is halved in which a pair becomes fast. */
    private static final int HALVES = 8;

    /** How long at first, as a share of the time; each time four times as long. */
    private static final double FIRST_PAUSE = 0x1p-12;

    /** Most rounds in which bodies are put apart. */
    private static final int SHIFTS = 8;

    /** Deeper in each other than this share of the size bodies do not touch. */
    private static final double DEEPEST = 1e-2;

    /** Shifts and turns that part two less than by this share of what shifts along the normal would are not made. */
    private static final double LEAST_PARTED = 0x1p-4;

    /** Pieces that touch and approach more slowly are left to close what is left of the gap, m/s. */
    private static final double QUIET = 1e-9;

    final PlanarTimeOfImpact impact;
    final Island island;
    final ContactSolver solver;

    private final PlanarScene scene;
    private final MovingBodies bodies;
    private final ConvexPieces pieces;
    private final CollisionQueue pairs;
    private final Manifold manifold = new Manifold();
    private final int[] both = new int[2];
    private double gap;
    private double end;

    CollisionPrediction(PlanarScene scene, CollisionQueue pairs, FloorFriction floor) {
        this.scene = scene;
        this.pairs = pairs;
        bodies = scene.bodies;
        pieces = scene.pieces;
        impact = new PlanarTimeOfImpact(bodies, pieces);
        island = new Island(bodies, floor);
        solver = new ContactSolver(bodies, floor, island);
    }

    double gap() {
        return gap;
    }

    /** Whether two that are so far apart touch. */
    boolean isTouch(int pair, double distance) {
        return distance <= TOUCH * gap && distance > deepest(pair);
    }

    /** Begins a time. MovingBodies stop a gap apart; more where coordinates are so large that less would drown in rounding. */
    void begin(double seconds) {
        end = seconds;
        double most = 0;
        for (int b = 0; b < bodies.count; b++) {
            most = Math.max(
                    most,
                    Math.max(Math.abs(bodies.x[b]), Math.abs(bodies.z[b]))
                            + bodies.size[b]
                            + (Math.abs(bodies.vx[b]) + Math.abs(bodies.vz[b])) * end);
        }
        gap = Math.max(GAP, 0x1p-42 * Math.min(most, 1e9));
        impact.stayApart(gap);
    }

    /** Expects when a pair meets next, from a time on. */
    void predict(int pair, double now) {
        bodies.betweenParts.run();
        double time = impact.first(pairs.a[pair], pairs.b[pair], now, end);
        pairs.touches[pair] = isTouch(pair, impact.apart);
        if (pairs.touches[pair] && pairs.solved[pair] != now && isApproaching(pair, now)) {
            time = now;
        }
        boolean isSolved = pairs.solved[pair] == now;
        if ((isSolved || pairs.pause[pair] > now) && pairs.touches[pair] && impact.apart <= 0) {
            time = now;
        }
        if (time == now && isSolved && pairs.pause[pair] <= now) {
            pause(pair, now, false); // it turns: otherwise it would not meet again in no time
        }
        // What has been solved often meets again after a pause only, unless something has made it fast meanwhile.
        if (time < pairs.pause[pair] && ((time == now && isSolved) || approach(pair, time) < SLOW)) {
            time = fast(pair, time);
        }
        pairs.expect(pair, time >= end ? PlanarTimeOfImpact.NEVER : time);
    }

    /** How deep two may be in each other, where they met in a pause, and still be taken for touching. */
    private double deepest(int pair) {
        return -DEEPEST * bodies.size[pieces.body[pairs.a[pair]]];
    }

    /**
     * An edge that turns about a corner which it touches meets it again at once, however often that is solved: each time the
     * pair is left alone for longer, so that it has few collisions in a step. So is at once one that has met and did not
     * approach.
     */
    void pause(int pair, double now, boolean isChanged) {
        int times = ++pairs.slowMeetings[pair] - (isChanged ? PATIENCE : 0);
        if (times > 0) {
            pairs.pause[pair] = now + end * FIRST_PAUSE * (1L << (2 * Math.min(times, 16)));
        }
    }

    /** Whether two that touch approach at a point of contact. */
    boolean isApproaching(int pair, double now) {
        island.begin();
        addContacts(pair, now);
        for (int c = 0; c < island.count; c++) {
            if (island.parting(c) < -QUIET) {
                return true;
            }
        }
        return false;
    }

    /**
     * When the pause of a pair is over, from a time at which it is slow: before its end if it becomes fast, as where two that
     * turn have come to lie flat against each other and meet at the other end of their edges.
     */
    private double fast(int pair, double from) {
        double slow = from;
        double fast = Math.min(pairs.pause[pair], end);
        if (approach(pair, fast) < SLOW) {
            return pairs.pause[pair];
        }
        for (int k = 0; k < HALVES; k++) {
            double mid = 0.5 * (slow + fast);
            if (approach(pair, mid) < SLOW) {
                slow = mid;
            } else {
                fast = mid;
            }
        }
        return fast;
    }

    /** How fast two that meet at a time approach at the points where they do. */
    private double approach(int pair, double time) {
        int pa = pairs.a[pair];
        int pb = pairs.b[pair];
        double distance = impact.measure(pa, pb, time);
        manifold.take(impact.separation, pieces.radius[pa], pieces.radius[pb], distance, TOUCH * gap);
        double most = 0;
        for (int k = 0; k < manifold.count; k++) {
            most = Math.max(most, inwards(pieces.body[pb], k, time) - inwards(pieces.body[pa], k, time));
        }
        return most;
    }

    /** The speed of a body along the normal at a point where it meets another one at a time. */
    private double inwards(int b, int k, double time) {
        if (b < 0) {
            return 0;
        }
        double nx = impact.separation.nx;
        double nz = impact.separation.nz;
        double lever = (manifold.z[k] - bodies.zAt(b, time)) * nx - (manifold.x[k] - bodies.xAt(b, time)) * nz;
        return bodies.vx[b] * nx + bodies.vz[b] * nz + bodies.w[b] * lever;
    }

    /** Adds the points at which two touch to the island. */
    void addContacts(int pair, double now) {
        int pa = pairs.a[pair];
        int pb = pairs.b[pair];
        int a = pieces.body[pa];
        int b = pieces.body[pb];
        bodies.advance(a, now);
        if (b >= 0) {
            bodies.advance(b, now);
        }
        double distance = impact.measure(pa, pb, now);
        manifold.take(impact.separation, pieces.radius[pa], pieces.radius[pb], distance, TOUCH * gap);
        for (int k = 0; k < manifold.count; k++) {
            int c = island.add(pair, a, b, manifold.x[k], manifold.z[k], impact.separation.nx, impact.separation.nz);
            ContactSurfaces mixed = scene.surfaces();
            double restitution = mixed.mixRestitution(scene.restitution[pa], scene.restitution[pb]);
            boolean isShort = restitution < 1 && (now - pairs.met[pair]) * -island.parting(c) < LEAST_FLIGHT;
            island.restitution[c] = isShort ? 0 : restitution;
            island.still[c] = mixed.mixFriction(scene.still[pa], scene.still[pb]);
            island.sliding[c] = Math.min(island.still[c], mixed.mixFriction(scene.sliding[pa], scene.sliding[pb]));
            island.least[c] = distance < 0.5 * gap && distance > 0 ? (gap - distance) / end : 0;
            int edge = impact.separation.edgeOf();
            island.rise[c] = edge == 0 ? 0 : edge == 1 ? rise(k, a, b, pb, -1, now) : rise(k, b, a, pa, 1, now);
        }
    }

    /**
     * The speed of parting with which a point that touches the edge of a body which turns is back at it at the end, rather
     * than in it at once: half of what the edge, turning into the straight path of the point, takes from its speed until then.
     *
     * @param edge  the body of the edge, or -1
     * @param point the body of the point, or -1
     * @param piece the piece of the point
     * @param sign  of the normal away from the edge, as seen from the one that points to the first body
     */
    private double rise(int k, int edge, int point, int piece, int sign, double now) {
        double w = edge < 0 ? 0 : bodies.w[edge];
        if (w == 0) {
            return 0;
        }
        double outX = sign * impact.separation.nx;
        double outZ = sign * impact.separation.nz;
        double x = manifold.x[k] + outX * pieces.radius[piece];
        double z = manifold.z[k] + outZ * pieces.radius[piece];
        double vx = 0.0 - bodies.vx[edge];
        double vz = 0.0 - bodies.vz[edge];
        double inwards = 0;
        if (point >= 0) {
            double spin = bodies.w[point];
            double dx = x - bodies.x[point];
            double dz = z - bodies.z[point];
            vx += bodies.vx[point] + spin * dz;
            vz += bodies.vz[point] - spin * dx;
            inwards = spin * spin * (outX * dx + outZ * dz);
        }
        double away = outX * (x - bodies.x[edge]) + outZ * (z - bodies.z[edge]);
        double bend = 2 * w * (outZ * vx - outX * vz) - w * w * away - inwards;
        double left = end - now;
        return bend < 0 ? -0.5 * bend * left * (1 + 0.5 * Math.abs(w) * left) : 0; // and what it takes more than evenly
    }

    /** Puts bodies apart that came too near in a pause, each by the share of its lightness. */
    void apart(double now) {
        boolean isDone = false;
        for (int round = 0; round < SHIFTS && !isDone; round++) {
            isDone = true;
            for (int c = 0; c < island.count; c++) {
                isDone &= !isPutApart(island.pair[c], now);
            }
        }
    }

    /** Does the same at the end, for all that touch, and keeps in which direction they do. */
    void apartAtEnd() {
        boolean isDone = false;
        for (int round = 0; round < SHIFTS && !isDone; round++) {
            isDone = true;
            for (int pair = 0; pair < pairs.count; pair++) {
                if (pairs.pause[pair] > 0 || pairs.touches[pair]) {
                    isDone &= !isPutApart(pair, end);
                    pairs.isNear[pair] = true;
                    pairs.nx[pair] = impact.separation.nx;
                    pairs.nz[pair] = impact.separation.nz;
                }
            }
        }
    }

    /** Whether two had to be put apart. */
    private boolean isPutApart(int pair, double now) {
        bodies.betweenParts.run();
        double distance = impact.measure(pairs.a[pair], pairs.b[pair], now);
        double missing = gap - distance;
        int a = pieces.body[pairs.a[pair]];
        int b = pieces.body[pairs.b[pair]];
        double lightB = b < 0 ? 0 : bodies.lightness[b];
        double light = bodies.lightness[a] + lightB;
        if (missing <= 0.5 * gap || light == 0 || distance <= deepest(pair)) {
            return false;
        }
        if (lightB > 0 && bodies.lightness[a] > 0 && !bodies.isDriven[a] && !bodies.isDriven[b]) {
            putApart(pair, distance, missing);
            return true;
        }
        double byA = missing * (bodies.lightness[a] / light);
        bodies.x[a] += byA * impact.separation.nx;
        bodies.z[a] += byA * impact.separation.nz;
        if (lightB > 0) {
            double byB = missing * (lightB / light);
            bodies.x[b] -= byB * impact.separation.nx;
            bodies.z[b] -= byB * impact.separation.nz;
        }
        return true;
    }

    /**
     * Puts two free bodies apart such that their angular momentum stays as it is: by turns, on which it does not depend, and
     * by shifts in opposite directions along the velocity of the one as seen from the other. Where that hardly parts them, as
     * where the one slides along the other, they are shifted along the normal, and slide more slowly by as much as their
     * centres are farther apart, or else turn together by what that changes; so energy does not grow.
     */
    private void putApart(int pair, double distance, double missing) {
        int pa = pairs.a[pair];
        int pb = pairs.b[pair];
        int a = pieces.body[pa];
        int b = pieces.body[pb];
        double nx = impact.separation.nx;
        double nz = impact.separation.nz;
        double vx = bodies.vx[a] - bodies.vx[b];
        double vz = bodies.vz[a] - bodies.vz[b];
        double square = vx * vx + vz * vz;
        double along = square > 0 ? (nx * vx + nz * vz) / square : 0;
        // Corners that are behind the nearest one by little more than what is missing would be turned in next.
        double slack = Math.max(TOUCH * gap, 4 * missing);
        manifold.take(impact.separation, pieces.radius[pa], pieces.radius[pb], distance, slack);
        double leverA = lever(a, nx, nz);
        double leverB = lever(b, nx, nz);
        double light = bodies.lightness[a] + bodies.lightness[b];
        double turned = bodies.ease[a] * leverA * leverA + bodies.ease[b] * leverB * leverB;
        double parted = light * (square > 0 ? along * (nx * vx + nz * vz) : 1) + turned;
        if (parted >= LEAST_PARTED * light) {
            double by = missing / parted;
            shift(a, b, by * (square > 0 ? along * vx : nx), by * (square > 0 ? along * vz : nz));
            bodies.angle[a] += by * bodies.ease[a] * leverA;
            bodies.angle[b] -= by * bodies.ease[b] * leverB;
            return;
        }
        double before = (bodies.z[a] - bodies.z[b]) * vx - (bodies.x[a] - bodies.x[b]) * vz;
        shift(a, b, missing / light * nx, missing / light * nz);
        double after = (bodies.z[a] - bodies.z[b]) * vx - (bodies.x[a] - bodies.x[b]) * vz;
        double kept = before / after;
        if (kept < 1 && kept > 0.5) {
            double share = (1 - kept) / light;
            bodies.vx[a] -= share * bodies.lightness[a] * vx;
            bodies.vz[a] -= share * bodies.lightness[a] * vz;
            bodies.vx[b] += share * bodies.lightness[b] * vx;
            bodies.vz[b] += share * bodies.lightness[b] * vz;
            return;
        }
        both[0] = a;
        both[1] = b;
        bodies.turnTogether(both, 2, (before - after) / light);
    }

    /** Shifts two bodies in opposite directions, by their lightness. */
    private void shift(int a, int b, double byX, double byZ) {
        bodies.x[a] += bodies.lightness[a] * byX;
        bodies.z[a] += bodies.lightness[a] * byZ;
        bodies.x[b] -= bodies.lightness[b] * byX;
        bodies.z[b] -= bodies.lightness[b] * byZ;
    }

    /** By how much a turn of a body shifts where it touches along the normal: both ends of a common edge at least. */
    private double lever(int body, double nx, double nz) {
        double first = (manifold.z[0] - bodies.z[body]) * nx - (manifold.x[0] - bodies.x[body]) * nz;
        if (manifold.count == 1) {
            return first;
        }
        double second = (manifold.z[1] - bodies.z[body]) * nx - (manifold.x[1] - bodies.x[body]) * nz;
        return first * second <= 0 ? 0 : Math.abs(first) < Math.abs(second) ? first : second;
    }

    /** Tells who pushed whom. */
    void tell(ContactLog touches) {
        for (int c = 0; c < island.count; c++) {
            int a = bodies.id[island.a[c]];
            int b = pieces.object[pairs.b[island.pair[c]]];
            double push = solver.push[c] > 0 ? solver.push[c] : -1;
            note(touches, a, b, island.px[c], island.pz[c], island.nx[c], island.nz[c], push);
        }
        touches.tell();
    }

    private void note(ContactLog touches, int a, int b, double x, double z, double nx, double nz, double push) {
        double height = scene.height(a);
        touches.note(a, b, x, height, z, nx, 0, nz, push);
    }

    /** Notes a contact that is left at the end. */
    void noteResting(ContactLog touches, int pair) {
        if (!pairs.touches[pair]) {
            return;
        }
        bodies.betweenParts.run();
        int pa = pairs.a[pair];
        int pb = pairs.b[pair];
        double distance = impact.measure(pa, pb, end);
        if (distance <= TOUCH * gap) {
            manifold.take(impact.separation, pieces.radius[pa], pieces.radius[pb], distance, TOUCH * gap);
            double nx = impact.separation.nx;
            double nz = impact.separation.nz;
            note(touches, pieces.object[pa], pieces.object[pb], manifold.x[0], manifold.z[0], nx, nz, 0);
        }
    }
}
