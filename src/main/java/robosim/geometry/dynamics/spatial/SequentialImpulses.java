package robosim.geometry.dynamics.spatial;

import java.util.List;
import robosim.geometry.dynamics.planar.ContactSurfaces;

/**
 * Impulses at contacts, one after the other until nothing changes any more (Catto 2005): Newton's restitution, and Coulomb's
 * friction within its cone.
 */
final class SequentialImpulses {
    /** Slower approaches do not bounce, m/s: twice what gravity makes of rest in a slice. */
    static final double BOUNCE = 0.02;

    /** Whatever slides more slowly sticks as long as static friction can hold it, m/s. */
    private static final double STICK = 1e-4;

    private static final int MOST_ROUNDS = 200;

    /** What static friction holds slides more slowly, m/s. */
    private static final double SLIP = 1e-5;

    /** The same where all contacts give all the friction that they can. */
    private static final double SLIP_AT_MOST = 2e-8;

    private static final double ALL = 1 - 1e-6;

    /** What is too near is parted in no less, seconds: else it would hop, and not be driven until it is down again. */
    private static final double PARTS = 1e-3;

    /** So often contacts are found to slide that were not. */
    private static final int MOST_SLIPS = 4;

    /** Impulses that change a velocity by less than so many m/s no longer count. */
    private static final double SMALL = 1e-9;

    /** Speeds at contacts that are off by at most so many m/s may come of solutions that are not exact. */
    private static final double INEXACT = 1e-6;

    private final List<RigidBody> bodies;

    private double[] target = new double[0];
    private double[] pushed = new double[0];
    private double[] rubbed = new double[0];
    private double[] tangents = new double[0];
    private double[] ease = new double[0];
    private double[] friction = new double[0];
    private boolean[] isOff = new boolean[0];

    /** In which order contacts get their impulses, and how often it has changed. */
    private int[] order = new int[0];

    private int turn;

    /** Of contacts below a driven body, that body, and else -1; and friction while wheels slide. */
    private int[] wheel = new int[0];

    private double[] slides = new double[0];

    /** From the centres of both bodies to the point, three numbers each. */
    private double[] arms = new double[0];

    private final Traction traction;
    private final RollingResistance rolling;

    SequentialImpulses(List<RigidBody> bodies, Traction traction) {
        this.bodies = bodies;
        this.traction = traction;
        rolling = new RollingResistance(bodies);
    }

    /** Begins anew with the order of contacts. */
    void clear() {
        turn = 0;
    }

    /** How often the order has changed. */
    int turn() {
        return turn;
    }

    void turn(int to) {
        turn = to;
    }

    private double[] velocity(int b, boolean atEnd) {
        RigidBody body = bodies.get(b);
        return atEnd ? body.u : body.v;
    }

    /** Whether impulses move a body; what sleeps stands still until it is woken. */
    private boolean isMoved(int b) {
        return b >= 0 && !bodies.get(b).isAsleep;
    }

    /**
     * Gives impulses.
     *
     * @param driven  the one body whose drive acts, or -1 for all
     * @param atEnd   whether to the velocities at the end of the slice, and then without restitution, but with drives
     * @param seconds what is left of the slice
     * @param gap     nearer than this bodies are kept from coming
     */
    void solve(Contacts contacts, int driven, boolean atEnd, double seconds, double gap, ContactSurfaces surfaces) {
        reserve(contacts.count);
        rolling.begin(contacts.count);
        boolean any = false;
        for (int k = 0; k < contacts.count; k++) {
            any |= prepare(contacts, k, atEnd, seconds, gap, surfaces);
        }
        turn += atEnd ? 0 : 1;
        arrange(contacts);
        if (atEnd) {
            traction.prepare(contacts, wheel, isOff, driven, seconds);
        }
        if (any) {
            iterate(contacts, atEnd);
        }
        if (any && spread(contacts, atEnd)) {
            iterate(contacts, atEnd);
        }
        for (int k = 0; any && k < MOST_SLIPS && slips(contacts, atEnd); k++) {
            iterate(contacts, atEnd);
        }
        for (int k = 0; k < contacts.count; k++) {
            if (!isOff[k]) {
                contacts.impulse[k] += pushed[k];
                contacts.lasting[k] = atEnd ? pushed[k] : 0;
            }
        }
        if (atEnd) {
            lend(contacts, seconds);
            traction.finish();
        }
    }

