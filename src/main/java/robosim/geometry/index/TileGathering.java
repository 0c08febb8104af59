package robosim.geometry.index;

import java.util.Arrays;

/** Objects of {@link Tiles} that are near a box, all at once: each as often as tiles of the box list it. */
final class TileGathering {
    private int[] ids = new int[16];
    private int count;

    void clear() {
        count = 0;
    }

    int count() {
        return count;
    }

    int id(int k) {
        return ids[k];
    }

    /** Adds the objects whose listed bounds meet a closed box. */
    void gather(Tiles over, double minX, double minZ, double maxX, double maxZ) {
        if (over.rest != Tiles.NONE) {
            gatherList(over.store, over.rest, minX, minZ, maxX, maxZ);
        }
        int column0 = over.column(minX, 0);
        int column1 = over.column(maxX, 0);
        int row1 = over.row(maxZ, 0);
        int row0 = over.row(minZ, 0);
        int startX = over.spreadX(column0);
        int z = over.spreadZ(row0);
        for (int row = row0; row <= row1; row++) {
            int x = startX;
            for (int column = column0; column <= column1; column++) {
                int head = over.heads[x | z];
                if (head < Tiles.NONE) {
                    gather(over.within(head), minX, minZ, maxX, maxZ);
                } else {
                    gatherList(over.store, head, minX, minZ, maxX, maxZ);
                }
                x = Tiles.up(x, over.maskX);
            }
            z = Tiles.up(z, over.maskZ);
        }
    }

    private void gatherList(Tiles.Entries store, int head, double minX, double minZ, double maxX, double maxZ) {
        int[] entries = store.data;
        float[] bounds = store.bounds;
        int listed = head;
        while (listed != Tiles.NONE) {
            int at = 4 * listed;
            int id = entries[2 * listed];
            listed = entries[2 * listed + 1];
            if (bounds[at] <= maxX && minX <= bounds[at + 2] && bounds[at + 1] <= maxZ && minZ <= bounds[at + 3]) {
                add(id);
            }
        }
    }

    private void add(int id) {
        if (count == ids.length) {
            ids = Arrays.copyOf(ids, 2 * count);
        }
        ids[count++] = id;
    }
}
