package robosim.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.narrow.Leaf;
import robosim.geometry.narrow.LeafColumn;

class SpansTest {
    /** Objects come and go, at first all of one leaf; a list of what each wrote is the twin. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void everyObjectKeepsItsLeaves(int most) {
        SplittableRandom random = new SplittableRandom(most);
        Spans spans = new Spans();
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
                int first = spans.claim(id, marks.length, column);
                for (int k = 0; k < marks.length; k++) {
                    marks[k] = step + 0.25 * k;
                    column.setKind(first + k, Leaf.SPHERE);
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

    private static void assertKept(Spans spans, LeafColumn column, Map<Integer, double[]> twin) {
        twin.forEach((id, marks) -> {
            assertThat(spans.count(id)).as("leaves of %d", id).isEqualTo(marks.length);
            for (int k = 0; k < marks.length; k++) {
                assertThat(column.rows()[(spans.first(id) + k) * Leaf.STRIDE]).isEqualTo(marks[k]);
            }
        });
    }
}
