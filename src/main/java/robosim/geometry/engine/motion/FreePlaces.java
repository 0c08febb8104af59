package robosim.geometry.engine.motion;

import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.Candidates;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.objects.ObjectLeaves;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Attitude;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.StartContacts;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.planar.PlainCells;

/**
 * Whether a moveable object could stand at other places than its own, and go from one to another: many answers at once,
 * as bits. Nothing is moved.
 */
public final class FreePlaces {
    /** The numbers of a pose: X, Y, Z and the heading. */
    public static final int POSE = 4;

    /** The numbers of an edge: two poses. */
    public static final int EDGE = 2 * POSE;

    private final ObjectRegistry registry;
    private final Motion motion;
    private final Scratch scratch;

    /** Made for the first edge, as many worlds are asked about none. */
    private @Nullable EdgeFastPath fastPath;

    final double[] place = new double[ObjectTable.PLACE];

    /** The heading of the place as it was given. */
    private double heading = Double.NaN;

    /** Where the object is. */
    private final double[] present = new double[ObjectTable.PLACE];

    /** Whether the place is where the object is. */
    private boolean isPresent;

    private final Candidates candidates;
    private final StartContacts standing;
    private final Sweep sweep;
    private final LeafColumn here = new LeafColumn(1);
    private final LeafColumn there = new LeafColumn(1);
    private final double[] box = new double[6];

    /** Whether the object touches nothing where it is. */
    private boolean isStandingKnown;

    private boolean isAloft;

    public FreePlaces(ObjectRegistry registry, Motion motion, Scratch scratch) {
        this.scratch = scratch;
        this.registry = registry;
        this.motion = motion;
        candidates = new Candidates(registry.objects);
        standing = new StartContacts(scratch);
        sweep = new Sweep(scratch);
    }

    /**
     * Checks numbers and the array for their answers before any of them is given.
     *
     * @param stride how many numbers belong to one answer
     * @return how many answers there are
     */
    public static int check(String argument, double[] numbers, int stride, long[] free) {
        int count = check(argument, numbers, stride);
        checkRoom(count, free);
        return count;
    }

    /** Checks numbers; returns how many answers there are. */
    public static int check(String argument, double[] numbers, int stride) {
        Checks.present(argument, numbers);
        if (numbers.length % stride != 0) {
            throw new IllegalArgumentException(
                    argument + " must have " + stride + " numbers each (got: " + numbers.length + " numbers)");
        }
        for (int k = 0; k < numbers.length; k++) {
            double number = numbers[k];
            boolean isHeading = k % POSE == POSE - 1;
            if (!(Math.abs(number) <= (isHeading ? Double.MAX_VALUE : Checks.LIMIT))) {
                refuse(argument + "[" + k + "]", number, isHeading);
            }
        }
        if (stride == EDGE) {
            checkTurns(argument, numbers);
        }
        return numbers.length / stride;
    }

    /** Checks that an array has room for so many bits. */
    public static void checkRoom(int count, long[] free) {
        if (Checks.present("free", free).length < words(count)) {
            throw new IllegalArgumentException("free must have at least " + words(count) + " elements for " + count
                    + " bits (got: " + free.length + ")");
        }
    }

    private static void refuse(String argument, double number, boolean isHeading) {
        if (isHeading) {
            Checks.angle(argument, number);
        } else {
            Checks.coordinate(argument, number);
        }
    }

    private static void checkTurns(String argument, double[] edges) {
        for (int at = POSE - 1; at < edges.length; at += EDGE) {
            double turn = edges[at + POSE] - edges[at];
            if (!Double.isFinite(turn)) {
                Checks.angle("turn from " + argument + "[" + at + "] to [" + (at + POSE) + "]", turn);
            }
        }
    }

    /** How many elements of an array have so many bits. */
    public static int words(int bits) {
        return (bits + Long.SIZE - 1) / Long.SIZE;
    }

    /**
     * Sets the bits of poses at which an object is free, and clears the others.
     *
     * @param from the first pose, a multiple of 64
     * @param to   behind the last one
     * @return how many are free
     */
    public int poses(AccuracyView view, int id, double[] poses, int from, int to, long[] free) {
        begin(id);
        int found = 0;
        boolean isSingle = view.isSingle(id);
        double before = Double.NaN; // the heading of the pose before
        for (int first = from; first < to; first += Long.SIZE) {
            long bits = 0;
            for (int k = first; k < Math.min(first + Long.SIZE, to); k++) {
                scratch.work.take();
                take(poses, POSE * k);
                boolean isShifted = isSingle && heading == before;
                before = heading;
                boolean collides =
                        isShifted ? registry.collidesShifted(view, id, place) : registry.collidesAt(view, id, place);
                if (collides ? !(isStandingKnown && isAloft) : !registry.isClearlyInside()) {
                    before = Double.NaN; // as the object is placed again
                    collides = !registry.fitsAt(id, place) || (collides && !stands(view, id));
                }
                bits |= collides ? 0 : 1L << k;
            }
            free[first / Long.SIZE] = bits;
            found += Long.bitCount(bits);
        }
        return found;
    }

    /** The same for edges along which it is free. */
    public int edges(AccuracyView view, int id, double[] edges, int from, int to, long[] free) {
        EdgeFastPath quick = fastPath();
        begin(id);
        int found = 0;
        for (int first = from; first < to; first += Long.SIZE) {
            long bits = 0;
            for (int k = first; k < Math.min(first + Long.SIZE, to); k++) {
                scratch.work.take();
                bits |= isFree(quick, view, id, edges, EDGE * k) ? 1L << k : 0;
            }
            free[first / Long.SIZE] = bits;
            found += Long.bitCount(bits);
        }
        return found;
    }

