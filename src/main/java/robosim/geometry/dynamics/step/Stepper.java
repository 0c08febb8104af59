package robosim.geometry.dynamics.step;

import java.util.Arrays;
import robosim.geometry.engine.motion.Carrier;

/**
 * Lets the bodies of a PLANAR world go on for a time: they move at constant speeds from one collision to the next, each with
 * a time of its own, so that a collision concerns only those that touch there (Lubachevsky 1991); a queue holds the next
 * collision of each pair. Then the world carries them along the ways found.
 */
public final class Stepper {
    /** Most times that the velocity of a body changes in one go; then it is held until the end. */
    private static final int MOST_CHANGES = 48;

    /** Collisions within so much of the time are solved together. */
    private static final double TOGETHER = 1e-12;

    /** Pieces that touch: nearer than so many gaps. */
    private static final double TOUCH = 20;

    private static final double GAP = 1e-10;

    /** So often a pair meets slowly before it is left alone for a while. */
    private static final int PATIENCE = 3;

    /** How long at first, as a share of the time; each time four times as long. */
    private static final double FIRST_PAUSE = 0x1p-12;

    /** Meeting more slowly is slow, m/s. */
    private static final double SLOW = 0.05;

    /** Most rounds in which bodies are put apart. */
    private static final int SHIFTS = 8;

    /** Deeper in each other than this share of the size bodies do not touch. */
    private static final double DEEPEST = 1e-2;

    /** Pieces that touch and approach more slowly are left to close what is left of the gap, m/s. */
    private static final double QUIET = 1e-9;

    final Scene scene;
    final Bodies bodies;
    private final Pieces pieces;
    private final Pairs pairs = new Pairs();
    private final CellGrid grid = new CellGrid();
    private final TimeOfImpact impact;
    private final ContactSolver solver;
    private final Order order = new Order();
    private final Manifold manifold = new Manifold();
    private final FrontToBack carrying;
    private final Carrier carrier;
    private Touches touches = new Touches();
    private Touches before = new Touches();

    private double gap;
    private double end;
    private int mark;
    private int[] hits = new int[16];
    private int hitCount;
    private int[] bodyMark = new int[8];
    private double[] own = new double[4];

    /** Whether a body had to be stopped. */
    boolean[] isStopped = new boolean[8];

    /** The deceleration by the floor, m/s^2 and rad/s^2. */
    double[] drag = new double[8];

    double[] spinDrag = new double[8];

    public Stepper(Object world, double width, double length) {
        carrier = Carrier.of(world);
        scene = new Scene(carrier, width, length);
        bodies = scene.bodies;
        pieces = scene.pieces;
        impact = new TimeOfImpact(bodies, pieces);
        solver = new ContactSolver(bodies);
        carrying = new FrontToBack(carrier, bodies, GAP);
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
        if (b >= drag.length) {
            drag = Arrays.copyOf(drag, 2 * b);
            spinDrag = Arrays.copyOf(spinDrag, 2 * b);
            isStopped = new boolean[2 * b];
            bodyMark = new int[2 * b];
        }
        drag[b] = 0;
        spinDrag[b] = 0;
        bodies.stop(b);
        scene.forget();
        return b;
    }

    public void setVelocity(int b, double vx, double vz, double w) {
        bodies.vx[b] = vx;
        bodies.vz[b] = vz;
        bodies.w[b] = w;
    }