    /**
     * Notes what impulses do over the little by which solutions are not exact, and the most that they would over a gap: bodies
     * stay within it, so that what it lends comes back.
     */
    private void lend(Contacts c, double seconds) {
        for (int k = 0; k < c.count; k++) {
            if (!isOff[k] && pushed[k] > 0 && target[k] <= 0) {
                double mean = 0.5 * (speed(c, k, c.normal, 3 * k, false) + speed(c, k, c.normal, 3 * k, true));
                RigidBody body = bodies.get(c.body[k]);
                body.lends += pushed[k] * Math.max(0, Math.min(mean, 0.5 * INEXACT));
                body.mostLent += pushed[k] / seconds * TurningSweep.GAP;
            }
        }
    }

    /** Gives impulses until they change nothing any more. */
    private void iterate(Contacts contacts, boolean atEnd) {
        for (int round = 0; round < MOST_ROUNDS; round++) {
            double most = 0;
            for (int at = 0; at < contacts.count; at++) {
                int k = order[at];
                if (!isOff[k]) {
                    most = Math.max(most, push(contacts, k, atEnd));
                    most = Math.max(most, rub(contacts, k, atEnd));
                    most = Math.max(most, rolling.resist(contacts, k, pushed[k], atEnd));
                }
            }
            if (atEnd) {
                most = Math.max(most, traction.roll(contacts, wheel, pushed, friction, slides));
            }
            if (most < SMALL) {
                break;
            }
        }
    }

    /**
     * Spreads the friction between two bodies, or of one with all that stands still, over their contacts as they are pressed,
     * where all give what they can and slide; whether there are any. What early rounds have left of one that pulls against
     * another hardly turns any more then, and would lack where it is needed.
     */
    private boolean spread(Contacts c, boolean atEnd) {
        boolean any = false;
        for (int k = 0; k < c.count; k++) {
            if (isHeld(k) && isAtMost(c, k, atEnd)) {
                spread(c, k, atEnd);
                any = true;
            }
        }
        return any;
    }

    private void spread(Contacts c, int of, boolean atEnd) {
        double x = 0;
        double y = 0;
        double z = 0;
        double all = 0;
        for (int k = 0; k < c.count; k++) {
            if (isBeside(c, of, k)) {
                double s = rubbed[2 * k];
                double t = rubbed[2 * k + 1];
                x += s * tangents[6 * k] + t * tangents[6 * k + 3];
                y += s * tangents[6 * k + 1] + t * tangents[6 * k + 4];
                z += s * tangents[6 * k + 2] + t * tangents[6 * k + 5];
                all += pushed[k];
            }
        }
        for (int k = 0; k < c.count; k++) {
            if (isBeside(c, of, k)) {
                double share = pushed[k] / all;
                for (int which = 0; which < 2; which++) {
                    int at = 6 * k + 3 * which;
                    double along = x * tangents[at] + y * tangents[at + 1] + z * tangents[at + 2];
                    double by = share * along - rubbed[2 * k + which];
                    rubbed[2 * k + which] += by;
                    give(c, k, tangents, at, by, atEnd);
                }
            }
        }
    }

    /** Whether static friction may hold a contact. */
    private boolean isHeld(int k) {
        return !isOff[k] && wheel[k] < 0 && pushed[k] > 0 && friction[k] > slides[k];
    }

    /** Whether a contact presses the same two bodies as another one, or the same one against something that stands still. */
    private boolean isBeside(Contacts c, int k, int m) {
        return !isOff[m] && pushed[m] > 0 && c.body[m] == c.body[k] && c.other[m] == c.other[k];
    }

