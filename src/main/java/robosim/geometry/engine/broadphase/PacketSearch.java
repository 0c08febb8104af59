package robosim.geometry.engine.broadphase;

import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.WorkCounter;
import robosim.geometry.index.hierarchy.FrustumCursor;
import robosim.geometry.index.hierarchy.Hierarchy;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Cast;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.packet.RayPacket;

/**
 * The nearest echoes of many rays from one place in a world with heights, to the bit as of each alone: the hierarchies are
 * searched once for all of them.
 *
 * <p>What a ray certainly meets between two bounds is kept back as long as nothing else may be as near; so the kernel of
 * single rays is mostly asked once for each ray, about the leaf that gives its answer. It is asked at once where a bound is
 * not sure.
 */
public final class PacketSearch {
    /** Rays farther than 30 degrees from their middle share little. */
    private static final double NARROW = 0.866;

    private static final StageCounters.Counter UNSURE = StageCounters.counter("PacketSearch");

    private final ObjectTable objects;
    private final Cast cast;
    private final WorkCounter work;
    private final RayPacket packet = new RayPacket();
    private final FrustumCursor cursor = new FrustumCursor();

    private double ox;
    private double oy;
    private double oz;
    private double[] directions = new double[0];
    private int first;

    // The nearest for certain, by ray.
    private final double[] best = new double[RayPacket.MOST];
    private final int[] hit = new int[RayPacket.MOST];
    private final int[] hitLeaf = new int[RayPacket.MOST];
    private final int[] hitPiece = new int[RayPacket.MOST];

    /** What may be nearer: an object that is certainly met, not before {@link #from}, and which of its leaves; -1 for none. */
    private final int[] pending = new int[RayPacket.MOST];

    private final int[] pendingLeaf = new int[RayPacket.MOST];
    private final double[] from = new double[RayPacket.MOST];

    /** The rays that have met nothing yet. */
    private long open;

    /** How far any ray still looks. */
    private double reach;

    /** A search in a world of objects. */
    public PacketSearch(ObjectTable objects, Scratch scratch) {
        this.objects = objects;
        cast = new Cast(scratch);
        work = scratch.work;
    }

    /** Whether a world is searched by this: it has hierarchies. */
    public static boolean isFor(AccuracyView view) {
        return view.dimension == Dimension.SPATIAL;
    }

    /**
     * Sets the rays.
     *
     * @param ways their directions, three numbers each, of any length but zero, from an index on
     * @param count how many rays, 1 to {@link RayPacket#MOST}
     * @return false where they spread so far that they share too little
     */
    public boolean aim(double x, double y, double z, double[] ways, int at, int count) {
        packet.aim(x, y, z, ways, at, count);
        if (!cursor.enclose(packet.units(0), packet.units(1), packet.units(2), count, NARROW)) {
            return false;
        }
        ox = x;
        oy = y;
        oz = z;
        directions = ways;
        first = at;
        return true;
    }

    /**
     * Searches a world.
     *
     * @param limit how far to look
     * @param ignored an object that does not echo; -1 for none
     */
    public void search(AccuracyView view, double limit, int ignored) {
        packet.look(limit);
        open = packet.rays();
        reach = limit;
        for (int ray = 0; ray < packet.count(); ray++) {
            best[ray] = Double.POSITIVE_INFINITY;
            hit[ray] = -1;
            pending[ray] = -1;
        }
        LeafTable shared = view.shared;
        if (shared != null) {
            searchTrees(view, shared, ignored);
        }
        searchTrees(view, view.own, ignored);
        for (int k = 0; k < view.own.moversBesideTree(); k++) {
            int id = objects.mover(k);
            if (id != ignored) {
                hit(view, view.own, id);
            }
        }
        for (int ray = 0; ray < packet.count(); ray++) {
            settle(view, ray);
            if (!(best[ray] <= limit)) {
                hit[ray] = -1;
            }
        }
    }

    private void searchTrees(AccuracyView view, LeafTable table, int ignored) {
        for (int k = 0; k < table.gridCount(); k++) { // first, as a map's walls mostly hide the rest
            if (table.grid(k) != ignored) {
                hit(view, table, table.grid(k));
            }
        }
        SpaceIndex space = table.space;
        if (space != null) {
            cursor.aim(ox, oy, oz, space.most());
            searchTree(view, table, space.still, ignored);
            searchTree(view, table, space.moving, ignored);
        }
    }

