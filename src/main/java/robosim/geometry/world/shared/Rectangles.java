package robosim.geometry.world.shared;

import java.util.BitSet;

/** Covers the set cells of a grid exactly by a small number of disjoint rectangles, for pictures and for boxes. */
public final class Rectangles {
    private Rectangles() {}

    /** Takes the cells of columns {@code [fromColumn, toColumn)} in rows {@code [fromRow, toRow)}. */
    @FunctionalInterface
    public interface Taker<E extends Exception> {
        void take(int fromColumn, int fromRow, int toColumn, int toRow) throws E;
    }

    /**
     * A greedy cover: the longest run to the right of the first uncovered cell, then as many rows down as contain all
     * of it. Not always the minimum, but a straight wall becomes one rectangle.
     *
     * @param cells that in column i and row j is bit {@code j * columns + i}
     */
    public static <E extends Exception> void cover(BitSet cells, int columns, int rows, Taker<E> taker) throws E {
        BitSet left = (BitSet) cells.clone();
        for (int from = left.nextSetBit(0); from >= 0; from = left.nextSetBit(from)) {
            int row = from / columns;
            int end = Math.min(left.nextClearBit(from), (row + 1) * columns);
            left.clear(from, end);
            int toRow = row + 1;
            while (toRow < rows && isFull(left, from + (toRow - row) * columns, end - from)) {
                left.clear(from + (toRow - row) * columns, end + (toRow - row) * columns);
                toRow++;
            }
            FileWork.take(toRow - row);
            taker.take(from - row * columns, row, end - row * columns, toRow);
        }
    }

    private static boolean isFull(BitSet cells, int from, int length) {
        return cells.nextClearBit(from) >= from + length;
    }
}
