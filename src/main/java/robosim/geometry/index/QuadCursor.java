package robosim.geometry.index;

import org.jspecify.annotations.Nullable;
import robosim.geometry.index.regions.NearestFirst;
import robosim.geometry.index.tiles.NearGrid;
import robosim.geometry.index.tiles.NearTarget;
import robosim.geometry.index.tiles.TileGathering;
import robosim.geometry.index.tiles.TileLayers;
import robosim.geometry.index.tiles.TileProbe;
import robosim.geometry.index.tiles.TileScan;
import robosim.geometry.index.tiles.TileWalk;
import robosim.geometry.index.tiles.Tiles;

/**
 * One query at a time over the {@link QuadTree} it came from; reusable, nothing is allocated once its queue has grown. A change of
 * the tree ends the query: start again.
 */
public final class QuadCursor {
    /** A box on so many tiles meets few objects twice. */
    private static final int FEW_TILES = 9;

    /** The target wanted no more. */
    public static final int ENOUGH = TileProbe.ENOUGH;

    /** The rectangle lies on too many regions. */
    public static final int TOO_MANY = TileProbe.TOO_MANY;

    /** The target has met all. */
    public static final int ALL = TileProbe.ALL;

    private final QuadTree tree;
    private final TileLayers layers;
    private final NearestFirst ordered = new NearestFirst();
    private final TileWalk walk;
    private final TileScan scan;
    private final TileWalk.Line line = new TileWalk.Line();
    private final TileProbe probe = new TileProbe();
    private final TileGathering gathering = new TileGathering();
    private int layer;

    /** Whether the ray is answered by the regions, in order. */
    private boolean isInOrder;

    /** Whether a ray has layers still to come. */
    private boolean hasMore;

    // The box, for the layers to come.
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

    /** How many regions this cursor has looked into since it was made. */
    public long visited() {
        return ordered.visited() + walk.visited() + scan.visited();
    }

    /** Starts the query for all objects whose boxes meet this closed box; take them with {@link #next()}. */
    public void startBox(double minX, double minZ, double maxX, double maxZ) {
        tree.settle();
        x0 = minX;
        z0 = minZ;
        x1 = maxX;
        z1 = maxZ;
        layer = 0;
        scan.stop();
    }

    /** The next object that meets the box, in no promised order, each once; -1 after the last. */
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

    /** Half of what lies between two numbers, rounded up: at least as far as either is from the middle, min / 2 + max / 2. */
    public static double half(double min, double max) {
        double middle = min / 2 + max / 2;
        return Math.nextUp(Math.max(middle - min, max - middle));
    }

    /**
     * Lets a target meet all objects that may meet a small rectangle about a place, until it wants no more. One that lies
     * across regions may come again.
     *
     * @param halfX half its size, at least 0
     * @return {@link #ENOUGH}, {@link #ALL}, or {@link #TOO_MANY} where it is not small: start a query that gives each once
     */
    public int near(double x, double z, double halfX, double halfZ, double[] outlines, NearTarget target) {
        tree.settle();
        probe.start(x, z, halfX, halfZ, tree.most);
        for (int k = 0; k < layers.count(); k++) {
            if (!layers.get(k).isEmpty()) {
                int asked = probe.ask(layers.get(k), FEW_TILES, outlines, target);
                if (asked != ALL) {
                    return asked;
                }
            }
        }
        return ALL;
    }

    /**
     * Gathers all objects but one that may meet this closed box, and answers how many there are; take them with
     * {@link #gathered}. One that lies across regions may be there again.
     */
    public int gather(double minX, double minZ, double maxX, double maxZ, int but, double[] outlines) {
        NearGrid near = tree.near();
        gathering.start(minX, minZ, maxX, maxZ, but);
        if (near != null) {
            gathering.gather(near, tree.boxes);
            return gathering.count();
        }
        double halfX = maxX / 2 - minX / 2;
        double halfZ = maxZ / 2 - minZ / 2;
        gathering.startAbout(minX / 2 + maxX / 2, minZ / 2 + maxZ / 2, halfX, halfZ, tree.most, but);
        for (int k = 0; k < layers.count(); k++) {
            if (!layers.get(k).isEmpty()) {
                gathering.gather(layers.get(k), outlines);
            }
        }
        return gathering.count();
    }

    /** The k-th object that was gathered. */
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

    /** Turns to the next layer that is not empty, if there is one. */
    private boolean hasLayer() {
        while (layer < layers.count() && layers.get(layer).isEmpty()) {
            layer++;
        }
        return layer < layers.count();
    }

    /**
     * Starts the query for all objects whose outlines a ray may meet; take them with {@link #nextOnRay}. A point of the ray is
     * its start plus a parameter times the direction.
     *
     * @throws IllegalArgumentException where the start is not finite, or the direction zero or not finite
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
        isInOrder = false;
        hasMore = false;
        if (!line.isOrdinary()) {
            startInOrder();
        } else if (!walkOn()) {
            walk.stop();
        }
    }

    /** Turns to the next layer, or to all objects in order where the ray is too far from it; false after the last layer. */
    private boolean walkOn() {
        Tiles tiles = nextLayer();
        if (tiles == null) {
            return false;
        }
        hasMore = hasLayer();
        if (!walk.start(tiles)) {
            startInOrder();
        }
        return true;
    }

    private void startInOrder() {
        isInOrder = true;
        tree.growRegions();
        ordered.startRay(tree.regions, line.ox(), line.oz(), line.dx(), line.dz(), Double.POSITIVE_INFINITY);
    }

    /**
     * The next object that the ray may meet at a parameter up to the limit, region by region, maybe again; -1 after the last.
     *
     * @param limit at least 0; may be infinite, and may shrink from call to call
     */
    public int nextOnRay(double limit, double[] outlines) {
        if (isInOrder) {
            return ordered.next(tree.regions, tree.boxes, limit);
        }
        int id = walk.next(limit, outlines);
        return id == Tiles.NONE && hasMore ? nextFarther(limit, outlines) : id;
    }

    private int nextFarther(double limit, double[] outlines) {
        int id = Tiles.NONE;
        while (id == Tiles.NONE && walkOn()) {
            if (isInOrder) {
                return ordered.next(tree.regions, tree.boxes, limit);
            }
            id = walk.next(limit, outlines);
        }
        return id;
    }

    /**
     * Starts the query for all objects whose boxes are within a distance of a point, nearest first; take them with
     * {@link #next(double)}.
     *
     * @param limit at least 0; may be infinite
     * @throws IllegalArgumentException where the point is not finite
     */
    public void startPoint(double x, double z, double limit) {
        tree.growRegions();
        ordered.startPoint(tree.regions, x, z, limit);
    }

    /**
     * Starts the query for all objects whose boxes are within a distance of a point and not wholly beyond one of two
     * lines through it, nearest first.
     *
     * @param leftX  outward normal of one line, of length 1 at most; zero for none
     * @param rightX outward normal of the other line
     */
    public void startSector(
            double x, double z, double leftX, double leftZ, double rightX, double rightZ, double limit) {
        tree.growRegions();
        ordered.startSector(tree.regions, x, z, leftX, leftZ, rightX, rightZ, limit);
    }

    /** The next object of a point query; -1 after the last within the limit, which may shrink from call to call. */
    public int next(double limit) {
        return ordered.next(tree.regions, tree.boxes, limit);
    }

    /** A lower bound, rounded down, of the distance at which the last object of a point query begins. */
    public double entry() {
        return ordered.entry();
    }
}
