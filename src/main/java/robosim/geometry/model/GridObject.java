package robosim.geometry.model;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.index.cells.ClearanceMap;
import robosim.geometry.index.cells.PlacedCells;

/**
 * An occupancy grid: squares of one size in rows and columns, of which the occupied ones are solid boxes of one height. A
 * map of millions of cells takes a byte a cell, and rays and moves pass over what is free without looking at its cells.
 *
 * <p>It is placed by the middle of the whole grid, free cells included. Columns go along its own +X, rows along its own +Z.
 * The lines between cells are rounded where the grid stands, to a multiple of a power of two, by less than 2<sup>-50</sup>
 * of the largest coordinate of its corners: neighbours share a line, so there is neither gap nor overlap between them while
 * the grid is turned by a multiple of 90 degrees. At other headings each cell is a box that is placed and rounded for
 * itself.
 *
 * <p>A grid is static and stands upright, and is a member of no group. At each {@link Accuracy} its occupied cells are what
 * they are: a coarser one encloses the objects beside it.
 *
 * <pre>{@code
 * BitSet walls = new BitSet();
 * walls.set(0, 4);                                                          // the first row
 * GridObject map = new GridObject(new Point(0, 0.5, 0), 0.5, 1, 4, 3, walls);
 * map.isOccupied(3, 0);                                                     // true
 * map.bounds().minZ();                                                      // -0.75
 * map.bounds().maxZ();                                                      // -0.25
 * }</pre>
 */
public final class GridObject extends PlacedObject<GridObject> implements GeometryObject {
    private static final long serialVersionUID = 1;

    /** The least side of a cell, whose square is still a double. */
    private static final double LEAST_CELL = 0x1p-500;

    /** The most cells between the origin of the world and the far end of a grid. */
    private static final double FARTHEST = 0x1p30;

    private final transient double cell;
    private final transient double height;
    private final transient ClearanceMap cells;

    /**
     * A grid facing +X.
     *
     * @param center   the middle of the grid, at half its height
     * @param cell     side of a cell in world units, at least 2<sup>-500</sup>; the grid must lie within 2<sup>30</sup> cells of the origin
     * @param height   extent along Y in world units; at least 0
     * @param columns  cells along X; at least 1
     * @param rows     cells along Z; at least 1. There are at most 2<sup>28</sup> cells
     * @param occupied the occupied cells, of which there must be one: that in column i and row j is bit j * columns + i
     */
    public GridObject(Point center, double cell, double height, int columns, int rows, BitSet occupied) {
        this(Tag.NONE, Pose.of(center, 0), cell, height, map(columns, rows, occupied));
    }

    GridObject(Tag tag, Pose pose, double cell, double height, ClearanceMap cells) {
        super(tag, pose, null);
        if (!(cell >= LEAST_CELL)) {
            throw new IllegalArgumentException("cell must be a number from 2^-500 to 2^100 (got: " + cell + ")");
        }
        if (tag.moveable()) {
            throw new IllegalArgumentException("a grid is static, so it cannot be moveable: give it a name with named"
                    + " (got: \"" + tag.name() + "\")");
        }
        this.cell = Checks.size("cell", cell);
        this.height = Checks.halved("height", height);
        this.cells = cells;
        check(pose);
    }

    /**
     * A grid of given bits, eight a byte.
     *
     * @param occupied as {@link #bytes} gives them: one bit for each cell, and no more bytes than these need
     */
    public static GridObject of(Point center, double cell, double height, int columns, int rows, byte[] occupied) {
        return of(Tag.NONE, Pose.of(center, 0), cell, height, columns, rows, occupied);
    }

    static GridObject of(Tag tag, Pose pose, double cell, double height, int columns, int rows, byte[] occupied) {
        long bytes = ((long) columns * rows + 7) / 8;
        if (Checks.present("occupied", occupied).length != bytes) {
            throw new IllegalArgumentException("occupied must have a bit for each of " + columns + " x " + rows
                    + " cells, " + bytes + " bytes (got: " + occupied.length + " bytes)");
        }
        return new GridObject(tag, pose, cell, height, map(columns, rows, BitSet.valueOf(occupied)));
    }

    private static ClearanceMap map(int columns, int rows, BitSet occupied) {
        Checks.atLeastOne("columns", columns);
        Checks.atLeastOne("rows", rows);
        long count = (long) columns * rows;
        if (count > ClearanceMap.MOST_CELLS) {
            throw new IllegalArgumentException(
                    "columns * rows must be at most " + ClearanceMap.MOST_CELLS + " (got: " + count + ")");
        }
        if (Checks.present("occupied", occupied).isEmpty() || occupied.length() > count) {
            throw new IllegalArgumentException("occupied must have a bit and none from " + count + " on (got: "
                    + (occupied.isEmpty() ? "none" : "bit " + (occupied.length() - 1)) + ")");
        }
        return new ClearanceMap(columns, rows, occupied);
    }

