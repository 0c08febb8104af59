package robosim.geometry.index;

import org.jspecify.annotations.Nullable;

/**
 * The objects of {@link Tiles} whose boxes, rounded outward, meet a small box; one that lies on several of its tiles may
 * come again. Cheaper for a few tiles than {@link TileScan}, which gives each once.
 */
final class TileProbe {
    private Tiles tiles;
    private double minX;
    private double minZ;
    private double maxX;
    private double maxZ;
    private int columns;
    private int startX;
    private int atX;
    private int atZ;

    /** How many tiles are left, and how many of them in the row. */
    private int left;

    private int leftX;
    private int entry = Tiles.NONE;
    private boolean isWithin;
    private @Nullable TileProbe inner;
    private long visited;

    TileProbe(Tiles any) {
        tiles = any;
    }

    long visited() {
        return visited + (inner == null ? 0 : inner.visited());
    }

    void stop() {
        left = 0;
        isWithin = false;
        entry = Tiles.NONE;
    }

    /** Starts at the first tile and answers on how many the box lies. */
    int start(Tiles over, double x0, double z0, double x1, double z1) {
        tiles = over;
        minX = x0;
        minZ = z0;
        maxX = x1;
        maxZ = z1;
        isWithin = false;
        entry = over.rest;
        int column = over.column(x0, 0);
        int row = over.row(z0, 0);
        columns = over.column(x1, 0) - column + 1;
        startX = over.spreadX(column);
        atX = startX;
        atZ = over.spreadZ(row);
        leftX = columns;
        left = columns * (over.row(z1, 0) - row + 1);
        return left;
    }

    /** The next object, or {@link Tiles#NONE} after the last. */
    int next() {
        while (true) {
            int id = isWithin ? within().next() : Tiles.NONE;
            if (id != Tiles.NONE) {
                return id;
            }
            isWithin = false;
            id = nextListed();
            if (!isWithin) {
                return id;
            }
        }
    }

    /** The same, but where it comes to a divided tile it only starts there. */
    private int nextListed() {
        float[] entries = tiles.store.data;
        int listed = entry;
        while (true) {
            while (listed >= 0) {
                int at = listed;
                int id = Float.floatToRawIntBits(entries[at + TileEntries.ID]);
                listed = Float.floatToRawIntBits(entries[at + TileEntries.NEXT]);
                // Four comparisons in one branch: a negative difference is a gap.
                long gaps = Double.doubleToRawLongBits(maxX - entries[at])
                        | Double.doubleToRawLongBits(maxZ - entries[at + 1])
                        | Double.doubleToRawLongBits(entries[at + 2] - minX)
                        | Double.doubleToRawLongBits(entries[at + 3] - minZ);
                if (gaps >= 0) {
                    entry = listed;
                    return id;
                }
            }
            if (listed < Tiles.NONE) {
                entry = Tiles.NONE;
                within().start(tiles.within(listed), minX, minZ, maxX, maxZ);
                isWithin = true;
                return Tiles.NONE;
            }
            if (left == 0) {
                entry = Tiles.NONE;
                return Tiles.NONE;
            }
            left--;
            visited++;
            listed = tiles.heads[atX | atZ];
            atX = Tiles.up(atX, tiles.maskX);
            if (--leftX == 0) {
                leftX = columns;
                atX = startX;
                atZ = Tiles.up(atZ, tiles.maskZ);
            }
        }
    }

    private TileProbe within() {
        if (inner == null) {
            inner = new TileProbe(tiles);
        }
        return inner;
    }
}
