package robosim.geometry.export;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import robosim.geometry.model.GridObject;
import robosim.geometry.world.shared.Rectangles;

/**
 * The occupied cells of a grid as few rectangles. Of a grid that would take too many, squares of two by two cells are
 * taken together, occupied if any of them is, and again, until there are few enough.
 */
final class GridCells {
    /** Most rectangles of a grid: a page with as many has 2 MB, and the graphics of a laptop draw them. */
    static final int MOST = 200_000;

    /**
     * A rectangle of cells, in columns {@code [fromColumn, toColumn)} and rows {@code [fromRow, toRow)}.
     */
    record Rectangle(int fromColumn, int fromRow, int toColumn, int toRow) {}

    /** As many columns and as many rows are taken together. */
    final int together;

    final List<Rectangle> rectangles;

    GridCells(GridObject grid) {
        this(grid, MOST);
    }

    GridCells(GridObject grid, int most) {
        BitSet cells = grid.occupied();
        int columns = grid.columns();
        int rows = grid.rows();
        int side = 1;
        List<Rectangle> cover = cover(cells, columns, rows, most);
        while (cover.size() > most) {
            cells = halved(cells, columns, rows);
            columns = (columns + 1) / 2;
            rows = (rows + 1) / 2;
            side *= 2;
            cover = cover(cells, columns, rows, most);
        }
        together = side;
        rectangles = new ArrayList<>(cover.size());
        for (Rectangle each : cover) {
            rectangles.add(new Rectangle(
                    each.fromColumn * side,
                    each.fromRow * side,
                    Math.min(each.toColumn * side, grid.columns()),
                    Math.min(each.toRow * side, grid.rows())));
        }
    }

    /** All rectangles, or one more than {@code most}. */
    private static List<Rectangle> cover(BitSet cells, int columns, int rows, int most) {
        List<Rectangle> cover = new ArrayList<>();
        Rectangles.cover(cells, columns, rows, (fromColumn, fromRow, toColumn, toRow) -> {
            if (cover.size() <= most) {
                cover.add(new Rectangle(fromColumn, fromRow, toColumn, toRow));
            }
        });
        return cover;
    }

    private static BitSet halved(BitSet cells, int columns, int rows) {
        int half = (columns + 1) / 2;
        BitSet halved = new BitSet(half * ((rows + 1) / 2));
        for (int each = cells.nextSetBit(0); each >= 0; each = cells.nextSetBit(each + 1)) {
            halved.set(each / columns / 2 * half + each % columns / 2);
        }
        return halved;
    }
}