    /** Whether all contacts beside one slide and give all the friction that they can: one often does where others still hold. */
    private boolean isAtMost(Contacts c, int of, boolean atEnd) {
        boolean isAll = true;
        for (int k = 0; isAll && k < c.count; k++) {
            if (isBeside(c, of, k)) {
                double given = Math.sqrt(rubbed[2 * k] * rubbed[2 * k] + rubbed[2 * k + 1] * rubbed[2 * k + 1]);
                isAll = given >= ALL * friction[k] * pushed[k] && slidesBy(c, k, atEnd) > SLIP_AT_MOST;
            }
        }
        return isAll;
    }

    /** Lets those slide that static friction has not held; whether there are any. */
    private boolean slips(Contacts c, boolean atEnd) {
        boolean any = false;
        for (int k = 0; k < c.count; k++) {
            if (isHeld(k) && (slidesBy(c, k, atEnd) > SLIP || isAtMost(c, k, atEnd))) {
                friction[k] = slides[k];
                any = true;
            }
        }
        return any;
    }

    /**
     * Puts the contacts in order. Where there are several solutions, as for who carries how much of a box on four corners, which
     * one is found depends on it: so those of two pieces take turns, each of them to be the first, one way round and the other,
     * and no side is favoured in the long run.
     */
    private void arrange(Contacts c) {
        int to;
        for (int from = 0; from < c.count; from = to) {
            to = from + 1;
            while (to < c.count && isSamePair(c, from, to)) {
                to++;
            }
            int size = to - from;
            int first = (turn >>> 1) % size;
            for (int k = 0; k < size; k++) {
                int next = (turn & 1) == 0 ? first + k : first + size - k;
                order[from + k] = from + next % size;
            }
        }
    }

    private static boolean isSamePair(Contacts c, int a, int b) {
        return c.body[a] == c.body[b] && c.object[a] == c.object[b] && c.piece[a] == c.piece[b];
    }

    private void reserve(int count) {
        if (target.length < count) {
            int room = 2 * count;
            target = new double[room];
            order = new int[room];
            pushed = new double[room];
            friction = new double[room];
            slides = new double[room];
            wheel = new int[room];
            rubbed = new double[2 * room];
            tangents = new double[6 * room];
            arms = new double[6 * room];
            ease = new double[2 * room];
            isOff = new boolean[room];
        }
    }

    private boolean prepare(Contacts c, int k, boolean atEnd, double seconds, double gap, ContactSurfaces surfaces) {
        pushed[k] = 0;
        wheel[k] = -1;
        rubbed[2 * k] = 0;
        rubbed[2 * k + 1] = 0;
        reach(c, k);
        int own = bodies.get(c.body[k]).id;
        int other = c.object[k];
        double before = speed(c, k, c.normal, 3 * k, false);
        double apart = c.apart[k];
        // A contact that is not closed yet and approaches fast enough to bounce is solved when it closes. But a rim
        // that
        // lands almost flat touches the floor at one point after the other within microseconds: as the gap grows, all
        // contacts within it are solved together.
        boolean isBall = bodies.get(c.body[k]).isBall;
        isOff[k] = before < -BOUNCE && apart > (isBall ? 4 * gap : Math.max(TurningSweep.THERE, gap));
        if (isOff[k]) {
            return false;
        }
        boolean bounces = !atEnd && before < -BOUNCE;
        if (bounces) {
            target[k] = -before * surfaces.mixRestitution(surfaces.restitution(own), surfaces.restitution(other));
        } else if (apart > 2 * gap) {
            target[k] = -(apart - 2 * gap) / seconds;
        } else {
            double time = gap > TurningSweep.GAP ? seconds : Math.max(seconds, PARTS);
            target[k] = apart < gap / 4 ? (gap / 4 - apart) / time : 0;
        }
        if (atEnd && before > INEXACT) {
            // What separates now and is caught up with comes back at most as fast as it goes: then no impulse in
            // between
            // does work.
            target[k] = Math.min(target[k], -before);
        }
        makeTangents(c, k);
        ease[2 * k] = 1 / lightness(c, k, c.normal, 3 * k);
        // One for both, so that what slides is rubbed straight against its way.
        ease[2 * k + 1] = 1 / Math.max(lightness(c, k, tangents, 6 * k), lightness(c, k, tangents, 6 * k + 3));
        rubs(c, k, own, other, surfaces);
        rolling.prepare(c, k);
        return true;
    }

