package robosim.geometry.proof;

import java.util.Arrays;

/**
 * The widest gap between a piece and what a course sweeps, by the algorithm of Gilbert, Johnson and Keerthi (1988) on plain doubles:
 * for sets that the kernels have no leaf for. What it finds is a candidate.
 */
final class GapSearch {
    private static final int MOST_STEPS = 60;

    private final double[][] points = new double[4][3];
    private final double[] weights = new double[4];
    private final double[] best = new double[4];
    private final double[] v = new double[3];
    private int count;

    /** Writes a direction from the course's piece towards the other one; whether there is a gap. */
    boolean find(Course course, int i, double from, double to, double[] row, double[] n) {
        count = 0;
        double[] mine = new double[3];
        double[] theirs = new double[3];
        double[] back = new double[3];
        double widest = Double.NEGATIVE_INFINITY;
        double[] direction = start(course, i, row);
        for (int step = 0; step < MOST_STEPS; step++) {
            double[] unit = Rows.unit(direction);
            course.support(i, unit, from, to, mine);
            for (int k = 0; k < 3; k++) {
                back[k] = -unit[k];
            }
            Rows.support(row, back, theirs);
            double[] w = {theirs[0] - mine[0], theirs[1] - mine[1], theirs[2] - mine[2]};
            double gap = Rows.product(unit, w);
            if (gap > widest) {
                widest = gap;
                System.arraycopy(unit, 0, n, 0, 3);
            }
            double length = Rows.length(direction);
            if (step > 0 && length - gap <= 1e-13 * length) {
                break;
            }
            if (!add(w)) {
                break;
            }
            nearest();
            System.arraycopy(v, 0, direction, 0, 3);
            if (count == 4 || Rows.length(direction) == 0) {
                break; // the origin is inside
            }
        }
        return widest > 0;
    }

    private static double[] start(Course course, int i, double[] row) {
        double[] d = {row[0] - course.rows[i][0], row[1] - course.rows[i][1], row[2] - course.rows[i][2]};
        return d[0] == 0 && d[1] == 0 && d[2] == 0 ? new double[] {1, 0, 0} : d;
    }

    private boolean add(double[] w) {
        for (int k = 0; k < count; k++) {
            if (points[k][0] == w[0] && points[k][1] == w[1] && points[k][2] == w[2]) {
                return false;
            }
        }
        System.arraycopy(w, 0, points[count++], 0, 3);
        return true;
    }

    /** Reduces the points to those whose hull has the point v nearest to the origin. */
    private void nearest() {
        double least = Double.POSITIVE_INFINITY;
        int chosen = 0;
        for (int set = 1; set < (1 << count); set++) {
            if (solve(set)) {
                double x = 0;
                double y = 0;
                double z = 0;
                for (int k = 0; k < count; k++) {
                    x += weights[k] * points[k][0];
                    y += weights[k] * points[k][1];
                    z += weights[k] * points[k][2];
                }
                double square = x * x + y * y + z * z;
                if (square < least) {
                    least = square;
                    chosen = set;
                    v[0] = x;
                    v[1] = y;
                    v[2] = z;
                    System.arraycopy(weights, 0, best, 0, 4);
                }
            }
        }
        int kept = 0;
        for (int k = 0; k < count; k++) {
            if (((chosen >> k) & 1) == 1) {
                double[] swap = points[kept];
                points[kept++] = points[k];
                points[k] = swap;
            }
        }
        count = kept;
    }

    /** Weights of the point nearest to the origin of the plane through some points; whether all are positive. */
    private boolean solve(int set) {
        Arrays.fill(weights, 0);
        int base = Integer.numberOfTrailingZeros(set);
        int size = Integer.bitCount(set) - 1;
        double[][] m = new double[3][4];
        int[] which = new int[3];
        int row = 0;
        for (int k = base + 1; k < count; k++) {
            if (((set >> k) & 1) == 1) {
                which[row++] = k;
            }
        }
        for (int a = 0; a < size; a++) {
            for (int b = 0; b < size; b++) {
                m[a][b] = edge(which[a], base, which[b], base);
            }
            m[a][3] = 0;
            for (int axis = 0; axis < 3; axis++) {
                m[a][3] -= (points[which[a]][axis] - points[base][axis]) * points[base][axis];
            }
        }
        if (!eliminate(m, size)) {
            return false;
        }
        double rest = 1;
        for (int a = 0; a < size; a++) {
            weights[which[a]] = m[a][3];
            rest -= m[a][3];
            if (!(m[a][3] > 0)) {
                return false;
            }
        }
        weights[base] = rest;
        return rest > 0;
    }

    private double edge(int a, int b, int c, int d) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            sum += (points[a][axis] - points[b][axis]) * (points[c][axis] - points[d][axis]);
        }
        return sum;
    }

    private static boolean eliminate(double[][] m, int size) {
        for (int k = 0; k < size; k++) {
            int pivot = k;
            for (int r = k + 1; r < size; r++) {
                pivot = Math.abs(m[r][k]) > Math.abs(m[pivot][k]) ? r : pivot;
            }
            double[] swap = m[k];
            m[k] = m[pivot];
            m[pivot] = swap;
            if (m[k][k] == 0) {
                return false;
            }
            for (int r = 0; r < size; r++) {
                if (r != k) {
                    double factor = m[r][k] / m[k][k];
                    for (int c = 0; c < 4; c++) {
                        m[r][c] -= factor * m[k][c];
                    }
                }
            }
        }
        for (int k = 0; k < size; k++) {
            m[k][3] /= m[k][k];
        }
        return true;
    }
}
