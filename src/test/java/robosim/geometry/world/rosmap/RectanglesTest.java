package robosim.geometry.world.rosmap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RectanglesTest {
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
            List<Rectangles.Rectangle> found = Rectangles.cover(cells, width, height, 1000);
            assertThat(cells).isEqualTo(before);
            int[] covered = new int[width * height];
            for (Rectangles.Rectangle rectangle : found) {
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
        assertThat(Rectangles.cover(cells, 7, 9, 1)).containsExactly(new Rectangles.Rectangle(2, 0, 4, 9));
    }

    @Test
    void areLimited() {
        BitSet cells = new BitSet();
        cells.set(0);
        cells.set(2);
        cells.set(4);
        assertThat(Rectangles.cover(cells, 5, 1, 3)).hasSize(3);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Rectangles.cover(cells, 5, 1, 2))
                .withMessageContaining("must fit in 2 boxes");
    }
}
