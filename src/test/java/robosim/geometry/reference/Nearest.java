package robosim.geometry.reference;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The square of the least distance between two hulls of points, exactly: the method of Gilbert, Johnson and Keerthi
 * (1988) in rational numbers, where it ends by itself and knows no tolerance.
 */
final class Nearest {
    private final List<Rational[]> a;
    private final List<Rational[]> b;

    Nearest(List<Rational[]> a, List<Rational[]> b) {
        this.a = a;
        this.b = b;
    }

    Rational square() {
        List<Rational[]> simplex = List.<Rational[]>of(Rational.minus(a.get(0), b.get(0)));
        Rational[] nearest = simplex.get(0);
        while (true) {
            Rational square = Rational.dot(nearest, nearest);
            if (square.signum() == 0) {
                return square;
            }
            Rational[] least = Rational.minus(least(a, nearest, 1), least(b, nearest, -1));
            if (Rational.dot(least, nearest).compareTo(square) >= 0) {
                return square;
            }
            List<Rational[]> simplexBefore = simplex;
            Rational shortest = null;
            // The new corner has a part in it: without it nothing was nearer.
            for (int subset = 0; subset < 1 << simplexBefore.size(); subset++) {
                List<Rational[]> corners = new ArrayList<>();
                corners.add(least);
                for (int k = 0; k < simplexBefore.size(); k++) {
                    if ((subset >> k & 1) == 1) {
                        corners.add(simplexBefore.get(k));
                    }
                }
                Rational[] foot = foot(corners);
                if (foot != null
                        && (shortest == null || Rational.dot(foot, foot).compareTo(shortest) < 0)) {
                    shortest = Rational.dot(foot, foot);
                    nearest = foot;
                    simplex = corners;
                }
            }
        }
    }

    private static Rational[] least(List<Rational[]> points, Rational[] along, int sign) {
        Rational[] best = points.get(0);
        for (Rational[] point : points) {
            if (sign * Rational.dot(point, along).compareTo(Rational.dot(best, along)) < 0) {
                best = point;
            }
        }
        return best;
    }

    /** The foot of the origin on the flat through some points, where that lies between them; else null. */
    private static Rational @Nullable [] foot(List<Rational[]> corners) {
        Rational[] first = corners.get(0);
        int n = corners.size() - 1;
        Rational[][] system = new Rational[n][n + 1];
        for (int i = 0; i < n; i++) {
            Rational[] edge = Rational.minus(corners.get(i + 1), first);
            for (int j = 0; j < n; j++) {
                system[i][j] = Rational.dot(edge, Rational.minus(corners.get(j + 1), first));
            }
            system[i][n] = Rational.dot(edge, first).negate();
        }
        if (!solve(system)) {
            return null;
        }
        Rational rest = Rational.of(1);
        Rational[] foot = first.clone();
        for (int i = 0; i < n; i++) {
            Rational share = system[i][n];
            if (share.signum() < 0) {
                return null;
            }
            rest = rest.minus(share);
            Rational[] edge = Rational.minus(corners.get(i + 1), first);
            for (int k = 0; k < foot.length; k++) {
                foot[k] = foot[k].plus(share.times(edge[k]));
            }
        }
        return rest.signum() < 0 ? null : foot;
    }

    /** Gauss and Jordan; false where the rows depend on each other. */
    private static boolean solve(Rational[][] system) {
        int n = system.length;
        for (int c = 0; c < n; c++) {
            int pivot = c;
            while (pivot < n && system[pivot][c].signum() == 0) {
                pivot++;
            }
            if (pivot == n) {
                return false;
            }
            Rational[] row = system[pivot];
            system[pivot] = system[c];
            system[c] = row;
            for (int k = n; k >= c; k--) {
                row[k] = row[k].over(row[c]);
            }
            for (int r = 0; r < n; r++) {
                Rational factor = system[r][c];
                for (int k = c; k <= n && r != c; k++) {
                    system[r][k] = system[r][k].minus(factor.times(row[k]));
                }
            }
        }
        return true;
    }
}
