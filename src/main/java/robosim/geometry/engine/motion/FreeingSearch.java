package robosim.geometry.engine.motion;

import java.util.Arrays;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Dimension;

/**
 * Finds a short displacement that frees an object which touches or overlaps others. Candidates are the least displacement out of
 * all overlaps at once, found plane by plane, and free places along fixed directions; from each the object slides back toward
 * its start, as near as it comes. A candidate is taken only if its place is free and the way there passes through nothing but
 * pieces that the object touches at the start.
 */
public final class FreeingSearch {
    /** Most times that planes are added to those which a displacement has to leave. */
    private static final int ROUNDS = 24;

    /** Distances that are tried along a direction: the largest, halved up to so many times. */
    private static final int HALVINGS = 7;

    /** How far beyond a plane, as a share of the magnitudes of the bounds. */
    private static final double BEYOND = 0x1p-36;

    /** Directions along which free places are looked for. */
    private static final int DIRECTIONS = 48;

    /** The golden angle, in radians: points at multiples of it, on equal steps of height, cover a sphere evenly. */
    private static final double GOLDEN = Math.PI * (3 - Math.sqrt(5));

    private final ObjectRegistry registry;
    private final Motion motion;
    private final Slide slide;
    private final double[] start = new double[ObjectTable.PLACE];
    private final double[] place = new double[ObjectTable.PLACE];
    private final double[] best = new double[3];
    private final double[] way = new double[3];
    private final HalfSpaces spaces = new HalfSpaces();
    private double least;
    private double size;
    private AccuracyView view;
    private int id;

    @SuppressWarnings("NullAway.Init") // a search sets its view
    public FreeingSearch(ObjectRegistry registry, Motion motion, Slide slide) {
        this.registry = registry;
        this.motion = motion;
        this.slide = slide;
    }

    /** Frees an object by at most a distance and writes the displacement; false, and nothing is moved, if none is found. */
    public boolean find(AccuracyView inView, int mover, double max, double[] out) {
        view = inView;
        id = mover;
        System.arraycopy(registry.objects.places(), registry.objects.place(id), start, 0, ObjectTable.PLACE);
        boolean isDone = false;
        try {
            boolean found = find(max, out);
            isDone = true;
            return found;
        } finally {
            if (!isDone) {
                registry.move(id, start); // what threw may have left it anywhere
            }
        }
    }

    private boolean find(double max, double[] out) {
        Arrays.fill(out, 0, 3, 0);
        if (!registry.collidesAt(view, id, start)) {
            return true;
        }
        size = motion.size(view, id);
        least = Double.POSITIVE_INFINITY;
        outOfPlanes(max);
        for (int k = 0; k < DIRECTIONS; k++) {
            along(k, max);
        }
        if (least == Double.POSITIVE_INFINITY) {
            registry.move(id, start);
            return false;
        }
        placeAt(best);
        registry.move(id, place);
        System.arraycopy(best, 0, out, 0, 3);
        return true;
    }

    private void placeAt(double[] by) {
        System.arraycopy(start, 0, place, 0, ObjectTable.PLACE);
        for (int k = 0; k < 3; k++) {
            place[k] = start[k] + by[k];
        }
    }

    private boolean isFree(double[] by) {
        placeAt(by);
        return registry.fitsAt(id, place) && !registry.collidesAt(view, id, place);
    }

    /** Leaves the shallowest plane of each piece that is touched, and again of those that are touched there. */
    private void outOfPlanes(double max) {
        spaces.clear();
        Arrays.fill(way, 0);
        for (int round = 0; round < ROUNDS; round++) {
            placeAt(way);
            registry.move(id, place);
            NearPairs pairs = motion.near(view, id, 0);
            int before = spaces.count();
            for (int k = 0; k < pairs.count(); k++) {
                if (pairs.gap(k) == 0) {
                    spaces.add(pairs, k, way, BEYOND * size);
                }
            }
            if (spaces.count() == before) {
                break;
            }
            if (!spaces.least(way) || length(way) > max) {
                registry.move(id, start);
                return;
            }
        }
        registry.move(id, start);
        take(max);
    }

    /** Tries places along a direction, the nearest first, and slides back from the first one that is free. */
    private void along(int k, double max) {
        boolean isFlat = view.dimension == Dimension.PLANAR;
        double y = isFlat ? 0 : 1 - 2 * (k + 0.5) / DIRECTIONS;
        double across = Math.sqrt(1 - y * y);
        double around = isFlat ? 2 * Math.PI * k / DIRECTIONS : GOLDEN * k;
        double x = across * StrictMath.cos(around);
        double z = across * StrictMath.sin(around);
        for (double far = max / (1 << HALVINGS); far <= max; far *= 2) {
            way[0] = far * x;
            way[1] = far * y;
            way[2] = far * z;
            if (isFree(way)) {
                take(max);
                slideBack();
                take(max);
                return;
            }
        }
    }

    private void slideBack() {
        placeAt(way);
        registry.move(id, place);
        double[] back = {-way[0], -way[1], -way[2]};
        slide.set(0, 4, 0, 90, 0);
        slide.make(view, id, back, 0, 0);
        int at = registry.objects.place(id);
        for (int k = 0; k < 3; k++) {
            way[k] = registry.objects.places()[at + k] - start[k];
        }
        registry.move(id, start);
    }

    /** Makes the displacement the best one, if it is shorter, ends at a free place and goes through nothing untouched. */
    private void take(double max) {
        double length = length(way);
        if (length < least && length <= max && isFree(way) && motion.passes(view, id, way)) {
            least = length;
            System.arraycopy(way, 0, best, 0, 3);
        }
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
}