    private EdgeFastPath fastPath() {
        EdgeFastPath made = fastPath;
        if (made == null) {
            made = new EdgeFastPath(registry.objects, registry.worldBounds, scratch);
            fastPath = made;
        }
        return made;
    }

    /** Whether doubles tell that an edge is free. */
    boolean isClearlyFree(AccuracyView view, int id, double[] edges, int at) {
        return quickly(fastPath(), view, id, edges, at) == PlainCells.PAST;
    }

    /** Takes the first pose of an edge, and what doubles tell of the edge; they tell nothing while objects are ignored. */
    private int quickly(EdgeFastPath quick, AccuracyView view, int id, double[] edges, int at) {
        take(edges, at);
        return registry.objects.ignored.isEmpty()
                ? quick.find(
                        view,
                        id,
                        place,
                        edges[at + POSE] - place[0],
                        edges[at + POSE + 1] - place[1],
                        edges[at + POSE + 2] - place[2],
                        edges[at + POSE + 3] - edges[at + 3])
                : PlainCells.UNSURE;
    }

    private boolean isFree(EdgeFastPath quick, AccuracyView view, int id, double[] edges, int at) {
        int verdict = quickly(quick, view, id, edges, at);
        double dx = edges[at + POSE] - place[0];
        double dy = edges[at + POSE + 1] - place[1];
        double dz = edges[at + POSE + 2] - place[2];
        double degrees = edges[at + POSE + 3] - edges[at + 3];
        if (verdict == PlainCells.PAST) {
            return true;
        }
        if (verdict != PlainCells.UNSURE && !isPresent && isAloft(view, id)) {
            return false; // else contacts at the present place may spare what it meets
        }
        return (isPresent || isFreeHere(view, id)) && motion.allowsFrom(view, id, place, dx, dy, dz, degrees);
    }

    /** Whether the place taken last is where the object is. */
    boolean isPresent() {
        return isPresent;
    }

    /** Whether the place is in the world, and the object touches nothing there but what its contacts spare. */
    boolean isFreeHere(AccuracyView view, int id) {
        return registry.fitsAt(id, place) && (!registry.collidesAt(view, id, place) || stands(view, id));
    }

    /** Puts an object upright at a place that it touches, where it may stand on what it stands on now. */
    public boolean stand(AccuracyView view, int id, Point center, double headingThere) {
        begin(id);
        Pose.of(center, headingThere).place(place, 0);
        heading = Double.NaN;
        boolean isFree = registry.fitsAt(id, place) && stands(view, id);
        if (isFree) {
            registry.move(id, place);
        }
        return isFree;
    }

    void begin(int id) {
        System.arraycopy(registry.objects.places(), registry.objects.place(id), present, 0, present.length);
        heading = Double.NaN;
        isStandingKnown = false;
    }

    /**
     * Makes {@link #place} a pose: the object as it is tipped now, turned about the vertical until its heading is that of the
     * pose.
     */
    void take(double[] poses, int at) {
        double degrees = poses[at + 3] + 0.0;
        if (degrees != heading) { // planners ask about many places with one heading
            heading = degrees;
            System.arraycopy(present, 3, place, 3, Attitude.STRIDE);
            if (!Attitude.isUpright(present, 3)) {
                Attitude.turnVertically(place, 3, degrees - Attitude.heading(present, 3));
            } else if (degrees != Attitude.heading(present, 3)) {
                Attitude.setHeading(place, 3, degrees, 0);
            }
        }
        isPresent = degrees == Attitude.heading(present, 3);
        for (int axis = 0; axis < 3; axis++) {
            place[axis] = poses[at + axis] + 0.0; // no -0.0
            isPresent &= place[axis] == present[axis];
        }
        for (int k = Pose.LOST; k < ObjectTable.PLACE; k++) {
            place[k] = isPresent ? present[k] : 0;
        }
    }

    /**
     * Whether all that the object touches at the place is behind planes of what it touches where it is, such as the floor that
     * it stands on: see {@link StartContacts}.
     */
    private boolean stands(AccuracyView view, int id) {
        if (isAloft(view, id)) {
            return false;
        }
        put(view, id, place, there);
        find(view, id, there);
        for (int k = 0; k < candidates.count(); k++) {
            LeafTable of = view.table(candidates.id(k));
            int first = of.first(candidates.id(k));
            for (int j = first; j < first + of.count(candidates.id(k)); j++) {
                for (int i = 0; i < there.size(); i++) {
                    if (standing.touchesThere(there, i, of.leaves(), j)) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    /** Whether the object touches nothing where it is that could spare anything. */
    private boolean isAloft(AccuracyView view, int id) {
        if (isStandingKnown) {
            return isAloft;
        }
        isStandingKnown = true;
        put(view, id, present, here);
        sweep.translation(view.dimension, 0, 0, 0);
        standing.begin(view.dimension, sweep, here, there);
        find(view, id, here);
        put(view, id, present, there);
        for (int k = 0; k < candidates.count(); k++) {
            LeafTable of = view.table(candidates.id(k));
            int first = of.first(candidates.id(k));
            for (int j = first; j < first + of.count(candidates.id(k)); j++) {
                standing.add(of.leaves(), j);
            }
        }
        isAloft = standing.isEmpty();
        return isAloft;
    }

    private static void put(AccuracyView view, int id, double[] at, LeafColumn out) {
        ObjectLeaves form = view.form(id);
        out.clear();
        out.append(form.size());
        form.place(view.dimension, at[0], at[1], at[2], at, 3, out, 0);
    }

    private void find(AccuracyView view, int id, LeafColumn leaves) {
        leaves.bounds(0, leaves.size(), box);
        candidates.find(view, box, id);
    }
}
