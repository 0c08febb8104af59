package robosim.geometry.dynamics.spatial;

import java.util.Arrays;
import java.util.List;

/** The energy of bodies in a slice, shared by those that touch each other; and which of them come to rest. */
final class EnergyBudget {
    /** What touches something and moves more slowly than this for so long comes to rest: m/s, s. */
    private static final double SLOW = 1e-3;

    private static final double REST = 0.25;

    /** What is touched faster than this wakes up, m/s. */
    private static final double WAKE = 5e-3;

    private final List<RigidBody> bodies;
    private final double[] gravity;
    private final Clusters cluster;

    // By group: the energy before and what drives have added, the kinetic one now, the potential one gained, and
    // whether anything that stands still is touched.
    private double[] before = new double[0];
    private double[] moving = new double[0];
    private double[] risen = new double[0];
    private double[] lends = new double[0];
    private double[] lent = new double[0];
    private double[] mostLent = new double[0];
    private boolean[] isPressed = new boolean[0];
    private boolean[] isHeld = new boolean[0];

    EnergyBudget(List<RigidBody> bodies, double[] gravity, Clusters cluster) {
        this.bodies = bodies;
        this.gravity = gravity;
        this.cluster = cluster;
    }

    /** Notes what each body of a cluster has when a slice begins, after damping. */
    void begin(double seconds) {
        for (int m = 0; m < cluster.count; m++) {
            int b = cluster.member[m];
            RigidBody body = bodies.get(b);
            body.group = b;
            body.isTouching = false;
            body.isHeld = false;
            body.isAmongOthers = false;
            body.work = 0;
            body.lastWork = 0;
            body.lends = 0;
            body.mostLent = 0;
            Arrays.fill(body.exchanged, 0);
            body.turnInertia();
            if (!body.isAsleep) {
                body.limit(seconds);
            }
            body.energy = body.kinetic(body.v);
            System.arraycopy(body.place, 0, body.start, 0, 3);
            System.arraycopy(body.v, 0, body.began, 0, 6);
            body.spin(body.place, body.v, body.spun);
        }
    }

    /**
     * Notes that two bodies touch: they share their energy, and one that comes fast enough, or that a drive presses, wakes the
     * other.
     */
    void join(int a, int b) {
        RigidBody body = bodies.get(a);
        RigidBody other = bodies.get(b);
        other.isTouching = true;
        if (other.isAsleep && (body.isPressed || body.speed(body.v) > WAKE)) {
            other.wake();
        }
        if (!cluster.has(a) || !cluster.has(b)) {
            return; // the energy that they exchange counts as work
        }
        int from = body.group;
        int to = other.group;
        for (int m = 0; from != to && m < cluster.count; m++) {
            RigidBody each = bodies.get(cluster.member[m]);
            each.group = each.group == from ? to : each.group;
        }
    }

    /**
     * Energy grows by no more than the work of drives: what rounding, or restitution together with friction, would add is taken
     * from the speed. Bodies that touch nothing but each other keep both momenta instead.
     */
    void finish(double seconds, FreeGroup free) {
        double[] about = bodies.get(cluster.member[0]).start;
        for (int m = 0; m < cluster.count; m++) {
            RigidBody body = bodies.get(cluster.member[m]);
            if (!body.isAsleep) {
                body.exchange(body.place, body.u, 1, about); // what came after it was carried
                System.arraycopy(body.u, 0, body.v, 0, 6);
            }
        }
        free.list(cluster);
        for (int m = 0; m < cluster.count; m++) {
            free.takeBack(cluster.member[m]);
        }
        sum(seconds);
        lend();
        for (int m = 0; m < cluster.count; m++) {
            int group = cluster.member[m];
            double excess = moving[group] + risen[group] - before[group];
            bodies.get(group).isPressed = isPressed[bodies.get(group).group];
            if (isHeld[group] && excess > 0) {
                free.brake(group, moving[group], excess);
            } else if (!isHeld[group] && moving[group] > 0) {
                free.keep(group, seconds, before[group]);
            }
        }
        for (int m = 0; m < cluster.count; m++) {
            RigidBody body = bodies.get(cluster.member[m]);
            if (!body.isAsleep) {
                body.slow = body.isTouching && !body.isPressed && body.speed(body.v) < SLOW ? body.slow + seconds : 0;
                if (body.slow > REST) {
                    body.sleep();
                }
            }
        }
    }

    /** Lends groups what solutions that are not exact have added, and takes it back from what they lose. */
    private void lend() {
        for (int m = 0; m < cluster.count; m++) {
            int b = cluster.member[m];
            lends[b] = 0;
            lent[b] = 0;
            mostLent[b] = 0;
        }
        for (int m = 0; m < cluster.count; m++) {
            RigidBody body = bodies.get(cluster.member[m]);
            lends[body.group] += body.lends;
            lent[body.group] += body.lent;
            mostLent[body.group] += body.mostLent;
            body.lent = 0;
        }
        for (int m = 0; m < cluster.count; m++) {
            int group = cluster.member[m];
            double excess = moving[group] + risen[group] - before[group];
            double by = Math.max(-lent[group], Math.min(excess, Math.min(lends[group], mostLent[group] - lent[group])));
            if (isHeld[group]) {
                before[group] += Math.max(0, by);
                bodies.get(group).lent = lent[group] + by;
            }
        }
    }

    /** What the bodies of each group have. */
    private void sum(double seconds) {
        int count = bodies.size();
        if (before.length < count) {
            before = new double[count];
            moving = new double[count];
            risen = new double[count];
            lends = new double[count];
            lent = new double[count];
            mostLent = new double[count];
            isPressed = new boolean[count];
            isHeld = new boolean[count];
        }
        for (int m = 0; m < cluster.count; m++) {
            int b = cluster.member[m];
            before[b] = 0;
            moving[b] = 0;
            risen[b] = 0;
            isPressed[b] = false;
            isHeld[b] = false;
        }
        for (int m = 0; m < cluster.count; m++) {
            RigidBody body = bodies.get(cluster.member[m]);
            if (!body.isAsleep) {
                int group = body.group;
                before[group] += body.energy + body.work + body.pushWork(seconds);
                moving[group] += body.kinetic(body.v);
                risen[group] += body.risen(gravity);
                isPressed[group] |= body.isDriving || body.isPushed;
                isHeld[group] |= body.isHeld;
            }
        }
    }
}
