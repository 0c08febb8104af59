package robosim.geometry.dynamics.planar;

import java.util.Arrays;
import robosim.geometry.engine.World;
import robosim.geometry.engine.objects.IgnoredPairs;

/**
 * Lets the bodies of a PLANAR world go on for a time: they move at constant speeds from one collision to the next, each with
 * a time of its own, so that a collision concerns only those that touch there (Lubachevsky 1991); a queue holds the next
 * collision of each pair. Then the world carries them along the ways found.
 */
public final class PlanarStepper {
    /** Most times that the velocity of a body changes in one go; then it is held until the end. */
    private static final int MOST_CHANGES = 48;

    /** For so many seconds a body blocked by another one keeps its velocity; then it stops. */
    private static final double LONGEST_WAIT = 0.25;

    /** Collisions within so much of the time are solved together. */
    private static final double TOGETHER = 1e-12;

    /** What drives do when a collision has taken speed from the bodies that they drive. */
    @FunctionalInterface
    public interface Pushes {
        /**
         * Lets the drive of a body use what it has left of its acceleration; answers whether the velocity has changed.
         *
         * @param body  the index of the body
         * @param angle by how much it has turned since the run began, radians
         * @param round the number of the round of pushes, one above that of the round before in the same collision
         */
        boolean push(int body, double angle, long round);
    }

    final PlanarScene scene;
    final MovingBodies bodies;
    private final ConvexPieces pieces;
    private final CollisionQueue pairs = new CollisionQueue();
    private final Island island;
    private final ContactSolver solver;
    private final CarryingOrder order = new CarryingOrder();
    private final FloorFriction floor;
    private final CollisionPrediction meetings;
    private final Collisions met;
    private final PairSearch neighbours;
    private final MotionOrder carrying;
    private ContactLog touches;
    private ContactLog before;

    /** The log of the step before that, for a step that is taken back. */
    private ContactLog older;

    private double[] hadWaited = new double[0];

    private double end;
    private boolean[] isPressed = new boolean[8];

    /** For how long a body has waited for others that are in its way, seconds. */
    private double[] waited = new double[8];

    private int[] hits = new int[16];
    private int hitCount;

    /** How many collisions have been solved since the step began. */
    int collisions;

    public PlanarStepper(World world) {
        scene = new PlanarScene(world);
        bodies = scene.bodies;
        pieces = scene.pieces;
        floor = new FloorFriction(bodies);
        meetings = new CollisionPrediction(scene, pairs, floor);
        island = meetings.island;
        solver = meetings.solver;
        met = new Collisions(scene, pairs, meetings, floor);
        neighbours = new PairSearch(scene, pairs, meetings);
        carrying = new MotionOrder(world, scene, CollisionPrediction.GAP);
        touches = new ContactLog(world.objects);
        before = new ContactLog(world.objects);
        older = new ContactLog(world.objects);
    }

    /** What passes through each other; set before a build. */
    public IgnoredPairs passing() {
        return scene.passing;
    }

    /** Runs something between two parts of each step. */
    public void pausing(Runnable between) {
        bodies.betweenParts = between;
    }

    /** Forgets all bodies. */
    public void clear() {
        bodies.count = 0;
        scene.forget();
    }

    /** Adds a body, one without a mass (0) for what others only meet; answers its index. */
    public int add(int id, double mass, double inertia) {
        int b = bodies.add();
        bodies.id[b] = id;
        bodies.ownLightness[b] = mass == 0 ? 0 : 1 / mass;
        bodies.ownEase[b] = mass == 0 ? 0 : 1 / inertia;
        bodies.offsetX[b] = 0;
        bodies.offsetZ[b] = 0;
        if (b >= Math.min(isPressed.length, waited.length)) {
            isPressed = new boolean[2 * b];
            waited = Arrays.copyOf(waited, 2 * b);
        }
        floor.set(b, 0, 0);
        floor.forget(b);
        waited[b] = 0;
        bodies.stop(b);
        scene.forget();
        return b;
    }

    /** Sets where the centre of mass is as seen from the object's own centre, in axes that turn with its heading; before a build. */
    public void setOffset(int b, double x, double z) {
        bodies.offsetX[b] = x;
        bodies.offsetZ[b] = z;
    }

    /** Sets the moment of inertia of a body about the vertical, before a step. */
    public void setInertia(int b, double inertia) {
        bodies.ownEase[b] = 1 / inertia;
    }

