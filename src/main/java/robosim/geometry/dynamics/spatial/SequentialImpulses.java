package robosim.geometry.dynamics.spatial;

import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.dynamics.planar.ContactSurfaces;

/**
 * Impulses at contacts, one after the other until nothing changes any more (Catto 2005): Newton's restitution, and Coulomb's
 * friction within its cone. Where rounds converge slowly, as in a stack, each continues in the direction of those before it, as
 * in the method of conjugate gradients (Silcowitz, Niebe and Erleben 2010): tens of rounds then do the work of hundreds.
 */
final class SequentialImpulses {
    /** Slower approaches do not bounce, m/s: twice what gravity makes of rest in a slice. */
    static final double BOUNCE = 0.02;

    /** Whatever slides more slowly sticks as long as static friction can hold it, m/s. */
    private static final double STICK = 1e-4;

    private static final int MOST_ROUNDS = 200;

    /** The first rounds are plain, as are all where bodies are not coupled. */
    private static final int PLAIN_ROUNDS = 8;

    /**
     * Where no impulse changes a velocity by more than {@link #INEXACT}, and the largest change has not fallen to three quarters
     * in so many rounds, iteration ends: friction is turning whose direction nothing determines, as hardly anything slides.
     */
    private static final int MORE_ROUNDS = 16;

    private static final double FALLS = 0.75;

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
    private double[] ease = new double[0];

    /** The directions of a contact: its normal and two tangents. */
    private static final int DIRECTIONS = 3;

    /**
     * By contact and direction: the direction, the turn of the body that a unit of impulse along it is, the same of the other
     * body, and by how much these change the angular velocities of both.
     */
    private static final int ROW = 15;

    private static final int OWN = 3;
    private static final int OTHER = 6;
    private static final int OWN_GAIN = 9;
    private static final int OTHER_GAIN = 12;

    private double[] rows = new double[0];

    /** By contact: the body, and the other one, null where that stands still; and whether their final velocities change. */
    private RigidBody[] owns = new RigidBody[0];

    private @Nullable RigidBody[] others = new RigidBody[0];
    private boolean atEnd;

    /** Whether moving bodies touch each other, none of which has a drive; otherwise plain rounds do. */
    private boolean isCoupled;

    /** By contact and direction: what the last round gave, and what the next one continues with. */
    private double[] change = new double[0];

    private double[] heading = new double[0];

    /** The size of what the last round gave, joules. */
    private double changed;

    private double[] friction = new double[0];
    private boolean[] isOff = new boolean[0];

    /** In which order contacts get their impulses, and how often it has changed. */
    private int[] order = new int[0];

    private int turn;

    /** Of contacts below a driven body, that body, and else -1; and friction while wheels slide. */
    private int[] wheel = new int[0];

