package robosim.geometry.index.cells;

/**
 * The cells of a grid where it stands in the XZ plane: their squares in the plane, and points of the plane in the cells' own
 * coordinates, in which cell (i, j) reaches from i to i + 1 and from j to j + 1. Immutable.
 *
 * <p>Lines between cells lie along the grid's own axes at multiples of a power of two, the quantum, as seen from the
 * world's origin. Neighbours share the line, and a cell's middle and half size are exact. So the squares have no seams where
 * the own axes are those of the world; else the middle of each is turned and rounded.
 */
public final class PlacedCells {
    /** How far below the largest coordinate the quantum is: sums of two lines, and half of them, need no rounding then. */
    private static final int BITS = 50;

    /** The share of all coordinates, and of a cell, that covers some ten roundings and the quantum. */
    private static final double ERROR = 0x1p-46;

    public final ClearanceMap map;

    private final double cos;
    private final double sin;
    private final double middleU;
    private final double middleV;
    private final double half;
    private final double perCell;
    private final double largest;

    /** Adding and subtracting it rounds to the quantum. */
    private final double rounder;

    private final double[] bounds;

    /** How far the own axes are from unit length: a rotation is kept as it was given, to 1e-9. */
    private final double skew;

    /**
     * Places a grid.
     *
     * @param x    the middle of all cells in the plane
     * @param cos  of the heading, so that columns go along (cos, -sin) and rows along (sin, cos)
     * @param side of a cell
     */
    public PlacedCells(ClearanceMap map, double x, double z, double cos, double sin, double side) {
        this.map = map;
        this.cos = cos;
        this.sin = sin;
        middleU = cos * x - sin * z;
        middleV = sin * x + cos * z;
        half = side / 2;
        perCell = 1 / side;
        largest = Math.max(Math.abs(middleU) + map.columns() * half, Math.abs(middleV) + map.rows() * half);
        rounder = Math.scalb(1.5, Math.getExponent(largest) - BITS + 52);
        skew = Math.abs(cos * cos + sin * sin - 1) + (isAlongAxes() ? 0 : 0x1p-50);
        bounds = measure();
    }

    /** Whether the own axes are those of the world, so that nothing is turned. */
    public boolean isAlongAxes() {
        return (cos == 0 && Math.abs(sin) == 1) || (sin == 0 && Math.abs(cos) == 1);
    }

    /** Whether columns go along the world's X, either way, of a grid that {@link #isAlongAxes}. */
    public boolean isAlongX() {
        return sin == 0;
    }

    private double lineU(int i) {
        return line(middleU + (2L * i - map.columns()) * half);
    }

    private double lineV(int j) {
        return line(middleV + (2L * j - map.rows()) * half);
    }

    private double line(double at) {
        return (at + rounder) - rounder;
    }

    /**
     * Writes the square of a cell: its middle in the plane, x and z, at {@code to} and {@code to + 2}, and its half sizes at
     * {@code to + 3} and {@code to + 5}: along X and Z where the grid {@link #isAlongAxes}, else along the own axes.
     */
    public void square(int cell, double[] out, int to) {
        int i = cell % map.columns();
        int j = cell / map.columns();
        rectangle(i, j, i + 1, j + 1, out, to);
    }

    /** The same for the least rectangle along the cells' axes that holds all occupied cells. */
    public void occupiedRectangle(double[] out, int to) {
        rectangle(map.firstColumn(), map.firstRow(), map.lastColumn() + 1, map.lastRow() + 1, out, to);
    }

    /** The same for the rectangle between two lines along each axis. */
    private void rectangle(int fromColumn, int fromRow, int toColumn, int toRow, double[] out, int to) {
        double lowU = lineU(fromColumn);
        double highU = lineU(toColumn);
        double lowV = lineV(fromRow);
        double highV = lineV(toRow);
        double u = (lowU + highU) / 2;
        double v = (lowV + highV) / 2;
        boolean isAcross = cos == 0;
        out[to] = cos * u + sin * v + 0.0;
        out[to + 2] = cos * v - sin * u + 0.0;
        out[to + 3] = (isAcross ? highV - lowV : highU - lowU) / 2;
        out[to + 5] = (isAcross ? highU - lowU : highV - lowV) / 2;
    }

    private double[] measure() {
        double[] all = new double[6];
        occupiedRectangle(all, 0);
        double halfX = all[3];
        double halfZ = all[5];
        if (!isAlongAxes()) {
            double c = Math.abs(cos);
            double s = Math.abs(sin);
            double more = 0x1p-46 * largest;
            halfX = all[3] * c + all[5] * s + more;
            halfZ = all[3] * s + all[5] * c + more;
        }
        return new double[] {all[0] - halfX, all[2] - halfZ, all[0] + halfX, all[2] + halfZ};
    }

    /** Least x and z and greatest x and z of all occupied cells, 0 to 3; exact along the axes, else rounded outward. */
    public double bound(int index) {
        return bounds[index];
    }

    /** The first of a point's own coordinates, along the columns, in cells. */
    public double u(double x, double z) {
        return (cos * x - sin * z - middleU) * perCell + 0.5 * map.columns();
    }

    /** The second of them, along the rows. */
    public double v(double x, double z) {
        return (sin * x + cos * z - middleV) * perCell + 0.5 * map.rows();
    }

    /** The first own coordinate of a displacement, in cells. */
    public double du(double x, double z) {
        return (cos * x - sin * z) * perCell;
    }

    /** The second one. */
    public double dv(double x, double z) {
        return (sin * x + cos * z) * perCell;
    }

    /** Cells per unit of length. */
    public double perCell() {
        return perCell;
    }

    /** Half of what a box with given half sizes in the plane takes up along the columns, in cells. */
    public double halfU(double hx, double hz) {
        return (Math.abs(cos) * hx + Math.abs(sin) * hz) * perCell;
    }

    /** The same along the rows. */
    public double halfV(double hx, double hz) {
        return (Math.abs(sin) * hx + Math.abs(cos) * hz) * perCell;
    }

    /**
     * More than any error of own coordinates, in cells, of points as far out as given: some ten roundings, the quantum of the
     * lines, and the axes' skew.
     *
     * @param farthest the sum of the magnitudes of all coordinates that were transformed
     */
    public double slack(double farthest) {
        return ((ERROR + 2 * skew) * (farthest + largest)) * perCell + ERROR;
    }
}
