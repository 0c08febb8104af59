package robosim.geometry.engine.broadphase;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;

/**
 * The objects nearest to a place, found once for all cones that begin there, each with the cones that may meet it: those that
 * look, as seen from above, where it stands. They are found nearest first, and no farther than a cone looks.
 */
public final class ConeCandidates {
    /** The most cones: one for each bit of a long. */
    public static final int MOST = Long.SIZE;

    /** The most objects that are kept; a cone that looks past them is searched alone. */
    private static final int MOST_FOUND = 32;

    /** Where more are in no tree, nothing is shared. */
    private static final int MOST_BESIDE = 20;

    /** If most cones looked past what was found, so often all are searched alone. */
    private static final int REST = 15;

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

    /** No more are found for these cones. */
    private boolean isClosed;

    /** How far it is looked. */
    private double limit;

    // Where more objects come from: of each the next one, and a lower bound of how far all that are left there are.
    private LeafTable own;
    private int ownNext;
    private double ownFrom;
    private @Nullable LeafTable shared;
    private int sharedNext;
    private double sharedFrom;

    /** The objects that are in no tree, nearest first. */
    private final int[] beside = new int[MOST_BESIDE];

    private final double[] besideFrom = new double[MOST_BESIDE + 1];
    private int besideCount;
    private int besideNext;

    private final ObjectTable objects;
    private final double[] box = new double[6];

    private int coneCount;

    /** How many of the cones looked past what was found. */
    private int past;

    private int rest;

    /** For a world of objects. */
    @SuppressWarnings("NullAway.Init") // it is opened with a view
    public ConeCandidates(ObjectTable objects) {
        this.objects = objects;
    }

    /** Whether cones are likely to share anything, as the last ones did. */
    public boolean isWorthwhile() {
        if (2 * past > coneCount) {
            past = 0;
            rest = REST;
        }
        return rest-- <= 0;
    }

    /** Forgets all, and takes a place. */
    void start(double x, double y, double z) {
        ox = x;
        oy = y;
        oz = z;
        coneCount = 0;
        past = 0;
        rest = 0;
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
        coneCount++;
    }

    /** Adds a cone that looks all ways as seen from above. */
    void add(int cone) {
        for (int part = 0; part < PARTS; part++) {
            looking[part] |= 1L << cone;
        }
        coneCount++;
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
     * Begins to find the objects around.
     *
     * @param most how far the cones look
     * @return false where too many are in no tree
     */
    public boolean open(AccuracyView view, double most) {
        own = view.own;
        shared = view.shared;
        LeafTable others = view.shared;
        limit = most + PAD * (most + own.extent + Math.abs(ox) + Math.abs(oy) + Math.abs(oz));
        count = 0;
        isClosed = false;
        besideCount = 0;
        besideNext = 0;
        for (int k = 0; k < own.moversBesideTree(); k++) {
            addBeside(own, objects.mover(k));
        }
        addGrids(own);
        if (others != null) {
            addGrids(others);
        }
        if (besideCount > MOST_BESIDE) {
            return false;
        }
        besideFrom[besideCount] = Double.POSITIVE_INFINITY;
        start(own);
        takeOwn();
        sharedFrom = Double.POSITIVE_INFINITY;
        if (others != null) {
            start(others);
            takeShared(others);
        }
        return true;
    }

    private void addGrids(LeafTable table) {
        for (int k = 0; k < table.gridCount(); k++) {
            addBeside(table, table.grid(k));
        }
    }

    /** Keeps an object that is in no tree at its place in the order of distances. */
    private void addBeside(LeafTable table, int id) {
        if (besideCount < MOST_BESIDE) {
            double distance = distance(table, id);
            int at = besideCount;
            for (; at > 0 && besideFrom[at - 1] > distance; at--) {
                beside[at] = beside[at - 1];
                besideFrom[at] = besideFrom[at - 1];
            }
            beside[at] = id;
            besideFrom[at] = distance;
        }
        besideCount++;
    }

    private void start(LeafTable table) {
        SpaceIndex space = table.space;
        if (space == null) {
            table.cursor.startPoint(ox, oz);
        } else {
            space.nearest.around(ox, oy, oz);
            space.nearest.start(space.still, space.moving);
        }
    }

    private int next(LeafTable table) {
        SpaceIndex space = table.space;
        return space == null ? table.cursor.next(limit) : space.nearest.next(limit);
    }

    /** A lower bound of how far the last object is that the table gave, and of those that follow. */
    private static double from(LeafTable table, int local) {
        if (local < 0) {
            return Double.POSITIVE_INFINITY;
        }
        SpaceIndex space = table.space;
        return (space == null ? table.cursor.entry() : space.nearest.entry()) * (1 - PAD);
    }

    private void takeOwn() {
        ownNext = next(own);
        ownFrom = from(own, ownNext);
    }

    private void takeShared(LeafTable others) {
        sharedNext = next(others);
        sharedFrom = from(others, sharedNext);
    }

    /** Whether there is an object of a number in the order of distances that may be within a reach. */
    boolean has(int number, double reach) {
        while (number >= count) {
            double from = complete();
            boolean isEnd = from == Double.POSITIVE_INFINITY; // a reach may be infinite, too
            if (isEnd || !(from <= reach) || count == MOST_FOUND || isClosed) {
                return false;
            }
            take(from);
        }
        return distances[number] <= reach;
    }

    /** Takes the next object, unless no cone looks there. */
    private void take(double from) {
        LeafTable others = shared;
        if (besideFrom[besideNext] == from) {
            int id = beside[besideNext++];
            add(others != null && ObjectTable.isShared(id) ? others : own, id, from);
        } else if (others == null || ownFrom == from) {
            add(own, ownNext | own.mark, from);
            takeOwn();
        } else {
            add(others, sharedNext | others.mark, from);
            takeShared(others);
        }
    }

    private void add(LeafTable table, int id, double from) {
        long seeing = lookingAt(table.bounds(), table.boundsAt(id));
        if (seeing != 0) {
            ids[count] = id;
            distances[count] = from;
            cones[count] = seeing;
            count++;
        }
    }

    /** A cone looks past what was found, and is searched alone; what is found later would be in the way of that. */
    void close() {
        isClosed = true;
        past++;
    }

    /** A lower bound of how far the bounds of an object are. */
    private double distance(LeafTable table, int id) {
        double[] b = table.bounds();
        int k = table.boundsAt(id);
        double dx = Math.max(0, Math.max(b[k] - ox, ox - b[k + 3]));
        double dz = Math.max(0, Math.max(b[k + 2] - oz, oz - b[k + 5]));
        double dy = table.dimension == Dimension.PLANAR ? 0 : Math.max(0, Math.max(b[k + 1] - oy, oy - b[k + 4]));
        return VectorMath.anyLength(dx, dy, dz) * (1 - PAD);
    }

    /** Up to where no object is left out. */
    double complete() {
        return Math.min(besideFrom[besideNext], Math.min(ownFrom, sharedFrom));
    }

    /** All objects that meet this box were found. */
    double[] box() {
        // Its corners are not as far as that.
        double half = 0.57 * complete() - PAD * (Math.abs(ox) + Math.abs(oy) + Math.abs(oz));
        around(0, ox, half);
        around(1, oy, half);
        around(2, oz, half);
        return box;
    }

    private void around(int axis, double middle, double half) {
        box[axis] = middle - half;
        box[axis + 3] = middle + half;
    }

    int id(int number) {
        return ids[number];
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
