package robosim.geometry.dynamics.space;

import java.util.List;

/** The energy of bodies in a slice, shared by those that touch each other; and which of them come to rest. */
final class Ledger {
    /** What touches something and moves more slowly than this for so long comes to rest: m/s, s. */
    private static final double SLOW = 1e-3;

    private static final double REST = 0.25;

    /** What is touched faster than this wakes up, m/s. */
    private static final double WAKE = 5e-3;

    private final List<Rigid> bodies;
    private final double[] gravity;

    Ledger(List<Rigid> bodies, double[] gravity) {
        this.bodies = bodies;
        this.gravity = gravity;
    }

    /** Notes what each body has when a slice begins, after damping. */
    void begin(double seconds) {
        for (int b = 0; b < bodies.size(); b++) {
            Rigid body = bodies.get(b);
            body.group = b;
            body.isTouching = false;
            body.turnInertia();
            if (!body.isAsleep) {
                body.limit(seconds);
            }
            body.energy = body.kinetic(body.v);
            System.arraycopy(body.place, 0, body.start, 0, 3);
        }
    }

    /** Notes that two bodies touch: they share their energy, and one that comes fast enough wakes the other. */
    void join(int a, int b) {
        Rigid other = bodies.get(b);
        other.isTouching = true;
        if (other.isAsleep && bodies.get(a).speed(bodies.get(a).v) > WAKE) {
            other.wake();
        }
        int from = bodies.get(a).group;
        int to = other.group;
        for (Rigid each : bodies) {
            each.group = each.group == from ? to : each.group;
        }
    }

    /** Energy never grows: what rounding, or restitution together with friction, would add is taken from the speed. */
    void finish(double seconds) {
        for (int b = 0; b < bodies.size(); b++) {
            Rigid body = bodies.get(b);
            if (!body.isAsleep) {
                System.arraycopy(body.u, 0, body.v, 0, 6);
            }
        }
        for (int group = 0; group < bodies.size(); group++) {
            double before = 0;
            double moving = 0;
            double risen = 0;
            for (Rigid body : bodies) {
                if (body.group == group && !body.isAsleep) {
                    before += body.energy;
                    moving += body.kinetic(body.v);
                    risen += body.risen(gravity);
                }
            }
            if (moving > 0 && moving + risen > before) {
                double share = Math.sqrt(Math.max(0, before - risen) / moving);
                for (Rigid body : bodies) {
                    if (body.group == group) {
                        for (int k = 0; k < 6; k++) {
                            body.v[k] *= share;
                        }
                    }
                }
            }
        }
        for (Rigid body : bodies) {
            if (!body.isAsleep) {
                body.slow = body.isTouching && body.speed(body.v) < SLOW ? body.slow + seconds : 0;
                if (body.slow > REST) {
                    body.sleep();
                }
            }
        }
    }
}
