package robosim.geometry.dynamics.spatial;

import java.util.List;
import robosim.geometry.dynamics.planar.ContactLog;
import robosim.geometry.dynamics.planar.ContactSurfaces;
import robosim.geometry.engine.objects.ObjectTable;

/** Carries bodies through a slice of time, from collision to collision. */
final class Integrator {
    /** Most collisions of a body in a slice, and most of one that another moving body is beside, which moves on as well. */
    private static final int MOST_EVENTS = 32;

    private static final int MOST_AMONG_MOVING = 7;

    /**
     * After so many the body is parted from what it touches by ever more, twice as much each time: what slides over an edge at
     * several metres a second and turns as it does would meet it again after 50 microseconds, as the gap is 1e-8 m.
     */
    private static final int FEW_EVENTS = 3;

    private static final int MOST_DOUBLINGS = 10;

    /** Where it gets hardly any farther, by so many times twice as much. */
    private static final int IDLE_DOUBLINGS = 2;

    /** At most so fast, m/s. */
    private static final double PARTING = 0.25 * SequentialImpulses.BOUNCE;

    /** So often one after the other a body may get no farther than by such a share of what is left. */
    private static final int MOST_IDLE = 6;

    private static final int MOST_IDLE_AMONG_MOVING = 3;

    private static final double LITTLE = 0x1p-7;

    /** So many slices in a row a body waits for another one that moves out of its way, before it is stopped. */
    private static final int MOST_WAITS = 256;

    /** A contact is below a body if its normal is within 60 degrees of the vertical. */
    private static final double BELOW = 0.5;

    /** Lips that are lower are climbed, metres: what rounding leaves between objects that ought to be flush. */
    private static final double LIP = 1e-4;

    /** So many bodies in a row make way for each other. */
    private static final int MOST_AHEAD = 64;

    private final List<RigidBody> bodies;
    private final double[] gravity;
    private final TurningSweep way;
    private final RotationVectors turning = new RotationVectors();
    private final ContactDetection detection;
    private final SequentialImpulses impulses;
    private final Contacts contacts;
    private final Clusters cluster;
    private final ContactTeller tell;

    /** What acts on bodies from things that stand still until a part of a slice ends, or until they collide. */
    private final Contacts acting = new Contacts();

    private final double[] d = new double[3];
    private final double[] angle = new double[3];
    private final double[] middle = new double[ObjectTable.PLACE];
    private final double[] spare = new double[6];

    /** Takes what contacts give. */
    interface ContactTeller {
        /** Tells all contacts and impulses, after each collision. */
        void tell();

        /** Takes back that a contact, one of some, gives a body so many newton seconds. */
        void takeBack(Contacts of, int k, double impulse);
    }

    /** For some bodies. */
    Integrator(
            List<RigidBody> bodies,
            double[] gravity,
            TurningSweep way,
            ContactDetection detection,
            SequentialImpulses impulses,
            Contacts contacts,
            Clusters cluster,
            ContactTeller tell) {
        this.bodies = bodies;
        this.gravity = gravity;
        this.way = way;
        this.detection = detection;
        this.impulses = impulses;
        this.contacts = contacts;
        this.cluster = cluster;
        this.tell = tell;
    }

    /** Lets gravity act on a body from the beginning of a part: the velocity at the end of a time. */
    void fall(RigidBody body, double seconds) {
        body.begin();
        fallOn(body, seconds);
    }

    /** The same after a collision; what moving bodies gave it for the part it still gets, as they have the opposite. */
    private void fallOn(RigidBody body, double seconds) {
        if (body.isAsleep) {
            return;
        }
        for (int k = 0; k < 6; k++) {
            body.u[k] = body.v[k] + body.given[k];
        }
        for (int axis = 0; axis < 3; axis++) {
            body.u[axis] += gravity[axis] * seconds;
        }
        body.resist(seconds);
    }

    /** Lets a part of a slice begin, in which no body has been carried yet; it is a share of the time looked ahead. */
    void begin(double share) {
        for (int m = 0; m < cluster.count; m++) {
            RigidBody body = bodies.get(cluster.member[m]);
            body.isCarried = body.isAsleep;
            if (share < 1 && !body.isAsleep) {
                for (int k = 0; k < 6; k++) {
                    body.u[k] = body.v[k] + (body.u[k] - body.v[k]) * share;
                }
                body.keep(share);
                body.work -= body.lastWork * (1 - share);
                body.lastWork *= share;
            }
        }
    }

