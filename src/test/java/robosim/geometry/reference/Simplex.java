package robosim.geometry.reference;

import java.math.BigInteger;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The simplex method in integers (Edmonds' pivots, Bland's rule), for questions about convex hulls of points: it knows
 * nothing about faces, edges or axes, and a flat hull is a hull like any other.
 */
final class Simplex {
    private final int rows;
    private final int columns;

    /** Rows of equations, then the cost of being infeasible, then the cost asked for; the right sides are last. */
    private final BigInteger[][] table;

    private final int[] basis;
    private BigInteger common = BigInteger.ONE;

    private Simplex(BigInteger[][] equations, int rows, int columns, int costly) {
        this.rows = rows;
        this.columns = columns;
        table = new BigInteger[rows + 2][columns + 1];
        basis = new int[rows];
        for (int c = 0; c <= columns; c++) {
            table[rows][c] = BigInteger.ZERO;
            table[rows + 1][c] = c == costly ? BigInteger.ONE : BigInteger.ZERO;
        }
        for (int r = 0; r < rows; r++) {
            basis[r] = columns + r; // an artificial variable, whose column is never needed again
            boolean negative = equations[r][columns].signum() < 0;
            for (int c = 0; c <= columns; c++) {
                table[r][c] = negative ? equations[r][c].negate() : equations[r][c];
                table[rows][c] = table[rows][c].subtract(table[r][c]);
            }
        }
    }

    /** Whether the hulls of two sets of points have a point in common. */
    static boolean meet(List<Rational[]> a, List<Rational[]> b) {
        int axes = a.get(0).length;
        int columns = a.size() + b.size();
        BigInteger[][] equations = empty(axes + 2, columns);
        for (int k = 0; k < a.size(); k++) {
            point(equations, k, a.get(k), axes, 1);
        }
        for (int k = 0; k < b.size(); k++) {
            point(equations, a.size() + k, b.get(k), axes + 1, -1);
        }
        equations[axes][columns] = BigInteger.ONE;
        equations[axes + 1][columns] = BigInteger.ONE;
        return new Simplex(equations, axes + 2, columns, -1).isFeasible();
    }

    /** The least t of at least 0 for which start + t direction lies in the hull of some points, or null. */
    static @Nullable Rational enter(Rational[] start, Rational[] direction, List<Rational[]> hull) {
        int axes = start.length;
        int columns = hull.size() + 1;
        BigInteger[][] equations = empty(axes + 1, columns);
        for (int k = 0; k < hull.size(); k++) {
            point(equations, k, hull.get(k), axes, 1);
        }
        for (int axis = 0; axis < axes; axis++) {
            // Each row by a factor of its own, so that start and direction are integers too.
            BigInteger factor = start[axis].denominator.multiply(direction[axis].denominator);
            for (int k = 0; k < hull.size(); k++) {
                equations[axis][k] = equations[axis][k].multiply(factor);
            }
            equations[axis][columns - 1] =
                    direction[axis].numerator.multiply(start[axis].denominator).negate();
            equations[axis][columns] = start[axis].numerator.multiply(direction[axis].denominator);
        }
        equations[axes][columns] = BigInteger.ONE;
        Simplex simplex = new Simplex(equations, axes + 1, columns, columns - 1);
        if (!simplex.isFeasible()) {
            return null;
        }
        simplex.dropArtificial();
        simplex.improve(simplex.rows + 1);
        return Rational.of(simplex.table[simplex.rows + 1][columns].negate(), simplex.common);
    }

    private static BigInteger[][] empty(int rows, int columns) {
        BigInteger[][] equations = new BigInteger[rows][columns + 1];
        for (BigInteger[] row : equations) {
            java.util.Arrays.fill(row, BigInteger.ZERO);
        }
        return equations;
    }

    /** A point in homogeneous integers: its weight is counted in a row of its own. */
    private static void point(BigInteger[][] equations, int column, Rational[] point, int weightRow, int sign) {
        BigInteger weight = BigInteger.ONE;
        for (Rational coordinate : point) {
            weight = coordinate.commonDenominator(weight);
        }
        for (int axis = 0; axis < point.length; axis++) {
            BigInteger whole = point[axis].timesWhole(weight);
            equations[axis][column] = sign < 0 ? whole.negate() : whole;
        }
        equations[weightRow][column] = weight;
    }

    private boolean isFeasible() {
        improve(rows);
        return table[rows][columns].signum() == 0;
    }

    private void improve(int cost) {
        while (true) {
            int entering = 0;
            while (entering < columns && table[cost][entering].signum() >= 0) {
                entering++;
            }
            if (entering == columns) {
                return;
            }
            int leaving = -1;
            for (int r = 0; r < rows; r++) {
                if (table[r][entering].signum() > 0 && (leaving < 0 || isTighter(r, leaving, entering))) {
                    leaving = r;
                }
            }
            if (leaving < 0) {
                throw new IllegalStateException("a cost of at least 0 must have a least value");
            }
            pivot(leaving, entering);
        }
    }

    private boolean isTighter(int r, int than, int entering) {
        int order = table[r][columns]
                .multiply(table[than][entering])
                .compareTo(table[than][columns].multiply(table[r][entering]));
        return order < 0 || (order == 0 && basis[r] < basis[than]);
    }

    private void dropArtificial() {
        for (int r = 0; r < rows; r++) {
            for (int c = 0; c < columns && basis[r] >= columns; c++) {
                int sign = table[r][c].signum();
                if (sign == 0) {
                    continue;
                }
                if (sign < 0) { // its right side is 0
                    for (int k = 0; k <= columns; k++) {
                        table[r][k] = table[r][k].negate();
                    }
                }
                pivot(r, c);
            }
        }
    }

    private void pivot(int row, int column) {
        BigInteger pivot = table[row][column];
        for (int r = 0; r < rows + 2; r++) {
            if (r != row) {
                BigInteger factor = table[r][column];
                for (int c = 0; c <= columns; c++) {
                    table[r][c] = table[r][c]
                            .multiply(pivot)
                            .subtract(factor.multiply(table[row][c]))
                            .divide(common);
                }
            }
        }
        common = pivot;
        basis[row] = column;
    }
}
