package robosim.geometry.dynamics.space;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import robosim.geometry.dynamics.step.Surfaces;
import robosim.geometry.engine.motion.Carrier;
import robosim.geometry.engine.motion.Placer;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * Moves rigid bodies in space by slices of time: impulses where they touch, then gravity against what holds them, and then
 * each is carried to its next contact, the lowest first.
 */
public final class Space {
    /** Slices last so many seconds, or more where a step would have too many of them. */
    private Runnable breath = () -> {};

    private static final double SLICE = 1e-3;

    private static final int MOST_SLICES = 10_000;

    /** Contacts are looked for within so many metres. */
    private static final double TOUCH = 1e-4;

    /** Most collisions of a body in a slice. */
    private static final int MOST_EVENTS = 8;

    /** So often one after the other a body may get no farther than by such a share of what is left. */
    private static final int MOST_IDLE = 3;

    private static final double LITTLE = 0x1p-7;

    private final Placer placer;
    private final double[] gravity;
    private final List<Rigid> bodies = new ArrayList<>();
    private final Ledger ledger;
    private final Nearby near;
    private final Way way;
    private final Meeting meeting = new Meeting();
    private final Impulses impulses = new Impulses(bodies);
    private final Contacts contacts = new Contacts();
    private final LeafColumn leaf = new LeafColumn(1);
    private final double[] d = new double[3];
    private final double[] angle = new double[3];
    private final double[] middle = new double[21];
    private final double[] spare = new double[6];
    private int[] bodyOf = new int[0];
    private int[] order = new int[0];
    private Touched now = new Touched();
    private Touched last = new Touched();
    private long changes = -1;

    /**
     * No bodies so far.
     *
     * @param gravity three numbers, m/s^2
     */
    public Space(Carrier carrier, double width, double height, double length, double[] gravity) {
        placer = carrier.placer();
        near = new Nearby(placer, new double[] {width / 2, height / 2, length / 2});
        way = new Way(placer, near);
        this.gravity = gravity.clone();
        ledger = new Ledger(bodies, this.gravity);
    }

    /** Whether a world is one in which bodies can move. */
    public static boolean isExact(Carrier carrier) {
        return carrier.placer().isExact();
    }

    /** Forgets all bodies. */
    public void clear() {
        bodies.clear();
        changes = -1;
    }

    /** Adds a body at rest; answers its index. */
    public int add(int id, double mass, double[] moments, boolean isBall, double reach) {
        Rigid body = new Rigid(id, mass, moments, isBall, reach);
        way.read(body);
        bodies.add(body);
        return bodies.size() - 1;
    }

    /** Sets what slows a body, and its limits; radians. */
    public void limit(int b, double damping, double turnDamping, double maxSpeed, double maxTurn) {
        Rigid body = bodies.get(b);
        body.damping = damping;
        body.turnDamping = turnDamping;
        body.maxSpeed = maxSpeed;
        body.maxTurn = maxTurn;
    }

    /** The velocity of a body: six numbers, m/s and radians a second about the world's axes. */
    public void velocity(int b, double[] out) {
        System.arraycopy(bodies.get(b).v, 0, out, 0, 6);
    }

    /** Sets the velocity of a body and wakes it, unless it is the one that it has. */
    public void setVelocity(int b, double[] to) {
        Rigid body = bodies.get(b);
        if (!Arrays.equals(body.v, to)) {
            System.arraycopy(to, 0, body.v, 0, 6);
            body.wake();
        }
    }

    /** Whether a body was stopped in the last step. */
    public boolean isStopped(int b) {
        return bodies.get(b).isStopped;
    }

    /** The contacts of the last step, and of the one before. */
    public Touched touched() {
        return now;
    }

    public Touched before() {
        return last;
    }

    /** Runs something between two bodies in each part of a step, so that a long one gives way to others. */
    public void pausing(Runnable between) {
        breath = between;
    }

    /** Moves all bodies by a time. */
    public void run(double seconds, Surfaces surfaces) {
        Touched older = last;
        last = now;
        now = older;
        now.clear();
        refresh();
        int slices = (int) Math.ceil(Math.min(MOST_SLICES, seconds / SLICE * (1 - 0x1p-40)));
        for (int k = 0; k < slices; k++) {
            if (!slice(seconds / slices, surfaces)) {
                break;
            }
        }
        touchAtRest();
    }

