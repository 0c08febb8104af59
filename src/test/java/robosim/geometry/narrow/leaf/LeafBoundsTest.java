package robosim.geometry.narrow.leaf;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.PlanarRows;
import robosim.geometry.narrow.planar.DiscRectangle;

class LeafBoundsTest {
    @Test
    void boxesAndTrianglesAreWithinTheirBoundsToTheBitAndTheseAreTight() {
        PlanarRows rows = new PlanarRows(51);
        int exact = 0;
        for (int k = 0; k < 3000; k++) {
            LeafKind kind = rows.exactKind();
            double factor = Math.scalb(1.0, rows.random().nextInt(-60, 60));
            double[] row = PlanarRows.scaled(kind, rows.row(kind, 1, 1), factor);
            double[] out = new double[6];
            LeafBounds.of(kind, row, 0, out);
            for (int axis = 0; axis < 3; axis++) {
                String text = kind + " " + Arrays.toString(row) + " axis " + axis;
                BigDecimal least = extreme(kind, row, axis, -1);
                BigDecimal most = extreme(kind, row, axis, 1);
                assertThat(new BigDecimal(out[axis])).as(text).isLessThanOrEqualTo(least);
                assertThat(new BigDecimal(out[3 + axis])).as(text).isGreaterThanOrEqualTo(most);
                double size = 8 * Math.ulp(3 * factor);
                assertThat(least.doubleValue() - out[axis]).as(text).isLessThan(size);
                assertThat(out[3 + axis] - most.doubleValue()).as(text).isLessThan(size);
                exact += new BigDecimal(out[axis]).compareTo(least) == 0 ? 1 : 0;
            }
        }
        assertThat(exact).isBetween(100, 8000);
    }

    @Test
    void alignedBoxesAndUprightCylindersAreExactOnAGrid() {
        PlanarRows rows = new PlanarRows(52);
        for (int k = 0; k < 200; k++) {
            double[] row = rows.gridRow(k % 2 == 0 ? LeafKind.UPRIGHT_BOX : LeafKind.UPRIGHT_CYLINDER);
            double[] out = new double[6];
            LeafBounds.of(k % 2 == 0 ? LeafKind.UPRIGHT_BOX : LeafKind.UPRIGHT_CYLINDER, row, 0, out);
            double x = k % 2 == 0 ? DiscRectangle.alignedX(row, 0) : row[3];
            double z = k % 2 == 0 ? DiscRectangle.alignedZ(row, 0) : row[3];
            assertThat(out)
                    .containsExactly(row[0] - x, row[1] - row[4], row[2] - z, row[0] + x, row[1] + row[4], row[2] + z);
        }
    }

    @Test
    void turnedCylindersAreWithinAndTouchTheirBounds() {
        PlanarRows rows = new PlanarRows(53);
        double worst = 0;
        for (int k = 0; k < 300; k++) {
            double[] row = rows.row(LeafKind.CYLINDER, 1, 1);
            double[] out = new double[6];
            LeafBounds.of(LeafKind.CYLINDER, row, 0, out);
            double[] least = {9, 9, 9};
            double[] most = {-9, -9, -9};
            for (int n = 0; n < 720; n++) {
                double t = Math.PI * (n / 2) / 180;
                double x = row[3] * StrictMath.cos(t);
                double y = n % 2 == 0 ? row[4] : -row[4];
                double z = row[3] * StrictMath.sin(t);
                for (int axis = 0; axis < 3; axis++) {
                    int r = 6 + 3 * axis;
                    double p = row[axis] + row[r] * x + row[r + 1] * y + row[r + 2] * z;
                    least[axis] = Math.min(least[axis], p);
                    most[axis] = Math.max(most[axis], p);
                }
            }
            for (int axis = 0; axis < 3; axis++) {
                assertThat(out[axis]).isLessThanOrEqualTo(least[axis] + 1e-15);
                assertThat(out[3 + axis]).isGreaterThanOrEqualTo(most[axis] - 1e-15);
                worst = Math.max(worst, Math.max(least[axis] - out[axis], out[3 + axis] - most[axis]));
            }
        }
        assertThat(worst).isLessThan(1e-4);
    }

    private static BigDecimal extreme(LeafKind kind, double[] row, int axis, int side) {
        if (kind == LeafKind.TRIANGLE) {
            double a = side * row[axis];
            return new BigDecimal(side * Math.max(a, Math.max(side * row[3 + axis], side * row[6 + axis])));
        }
        BigDecimal half = BigDecimal.ZERO;
        if (kind == LeafKind.UPRIGHT_CYLINDER || kind == LeafKind.SPHERE) {
            half = new BigDecimal(kind == LeafKind.UPRIGHT_CYLINDER && axis == 1 ? row[4] : row[3]);
        } else {
            for (int own = 0; own < 3; own++) {
                half = half.add(new BigDecimal(row[3 + own]).multiply(new BigDecimal(row[6 + 3 * axis + own]).abs()));
            }
        }
        return new BigDecimal(row[axis]).add(side > 0 ? half : half.negate());
    }
}