    /** Sets by how much the floor slows a body, m/s^2 and rad/s^2. */
    public void setSlowing(int b, double slowing, double spinSlowing) {
        drag[b] = slowing;
        spinDrag[b] = spinSlowing;
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

    public boolean isStopped(int b) {
        return isStopped[b];
    }

    public int count() {
        return bodies.count;
    }

    /** How fast the fastest turns of those that are not round, radians a second. */
    public double turning() {
        double most = 0;
        for (int b = 0; b < bodies.count; b++) {
            int piece = bodies.firstPiece[b];
            boolean isRound = bodies.pieces[b] == 1 && pieces.reach[piece] == 0;
            most = isRound ? most : Math.max(most, Math.abs(bodies.w[b]));
        }
        return most;
    }

    /** Whether the floor slows any that moves. */
    public boolean isSlowed() {
        for (int b = 0; b < bodies.count; b++) {
            if ((drag[b] > 0 || spinDrag[b] > 0) && !bodies.isStill(b)) {
                return true;
            }
        }
        return false;
    }

    /** Who touched whom in this step. */
    public Touches touches() {
        return touches;
    }

    /** Who touched whom in the step before. */
    public Touches before() {
        return before;
    }

    /** Begins a step. */
    public void begin() {
        Touches last = touches;
        touches = before;
        before = last;
        touches.clear();
        Arrays.fill(isStopped, 0, bodies.count, false);
    }

    /** Whether all pieces have to be made anew before the next {@link #run}. */
    public boolean isOld() {
        return scene.isOld();
    }

    public void build(Surfaces surfaces) {
        scene.build(surfaces);
        carrying.know();
        touches.clear();
        before.clear();
    }

    /** Lets everything go on for a time in seconds. */
    public void run(double seconds, Surfaces surfaces) {
        while (!scene.place()) {
            scene.build(surfaces);
            carrying.know();
        }
        carrying.begin();
        end = seconds;
        measureGap();
        pairs.clear(bodies.count);
        for (int b = 0; b < bodies.count; b++) {
            slow(b);
        }
        spread();
        for (int p = 0; p < pairs.count; p++) {
            predict(p, 0);
        }
        for (double time = pairs.nextTime(); time <= end; time = pairs.nextTime()) {
            meet(time);
        }
        finish();
    }

    /** Bodies stop this far apart; more where coordinates are so large that less would drown in rounding. */
    private void measureGap() {
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

    // ---- the floor ----

    /**
     * Gives a body the mean of what the floor leaves of its velocity until the end; it keeps that but for collisions, so that
     * what has been solved stays solved.
     */
    private void slow(int b) {
        if (drag[b] == 0 && spinDrag[b] == 0) {
            return;
        }
        double speed = Math.sqrt(bodies.vx[b] * bodies.vx[b] + bodies.vz[b] * bodies.vz[b]);
        double share = meanShare(speed, drag[b], end);
        bodies.vx[b] *= share;
        bodies.vz[b] *= share;
        bodies.w[b] *= meanShare(Math.abs(bodies.w[b]), spinDrag[b], end);
    }

    private static double meanShare(double speed, double slowing, double left) {
        if (speed == 0 || slowing == 0) {
            return 1;
        }
        double rest = speed / slowing;
        return rest >= left ? 1 - 0.5 * left / rest : 0.5 * rest / left;
    }

    /** Takes from a velocity, which was the mean, what the floor takes in the second half of the time. */
    private void slowed(int b) {
        if (drag[b] == 0 && spinDrag[b] == 0) {
            return;
        }
        double speed = Math.sqrt(bodies.vx[b] * bodies.vx[b] + bodies.vz[b] * bodies.vz[b]);
        double share = endShare(speed, drag[b], 0.5 * end);
        bodies.vx[b] *= share;
        bodies.vz[b] *= share;
        bodies.w[b] *= endShare(Math.abs(bodies.w[b]), spinDrag[b], 0.5 * end);
    }

    private static double endShare(double speed, double slowing, double passed) {
        return speed == 0 ? 1 : Math.max(0, 1 - slowing * passed / speed);
    }

    // ---- who may meet ----

    private void spread() {
        double cell = 0;
        for (int b = 0; b < bodies.count; b++) {
            cell += 2 * bodies.size[b];
        }
        grid.clear(bodies.count, bodies.count == 0 || cell == 0 ? 1 : 1.5 * cell / bodies.count);
        for (int b = 0; b < bodies.count; b++) {
            sweep(b, 0);
            double margin = 0.0625 * bodies.size[b];
            grid.put(b, own[0] - margin, own[1] - margin, own[2] + margin, own[3] + margin);
        }
        for (int b = 0; b < bodies.count; b++) {
            findOthers(b, 0, true);
        }
    }

    /** Writes the box that holds a body from a time on to the end. */
    private void sweep(int b, double now) {
        double size = bodies.size[b] + 4 * gap + 0x1p-40 * (Math.abs(bodies.x[b]) + Math.abs(bodies.z[b]));
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
        grid.find(own[0], own[1], own[2], own[3]);
        int found = grid.foundCount;
        for (int k = 0; k < found; k++) {
            int other = grid.found[k];
            // In the first round each pair of bodies is found by both.
            if ((isFirst ? other > b : other != b) && (canMove || bodies.ownLightness[other] > 0)) {
                pairUp(b, other, isFirst, now);
            }
        }
        if (!canMove) {
            return;
        }
        scene.stillGrid.find(own[0], own[1], own[2], own[3]);
        for (int k = 0; k < scene.stillGrid.foundCount; k++) {
            int piece = scene.firstStill + scene.stillGrid.found[k];
            for (int p = bodies.firstPiece[b]; p < bodies.firstPiece[b] + bodies.pieces[b]; p++) {
                if (isFirst || !pairs.has(b, p, piece)) {
                    int pair = pairs.add(p, b, piece, -1);
                    if (!isFirst) {
                        predict(pair, now);
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
                        predict(pair, now);
                    }
                }
            }
        }
    }

    // ---- when they meet ----

    private void predict(int pair, double now) {
        double time = impact.first(pairs.a[pair], pairs.b[pair], now, end);
        double deepest = deepest(pair);
        pairs.touches[pair] = impact.apart <= TOUCH * gap && impact.apart > deepest;
        if (pairs.touches[pair] && pairs.solved[pair] != now && isApproaching(pair, now)) {
            time = now;
        }
        if (pairs.pause[pair] > now && pairs.touches[pair] && impact.apart <= 0) {
            time = now;
        }
        // What has been solved often meets again after a pause only.
        time = Math.max(time, pairs.pause[pair]);
        // What has just been solved and has no gap left does not meet again in no time.
        boolean isNever = time >= end || (time == now && pairs.solved[pair] == now);
        pairs.expect(pair, isNever ? TimeOfImpact.NEVER : time);
    }

    /** How deep two may be in each other, where they met in a pause, and still be taken for touching. */
    private double deepest(int pair) {
        return -DEEPEST * bodies.size[pieces.body[pairs.a[pair]]];
    }

    /**
     * An edge that turns about a corner which it touches meets it again at once, however often that is solved: each time the
     * pair is left alone for longer, so that it has few collisions in a step.
     */
    private void pause(int pair, double now) {
        int times = ++pairs.slowMeetings[pair] - PATIENCE;
        if (times > 0) {
            pairs.pause[pair] = now + end * FIRST_PAUSE * (1L << (2 * Math.min(times, 16)));
        }
    }

    /** Whether two that touch approach at a point of contact. */
    private boolean isApproaching(int pair, double now) {
        solver.begin();
        addContacts(pair, now);
        for (int c = 0; c < solver.count; c++) {
            if (solver.parting(c) < -QUIET) {
                return true;
            }
        }
        return false;
    }

    private void addContacts(int pair, double now) {
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
            int c = solver.add(pair, a, b, manifold.x[k], manifold.z[k], impact.separation.nx, impact.separation.nz);
            solver.restitution[c] = mean(scene.restitution[pa], scene.restitution[pb]);
            solver.still[c] = mean(scene.still[pa], scene.still[pb]);
            solver.sliding[c] = Math.min(solver.still[c], mean(scene.sliding[pa], scene.sliding[pb]));
            solver.least[c] = distance < 0.5 * gap && distance > 0 ? (gap - distance) / end : 0;
        }
    }

    private static double mean(double a, double b) {
        return a == b ? a : Math.sqrt(a * b);
    }

    /** Takes all that meet at a time, and solves them, those that touch each other together. */
    private void meet(double time) {
        hitCount = 0;
        double last = time + TOGETHER * end;
        for (double next = time; next <= last; next = pairs.nextTime()) {
            if (hitCount == hits.length) {
                hits = Arrays.copyOf(hits, 2 * hitCount);
            }
            hits[hitCount++] = pairs.take();
        }
        int lastMark = mark;
        for (int k = 0; k < hitCount; k++) {
            pairs.touches[hits[k]] = true;
        }
        for (int k = 0; k < hitCount; k++) {
            if (pairs.mark[hits[k]] <= lastMark) {
                solve(hits[k], time);
            }
        }
    }

    /** Solves a collision with all that touch there, and what these touch. */
    private void solve(int hit, double now) {
        mark++;
        pairs.mark[hit] = 0;
        solver.begin();
        join(pieces.body[pairs.a[hit]], now);
        int other = pieces.body[pairs.b[hit]];
        if (other >= 0) {
            join(other, now);
        }
        for (int k = 0; k < solver.bodyCount; k++) {
            int body = solver.bodyList[k];
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
                if (distance <= TOUCH * gap && distance > deepest(pair)) {
                    addContacts(pair, now);
                } else if (pair != hit) {
                    pairs.touches[pair] = false;
                }
            }
        }
        boolean isSwapped = other >= 0 && isFollowed(solver.bodyList[1], solver.bodyList[0], hit, now);
        double approach = 0;
        for (int c = 0; c < solver.count; c++) {
            approach = Math.min(approach, solver.pair[c] == hit ? solver.parting(c) : 0);
        }
        boolean isSlow = approach > -SLOW;
        boolean isSolved = solver.solve();
        tell();
        apart(now);
        for (int k = 0; k < solver.bodyCount; k++) {
            int body = solver.bodyList[isSwapped && k < 2 ? 1 - k : k];
            bodies.changes[body] += !isSlow && solver.isChanged(body) ? 1 : 0;
            if (!isSolved || bodies.changes[body] > MOST_CHANGES) {
                isStopped[body] |= bodies.ownLightness[body] > 0;
                bodies.hold(body);
            }
            carrying.leg(body);
        }
        for (int c = 0; c < solver.count; c++) {
            pairs.solved[solver.pair[c]] = now;
        }
        pairs.solved[hit] = now;
        if (isSlow) {
            pause(hit, now);
        }
        again(hit, now);
    }