    /** Works out the friction at a contact: of wheels that stand still, and for all else as it slides now. */
    private void rubs(Contacts c, int k, int own, int other, ContactSurfaces surfaces) {
        double floor = floor(c, k, c.body[k], 1);
        double otherFloor = c.other[k] < 0 ? 0 : floor(c, k, c.other[k], -1);
        double still = surfaces.mixFriction(
                Math.max(floor, surfaces.staticFriction(own)), Math.max(otherFloor, surfaces.staticFriction(other)));
        double sliding = surfaces.mixFriction(
                Math.max(floor, surfaces.slidingFriction(own)), Math.max(otherFloor, surfaces.slidingFriction(other)));
        slides[k] = sliding;
        friction[k] = wheel[k] >= 0 || slidesBy(c, k, false) <= STICK ? still : sliding;
    }

    /** A body's own friction with a floor, where the contact is below it, which may make that one of its wheels. */
    private double floor(Contacts c, int k, int b, double sign) {
        RigidBody body = bodies.get(b);
        boolean isWheel = Traction.isBelow(body, c.normal, 3 * k, sign);
        if (isWheel && wheel[k] < 0) {
            wheel[k] = b;
        }
        return isWheel || traction.carries(c.normal, 3 * k, sign) ? body.floorFriction : 0;
    }

    private double slidesBy(Contacts c, int k, boolean atEnd) {
        double s = speed(c, k, tangents, 6 * k, atEnd);
        double t = speed(c, k, tangents, 6 * k + 3, atEnd);
        return Math.sqrt(s * s + t * t);
    }

    /** The speed at which the body leaves the other one along a direction. */
    private double speed(Contacts c, int k, double[] along, int at, boolean atEnd) {
        double sum = speed(velocity(c.body[k], atEnd), 6 * k, along, at);
        return isMoved(c.other[k]) ? sum - speed(velocity(c.other[k], atEnd), 6 * k + 3, along, at) : sum;
    }

    private double speed(double[] v, int arm, double[] along, int at) {
        double[] r = arms;
        double x = v[0] + (v[4] * r[arm + 2] - v[5] * r[arm + 1]);
        double y = v[1] + (v[5] * r[arm] - v[3] * r[arm + 2]);
        double z = v[2] + (v[3] * r[arm + 1] - v[4] * r[arm]);
        return x * along[at] + y * along[at + 1] + z * along[at + 2];
    }

    /** Works out the arms of a contact. */
    private void reach(Contacts c, int k) {
        reach(c, k, c.body[k], 6 * k);
        if (isMoved(c.other[k])) {
            reach(c, k, c.other[k], 6 * k + 3);
        }
    }

    private void reach(Contacts c, int k, int b, int at) {
        double[] place = bodies.get(b).place;
        for (int axis = 0; axis < 3; axis++) {
            arms[at + axis] = c.point[3 * k + axis] - place[axis];
        }
    }

    /** By how much a unit of impulse along a direction changes the speed. */
    private double lightness(Contacts c, int k, double[] along, int at) {
        double sum = isMoved(c.body[k]) ? lightness(bodies.get(c.body[k]), 6 * k, along, at) : 0;
        return isMoved(c.other[k]) ? sum + lightness(bodies.get(c.other[k]), 6 * k + 3, along, at) : sum;
    }

    private double lightness(RigidBody body, int arm, double[] along, int at) {
        double[] r = arms;
        double x = r[arm + 1] * along[at + 2] - r[arm + 2] * along[at + 1];
        double y = r[arm + 2] * along[at] - r[arm] * along[at + 2];
        double z = r[arm] * along[at + 1] - r[arm + 1] * along[at];
        double[] i = body.inverse;
        return 1 / body.mass
                + x * (i[0] * x + i[1] * y + i[2] * z)
                + y * (i[3] * x + i[4] * y + i[5] * z)
                + z * (i[6] * x + i[7] * y + i[8] * z);
    }