    private void check(Pose at) {
        double half = (double) (cells.columns() + cells.rows()) / 2;
        double x = Math.abs(at.center().x());
        double z = Math.abs(at.center().z());
        if (!(x / cell + z / cell + half <= FARTHEST)) {
            throw new IllegalArgumentException("a grid must lie within 2^30 of its cells of the origin, cells of "
                    + cell + " (got: center " + at.center() + ")");
        }
        if (!at.isUpright() || at.rotation(0) != at.rotation(8) || at.rotation(2) != -at.rotation(6)) {
            throw new IllegalArgumentException(
                    "a grid stands upright: its rotation must be that of a heading (got: " + at + ")");
        }
    }

    @Override
    GridObject with(Tag newTag, Pose newPose) {
        return new GridObject(newTag, newPose, cell, height, cells);
    }

    /** False: a grid is static. */
    @Override
    public boolean isMoveable() {
        return false;
    }

    /**
     * Refused: a grid is static.
     *
     * @throws IllegalArgumentException always
     */
    @Override
    public GridObject moveable(String name) {
        return with(tag.moveable(name), pose);
    }

    /**
     * This grid turned in place.
     *
     * @param rx degrees about its own X: 0, as a grid stands upright
     * @param ry degrees about its own Y
     */
    @Override
    public GridObject turned(double rx, double ry) {
        return with(tag, pose.turned(rx, ry));
    }

    @Override
    public Kind kind() {
        return Kind.GRID;
    }

    /** The side of a cell in world units. */
    public double cell() {
        return cell;
    }

    /** Extent along Y in world units. */
    public double height() {
        return height;
    }

    /** The number of cells along the own X. */
    public int columns() {
        return cells.columns();
    }

    /** The number of cells along the own Z. */
    public int rows() {
        return cells.rows();
    }

    /** Whether a cell is occupied; columns go along the own +X, rows along the own +Z, both from 0. */
    public boolean isOccupied(int column, int row) {
        checkCell(column, row);
        return cells.isOccupied(cells.cell(column, row));
    }

    private void checkCell(int column, int row) {
        if (column < 0 || column >= columns() || row < 0 || row >= rows()) {
            throw new IllegalArgumentException("column and row must be in the grid of " + columns() + " x " + rows()
                    + " (got: " + column + " and " + row + ")");
        }
    }

    /** The occupied cells, that in column i and row j as bit j * columns + i; a fresh set. */
    public BitSet occupied() {
        BitSet occupied = new BitSet(columns() * rows());
        for (int each = cells.next(0); each >= 0; each = cells.next(each + 1)) {
            occupied.set(each);
        }
        return occupied;
    }

    /** The bits of {@link #occupied}, eight a byte, the first in the lowest bit; as many bytes as all cells need. */
    public byte[] bytes() {
        return Arrays.copyOf(occupied().toByteArray(), (columns() * rows() + 7) / 8);
    }

    /**
     * The box that a cell is where the grid stands, occupied or not: its sizes and its place to the bit. It faces +X where
     * the grid is turned by a multiple of 90 degrees.
     */
    public BoxObject box(int column, int row) {
        checkCell(column, row);
        double[] square = new double[6];
        PlacedCells placed = placed();
        placed.square(cells.cell(column, row), square, 0);
        BoxObject box =
                new BoxObject(new Point(square[0], pose.center().y(), square[2]), 2 * square[3], height, 2 * square[5]);
        return placed.isAlongAxes() ? box : box.at(pose.movedTo(box.center()));
    }

    /** The cells where the grid stands. */
    public PlacedCells placed() {
        Point c = pose.center();
        return new PlacedCells(cells, c.x(), c.z(), pose.rotation(0), pose.rotation(2), cell);
    }

    /** The cells, shared by all placements. */
    public ClearanceMap cells() {
        return cells;
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof GridObject that
                && cell == that.cell
                && height == that.height
                && tag.equals(that.tag)
                && pose.equals(that.pose)
                && cells.equals(that.cells);
    }

    @Override
    public int hashCode() {
        return 31 * Objects.hash(tag, pose, cell, height) + cells.hashCode();
    }

    @Override
    public String toString() {
        return "grid" + tag.text(pose) + ", " + columns() + " x " + rows() + " cells of " + cell + ", "
                + cells.occupied() + " occupied, height " + height;
    }
}
