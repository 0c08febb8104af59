package robosim.geometry.index;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.index.regions.Cells;
import robosim.geometry.index.regions.RegionTree;
import robosim.geometry.index.regions.Regions;
import robosim.geometry.index.tiles.NearGrid;
import robosim.geometry.index.tiles.TileLayers;
import robosim.geometry.index.tiles.Tiles;

/**
 * Objects by a small id of the caller's and a box in the XZ plane.
 *
 * <p>A region is cut in four at its centre, again and again. Where a ray or a box asks, all regions of one depth are taken
 * at once as {@link Tiles}, about as many as there are objects: a ray steps from tile to tile, front to back, until no
 * later tile can hold anything nearer than what it has met. Objects that are too large for the tiles stand on coarser ones.
 * Where a point asks for what is nearest, the regions are a tree that is descended nearest first. Who is near a small box
 * while objects are being added or move is asked of a {@link NearGrid}, and the tiles catch up when they are asked again.
 * Each is made when first asked, and laid out anew when the number of objects has outgrown it.
 *
 * <p>Belongs to one thread at a time. Arrays have one place for every id up to the greatest.
 */
public final class QuadTree {
    /** Greatest id: six numbers for each must fit one array. */
    public static final int MAX_ID = (1 << 28) - 2;

    /** Numbers of a box: its least x, y and z, then its greatest. Heights do not count here, but stand beside the others. */
    public static final int BOX = 6;

    private static final RegionTree NO_REGIONS = new RegionTree(new Cells(0, 0, 0, 0));

    private final Cells cells;

    // By id, of those in the tree and of others that its owner keeps here.
    double[] boxes;

    /** By id, whether it is in the tree. */
    private boolean[] listed;

    /** One more than the greatest id so far. */
    private int limit;

    private int size;

    private final Runnable laidOut;

    /** No coordinate of a box was ever of a greater magnitude. */
    double most;

    private final double[] given = new double[BOX];

    final TileLayers tiles;
    private final double[] before = new double[BOX];
    RegionTree regions;
    private boolean hasRegions;

    /** Who is near whom while tiles are out of date; none where it would not do. */
    private @Nullable NearGrid grid;

    /** A grid is for so many objects at least. */
    private int leastForGrid;

    private boolean hasMoved;

    /** What this is a view of, which makes the regions for all of its views; null where it is none. */
    private final @Nullable QuadTree frozen;

    /** Who has moved since the tiles were up to date. */
    private final Moved moved = new Moved();

    /** An empty tree over a world of this extent. Objects may lie outside of it; the tree is merely coarser there. */
    public QuadTree(double minX, double minZ, double maxX, double maxZ) {
        this(minX, minZ, maxX, maxZ, () -> {});
    }

    /** The same, with what to do whenever the tree has been laid out anew: its owner may do likewise. */
    public QuadTree(double minX, double minZ, double maxX, double maxZ, Runnable whenLaidOut) {
        laidOut = whenLaidOut;
        cells = new Cells(minX, minZ, maxX, maxZ);
        regions = NO_REGIONS;
        tiles = new TileLayers();
        frozen = null;
        boxes = new double[BOX * Growth.FIRST];
        listed = new boolean[Growth.FIRST];
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

    /** Lays out what would be laid out when first asked: from now on nobody may change this tree, and many may ask its views. */
    public void freeze() {
        grid = null;
        leastForGrid = Integer.MAX_VALUE;
        settle();
        grid = null;
    }

    /** The same objects as in a frozen tree, for one more thread to ask. */
    public QuadTree view() {
        return new QuadTree(this);
    }

    /** The regions of a frozen tree, made when the first of its views asks. */
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

    /** A cursor over this tree; it sees the tree as it is when a query starts. */
    public QuadCursor cursor() {
        return new QuadCursor(this);
    }

    /**
     * Adds an object by its closed box.
     *
     * @param id small, from 0 to {@link #MAX_ID}, and not in the tree
     * @throws IllegalArgumentException where the id is taken or out of range, or the box is not finite or inside out
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

    /** Gives an id a box of {@link #BOX} numbers without adding it. */
    public void keep(int id, double[] box) {
        if (id >= listed.length) {
            resize(Math.min(MAX_ID + 1, Growth.of(id)));
        }
        limit = Math.max(limit, id + 1);
        System.arraycopy(box, 0, boxes, BOX * id, BOX);
    }

    /**
     * Adds an object that has its box here.
     *
     * @throws IllegalArgumentException where it is in the tree or its box is not finite or inside out
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

    /** The boxes by id, {@link #BOX} numbers each: of those in the tree and of others that were kept. Valid until the next is. */
    public double[] boxes() {
        return boxes;
    }

    /** Takes an object out; false where it is not in the tree. */
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
     * Gives an object of the tree another box, which must be one that could be added.
     *
     * @param to {@link #BOX} numbers
     * @throws IllegalArgumentException where the id is not in the tree
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
            if (!hasMoved) { // a world that stands still needs nothing more
                grid = null;
            }
        }
    }

    /** Gives up room that there is for more. */
    private void trim() {
        if (Growth.isWasteful(limit, listed.length)) {
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

    /** The grid, or null where the tiles are to be asked, which are up to date then. */
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

    /** The regions as a tree. */
    Regions grown() {
        growRegions();
        return regions.regions;
    }

    /** How many regions the tree has, cut and uncut. */
    public int regions() {
        return grown().count();
    }
}