    /** Notes what goes on acting from things that stand still: on one body, or on all where that is below 0. */
    void act(int only, double seconds) {
        if (only < 0) {
            acting.clear();
        }
        for (int k = 0; k < contacts.count; k++) {
            int other = contacts.other[k];
            if (contacts.lasting[k] > 0 && (other < 0 || bodies.get(other).isAsleep)) {
                acting.add(contacts, k);
                acting.lasting[acting.count - 1] /= seconds;
            }
        }
    }

    /** Ends that for a body, which collides before the end. */
    private void endActing(int b, double rest) {
        int kept = 0;
        for (int k = 0; k < acting.count; k++) {
            if (acting.body[k] == b) {
                tell.takeBack(acting, k, acting.lasting[k] * rest);
            } else {
                acting.copy(k, kept++);
            }
        }
        acting.count = kept;
    }

    /** Carries a body through a slice unless that has been done. */
    void carry(int b, double seconds, ContactSurfaces surfaces) {
        if (!bodies.get(b).isCarried) {
            carry(b, seconds, surfaces, 0);
        }
    }

    /** Carries a body from collision to collision; what is in its way and has not been carried yet goes first. */
    private void carry(int b, double seconds, ContactSurfaces surfaces, int depth) {
        RigidBody body = bodies.get(b);
        body.isCarried = true;
        double rest = seconds;
        int idle = 0;
        boolean hasClimbed = false;
        for (int event = 0; event < MOST_EVENTS && idle < MOST_IDLE; event++) {
            for (int axis = 0; axis < 3; axis++) {
                d[axis] = 0.5 * (body.v[axis] + body.u[axis]) * rest;
            }
            spin(body, rest);
            System.arraycopy(body.place, 0, middle, 0, body.place.length);
            double share = way.go(body, d, angle);
            detection.join(b, way.keptOff);
            double time = share < 1 ? time(body, share, rest) : rest;
            arrive(body, time / rest);
            if (share >= 1) {
                body.waits = 0;
                return;
            }
            idle = share > LITTLE ? 0 : idle + 1;
            body.lastWork *= 1 - time / rest;
            rest -= time;
            if (!(rest > 0)) {
                System.arraycopy(body.v, 0, body.u, 0, 6);
                return;
            }
            boolean hasGone = false;
            for (int ahead = ahead(b, depth); ahead >= 0; ahead = ahead(b, depth)) {
                carry(ahead, seconds, surfaces, depth + 1);
                hasGone = true;
            }
            if (!hasGone && !hasClimbed && climbs(b)) {
                hasClimbed = true;
            } else if (!hasGone) {
                hit(b, rest, event < FEW_EVENTS && idle == 0 ? 0 : event + idle * IDLE_DOUBLINGS, surfaces);
            }
            if ((event >= MOST_AMONG_MOVING || idle >= MOST_IDLE_AMONG_MOVING) && isBesideMoving()) {
                break;
            }
        }
        if (body.waits < MOST_WAITS && isBesideMoving()) {
            // Who slides over a face that has turned meanwhile lacks a little of its way, and does not wait.
            body.waits = rest < seconds / 2 ? 0 : body.waits + 1;
            System.arraycopy(body.u, 0, body.v, 0, 6);
            return;
        }
        if (rest < seconds / 2 && !isBesideMoving()) {
            System.arraycopy(body.u, 0, body.v, 0, 6); // delayed by less than half of a slice
            return;
        }
        if (body.stop == null) {
            explain(b, idle > 0 || body.waits > 0 ? ContactLog.Cause.BLOCKED : ContactLog.Cause.COLLISIONS);
        }
        for (int k = 0; k < 6; k++) {
            body.v[k] = 0.5 * body.u[k];
            body.u[k] = body.v[k];
        }
    }

