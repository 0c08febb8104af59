package robosim.geometry.dynamics.step;

import java.util.Arrays;

/** How the floor slows bodies. */
final class Floor {
    private final Bodies bodies;

    // The deceleration by the floor, m/s^2 and rad/s^2.
    private double[] drag = new double[8];
    private double[] spinDrag = new double[8];

    Floor(Bodies bodies) {
        this.bodies = bodies;
    }

    /** Sets by how much the floor slows a body. */
    void set(int b, double slowing, double spinSlowing) {
        if (b >= drag.length) {
            drag = Arrays.copyOf(drag, 2 * b);
            spinDrag = Arrays.copyOf(spinDrag, 2 * b);
        }
        drag[b] = slowing;
        spinDrag[b] = spinSlowing;
    }

    /** Whether the floor slows any that moves. */
    boolean slowsAny() {
        for (int b = 0; b < bodies.count; b++) {
            if ((drag[b] > 0 || spinDrag[b] > 0) && !bodies.isStill(b)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Gives a body the mean of what the floor leaves of its velocity until the end; it keeps that but for collisions, so that
     * what has been solved stays solved.
     */
    void slow(int b, double end) {
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
    void slowed(int b, double end) {
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
}