    /** Takes over what others have done to the world since. */
    private void refresh() {
        boolean isNew = changes != placer.objects.changes();
        changes = placer.objects.changes();
        if (bodyOf.length < placer.objects.limit()) {
            bodyOf = new int[placer.objects.limit() + 16];
        }
        Arrays.fill(bodyOf, -1);
        for (int b = 0; b < bodies.size(); b++) {
            Rigid body = bodies.get(b);
            bodyOf[body.id] = b;
            System.arraycopy(body.place, 0, middle, 0, body.place.length);
            way.read(body);
            isNew |= !Arrays.equals(middle, 0, body.place.length, body.place, 0, body.place.length);
            body.isStopped = false;
        }
        if (isNew) {
            bodies.forEach(Rigid::wake);
        }
    }

    private int bodyOf(int object) {
        return object < 0 || object >= bodyOf.length ? -1 : bodyOf[object];
    }

    /** Moves all bodies by a slice of time; false if all rest. */
    private boolean slice(double seconds, Surfaces surfaces) {
        boolean any = false;
        for (Rigid body : bodies) {
            any |= !body.isAsleep;
        }
        if (!any) {
            return false;
        }
        ledger.begin(seconds);
        contacts.clear();
        for (int b = 0; b < bodies.size(); b++) {
            if (!bodies.get(b).isAsleep) {
                breath.run();
                gather(b, false);
            }
        }
        solve(seconds, surfaces);
        tell();
        sort();
        for (int k = 0; k < bodies.size(); k++) {
            if (!bodies.get(order[k]).isAsleep) {
                breath.run();
                carry(order[k], seconds, surfaces);
            }
        }
        ledger.finish(seconds);
        return true;
    }

    private void solve(double seconds, Surfaces surfaces) {
        impulses.solve(contacts, 0, false, seconds, Way.GAP, surfaces);
        for (Rigid body : bodies) {
            fall(body, seconds);
        }
        impulses.solve(contacts, 0, true, seconds, Way.GAP, surfaces);
    }

    private void fall(Rigid body, double seconds) {
        if (body.isAsleep) {
            return;
        }
        System.arraycopy(body.v, 0, body.u, 0, 6);
        for (int axis = 0; axis < 3; axis++) {
            body.u[axis] += gravity[axis] * seconds;
        }
    }

    /** Finds the contacts of a body; those with other bodies that will find them too only if asked. */
    private void gather(int b, boolean all) {
        Rigid body = bodies.get(b);
        near.find(body, 0, 0, 0, body.reach + TOUCH);
        near.leaf(body, body.place, leaf);
        int from = contacts.count;
        for (int k = 0; k < near.count; k++) {
            int other = bodyOf(near.object[k]);
            if (other >= 0 && !all && other < b && !bodies.get(other).isAsleep) {
                continue;
            }
            int at = k * Leaf.STRIDE;
            if (meeting.measure(leaf.kind(0), leaf.rows(), 0, near.kind[k], near.rows, at) && meeting.apart <= TOUCH) {
                body.isTouching = true;
                if (other >= 0) {
                    ledger.join(b, other);
                }
                meeting.points(
                        leaf.kind(0),
                        leaf.rows(),
                        0,
                        near.kind[k],
                        near.rows,
                        at,
                        b,
                        other,
                        near.object[k],
                        TOUCH,
                        contacts);
            }
        }
        contacts.dropInnerEdges(from);
    }

    /** The bodies, the lowest first. */
    private void sort() {
        if (order.length != bodies.size()) {
            order = new int[bodies.size()];
            for (int k = 0; k < order.length; k++) {
                order[k] = k;
            }
        }
        for (int k = 1; k < order.length; k++) {
            int b = order[k];
            double height = bodies.get(b).height(gravity);
            int to = k;
            while (to > 0 && bodies.get(order[to - 1]).height(gravity) > height) {
                order[to] = order[to - 1];
                to--;
            }
            order[to] = b;
        }
    }