    /** Gives a body the velocity after a share of the time that was left to it, in which it has come to where it is. */
    private void arrive(RigidBody body, double share) {
        for (int k = 0; k < 6; k++) {
            spare[k] = share < 1 ? body.v[k] + (body.u[k] - body.v[k]) * share : body.u[k];
        }
        body.exchange(middle, spare, share, about());
        body.keep(1 - share);
        if (body.isBall) {
            System.arraycopy(spare, 0, body.v, 0, 6);
            return;
        }
        System.arraycopy(spare, 0, body.v, 0, 3);
        body.keepMomentum(middle, spare, body.place, body.v, 3);
        body.keepMomentum(middle, body.u, body.place, spare, 3);
        System.arraycopy(spare, 3, body.u, 3, 3);
        body.turnInertia();
    }

    private double[] about() {
        return bodies.get(cluster.member[0]).start;
    }

    /** Keeps why a body is stopped, and by what: of all that it touches, what is against its last displacement most. */
    private void explain(int b, ContactLog.Cause cause) {
        RigidBody body = bodies.get(b);
        body.stop = way.isFree(body) ? cause : ContactLog.Cause.OVERLAP;
        if (body.stop == ContactLog.Cause.OVERLAP) {
            body.stopper = detection.overlapped(body);
            return;
        }
        contacts.clear();
        detection.gather(b, true);
        double most = Double.POSITIVE_INFINITY;
        body.stopper = -1;
        for (int k = 0; k < contacts.count; k++) {
            double along = up(k, d);
            if (along < most) {
                most = along;
                body.stopper = contacts.object[k];
            }
        }
    }

    /** Whether a body that moves is among those that were touched last. */
    private boolean isBesideMoving() {
        for (int k = 0; k < contacts.count; k++) {
            int other = contacts.other[k];
            if (other >= 0 && !bodies.get(other).isAsleep) {
                return true;
            }
        }
        return false;
    }

    /** A body that is in the way of another one and has not been carried yet; -1 for none. */
    private int ahead(int b, int depth) {
        if (depth == MOST_AHEAD) {
            return -1;
        }
        contacts.clear();
        detection.gather(b, true);
        for (int k = 0; k < contacts.count; k++) {
            int other = contacts.other[k];
            if (other >= 0 && !bodies.get(other).isCarried && !bodies.get(other).isAsleep) {
                return other;
            }
        }
        return -1;
    }

    /** Lifts a body over a lip that is in its way, if that is low; the energy that it takes is taken from its speed. */
    private boolean climbs(int b) {
        contacts.clear();
        detection.gather(b, true);
        int ground = -1;
        for (int k = 0; k < contacts.count; k++) {
            if (up(k, gravity) < -BELOW * RigidBody.length(gravity, 0)
                    && (ground < 0 || contacts.apart[k] < contacts.apart[ground])) {
                ground = k;
            }
        }
        double lip = ground < 0 ? 0 : lip(ground);
        if (lip <= 0) {
            return false;
        }
        double lift = lip + 2 * TurningSweep.GAP;
        int n = 3 * ground;
        double[] normal = contacts.normal;
        return way.lift(bodies.get(b), lift * normal[n], lift * normal[n + 1], lift * normal[n + 2]);
    }

    private double up(int k, double[] along) {
        return contacts.normal[3 * k] * along[0]
                + contacts.normal[3 * k + 1] * along[1]
                + contacts.normal[3 * k + 2] * along[2];
    }

    /** The height of the highest lip beside a body, above the ground at a contact; 0 for none that is low. */
    private double lip(int ground) {
        double highest = 0;
        for (int k = 0; k < contacts.count; k++) {
            double high = isGround(k, ground) ? 0 : detection.height(k, ground);
            // A piece that rises farther on is as high as where it touches.
            double beside = 0;
            for (int m = 0; m < contacts.count; m++) {
                if (contacts.piece[m] == contacts.piece[k] && !isGround(m, ground)) {
                    beside = Math.max(beside, height(m, ground));
                }
            }
            high = high < LIP ? high : beside;
            highest = high < LIP ? Math.max(highest, high) : highest;
        }
        return highest;
    }

    private boolean isGround(int k, int ground) {
        double same = 0;
        for (int axis = 0; axis < 3; axis++) {
            same += contacts.normal[3 * k + axis] * contacts.normal[3 * ground + axis];
        }
        return same > BELOW;
    }

    private double height(int k, int ground) {
        double high = 0;
        for (int axis = 0; axis < 3; axis++) {
            high += (contacts.point[3 * k + axis] - contacts.point[3 * ground + axis])
                    * contacts.normal[3 * ground + axis];
        }
        return high;
    }

