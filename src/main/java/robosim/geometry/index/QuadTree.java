package robosim.geometry.index;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.index.quadtree.CellGrid;
import robosim.geometry.index.quadtree.RegionTree;
import robosim.geometry.index.quadtree.Regions;
import robosim.geometry.index.tiles.NearGrid;
import robosim.geometry.index.tiles.TileLayers;
import robosim.geometry.index.tiles.Tiles;

/**
 * An index of objects, each given by a small id that the caller chooses and a box in the XZ plane.
 *
 * <p>Regions are cut in four at their centres, recursively. Ray and box queries use all regions of one depth at once,
 * as {@link Tiles}, about as many as there are objects: a ray steps from tile to tile, front to back, until no later
 * tile can hold anything nearer than what it has hit. Objects too large for the tiles are listed on coarser ones.
 * Queries for the nearest objects of a point descend the regions as a tree, nearest first. While objects are added or
 * move, queries around a small box use a {@link NearGrid}, and the tiles are brought up to date when they are next
 * used. Each structure is built on first use, and rebuilt when the number of objects has outgrown it.
 *
 * <p>May be used by one thread at a time. Arrays have one element for every id up to the greatest.
 */
public final class QuadTree {
    /** The greatest id: six numbers for each must fit into one array. */
    public static final int MAX_ID = (1 << 28) - 2;

    /** Number of doubles in a box: its minimum x, y and z, then its maximum. Heights are stored but not used here. */
    public static final int BOX = 6;

    private static final RegionTree NO_REGIONS = new RegionTree(new CellGrid(0, 0, 0, 0));

    private final CellGrid cells;

    // By id, of objects in the tree and of others that its owner stores here.
    double[] boxes;

    /** By id, whether it is in the tree. */
    private boolean[] listed;

    /** The greatest id so far, plus one. */
    int limit;

    private int size;

    private final Runnable laidOut;

    /** The greatest magnitude of any coordinate of a box so far. */
    double most;

    private final double[] given = new double[BOX];

    final TileLayers tiles;
    private final double[] before = new double[BOX];
    RegionTree regions;
    private boolean hasRegions;

    /** Answers queries around small boxes while the tiles are out of date; null if a grid is unsuitable. */
    private @Nullable NearGrid grid;

    /** The number of objects from which on a grid is used. */
    private int leastForGrid;

    private boolean hasMoved;

    /**
     * The frozen tree that this is a view of, which builds the regions for all its views; null if this is not a view.
     */
    private final @Nullable QuadTree frozen;

    /** The objects that have moved since the tiles were last up to date. */
    private final Moved moved = new Moved();

    /** An empty tree over a world of this extent. Objects may lie outside it, where the tree is merely coarser. */
    public QuadTree(double minX, double minZ, double maxX, double maxZ) {
        this(minX, minZ, maxX, maxZ, () -> {});
    }

    /**
     * The same, with an action to run whenever the tree has been rebuilt, so that its owner can rebuild its own data.
     */
    public QuadTree(double minX, double minZ, double maxX, double maxZ, Runnable whenLaidOut) {
        laidOut = whenLaidOut;
        cells = new CellGrid(minX, minZ, maxX, maxZ);
        regions = NO_REGIONS;
        tiles = new TileLayers();
        frozen = null;
        boxes = new double[BOX * ArrayGrowth.FIRST];
        listed = new boolean[ArrayGrowth.FIRST];
    }

    private QuadTree(QuadTree of) {
        laidOut = () -> {};
        cells = of.cells;
        boxes = of.boxes;
        listed = of.listed;
        limit = of.limit;
        size = of.size;
        most = of.most;
        tiles = of.tiles;
        regions = of.regions;
        frozen = of;
    }

    /**
     * Builds everything that would be built on first use. From now on the tree must not be changed, and many threads
     * may query its views.
     */
    public void freeze() {
        grid = null;
        leastForGrid = Integer.MAX_VALUE;
        settle();
        grid = null;
    }

    /** A view of a frozen tree, for one thread to query. */
    public QuadTree view() {
        return new QuadTree(this);
    }

    /** The regions of a frozen tree, built when one of its views first needs them. */
    private synchronized RegionTree frozenRegions() {
        growRegions();
        return regions;
    }

    public int size() {
        return size;
    }

    public boolean contains(int id) {
        return id >= 0 && id < listed.length && listed[id];
    }

    /** A new cursor over this tree; a query sees the tree as it is when the query starts. */
    public QuadCursor cursor() {
        return new QuadCursor(this);
    }

    /**
     * Adds an object by its closed box.
     *
     * @param id from 0 to {@link #MAX_ID}, not in the tree; should be small, as arrays are indexed by it
     * @throws IllegalArgumentException if the id is taken or out of range, or the box is not finite or inverted
     */
    public void add(int id, double minX, double minZ, double maxX, double maxZ) {
        requireNew(id);
        requireBox(minX, minZ, maxX, maxZ);
        given[0] = minX;
        given[2] = minZ;
        given[3] = maxX;
        given[5] = maxZ;
        keep(id, given);
        list(id);
    }

    /** Stores a box of {@link #BOX} numbers for an id without adding it to the tree. */
    public void keep(int id, double[] box) {
        if (id >= listed.length) {
            resize(Math.min(MAX_ID + 1, ArrayGrowth.of(id)));
        }
        limit = Math.max(limit, id + 1);
        System.arraycopy(box, 0, boxes, BOX * id, BOX);
    }

