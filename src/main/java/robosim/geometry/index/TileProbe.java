package robosim.geometry.index;

import org.jspecify.annotations.Nullable;

/**
 * The objects of {@link Tiles} whose outlines may meet a small box; one that lies on several of its tiles may
 * come again. Cheaper for a few tiles than {@link TileScan}, which gives each once.
 */
final class TileProbe {
    private Tiles tiles;
    private double minX;
    private double minZ;
    private double maxX;
    private double maxZ;
    private double slack;

    private int columns;

    /** The next tile, how many there are left, and how many of them in its row. */
    private int tile;

    private int left;
    private int leftX;

    /** The last column, and after the last row. */
    private int lastColumn;

    private int endRow;

    // The box in steps of a tile, and what is asked of the sketches of the list that is read.
    private int lowX;
    private int lowZ;
    private int highX;
    private int highZ;
    private int question;

    /** The next object of the list that is read, and the list's end. */
    private int entry;

    private int end;
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
        end = entry;
    }

    /** What rounding may do to the gap between a box and outlines that reach no farther than the most. */
    static double rounding(double most, double x0, double z0, double x1, double z1) {
        // Twenty roundings of 2^-53 in sums of what is no greater than these, and what underflows.
        return 0x1p-47 * (most + Math.abs(x0) + Math.abs(z0) + Math.abs(x1) + Math.abs(z1)) + 0x1p-1000;
    }

    /** Starts at the first tile and answers on how many the box lies. */
    int start(Tiles over, double x0, double z0, double x1, double z1, double rounding) {
        slack = rounding;
        tiles = over;
        minX = x0;
        minZ = z0;
        maxX = x1;
        maxZ = z1;
        isWithin = false;
        int[] data = over.store.data;
        int rest = over.rest();
        entry = TileLists.first(data, rest, data[rest]);
        end = entry + data[rest];
        question = Sketch.EVERYBODY;
        if (over.store.hasSketches()) {
            lowX = Sketch.low(over.across(x0));
            lowZ = Sketch.low(over.along(z0));
            highX = Sketch.high(over.across(x1));
            highZ = Sketch.high(over.along(z1));
        }
        int column = over.column(x0, 0);
        int row = over.row(z0, 0);
        lastColumn = over.column(x1, 0);
        endRow = over.row(z1, 0) + 1;
        columns = lastColumn - column + 1;
        tile = over.at(column, row);
        leftX = columns;
        left = columns * (endRow - row);
        return left;
    }

    /** The next object, or {@link Tiles#NONE} after the last. */
    int next(double[] outlines) {
        while (true) {
            int id = isWithin ? within().next(outlines) : Tiles.NONE;
            if (id != Tiles.NONE) {
                return id;
            }
            isWithin = false;
            id = nextListed(outlines);
            if (!isWithin) {
                return id;
            }
        }
    }

    /** The same, but where it comes to a divided tile it only starts there. */
    private int nextListed(double[] outlines) {
        int[] data = tiles.store.data;
        int[] sketches = tiles.store.sketches;
        boolean hasSketches = tiles.store.hasSketches();
        double x = minX / 2 + maxX / 2;
        double z = minZ / 2 + maxZ / 2;
        double wide = maxX / 2 - minX / 2 + slack;
        double deep = maxZ / 2 - minZ / 2 + slack;
        int listed = entry;
        int last = end;
        int asked = question;
        while (true) {
            while (listed < last) {
                int id = data[listed];
                boolean mayMeet = !hasSketches || Sketch.mayMeet(asked, sketches[listed]);
                listed++;
                if (!mayMeet) {
                    continue;
                }
                int at = Outline.at(id);
                double halfX = outlines[at + Outline.HALF_X];
                double halfZ = outlines[at + Outline.HALF_Z];
                double cos = Math.abs(outlines[at + Outline.COS]);
                double sin = Math.abs(outlines[at + Outline.SIN]);
                double gapX = halfX * cos + halfZ * sin + wide - Math.abs(outlines[at + Outline.X] - x);
                double gapZ = halfX * sin + halfZ * cos + deep - Math.abs(outlines[at + Outline.Z] - z);
                // Two comparisons in one branch: a negative difference is a gap.
                long gaps = Double.doubleToRawLongBits(gapX) | Double.doubleToRawLongBits(gapZ);
                if (gaps >= 0) {
                    entry = listed;
                    end = last;
                    question = asked;
                    return id;
                }
            }
            if (left == 0) {
                end = entry;
                return Tiles.NONE;
            }
            visited++;
            int length = data[tile];
            listed = TileLists.first(data, tile, length);
            last = listed + length;
            if (hasSketches) {
                int row = endRow - (left + columns - 1) / columns;
                asked = Sketch.question(lowX, lowZ, highX, highZ, lastColumn + 1 - leftX, row);
            }
            left--;
            tile += TileLists.STRIDE;
            if (--leftX == 0) {
                leftX = columns;
                tile += tiles.rowStep() - TileLists.STRIDE * columns;
            }
            if (length < 0) {
                end = entry;
                within().start(tiles.within(length), minX, minZ, maxX, maxZ, slack);
                isWithin = true;
                return Tiles.NONE;
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
