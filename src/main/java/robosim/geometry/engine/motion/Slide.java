package robosim.geometry.engine.motion;

import java.util.Arrays;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.model.Dimension;

/**
 * A motion that goes on along what blocks it, and keeps a clearance from everything: each part of it is one {@link Motion}, and
 * what is left is clipped by the planes of all pieces about as near as the clearance ({@link SlidePlanes}). Where to go is
 * chosen in plain doubles; whether that is free, and where it ends, is decided by the motion alone.
 *
 * <p>Without a clearance a {@link #SKIN} is kept instead, so that seams of flat walls, which rounding puts an ulp before or
 * behind each other, stop nothing.
 */
public final class Slide {
    /** Numbers of a contact: a point and a normal. */
    public static final int CONTACT = 6;

    /** The least clearance, as a share of the magnitudes of the object's bounds: 2^17 units of roundoff. */
    private static final double SKIN = 0x1p-36;

    /** What a step along planes moves away from them, as a share of the same: more than places lose when they are stored. */
    private static final double LEAN = 0x1p-48;

    /** Displacements below this share of the whole are none. */
    private static final double NONE = 0x1p-40;

    /** Planes count as left after so much of the whole displacement. */
    private static final double LEFT = 0x1p-30;

    /** Most contacts at which a motion may go on, so that no call takes forever. */
    private static final int MOST_BENDS = 64;

    /** Most attempts to get a lost clearance back. */
    private static final int PUSHES = 4;

    private final ObjectRegistry registry;
    private final Motion motion;
    private final SlidePlanes planes;
    private final double[] one = new double[CONTACT];
    private final double[] asked = new double[3];
    private final double[] made = new double[3];
    private final double[] left = new double[3];
    private final double[] next = new double[3];

    /** The contacts at which parts of the motion ended since the object last moved on. */
    private final double[] stops = new double[MOST_STOPS * CONTACT];

    private final int[] stoppedBy = new int[MOST_STOPS];
    private int stopCount;
    private static final int MOST_STOPS = 8;

    private int[] obstacles = new int[4];
    private double[] contacts = new double[4 * CONTACT];
    private boolean[] isNear = new boolean[4];
    private int count;

    private AccuracyView view;
    private int id;
    private boolean isLevel;
    private double keep;
    private double lean;
    private double length;
    private double turnFraction;

    @SuppressWarnings("NullAway.Init") // a motion begins with its view
    public Slide(ObjectRegistry registry, Motion motion) {
        this.registry = registry;
        this.motion = motion;
        planes = new SlidePlanes(registry.objects);
    }

    /** Refuses a number of contacts at which no motion may go on. */
    public static void checkBends(int bends) {
        if (bends < 0 || bends > MOST_BENDS) {
            throw new IllegalArgumentException("bends must be from 0 to " + MOST_BENDS + " (got: " + bends + ")");
        }
    }

    /** Moves an object by a displacement in the world's axes and then turns it about its own, as far as that is free. */
    public void make(
            AccuracyView inView,
            int mover,
            double x,
            double y,
            double z,
            double turnX,
            double turnY,
            double clearance,
            int bends) {
        view = inView;
        id = mover;
        Arrays.fill(made, 0);
        asked[0] = x;
        asked[1] = y;
        asked[2] = z;
        System.arraycopy(asked, 0, left, 0, 3);
        isLevel = y == 0 || isFlat();
        count = 0;
        length = 0;
        turnFraction = 1;
        double whole = size(left);
        if (whole > 0 && bends == 0) {
            toContact(clearance);
        } else if (whole > 0) {
            slide(clearance, bends, whole);
        }
        if (size(left) <= NONE * whole) {
            Arrays.fill(left, 0);
        }
        if (turnX != 0 || turnY != 0) {
            boolean free = motion.attempt(view, id, 0, 0, 0, turnX, turnY, false, clearance);
            registry.move(id, motion.end());
            if (!free) {
                turnFraction = motion.turnFraction();
                motion.contact(one);
                add(motion.obstacle(), one, 0);
            }
        }
    }

    private boolean isFlat() {
        return view.dimension == Dimension.PLANAR;
    }