    public void setVelocity(int b, double vx, double vz, double w) {
        bodies.vx[b] = vx;
        bodies.vz[b] = vz;
        bodies.w[b] = w;
    }

    /** Sets whether a drive pushes a body. */
    public void setDriven(int b, boolean isDriven) {
        bodies.isDriven[b] = isDriven;
    }

    /** Sets by how much the floor slows a body, m/s^2 and rad/s^2. */
    public void setSlowing(int b, double slowing, double spinSlowing) {
        floor.set(b, slowing, spinSlowing);
    }

    /** The id of a body in the world. */
    public int id(int b) {
        return bodies.id[b];
    }

    public double vx(int b) {
        return bodies.vx[b];
    }

    public double vz(int b) {
        return bodies.vz[b];
    }

    public double w(int b) {
        return bodies.w[b];
    }

    public int count() {
        return bodies.count;
    }

    /** Whether turning alone changes nothing about a body's outline. */
    public boolean isRound(int b) {
        int piece = bodies.firstPiece[b];
        return bodies.pieces[b] == 1 && pieces.reach[piece] == 0;
    }

    /** Who touched whom in this step, and which bodies were stopped. */
    public ContactLog touches() {
        return touches;
    }

    /** Who touched whom in the step before. */
    public ContactLog before() {
        return before;
    }

    /** Begins a step. */
    public void begin() {
        ContactLog spare = older;
        older = before;
        before = touches;
        touches = spare;
        touches.begin(before);
        collisions = 0;
    }

    /** Keeps what a step changes that is about to begin. */
    public void keep() {
        hadWaited = waited.clone();
        floor.keep();
    }

    /** Makes what the first bodies did before count again, as it was kept: they are the same. */
    public void recall(int count) {
        System.arraycopy(hadWaited, 0, waited, 0, count);
        floor.undo(count);
    }

    /** Takes a step back that was not made; whether it had begun. */
    public void undo(boolean hasBegun) {
        recall(hadWaited.length);
        if (hasBegun) {
            ContactLog failed = touches;
            touches = before;
            before = older;
            older = failed;
            touches.forgetNext();
        }
    }

    /** Whether all pieces have to be made anew before the next {@link #run}. */
    public boolean isOld() {
        return scene.isOld();
    }

    public void build(ContactSurfaces surfaces) {
        scene.build(surfaces);
        carrying.know();
    }

    /** Lets everything go on for a time in seconds; where too many may meet in it, for one half and then the other. */
    public void run(double seconds, ContactSurfaces surfaces, Pushes byDrives) {
        met.pushes = byDrives;
        while (!scene.place()) {
            scene.build(surfaces);
            carrying.know();
        }
        carrying.begin();
        end = seconds;
        meetings.begin(end);
        pairs.clear(bodies.count);
        if (!neighbours.spread(end)) {
            run(0.5 * seconds, surfaces, byDrives);
            run(0.5 * seconds, surfaces, byDrives);
            return;
        }
        for (int b = 0; b < bodies.count; b++) {
            floor.slow(b, end);
        }
        for (int p = 0; p < pairs.count; p++) {
            meetings.predict(p, 0);
        }
        for (double time = pairs.nextTime(); time <= end; time = pairs.nextTime()) {
            collide(time);
        }
        finish();
    }

    /** Marks a body that {@link #settle} is to look at, or one that it is not to. */
    public void press(int b, boolean isPressing) {
        isPressed[b] = isPressing;
    }

    /**
     * Solves, where all are after {@link #run}, what the bodies that press and have other velocities since do to those which
     * they touch. Nothing bounces there: all of it has met before.
     */
    public void settle() {
        met.isCarried = true;
        int lastMark = met.mark;
        for (int b = 0; b < bodies.count; b++) {
            for (int link = isPressed[b] ? pairs.heads[b] : -1; link >= 0; link = pairs.links[link]) {
                int pair = link >> 1;
                if (pairs.touches[pair] && pairs.mark[pair] <= lastMark && meetings.isApproaching(pair, end)) {
                    met.gather(pair, end);
                    met.settle(touches, false);
                }
            }
        }
        met.isCarried = false;
    }

