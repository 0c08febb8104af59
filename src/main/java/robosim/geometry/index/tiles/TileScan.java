package robosim.geometry.index.tiles;

import org.jspecify.annotations.Nullable;

/**
 * Finds the objects of {@link Tiles} whose boxes meet a query box, once each: of all tiles that list an object, it is
 * reported by the one that contains the minimum corner of the intersection of the two boxes.
 */
public final class TileScan {
    private Tiles tiles;
    private double minX;
    private double minZ;
    private double maxX;
    private double maxZ;
    private int column0;
    private int column1;
    private int column;
    private int row0;
    private int row1;
    private int row;

    /** The next position in the current list, and the list's end. */
    private int entry;

    private int end;
    private boolean isOver = true;
    private boolean isRest;
    private boolean isWithin;
    private @Nullable TileScan inner;
    private long visited;

    public TileScan(Tiles any) {
        tiles = any;
    }

    public long visited() {
        return visited + (inner == null ? 0 : inner.visited());
    }

    public void stop() {
        isOver = true;
        isWithin = false;
        end = entry;
    }

    public void start(Tiles over, double x0, double z0, double x1, double z1) {
        tiles = over;
        minX = x0;
        minZ = z0;
        maxX = x1;
        maxZ = z1;
        column0 = over.column(x0, 0);
        column1 = over.column(x1, 0);
        row0 = over.row(z0, 0);
        row1 = over.row(z1, 0);
        column = column0;
        row = row0;
        isOver = false;
        isWithin = false;
        isRest = over.hasRest();
        if (isRest) {
            read(over.rest());
        } else {
            look();
        }
    }

    private void read(int tile) {
        int[] data = tiles.store.data;
        entry = TileLists.first(data, tile, data[tile]);
        end = entry + data[tile];
    }

    /** Goes to the list of the current tile. */
    private void look() {
        visited++;
        int tile = tiles.at(column, row);
        read(tile);
        int length = tiles.store.data[tile];
        if (length < 0) {
            if (inner == null) {
                inner = new TileScan(tiles);
            }
            inner.start(tiles.within(length), minX, minZ, maxX, maxZ);
            isWithin = true;
        }
    }

    /** The next object, or {@link Tiles#NONE} after the last. */
    public int next(double[] boxes) {
        while (true) {
            if (isWithin && inner != null) {
                int id = inner.next(boxes);
                isWithin = id != Tiles.NONE;
                if (isWithin && isFirst(boxes, 6 * id)) {
                    return id;
                }
                continue;
            }
            int id = nextListed(boxes);
            if (id != Tiles.NONE) {
                return id;
            }
            if (isRest) {
                isRest = false;
                look();
            } else if (isOver || !step()) {
                isOver = true;
                return Tiles.NONE;
            }
        }
    }

    private int nextListed(double[] boxes) {
        int[] ids = tiles.store.data;
        while (entry < end) {
            int id = ids[entry++];
            if (overlaps(boxes, 6 * id) && (isRest || isFirst(boxes, 6 * id))) {
                return id;
            }
        }
        return Tiles.NONE;
    }

    private boolean step() {
        if (column < column1) {
            column++;
        } else if (row < row1) {
            column = column0;
            row++;
        } else {
            return false;
        }
        look();
        return true;
    }

    private boolean overlaps(double[] of, int at) {
        return of[at] <= maxX && minX <= of[at + 3] && of[at + 2] <= maxZ && minZ <= of[at + 5];
    }

    private boolean isFirst(double[] boxes, int at) {
        return (column == column0 || column == tiles.column(boxes[at], -Tiles.MARGIN))
                && (row == row0 || row == tiles.row(boxes[at + 2], -Tiles.MARGIN));
    }
}
