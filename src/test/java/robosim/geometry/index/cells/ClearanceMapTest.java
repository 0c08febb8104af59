package robosim.geometry.index.cells;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;

/** The clearance of cells against a look at all occupied ones. */
class ClearanceMapTest {
    private static final int MAPS = Effort.cases(300);

    /** The way of a king to the nearest occupied cell. */
    private static int clearance(int columns, BitSet occupied, int cell) {
        return occupied.stream()
                .map(other -> Math.max(
                        Math.abs(other % columns - cell % columns), Math.abs(other / columns - cell / columns)))
                .min()
                .orElseThrow();
    }

    static BitSet random(int cells, double density, SplittableRandom random) {
        BitSet occupied = new BitSet();
        for (int cell = 0; cell < cells; cell++) {
            occupied.set(cell, random.nextDouble() < density);
        }
        occupied.set(random.nextInt(cells));
        return occupied;
    }

    private static void check(int columns, int rows, BitSet occupied) {
        String as = columns + " x " + rows + ": " + occupied;
        ClearanceMap map = new ClearanceMap(columns, rows, occupied);
        assertThat(map.columns()).isEqualTo(columns);
        assertThat(map.rows()).isEqualTo(rows);
        assertThat(map.occupied()).as(as).isEqualTo(occupied.cardinality());
        for (int cell = 0; cell < columns * rows; cell++) {
            int truth = Math.min(clearance(columns, occupied, cell), ClearanceMap.MOST);
            assertThat(map.clearance(cell)).as("%s, cell %d", as, cell).isEqualTo(truth);
            assertThat(map.isOccupied(cell)).as("%s, cell %d", as, cell).isEqualTo(occupied.get(cell));
            assertThat(map.next(cell)).as("%s, from %d", as, cell).isEqualTo(occupied.nextSetBit(cell));
            assertThat(map.cell(cell % columns, cell / columns)).isEqualTo(cell);
        }
        assertThat(map.next(columns * rows)).isEqualTo(-1);
        assertThat(map.firstColumn())
                .as(as)
                .isEqualTo(occupied.stream().map(c -> c % columns).min().orElseThrow());
        assertThat(map.lastColumn())
                .as(as)
                .isEqualTo(occupied.stream().map(c -> c % columns).max().orElseThrow());
        assertThat(map.firstRow())
                .as(as)
                .isEqualTo(occupied.stream().map(c -> c / columns).min().orElseThrow());
        assertThat(map.lastRow())
                .as(as)
                .isEqualTo(occupied.stream().map(c -> c / columns).max().orElseThrow());
    }

    @Test
    void isTheWayOfAKing() {
        SplittableRandom random = new SplittableRandom(3);
        int sparse = 0;
        for (int k = 0; k < MAPS; k++) {
            int columns = random.nextInt(1, 24);
            int rows = random.nextInt(1, 24);
            double density = Math.pow(random.nextDouble(), 4);
            sparse += density * columns * rows < 2 ? 1 : 0;
            check(columns, rows, random(columns * rows, density, random));
        }
        assertThat(sparse).isBetween(MAPS / 10, MAPS * 9 / 10);
    }

    @Test
    void oneRowAndOneColumn() {
        SplittableRandom random = new SplittableRandom(4);
        for (int k = 0; k < 40; k++) {
            int cells = random.nextInt(1, 60);
            BitSet occupied = random(cells, random.nextDouble(0.2), random);
            check(cells, 1, occupied);
            check(1, cells, occupied);
        }
    }

    @Test
    void aSingleCell() {
        BitSet one = new BitSet();
        one.set(0);
        check(1, 1, one);
    }

    /** A byte tells no more than 255; passes upward and downward and to both sides come to it. */
    @Test
    void isCut() {
        for (int at : new int[] {0, 299, 599}) {
            BitSet one = new BitSet();
            one.set(at);
            check(600, 1, one);
            check(1, 600, one);
            BitSet inTheSecondRow = new BitSet();
            inTheSecondRow.set(600 + at);
            check(600, 3, inTheSecondRow);
        }
    }

    @Test
    void mapsOfTheSameCellsAreEqual() {
        BitSet cells = new BitSet();
        cells.set(1);
        cells.set(5);
        ClearanceMap map = new ClearanceMap(3, 2, cells);
        assertThat(map).isEqualTo(new ClearanceMap(3, 2, (BitSet) cells.clone()));
        assertThat(map).hasSameHashCodeAs(new ClearanceMap(3, 2, (BitSet) cells.clone()));
        assertThat(map).isNotEqualTo(new ClearanceMap(2, 3, cells));
        cells.set(2);
        assertThat(map.isOccupied(2)).as("a map keeps no hold of its bits").isFalse();
        assertThat(map).isNotEqualTo(new ClearanceMap(3, 2, cells));
        // Full rows of equal bytes differ by their lengths alone.
        BitSet full = new BitSet();
        full.set(0, 6);
        assertThat(new ClearanceMap(3, 2, full)).isNotEqualTo(new ClearanceMap(2, 3, full));
    }
}
