package robosim.geometry.world.shared;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RectanglesTest {
    private record Rectangle(int fromX, int fromRow, int toX, int toRow) {}

    private static List<Rectangle> cover(BitSet cells, int width, int height) {
        List<Rectangle> found = new ArrayList<>();
        Rectangles.cover(
                cells,
                width,
                height,
                (fromX, fromRow, toX, toRow) -> found.add(new Rectangle(fromX, fromRow, toX, toRow)));
        return found;
    }

    @Test
    void coverEverySetCellOnceAndNoOther() {
        SplittableRandom random = new SplittableRandom(11);
        int merged = 0;
        for (int k = 0; k < 3000; k++) {
            int width = 1 + random.nextInt(20);
            int height = 1 + random.nextInt(20);
            int share = random.nextInt(11);
            BitSet cells = new BitSet();
            for (int cell = 0; cell < width * height; cell++) {
                cells.set(cell, random.nextInt(10) < share);
            }
            BitSet before = (BitSet) cells.clone();
            List<Rectangle> found = cover(cells, width, height);
            assertThat(cells).isEqualTo(before);
            int[] covered = new int[width * height];
            for (Rectangle rectangle : found) {
                // Cells beyond the right edge would be those of the next row.
                assertThat(rectangle.toX()).isBetween(rectangle.fromX() + 1, width);
                assertThat(rectangle.toRow()).isBetween(rectangle.fromRow() + 1, height);
                for (int row = rectangle.fromRow(); row < rectangle.toRow(); row++) {
                    for (int x = rectangle.fromX(); x < rectangle.toX(); x++) {
                        covered[row * width + x]++;
                    }
                }
            }
            for (int cell = 0; cell < covered.length; cell++) {
                assertThat(covered[cell]).as("cell %d of %s", cell, before).isEqualTo(before.get(cell) ? 1 : 0);
            }
            merged += before.cardinality() - found.size();
        }
        assertThat(merged).isGreaterThan(100_000);
    }

    @Test
    void makeOneBoxOfAStraightWall() {
        BitSet cells = new BitSet();
        for (int row = 0; row < 9; row++) {
            cells.set(row * 7 + 2, row * 7 + 4);
        }
        assertThat(cover(cells, 7, 9)).containsExactly(new Rectangle(2, 0, 4, 9));
    }
}
