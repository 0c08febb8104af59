package robosim.geometry.index.cells;

/**
 * Walks the cells that a line may pass through, in its order, and shows those that are occupied: a square that is known to be
 * free is passed in one step. Where the line runs within rounding of an edge or a corner, the cells on both sides are shown,
 * so the walk may show a cell that the line misses, and one twice, but misses none. A walk belongs to one thread.
 *
 * <p>All coordinates are the cells' own ({@link PlacedCells}); how far along the line is in a unit of the caller's.
 */
public final class CellWalk {
    /** The line enters a cell somehow. */
    public static final int UNKNOWN = 0;

    /** The line enters a cell across a line between columns. */
    public static final int COLUMN = 1;

    /** The line enters a cell across a line between rows. */
    public static final int ROW = 2;

    private ClearanceMap map;
    private double u;
    private double v;
    private double du;
    private double dv;
    private double perU;
    private double perV;
    private double to;
    private double slack;
    private double slackAlong;

    // The cells that hold the point of the line reached so far, of which there is more than one near an edge.
    private int lowI;
    private int highI;
    private int lowJ;
    private int highJ;

    /** The foremost of their columns and rows along the line; outside the grid where it leaves that at a corner. */
    private int aheadI;

    private int aheadJ;

    // The next of them to be looked at; behind the last row where all have been.
    private int i;
    private int j;

    /** Across which coordinate the line certainly entered the only one of these cells; {@link #UNKNOWN} where that is not known. */
    private int entered;

    private double enteredAlong;

    /** How many cells away from any of these nothing is occupied; 0 if one of them is. */
    private int free;

    @SuppressWarnings("NullAway.Init") // a walk starts with its map
    public CellWalk() {}

    /** Takes a map to walk on; returns this walk, which is to be started. */
    public CellWalk over(ClearanceMap of) {
        map = of;
        return this;
    }

    /**
     * Begins a walk.
     *
     * @param u     where the line begins
     * @param du    how far it goes for each unit along it
     * @param from  where along the line to begin
     * @param to    where to end at the latest
     * @param slack more than the error of any of its coordinates; below 1/8
     */
    public void start(double u, double v, double du, double dv, double from, double to, double slack) {
        this.u = u;
        this.v = v;
        this.du = du;
        this.dv = dv;
        this.slack = slack;
        perU = 1 / du;
        perV = 1 / dv;
        slackAlong = 2 * slack * Math.min(Math.abs(perU), Math.abs(perV));
        this.to = Math.min(to, Math.min(leaves(u, du, perU, map.columns()), leaves(v, dv, perV, map.rows())));
        double begin = from;
        if (!(u >= 0 && v >= 0 && u <= map.columns() && v <= map.rows())) {
            begin = Math.max(from, Math.max(enters(u, du, perU, map.columns()), enters(v, dv, perV, map.rows())));
        }
        if (!(begin <= this.to)) {
            finish();
            return;
        }
        double atU = du == 0 ? u : u + begin * du;
        double atV = dv == 0 ? v : v + begin * dv;
        takeColumns(atU);
        takeRows(atV);
        enter();
    }

    /** Where the line enters the range of one coordinate from 0 to a count, or somewhat before. */
    private double enters(double at, double by, double per, int count) {
        if (by == 0) {
            return at < -slack || at > count + slack ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
        }
        return ((by > 0 ? -slack : count + slack) - at) * per;
    }

    private double leaves(double at, double by, double per, int count) {
        return by == 0 ? Double.POSITIVE_INFINITY : ((by > 0 ? count + slack : -slack) - at) * per;
    }

    private void finish() {
        to = Double.NEGATIVE_INFINITY;
        lowJ = 0;
        highJ = -1;
        j = 0;
        free = 1;
        lowI = 0;
        highI = -1;
    }

    private void takeColumns(double at) {
        int most = map.columns() - 1;
        lowI = clamp(at - slack, most);
        highI = clamp(at + slack, most);
        aheadI = du > 0 ? highI : lowI;
    }

    private void takeRows(double at) {
        int most = map.rows() - 1;
        lowJ = clamp(at - slack, most);
        highJ = clamp(at + slack, most);
        aheadJ = dv > 0 ? highJ : lowJ;
    }

    private static int clamp(double at, int most) {
        return at < 0 ? 0 : Math.min((int) at, most);
    }

    private void enter() {
        i = lowI;
        j = lowJ;
        free = ClearanceMap.MOST;
        entered = UNKNOWN;
    }

    /** How the line certainly enters the cell that was shown last, by more than the slack off its corners. */
    public int entered() {
        return entered;
    }

    /** How far along the line that is; to within the slack. */
    public double enteredAlong() {
        return enteredAlong;
    }

    /**
     * The number of the next occupied cell that the line may pass through; -1 if there is none.
     *
     * @param limit how far along the line to look; may only shrink
     */
    public int next(double limit) {
        while (true) {
            while (j <= highJ) {
                int cell = map.cell(i, j);
                if (i++ == highI) {
                    i = lowI;
                    j++;
                }
                int clearance = map.clearance(cell);
                if (clearance < free) {
                    free = clearance;
                }
                if (clearance == 0) {
                    return cell;
                }
            }
            boolean isSingle = lowI == highI && lowJ == highJ && lowI == aheadI && lowJ == aheadJ;
            isSingle &= du != 0 && dv != 0;
            boolean goesOn = isSingle ? run(limit) : advance(limit);
            if (!goesOn) {
                return -1;
            }
        }
    }

