package robosim.geometry.index.cells;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.BitSet;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.exact.Rotations;

/** The squares of cells against decimals, which hold all of a double. */
class PlacedCellsTest {
    private static final int GRIDS = Effort.cases(1000);
    private static final MathContext DIGITS = new MathContext(60);

    private record Place(double x, double z, double cos, double sin, double side) {}

    private static Place place(SplittableRandom random, double heading) {
        double size = Math.scalb(1.0, random.nextInt(-20, 21));
        double spread = size * (random.nextInt(3) == 0 ? 0 : Math.exp(random.nextDouble(-3, 8)));
        double[] rotation = new double[9];
        Rotations.yaw(heading, 0, rotation, 0);
        return new Place(
                random.nextDouble(-1, 1) * spread,
                random.nextDouble(-1, 1) * spread,
                rotation[0],
                rotation[2],
                random.nextBoolean() ? size : size * random.nextDouble(0.5, 1));
    }

    private static BigDecimal exact(double number) {
        return new BigDecimal(number);
    }

    private static double[] square(PlacedCells cells, int i, int j) {
        double[] square = new double[6];
        cells.square(cells.map.cell(i, j), square, 0);
        return square;
    }

    private static PlacedCells placed(ClearanceMap map, Place at) {
        return new PlacedCells(map, at.x, at.z, at.cos, at.sin, at.side);
    }

    private static ClearanceMap map(SplittableRandom random) {
        int columns = random.nextInt(1, 40);
        int rows = random.nextInt(1, 40);
        return new ClearanceMap(columns, rows, ClearanceMapTest.random(columns * rows, random.nextDouble(), random));
    }

