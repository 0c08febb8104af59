package robosim.geometry.viewer.scene;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GridObject;
import robosim.geometry.world.shared.Rectangles;

/** The occupied cells of a grid, as a piece of its projection; for pictures, in plain doubles. */
public final class CellArea implements Footprint {
    private final GridObject grid;
    private final double cos;
    private final double sin;

    CellArea(GridObject grid) {
        this.grid = grid;
        cos = grid.pose().rotation(0);
        sin = grid.pose().rotation(2);
    }

    /** The column of a point of the floor, in cells from the first one's edge. */
    private double column(double x, double z) {
        double dx = x - grid.center().x();
        double dz = z - grid.center().z();
        return (cos * dx - sin * dz) / grid.cell() + grid.columns() / 2.0;
    }

    private double row(double x, double z) {
        double dx = x - grid.center().x();
        double dz = z - grid.center().z();
        return (sin * dx + cos * dz) / grid.cell() + grid.rows() / 2.0;
    }

    /** How deep a point is within its cell, if that is occupied; else minus the distance of the nearest cell nearby. */
    double depth(double x, double z) {
        double column = column(x, z);
        double row = row(x, z);
        int i = (int) Math.floor(column);
        int j = (int) Math.floor(row);
        if (isOccupied(i, j)) {
            double edge = Math.min(Math.min(column - i, i + 1 - column), Math.min(row - j, j + 1 - row));
            return edge * grid.cell();
        }
        return -distance(x, z, grid.cell());
    }

    private boolean isOccupied(int column, int row) {
        return column >= 0 && row >= 0 && column < grid.columns() && row < grid.rows() && grid.isOccupied(column, row);
    }

    /** The distance of a point from the nearest occupied cell; 0 on it, infinite if it is beyond {@code limit}. */
    public double distance(double x, double z, double limit) {
        double column = column(x, z);
        double row = row(x, z);
        double reach = limit / grid.cell();
        double least = Double.POSITIVE_INFINITY;
        for (int j = first(row - reach); j <= last(row + reach, grid.rows()); j++) {
            for (int i = first(column - reach); i <= last(column + reach, grid.columns()); i++) {
                if (grid.isOccupied(i, j)) {
                    double across = Math.max(0, Math.max(i - column, column - i - 1));
                    double down = Math.max(0, Math.max(j - row, row - j - 1));
                    least = Math.min(least, across * across + down * down);
                }
            }
        }
        double distance = Math.sqrt(least) * grid.cell();
        return distance <= limit ? distance : Double.POSITIVE_INFINITY;
    }

    private static int first(double from) {
        return (int) Math.max(0, Math.floor(from));
    }

    private static int last(double to, int count) {
        return (int) Math.min(count - 1.0, Math.floor(to));
    }

    /**
     * Polygons of the page that cover the occupied cells in its map, or in a part of the world: of cells smaller than a pixel
     * as many as take one are drawn together, occupied if any of them is.
     *
     * @param part null for all that the page shows
     */
    public List<double[]> onPage(MapFrame frame, @Nullable Bounds part) {
        double[] x = {frame.worldX(frame.left()), frame.worldX(frame.right())};
        double[] z = {frame.worldZ(frame.top()), frame.worldZ(frame.bottom())};
        if (part != null) {
            x = new double[] {part.minX(), part.maxX()};
            z = new double[] {part.minZ(), part.maxZ()};
        }
        double[] columns = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        double[] rows = columns.clone();
        for (int corner = 0; corner < 4; corner++) {
            extend(columns, column(x[corner & 1], z[corner >> 1]));
            extend(rows, row(x[corner & 1], z[corner >> 1]));
        }
        int together = Math.max(1, (int) Math.min(Math.floor(1 / (grid.cell() * frame.scale)), 1 << 30));
        Window window = new Window(
                first(columns[0]),
                first(rows[0]),
                last(columns[1], grid.columns()),
                last(rows[1], grid.rows()),
                together);
        List<double[]> polygons = new ArrayList<>();
        if (window.lastColumn < window.firstColumn || window.lastRow < window.firstRow) {
            return polygons;
        }
        Rectangles.cover(
                window.blocks(grid),
                window.columns(),
                window.rows(),
                (fromColumn, fromRow, toColumn, toRow) -> polygons.add(frame.toPage(rectangle(
                        window.column(fromColumn), window.row(fromRow), window.column(toColumn), window.row(toRow)))));
        return polygons;
    }

    private static void extend(double[] range, double value) {
        range[0] = Math.min(range[0], value);
        range[1] = Math.max(range[1], value);
    }

    /** The whole grid with its free cells, as a polygon of the page. */
    public double[] outline(MapFrame frame) {
        return frame.toPage(rectangle(0, 0, grid.columns(), grid.rows()));
    }

    /** The corners of the rectangle between columns and rows, in the world. */
    private double[] rectangle(int fromColumn, int fromRow, int toColumn, int toRow) {
        double[] corners = new double[8];
        for (int k = 0; k < 4; k++) {
            double u = ((k == 0 || k == 3 ? fromColumn : toColumn) - grid.columns() / 2.0) * grid.cell();
            double v = ((k < 2 ? fromRow : toRow) - grid.rows() / 2.0) * grid.cell();
            corners[2 * k] = grid.center().x() + cos * u + sin * v;
            corners[2 * k + 1] = grid.center().z() - sin * u + cos * v;
        }
        return corners;
    }

    /** A part of the cells, in blocks of {@code together} columns and rows, counted from the grid's first cell. */
    private record Window(int firstColumn, int firstRow, int lastColumn, int lastRow, int together) {
        int columns() {
            return lastColumn / together - firstColumn / together + 1;
        }

        int rows() {
            return lastRow / together - firstRow / together + 1;
        }

        int column(int block) {
            return Math.min(lastColumn + 1, (firstColumn / together + block) * together);
        }

        int row(int block) {
            return Math.min(lastRow + 1, (firstRow / together + block) * together);
        }

        /** The blocks with an occupied cell. */
        BitSet blocks(GridObject grid) {
            BitSet blocks = new BitSet(columns() * rows());
            for (int j = firstRow; j <= lastRow; j++) {
                int row = (j / together - firstRow / together) * columns() - firstColumn / together;
                for (int i = firstColumn; i <= lastColumn; i++) {
                    if (grid.isOccupied(i, j)) {
                        blocks.set(row + i / together);
                    }
                }
            }
            return blocks;
        }
    }
}
