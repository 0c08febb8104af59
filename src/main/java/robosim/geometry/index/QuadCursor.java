package robosim.geometry.index;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.index.quadtree.RegionSearch;
import robosim.geometry.index.tiles.NearGrid;
import robosim.geometry.index.tiles.NearTarget;
import robosim.geometry.index.tiles.TileGathering;
import robosim.geometry.index.tiles.TileLayers;
import robosim.geometry.index.tiles.TileProbe;
import robosim.geometry.index.tiles.TileScan;
import robosim.geometry.index.tiles.TileWalk;
import robosim.geometry.index.tiles.Tiles;

/**
 * Runs one query at a time over its {@link QuadTree}. It is reusable and allocates nothing once its queue has grown. A
 * change of the tree invalidates the query, which must be started again.
 */
public final class QuadCursor {
    /** A box on at most this many tiles meets few objects twice. */
    private static final int FEW_TILES = 9;

    /** The target needs no more objects. */
    public static final int ENOUGH = TileProbe.ENOUGH;

    /** The rectangle lies on too many regions. */
    public static final int TOO_MANY = TileProbe.TOO_MANY;

    /** The target has seen all objects. */
    public static final int ALL = TileProbe.ALL;

    private final QuadTree tree;
    private final TileLayers layers;
    private final RegionSearch regions = new RegionSearch();
    private final TileWalk walk;
    private final TileScan scan;
    private final TileWalk.Line line = new TileWalk.Line();
    private final TileProbe probe = new TileProbe();
    private final TileGathering gathering = new TileGathering();
    private int layer;

    /** Whether the ray query goes through all objects, as its numbers are beyond what tiles are made for. */
    private boolean isOfAll;

    /** The next object then. */
    private int each;

    /** Whether the ray query has layers left. */
    private boolean hasMore;

    // The query's box, for the remaining layers.
    private double x0;
    private double z0;
    private double x1;
    private double z1;

    QuadCursor(QuadTree tree) {
        this.tree = tree;
        layers = tree.tiles;
        Tiles none = Tiles.single();
        walk = new TileWalk(line, none);
        scan = new TileScan(none);
    }

    /** Number of regions that this cursor has examined since it was made. */
    public long visited() {
        return regions.visited() + walk.visited() + scan.visited();
    }

    /** Starts a query for all objects whose boxes meet this closed box; {@link #next()} returns them. */
    public void startBox(double minX, double minZ, double maxX, double maxZ) {
        tree.settle();
        x0 = minX;
        z0 = minZ;
        x1 = maxX;
        z1 = maxZ;
        layer = 0;
        scan.stop();
    }

    /** The next object that meets the box, each once, in an unspecified order; -1 after the last. */
    public int next() {
        while (true) {
            int id = scan.next(tree.boxes);
            if (id != Tiles.NONE) {
                return id;
            }
            Tiles tiles = nextLayer();
            if (tiles == null) {
                return -1;
            }
            scan.start(tiles, x0, z0, x1, z1);
        }
    }

    /**
     * Half of the distance between two numbers, rounded up, so that it is at least as large as the distance of either
     * from the rounded middle, min / 2 + max / 2.
     */
    public static double half(double min, double max) {
        double middle = min / 2 + max / 2;
        return Math.nextUp(Math.max(middle - min, max - middle));
    }

    /**
     * Passes all objects that may meet a small rectangle around a point to a target, until it needs no more. An object
     * that lies across regions may be passed more than once.
     *
     * @param halfX half its size, at least 0
     * @return {@link #ENOUGH}, {@link #ALL}, or {@link #TOO_MANY} if the rectangle is not small; then start a box query
     *     instead
     */
    public int near(double x, double z, double halfX, double halfZ, double[] outlines, NearTarget target) {
        tree.settle();
        probe.start(x, z, halfX, halfZ, tree.most);
        for (int k = 0; k < layers.count(); k++) {
            if (!layers.get(k).isEmpty()) {
                int asked = probe.query(layers.get(k), FEW_TILES, outlines, target);
                if (asked != ALL) {
                    return asked;
                }
            }
        }
        return ALL;
    }

