package robosim.geometry.dynamics.spatial;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.dynamics.planar.ContactLog;
import robosim.geometry.dynamics.planar.ContactSurfaces;
import robosim.geometry.engine.World;
import robosim.geometry.engine.motion.Placer;
import robosim.geometry.engine.objects.IgnoredPairs;
import robosim.geometry.engine.objects.ObjectTable;

/**
 * Moves rigid bodies in space by slices of time: impulses where they touch, then gravity against what holds them, and then
 * each is carried to its next contact, the lowest first.
 */
public final class SpatialStepper {
    /** Slices last so many seconds, or more where a step would have too many of them. */
    private static final double SLICE = 1e-3;

    private static final int MOST_SLICES = 10_000;

    /** Most parts of a slice; in the last of them bodies meet where the one that is carried first finds the other. */
    private static final int MOST_PARTS = 16;

    private final Placer placer;
    private final double[] gravity;
    private final List<RigidBody> bodies = new ArrayList<>();
    private final Clusters cluster;
    private final EnergyBudget budget;
    private final TurningSweep way;
    private final Traction traction;
    private final SequentialImpulses impulses;
    private final Contacts contacts = new Contacts();
    private final ContactDetection detection;
    private final Integrator carriage;
    private final SpatialTimeOfImpact impact;
    private final RestGap loosening;
    private final FreeGroup free;
    private final double[] known = new double[ObjectTable.PLACE];
    private int[] order = new int[0];
    private Runnable betweenParts = () -> {};
    private ContactLog now;
    private ContactLog last;

    /** The log of the step before that, for a step that is taken back. */
    private ContactLog older;

    // What was before a step that may be taken back.
    private final List<RigidBody> kept = new ArrayList<>();
    private int keptTurn;
    private long keptChanges;

    private long changes = -1;

    /**
     * No bodies so far.
     *
     * @param gravity three numbers, m/s^2
     */
    public SpatialStepper(World world, double[] gravity) {
        placer = world.placer();
        now = new ContactLog(placer.objects);
        last = new ContactLog(placer.objects);
        older = new ContactLog(placer.objects);
        NearbyPieces near =
                new NearbyPieces(placer, new double[] {world.width / 2, world.height / 2, world.length / 2});
        way = new TurningSweep(placer, near);
        this.gravity = gravity.clone();
        cluster = new Clusters(bodies, this.gravity, near::arePassing);
        budget = new EnergyBudget(bodies, this.gravity, cluster);
        traction = new Traction(bodies, this.gravity, cluster);
        impulses = new SequentialImpulses(bodies, traction);
        detection = new ContactDetection(bodies, budget, near, contacts);
        impact = new SpatialTimeOfImpact(bodies, near);
        free = new FreeGroup(bodies, this.gravity, placer, detection);
        loosening = new RestGap(bodies, placer, way, detection, this.gravity);
        carriage = new Integrator(bodies, this.gravity, way, detection, impulses, contacts, cluster, new Teller());
    }

    /** Forgets all bodies. */
    public void clear() {
        bodies.clear();
        impulses.clear();
        changes = -1;
    }

    /** Adds a body at rest; answers its index. */
    public int add(int id, double mass, double[] moments, boolean isBall, double reach) {
        RigidBody body = new RigidBody(id, mass, moments, isBall, reach);
        way.read(body);
        bodies.add(body);
        return bodies.size() - 1;
    }

    /** What passes through each other; set when bodies are added. */
    public IgnoredPairs passing() {
        return placer.passing;
    }

    /** Sets what drives bodies. */
    public void driveBy(Driver driver) {
        traction.driveBy(driver);
    }

    /** Sets what slows a body, and its limits; radians. */
    public void limit(
            int b, double floorFriction, double damping, double turnDamping, double maxSpeed, double maxTurn) {
        RigidBody body = bodies.get(b);
        body.floorFriction = floorFriction;
        body.damping = damping;
        body.turnDamping = turnDamping;
        body.maxSpeed = maxSpeed;
        body.maxTurn = maxTurn;
    }