    /** Carries a body through a slice, from collision to collision. */
    private void carry(int b, double seconds, Surfaces surfaces) {
        Rigid body = bodies.get(b);
        double rest = seconds;
        int idle = 0;
        for (int event = 0; event < MOST_EVENTS && idle < MOST_IDLE; event++) {
            for (int axis = 0; axis < 3; axis++) {
                d[axis] = 0.5 * (body.v[axis] + body.u[axis]) * rest;
            }
            spin(body, rest);
            System.arraycopy(body.place, 0, middle, 0, body.place.length);
            double share = way.go(body, d, angle);
            if (!body.isBall) {
                body.keepMomentum(middle, body.u, body.place, spare, 3);
                System.arraycopy(spare, 3, body.u, 3, 3);
                body.turnInertia();
            }
            if (share >= 1) {
                System.arraycopy(body.u, 0, body.v, 0, 6);
                return;
            }
            idle = share > LITTLE ? 0 : idle + 1;
            double time = time(body, share, rest);
            for (int k = 0; k < 6; k++) {
                body.v[k] += (body.u[k] - body.v[k]) * (time / rest);
            }
            rest -= time;
            if (!(rest > 0)) {
                System.arraycopy(body.v, 0, body.u, 0, 6);
                return;
            }
            hit(b, rest, surfaces);
        }
        body.isStopped = true;
        for (int k = 0; k < 6; k++) {
            body.v[k] = 0.5 * body.u[k];
            body.u[k] = body.v[k];
        }
    }

    /** The angle by which a body turns in a time: of one that turns freely, with the velocity halfway (midpoint method). */
    private void spin(Rigid body, double seconds) {
        for (int axis = 0; axis < 3; axis++) {
            angle[axis] = 0.5 * (body.v[3 + axis] + body.u[3 + axis]) * seconds;
        }
        if (body.isBall || body.isTouching) {
            return;
        }
        for (int axis = 0; axis < 3; axis++) {
            angle[axis] *= 0.5;
        }
        way.turn(body.place, angle, 1, middle);
        body.keepMomentum(body.place, body.u, middle, spare, 3);
        for (int axis = 0; axis < 3; axis++) {
            angle[axis] = spare[3 + axis] * seconds;
        }
    }

    /** When a share of the way was made that begins with one velocity and ends with another one. */
    private double time(Rigid body, double share, double rest) {
        double way = Rigid.length(d, 0);
        if (way == 0) {
            return share * rest;
        }
        double begins = (body.v[0] * d[0] + body.v[1] * d[1] + body.v[2] * d[2]) / way;
        double ends = (body.u[0] * d[0] + body.u[1] * d[1] + body.u[2] * d[2]) / way;
        double gains = (ends - begins) / rest;
        double made = share * way;
        double root = begins * begins + 2 * gains * made;
        double sum = begins + Math.sqrt(Math.max(0, root));
        double time = root > 0 && sum > 0 ? 2 * made / sum : share * rest;
        return Math.max(0, Math.min(rest, time));
    }

    /** Resolves the collision of a body that has met something on its way. */
    private void hit(int b, double rest, Surfaces surfaces) {
        Rigid body = bodies.get(b);
        contacts.clear();
        gather(b, true);
        for (int k = 0; k < contacts.count; k++) {
            remember(contacts.other[k]);
        }
        impulses.solve(contacts, 0, false, rest, Way.GAP, surfaces);
        for (int k = 0; k < contacts.count; k++) {
            pass(contacts.other[k]);
        }
        fall(body, rest);
        impulses.solve(contacts, 0, true, rest, Way.GAP, surfaces);
        tell();
    }

    private void remember(int other) {
        if (other >= 0) {
            Rigid body = bodies.get(other);
            System.arraycopy(body.v, 0, body.known, 0, 6);
        }
    }

    /** What another body was given now, it has at the end of the slice too; once. */
    private void pass(int other) {
        if (other >= 0) {
            Rigid body = bodies.get(other);
            for (int k = 0; k < 6; k++) {
                body.u[k] += body.v[k] - body.known[k];
                body.known[k] = body.v[k];
            }
        }
    }

    private void tell() {
        for (int k = 0; k < contacts.count; k++) {
            if (contacts.impulse[k] > 0) {
                tell(k);
            }
        }
    }

    private void tell(int k) {
        now.add(contacts, k, bodies.get(contacts.body[k]).id, placer.objects);
    }

    /** Tells the contacts of what is at rest at the end. */
    private void touchAtRest() {
        contacts.clear();
        for (int b = 0; b < bodies.size(); b++) {
            if (bodies.get(b).isAsleep) {
                gather(b, true);
            }
        }
        for (int k = 0; k < contacts.count; k++) {
            tell(k);
        }
    }
}
