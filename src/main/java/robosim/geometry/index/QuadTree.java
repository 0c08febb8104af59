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
    private double[] boxes = new double[4 * 64];
    private int size;

    private final Runnable laidOut;

    /** No coordinate of a box was ever of a greater magnitude. */
    private double most;

    private final TileLayers tiles = new TileLayers();
    private final double[] before = new double[4];
    private RegionTree regions;
    private boolean hasRegions;

    /** Who is near whom while tiles are out of date; none where it would not do. */
    private @Nullable NearGrid grid;

    /** A grid is for so many objects at least. */
    private int leastForGrid;

    private boolean hasMoved;

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
        Arrays.fill(boxes, Double.NaN);
    }

    public int size() {
        return size;
    }

    public boolean contains(int id) {
        return id >= 0 && 4 * id < boxes.length && !Double.isNaN(boxes[4 * id]);
    }

    /** A cursor over this tree; it sees the tree as it is when a query starts. */
    public Cursor cursor() {
        return new Cursor(this);
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
    private void settle() {
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
    private @Nullable NearGrid near() {
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

    private void growRegions() {
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

    /**
     * One query at a time over the tree it came from; reusable, nothing is allocated once its queue has grown. A change of
     * the tree ends the query: start again.
     */
    public static final class Cursor {
        /** A box on so many tiles meets few objects twice. */
        private static final int FEW_TILES = 9;

        private final QuadTree tree;
        private final TileLayers layers;
        private final NearestFirst ordered = new NearestFirst();
        private final TileWalk walk;
        private final TileScan scan;
        private final TileProbe probe;
        private final TileWalk.Line line = new TileWalk.Line();
        private final TileGathering gathering = new TileGathering();
        private boolean isOrdered;
        private int layer;
        private double slack;

        // The box, for the layers to come.
        private double x0;
        private double z0;
        private double x1;
        private double z1;

        private Cursor(QuadTree tree) {
            this.tree = tree;
            layers = tree.tiles;
            Tiles none = Tiles.single(0);
            walk = new TileWalk(none, line);
            scan = new TileScan(none);
            probe = new TileProbe(none);
        }

        /** How many regions this cursor has looked into since it was made. */
        public long visited() {
            return ordered.visited() + walk.visited() + scan.visited() + probe.visited();
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

        /**
         * Starts the query for all objects whose boxes, rounded outward, meet this closed box, if it is small; take them
         * with {@link #nextNear()}.
         *
         * @return whether it is small: else start a query that gives each object once
         */
        public boolean startNear(double minX, double minZ, double maxX, double maxZ) {
            tree.settle();
            x0 = minX;
            z0 = minZ;
            x1 = maxX;
            z1 = maxZ;
            layer = 0;
            Tiles finest = nextLayer();
            if (finest == null) {
                probe.stop();
                return true;
            }
            return probe.start(finest, minX, minZ, maxX, maxZ) <= FEW_TILES;
        }

        /** The next object near a small box, in no promised order, maybe again; -1 after the last. */
        public int nextNear() {
            while (true) {
                int id = probe.next();
                if (id != Tiles.NONE) {
                    return id;
                }
                Tiles tiles = nextLayer();
                if (tiles == null) {
                    return -1;
                }
                probe.start(tiles, x0, z0, x1, z1);
            }
        }

        /**
         * Gathers all objects but one whose boxes, maybe rounded outward to floats, meet this closed box, and answers how
         * many there are; take them with {@link #gathered}. One that lies across regions may be there again.
         */
        public int gather(double minX, double minZ, double maxX, double maxZ, int but) {
            NearGrid near = tree.near();
            gathering.start(minX, minZ, maxX, maxZ, but);
            if (near != null) {
                gathering.gather(near, tree.boxes);
                return gathering.count();
            }
            for (int k = 0; k < layers.count(); k++) {
                if (!layers.get(k).isEmpty()) {
                    gathering.gather(layers.get(k));
                }
            }
            return gathering.count();
        }

        /** The k-th object that was gathered. */
        public int gathered(int k) {
            return gathering.id(k);
        }

        /** The boxes of all objects: least x and z, greatest x and z of each from four times its id on. */
        public double[] boxes() {
            return tree.boxes;
        }

        private @Nullable Tiles nextLayer() {
            while (layer < layers.count()) {
                Tiles tiles = layers.get(layer++);
                if (!tiles.isEmpty()) {
                    return tiles;
                }
            }
            return null;
        }

        /**
         * Starts the query for all objects whose boxes the ray may meet at a parameter up to the limit, region by region;
         * take them with {@link #next(double)}. A point of the ray is its start plus the parameter times the direction.
         *
         * @param limit at least 0; may be infinite
         * @throws IllegalArgumentException where the start is not finite, or the direction zero or not finite
         */
        public void startRay(double ox, double oz, double dx, double dz, double limit) {
            double sum = Math.abs(ox) + Math.abs(oz);
            double speed = Math.abs(dx) + Math.abs(dz);
            if (!(sum < Double.POSITIVE_INFINITY && speed > 0 && speed < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException("ray must be finite and its direction not zero (got: start " + ox
                        + ", " + oz + " direction " + dx + ", " + dz + ")");
            }
            tree.settle();
            slack = 0x1p-44 * sum / speed;
            line.start(ox, oz, dx, dz, tree.most);
            walk.stop();
            layer = 0;
            isOrdered = !line.isOrdinary();
            for (int k = 0; k < layers.count(); k++) {
                // Far from one of them: all in order then.
                isOrdered |= !TileWalk.isNear(layers.get(k), ox, oz, dx, dz);
            }
            if (isOrdered) {
                tree.growRegions();
                ordered.startRay(tree.regions, ox, oz, dx, dz, limit);
            }
        }

        /**
         * Starts the query for all objects whose boxes are within a distance of a point, nearest first; take them with
         * {@link #next(double)}.
         *
         * @param limit at least 0; may be infinite
         * @throws IllegalArgumentException where the point is not finite
         */
        public void startPoint(double x, double z, double limit) {
            isOrdered = true;
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
            isOrdered = true;
            tree.growRegions();
            ordered.startSector(tree.regions, x, z, leftX, leftZ, rightX, rightZ, limit);
        }

        /**
         * The next object of a ray or point query; -1 after the last within the limit, which may shrink from call to call.
         * A ray may be given an object again, and one that it passes by.
         */
        public int next(double limit) {
            if (isOrdered) {
                return ordered.next(tree.regions, tree.boxes, limit);
            }
            // What is hit is measured with an error of its own: look a little farther.
            double reach = limit * (1 + 0x1p-44) + slack;
            while (true) {
                int id = walk.next(reach);
                if (id != Tiles.NONE) {
                    return id;
                }
                Tiles tiles = nextLayer();
                if (tiles == null) {
                    return -1;
                }
                walk.start(tiles);
            }
        }

        /** A lower bound, rounded down, of the distance at which the last object of a point query begins. */
        public double entry() {
            return ordered.entry();
        }
    }
}
