package robosim.geometry.dynamics.planar;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** What is found in a grid of cells is what meets the box asked for, whatever was put there before, and in ascending order. */
class CellGridTest {
    private final CellGrid grid = new CellGrid();

    /** Boxes from a tenth of a cell to thousands of cells, some without end, each replaced again and again. */
    @Test
    void whatIsFoundIsWhatMeetsTheBox() {
        SplittableRandom random = new SplittableRandom(1);
        int found = 0;
        int asked = 0;
        for (int count : new int[] {1, 3, 20, 300, 7}) {
            double[][] boxes = new double[count][];
            grid.clear(count, 0.5);
            for (int item = 0; item < count; item++) {
                boxes[item] = put(random, item);
            }
            for (int change = 0; change < 2000; change++) {
                int item = random.nextInt(count);
                boxes[item] = put(random, item);
                double[] own = box(random);
                grid.find(own[0], own[1], own[2], own[3]);
                int[] expected = IntStream.range(0, count)
                        .filter(other -> meets(boxes[other], own))
                        .toArray();
                assertThat(Arrays.copyOf(grid.found, grid.foundCount))
                        .as("%d boxes, change %d", count, change)
                        .isEqualTo(expected);
                assertThat(grid.holds(item, boxes[item][0], boxes[item][1], boxes[item][2], boxes[item][3]))
                        .isTrue();
                found += expected.length;
                asked += count;
            }
        }
        assertThat(found).isBetween(asked / 20, asked / 2);
    }

    /** Boxes that are given in any order, asked for in between: those that have none yet are not found, whatever was there before. */
    @Test
    void whatHasNoBoxIsNotFound() {
        SplittableRandom random = new SplittableRandom(3);
        for (int round = 0; round < 300; round++) {
            int count = random.nextInt(1, 200);
            double[][] boxes = new double[count][];
            grid.clear(count, 0.5);
            int step = round % 2 == 0 ? 1 : count - 1; // upward or downward
            for (int k = 0, item = 0; k < count; k++, item = (item + step) % count) {
                double[] own = box(random);
                grid.find(own[0], own[1], own[2], own[3]);
                assertFound(boxes, -1, own);
                boxes[item] = put(random, item);
            }
        }
    }

    @Test
    void thoseAboveAreFound() {
        SplittableRandom random = new SplittableRandom(4);
        for (int round = 0; round < 300; round++) {
            int count = random.nextInt(1, 200);
            double[][] boxes = new double[count][];
            grid.clear(count, 0.5);
            for (int item = 0; item < count; item++) {
                boxes[item] = put(random, item);
            }
            for (int item = 0; item < count; item++) {
                double[] own = box(random);
                grid.findAbove(item, own[0], own[1], own[2], own[3]);
                assertFound(boxes, item, own);
            }
        }
    }

    private void assertFound(double[][] boxes, int above, double[] own) {
        int[] expected = IntStream.range(above + 1, boxes.length)
                .filter(other -> boxes[other] != null && meets(boxes[other], own))
                .toArray();
        assertThat(Arrays.copyOf(grid.found, grid.foundCount)).isEqualTo(expected);
    }

    /** A body that meets things again and again is put there again each time: what replaced boxes leave does not pile up. */
    @Test
    void replacedBoxesDoNotPileUp() {
        SplittableRandom random = new SplittableRandom(2);
        grid.clear(100, 1);
        for (int change = 0; change < 100_000; change++) {
            double x = random.nextDouble(100);
            grid.put(change % 100, x, 0, x + 5, 5);
        }
        // Each of the 100 covers at most 6 by 6 cells.
        assertThat(grid.entries()).isLessThan(16 * 3600);
    }

    private double[] put(SplittableRandom random, int item) {
        double[] box = box(random);
        grid.put(item, box[0], box[1], box[2], box[3]);
        return box;
    }

    private static double[] box(SplittableRandom random) {
        double width = random.nextInt(50) == 0 ? Double.POSITIVE_INFINITY : Math.pow(10, random.nextDouble(-1.3, 1.7));
        double length = Math.pow(10, random.nextDouble(-1.3, 1.7));
        double x = random.nextDouble(-20, 20);
        double z = random.nextDouble(-20, 20);
        return new double[] {x - width, z - length, x + width, z + length};
    }

    private static boolean meets(double[] a, double[] b) {
        return a[0] <= b[2] && a[2] >= b[0] && a[1] <= b[3] && a[3] >= b[1];
    }
}