    /** An edge of a square along the world's axis 0 or 2, to the negative or the positive side. */
    private static BigDecimal edge(double[] square, int axis, int sign) {
        return exact(square[axis]).add(exact(sign * square[3 + axis]));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 90, 180, -90})
    void neighboursShareALine(int heading) {
        SplittableRandom random = new SplittableRandom(41 + heading);
        int rounded = 0;
        double worst = 0;
        for (int k = 0; k < GRIDS; k++) {
            ClearanceMap map = map(random);
            Place at = place(random, heading);
            PlacedCells cells = placed(map, at);
            assertThat(cells.isAlongAxes()).isTrue();
            String as = "%s, %d x %d".formatted(at, map.columns(), map.rows());
            int i = random.nextInt(map.columns());
            int j = random.nextInt(map.rows());
            double[] square = square(cells, i, j);
            // Which way columns and rows go.
            int axis = at.cos == 0 ? 2 : 0;
            int columnsGo = (int) (at.cos == 0 ? -at.sin : at.cos);
            int rowsGo = (int) (at.cos == 0 ? at.sin : at.cos);
            if (i + 1 < map.columns()) {
                assertThat(edge(square, axis, columnsGo))
                        .as("%s, columns %d", as, i)
                        .isEqualByComparingTo(edge(square(cells, i + 1, j), axis, -columnsGo));
            }
            if (j + 1 < map.rows()) {
                assertThat(edge(square, 2 - axis, rowsGo))
                        .as("%s, rows %d", as, j)
                        .isEqualByComparingTo(edge(square(cells, i, j + 1), 2 - axis, -rowsGo));
            }
            BigDecimal truth = exact(axis == 0 ? at.x : at.z)
                    .add(exact(columnsGo * at.side).multiply(exact((2 * i - map.columns()) / 2.0)));
            double error = edge(square, axis, -columnsGo).subtract(truth).abs().doubleValue();
            boolean isX = axis == 0;
            double largest = Math.max(
                    Math.abs(at.x) + at.side * (isX ? map.columns() : map.rows()) / 2,
                    Math.abs(at.z) + at.side * (isX ? map.rows() : map.columns()) / 2);
            worst = Math.max(worst, error / largest);
            rounded += error > 0 ? 1 : 0;
        }
        // A bound that nothing comes near would be idle.
        assertThat(worst).isBetween(0.1 * 0x1p-49, 0x1p-49);
        assertThat(rounded).isBetween(GRIDS / 10, GRIDS * 9 / 10);
    }

    /** Own coordinates of points against those in the parallelogram that the cell is, at decimals. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 90, 33, -71.3, 45, 1e-7})
    void ownCoordinatesAreWithinTheSlack(double heading) {
        SplittableRandom random = new SplittableRandom(51 + (long) heading);
        double worst = 0;
        for (int k = 0; k < GRIDS; k++) {
            ClearanceMap map = map(random);
            Place at = place(random, heading);
            if (random.nextInt(3) == 0) {
                // A rotation is kept as it was given, to 1e-9.
                double by = 1 + random.nextDouble(-4e-10, 4e-10);
                at = new Place(at.x, at.z, at.cos * by, at.sin * by, at.side);
            }
            PlacedCells cells = placed(map, at);
            int i = random.nextInt(map.columns());
            int j = random.nextInt(map.rows());
            double[] square = square(cells, i, j);
            double reach = at.side * 60;
            double px = at.x + random.nextDouble(-reach, reach);
            double pz = at.z + random.nextDouble(-reach, reach);
            BigDecimal dx = exact(px).subtract(exact(square[0]));
            BigDecimal dz = exact(pz).subtract(exact(square[2]));
            BigDecimal c = exact(at.cos);
            BigDecimal s = exact(at.sin);
            BigDecimal scale = exact(at.side).multiply(c.pow(2).add(s.pow(2)));
            BigDecimal half = exact(0.5);
            BigDecimal u = c.multiply(dx).subtract(s.multiply(dz)).divide(scale, DIGITS);
            BigDecimal v = s.multiply(dx).add(c.multiply(dz)).divide(scale, DIGITS);
            double offU =
                    exact(cells.u(px, pz)).subtract(u.add(exact(i)).add(half)).doubleValue();
            double offV =
                    exact(cells.v(px, pz)).subtract(v.add(exact(j)).add(half)).doubleValue();
            double slack = cells.slack(Math.abs(px) + Math.abs(pz));
            double off = Math.max(Math.abs(offU), Math.abs(offV)) / slack;
            assertThat(off)
                    .as("%s, %d x %d, cell %d, %d, point %s, %s", at, map.columns(), map.rows(), i, j, px, pz)
                    .isLessThan(1);
            worst = Math.max(worst, off);
        }
        assertThat(worst).isGreaterThan(0.01);
    }

    /** All corners of occupied cells are within the bounds, which along the axes are met exactly. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 90, 180, 33, -71.3})
    void boundsHoldAllOccupiedCells(double heading) {
        SplittableRandom random = new SplittableRandom(61 + (long) heading);
        for (int k = 0; k < GRIDS / 10; k++) {
            int columns = random.nextInt(1, 12);
            int rows = random.nextInt(1, 12);
            BitSet occupied = ClearanceMapTest.random(columns * rows, random.nextDouble(0.3), random);
            ClearanceMap map = new ClearanceMap(columns, rows, occupied);
            Place at = place(random, heading);
            PlacedCells cells = placed(map, at);
            BigDecimal[] most = new BigDecimal[4];
            for (int cell = occupied.nextSetBit(0); cell >= 0; cell = occupied.nextSetBit(cell + 1)) {
                extend(most, square(cells, cell % columns, cell / columns), at, cells.isAlongAxes());
            }
            for (int b = 0; b < 4; b++) {
                String as = "%s, %d x %d, %s, bound %d".formatted(at, columns, rows, occupied, b);
                double beyond = exact(cells.bound(b)).subtract(most[b]).doubleValue() * (b < 2 ? -1 : 1);
                assertThat(beyond + 0.0).as(as).isBetween(0.0, cells.isAlongAxes() ? 0.0 : at.side * (columns + rows));
            }
        }
    }

    private static void extend(BigDecimal[] most, double[] square, Place at, boolean isAlongAxes) {
        BigDecimal cos = isAlongAxes ? BigDecimal.ONE : exact(at.cos);
        BigDecimal sin = isAlongAxes ? BigDecimal.ZERO : exact(at.sin);
        for (int corner = 0; corner < 4; corner++) {
            BigDecimal a = exact((corner & 1) == 0 ? -square[3] : square[3]);
            BigDecimal b = exact((corner & 2) == 0 ? -square[5] : square[5]);
            BigDecimal x = exact(square[0]).add(cos.multiply(a)).add(sin.multiply(b));
            BigDecimal z = exact(square[2]).subtract(sin.multiply(a)).add(cos.multiply(b));
            most[0] = most[0] == null ? x : most[0].min(x);
            most[1] = most[1] == null ? z : most[1].min(z);
            most[2] = most[2] == null ? x : most[2].max(x);
            most[3] = most[3] == null ? z : most[3].max(z);
        }
    }
}