    private void toContact(double clearance) {
        if (!advance(left, clearance)) {
            motion.contact(one);
            add(motion.obstacle(), one, 0);
        } else {
            Arrays.fill(left, 0);
        }
    }

    private void slide(double clearance, int bends, double whole) {
        double size = motion.size(view, id);
        keep = Math.max(clearance, SKIN * size);
        lean = LEAN * size;
        stopCount = 0;
        findPlanes();
        for (int k = 0; k < PUSHES && planes.push(keep, 2 * lean, next); k++) {
            advance(next, keep);
            findPlanes();
        }
        for (int round = 0; round <= 4 * bends + 8; round++) {
            planes.clip(left, next);
            noteContacts();
            if (count > bends || size(next) <= NONE * size(left) || dot(next, asked) <= 0) {
                return;
            }
            System.arraycopy(next, 0, left, 0, 3);
            planes.lean(next, lean);
            double before = length;
            boolean free = advance(next, keep);
            double share = free ? 1 : motion.fraction();
            for (int k = 0; k < 3; k++) {
                left[k] -= share * left[k];
            }
            if (free || size(left) <= NONE * whole) {
                Arrays.fill(left, 0);
                return;
            }
            stopCount = length - before > LEFT * whole ? 0 : Math.min(stopCount, MOST_STOPS - 1);
            motion.contact(one);
            System.arraycopy(one, 0, stops, CONTACT * stopCount, CONTACT);
            stoppedBy[stopCount++] = motion.obstacle();
            findPlanes();
        }
    }

    /** Finds the planes at the object's place, with those at which it was stopped there. */
    private void findPlanes() {
        planes.find(motion.near(view, id, keep + 4 * lean), isLevel, isFlat(), lean / LEAN);
        for (int k = 0; k < stopCount; k++) {
            System.arraycopy(stops, CONTACT * k, one, 0, CONTACT);
            planes.add(stoppedBy[k], one);
        }
        for (int k = 0; k < count; k++) {
            isNear[k] &= plane(k) >= 0;
        }
    }

    /** The plane of a contact, or -1. */
    private int plane(int contact) {
        for (int p = 0; p < planes.count(); p++) {
            if (planes.isSame(p, contacts, CONTACT * contact + 3)) {
                return p;
            }
        }
        return -1;
    }

    /** Lists the planes that what is left goes into, each once until the object has left it. */
    private void noteContacts() {
        for (int p = 0; p < planes.count(); p++) {
            if (planes.isAgainst(p, left) && !isKnown(p)) {
                for (int k = 0; k < CONTACT; k++) {
                    one[k] = planes.contact(p, k);
                }
                add(planes.obstacle(p), one, 0);
            }
        }
    }

    private boolean isKnown(int p) {
        for (int k = 0; k < count; k++) {
            if (isNear[k] && planes.isSame(p, contacts, CONTACT * k + 3)) {
                return true;
            }
        }
        return false;
    }

    /** Moves the object by a displacement as far as that is free; whether it is all free. */
    private boolean advance(double[] way, double clearance) {
        boolean free = motion.attempt(view, id, way[0], way[1], way[2], 0, 0, false, clearance);
        registry.move(id, motion.end());
        double share = free ? 1 : motion.fraction();
        length += share * size(way);
        for (int k = 0; k < 3; k++) {
            made[k] += share * way[k];
        }
        return free;
    }

    private void add(int obstacle, double[] contact, int at) {
        if (count == obstacles.length) {
            obstacles = Arrays.copyOf(obstacles, 2 * count);
            contacts = Arrays.copyOf(contacts, 2 * count * CONTACT);
            isNear = Arrays.copyOf(isNear, 2 * count);
        }
        obstacles[count] = obstacle;
        isNear[count] = true;
        System.arraycopy(contact, at, contacts, CONTACT * count, CONTACT);
        count++;
    }

    private static double dot(double[] way, double[] other) {
        return way[0] * other[0] + way[1] * other[1] + way[2] * other[2];
    }

    private static double size(double[] way) {
        return Math.sqrt(dot(way, way));
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
