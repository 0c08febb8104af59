package robosim.geometry.engine.broadphase;

import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.WorkCounter;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.hierarchy.FrustumCursor;
import robosim.geometry.index.hierarchy.Hierarchy;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Cast;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.packet.RayFan;
import robosim.geometry.narrow.packet.RayPacket;

/**
 * The nearest echoes of many rays from one place, to the bit as of each alone: the hierarchies of a world with heights, or the
 * quadtree of one without, are searched once for all of them.
 *
 * <p>What a ray certainly meets between two bounds is kept back as long as nothing else may be as near; so the kernel of
 * single rays is mostly asked once for each ray, about the leaf that gives its answer. It is asked at once where a bound is
 * not sure.
 */
public final class PacketSearch {
    /** Rays farther than 32 degrees from their middle share little. */
    private static final double NARROW = 0.848;

    /** So few rays are shown to all leaves of a group one by one just as fast. */
    private static final int FEW = 2;

    /**
     * Where a search in a plane looks at more objects for each ray, in a crowd where each ray soon meets one of its own, rays
     * are faster one by one: along a line an object is found sooner than in a sector.
     */
    private static final double CROWD = 0.4;

    /** How many searches are left out then. */
    private static final int REST = 63;

    private static final StageCounters.Counter UNSURE = StageCounters.counter("PacketSearch");

    private final ObjectTable objects;
    private final Cast cast;
    private final WorkCounter work;
    private final RayPacket packet = new RayPacket();
    private final FrustumCursor cursor = new FrustumCursor();

    /** The rays in a plane. */
    private final RayFan fan = new RayFan();

    private final double[] box = new double[6];

    private Dimension dimension = Dimension.SPATIAL;
    private double ox;
    private double oy;
    private double oz;
    private double[] directions = new double[0];
    private int first;
    private int number;

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

    /** How far all of them look at first. */
    private double farthest;

    /** How many objects the search at hand has looked at. */
    private int visited;

    /** How many searches are still left out. */
    private int rest;

    /** A search in a world of objects. */
    public PacketSearch(ObjectTable objects, Scratch scratch) {
        this.objects = objects;
        cast = new Cast(scratch);
        work = scratch.work;
    }

    /**
     * Sets the rays.
     *
     * @param in in PLANAR their projections are meant
     * @param ways their directions, three numbers each, of any length but zero, from an index on
     * @param count how many rays, 1 to {@link RayPacket#MOST}
     * @return false where they spread so far that they share too little, or are not in order in a plane
     */
    public boolean aim(Dimension in, double x, double y, double z, double[] ways, int at, int count) {
        if (in == Dimension.PLANAR) {
            if (!fan.aim(x, z, ways, at, count)) {
                return false;
            }
        } else {
            packet.aim(x, y, z, ways, at, count);
            if (!cursor.enclose(packet.units(0), packet.units(1), packet.units(2), count, NARROW)) {
                return false;
            }
        }
        dimension = in;
        number = count;
        ox = x;
        oy = y;
        oz = z;
        directions = ways;
        first = at;
        return true;
    }

    /** Whether rays are likely to share enough, as the last ones did; in space always. To be asked once for each search. */
    public boolean isWorthwhile(Dimension in) {
        if (in == Dimension.PLANAR && rest > 0) {
            rest--;
            return false;
        }
        return true;
    }