    /**
     * Goes on as {@link #advance} does, from a single cell and over single cells, until one is occupied or the line comes near
     * an edge that it does not cross there; false where the line ends before.
     */
    private boolean run(double limit) {
        ClearanceMap of = map;
        int columns = of.columns();
        int rows = of.rows();
        double beginU = u;
        double beginV = v;
        double byU = du;
        double byV = dv;
        double end = Math.min(to, limit + slackAlong);
        double most = 0.5 - slack;
        int stepU = byU > 0 ? 1 : -1;
        int stepV = byV > 0 ? 1 : -1;
        int behindU = byU > 0 ? 0 : 1;
        int behindV = byV > 0 ? 0 : 1;
        int column = aheadI;
        int row = aheadJ;
        int reach = Math.max(1, free);
        while (true) {
            int lineU = column + behindU + stepU * reach;
            int lineV = row + behindV + stepV * reach;
            double alongU = (lineU - beginU) * perU;
            double alongV = (lineV - beginV) * perV;
            boolean isU = alongU <= alongV;
            double along = isU ? alongU : alongV;
            double past; // how far off the middle of the cell across
            if (isU) {
                column = lineU - behindU;
                double at = beginV + along * byV;
                row = (int) at;
                past = at - row;
            } else {
                row = lineV - behindV;
                double at = beginU + along * byU;
                column = (int) at;
                past = at - column;
            }
            boolean isPlain = along <= end
                    && Math.abs(past - 0.5) <= most
                    && Integer.compareUnsigned(column, columns) < 0
                    && Integer.compareUnsigned(row, rows) < 0;
            if (!isPlain) {
                aheadI = lineU - behindU - stepU * reach;
                aheadJ = lineV - behindV - stepV * reach;
                free = reach;
                return advance(limit);
            }
            reach = of.clearance(of.cell(column, row));
            if (reach == 0) {
                lowI = column;
                highI = column;
                aheadI = column;
                lowJ = row;
                highJ = row;
                aheadJ = row;
                enter();
                entered = isU ? COLUMN : ROW;
                enteredAlong = along;
                return true;
            }
        }
    }

    /** Goes to where the line leaves the cells around it that need no look any more; false where it ends before. */
    private boolean advance(double limit) {
        int reach = Math.max(1, free);
        int lineU = du > 0 ? Math.min(aheadI + reach, map.columns()) : Math.max(aheadI - reach + 1, 0);
        int lineV = dv > 0 ? Math.min(aheadJ + reach, map.rows()) : Math.max(aheadJ - reach + 1, 0);
        boolean hasU = du != 0 && aheadI >= 0 && aheadI < map.columns();
        boolean hasV = dv != 0 && aheadJ >= 0 && aheadJ < map.rows();
        double alongU = hasU ? (leaving(lineU, map.columns()) - u) * perU : Double.POSITIVE_INFINITY;
        double alongV = hasV ? (leaving(lineV, map.rows()) - v) * perV : Double.POSITIVE_INFINITY;
        double along = Math.min(alongU, alongV);
        if (!(along <= to && along - slackAlong <= limit)) {
            return end(Math.min(to, limit), hasU ? lineU : Double.NaN, hasV ? lineV : Double.NaN);
        }
        return cross(lineU, lineV, alongU, alongV);
    }

    /** Ends the walk: near a line ahead, which it may cross before in truth, with the cells on both sides. */
    private boolean end(double along, double lineU, double lineV) {
        double atU = u + along * du;
        double atV = v + along * dv;
        finish();
        if (!(Math.abs(atU - lineU) <= slack || Math.abs(atV - lineV) <= slack)) {
            return false;
        }
        takeColumns(atU);
        takeRows(atV);
        enter();
        return true;
    }

    /** A line between cells; where that is an edge of the grid, a line so far outside that the grid is left for certain. */
    private double leaving(int line, int count) {
        return line <= 0 ? -slack : line >= count ? count + slack : line;
    }

    /** Goes to the nearer one of two lines, and to the corner if it is that; false where the line leaves the grid. */
    private boolean cross(int lineU, int lineV, double alongU, double alongV) {
        double along = Math.min(alongU, alongV);
        if (alongU <= alongV) {
            double at = dv == 0 ? v : v + along * dv;
            if (dv != 0 && Math.abs(at - lineV) <= 2 * slack) {
                takeCorner(lineU, lineV);
            } else {
                crossColumns(lineU);
                takeRows(at);
            }
        } else {
            double at = du == 0 ? u : u + along * du;
            if (du != 0 && Math.abs(at - lineU) <= 2 * slack) {
                takeCorner(lineU, lineV);
            } else {
                crossRows(lineV);
                takeColumns(at);
            }
        }
        if (lowI > highI || lowJ > highJ) {
            finish();
            return false;
        }
        enter();
        return true;
    }

    /** Takes the column behind a line; none where that is outside. */
    private void crossColumns(int line) {
        int column = du > 0 ? line : line - 1;
        aheadI = column;
        boolean isInside = column >= 0 && column < map.columns();
        lowI = isInside ? column : 0;
        highI = isInside ? column : -1;
    }

    private void crossRows(int line) {
        int row = dv > 0 ? line : line - 1;
        aheadJ = row;
        boolean isInside = row >= 0 && row < map.rows();
        lowJ = isInside ? row : 0;
        highJ = isInside ? row : -1;
    }

    /** Takes all cells at a corner, which the line passes within rounding: either of two beside it may be entered first. */
    private void takeCorner(int lineU, int lineV) {
        lowI = Math.max(lineU - 1, 0);
        highI = Math.min(lineU, map.columns() - 1);
        lowJ = Math.max(lineV - 1, 0);
        highJ = Math.min(lineV, map.rows() - 1);
        aheadI = du > 0 ? lineU : lineU - 1;
        aheadJ = dv > 0 ? lineV : lineV - 1;
    }
}
