package robosim.geometry.index.tiles;

/**
 * The layers of {@link Tiles} of a {@code QuadTree}: fine ones for most objects, coarser ones for larger objects, and a
 * last one for everything else. They are stale at first, and again when the number of objects has outgrown them.
 *
 * <p>An object is given by its id and its box, six numbers from six times the id on.
 */
public final class TileLayers {
    private static final int MOST_LAYERS = 8;

    /** A layer of at most this many objects is a single tile. */
    private static final int FEW = 6;

    /** A layer with fewer tiles is not worthwhile. */
    private static final int FEW_TILES = 16;

    /** Finer tiles first; the last layer takes everything. */
    private final Tiles[] layers = new Tiles[MOST_LAYERS];

    private int count;

    /** Number of objects when the tiles were laid out. */
    private int laid;

    /** Number of objects in the last layer beyond which everything is laid out again. */
    private int mostBeside;

    /** Whether the tiles were laid out while the number of objects was growing, with room for more. */
    private boolean isGrowing;

    private boolean isStale = true;

    /** Whether the tiles must be laid out before they are queried. */
    public boolean isStale() {
        return isStale;
    }

    public int count() {
        return count;
    }

    /** The k-th layer, finest first. */
    public Tiles get(int k) {
        return layers[k];
    }

    /** Adds an object, unless the tiles are stale; {@code size} is the number of objects, this one included. */
    public void add(int id, double[] boxes, int size) {
        if (!isStale) {
            layerOf(boxes, 6 * id).add(id, boxes, 6 * id);
            isStale = size > 4 * laid + FEW || layers[count - 1].objects() > mostBeside;
        }
    }

    /** Removes an object, unless the tiles are stale. */
    public void remove(int id, double[] boxes) {
        if (!isStale) {
            layerOf(boxes, 6 * id).remove(id, boxes, 6 * id);
        }
    }

    /** Changes the box of an object, unless the tiles are stale; {@code size} is the number of objects. */
    public void move(int id, double[] before, double[] boxes, int size) {
        if (isStale) {
            return;
        }
        Tiles old = layerOf(before, 0);
        if (old == layerOf(boxes, 6 * id)) {
            old.move(id, before, 0, boxes, 6 * id);
        } else {
            old.remove(id, before, 0);
            add(id, boxes, size);
        }
    }

    /** The finest layer that a box fits. */
    private Tiles layerOf(double[] boxes, int at) {
        for (int k = 0; k < count - 1; k++) {
            if (layers[k].fits(boxes, at)) {
                return layers[k];
            }
        }
        return layers[count - 1];
    }

    /** Lays out all listed objects again; {@code size} is their number. */
    public void layOut(double[] boxes, boolean[] listed, int size) {
        isGrowing = laid > 0 && size > laid;
        laid = size;
        int[] left = new int[size];
        int remaining = 0;
        for (int id = 0; remaining < size; id++) {
            if (listed[id]) {
                left[remaining++] = id;
            }
        }
        count = 0;
        int coarser = 0;
        while (count < MOST_LAYERS - 1 && remaining > FEW && tiles(remaining) >> coarser > FEW_TILES) {
            int rest = lay(left, remaining, boxes, coarser);
            coarser += 2 * rest > remaining ? 2 : 0;
            remaining = rest;
        }
        Tiles rest = Tiles.single();
        for (int k = 0; k < remaining; k++) {
            rest.add(left[k], boxes, 6 * left[k]);
        }
        layers[count++] = rest;
        mostBeside = 2 * (remaining + FEW) + laid / 16;
        isStale = false;
    }

    /** Makes a layer of the objects that fit its tiles; moves the others to the front and returns their number. */
    private int lay(int[] ids, int objects, double[] boxes, int coarser) {
        Tiles tiles = tilesFor(ids, objects, boxes, coarser);
        int left = 0;
        for (int k = 0; k < objects; k++) {
            if (tiles.fits(boxes, 6 * ids[k])) {
                tiles.add(ids[k], boxes, 6 * ids[k]);
            } else {
                ids[left++] = ids[k];
            }
        }
        if (left < objects) {
            tiles.divideCrowded(boxes);
            tiles.store.trim();
            layers[count++] = tiles;
        }
        return left;
    }

    /** Empty tiles over the area of the objects, an eighth larger on all sides if their number is growing. */
    private Tiles tilesFor(int[] ids, int objects, double[] boxes, int coarser) {
        double minX = Double.POSITIVE_INFINITY;
        double minZ = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxZ = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < objects; k++) {
            int at = 6 * ids[k];
            minX = boxes[at] < minX ? boxes[at] : minX;
            minZ = boxes[at + 2] < minZ ? boxes[at + 2] : minZ;
            maxX = boxes[at + 3] > maxX ? boxes[at + 3] : maxX;
            maxZ = boxes[at + 5] > maxZ ? boxes[at + 5] : maxZ;
        }
        double roomX = isGrowing ? (maxX - minX) / 8 : 0;
        double roomZ = isGrowing ? (maxZ - minZ) / 8 : 0;
        return Tiles.over(
                minX - roomX, minZ - roomZ, maxX + roomX, maxZ + roomZ, tiles(objects) >> coarser, new TileLists(true));
    }

    /** About one tile per object, and half as many again if their number is growing. */
    private long tiles(long objects) {
        return isGrowing ? objects + objects / 2 : objects;
    }
}
