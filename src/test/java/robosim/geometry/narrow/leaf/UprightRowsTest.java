package robosim.geometry.narrow.leaf;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.exact.Rotations;

class UprightRowsTest {
    private static final LeafKind[] KINDS = {LeafKind.UPRIGHT_BOX, LeafKind.UPRIGHT_CYLINDER, LeafKind.SPHERE};

    private final SplittableRandom random = new SplittableRandom(7);

    @Test
    void whatIsTakenComesBackToTheBit() {
        UprightRows rows = new UprightRows();
        int boxes = 0;
        for (int place = 0; place < 500; place++) {
            LeafKind kind = KINDS[random.nextInt(3)];
            double[] row = row(kind);
            assertThat(UprightRows.takes(kind, row, 0)).isTrue();
            rows.reserve(place);
            assertThat(rows.isVacant(place)).isTrue();
            rows.write(place, kind, row, 0);
            int numbers = kind == LeafKind.UPRIGHT_BOX ? 15 : 5;
            boxes += kind == LeafKind.UPRIGHT_BOX ? 1 : 0;
            int at = rows.at(place);
            assertThat(bits(rows.rows(place), at, numbers)).isEqualTo(bits(row, 0, numbers));
            double[] copy = new double[2 * Leaf.STRIDE];
            rows.copy(place, copy, Leaf.STRIDE);
            assertThat(bits(copy, Leaf.STRIDE, numbers)).isEqualTo(bits(row, 0, numbers));
            assertThat(LeafKind.of(rows.code(place))).isEqualTo(kind);
            // Who takes a cylinder or sphere for a row copies a row's length.
            assertThat(rows.rows(place).length - at).isGreaterThanOrEqualTo(Leaf.STRIDE);
        }
        assertThat(boxes).isBetween(100, 250);
    }

    @Test
    void whatHasOtherNumbersIsNotTaken() {
        double[] row = row(LeafKind.UPRIGHT_BOX);
        for (int k : new int[] {7, 9, 10, 11, 12, 13, 14}) {
            double kept = row[k];
            row[k] = kept == 0 ? -0.0 : Math.nextUp(kept);
            assertThat(UprightRows.takes(LeafKind.UPRIGHT_BOX, row, 0))
                    .as("number %d", k)
                    .isFalse();
            row[k] = kept;
        }
        assertThat(UprightRows.takes(LeafKind.UPRIGHT_BOX, row, 0)).isTrue();
        for (LeafKind kind : EnumSet.complementOf(EnumSet.copyOf(List.of(KINDS)))) {
            assertThat(UprightRows.takes(kind, row, 0)).isFalse();
        }
    }

    @Test
    void aColumnKeepsBothSortsApart() {
        LeafColumn column = new LeafColumn(1);
        LeafColumn one = new LeafColumn(1);
        one.append(1);
        one.setKind(0, LeafKind.UPRIGHT_BOX);
        System.arraycopy(row(LeafKind.UPRIGHT_BOX), 0, one.rows(), 0, Leaf.STRIDE);
        assertThat(one.fitsUpright()).isTrue();
        column.reserveUpright(0);
        int half = LeafColumn.UPRIGHT;
        column.copy(one, half);
        int whole = column.appendWhole(column, half, 1);
        assertThat(column.size()).isEqualTo(1);
        assertThat(column.uprightSize()).isEqualTo(1);
        assertThat(bits(column.rows(whole), column.at(whole), 15)).isEqualTo(bits(one.rows(), 0, 15));
        double[] a = new double[6];
        double[] b = new double[6];
        column.bounds(half, a);
        column.bounds(whole, b);
        assertThat(a).isEqualTo(b);
        column.vacate(half);
        assertThat(column.isVacant(half)).isTrue();
        assertThat(column.isVacant(whole)).isFalse();
    }

    private double[] row(LeafKind kind) {
        double[] row = new double[Leaf.STRIDE];
        for (int k = 0; k < 6; k++) {
            row[k] = random.nextDouble(0, 9);
        }
        if (kind == LeafKind.UPRIGHT_BOX) {
            Rotations.yaw(random.nextInt(5) * 37.5, 0, row, Leaf.ROTATION);
        }
        return row;
    }

    private static long[] bits(double[] numbers, int from, int count) {
        return Arrays.stream(numbers, from, from + count)
                .mapToLong(Double::doubleToRawLongBits)
                .toArray();
    }
}
