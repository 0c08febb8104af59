package robosim.geometry.index;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

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
    /** Greatest id: four numbers for each must fit one array. */
    public static final int MAX_ID = (1 << 28) - 2;

    /** Room for so many more is not worth giving up. */
    private static final int FEW = 1024;

    private final Cells cells;

    // By id: the box; the first number is NaN where there is none.
    double[] boxes;
    private int size;

    private final Runnable laidOut;

    /** No coordinate of a box was ever of a greater magnitude. */
    double most;

    final TileLayers tiles;
    private final double[] before = new double[4];
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
        regions = new RegionTree(cells);
        tiles = new TileLayers();
        frozen = null;
        boxes = new double[4 * 64];
        Arrays.fill(boxes, Double.NaN);
    }

    private QuadTree(QuadTree of) {
        laidOut = () -> {};
        cells = of.cells;
        boxes = of.boxes;
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
        return id >= 0 && 4 * id < boxes.length && !Double.isNaN(boxes[4 * id]);
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
        if (id < 0 || id > MAX_ID || contains(id)) {
            throw new IllegalArgumentException("id must be 0 to " + MAX_ID + " and not in the tree (got: " + id + ")");
        }
        if (!(minX <= maxX) || !(minZ <= maxZ) || !finite(minX, minZ) || !finite(maxX, maxZ)) {
            throw new IllegalArgumentException("box must be finite and min at most max (got: x %s to %s, z %s to %s)"
                    .formatted(minX, maxX, minZ, maxZ));
        }
        ensureId(id);
        write(id, minX, minZ, maxX, maxZ);
        size++;
        tiles.add(id, boxes, size);
        if (grid != null) {
            grid.add(id, boxes);
        }
        if (hasRegions) {
            regions.add(id, boxes);
        }
    }

    private void write(int id, double minX, double minZ, double maxX, double maxZ) {
        if (-minX > most || maxX > most || -minZ > most || maxZ > most) {
            most = Math.max(Math.max(-minX, maxX), Math.max(-minZ, maxZ));
        }
        int at = 4 * id;
        boxes[at] = minX;
        boxes[at + 1] = minZ;
        boxes[at + 2] = maxX;
        boxes[at + 3] = maxZ;
    }

    private static boolean finite(double a, double b) {
        return Double.isFinite(a) && Double.isFinite(b);
    }

    private void ensureId(int id) {
        if (4 * id >= boxes.length) {
            int before = boxes.length;
            boxes = Arrays.copyOf(boxes, 4 * Math.min(MAX_ID + 1, Math.max(id + 1, before / 4 + before / 8)));
            Arrays.fill(boxes, before, boxes.length, Double.NaN);
        }
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
        boxes[4 * id] = Double.NaN;
        size--;
        return true;
    }

    /**
     * Gives an object of the tree another box, which must be one that could be added.
     *
     * @throws IllegalArgumentException where the id is not in the tree
     */
    public void move(int id, double minX, double minZ, double maxX, double maxZ) {
        if (!contains(id)) {
            throw new IllegalArgumentException("id must be in the tree (got: " + id + ")");
        }
        if (hasRegions) {
            regions.remove(id, boxes);
        }
        NearGrid near = grid;
        if (near == null) {
            System.arraycopy(boxes, 4 * id, before, 0, 4);
            write(id, minX, minZ, maxX, maxZ);
            tiles.move(id, before, boxes, size);
        } else {
            hasMoved = true;
            if (!tiles.isStale()) {
                moved.note(id, boxes);
            }
            write(id, minX, minZ, maxX, maxZ);
            near.move(id, boxes);
        }
        if (hasRegions) {
            regions.add(id, boxes);
        }
    }

    /** Brings the tiles up to date. */
    void settle() {
        if (!moved.isEmpty()) {
            catchUp();
        }
        if (tiles.isStale()) {
            tiles.layOut(boxes, size);
            trim();
            laidOut.run();
            if (!hasMoved) { // a world that stands still needs nothing more
                grid = null;
            }
        }
    }

    /** Gives up room that there is for more. */
    private void trim() {
        int limit = boxes.length / 4;
        while (limit > 1 && Double.isNaN(boxes[4 * limit - 4])) {
            limit--;
        }
        if (boxes.length / 4 - limit > FEW + (limit >> 6)) {
            boxes = Arrays.copyOf(boxes, 4 * limit);
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
            near = new NearGrid(boxes, size);
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
