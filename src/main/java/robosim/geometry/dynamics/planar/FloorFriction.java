package robosim.geometry.dynamics.planar;

import java.util.Arrays;

/**
 * How the floor slows bodies. What moves freely has the mean of what the floor leaves of its velocity; what others press is
 * slowed in full at once, and what the floor has left after that holds it in the collisions with them, so that what they cannot
 * move stands still.
 */
final class FloorFriction {
    private final MovingBodies bodies;

    // The deceleration by the floor, m/s^2 and rad/s^2.
    private double[] drag = new double[8];
    private double[] spinDrag = new double[8];

    // What the floor may still take from the velocity of what is pressed, m/s and radians a second.
    private double[] left = new double[8];
    private double[] spinLeft = new double[8];

    // Whether others pressed it before, and do now.
    private boolean[] wasPressed = new boolean[8];
    private boolean[] isPressed = new boolean[8];

    private boolean[] keptPressed = new boolean[0];

    // What the floor gives in the solution at hand, and gave in the round before: changes of the velocity.
    private double[] given = new double[24];
    private double[] last = new double[24];

    /** What the last {@link #answer} changes. */
    double changeX;

    double changeZ;
    double changeTurn;

    FloorFriction(MovingBodies bodies) {
        this.bodies = bodies;
    }

    /** Sets by how much the floor slows a body. */
    void set(int b, double slowing, double spinSlowing) {
        if (b >= drag.length) {
            int room = 2 * b;
            drag = Arrays.copyOf(drag, room);
            spinDrag = Arrays.copyOf(spinDrag, room);
            left = Arrays.copyOf(left, room);
            spinLeft = Arrays.copyOf(spinLeft, room);
            wasPressed = Arrays.copyOf(wasPressed, room);
            isPressed = Arrays.copyOf(isPressed, room);
            given = Arrays.copyOf(given, 3 * room);
            last = Arrays.copyOf(last, 3 * room);
        }
        drag[b] = slowing;
        spinDrag[b] = spinSlowing;
    }

    /** Forgets who pressed a body. */
    void forget(int b) {
        wasPressed[b] = false;
        isPressed[b] = false;
    }

    /** Keeps who is pressed. */
    void keep() {
        keptPressed = isPressed.clone();
    }

    /** Takes that back for the first bodies. */
    void undo(int count) {
        System.arraycopy(keptPressed, 0, isPressed, 0, Math.min(count, keptPressed.length));
    }

    /** Remembers that another body presses this one. */
    void press(int b) {
        isPressed[b] = true;
    }

    /**
     * Slows a body at the beginning of a time: it keeps that velocity until the end but for collisions, so that what has been
     * solved stays solved.
     */
    void slow(int b, double end) {
        wasPressed[b] = isPressed[b];
        isPressed[b] = false;
        left[b] = 0;
        spinLeft[b] = 0;
        if (drag[b] == 0 && spinDrag[b] == 0) {
            return;
        }
        double speed = speed(b);
        double turn = Math.abs(bodies.w[b]);
        if (wasPressed[b]) {
            slow(b, endShare(speed, drag[b], end), endShare(turn, spinDrag[b], end));
            left[b] = Math.max(0, drag[b] * end - speed);
            spinLeft[b] = Math.max(0, spinDrag[b] * end - turn);
        } else {
            slow(b, meanShare(speed, drag[b], end), meanShare(turn, spinDrag[b], end));
        }
    }

    private void slow(int b, double share, double spinShare) {
        bodies.vx[b] *= share;
        bodies.vz[b] *= share;
        bodies.w[b] *= spinShare;
    }

    private double speed(int b) {
        return Math.sqrt(bodies.vx[b] * bodies.vx[b] + bodies.vz[b] * bodies.vz[b]);
    }

    private static double meanShare(double speed, double slowing, double left) {
        if (speed == 0 || slowing == 0) {
            return 1;
        }
        double rest = speed / slowing;
        return rest >= left ? 1 - 0.5 * left / rest : 0.5 * rest / left;
    }

    /** Takes from a velocity that was the mean what the floor takes in the second half of the time. */
    void slowed(int b, double end) {
        if (!wasPressed[b] && (drag[b] > 0 || spinDrag[b] > 0)) {
            slow(b, endShare(speed(b), drag[b], 0.5 * end), endShare(Math.abs(bodies.w[b]), spinDrag[b], 0.5 * end));
        }
    }

    private static double endShare(double speed, double slowing, double passed) {
        return speed == 0 ? 1 : Math.max(0, 1 - slowing * passed / speed);
    }

    // ---- in a solution ----

    /** Whether the floor holds a body in collisions. */
    boolean holds(int b) {
        return left[b] > 0 || spinLeft[b] > 0;
    }

    /** Begins a solution. */
    void begin(int b) {
        Arrays.fill(given, 3 * b, 3 * b + 3, 0);
        Arrays.fill(last, 3 * b, 3 * b + 3, 0);
    }

    /**
     * Changes what the floor gives as the velocity of a body asks; answers by how much that changes the velocity.
     *
     * @param parts    among how many the body is divided
     * @param momentum how far the last change is carried on, as that of contacts
     */
    double answer(int b, int parts, double momentum) {
        int at = 3 * b;
        double x = given[at] - bodies.vx[b] / parts;
        double z = given[at + 1] - bodies.vz[b] / parts;
        double length = Math.sqrt(x * x + z * z);
        if (length > left[b]) {
            x *= left[b] / length;
            z *= left[b] / length;
        }
        double turn = given[at + 2] - bodies.w[b] / parts;
        turn = Math.max(-spinLeft[b], Math.min(spinLeft[b], turn));
        double change =
                Math.abs(x - given[at]) + Math.abs(z - given[at + 1]) + Math.abs(turn - given[at + 2]) * bodies.size[b];
        changeX = carriedOn(at, x, momentum);
        changeZ = carriedOn(at + 1, z, momentum);
        changeTurn = carriedOn(at + 2, turn, momentum);
        return change;
    }

    private double carriedOn(int at, double now, double momentum) {
        double next = now + momentum * (now - last[at]);
        last[at] = now;
        double change = next - given[at];
        given[at] = next;
        return change;
    }

    /** Takes what a solution has used of what the floor had left. */
    void take(int b) {
        int at = 3 * b;
        left[b] = Math.max(0, left[b] - Math.sqrt(given[at] * given[at] + given[at + 1] * given[at + 1]));
        spinLeft[b] = Math.max(0, spinLeft[b] - Math.abs(given[at + 2]));
    }
}
