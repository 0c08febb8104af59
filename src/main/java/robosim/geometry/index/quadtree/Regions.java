package robosim.geometry.index.quadtree;

/**
 * The regions of a {@code QuadTree} in flat arrays. Region 0 is the whole world; a cut c gives the four regions 4c + 1
 * to 4c + 4, which are adjacent because a query reads them together.
 */
public final class Regions {
    static final int NONE = -1;

    /** The link of a region without objects. */
    public static final int EMPTY = Integer.MIN_VALUE;

    /** By region, four numbers each: min x, min z, max x, max z of its objects; inverted if it has none. */
    double[] bounds = new double[4 * 65];

    /** By region: its first quarter if it is cut, else a negative number that the tree assigns. */
    public int[] links = new int[65];

    // By cut: the cell of one of the objects within, and the bit of the cells that distinguishes the quarters.
    private long[] cutX = new long[16];
    private long[] cutZ = new long[16];
    private byte[] cutBit = new byte[16];
    private int cuts;
    private int freeCut = NONE;

    Regions() {
        clear(0);
    }

    public int count() {
        int free = 0;
        for (int cut = freeCut; cut != NONE; cut = (int) cutX[cut]) {
            free++;
        }
        return 4 * (cuts - free) + 1;
    }

    long x(int firstQuarter) {
        return cutX[cutOf(firstQuarter)];
    }

    long z(int firstQuarter) {
        return cutZ[cutOf(firstQuarter)];
    }

    /** The bit of a cell that distinguishes the quarters of this cut; all objects within agree in the bits above. */
    int bit(int firstQuarter) {
        return cutBit[cutOf(firstQuarter)];
    }

    /** Empties a region. */
    void clear(int region) {
        links[region] = EMPTY;
        int at = 4 * region;
        bounds[at] = Double.POSITIVE_INFINITY;
        bounds[at + 1] = Double.POSITIVE_INFINITY;
        bounds[at + 2] = Double.NEGATIVE_INFINITY;
        bounds[at + 3] = Double.NEGATIVE_INFINITY;
    }

    /** Extends a region's bounds by a box of six numbers. */
    void grow(int region, double[] boxes, int box) {
        grow(region, boxes[box], boxes[box + 2], boxes[box + 3], boxes[box + 5]);
    }

    private void grow(int region, double minX, double minZ, double maxX, double maxZ) {
        int at = 4 * region;
        bounds[at] = Math.min(bounds[at], minX);
        bounds[at + 1] = Math.min(bounds[at + 1], minZ);
        bounds[at + 2] = Math.max(bounds[at + 2], maxX);
        bounds[at + 3] = Math.max(bounds[at + 3], maxZ);
    }

    /**
     * Inserts a cut at this bit above the present contents of a region, whose cells all agree with the given one in the
     * bits above.
     */
    void cut(int region, int bit, long x, long z) {
        int cut = freeCut == NONE ? cuts++ : freeCut;
        if (cut == freeCut) {
            freeCut = (int) cutX[cut];
        }
        cutX[cut] = x;
        cutZ[cut] = z;
        cutBit[cut] = (byte) bit;
        int first = 4 * cut + 1;
        for (int quarter = first; quarter < first + 4; quarter++) {
            clear(quarter);
        }
        int held = first + CellGrid.quarter(bit, x, z);
        links[held] = links[region];
        System.arraycopy(bounds, 4 * region, bounds, 4 * held, 4);
        links[region] = first;
    }

    /** Recomputes a cut region's bounds from its quarters, and undoes the cut if only one of them is in use. */
    void tighten(int region) {
        int first = links[region];
        int used = 0;
        int last = first;
        clear(region);
        for (int quarter = first; quarter < first + 4; quarter++) {
            int at = 4 * quarter;
            grow(region, bounds[at], bounds[at + 1], bounds[at + 2], bounds[at + 3]);
            if (links[quarter] != EMPTY) {
                used++;
                last = quarter;
            }
        }
        links[region] = used > 1 ? first : links[last];
        if (used <= 1) {
            int cut = cutOf(first);
            cutX[cut] = freeCut;
            freeCut = cut;
        }
    }

    /**
     * Makes room for one more cut. When the arrays grow, cuts are reordered depth first, so that regions near in the
     * world are near in memory.
     */
    void reserve() {
        if (freeCut != NONE || cuts < cutX.length) {
            return;
        }
        int[] order = new int[cuts];
        int[] places = new int[cuts];
        list(links[0], order, 0);
        for (int place = 0; place < cuts; place++) {
            places[order[place]] = place;
        }
        long[] oldX = cutX;
        long[] oldZ = cutZ;
        byte[] oldBit = cutBit;
        int[] oldLinks = links;
        double[] oldBounds = bounds;
        cutX = new long[2 * cuts];
        cutZ = new long[2 * cuts];
        cutBit = new byte[2 * cuts];
        links = new int[8 * cuts + 1];
        bounds = new double[4 * links.length];
        System.arraycopy(oldBounds, 0, bounds, 0, 4);
        links[0] = moved(oldLinks[0], places);
        for (int cut = 0; cut < cuts; cut++) {
            int old = order[cut];
            cutX[cut] = oldX[old];
            cutZ[cut] = oldZ[old];
            cutBit[cut] = oldBit[old];
            System.arraycopy(oldBounds, 16 * old + 4, bounds, 16 * cut + 4, 16);
            for (int quarter = 1; quarter <= 4; quarter++) {
                links[4 * cut + quarter] = moved(oldLinks[4 * old + quarter], places);
            }
        }
    }

    private int list(int link, int[] order, int from) {
        if (link < 0) {
            return from;
        }
        order[from] = cutOf(link);
        int to = from + 1;
        for (int quarter = link; quarter < link + 4; quarter++) {
            to = list(links[quarter], order, to);
        }
        return to;
    }

    private static int moved(int link, int[] places) {
        return link < 0 ? link : 4 * places[cutOf(link)] + 1;
    }

    private static int cutOf(int firstQuarter) {
        return (firstQuarter - 1) >> 2;
    }
}