    /**
     * Searches a world, which is seen in the dimension of the rays.
     *
     * @param limit how far to look
     * @param ignored an object that does not echo; -1 for none
     */
    public void search(AccuracyView view, double limit, int ignored) {
        packet.look(limit);
        reach = limit;
        farthest = limit;
        visited = 0;
        open = number == Long.SIZE ? -1 : (1L << number) - 1;
        for (int ray = 0; ray < number; ray++) {
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
        for (int ray = 0; ray < number; ray++) {
            settle(view, ray);
            if (!(best[ray] <= limit)) {
                hit[ray] = -1;
            }
        }
        if (dimension == Dimension.PLANAR && visited > CROWD * number) {
            rest = REST;
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
        } else if (!table.hasEmptyTrees()) {
            searchSector(view, table, ignored);
        }
    }

    private void searchSector(AccuracyView view, LeafTable table, int ignored) {
        double slack = 0x1p-44 * (table.extent + Math.abs(ox) + Math.abs(oz));
        QuadCursor tree = table.cursor;
        tree.startSector(fan.sector());
        for (int local = tree.next(BeamSearch.loose(reach, slack));
                local >= 0;
                local = tree.next(BeamSearch.loose(reach, slack))) {
            int id = local | table.mark;
            if (id != ignored) {
                hit(view, table, id);
            }
        }
    }

    private void searchTree(AccuracyView view, LeafTable table, Hierarchy tree, int ignored) {
        if (tree.size() == 0) {
            return;
        }
        cursor.start(tree);
        for (int local = cursor.next(reach); local >= 0; local = cursor.next(reach)) {
            int id = local | table.mark;
            if (id != ignored) {
                hit(view, table, id);
            }
        }
    }

    private void hit(AccuracyView view, LeafTable table, int id) {
        if (objects.ignored.has(id)) {
            return;
        }
        visited++;
        if (dimension == Dimension.PLANAR) {
            hitInPlane(table, id);
            return;
        }
        LeafColumn leaves = table.leaves();
        int leaf = table.first(id);
        int end = leaf + table.count(id);
        long rays = packet.rays();
        if (end > leaf + 1 || !RayPacket.knows(leaves.kind(leaf))) {
            rays = packet.box(table.bounds(), table.boundsAt(id));
        }
        boolean isNearer = false;
        boolean isFew = end > leaf + 1 && Long.bitCount(rays) <= FEW;
        for (; rays != 0 && leaf < end; leaf++) {
            work.take();
            isNearer |= isFew
                    ? hitFew(leaves, id, leaf, rays)
                    : hitLeaf(view, leaves, id, leaf, rays & packet.sift(leaves, leaf));
        }
        if (isNearer && open == 0) {
            reach = packet.reach();
        }
    }

    /** Shows an object to the neighbours among the rays that may meet it. */
    private void hitInPlane(LeafTable table, int id) {
        if (!fan.find(table.bounds(), table.boundsAt(id), table.isDisc(id))) {
            return;
        }
        LeafColumn leaves = table.leaves();
        boolean isNearer = false;
        if (table.isUpright(id)) {
            isNearer = showUpright(leaves, id, table.uprightLeaf(id));
        } else if (table.count(id) == 1) {
            isNearer = show(leaves, id, table.first(id), fan.first(), fan.last());
        } else {
            int from = fan.first();
            int to = fan.last();
            for (int leaf = table.first(id); leaf < table.first(id) + table.count(id); leaf++) {
                isNearer |= showLeaf(leaves, id, leaf, from, to);
            }
        }
        if (isNearer && open == 0) {
            reach = 0;
            for (int ray = 0; ray < number; ray++) {
                reach = Math.max(reach, best[ray]);
            }
        }
    }

    /** Shows a leaf of a group to those of some rays that may meet it. */
    private boolean showLeaf(LeafColumn leaves, int id, int leaf, int from, int to) {
        if (to - from < FEW) {
            return show(leaves, id, leaf, from, to);
        }
        leaves.bounds(leaf, box);
        return fan.find(box, 0, leaves.kind(leaf).isDisc())
                && show(leaves, id, leaf, Math.max(from, fan.first()), Math.min(to, fan.last()));
    }

    /** Shows a leaf to some rays; answers whether any of them looks less far now. */
    private boolean show(LeafColumn leaves, int id, int leaf, int from, int to) {
        boolean isNearer = false;
        double nearest = fan.nearest();
        for (int ray = from; ray <= to; ray++) {
            double limit = Math.min(best[ray], farthest);
            if (nearest <= limit) {
                work.take();
                line(ray);
                isNearer |= take(ray, cast.distance(leaves, leaf, limit), id, leaf);
            }
        }
        return isNearer;
    }

    /** The same for an upright leaf, mostly by its outline alone. */
    private boolean showUpright(LeafColumn leaves, int id, int leaf) {
        double[] outlines = leaves.outlines();
        int local = ObjectTable.local(id);
        boolean isNearer = false;
        double nearest = fan.nearest();
        for (int ray = fan.first(); ray <= fan.last(); ray++) {
            double limit = Math.min(best[ray], farthest);
            if (nearest <= limit) {
                line(ray);
                double found = cast.upright(outlines, local);
                isNearer |= take(ray, Double.isNaN(found) ? cast.distance(leaves, leaf, limit) : found, id, leaf);
            }
        }
        return isNearer;
    }

    /** Shows a leaf to some rays without a sieve; answers whether any of them looks less far now. */
    private boolean hitFew(LeafColumn leaves, int id, int leaf, long rays) {
        boolean isNearer = false;
        for (long left = rays; left != 0; left &= left - 1) {
            int ray = Long.numberOfTrailingZeros(left);
            line(ray);
            isNearer |= take(ray, cast.distance(leaves, leaf, packet.near(ray)), id, leaf);
        }
        return isNearer;
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
        cast.line(dimension, ox, oy, oz, directions[at], directions[at + 1], directions[at + 2]);
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
