package robosim.geometry.world.rosmap;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/** Covers the set cells of a grid exactly by a small number of disjoint rectangles. */
public final class Rectangles {
    /** Cells of columns {@code [fromX, toX)} in rows {@code [fromRow, toRow)}. */
    record Rectangle(int fromX, int fromRow, int toX, int toRow) {}

    private Rectangles() {}

    /**
     * A greedy cover: the longest run to the right of the first uncovered cell, then as many rows down as contain all
     * of it. Not always the minimum, but a straight wall becomes one rectangle.
     *
     * @throws IllegalArgumentException if it takes more than {@code most}
     */
    static List<Rectangle> cover(BitSet cells, int width, int height, int most) {
        BitSet left = (BitSet) cells.clone();
        List<Rectangle> found = new ArrayList<>();
        for (int from = left.nextSetBit(0); from >= 0; from = left.nextSetBit(from)) {
            if (found.size() == most) {
                throw new IllegalArgumentException("the walls of a map must fit in " + most
                        + " boxes; remove single cells or use larger cells (got: more)");
            }
            int row = from / width;
            int end = Math.min(left.nextClearBit(from), (row + 1) * width);
            left.clear(from, end);
            int toRow = row + 1;
            while (toRow < height && isFull(left, from + (toRow - row) * width, end - from)) {
                left.clear(from + (toRow - row) * width, end + (toRow - row) * width);
                toRow++;
            }
            found.add(new Rectangle(from - row * width, row, end - row * width, toRow));
        }
        return found;
    }

    private static boolean isFull(BitSet cells, int from, int length) {
        return cells.nextClearBit(from) >= from + length;
    }
}
