package robosim.geometry.narrow.leaf;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.WorkCounter;
import robosim.geometry.index.cells.CellRings;
import robosim.geometry.index.cells.CellScan;
import robosim.geometry.index.cells.CellWalk;
import robosim.geometry.index.cells.PlacedCells;

/**
 * Finds the occupied cells of a placed grid that a query may meet, each of which is then an upright box: those along a line,
 * those that a box may touch, also one that moves, and those around a box or in a cone, nearest first.
 *
 * <p>A query is transformed to the cells' own coordinates and widened by more than the rounding, so no cell is missed;
 * decisions are made on the cells' boxes.
 */
public final class GridWalk {
    /** How much of a distance, or of a height, is allowed for rounding. */
    private static final double WIDEN = 0x1p-44;

    private final WorkCounter work;
    private final CellWalk line = new CellWalk();
    private final CellScan scan = new CellScan();
    private final CellRings rings = new CellRings();

    /** The cell that was asked for last, as a leaf. */
    private final LeafColumn box = new LeafColumn(1);

    /** The same as an octagonal prism. */
    private final LeafColumn prism = new LeafColumn(1);

    private PlacedCells cells;
    private double[] row;
    private int at;

    /** Whether the last query can meet nothing because of its heights. */
    private boolean isApart;

    private double slack;

    /** More cells than a unit of length has, however it is rounded. */
    private double perUnit;

    /** Cells are shown one after another, as a line's errors are too large to tell them apart. */
    private boolean isBlind;

    private int nextBlind;

    @SuppressWarnings("NullAway.Init") // a query opens a grid
    public GridWalk(WorkCounter work) {
        this.work = work;
        box.append(1);
        prism.append(1);
    }

    /** Opens a grid, for its cells alone or for a query. */
    public void open(LeafColumn column, int leaf) {
        cells = column.cells(leaf);
        row = column.rows();
        at = leaf * Leaf.STRIDE;
        isApart = false;
    }

    /** Sum of the sides of a cell, or more. */
    public double sides() {
        return 2.001 / cells.perCell() + 2 * row[at + 4];
    }

    private double low() {
        return row[at + 1] - row[at + 4];
    }

    private double high() {
        return row[at + 1] + row[at + 4];
    }

    private double heightSlack(double other) {
        return WIDEN * (Math.abs(row[at + 1]) + row[at + 4] + Math.abs(other));
    }

    /** Begins a query for all cells that may touch a box of six numbers; in PLANAR pass infinite heights. */
    public void startBox(LeafColumn column, int leaf, double[] world) {
        startSwept(column, leaf, world, 0, 0);
    }

    /**
     * The same for a box that moves straight.
     *
     * @param world the box at the start, but with the heights of all of the motion
     */
    public void startSwept(LeafColumn column, int leaf, double[] world, double dx, double dz) {
        open(column, leaf);
        if (world[1] > high() + heightSlack(world[1]) || world[4] < low() - heightSlack(world[4])) {
            isApart = true;
            return;
        }
        double x = world[0] / 2 + world[3] / 2;
        double z = world[2] / 2 + world[5] / 2;
        double hx = world[3] / 2 - world[0] / 2;
        double hz = world[5] / 2 - world[2] / 2;
        double u = cells.u(x, z);
        double v = cells.v(x, z);
        double hu = cells.halfU(hx, hz);
        double hv = cells.halfV(hx, hz);
        slack = cells.slack(Math.abs(x) + Math.abs(z) + hx + hz + Math.abs(dx) + Math.abs(dz));
        scan.over(cells.map).start(u - hu, v - hv, u + hu, v + hv, cells.du(dx, dz), cells.dv(dx, dz), slack);
    }

    /** The number of the next cell that may touch the box; -1 if there is none. */
    public int nextInBox() {
        work.take();
        return isApart ? -1 : scan.next();
    }

    /** Begins a query for the cells around a box of six numbers, nearest first. */
    public void startNearest(LeafColumn column, int leaf, double[] world) {
        open(column, leaf);
        double x = world[0] / 2 + world[3] / 2;
        double z = world[2] / 2 + world[5] / 2;
        startRings(x, z, world[3] / 2 - world[0] / 2, world[5] / 2 - world[2] / 2);
    }

    private void startRings(double x, double z, double hx, double hz) {
        double u = cells.u(x, z);
        double v = cells.v(x, z);
        double hu = cells.halfU(hx, hz);
        double hv = cells.halfV(hx, hz);
        slack = cells.slack(Math.abs(x) + Math.abs(z) + hx + hz);
        perUnit = cells.perCell() * (1 + 0x1p-25);
        rings.start(cells.map, u - hu, v - hv, u + hu, v + hv, slack);
    }