    /** Sets what resists the motion of a body: its quadratic drag, kg/m, and rolling resistance, a share of the load. */
    public void resist(int b, double drag, double rolling) {
        bodies.get(b).drag = drag;
        bodies.get(b).rolling = rolling;
    }

    /**
     * Lets a force and a torque act on a body until they are set anew, and wakes it.
     *
     * @param by newtons and newton metres in the world's axes; null for nothing
     */
    public void push(int b, double @Nullable [] by) {
        RigidBody body = bodies.get(b);
        body.isPushed = by != null;
        if (by != null) {
            System.arraycopy(by, 0, body.push, 0, 6);
            body.wake();
        }
    }

    /** The velocity of a body: six numbers, m/s and radians a second about the world's axes. */
    public void velocity(int b, double[] out) {
        System.arraycopy(bodies.get(b).v, 0, out, 0, 6);
    }

    /** Sets the velocity of a body and wakes it, unless it is the one that it has. */
    public void setVelocity(int b, double[] to) {
        RigidBody body = bodies.get(b);
        if (!Arrays.equals(body.v, to)) {
            System.arraycopy(to, 0, body.v, 0, 6);
            body.wake();
        }
    }

    /** The contacts of the last step, and of the one before. */
    public ContactLog touched() {
        return now;
    }

    public ContactLog before() {
        return last;
    }

    /** Runs something between two bodies in each part of a step, so that a long one gives way to others. */
    public void pausing(Runnable between) {
        betweenParts = between;
    }

    /** Begins a step: its contacts are told apart from those of the step before. */
    public void begin() {
        ContactLog spare = older;
        older = last;
        last = now;
        now = spare;
        now.begin(last);
    }

    /** Keeps what a step changes that is about to begin. */
    public void keep() {
        kept.clear();
        bodies.forEach(body -> kept.add(body.copy()));
        keptTurn = impulses.turn();
        keptChanges = changes;
    }

    /** Takes a step back that was not made; whether it had begun. */
    public void undo(boolean hasBegun) {
        bodies.clear();
        bodies.addAll(kept);
        impulses.turn(keptTurn);
        changes = keptChanges;
        if (hasBegun) {
            ContactLog failed = now;
            now = last;
            last = older;
            older = failed;
            now.forgetNext();
        }
    }

    /** Moves all bodies by a time, which is the whole of a step that has begun. */
    public void run(double seconds, ContactSurfaces surfaces) {
        refresh();
        int slices = (int) Math.ceil(Math.min(MOST_SLICES, seconds / SLICE * (1 - 0x1p-40)));
        boolean isMoving = true;
        for (int k = 0; k < slices && isMoving; k++) {
            isMoving = slice(seconds / slices, surfaces);
        }
        touchAtRest();
        for (int b = 0; b < bodies.size(); b++) {
            RigidBody body = bodies.get(b);
            if (body.stop != null) {
                now.stop(b, body.id, body.stopper, body.stop);
            }
        }
    }

    /** Moves all bodies by a slice of time, one cluster after the other; false if all rest. */
    private boolean slice(double seconds, ContactSurfaces surfaces) {
        traction.begin(seconds);
        cluster.find(seconds);
        for (int b = 0; b < bodies.size(); b++) {
            bodies.get(b).isCarried = true; // of other clusters, none makes way
            bodies.get(b).group = b;
        }
        boolean any = false;
        int turn = impulses.turn();
        int latest = turn;
        for (int first = 0; first < bodies.size(); first++) {
            if (cluster.take(first)) {
                any = true;
                impulses.turn(turn); // so that no cluster is favoured by how many there are
                parts(seconds, surfaces);
                latest = Math.max(latest, impulses.turn());
            }
        }
        impulses.turn(latest);
        return any;
    }

    /** Moves a cluster by a slice of time, in parts that end where two of its bodies meet. */
    private void parts(double seconds, ContactSurfaces surfaces) {
        double left = seconds;
        for (int parts = 1; left > 0; parts++) {
            double made = part(left, parts < MOST_PARTS, surfaces);
            left = made < left ? left - made : 0;
        }
    }

