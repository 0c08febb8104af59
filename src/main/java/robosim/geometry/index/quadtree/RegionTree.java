package robosim.geometry.index.quadtree;

import java.util.Arrays;

/**
 * The regions of a {@code QuadTree} as a tree, for queries around a point. Each object belongs to the one region that
 * contains its box's centre, and every region has tight bounds of all its objects, so objects across a boundary or
 * outside the world are handled too. A region is cut until it holds one object, or several whose centres are in the
 * same cell of {@code 2^-52} of the world. Cuts that would leave all objects in one quarter are skipped, so there are
 * always fewer cut regions than objects.
 */
public final class RegionTree {
    private static final int NONE = Regions.NONE;
    private static final int ABSENT = -2;
    private static final int EMPTY = Regions.EMPTY;
    // The link of an uncut region is ~id of its only object, or ~(id | MORE) of the first of several, or EMPTY.
    private static final int MORE = 1 << 29;

    private final CellGrid cells;

    public final Regions regions = new Regions();

    /** By id, the next object of the same region. */
    int[] next = new int[64];

    private final int[] path = new int[CellGrid.BITS + 2];

    public RegionTree(CellGrid cells) {
        this.cells = cells;
        Arrays.fill(next, ABSENT);
    }

    /** Adds an object whose box is in the array. */
    public void add(int id, double[] boxes) {
        ensureId(id);
        regions.reserve();
        int region = regionFor(boxes, 6 * id);
        regions.grow(region, boxes, 6 * id);
        next[id] = first(regions.links[region]);
        regions.links[region] = next[id] == NONE ? ~id : ~(id | MORE);
    }

    // Returns the uncut region that is to hold a box, cutting regions if needed, and extends the bounds of all regions
    // above it.
    private int regionFor(double[] boxes, int box) {
        long x = cells.x(boxes, box);
        long z = cells.z(boxes, box);
        int region = 0;
        while (true) {
            int link = regions.links[region];
            if (link == EMPTY) {
                return region;
            }
            boolean isCut = link >= 0;
            long heldX = isCut ? regions.x(link) : cells.x(boxes, 6 * first(link));
            long heldZ = isCut ? regions.z(link) : cells.z(boxes, 6 * first(link));
            int bit = Long.SIZE - 1 - Long.numberOfLeadingZeros((x ^ heldX) | (z ^ heldZ));
            if (isCut && bit <= regions.bit(link)) {
                regions.grow(region, boxes, box);
                region = link + CellGrid.quarter(regions.bit(link), x, z);
            } else if (bit < 0) {
                return region; // the same cell: no cut separates them
            } else {
                regions.cut(region, bit, heldX, heldZ);
            }
        }
    }

    /** Removes an object that is in the tree. */
    public void remove(int id, double[] boxes) {
        long x = cells.x(boxes, 6 * id);
        long z = cells.z(boxes, 6 * id);
        int depth = 0;
        int region = 0;
        while (regions.links[region] >= 0) {
            path[depth++] = region;
            int link = regions.links[region];
            region = link + CellGrid.quarter(regions.bit(link), x, z);
        }
        unlink(region, id, boxes);
        while (depth > 0) {
            regions.tighten(path[--depth]);
        }
    }

    private void unlink(int region, int id, double[] boxes) {
        int first = first(regions.links[region]);
        if (first == id) {
            first = next[id];
        } else {
            int before = first;
            while (next[before] != id) {
                before = next[before];
            }
            next[before] = next[id];
        }
        next[id] = ABSENT;
        regions.clear(region);
        for (int other = first; other != NONE; other = next[other]) {
            regions.grow(region, boxes, 6 * other);
        }
        regions.links[region] = first == NONE ? EMPTY : next[first] == NONE ? ~first : ~(first | MORE);
    }

    private void ensureId(int id) {
        if (id >= next.length) {
            int before = next.length;
            next = Arrays.copyOf(next, Math.max(id + 1, 2 * before));
            Arrays.fill(next, before, next.length, ABSENT);
        }
    }

    // The first object of an uncut region.
    static int first(int link) {
        return link == EMPTY ? NONE : ~link & ~MORE;
    }
}