    /** The angle by which a body turns in a time: of one that turns freely, with the velocity halfway (midpoint method). */
    private void spin(RigidBody body, double seconds) {
        for (int axis = 0; axis < 3; axis++) {
            angle[axis] = 0.5 * (body.v[3 + axis] + body.u[3 + axis]) * seconds;
        }
        if (body.isBall || body.isTouching) {
            return;
        }
        for (int axis = 0; axis < 3; axis++) {
            angle[axis] *= 0.5;
        }
        turning.turn(body.place, angle, 1, middle);
        body.keepMomentum(body.place, body.u, middle, spare, 3);
        for (int axis = 0; axis < 3; axis++) {
            angle[axis] = spare[3 + axis] * seconds;
        }
    }

    /** When a share of the way was made that begins with one velocity and ends with another one. */
    private double time(RigidBody body, double share, double rest) {
        double way = RigidBody.length(d, 0);
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
    private void hit(int b, double rest, int doublings, ContactSurfaces surfaces) {
        RigidBody body = bodies.get(b);
        body.work -= body.lastWork;
        body.lastWork = 0;
        endActing(b, rest);
        contacts.clear();
        detection.gather(b, true);
        for (int k = 0; k < contacts.count; k++) {
            remember(contacts.other[k]);
            body.isAmongOthers |= isElsewhere(contacts.other[k]); // its cluster has not all of the momentum
            body.isHeld |= body.isAmongOthers;
        }
        double gap = TurningSweep.GAP;
        if (doublings > 0 && !isBesideMoving()) {
            regain(body);
            gap = Math.max(gap, Math.min(gap * (1 << Math.min(MOST_DOUBLINGS, doublings)), 4 * PARTING * rest));
        }
        impulses.solve(contacts, b, false, rest, gap, surfaces);
        for (int k = 0; k < contacts.count; k++) {
            pass(contacts.other[k]);
        }
        body.release();
        fallOn(body, rest);
        impulses.solve(contacts, b, true, rest, gap, surfaces);
        for (int k = 0; k < contacts.count; k++) {
            settle(body, contacts.other[k]);
        }
        act(b, rest);
        tell.tell();
    }

    /** Moves a body away from what it has come nearer to than gaps are: no direction would separate the two on any way. */
    private void regain(RigidBody body) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int k = 0; k < contacts.count; k++) {
            if (contacts.apart[k] < TurningSweep.GAP / 2) {
                x += contacts.normal[3 * k];
                y += contacts.normal[3 * k + 1];
                z += contacts.normal[3 * k + 2];
            }
        }
        double size = Math.sqrt(x * x + y * y + z * z);
        if (size > 0.1) {
            double by = TurningSweep.GAP / size;
            way.lift(body, by * x, by * y, by * z);
        }
    }

    private boolean isElsewhere(int other) {
        return other >= 0 && !bodies.get(other).isAsleep && !cluster.has(other);
    }

    /**
     * Notes how another body moves before a collision. One of another cluster, which was farther away than the two could come,
     * but for what others gave them, has its slice before or after: it gets all at once.
     */
    private void remember(int other) {
        if (other >= 0) {
            RigidBody body = bodies.get(other);
            System.arraycopy(body.v, 0, body.known, 0, 6);
            if (isElsewhere(other)) {
                System.arraycopy(body.v, 0, body.u, 0, 6);
                body.energy = body.kinetic(body.v);
            }
        }
    }

    /** Lets a body of another cluster keep what it got; the energy counts as work. */
    private void settle(RigidBody body, int other) {
        if (isElsewhere(other)) {
            RigidBody hit = bodies.get(other);
            double now = hit.kinetic(hit.u);
            body.work -= now - hit.energy;
            hit.energy = now;
            System.arraycopy(hit.u, 0, hit.v, 0, 6);
        }
    }

    /** What another body was given now, it has at the end of the slice too; once. */
    private void pass(int other) {
        if (other >= 0) {
            RigidBody body = bodies.get(other);
            for (int k = 0; k < 6; k++) {
                body.u[k] += body.v[k] - body.known[k];
                body.known[k] = body.v[k];
            }
        }
    }
}