    /** Takes over what others have done to the world since. */
    private void refresh() {
        boolean isNew = changes != placer.objects.changes();
        changes = placer.objects.changes();
        detection.clear(placer.objects.limit());
        for (int b = 0; b < bodies.size(); b++) {
            RigidBody body = bodies.get(b);
            detection.add(body.id, b);
            System.arraycopy(body.place, 0, known, 0, body.place.length);
            way.read(body);
            isNew |= !Arrays.equals(known, 0, body.place.length, body.place, 0, body.place.length);
            body.stop = null;
        }
        if (isNew) {
            bodies.forEach(RigidBody::wake);
            loosening.loosen();
        }
    }

    /**
     * Moves a cluster by a time, or for less where two bodies meet before; answers for how long.
     *
     * @param mayEnd whether it may end before
     */
    private double part(double seconds, boolean mayEnd, ContactSurfaces surfaces) {
        traction.begin(cluster, seconds);
        budget.begin(seconds);
        contacts.clear();
        for (int m = 0; m < cluster.count; m++) {
            if (!bodies.get(cluster.member[m]).isAsleep) {
                betweenParts.run();
                detection.gather(cluster.member[m], false);
            }
        }
        solve(seconds, surfaces);
        double share = mayEnd ? impact.first(cluster, seconds) : SpatialTimeOfImpact.NEVER;
        contacts.keep(share);
        tell();
        double made = share * seconds;
        carriage.act(-1, made);
        carriage.begin(share);
        sort();
        for (int k = 0; k < cluster.count; k++) {
            if (!bodies.get(order[k]).isAsleep) {
                betweenParts.run();
                carriage.carry(order[k], made, surfaces);
            }
        }
        budget.finish(made, free);
        return made;
    }

    private void solve(double seconds, ContactSurfaces surfaces) {
        impulses.solve(contacts, -1, false, seconds, TurningSweep.GAP, surfaces);
        for (int m = 0; m < cluster.count; m++) {
            carriage.fall(bodies.get(cluster.member[m]), seconds);
        }
        impulses.solve(contacts, -1, true, seconds, TurningSweep.GAP, surfaces);
    }

    /** The bodies of a cluster, the lowest first. */
    private void sort() {
        if (order.length < cluster.count) {
            order = new int[bodies.size()];
        }
        for (int k = 0; k < cluster.count; k++) {
            int b = cluster.member[k];
            double height = bodies.get(b).height(gravity);
            int to = k;
            while (to > 0 && bodies.get(order[to - 1]).height(gravity) > height) {
                order[to] = order[to - 1];
                to--;
            }
            order[to] = b;
        }
    }

    private final class Teller implements Integrator.ContactTeller {
        @Override
        public void tell() {
            SpatialStepper.this.tell();
        }

        @Override
        public void takeBack(Contacts of, int k, double impulse) {
            now.takeBack(bodies.get(of.body[k]).id, of.object[k], of.normal, 3 * k, impulse);
        }
    }

    private void tell() {
        for (int k = 0; k < contacts.count; k++) {
            note(k, contacts.impulse[k] > 0 ? contacts.impulse[k] : -1);
        }
        now.tell();
    }

    /** Notes a contact; of two bodies, the first is told to touch the other one. */
    private void note(int k, double impulse) {
        int own = bodies.get(contacts.body[k]).id;
        boolean isSecond = contacts.other[k] >= 0 && contacts.other[k] < contacts.body[k];
        double sign = isSecond ? -1 : 1;
        int c = 3 * k;
        now.note(
                isSecond ? contacts.object[k] : own,
                isSecond ? own : contacts.object[k],
                contacts.point[c],
                contacts.point[c + 1],
                contacts.point[c + 2],
                sign * contacts.normal[c] + 0.0,
                sign * contacts.normal[c + 1] + 0.0,
                sign * contacts.normal[c + 2] + 0.0,
                impulse);
    }

    /** Tells the contacts of what is at rest at the end. */
    private void touchAtRest() {
        contacts.clear();
        for (int b = 0; b < bodies.size(); b++) {
            if (bodies.get(b).isAsleep) {
                detection.gather(b, true);
            }
        }
        for (int k = 0; k < contacts.count; k++) {
            note(k, 0);
        }
        now.tell();
    }
}
