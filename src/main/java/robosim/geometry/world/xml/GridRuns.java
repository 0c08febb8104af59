package robosim.geometry.world.xml;

import java.util.BitSet;
import robosim.geometry.model.GridObject;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Numbers;

/**
 * The cells of a grid as a world file has them: row by row the lengths of runs of free and of occupied cells in turn. A row
 * begins with its free cells, 0 if its first cell is occupied, and its runs add up to the columns.
 */
public final class GridRuns {
    private GridRuns() {}

    /** The runs of one row, separated by spaces. */
    public static void write(GridObject grid, BitSet occupied, int row, StringBuilder out) {
        int begin = row * grid.columns();
        int end = begin + grid.columns();
        boolean isOccupied = false;
        for (int at = begin; at < end; isOccupied = !isOccupied) {
            int next = isOccupied ? occupied.nextClearBit(at) : occupied.nextSetBit(at);
            int to = next < 0 ? end : Math.min(next, end);
            out.append(isOccupied || at > begin ? " " : "").append(to - at);
            at = to;
        }
    }

    /**
     * Reads the occupied cells.
     *
     * @throws IllegalArgumentException if these are not the runs of so many cells; the text is then at the run in question,
     *     or at its end
     */
    public static BitSet read(Text text, int columns, int rows) {
        BitSet occupied = new BitSet(columns * rows);
        for (int row = 0; row < rows; row++) {
            boolean isOccupied = false;
            for (int column = 0; column < columns; isOccupied = !isOccupied) {
                FileWork.take(1);
                int run = run(text, row, column, columns, isOccupied || column > 0 ? 1 : 0);
                int cell = row * columns + column;
                occupied.set(cell, cell + run, isOccupied);
                column += run;
            }
        }
        if (text.next()) {
            throw new IllegalArgumentException("the runs must end with the last of " + rows + " rows of " + columns
                    + " cells (got: " + Numbers.shown(text.token()) + " after it)");
        }
        return occupied;
    }

    private static int run(Text text, int row, int column, int columns, int least) {
        if (!text.next()) {
            throw new IllegalArgumentException("the runs must add up to " + columns + " cells in each row"
                    + " (got: no more after " + column + " cells of row " + row + ")");
        }
        int run = length(text.token());
        if (run < least || run > columns - column) {
            throw new IllegalArgumentException("a run must be from " + least + " to " + (columns - column)
                    + " cells here, after " + column + " of the " + columns + " cells of row " + row + " (got: " + run
                    + ")");
        }
        return run;
    }

    private static int length(String token) {
        try {
            return Integer.parseInt(token);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(
                    "a run must be a whole number of cells (got: " + Numbers.shown(token) + ")", e);
        }
    }
}