    /**
     * Adds an object whose box is stored here.
     *
     * @throws IllegalArgumentException if it is in the tree or its box is not finite or inverted
     */
    public void list(int id) {
        requireNew(id);
        int at = BOX * id;
        double minX = boxes[at];
        double minZ = boxes[at + 2];
        double maxX = boxes[at + 3];
        double maxZ = boxes[at + 5];
        requireBox(minX, minZ, maxX, maxZ);
        stretch(minX, minZ, maxX, maxZ);
        listed[id] = true;
        size++;
        tiles.add(id, boxes, size);
        if (grid != null) {
            grid.add(id, boxes);
        }
        if (hasRegions) {
            regions.add(id, boxes);
        }
    }

    private void requireNew(int id) {
        if (id < 0 || id > MAX_ID || contains(id)) {
            throw new IllegalArgumentException("id must be 0 to " + MAX_ID + " and not in the tree (got: " + id + ")");
        }
    }

    private static void requireBox(double minX, double minZ, double maxX, double maxZ) {
        boolean isFinite = minX > Double.NEGATIVE_INFINITY
                && maxX < Double.POSITIVE_INFINITY
                && minZ > Double.NEGATIVE_INFINITY
                && maxZ < Double.POSITIVE_INFINITY;
        if (!(isFinite && minX <= maxX && minZ <= maxZ)) {
            throw new IllegalArgumentException("box must be finite and min at most max (got: x %s to %s, z %s to %s)"
                    .formatted(minX, maxX, minZ, maxZ));
        }
    }

    private void stretch(double minX, double minZ, double maxX, double maxZ) {
        if (-minX > most || maxX > most || -minZ > most || maxZ > most) {
            most = Math.max(Math.max(-minX, maxX), Math.max(-minZ, maxZ));
        }
    }

    private void resize(int capacity) {
        boxes = Arrays.copyOf(boxes, BOX * capacity);
        listed = Arrays.copyOf(listed, capacity);
    }

    /**
     * The boxes by id, {@link #BOX} numbers each: of objects in the tree and of others stored here. Valid until the
     * next box is stored.
     */
    public double[] boxes() {
        return boxes;
    }

    /** Removes an object; returns false if it is not in the tree. */
    public boolean remove(int id) {
        if (!contains(id)) {
            return false;
        }
        catchUp();
        tiles.remove(id, boxes);
        if (grid != null) {
            grid.remove(id);
        }
        if (hasRegions) {
            regions.remove(id, boxes);
        }
        listed[id] = false;
        size--;
        return true;
    }

    /**
     * Changes the box of an object of the tree; the same rules hold as for adding it.
     *
     * @param to {@link #BOX} numbers
     * @throws IllegalArgumentException if the id is not in the tree
     */
    public void move(int id, double[] to) {
        if (!contains(id)) {
            throw new IllegalArgumentException("id must be in the tree (got: " + id + ")");
        }
        if (hasRegions) {
            regions.remove(id, boxes);
        }
        NearGrid near = grid;
        if (near == null) {
            System.arraycopy(boxes, BOX * id, before, 0, BOX);
            put(id, to);
            tiles.move(id, before, boxes, size);
        } else {
            hasMoved = true;
            if (!tiles.isStale()) {
                moved.note(id, boxes);
            }
            put(id, to);
            near.move(id, boxes);
        }
        if (hasRegions) {
            regions.add(id, boxes);
        }
    }

    private void put(int id, double[] to) {
        stretch(to[0], to[2], to[3], to[5]);
        System.arraycopy(to, 0, boxes, BOX * id, BOX);
    }

    /** Brings the tiles up to date. */
    void settle() {
        if (!moved.isEmpty()) {
            catchUp();
        }
        if (tiles.isStale()) {
            tiles.layOut(boxes, listed, size);
            trim();
            laidOut.run();
            if (!hasMoved) { // nothing to do in a world at rest
                grid = null;
            }
        }
    }

    /** Gives up spare room. */
    public void trim() {
        if (ArrayGrowth.isWasteful(limit, listed.length)) {
            resize(limit);
        }
    }

    private void catchUp() {
        for (int k = 0; k < moved.count(); k++) {
            int id = moved.id(k);
            moved.before(k, before);
            tiles.move(id, before, boxes, size);
        }
        moved.clear();
    }

    /** The grid, or null if the tiles are to be used, which are then up to date. */
    @Nullable
    NearGrid near() {
        NearGrid near = grid;
        if (near == null ? tiles.isStale() && size >= leastForGrid : near.isUnfit() || near.isOutgrown(size)) {
            near = new NearGrid(boxes, listed, size);
            if (near.isUnfit()) {
                near = null;
                leastForGrid = 4 * size;
            }
            grid = near;
        }
        if (near == null) {
            settle();
        }
        return near;
    }

    void growRegions() {
        if (!hasRegions && frozen != null) {
            regions = frozen.frozenRegions();
            hasRegions = true;
        }
        if (!hasRegions) {
            regions = new RegionTree(cells);
            for (int id = 0, found = 0; found < size; id++) {
                if (contains(id)) {
                    regions.add(id, boxes);
                    found++;
                }
            }
            hasRegions = true;
        }
    }

    /** The regions as a tree, built if necessary. */
    Regions grown() {
        growRegions();
        return regions.regions;
    }

    /** The number of regions of the tree, cut and uncut. */
    public int regions() {
        return grown().count();
    }
}
