package robosim.geometry.engine.motion;

import java.util.Arrays;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ObjectRegistry;

/**
 * A motion that goes on along what blocks it: each part of the way is one {@link Motion} to contact, and what is left of it is
 * clipped by the planes of the contacts that the object has not left since (Fauerby 2003). Which way to go on is decided in
 * plain doubles; whether that way is free, and where it ends, is decided by the motion alone.
 */
public final class Slide {
    /** Numbers of a contact: a point and a normal. */
    public static final int CONTACT = 6;

    /**
     * A plane that is met again at once is left by so much of what is left of the way, as rounding alone takes a way along an
     * oblique plane into it by some {@code 2^-52} of its length.
     */
    private static final double LEAN = 0x1p-40;

    /** Contacts count as left after so much of the whole way. */
    private static final double LEFT = 0x1p-30;

    /** Two unit normals are the same plane's where their difference, squared, is below this. */
    private static final double SAME = 0x1p-60;

    /** Most contacts at which a way may go on, so that no call takes forever. */
    private static final int MOST_BENDS = 64;

    private final ObjectRegistry registry;
    private final Motion motion;
    private final double[] one = new double[CONTACT];
    private final double[] asked = new double[3];
    private final double[] made = new double[3];
    private final double[] left = new double[3];
    private final double[] next = new double[3];

    private int[] obstacles = new int[4];
    private double[] contacts = new double[4 * CONTACT];
    private int count;

    /** The contacts from here on have not been left since they were met. */
    private int near;

    private double length;
    private double turnFraction;

    public Slide(ObjectRegistry registry, Motion motion) {
        this.registry = registry;
        this.motion = motion;
    }

    /** Refuses a number of contacts at which no way may go on. */
    public static void checkBends(int bends) {
        if (bends < 0 || bends > MOST_BENDS) {
            throw new IllegalArgumentException("bends must be from 0 to " + MOST_BENDS + " (got: " + bends + ")");
        }
    }

    /** Moves an object by a displacement in the world's axes and then turns it about its own, as far as that is free. */
    public void make(
            AccuracyView view,
            int id,
            double x,
            double y,
            double z,
            double turnX,
            double turnY,
            double clearance,
            int bends) {
        Arrays.fill(made, 0);
        asked[0] = x;
        asked[1] = y;
        asked[2] = z;
        System.arraycopy(asked, 0, left, 0, 3);
        count = 0;
        near = 0;
        length = 0;
        turnFraction = 1;
        double whole = size(left);
        int leans = 0;
        boolean goesOn = whole > 0;
        while (goesOn) {
            goesOn = false;
            boolean free = motion.attempt(view, id, left[0], left[1], left[2], 0, 0, false, clearance);
            double way = advance(id, free ? 1 : motion.fraction());
            if (free) {
                break;
            }
            if (way > LEFT * whole) {
                near = count;
            }
            motion.contact(one);
            if (!isKnown()) {
                add();
                goesOn = count <= bends && bend(0);
            } else if (leans < bends) {
                leans++;
                goesOn = bend(LEAN * size(left));
            }
        }
        if (size(left) <= LEAN * whole) {
            Arrays.fill(left, 0);
        }
        if (turnX != 0 || turnY != 0) {
            boolean free = motion.attempt(view, id, 0, 0, 0, turnX, turnY, false, clearance);
            registry.move(id, motion.end());
            if (!free) {
                turnFraction = motion.turnFraction();
                motion.contact(one);
                add();
            }
        }
    }

    /** Puts the object where the motion ended, and takes that part off what is left; answers its length. */
    private double advance(int id, double share) {
        registry.move(id, motion.end());
        double way = share * size(left);
        length += way;
        for (int k = 0; k < 3; k++) {
            made[k] += share * left[k];
            left[k] -= share * left[k];
        }
        return way;
    }

    /** Whether the plane met last is one that the object has not left, or that of the contact before on the same object. */
    private boolean isKnown() {
        for (int k = near; k < count; k++) {
            if (isPlane(k)) {
                return true;
            }
        }
        int last = count - 1;
        if (near == count && last >= 0 && obstacles[last] == motion.touched() && isPlane(last)) {
            near = last;
            return true;
        }
        return false;
    }

    private boolean isPlane(int k) {
        int at = CONTACT * k + 3;
        double x = contacts[at] - one[3];
        double y = contacts[at + 1] - one[4];
        double z = contacts[at + 2] - one[5];
        return x * x + y * y + z * z < SAME;
    }

    private void add() {
        if (count == obstacles.length) {
            obstacles = Arrays.copyOf(obstacles, 2 * count);
            contacts = Arrays.copyOf(contacts, 2 * count * CONTACT);
        }
        obstacles[count] = motion.touched();
        System.arraycopy(one, 0, contacts, CONTACT * count, CONTACT);
        count++;
    }

    /**
     * Bends what is left along the plane that was met, or along the edge between it and another one near; false where neither
     * leads on, or only back: a way out of a blunt corner would lead into it again next time, and so on.
     */
    private boolean bend(double lean) {
        double into = dot(left, one, 3);
        for (int k = 0; k < 3; k++) {
            next[k] = left[k] - Math.min(into, 0) * one[3 + k];
        }
        boolean isFree = isClear();
        for (int k = near; k < count && !isFree; k++) {
            isFree = follow(CONTACT * k + 3) && isClear();
        }
        if (!isFree || size(next) <= LEAN * size(left) || dot(next, asked, 0) <= 0) {
            return false;
        }
        System.arraycopy(next, 0, left, 0, 3);
        for (int k = near; k < count && lean > 0; k++) {
            for (int axis = 0; axis < 3; axis++) {
                left[axis] += lean * contacts[CONTACT * k + 3 + axis];
            }
        }
        return true;
    }

    /** Makes the next way one along the edge between the plane that was met and another; false where they are parallel. */
    private boolean follow(int at) {
        double x = one[4] * contacts[at + 2] - one[5] * contacts[at + 1];
        double y = one[5] * contacts[at] - one[3] * contacts[at + 2];
        double z = one[3] * contacts[at + 1] - one[4] * contacts[at];
        double square = x * x + y * y + z * z;
        if (square < SAME) {
            return false;
        }
        double along = (left[0] * x + left[1] * y + left[2] * z) / square;
        next[0] = along * x;
        next[1] = along * y;
        next[2] = along * z;
        return true;
    }

    /** Whether the next way goes into none of the planes that are near, but for rounding. */
    private boolean isClear() {
        double slack = LEAN * size(next);
        for (int k = near; k < count; k++) {
            if (dot(next, contacts, CONTACT * k + 3) < -slack) {
                return false;
            }
        }
        return true;
    }

    private static double dot(double[] way, double[] normals, int at) {
        return way[0] * normals[at] + way[1] * normals[at + 1] + way[2] * normals[at + 2];
    }

    private static double size(double[] way) {
        return Math.sqrt(dot(way, way, 0));
    }

    /** The displacement made, by axis of the world. */
    public double made(int axis) {
        return made[axis];
    }

    /** What was left to go where it stopped, by axis of the world. */
    public double left(int axis) {
        return left[axis];
    }

    /** The length of the way that was made. */
    public double length() {
        return length;
    }

    public double turnFraction() {
        return turnFraction;
    }

    /** The number of contacts. */
    public int count() {
        return count;
    }

    /** What blocked at a contact: an id, or below 0 for the border. */
    public int obstacle(int k) {
        return obstacles[k];
    }

    /** One of the {@link #CONTACT} numbers of a contact. */
    public double contact(int k, int number) {
        return contacts[CONTACT * k + number];
    }
}
