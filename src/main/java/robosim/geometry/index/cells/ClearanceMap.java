package robosim.geometry.index.cells;

import java.util.Arrays;
import java.util.BitSet;

/**
 * The cells of a grid, one byte each: 0 for an occupied cell, else how many cells away the nearest occupied one is, counted
 * as a king moves on a chessboard, up to {@link #MOST}. No cell that is nearer than this is occupied. Immutable.
 *
 * <p>Cells are numbered row by row: the one in column i and row j is {@code j * columns + i}. In the cells' own coordinates it
 * is the square from (i, j) to (i + 1, j + 1), edges included. Outside the grid nothing is occupied.
 */
public final class ClearanceMap {
    /** The largest clearance that a byte tells. */
    public static final int MOST = 255;

    /** The largest number of cells. */
    public static final int MOST_CELLS = 1 << 28;

    private final int columns;
    private final int rows;
    private final byte[] clearance;
    private final int occupied;
    private final int firstColumn;
    private final int lastColumn;
    private final int firstRow;
    private final int lastRow;

    /**
     * Measures the clearance of all cells in two passes, downward and upward (Rosenfeld and Pfaltz 1966, Sequential
     * Operations in Digital Picture Processing, for the chessboard distance).
     *
     * @param occupied the numbers of the occupied cells, of which there is at least one
     */
    public ClearanceMap(int columns, int rows, BitSet occupied) {
        this.columns = columns;
        this.rows = rows;
        clearance = new byte[columns * rows];
        Arrays.fill(clearance, (byte) MOST);
        int left = columns;
        int right = -1;
        int count = 0;
        for (int cell = occupied.nextSetBit(0); cell >= 0; cell = occupied.nextSetBit(cell + 1)) {
            clearance[cell] = 0;
            left = Math.min(left, cell % columns);
            right = Math.max(right, cell % columns);
            count++;
        }
        this.occupied = count;
        firstColumn = left;
        lastColumn = right;
        firstRow = occupied.nextSetBit(0) / columns;
        lastRow = (occupied.length() - 1) / columns;
        for (int j = 0; j < rows; j++) {
            measure(j, -1);
        }
        for (int j = rows - 1; j >= 0; j--) {
            measure(j, 1);
        }
    }

    /** Lowers the clearance of a row to what the row before it, and the cell before each on the row itself, allow. */
    private void measure(int j, int before) {
        int row = j * columns;
        int other = row + before * columns;
        boolean hasOther = other >= 0 && other < clearance.length;
        int first = before < 0 ? 0 : columns - 1;
        int step = -before;
        int least = MOST; // of the cell before, one more than its clearance
        for (int k = 0, i = first; k < columns; k++, i += step) {
            int here = clearance[row + i] & 0xff;
            if (here > least) {
                here = least;
            }
            if (hasOther) {
                here = Math.min(here, above(other, i));
            }
            clearance[row + i] = (byte) here;
            least = Math.min(here + 1, MOST);
        }
    }

    private int above(int other, int i) {
        int least = clearance[other + i] & 0xff;
        if (i > 0) {
            least = Math.min(least, clearance[other + i - 1] & 0xff);
        }
        if (i + 1 < columns) {
            least = Math.min(least, clearance[other + i + 1] & 0xff);
        }
        return Math.min(least + 1, MOST);
    }

    public int columns() {
        return columns;
    }

    public int rows() {
        return rows;
    }

    /** How many cells are occupied. */
    public int occupied() {
        return occupied;
    }

    /** The least column with an occupied cell. */
    public int firstColumn() {
        return firstColumn;
    }

    /** The greatest column with an occupied cell. */
    public int lastColumn() {
        return lastColumn;
    }

    /** The least row with an occupied cell. */
    public int firstRow() {
        return firstRow;
    }

    /** The greatest row with an occupied cell. */
    public int lastRow() {
        return lastRow;
    }

    /** The number of the cell in a column and a row of the grid. */
    public int cell(int column, int row) {
        return row * columns + column;
    }

    /** How far a cell is from an occupied one, by its number: 0 to {@link #MOST}. */
    public int clearance(int cell) {
        return clearance[cell] & 0xff;
    }

    /** Whether a cell is occupied, by its number. */
    public boolean isOccupied(int cell) {
        return clearance[cell] == 0;
    }

    /** The first occupied cell from a number on; -1 if there is none. */
    public int next(int from) {
        for (int cell = from; cell < clearance.length; cell++) {
            if (clearance[cell] == 0) {
                return cell;
            }
        }
        return -1;
    }

    @Override
    public boolean equals(Object other) {
        return this == other
                || (other instanceof ClearanceMap that
                        && columns == that.columns
                        && rows == that.rows
                        && Arrays.equals(clearance, that.clearance));
    }

    @Override
    public int hashCode() {
        return 31 * (31 * columns + rows) + Arrays.hashCode(clearance);
    }
}
