package robosim.geometry.contract;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;

/** Small maps of walls and of cells that stand alone, half of them on a grid of eighths, and the boxes that their cells are. */
final class RandomGrids {
    private RandomGrids() {}

    static GridObject next(SplittableRandom random, double heading) {
        int columns = random.nextInt(2, 24);
        int rows = random.nextInt(2, 24);
        int density = random.nextInt(4, 20);
        BitSet occupied = new BitSet();
        for (int cell = 0; cell < columns * rows; cell++) {
            occupied.set(cell, random.nextInt(density) == 0);
        }
        int row = random.nextInt(rows) * columns;
        occupied.set(row, row + random.nextInt(1, columns + 1));
        boolean isDyadic = random.nextBoolean();
        double cell = isDyadic ? random.nextInt(1, 7) / 8.0 : random.nextDouble(0.05, 0.7);
        Point center = isDyadic
                ? new Point(random.nextInt(-8, 9) / 8.0, random.nextInt(-2, 3) / 8.0, random.nextInt(-8, 9) / 8.0)
                : new Point(random.nextDouble(-3, 3), random.nextDouble(-0.5, 0.5), random.nextDouble(-3, 3));
        return new GridObject(center, cell, random.nextDouble(0.2, 3), columns, rows, occupied).turned(0, heading);
    }

    static List<BoxObject> boxes(GridObject grid) {
        List<BoxObject> boxes = new ArrayList<>();
        grid.occupied().stream().forEach(cell -> boxes.add(grid.box(cell % grid.columns(), cell / grid.columns())));
        return boxes;
    }
}
