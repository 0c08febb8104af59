package robosim.geometry.engine.broadphase;

import java.util.Arrays;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;

/**
 * The objects nearest to a place, found once for all cones that begin there, each with the cones that may meet it: those that
 * look, as seen from above, where it stands.
 */
public final class ConeCandidates {
    /** The most cones: one for each bit of a long. */
    public static final int MOST = Long.SIZE;

    /** The most objects that are kept; a cone that looks past them is searched alone. */
    private static final int MOST_FOUND = 32;

    /** Where fewer are found, the next time it is looked farther. */
    private static final int FEW = 12;

    /** How often it is looked less far before that is given up; the next time goes on there. */
    private static final int TRIES = 4;

    /** By how much. */
    private static final double WIDER = 1.25;

    /** Parts of a turn, each with the cones that look there. */
    private static final int PARTS = 64;

    /** More than what is rounded here, and than what a certified shape is taken larger by. */
    private static final double PAD = 0x1p-40;

    private final long[] looking = new long[PARTS];

    private double ox;
    private double oy;
    private double oz;

    // The objects that were found, nearest first.
    private final int[] ids = new int[MOST_FOUND];
    private final double[] distances = new double[MOST_FOUND];
    private final long[] cones = new long[MOST_FOUND];
    private int count;
    private double complete;

    /** How far it is looked to each side, which is learnt from how many objects are found. */
    private double radius = Double.POSITIVE_INFINITY;

    private final BoxQuery query;
    private final double[] box = new double[6];

    /** Whether there are more objects than can be kept. */
    private boolean isFull;

    /** For a world of objects. */
    public ConeCandidates(ObjectTable objects) {
        query = new BoxQuery(objects, this::add);
    }

    /** Forgets all, and takes a place. */
    void start(double x, double y, double z) {
        ox = x;
        oy = y;
        oz = z;
        count = 0;
        Arrays.fill(looking, 0);
    }

    /**
     * Adds a cone that is a sector as seen from above.
     *
     * @param ax where its axis points from above, of length 1
     * @param sin of half its angle from above, rounded up
     */
    void add(int cone, double ax, double az, double sin) {
        double cos = Math.sqrt((1 - sin) * (1 + sin));
        int from = part(ax * cos + az * sin, az * cos - ax * sin);
        int to = part(ax * cos - az * sin, az * cos + ax * sin);
        for (int part = from; part != to; part = part + 1 & PARTS - 1) {
            looking[part] |= 1L << cone;
        }
        looking[to] |= 1L << cone;
    }

    /** Adds a cone that looks all ways as seen from above. */
    void add(int cone) {
        for (int part = 0; part < PARTS; part++) {
            looking[part] |= 1L << cone;
        }
    }

    /** Whether the cones look at most of what is around. */
    public boolean isAround() {
        int parts = 0;
        for (long each : looking) {
            parts += each != 0 ? 1 : 0;
        }
        return parts >= PARTS / 2;
    }

    /**
     * Finds the objects around.
     *
     * @param limit how far the cones look
     * @return false where there are too many even near by
     */
    public boolean open(AccuracyView view, double limit) {
        radius = Math.min(radius, view.own.extent);
        isFull = true;
        for (int k = 0; k < TRIES && isFull; k++) {
            gather(view, Math.min(radius, limit));
        }
        if (count < FEW && radius < limit) {
            radius *= WIDER;
        }
        return !isFull;
    }

    private void gather(AccuracyView view, double within) {
        around(0, ox, within);
        around(1, oy, within);
        around(2, oz, within);
        count = 0;
        isFull = false;
        complete = within;
        query.each(view, box, -1);
        if (isFull) {
            radius = within / WIDER;
        }
    }

    private void around(int axis, double middle, double within) {
        // Rounded outward, so that nothing within is left out.
        box[axis] = Math.nextDown(middle - within);
        box[axis + 3] = Math.nextUp(middle + within);
    }

    /** Keeps an object at its place in the order of distances. */
    private boolean add(LeafTable table, int id) {
        if (count == MOST_FOUND) {
            isFull = true;
            return true;
        }
        long seeing = lookingAt(table.bounds(), table.boundsAt(id));
        if (seeing == 0) {
            return false;
        }
        double distance = distance(table, id);
        int at = count++;
        for (; at > 0 && distances[at - 1] > distance; at--) {
            ids[at] = ids[at - 1];
            distances[at] = distances[at - 1];
            cones[at] = cones[at - 1];
        }
        ids[at] = id;
        distances[at] = distance;
        cones[at] = seeing;
        return false;
    }

    /** A lower bound of how far the bounds of an object are, up to the radius. */
    private double distance(LeafTable table, int id) {
        double[] b = table.bounds();
        int k = table.boundsAt(id);
        double dx = Math.max(0, Math.max(b[k] - ox, ox - b[k + 3]));
        double dz = Math.max(0, Math.max(b[k + 2] - oz, oz - b[k + 5]));
        double dy = table.dimension == Dimension.PLANAR ? 0 : Math.max(0, Math.max(b[k + 1] - oy, oy - b[k + 4]));
        return VectorMath.anyLength(dx, dy, dz) * (1 - PAD);
    }

    /** How many objects were found. */
    int count() {
        return count;
    }

    /** Up to where no object is left out. */
    double complete() {
        return complete;
    }

    /** All objects that meet this box were found. */
    double[] box() {
        return box;
    }

    int id(int number) {
        return ids[number];
    }

    /** A lower bound of how far an object is. */
    double distance(int number) {
        return distances[number];
    }

    /** Whether a cone may meet an object. */
    boolean mayTouch(int number, int cone) {
        return (cones[number] >>> cone & 1) != 0;
    }

    /** The cones that look where a box stands. */
    private long lookingAt(double[] b, int k) {
        double pad = PAD
                * (Math.abs(ox)
                        + Math.abs(oz)
                        + Math.abs(b[k])
                        + Math.abs(b[k + 2])
                        + Math.abs(b[k + 3])
                        + Math.abs(b[k + 5]));
        double minX = b[k] - ox - pad;
        double maxX = b[k + 3] - ox + pad;
        double minZ = b[k + 2] - oz - pad;
        double maxZ = b[k + 5] - oz + pad;
        if (minX > 0) {
            return between(minZ < 0 ? minX : maxX, minZ, maxZ > 0 ? minX : maxX, maxZ);
        }
        if (maxX < 0) {
            return between(maxZ > 0 ? maxX : minX, maxZ, minZ < 0 ? maxX : minX, minZ);
        }
        if (minZ > 0) {
            return between(maxX, minZ, minX, minZ);
        }
        return maxZ < 0 ? between(minX, maxZ, maxX, maxZ) : -1;
    }

    /** The cones that look anywhere from one direction to another, turning from +X to +Z. */
    private long between(double fromX, double fromZ, double toX, double toZ) {
        int from = part(fromX, fromZ);
        int to = part(toX, toZ);
        long found = looking[to];
        for (int part = from; part != to; part = part + 1 & PARTS - 1) {
            found |= looking[part];
        }
        return found;
    }

    /** The part of a turn that a direction is in: a quarter for each two signs, and there by the share of one coordinate. */
    private static int part(double x, double z) {
        double sum = Math.abs(x) + Math.abs(z);
        double turn = z >= 0 ? (x >= 0 ? z / sum : 1 - x / sum) : x < 0 ? 2 - z / sum : 3 + x / sum;
        return (int) (turn * (PARTS / 4)) & PARTS - 1;
    }
}