    private double[] slides = new double[0];

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
        this.atEnd = atEnd;
        reserve(contacts.count);
        rolling.begin(contacts.count);
        boolean isDriven = false;
        isCoupled = false;
        boolean any = false;
        for (int k = 0; k < contacts.count; k++) {
            any |= prepare(contacts, k, seconds, gap, surfaces);
            RigidBody other = others[k];
            isCoupled |= !isOff[k] && other != null;
            isDriven |= owns[k].isDriven || (other != null && other.isDriven);
        }
        isCoupled &= !isDriven;
        turn += atEnd ? 0 : 1;
        arrange(contacts);
        if (atEnd) {
            traction.prepare(contacts, wheel, isOff, driven, seconds);
        }
        if (any) {
            iterate(contacts);
        }
        if (any && spread(contacts)) {
            iterate(contacts);
        }
        for (int k = 0; any && k < MOST_SLIPS && slips(contacts); k++) {
            iterate(contacts);
        }
        for (int k = 0; k < contacts.count; k++) {
            if (!isOff[k]) {
                contacts.impulse[k] += pushed[k];
                contacts.lasting[k] = atEnd ? pushed[k] : 0;
            }
        }
        if (atEnd) {
            note(contacts);
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
                double mean = 0.5 * (speed(k, 0, false) + speed(k, 0, true));
                RigidBody body = bodies.get(c.body[k]);
                body.lends += pushed[k] * Math.max(0, Math.min(mean, 0.5 * INEXACT));
                body.mostLent += pushed[k] / seconds * TurningSweep.GAP;
            }
        }
    }

    /** Notes what moving bodies have given each other for the time up to the end. */
    private void note(Contacts c) {
        for (int k = 0; k < c.count; k++) {
            RigidBody other = others[k];
            if (other != null && !isOff[k]) {
                for (int d = 0; d < DIRECTIONS; d++) {
                    double impulse = d == 0 ? pushed[k] : rubbed[2 * k + d - 1];
                    give(owns[k], owns[k].given, DIRECTIONS * k + d, OWN_GAIN, impulse);
                    give(other, other.given, DIRECTIONS * k + d, OTHER_GAIN, -impulse);
                }
            }
        }
    }

    /** Gives impulses until they change nothing any more. */
    private void iterate(Contacts contacts) {
        Arrays.fill(change, 0, DIRECTIONS * contacts.count, 0);
        Arrays.fill(heading, 0, DIRECTIONS * contacts.count, 0);
        changed = 0;
        double bar = Double.POSITIVE_INFINITY;
        for (int round = 0; round < MOST_ROUNDS; round++) {
            double most = 0;
            for (int at = 0; at < contacts.count; at++) {
                int k = order[at];
                if (!isOff[k]) {
                    most = Math.max(most, push(k));
                    most = Math.max(most, rub(k));
                    most = Math.max(most, rolling.resist(contacts, k, pushed[k], atEnd));
                }
            }
            if (atEnd) {
                most = Math.max(most, traction.roll(contacts, wheel, pushed, friction, slides));
            }
            boolean isCheck = round % MORE_ROUNDS == 0;
            if (most < SMALL || (isCoupled && isCheck && most < INEXACT && most > bar)) {
                break;
            }
            bar = isCheck ? FALLS * most : bar;
            if (isCoupled && round >= PLAIN_ROUNDS && round + 1 < MOST_ROUNDS) {
                goOn(contacts.count);
            }
        }
    }

    /**
     * Continues in the direction of the rounds so far, by the ratio of the sizes of the last two; not where they grew. The next
     * round corrects whatever that overshoots, and only a round ends the iteration.
     */
    private void goOn(int count) {
        double before = changed;
        changed = 0;
        for (int k = 0; k < count; k++) {
            if (!isOff[k]) {
                double n = change[DIRECTIONS * k];
                double s = change[DIRECTIONS * k + 1];
                double t = change[DIRECTIONS * k + 2];
                changed += n * n / ease[2 * k] + (s * s + t * t) / ease[2 * k + 1];
            }
        }
        double share = changed < before ? changed / before : 0;
        for (int at = 0; at < DIRECTIONS * count; at++) {
            int k = at / DIRECTIONS;
            if (!isOff[k]) {
                double by = share * heading[at];
                heading[at] = by + change[at];
                if (at == DIRECTIONS * k) {
                    pushed[k] += by;
                } else {
                    rubbed[at - k - 1] += by;
                }
                give(k, at, by);
            }
        }
    }

    /**
     * Spreads the friction between two bodies, or of one with all that stands still, over their contacts as they are pressed,
     * where all give what they can and slide; whether there are any. What early rounds have left of one that pulls against
     * another hardly turns any more then, and would lack where it is needed.
     */
    private boolean spread(Contacts c) {
        boolean any = false;
        for (int k = 0; k < c.count; k++) {
            if (isHeld(k) && isAtMost(c, k)) {
                spread(c, k);
                any = true;
            }
        }
        return any;
    }

    private void spread(Contacts c, int of) {
        double x = 0;
        double y = 0;
        double z = 0;
        double all = 0;
        for (int k = 0; k < c.count; k++) {
            if (isBeside(c, of, k)) {
                double s = rubbed[2 * k];
                double t = rubbed[2 * k + 1];
                int row = ROW * (DIRECTIONS * k + 1);
                x += s * rows[row] + t * rows[row + ROW];
                y += s * rows[row + 1] + t * rows[row + ROW + 1];
                z += s * rows[row + 2] + t * rows[row + ROW + 2];
                all += pushed[k];
            }
        }
        for (int k = 0; k < c.count; k++) {
            if (isBeside(c, of, k)) {
                double share = pushed[k] / all;
                for (int which = 0; which < 2; which++) {
                    int at = DIRECTIONS * k + 1 + which;
                    double along = x * rows[ROW * at] + y * rows[ROW * at + 1] + z * rows[ROW * at + 2];
                    double by = share * along - rubbed[2 * k + which];
                    rubbed[2 * k + which] += by;
                    give(k, at, by);
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
    private boolean isAtMost(Contacts c, int of) {
        boolean isAll = true;
        for (int k = 0; isAll && k < c.count; k++) {
            if (isBeside(c, of, k)) {
                double given = Math.sqrt(rubbed[2 * k] * rubbed[2 * k] + rubbed[2 * k + 1] * rubbed[2 * k + 1]);
                isAll = given >= ALL * friction[k] * pushed[k] && slidesBy(k, atEnd) > SLIP_AT_MOST;
            }
        }
        return isAll;
    }

    /** Lets those slide that static friction has not held; whether there are any. */
    private boolean slips(Contacts c) {
        boolean any = false;
        for (int k = 0; k < c.count; k++) {
            if (isHeld(k) && (slidesBy(k, atEnd) > SLIP || isAtMost(c, k))) {
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
            ease = new double[2 * room];
            rows = new double[DIRECTIONS * ROW * room];
            change = new double[DIRECTIONS * room];
            heading = new double[DIRECTIONS * room];
            owns = new RigidBody[room];
            others = new RigidBody[room];
            isOff = new boolean[room];
        }
    }

    private boolean prepare(Contacts c, int k, double seconds, double gap, ContactSurfaces surfaces) {
        pushed[k] = 0;
        wheel[k] = -1;
        rubbed[2 * k] = 0;
        rubbed[2 * k + 1] = 0;
        owns[k] = bodies.get(c.body[k]);
        others[k] = isMoved(c.other[k]) ? bodies.get(c.other[k]) : null;
        System.arraycopy(c.normal, 3 * k, rows, ROW * DIRECTIONS * k, 3);
        reach(c, k, 0);
        int own = bodies.get(c.body[k]).id;
        int other = c.object[k];
        double before = speed(k, 0, false);
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
        makeTangents(k);
        reach(c, k, 1);
        reach(c, k, 2);
        ease[2 * k] = 1 / lightness(k, 0);
        // One for both, so that what slides is rubbed straight against its way.
        ease[2 * k + 1] = 1 / Math.max(lightness(k, 1), lightness(k, 2));
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
        friction[k] = wheel[k] >= 0 || slidesBy(k, false) <= STICK ? still : sliding;
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

    private double slidesBy(int k, boolean end) {
        double s = speed(k, 1, end);
        double t = speed(k, 2, end);
        return Math.sqrt(s * s + t * t);
    }

    /** The speed at which the body leaves the other one along a direction. */
    private double speed(int k, int direction, boolean end) {
        int row = ROW * (DIRECTIONS * k + direction);
        double sum = speed(row, OWN, end ? owns[k].u : owns[k].v);
        RigidBody other = others[k];
        return other == null ? sum : sum - speed(row, OTHER, end ? other.u : other.v);
    }

    private double speed(int row, int turn, double[] v) {
        double[] r = rows;
        return (v[0] * r[row] + v[1] * r[row + 1] + v[2] * r[row + 2])
                + (v[3] * r[row + turn] + v[4] * r[row + turn + 1] + v[5] * r[row + turn + 2]);
    }

    /** Works out how a direction of a contact turns both bodies. */
    private void reach(Contacts c, int k, int direction) {
        int row = ROW * (DIRECTIONS * k + direction);
        reach(owns[k], c.point, 3 * k, row, OWN, OWN_GAIN);
        RigidBody other = others[k];
        if (other != null) {
            reach(other, c.point, 3 * k, row, OTHER, OTHER_GAIN);
        }
    }

    private void reach(RigidBody body, double[] point, int p, int row, int turn, int gain) {
        double[] r = rows;
        double x = point[p] - body.place[0];
        double y = point[p + 1] - body.place[1];
        double z = point[p + 2] - body.place[2];
        double tx = y * r[row + 2] - z * r[row + 1];
        double ty = z * r[row] - x * r[row + 2];
        double tz = x * r[row + 1] - y * r[row];
        double[] i = body.inverse;
        r[row + turn] = tx;
        r[row + turn + 1] = ty;
        r[row + turn + 2] = tz;
        r[row + gain] = i[0] * tx + i[1] * ty + i[2] * tz;
        r[row + gain + 1] = i[3] * tx + i[4] * ty + i[5] * tz;
        r[row + gain + 2] = i[6] * tx + i[7] * ty + i[8] * tz;
    }

    /** By how much a unit of impulse along a direction changes the speed. */
    private double lightness(int k, int direction) {
        int row = ROW * (DIRECTIONS * k + direction);
        RigidBody other = others[k];
        double own = lightness(owns[k], row, OWN, OWN_GAIN);
        return other == null ? own : own + lightness(other, row, OTHER, OTHER_GAIN);
    }

    private double lightness(RigidBody body, int row, int turn, int gain) {
        double[] r = rows;
        return 1 / body.mass
                + r[row + turn] * r[row + gain]
                + r[row + turn + 1] * r[row + gain + 1]
                + r[row + turn + 2] * r[row + gain + 2];
    }

    private void makeTangents(int k) {
        double[] r = rows;
        int at = ROW * DIRECTIONS * k;
        double nx = r[at];
        double ny = r[at + 1];
        double nz = r[at + 2];
        int s = at + ROW;
        int t = s + ROW;
        boolean isLevel = Math.abs(nx) < 0.6;
        r[s] = isLevel ? 0 : -nz;
        r[s + 1] = isLevel ? nz : 0;
        r[s + 2] = isLevel ? -ny : nx;
        double size = RigidBody.length(r, s);
        for (int axis = 0; axis < 3; axis++) {
            r[s + axis] /= size;
        }
        r[t] = ny * r[s + 2] - nz * r[s + 1];
        r[t + 1] = nz * r[s] - nx * r[s + 2];
        r[t + 2] = nx * r[s + 1] - ny * r[s];
    }

    /** Pushes along the normal; answers by how much that changes the speed there. */
    private double push(int k) {
        double lacks = target[k] - speed(k, 0, atEnd);
        double after = Math.max(0, pushed[k] + lacks * ease[2 * k]);
        double by = after - pushed[k];
        pushed[k] = after;
        change[DIRECTIONS * k] = by;
        give(k, DIRECTIONS * k, by);
        return Math.abs(by) / ease[2 * k];
    }

    private double rub(int k) {
        if (friction[k] == 0 || wheel[k] >= 0) {
            return 0;
        }
        double s = rubbed[2 * k] - speed(k, 1, atEnd) * ease[2 * k + 1];
        double t = rubbed[2 * k + 1] - speed(k, 2, atEnd) * ease[2 * k + 1];
        double size = Math.sqrt(s * s + t * t);
        double most = friction[k] * pushed[k];
        double share = size > most ? most / size : 1;
        double byS = share * s - rubbed[2 * k];
        double byT = share * t - rubbed[2 * k + 1];
        rubbed[2 * k] = share * s;
        rubbed[2 * k + 1] = share * t;
        change[DIRECTIONS * k + 1] = byS;
        change[DIRECTIONS * k + 2] = byT;
        give(k, DIRECTIONS * k + 1, byS);
        give(k, DIRECTIONS * k + 2, byT);
        return Math.max(Math.abs(byS), Math.abs(byT)) / ease[2 * k + 1];
    }

    /** Gives both bodies of a contact an impulse along one of all directions. */
    private void give(int k, int at, double impulse) {
        if (impulse != 0) {
            RigidBody own = owns[k];
            give(own, atEnd ? own.u : own.v, at, OWN_GAIN, impulse);
            RigidBody other = others[k];
            if (other != null) {
                give(other, atEnd ? other.u : other.v, at, OTHER_GAIN, -impulse);
            }
        }
    }

    private void give(RigidBody body, double[] v, int at, int gain, double impulse) {
        double[] r = rows;
        int row = ROW * at;
        double by = impulse / body.mass;
        v[0] += by * r[row];
        v[1] += by * r[row + 1];
        v[2] += by * r[row + 2];
        v[3] += impulse * r[row + gain];
        v[4] += impulse * r[row + gain + 1];
        v[5] += impulse * r[row + gain + 2];
    }
}
