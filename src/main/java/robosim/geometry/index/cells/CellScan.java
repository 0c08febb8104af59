package robosim.geometry.index.cells;

/**
 * Shows the occupied cells that a rectangle, also one that moves, may meet: row by row, over free cells by their clearance.
 * Coordinates are the cells' own ({@link PlacedCells}). A scan belongs to one thread.
 */
public final class CellScan {
    private ClearanceMap map;
    private double lowU;
    private double lowV;
    private double highU;
    private double highV;
    private double du;
    private double dv;
    private double slack;
    private int row;
    private int lastRow;
    private int column;
    private int lastColumn;

    @SuppressWarnings("NullAway.Init") // a scan starts with its map
    public CellScan() {}

    /** Takes a map to scan; returns this scan, which is to be started. */
    public CellScan over(ClearanceMap of) {
        map = of;
        return this;
    }

    /** Begins a scan of all cells that a rectangle may touch; the slack is more than any error of a coordinate. */
    public void start(double lowU, double lowV, double highU, double highV, double slack) {
        start(lowU, lowV, highU, highV, 0, 0, slack);
    }

    /** The same for one that moves straight by (du, dv). */
    public void start(double lowU, double lowV, double highU, double highV, double du, double dv, double slack) {
        this.lowU = lowU;
        this.lowV = lowV;
        this.highU = highU;
        this.highV = highV;
        this.du = du;
        this.dv = dv;
        this.slack = slack;
        row = 0;
        lastRow = -1;
        column = 0;
        lastColumn = -1;
        double fromU = lowU + Math.min(0, du) - slack;
        double fromV = lowV + Math.min(0, dv) - slack;
        double toU = highU + Math.max(0, du) + slack;
        double toV = highV + Math.max(0, dv) + slack;
        if (!(toU >= 0 && toV >= 0 && fromU <= map.columns() && fromV <= map.rows())) {
            return;
        }
        int firstColumn = clamp(fromU, map.columns());
        int endColumn = clamp(toU, map.columns());
        int firstRow = clamp(fromV, map.rows());
        int endRow = clamp(toV, map.rows());
        if (isFree(firstColumn, firstRow, endColumn, endRow)) {
            return;
        }
        row = firstRow;
        lastRow = endRow;
        takeRow();
    }

    private static int clamp(double at, int count) {
        return at < 0 ? 0 : Math.min((int) at, count - 1);
    }

    /** Whether one look, at the middle, tells that a range of cells is free. */
    private boolean isFree(int firstColumn, int firstRow, int endColumn, int endRow) {
        int i = (firstColumn + endColumn) >> 1;
        int j = (firstRow + endRow) >> 1;
        return map.clearance(map.cell(i, j)) > Math.max(endColumn - i, endRow - j);
    }

    /** Finds the columns of this row that the rectangle passes over. */
    private void takeRow() {
        double first = 0;
        double last = 1;
        if (dv > 0) {
            first = Math.max(0, (row - slack - highV) / dv);
            last = Math.min(1, (row + 1 + slack - lowV) / dv);
        } else if (dv < 0) {
            first = Math.max(0, (row + 1 + slack - lowV) / dv);
            last = Math.min(1, (row - slack - highV) / dv);
        }
        double from = lowU + Math.min(first * du, last * du) - slack;
        double to = highU + Math.max(first * du, last * du) + slack;
        boolean isOver = first <= last && to >= 0 && from <= map.columns();
        column = isOver ? clamp(from, map.columns()) : 0;
        lastColumn = isOver ? clamp(to, map.columns()) : -1;
    }

    /** The number of the next occupied cell; -1 if there is none. */
    public int next() {
        while (row <= lastRow) {
            while (column <= lastColumn) {
                int cell = map.cell(column, row);
                int clearance = map.clearance(cell);
                if (clearance == 0) {
                    column++;
                    return cell;
                }
                column += clearance;
            }
            row++;
            takeRow();
        }
        return -1;
    }
}
