package robosim.geometry.world.rosmap;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/** Few rectangles that cover the set cells of a grid exactly, and no cell twice. */
public final class Rectangles {
    /** Cells of columns {@code [fromX, toX)} in rows {@code [fromRow, toRow)}. */
    record Rectangle(int fromX, int fromRow, int toX, int toRow) {}

    private Rectangles() {}

    /**
     * Greedy: the longest run to the right of the first cell that is not covered, then as many rows down as have all of
     * it. Not the fewest there could be; a straight wall is one.
     *
     * @throws IllegalArgumentException where it takes more than {@code most}
     */
    static List<Rectangle> cover(BitSet cells, int width, int height, int most) {
        BitSet left = (BitSet) cells.clone();
        List<Rectangle> found = new ArrayList<>();
        for (int from = left.nextSetBit(0); from >= 0; from = left.nextSetBit(from)) {
            if (found.size() == most) {
                throw new IllegalArgumentException("the walls of a map must fit in " + most
                        + " boxes; clean it of single cells or join cells to larger ones (got: more)");
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