    /**
     * Collects all objects that may meet this closed box, ignoring one, and returns their number; {@link #gathered}
     * returns them. An object that lies across regions may be among them more than once.
     */
    public int gather(double minX, double minZ, double maxX, double maxZ, int ignored, double[] outlines) {
        NearGrid near = tree.near();
        gathering.start(minX, minZ, maxX, maxZ, ignored);
        if (near != null) {
            gathering.gather(near, tree.boxes);
            return gathering.count();
        }
        double halfX = maxX / 2 - minX / 2;
        double halfZ = maxZ / 2 - minZ / 2;
        gathering.startAbout(minX / 2 + maxX / 2, minZ / 2 + maxZ / 2, halfX, halfZ, tree.most, ignored);
        for (int k = 0; k < layers.count(); k++) {
            if (!layers.get(k).isEmpty()) {
                gathering.gather(layers.get(k), outlines);
            }
        }
        return gathering.count();
    }

    /** The k-th object collected. */
    public int gathered(int k) {
        return gathering.id(k);
    }

    /** The boxes of all objects, as {@link QuadTree#boxes}. */
    public double[] boxes() {
        return tree.boxes;
    }

    private @Nullable Tiles nextLayer() {
        return hasLayer() ? layers.get(layer++) : null;
    }

    /** Goes to the next layer that is not empty, if there is one. */
    private boolean hasLayer() {
        while (layer < layers.count() && layers.get(layer).isEmpty()) {
            layer++;
        }
        return layer < layers.count();
    }

    /**
     * Starts a query for all objects whose outlines a ray may meet; {@link #nextOnRay} returns them. A point of the ray
     * is its start plus a parameter times the direction.
     *
     * @throws IllegalArgumentException if the start is not finite, or the direction zero or not finite
     */
    public void startRay(double ox, double oz, double dx, double dz) {
        double sum = Math.abs(ox) + Math.abs(oz);
        double speed = Math.abs(dx) + Math.abs(dz);
        if (!(sum < Double.POSITIVE_INFINITY && speed > 0 && speed < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("ray must be finite and its direction not zero (got: start " + ox + ", "
                    + oz + " direction " + dx + ", " + dz + ")");
        }
        tree.settle();
        line.start(ox, oz, dx, dz, tree.most);
        layer = 0;
        isOfAll = false;
        hasMore = false;
        if (!line.isOrdinary()) {
            startAll();
        } else if (!walkOn()) {
            walk.stop();
        }
    }

    /**
     * Goes to the next layer, or to all objects if the ray is too far from that layer; false after the last layer.
     */
    private boolean walkOn() {
        Tiles tiles = nextLayer();
        if (tiles == null) {
            return false;
        }
        hasMore = hasLayer();
        if (!walk.start(tiles)) {
            startAll();
        }
        return true;
    }

    private void startAll() {
        isOfAll = true;
        each = 0;
    }

    private int nextOfAll() {
        while (each < tree.limit) {
            int id = each++;
            if (tree.contains(id)) {
                return id;
            }
        }
        return -1;
    }

    /**
     * The next object that the ray may meet at a parameter up to the limit, region by region; -1 after the last. An
     * object may be returned more than once.
     *
     * @param limit at least 0; may be infinite, and may shrink from call to call
     */
    public int nextOnRay(double limit, double[] outlines) {
        if (isOfAll) {
            return nextOfAll();
        }
        int id = walk.next(limit, outlines);
        return id == Tiles.NONE && hasMore ? nextFarther(limit, outlines) : id;
    }

    private int nextFarther(double limit, double[] outlines) {
        int id = Tiles.NONE;
        while (id == Tiles.NONE && walkOn()) {
            if (isOfAll) {
                return nextOfAll();
            }
            id = walk.next(limit, outlines);
        }
        return id;
    }

    /**
     * Starts a query for all objects around a point, nearest first; {@link #next(double)} returns them.
     *
     * @throws IllegalArgumentException if the point is not finite
     */
    public void startPoint(double x, double z) {
        tree.growRegions();
        regions.start(tree.regions, x, z);
    }

    /**
     * Starts a query for all objects whose boxes the sector about a level beam may meet, in the order of how far they are within
     * the sector, or less; {@link #next(double)} returns them.
     */
    public void startSector(BeamAxis beam) {
        tree.growRegions();
        regions.start(tree.regions, beam, tree.most);
    }

    /**
     * The next object of a point or sector query within the limit, which may be infinite, and may shrink from call to call; -1
     * after the last.
     */
    public int next(double limit) {
        return regions.next(tree.regions, tree.boxes, limit);
    }

    /** A lower bound, to some 2^-20 of it, of the distance of the object last returned by a point query. */
    public double entry() {
        return regions.entry();
    }
}
