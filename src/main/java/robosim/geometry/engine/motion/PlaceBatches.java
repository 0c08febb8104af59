package robosim.geometry.engine.motion;

import robosim.geometry.check.Checks;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Twist;

/**
 * Many answers at once about a moveable object at other places than its own: with a margin, with objects that do not count,
 * as numbers. Places are those of {@link FreePlaces}. Nothing is moved.
 */
public final class PlaceBatches {
    /** The numbers of a drive: a pose, a twist and its seconds. */
    public static final int DRIVE = FreePlaces.POSE + 5;

    /** The numbers of an answer about an edge: the fractions of its translation and of its turn. */
    public static final int FRACTIONS = 2;

    private final ObjectRegistry registry;
    private final Motion motion;
    private final FreePlaces places;
    private final ClearanceQuery clearance;
    private final DriveSweep drive;
    private final double[] displacement = new double[3];
    private final double[] place = new double[ObjectTable.PLACE];

    public PlaceBatches(ObjectRegistry registry, Motion motion, FreePlaces places, ClearanceQuery clearance) {
        this.registry = registry;
        this.motion = motion;
        this.places = places;
        this.clearance = clearance;
        drive = new DriveSweep(clearance, registry.width, registry.height, registry.length);
    }

    /** Checks drives before any is answered; returns how many there are. */
    public static int checkDrives(double[] drives) {
        if (Checks.present("drives", drives).length % DRIVE != 0) {
            throw new IllegalArgumentException(
                    "drives must have " + DRIVE + " numbers each (got: " + drives.length + " numbers)");
        }
        for (int at = 0; at < drives.length; at += DRIVE) {
            for (int k = 0; k < 3; k++) {
                Checks.coordinate("drives[" + (at + k) + "]", drives[at + k]);
            }
            Checks.angle("drives[" + (at + 3) + "]", drives[at + 3]);
            double seconds = drives[at + DRIVE - 1];
            if (!(seconds >= 0 && seconds < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException(
                        "drives[" + (at + DRIVE - 1) + "] must be a time of at least 0 seconds (got: " + seconds + ")");
            }
            twist(drives, at).check(seconds, drives[at], drives[at + 1], drives[at + 2]);
        }
        return drives.length / DRIVE;
    }

    private static Twist twist(double[] drives, int at) {
        int k = at + FreePlaces.POSE;
        return new Twist(drives[k], drives[k + 1], drives[k + 2], drives[k + 3]);
    }

    /** How far the object is from all others at poses, with points if there are {@link ClearanceQuery#NUMBERS} for each. */
    public int clearances(AccuracyView view, int id, double[] poses, int from, int to, double max, double[] out) {
        int stride = from == to ? 1 : out.length / (poses.length / FreePlaces.POSE);
        boolean isFull = stride >= ClearanceQuery.NUMBERS;
        int numbers = isFull ? ClearanceQuery.NUMBERS : 1;
        places.begin(id);
        int clear = 0;
        for (int k = from; k < to; k++) {
            registry.work.take();
            places.take(poses, FreePlaces.POSE * k);
            clearance.at(view, id, places.place);
            double found = isFull ? clearance.signed(id, max) : clearance.signedAlone(id, max);
            out[numbers * k] = found;
            clear += found > 0 ? 1 : 0;
            for (int n = 1; n < numbers; n++) {
                out[numbers * k + n] =
                        found == Double.POSITIVE_INFINITY ? 0 : clearance.witness()[n - 1];
            }
        }
        return clear;
    }

    /** Sets the bits of poses at which the object keeps a margin. */
    public int poses(AccuracyView view, int id, double[] poses, int from, int to, double margin, long[] free) {
        if (margin == 0) {
            return places.poses(view, id, poses, from, to, free);
        }
        places.begin(id);
        return bits(from, to, free, k -> {
            places.take(poses, FreePlaces.POSE * k);
            return keeps(view, id, margin);
        });
    }

    /** The same for edges. */
    public int edges(AccuracyView view, int id, double[] edges, int from, int to, double margin, long[] free) {
        if (margin == 0) {
            return places.edges(view, id, edges, from, to, free);
        }
        places.begin(id);
        return bits(from, to, free, k -> attempt(view, id, edges, FreePlaces.EDGE * k, margin));
    }

    /** Writes the fractions of edges that are free, two for each; returns how many edges are free. */
    public int fractions(AccuracyView view, int id, double[] edges, int from, int to, double margin, double[] out) {
        places.begin(id);
        int free = 0;
        for (int k = from; k < to; k++) {
            registry.work.take();
            boolean isFree = (margin == 0 && places.isClearlyFree(view, id, edges, FreePlaces.EDGE * k))
                    || attempt(view, id, edges, FreePlaces.EDGE * k, margin);
            free += isFree ? 1 : 0;
            out[FRACTIONS * k] = isFree ? 1 : isStartFree ? motion.fraction() : 0;
            out[FRACTIONS * k + 1] = isFree ? 1 : isStartFree ? motion.turnFraction() : 0;
        }
        return free;
    }

    /** Writes the fractions of drives that are free; returns how many are free as a whole. */
    public int drives(AccuracyView view, int id, double[] drives, int from, int to, double margin, double[] out) {
        places.begin(id);
        int free = 0;
        for (int k = from; k < to; k++) {
            registry.work.take();
            int at = DRIVE * k;
            places.take(drives, at);
            out[k] = drive.share(view, id, places.place, twist(drives, at), drives[at + DRIVE - 1], margin);
            free += out[k] == 1 ? 1 : 0;
        }
        return free;
    }

    /**
     * Tries a motion with a constant twist from the object's own place. The sweep of a turn resolves a share of the radius of
     * the arc. So a wide one that it refuses is also measured like a drive, and goes on from where that ends.
     */
    public boolean attemptTwist(AccuracyView view, int id, Twist twist, double seconds, double gap) {
        if (motion.attemptTwist(view, id, twist, seconds, gap)) {
            return true;
        }
        if (!motion.isWide()) {
            return false;
        }
        System.arraycopy(registry.objects.places(), registry.objects.place(id), place, 0, place.length);
        double free = drive.share(view, id, place, twist, seconds, gap);
        if (free <= motion.fraction()) {
            return false;
        }
        twist.after(place, 0, free * seconds, place);
        return motion.attemptRest(view, id, place, twist, seconds, gap, free);
    }

    /** Whether the object was free at the first pose of the last edge. */
    private boolean isStartFree;

    private boolean attempt(AccuracyView view, int id, double[] edges, int at, double margin) {
        places.take(edges, at);
        isStartFree = margin > 0 ? keeps(view, id, margin) : places.isPresent() || places.isFreeHere(view, id);
        if (!isStartFree) {
            return false;
        }
        for (int axis = 0; axis < 3; axis++) {
            displacement[axis] = edges[at + FreePlaces.POSE + axis] - places.place[axis];
        }
        double degrees = edges[at + FreePlaces.POSE + 3] - edges[at + 3];
        return motion.attemptFrom(view, id, places.place, displacement, degrees, margin);
    }

    /** Whether the object at the place taken is within the world and keeps a margin from all others. */
    private boolean keeps(AccuracyView view, int id, double margin) {
        clearance.at(view, id, places.place);
        return clearance.distance(id, margin) >= margin
                && drive.borderGap(view.dimension, margin) >= margin
                && registry.fitsAt(id, places.place);
    }

    /** A question about one of many places. */
    private interface Question {
        boolean isFree(int k);
    }

    private int bits(int from, int to, long[] free, Question question) {
        int found = 0;
        for (int first = from; first < to; first += Long.SIZE) {
            long bits = 0;
            for (int k = first; k < Math.min(first + Long.SIZE, to); k++) {
                registry.work.take();
                bits |= question.isFree(k) ? 1L << k : 0;
            }
            free[first / Long.SIZE] = bits;
            found += Long.bitCount(bits);
        }
        return found;
    }
}
