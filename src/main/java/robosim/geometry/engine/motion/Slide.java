package robosim.geometry.engine.motion;

import java.util.Arrays;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Pose;

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

    /** What normals are off: at first, and at most, after steps along planes that were stopped at once. */
    private static final double OFF = 0x1p-43;

    private static final double MOST_OFF = 0x1p-17;

    /** A step that makes less than this share of its length was stopped at once. */
    private static final double HARDLY = 0x1p-10;

    /** Displacements below this share of the whole are none. */
    private static final double NONE = 0x1p-40;

    /** Planes count as left after this share of the whole displacement. */
    private static final double LEFT = 0x1p-30;

    /** What a normal of level ground may be off. */
    private static final double UPRIGHT = 0x1p-20;

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
    private double clearance;
    private int bends;
    private double stepHeight;
    private double maxSlope;
    private double snap;
    private boolean isLevel;
    private double whole;
    private double keep;
    private double lean;

    private final double[] start = new double[ObjectTable.PLACE];
    private final double[] place = new double[ObjectTable.PLACE];
    private final double[] above = new double[ObjectTable.PLACE];
    private final double[] landed = new double[ObjectTable.PLACE];
    private final double[] leftBefore = new double[3];
    private double length;
    private double turnFraction;

    @SuppressWarnings("NullAway.Init") // a motion begins with its view
    public Slide(ObjectRegistry registry, Motion motion) {
        this.registry = registry;
        this.motion = motion;
        planes = new SlidePlanes(registry.objects);
    }

    /** Sets how the next motions go: see the options of {@code Geometry.moveAndSlide}. */
    public void set(double toKeep, int mostBends, double highestStep, double steepest, double snapDown) {
        clearance = toKeep;
        bends = mostBends;
        stepHeight = highestStep;
        maxSlope = steepest;
        snap = snapDown;
    }

    /**
     * Moves an object by a displacement in the world's axes and then turns it about its own, as far as that is free. If it throws,
     * the object is where it was.
     */
    public void make(AccuracyView inView, int mover, double[] way, double turnX, double turnY) {
        view = inView;
        id = mover;
        savePlace(start);
        boolean isMade = false;
        try {
            go(way, turnX, turnY);
            isMade = true;
        } finally {
            if (!isMade) {
                registry.move(id, start);
            }
        }
    }

    private void go(double[] way, double turnX, double turnY) {
        System.arraycopy(way, 0, asked, 0, 3);
        System.arraycopy(asked, 0, left, 0, 3);
        isLevel = asked[1] == 0 || isFlat();
        boolean isWalk = isLevel && !isFlat() && (stepHeight > 0 || maxSlope < 90 || snap > 0);
        planes.walkOn(isWalk ? StrictMath.cos(StrictMath.toRadians(maxSlope)) : -1);
        count = 0;
        length = 0;
        turnFraction = 1;
        whole = size(left);
        if (whole > 0 && bends == 0) {
            toContact();
        } else if (whole > 0) {
            measure();
            slide();
            if (isWalk && stepHeight > 0 && count > 0) {
                step();
            }
        }
        if (isWalk && snap > 0) {
            measure();
            snap();
        }
        if (size(left) <= NONE * whole) {
            Arrays.fill(left, 0);
        }
        savePlace(place);
        for (int k = 0; k < 3; k++) {
            made[k] = place[k] - start[k] + (place[Pose.LOST + k] - start[Pose.LOST + k]);
        }
        if (turnX != 0 || turnY != 0) {
            turn(turnX, turnY);
        }
    }

    private void turn(double turnX, double turnY) {
        boolean free = motion.attemptTurns(view, id, turnX, turnY, clearance);
        motion.commit();
        if (!free) {
            turnFraction = motion.turnFraction();
            motion.contact(one);
            add(motion.touched());
        }
    }

    private boolean isFlat() {
        return view.dimension == Dimension.PLANAR;
    }

    private void savePlace(double[] out) {
        System.arraycopy(registry.objects.places(), registry.objects.place(id), out, 0, ObjectTable.PLACE);
    }

    private void toContact() {
        if (!advance(left, clearance)) {
            motion.contact(one);
            add(motion.touched());
        } else {
            Arrays.fill(left, 0);
        }
    }

    private void measure() {
        double size = motion.size(view, id);
        keep = Math.max(clearance, SKIN * size);
        lean = LEAN * size;
    }

    /** Makes what is left, along what is in its path. */
    private void slide() {
        double off = OFF;
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
            planes.lean(next, off, lean);
            double before = length;
            boolean free = advance(next, keep);
            double share = free ? 1 : motion.fraction();
            for (int k = 0; k < 3; k++) {
                left[k] -= share * left[k];
            }
            off = share < HARDLY ? Math.min(16 * off, MOST_OFF) : OFF;
            if (free || size(left) <= NONE * whole) {
                Arrays.fill(left, 0);
                return;
            }
            stopCount = length - before > LEFT * whole ? 0 : Math.min(stopCount, MOST_STOPS - 1);
            motion.contact(one);
            System.arraycopy(one, 0, stops, CONTACT * stopCount, CONTACT);
            stoppedBy[stopCount++] = motion.touched();
            findPlanes();
        }
    }

    /**
     * Tries the same displacement a step higher, and then down onto ground, and goes there if that is farther. A landing on an
     * edge too steep to be ground counts if there is ground at that height half an object's width ahead.
     */
    private void step() {
        savePlace(place);
        double farBefore = progress(place);
        double lengthBefore = length;
        System.arraycopy(left, 0, leftBefore, 0, 3);
        int countBefore = count;
        registry.move(id, start);
        length = 0;
        count = 0;
        set(0, stepHeight, 0);
        boolean isWhole = advance(next, keep);
        double rise = (isWhole ? 1 : motion.fraction()) * stepHeight;
        System.arraycopy(asked, 0, left, 0, 3);
        slide();
        savePlace(above);
        set(0, -rise, 0);
        boolean isAir = advance(next, keep + 4 * lean);
        savePlace(landed);
        boolean isFarther = progress(landed) > farBefore + NONE * whole;
        if (isFarther && (isAir || isOnGround() || hasGroundAhead(rise))) {
            registry.move(id, landed);
            return;
        }
        registry.move(id, place);
        length = lengthBefore;
        count = countBefore;
        System.arraycopy(leftBefore, 0, left, 0, 3);
    }

    /** How far a place is from the start in the direction that was asked for, times the length of that. */
    private double progress(double[] at) {
        double far = 0;
        for (int k = 0; k < 3; k++) {
            far += (at[k] - start[k]) * asked[k];
        }
        return far / whole;
    }

    private boolean isOnGround() {
        motion.contact(one);
        return one[4] >= StrictMath.cos(StrictMath.toRadians(maxSlope)) - UPRIGHT;
    }

    private boolean hasGroundAhead(double rise) {
        double reach = motion.reach(view, id) / whole;
        double before = length;
        registry.move(id, above);
        set(reach * asked[0], 0, reach * asked[2]);
        advance(next, keep);
        set(0, -rise, 0);
        boolean isGround = !advance(next, keep) && isOnGround();
        length = before;
        return isGround;
    }

    /** Puts the object down on ground that is near below it. */
    private void snap() {
        set(0, -snap, 0);
        double before = length;
        savePlace(place);
        boolean isAir = advance(next, keep + 4 * lean); // so that level steps have room for rounding
        boolean isDown = motion.fraction() * snap > 8 * lean;
        if (isAir || !isDown || !isOnGround()) {
            registry.move(id, place);
            length = before;
        }
    }

    private void set(double x, double y, double z) {
        next[0] = x;
        next[1] = y;
        next[2] = z;
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
                add(planes.obstacle(p));
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
    private boolean advance(double[] way, double gap) {
        boolean free = motion.attempt(view, id, way[0], way[1], way[2], 0, 0, gap);
        motion.commit();
        length += (free ? 1 : motion.fraction()) * size(way);
        return free;
    }

    /** Lists the contact that was found last. */
    private void add(int obstacle) {
        if (count == obstacles.length) {
            obstacles = Arrays.copyOf(obstacles, 2 * count);
            contacts = Arrays.copyOf(contacts, 2 * count * CONTACT);
            isNear = Arrays.copyOf(isNear, 2 * count);
        }
        obstacles[count] = obstacle;
        isNear[count] = true;
        System.arraycopy(one, 0, contacts, CONTACT * count, CONTACT);
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