    /**
     * Begins a query for the cells in a cone, nearest first.
     */
    public void startCone(LeafColumn column, int leaf, BeamAxis beam) {
        double x = beam.ox;
        double z = beam.oz;
        double ux = beam.ux();
        double uz = beam.uz();
        open(column, leaf);
        startRings(x, z, 0, 0);
        // The cone's projection is a sector where its axis rises less than it leaves room for: the sine of half of its
        // opening angle is that of the cone's over the cosine of the rise.
        double level = Math.sqrt(ux * ux + uz * uz);
        double wide = beam.sin * (1 + 0x1p-30) + 0x1p-30;
        if (wide >= level) {
            return;
        }
        double sin = wide / level;
        double cos = Math.sqrt((1 - sin) * (1 + sin));
        double ax = ux / level;
        double az = uz / level;
        double leftX = -sin * ax - cos * az;
        double leftZ = -sin * az + cos * ax;
        double rightX = -sin * ax + cos * az;
        double rightZ = -sin * az - cos * ax;
        double side = 1 / cells.perCell();
        rings.sector(
                cells.u(x, z),
                cells.v(x, z),
                cells.du(leftX, leftZ) * side,
                cells.dv(leftX, leftZ) * side,
                cells.du(rightX, rightZ) * side,
                cells.dv(rightX, rightZ) * side);
    }

    /** The number of the next cell that may be within a distance; -1 if there is none. The limit may only shrink. */
    public int nextAround(double limit) {
        work.take();
        return rings.next(limit * perUnit + slack);
    }

    /**
     * Begins a query for the cells along a line, in its order.
     *
     * @param isFlat whether heights do not count
     */
    public void startLine(LeafColumn column, int leaf, boolean isFlat, BeamAxis beam, double limit) {
        double x = beam.ox;
        double y = beam.oy;
        double z = beam.oz;
        double ux = beam.ux();
        double uy = beam.uy();
        double uz = beam.uz();
        open(column, leaf);
        double from = 0;
        double to = Double.POSITIVE_INFINITY;
        if (!isFlat) {
            double slackY = heightSlack(y);
            double low = low() - slackY - y;
            double high = high() + slackY - y;
            if (uy == 0 ? low > 0 || high < 0 : uy > 0 ? high < 0 : low > 0) {
                isApart = true;
                return;
            }
            if (uy != 0) {
                double one = low / uy;
                double other = high / uy;
                from = Math.max(0, Math.min(one, other) * (1 - 0x1p-50));
                to = Math.max(one, other) * (1 + 0x1p-50);
            }
        }
        slack = 4 * cells.slack(2 * (Math.abs(x) + Math.abs(z)));
        isBlind = !(slack < 0x1p-3);
        nextBlind = 0;
        if (!isBlind) {
            line.over(cells.map)
                    .start(
                            cells.u(x, z),
                            cells.v(x, z),
                            cells.du(ux, uz),
                            cells.dv(ux, uz),
                            from,
                            Math.min(to, limit * (1 + 0x1p-40)),
                            slack);
        }
    }

    /** The number of the next cell along the line that may begin within a distance; -1 if there is none. */
    public int nextOnLine(double limit) {
        work.take();
        if (isApart) {
            return -1;
        }
        if (isBlind) {
            int cell = cells.map.next(nextBlind);
            nextBlind = cell + 1;
            return cell;
        }
        return line.next(limit * (1 + 0x1p-40));
    }

    /**
     * The face by which the line certainly enters the cell that was found last, as seen from above: 0 for one across X, 2 for
     * one across Z; -1 where that is not known, or the cells' axes are not the world's.
     */
    public int face() {
        if (isBlind || line.entered() == CellWalk.UNKNOWN || !cells.isAlongAxes()) {
            return -1;
        }
        return (line.entered() == CellWalk.COLUMN) == cells.isAlongX() ? 0 : 2;
    }

    /**
     * The same where heights count.
     *
     * @param y  where the line begins
     * @param uy the height that it gains for each unit
     */
    public int face(double y, double uy) {
        double along = line.enteredAlong();
        double off = Math.abs(y + along * uy - row[at + 1]);
        double room = row[at + 4] - heightSlack(y) - (slack / cells.perCell() + WIDEN * along);
        return off < room ? face() : -1;
    }

    /** Writes a cell, an {@link LeafKind#UPRIGHT_BOX}, as a leaf's row. */
    public void corners(int cell, double[] out, int to) {
        CellBox.write(cells, row, at, cell, out, to);
    }

    /**
     * A cell as the only leaf of a column, valid until the next one is asked for.
     *
     * @param other what it is compared with: for a {@link LeafKind#PRISM}, which has kernels only for its kind, it is one too
     */
    public LeafColumn piece(int cell, LeafKind other) {
        corners(cell, box.rows(), 0);
        box.setKind(0, LeafKind.UPRIGHT_BOX);
        if (!other.isEnclosure()) {
            return box;
        }
        Enclosure.prism(box, prism);
        return prism;
    }
}
