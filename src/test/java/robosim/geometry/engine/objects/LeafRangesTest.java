package robosim.geometry.engine.objects;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

class LeafRangesTest {
    /** Objects come and go, at first all of one leaf; a list of what each wrote is the twin. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void everyObjectKeepsItsLeaves(int most) {
        SplittableRandom random = new SplittableRandom(most);
        LeafRanges spans = new LeafRanges();
        LeafColumn column = new LeafColumn(1);
        Map<Integer, double[]> twin = new TreeMap<>();
        int gone = 0;
        for (int step = 0; step < 4000; step++) {
            int id = random.nextInt(step < 50 ? 8 : 300);
            if (twin.remove(id) != null) {
                column = spans.release(id, column);
                gone++;
            } else {
                double[] marks = new double[step < 500 ? 1 : random.nextInt(1, most + 1)];
                int first = spans.claim(id, marks.length, column, false);
                for (int k = 0; k < marks.length; k++) {
                    marks[k] = step + 0.25 * k;
                    column.setKind(first + k, LeafKind.SPHERE);
                    column.rows()[(first + k) * Leaf.STRIDE] = marks[k];
                }
                twin.put(id, marks);
            }
            if (step % 16 == 0) {
                assertKept(spans, column, twin);
            }
        }
        assertThat(gone).isBetween(1000, 2500);
        // Of leaves that are given up, few are kept for long.
        assertThat(column.size()).isLessThan(2 * most * 300 + 64);
    }

    /** Leaves of half a row, and from some step on of both sorts. */
    @ParameterizedTest
    @ValueSource(ints = {0, 200, 100_000})
    void leavesOfBothSortsAreKept(int plainSteps) {
        SplittableRandom random = new SplittableRandom(plainSteps);
        LeafRanges spans = new LeafRanges();
        LeafColumn column = new LeafColumn(1);
        Map<Integer, Double> twin = new TreeMap<>();
        LeafColumn own = new LeafColumn(1);
        own.append(1);
        own.setKind(0, LeafKind.SPHERE);
        int halves = 0;
        for (int step = 0; step < 4000; step++) {
            int id = random.nextInt(300);
            if (twin.remove(id) != null) {
                column = spans.release(id, column);
            } else {
                boolean upright = step < plainSteps || random.nextBoolean();
                own.rows()[3] = step;
                int leaf = spans.claim(id, 1, column, upright);
                column.copy(own, leaf);
                halves += (leaf & LeafColumn.UPRIGHT) != 0 ? 1 : 0;
                twin.put(id, (double) step);
            }
            if (step % 16 == 0) {
                LeafColumn now = column;
                twin.forEach((each, mark) -> {
                    int leaf = spans.first(each);
                    assertThat(now.kind(leaf)).isEqualTo(LeafKind.SPHERE);
                    assertThat(now.rows(leaf)[now.at(leaf) + 3]).isEqualTo(mark);
                });
            }
        }
        assertThat(halves).isGreaterThan(900);
        assertThat(column.size()).isLessThan(2 * 300 + 64);
        assertThat(column.uprightSize()).isLessThanOrEqualTo(300);
    }

    private static void assertKept(LeafRanges spans, LeafColumn column, Map<Integer, double[]> twin) {
        twin.forEach((id, marks) -> {
            assertThat(spans.count(id)).as("leaves of %d", id).isEqualTo(marks.length);
            for (int k = 0; k < marks.length; k++) {
                assertThat(column.rows()[(spans.first(id) + k) * Leaf.STRIDE]).isEqualTo(marks[k]);
            }
        });
    }
}
