package robosim.geometry.narrow.leaf;

import robosim.geometry.exact.Rotations;
import robosim.geometry.index.cells.PlacedCells;

/** A cell of a placed grid as a leaf: an {@link LeafKind#UPRIGHT_BOX}. */
final class CellBox {
    private CellBox() {}

    /**
     * Writes its row.
     *
     * @param row the grid's own row, from {@code at} on
     */
    static void write(PlacedCells cells, double[] row, int at, int cell, double[] out, int to) {
        cells.square(cell, out, to);
        out[to + 1] = row[at + 1];
        out[to + 4] = row[at + 4];
        if (cells.isAlongAxes()) {
            Rotations.identity(out, to + Leaf.ROTATION);
        } else {
            System.arraycopy(row, at + Leaf.ROTATION, out, to + Leaf.ROTATION, Rotations.SIZE);
        }
    }
}