    private void searchTree(AccuracyView view, LeafTable table, Hierarchy tree, int ignored) {
        cursor.start(tree);
        for (int local = cursor.next(reach); local >= 0; local = cursor.next(reach)) {
            int id = local | table.mark;
            if (id != ignored) {
                hit(view, table, id);
            }
        }
    }

    private void hit(AccuracyView view, LeafTable table, int id) {
        LeafColumn leaves = table.leaves();
        int leaf = table.first(id);
        int end = leaf + table.count(id);
        long rays = packet.rays();
        if (end > leaf + 1 || !RayPacket.knows(leaves.kind(leaf))) {
            rays = packet.box(table.bounds(), table.boundsAt(id));
        }
        boolean isNearer = false;
        for (; rays != 0 && leaf < end; leaf++) {
            work.take();
            isNearer |= hitLeaf(view, leaves, id, leaf, rays & packet.sift(leaves, leaf));
        }
        if (isNearer && open == 0) {
            reach = packet.reach();
        }
    }

    /** Shows a leaf to some rays; answers whether any of them looks less far now. */
    private boolean hitLeaf(AccuracyView view, LeafColumn leaves, int id, int leaf, long rays) {
        LeafKind kind = leaves.kind(leaf);
        boolean isNearer = false;
        for (long left = rays; left != 0; left &= left - 1) {
            int ray = Long.numberOfTrailingZeros(left);
            if (packet.isSure(ray)) {
                isNearer |= keep(view, ray, id, leaf);
            } else {
                if (RayPacket.knows(kind)) {
                    UNSURE.count();
                }
                line(ray);
                isNearer |= take(ray, cast.distance(leaves, leaf, packet.near(ray)), id, leaf);
            }
        }
        return isNearer;
    }

    /** Keeps back a leaf that a ray certainly meets, in place of another one or after the kernel was asked about that. */
    private boolean keep(AccuracyView view, int ray, int id, int leaf) {
        double low = packet.low(ray);
        if (pending[ray] >= 0 && !(packet.high(ray) < from[ray])) {
            settle(view, ray);
            if (low > packet.near(ray)) {
                return true;
            }
        }
        pending[ray] = id;
        pendingLeaf[ray] = leaf;
        from[ray] = low;
        shorten(ray, packet.high(ray));
        return true;
    }

    /** Asks the kernel about what has been kept back. */
    private void settle(AccuracyView view, int ray) {
        int id = pending[ray];
        if (id >= 0) {
            pending[ray] = -1;
            line(ray);
            LeafColumn leaves = view.table(id).leaves();
            take(ray, cast.distance(leaves, pendingLeaf[ray], Double.POSITIVE_INFINITY), id, pendingLeaf[ray]);
        }
    }

    private void line(int ray) {
        int at = first + 3 * ray;
        cast.line(Dimension.SPATIAL, ox, oy, oz, directions[at], directions[at + 1], directions[at + 2]);
    }

    private boolean take(int ray, double found, int id, int leaf) {
        if (found < best[ray] || (found == best[ray] && hit[ray] >= 0 && isBefore(ray, id, leaf))) {
            best[ray] = found;
            hit[ray] = id;
            hitLeaf[ray] = leaf;
            hitPiece[ray] = cast.piece();
            shorten(ray, found);
            return true;
        }
        return false;
    }

    /** Whether a leaf wins a tie: that of the object added first, and there the first one. */
    private boolean isBefore(int ray, int id, int leaf) {
        return id == hit[ray] ? leaf < hitLeaf[ray] : objects.isEarlier(id, hit[ray]);
    }

    private void shorten(int ray, double limit) {
        packet.shorten(ray, limit);
        open &= ~(1L << ray);
    }

    /** The distance to a ray's nearest echo, or +Infinity. */
    public double nearest(int ray) {
        return hit[ray] < 0 ? Double.POSITIVE_INFINITY : best[ray];
    }

    /** The object that gave it, or -1. */
    public int hit(int ray) {
        return hit[ray];
    }

    /** The leaf that gave it, if anything did. */
    public int leaf(int ray) {
        return hitLeaf[ray];
    }

    /** The triangle or cell of the leaf that a ray met; -1 if it has none. */
    public int face(AccuracyView view, int ray) {
        line(ray);
        return cast.face(view.table(hit[ray]).leaves(), hitLeaf[ray], hitPiece[ray]);
    }

    /** Writes the unit normal where a ray met what it hit. */
    public void normal(AccuracyView view, int ray, double[] out) {
        line(ray);
        cast.normal(view.table(hit[ray]).leaves(), hitLeaf[ray], best[ray], hitPiece[ray], out);
    }
}