    private void makeTangents(Contacts c, int k) {
        double nx = c.normal[3 * k];
        double ny = c.normal[3 * k + 1];
        double nz = c.normal[3 * k + 2];
        int at = 6 * k;
        boolean isLevel = Math.abs(nx) < 0.6;
        tangents[at] = isLevel ? 0 : -nz;
        tangents[at + 1] = isLevel ? nz : 0;
        tangents[at + 2] = isLevel ? -ny : nx;
        double size = RigidBody.length(tangents, at);
        for (int axis = 0; axis < 3; axis++) {
            tangents[at + axis] /= size;
        }
        tangents[at + 3] = ny * tangents[at + 2] - nz * tangents[at + 1];
        tangents[at + 4] = nz * tangents[at] - nx * tangents[at + 2];
        tangents[at + 5] = nx * tangents[at + 1] - ny * tangents[at];
    }

    /** Pushes along the normal; answers by how much that changes the speed there. */
    private double push(Contacts c, int k, boolean atEnd) {
        double lacks = target[k] - speed(c, k, c.normal, 3 * k, atEnd);
        double after = Math.max(0, pushed[k] + lacks * ease[2 * k]);
        double by = after - pushed[k];
        pushed[k] = after;
        give(c, k, c.normal, 3 * k, by, atEnd);
        return Math.abs(by) / ease[2 * k];
    }

    private double rub(Contacts c, int k, boolean atEnd) {
        if (friction[k] == 0 || wheel[k] >= 0) {
            return 0;
        }
        double s = rubbed[2 * k] - speed(c, k, tangents, 6 * k, atEnd) * ease[2 * k + 1];
        double t = rubbed[2 * k + 1] - speed(c, k, tangents, 6 * k + 3, atEnd) * ease[2 * k + 1];
        double size = Math.sqrt(s * s + t * t);
        double most = friction[k] * pushed[k];
        double share = size > most ? most / size : 1;
        double byS = share * s - rubbed[2 * k];
        double byT = share * t - rubbed[2 * k + 1];
        rubbed[2 * k] = share * s;
        rubbed[2 * k + 1] = share * t;
        give(c, k, tangents, 6 * k, byS, atEnd);
        give(c, k, tangents, 6 * k + 3, byT, atEnd);
        return Math.max(Math.abs(byS), Math.abs(byT)) / ease[2 * k + 1];
    }

    private void give(Contacts c, int k, double[] along, int at, double impulse, boolean atEnd) {
        if (impulse != 0) {
            boolean isShared = isMoved(c.other[k]);
            RigidBody own = bodies.get(c.body[k]);
            give(own, 6 * k, along, at, impulse, atEnd ? own.u : own.v);
            if (isShared) {
                RigidBody other = bodies.get(c.other[k]);
                give(other, 6 * k + 3, along, at, -impulse, atEnd ? other.u : other.v);
                if (atEnd) {
                    give(own, 6 * k, along, at, impulse, own.given);
                    give(other, 6 * k + 3, along, at, -impulse, other.given);
                }
            }
        }
    }

    private void give(RigidBody body, int arm, double[] along, int at, double impulse, double[] v) {
        double[] r = arms;
        double x = impulse * along[at];
        double y = impulse * along[at + 1];
        double z = impulse * along[at + 2];
        v[0] += x / body.mass;
        v[1] += y / body.mass;
        v[2] += z / body.mass;
        double tx = r[arm + 1] * z - r[arm + 2] * y;
        double ty = r[arm + 2] * x - r[arm] * z;
        double tz = r[arm] * y - r[arm + 1] * x;
        double[] i = body.inverse;
        v[3] += i[0] * tx + i[1] * ty + i[2] * tz;
        v[4] += i[3] * tx + i[4] * ty + i[5] * tz;
        v[5] += i[6] * tx + i[7] * ty + i[8] * tz;
    }
}
