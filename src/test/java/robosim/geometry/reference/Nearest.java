package robosim.geometry.reference;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The square of the least distance between two hulls of points, exactly: the method of Gilbert, Johnson and Keerthi
 * (1988) in whole numbers, where it ends by itself and knows no tolerance. All points are multiplied by one number that
 * makes them whole; a point between them is whole coordinates over a weight.
 */
final class Nearest {
    private final BigInteger scale;
    private final List<BigInteger[]> a;
    private final List<BigInteger[]> b;

    Nearest(List<Rational[]> a, List<Rational[]> b) {
        BigInteger common = BigInteger.ONE;
        for (List<Rational[]> points : List.of(a, b)) {
            for (Rational[] point : points) {
                for (Rational coordinate : point) {
                    common = coordinate.commonDenominator(common);
                }
            }
        }
        this.scale = common;
        this.a = whole(a, common);
        this.b = whole(b, common);
    }

    private static List<BigInteger[]> whole(List<Rational[]> points, BigInteger scale) {
        List<BigInteger[]> whole = new ArrayList<>();
        for (Rational[] point : points) {
            BigInteger[] scaled = new BigInteger[point.length];
            for (int k = 0; k < scaled.length; k++) {
                scaled[k] = point[k].timesWhole(scale);
            }
            whole.add(scaled);
        }
        return whole;
    }

    Rational square() {
        Foot nearest = nearest();
        return Rational.of(nearest.square, nearest.weight.multiply(scale).pow(2));
    }

    /** The vector from the nearest point of b to that of a. */
    Rational[] vector() {
        Foot nearest = nearest();
        Rational[] vector = new Rational[nearest.over.length];
        for (int k = 0; k < vector.length; k++) {
            vector[k] = Rational.of(nearest.over[k], nearest.weight.multiply(scale));
        }
        return vector;
    }

    private Foot nearest() {
        List<BigInteger[]> simplex = List.<BigInteger[]>of(minus(a.get(0), b.get(0)));
        Foot nearest = new Foot(simplex.get(0), BigInteger.ONE);
        while (true) {
            BigInteger[] least = minus(least(a, nearest.over, 1), least(b, nearest.over, -1));
            // Both sides times the square of the weight.
            if (nearest.square.signum() == 0
                    || dot(least, nearest.over).multiply(nearest.weight).compareTo(nearest.square) >= 0) {
                return nearest;
            }
            List<BigInteger[]> simplexBefore = simplex;
            Foot shortest = null;
            // The new corner has a part in it: without it nothing was nearer.
            for (int subset = 0; subset < 1 << simplexBefore.size(); subset++) {
                List<BigInteger[]> corners = new ArrayList<>();
                corners.add(least);
                for (int k = 0; k < simplexBefore.size(); k++) {
                    if ((subset >> k & 1) == 1) {
                        corners.add(simplexBefore.get(k));
                    }
                }
                Foot foot = foot(corners);
                if (foot != null && (shortest == null || foot.isShorterThan(shortest))) {
                    shortest = foot;
                    simplex = corners;
                }
            }
            if (shortest == null) {
                throw new AssertionError("the new corner alone has a foot");
            }
            nearest = shortest;
        }
    }

    /** A point as a vector from the origin: whole numbers over a positive weight, and the square of those numbers. */
    private static final class Foot {
        final BigInteger[] over;
        final BigInteger weight;
        final BigInteger square;

        Foot(BigInteger[] over, BigInteger weight) {
            BigInteger common = weight;
            for (BigInteger coordinate : over) {
                common = common.gcd(coordinate);
            }
            this.over = over.clone();
            for (int k = 0; k < over.length; k++) {
                this.over[k] = over[k].divide(common);
            }
            this.weight = weight.divide(common);
            this.square = dot(this.over, this.over);
        }

        boolean isShorterThan(Foot that) {
            return square.multiply(that.weight.pow(2)).compareTo(that.square.multiply(weight.pow(2))) < 0;
        }
    }

    private static BigInteger[] least(List<BigInteger[]> points, BigInteger[] along, int sign) {
        BigInteger[] best = points.get(0);
        BigInteger reach = dot(best, along);
        for (BigInteger[] point : points) {
            BigInteger other = dot(point, along);
            if (sign * other.compareTo(reach) < 0) {
                best = point;
                reach = other;
            }
        }
        return best;
    }

    /** The foot of the origin on the flat through some points, where that lies between them; else null. */
    private static @Nullable Foot foot(List<BigInteger[]> corners) {
        BigInteger[] first = corners.get(0);
        int n = corners.size() - 1;
        BigInteger[][] edges = new BigInteger[n][];
        for (int i = 0; i < n; i++) {
            edges[i] = minus(corners.get(i + 1), first);
        }
        // Where the foot is first + sum of share * edge, it is at right angles to each edge. By Cramer's rule.
        BigInteger[][] products = new BigInteger[n][n];
        BigInteger[] right = new BigInteger[n];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                products[i][j] = dot(edges[i], edges[j]);
            }
            right[i] = dot(edges[i], first).negate();
        }
        // Gram's determinant: 0 where the edges depend on each other, else positive.
        BigInteger weight = determinant(products);
        if (weight.signum() == 0) {
            return null;
        }
        BigInteger rest = weight;
        BigInteger[] over = new BigInteger[first.length];
        for (int k = 0; k < over.length; k++) {
            over[k] = first[k].multiply(weight);
        }
        for (int i = 0; i < n; i++) {
            BigInteger share = determinant(withColumn(products, i, right));
            if (share.signum() < 0) {
                return null;
            }
            rest = rest.subtract(share);
            for (int k = 0; k < over.length; k++) {
                over[k] = over[k].add(share.multiply(edges[i][k]));
            }
        }
        return rest.signum() < 0 ? null : new Foot(over, weight);
    }

    private static BigInteger[][] withColumn(BigInteger[][] matrix, int column, BigInteger[] numbers) {
        BigInteger[][] changed = new BigInteger[matrix.length][];
        for (int i = 0; i < matrix.length; i++) {
            changed[i] = matrix[i].clone();
            changed[i][column] = numbers[i];
        }
        return changed;
    }

    /** Of at most three rows. */
    private static BigInteger determinant(BigInteger[][] m) {
        switch (m.length) {
            case 0:
                return BigInteger.ONE;
            case 1:
                return m[0][0];
            case 2:
                return minor(m, 0, 1, 0, 1);
            case 3:
                return m[0][0].multiply(minor(m, 1, 2, 1, 2))
                        .subtract(m[0][1].multiply(minor(m, 1, 2, 0, 2)))
                        .add(m[0][2].multiply(minor(m, 1, 2, 0, 1)));
            default:
                // Four edges in three dimensions depend on each other.
                return BigInteger.ZERO;
        }
    }

    private static BigInteger minor(BigInteger[][] m, int row, int below, int column, int beside) {
        return m[row][column].multiply(m[below][beside]).subtract(m[row][beside].multiply(m[below][column]));
    }

    private static BigInteger dot(BigInteger[] u, BigInteger[] v) {
        BigInteger sum = BigInteger.ZERO;
        for (int k = 0; k < u.length; k++) {
            sum = sum.add(u[k].multiply(v[k]));
        }
        return sum;
    }

    private static BigInteger[] minus(BigInteger[] u, BigInteger[] v) {
        BigInteger[] difference = new BigInteger[u.length];
        for (int k = 0; k < u.length; k++) {
            difference[k] = u[k].subtract(v[k]);
        }
        return difference;
    }
}