    /** Puts bodies apart that came too near in a pause, each by the share of its lightness. */
    private void apart(double now) {
        boolean isDone = false;
        for (int round = 0; round < SHIFTS && !isDone; round++) {
            isDone = true;
            for (int c = 0; c < solver.count; c++) {
                isDone &= !isPutApart(solver.pair[c], now);
            }
        }
    }

    private void apartAtEnd() {
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

    private boolean isPutApart(int pair, double now) {
        double distance = impact.measure(pairs.a[pair], pairs.b[pair], now);
        double missing = gap - distance;
        int a = pieces.body[pairs.a[pair]];
        int b = pieces.body[pairs.b[pair]];
        double lightB = b < 0 ? 0 : bodies.lightness[b];
        double light = bodies.lightness[a] + lightB;
        if (missing <= 0.5 * gap || light == 0 || distance <= deepest(pair)) {
            return false;
        }
        double byA = missing * (bodies.lightness[a] / light);
        bodies.x[a] += byA * impact.separation.nx;
        bodies.z[a] += byA * impact.separation.nz;
        if (b >= 0) {
            double byB = missing * (lightB / light);
            bodies.x[b] -= byB * impact.separation.nx;
            bodies.z[b] -= byB * impact.separation.nz;
        }
        return true;
    }

    /** Whether the second body of a pair recedes from the first, which follows it: then it is carried first. */
    private boolean isFollowed(int b, int a, int pair, double now) {
        impact.measure(pairs.a[pair], pairs.b[pair], now);
        double nx = impact.separation.nx;
        double nz = impact.separation.nz;
        return bodies.vx[b] * nx + bodies.vz[b] * nz < 0 && bodies.vx[a] * nx + bodies.vz[a] * nz < 0;
    }

    private void join(int body, double now) {
        if (bodyMark[body] == mark) {
            return;
        }
        bodyMark[body] = mark;
        bodies.advance(body, now);
        solver.addBody(body);
    }

    private void tell() {
        for (int c = 0; c < solver.count; c++) {
            if (solver.push[c] > 0) {
                int piece = pairs.b[solver.pair[c]];
                touches.add(
                        solver.a[c],
                        solver.b[c],
                        pieces.object[piece],
                        solver.px[c],
                        solver.pz[c],
                        solver.nx[c],
                        solver.nz[c],
                        solver.push[c]);
            }
        }
    }

    /** Expects the next collisions of those whose velocities have changed. */
    private void again(int hit, double now) {
        int count = solver.bodyCount;
        if (known.length < count) {
            known = new int[2 * count];
        }
        count = 0;
        for (int k = 0; k < solver.bodyCount; k++) {
            int body = solver.bodyList[k];
            if (solver.isChanged(body)) {
                known[count++] = body;
            }
        }
        pairs.expect(hit, TimeOfImpact.NEVER);
        for (int k = 0; k < count; k++) {
            int body = known[k];
            sweep(body, now);
            if (!grid.holds(body, own[0], own[1], own[2], own[3])) {
                grid.put(body, own[0], own[1], own[2], own[3]);
                findOthers(body, now, false);
            }
        }
        for (int k = 0; k < count; k++) {
            for (int link = pairs.heads[known[k]]; link >= 0; link = pairs.links[link]) {
                int pair = link >> 1;
                predict(pair, now);
            }
        }
        if (pairs.pause[hit] > now) {
            predict(hit, now);
        }
    }

    private int[] known = new int[16];

    // ---- the end ----

    private void finish() {
        for (int b = 0; b < bodies.count; b++) {
            bodies.advance(b, end);
            slowed(b);
        }
        apartAtEnd();
        for (int b = 0; b < bodies.count; b++) {
            carrying.leg(b);
        }
        for (int p = 0; p < pairs.count; p++) {
            tellResting(p);
        }
        order.sort(bodies, pairs, pieces, carrying.atX, carrying.atZ);
        carrying.carry(order.bodies);
        for (int b = 0; b < bodies.count; b++) {
            if (carrying.isBlocked[b]) {
                bodies.stop(b);
                isStopped[b] = true;
            }
        }
    }

    /** Tells of a contact that is left at the end. */
    private void tellResting(int pair) {
        if (!pairs.touches[pair]) {
            return;
        }
        int pa = pairs.a[pair];
        int pb = pairs.b[pair];
        double distance = impact.measure(pa, pb, end);
        if (distance <= TOUCH * gap) {
            manifold.take(impact.separation, pieces.radius[pa], pieces.radius[pb], distance, TOUCH * gap);
            touches.add(
                    pieces.body[pa],
                    pieces.body[pb],
                    pieces.object[pb],
                    manifold.x[0],
                    manifold.z[0],
                    impact.separation.nx,
                    impact.separation.nz,
                    0);
        }
    }
}