    /** Takes all that meet at a time, and solves them, those that touch each other together. */
    private void collide(double time) {
        hitCount = 0;
        double last = time + TOGETHER * end;
        for (double next = time; next <= last; next = pairs.nextTime()) {
            if (hitCount == hits.length) {
                hits = Arrays.copyOf(hits, 2 * hitCount);
            }
            hits[hitCount++] = pairs.take();
        }
        int lastMark = met.mark;
        for (int k = 0; k < hitCount; k++) {
            pairs.touches[hits[k]] = true;
        }
        for (int k = 0; k < hitCount; k++) {
            if (pairs.mark[hits[k]] <= lastMark) {
                solve(hits[k], time);
            }
        }
        for (int k = 0; k < hitCount; k++) {
            pairs.met[hits[k]] = time;
        }
    }

    /** Solves a collision. */
    private void solve(int hit, double now) {
        collisions++;
        met.gather(hit, now);
        int other = pieces.body[pairs.b[hit]];
        boolean isSwapped = other >= 0 && met.isFollowed(island.bodyList[1], island.bodyList[0], hit, now);
        double approach = 0;
        for (int c = 0; c < island.count; c++) {
            approach = Math.min(approach, island.pair[c] == hit ? island.parting(c) : 0);
        }
        boolean isSlow = approach > -CollisionPrediction.SLOW;
        boolean isSolved = met.settle(touches, true);
        meetings.apart(now);
        for (int k = 0; k < island.bodyCount; k++) {
            int body = island.bodyList[isSwapped && k < 2 ? 1 - k : k];
            bodies.changes[body] += !isSlow && solver.isChanged(body) ? 1 : 0;
            if (!isSolved || bodies.changes[body] > MOST_CHANGES) {
                if (bodies.ownLightness[body] > 0) {
                    touches.stop(body, bodies.id[body], partner(body, hit), ContactLog.Cause.COLLISIONS);
                }
                bodies.hold(body);
            }
            carrying.leg(body);
        }
        for (int c = 0; c < island.count; c++) {
            pairs.solved[island.pair[c]] = now;
        }
        pairs.solved[hit] = now;
        if (isSlow) {
            meetings.pause(hit, now, met.isChanged(hit));
        }
        again(hit, now);
    }

    /** The object with which a body collides: of several, that of the pair that met, or the first. */
    private int partner(int body, int hit) {
        int object = World.NOTHING;
        for (int c = 0; c < island.count; c++) {
            int pair = island.pair[c];
            boolean isFirst = pieces.body[pairs.a[pair]] == body;
            boolean isOf = isFirst || pieces.body[pairs.b[pair]] == body;
            if (isOf && (object == World.NOTHING || pair == hit)) {
                object = pieces.object[isFirst ? pairs.b[pair] : pairs.a[pair]];
            }
        }
        return object;
    }

    /** Expects the next collisions of those whose velocities have changed. */
    private void again(int hit, double now) {
        int count = island.bodyCount;
        if (known.length < count) {
            known = new int[2 * count];
        }
        count = 0;
        for (int k = 0; k < island.bodyCount; k++) {
            int body = island.bodyList[k];
            if (solver.isChanged(body)) {
                known[count++] = body;
            }
        }
        pairs.expect(hit, PlanarTimeOfImpact.NEVER);
        for (int k = 0; k < count; k++) {
            neighbours.follow(known[k], now);
        }
        for (int k = 0; k < count; k++) {
            for (int link = pairs.heads[known[k]]; link >= 0; link = pairs.links[link]) {
                int pair = link >> 1;
                meetings.predict(pair, now);
            }
        }
        if (pairs.pause[hit] > now) {
            meetings.predict(hit, now);
        }
    }

    private int[] known = new int[16];

    // ---- the end ----

    private void finish() {
        for (int b = 0; b < bodies.count; b++) {
            bodies.advance(b, end);
            floor.slowed(b, end);
        }
        meetings.apartAtEnd();
        for (int b = 0; b < bodies.count; b++) {
            carrying.leg(b);
        }
        for (int p = 0; p < pairs.count; p++) {
            meetings.noteResting(touches, p);
        }
        touches.tell();
        order.sort(bodies, pairs, pieces, carrying.atX, carrying.atZ);
        carrying.carry(order.bodies, end);
        for (int b = 0; b < bodies.count; b++) {
            if (!carrying.isBlocked[b]) {
                waited[b] = 0;
            } else if (carrying.isBehind[b] && waited[b] < LONGEST_WAIT) {
                waited[b] += end; // and keeps its velocity
            } else {
                bodies.stop(b);
                touches.stop(b, bodies.id[b], carrying.blocker[b], ContactLog.Cause.BLOCKED);
            }
        }
        met.keepAngularMomentum(carrying);
    }
}
