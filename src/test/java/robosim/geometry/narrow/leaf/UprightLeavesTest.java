package robosim.geometry.narrow.leaf;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class UprightLeavesTest {
    private static final LeafKind[] KINDS = {LeafKind.UPRIGHT_BOX, LeafKind.UPRIGHT_CYLINDER, LeafKind.PRISM};

    @Test
    void heightsTouchWhereTheExactIntervalsDo() {
        SplittableRandom random = new SplittableRandom(41);
        int hits = 0;
        int touches = 0;
        int count = 20_000;
        for (int k = 0; k < count; k++) {
            LeafKind kindA = KINDS[random.nextInt(3)];
            LeafKind kindB = KINDS[random.nextInt(3)];
            double[] a = row(kindA, random, k % 2 == 0);
            double[] b = row(kindB, random, k % 2 == 0);
            int low = bottom(kindA, a).compareTo(top(kindB, b));
            int high = bottom(kindB, b).compareTo(top(kindA, a));
            boolean truth = low <= 0 && high <= 0;
            String text = Arrays.toString(a) + " " + Arrays.toString(b);
            assertThat(UprightLeaves.heightsTouch(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0)))
                    .as(text)
                    .isEqualTo(truth);
            assertThat(UprightLeaves.heightsTouch(new Leaf(kindB, b, 0), new Leaf(kindA, a, 0)))
                    .as(text)
                    .isEqualTo(truth);
            hits += truth ? 1 : 0;
            touches += low == 0 || high == 0 ? 1 : 0;
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 7 / 10);
        assertThat(touches).isGreaterThan(count / 20);
    }

    @Test
    void anUlpBetweenIsApart() {
        double[] a = {0, 0.1, 0, 1, 0.2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        // 0.1 + 0.2 as stored is below the double 0.30000000000000004, and not below 0.3
        double[] b = {0, 1, 0, 0, 0, 0, 0, 0, 0.1 + 0.2, 9, 0, 0, 0, 0, 0, 0};
        assertThat(UprightLeaves.heightsTouch(
                        new Leaf(LeafKind.UPRIGHT_CYLINDER, a, 0), new Leaf(LeafKind.PRISM, b, 0)))
                .isFalse();
        b[8] = Math.nextDown(0.1 + 0.2);
        assertThat(UprightLeaves.heightsTouch(
                        new Leaf(LeafKind.UPRIGHT_CYLINDER, a, 0), new Leaf(LeafKind.PRISM, b, 0)))
                .isTrue();
    }

    private static double[] row(LeafKind kind, SplittableRandom random, boolean grid) {
        double[] row = new double[Leaf.STRIDE];
        for (int k = 0; k < 10; k++) {
            row[k] = grid ? random.nextInt(0, 6) : random.nextDouble() * 4;
        }
        if (kind == LeafKind.PRISM) {
            row[9] += row[8];
        } else {
            row[4] /= 2;
        }
        return row;
    }

    private static BigDecimal bottom(LeafKind kind, double[] row) {
        return kind == LeafKind.PRISM
                ? new BigDecimal(row[8])
                : new BigDecimal(row[1]).subtract(new BigDecimal(row[4]));
    }

    private static BigDecimal top(LeafKind kind, double[] row) {
        return kind == LeafKind.PRISM ? new BigDecimal(row[9]) : new BigDecimal(row[1]).add(new BigDecimal(row[4]));
    }
}
