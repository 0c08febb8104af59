package robosim.geometry.narrow;

import static robosim.geometry.reference.Decimals.cross;
import static robosim.geometry.reference.Decimals.dot;
import static robosim.geometry.reference.Decimals.minus;
import static robosim.geometry.reference.Decimals.plus;
import static robosim.geometry.reference.Decimals.times;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.DecimalRoot;

/**
 * The slow twin of the spatial rays, in decimals of any length: a box is its twelve triangles and its inside, a
 * cylinder the roots of its quadratic to 120 digits. Shares no code and no formula with the kernels.
 */
public final class RayOracle {
    public static final MathContext DIGITS = new MathContext(120);
    private static final BigDecimal TIE = new BigDecimal(BigInteger.ONE, 90);

    private RayOracle() {}

    /** The distance, or null on a miss. */
    public static BigDecimal distance(double[] o, double[] d, LeafKind kind, double[] row) {
        BigDecimal t = switch (kind) {
            case SPHERE -> sphere(minus(vector(o), vector(row, 0, 1)), vector(d), row[3]);
            case UPRIGHT_BOX, BOX -> box(o, d, row);
            case TRIANGLE -> triangle(vector(o), vector(d), vector(row, 0, 1), vector(row, 3, 1), vector(row, 6, 1));
            case UPRIGHT_CYLINDER -> cylinder(o, d, row, vector(new double[] {0, 1, 0}));
            case CYLINDER -> cylinder(o, d, row, vector(row, 7, 3));
            case UPRIGHT_CAPSULE -> capsule(o, d, row, vector(new double[] {0, 1, 0}));
            case CAPSULE -> capsule(o, d, row, vector(row, 7, 3));
            case PRISM -> prism(o, d, row);
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
        return t == null ? null : t.multiply(DecimalRoot.of(dot(vector(d), vector(d)), DIGITS), DIGITS);
    }

    /** The first of the cylinder about the segment and of the spheres about its ends. */
    private static @Nullable BigDecimal capsule(double[] o, double[] d, double[] row, BigDecimal[] a) {
        BigDecimal least = cylinder(o, d, row, a);
        for (int side = -1; side <= 1; side += 2) {
            BigDecimal[] end = plus(vector(row, 0, 1), times(a, big(side * row[4])));
            BigDecimal there = sphere(minus(vector(o), end), vector(d), row[3]);
            least = least == null ? there : there == null ? least : least.min(there);
        }
        return least;
    }

    private static @Nullable BigDecimal sphere(BigDecimal[] m, BigDecimal[] u, double radius) {
        BigDecimal a = dot(u, u);
        BigDecimal b = dot(m, u);
        BigDecimal c = dot(m, m).subtract(big(radius).pow(2));
        if (c.signum() <= 0) {
            return BigDecimal.ZERO;
        }
        BigDecimal quarter = b.multiply(b).subtract(a.multiply(c));
        if (quarter.signum() < 0 || b.signum() >= 0) {
            return null;
        }
        return b.negate().subtract(root(quarter)).divide(a, DIGITS);
    }

    private static BigDecimal cylinder(double[] o, double[] d, double[] row, BigDecimal[] a) {
        BigDecimal[] m = minus(vector(o), vector(row, 0, 1));
        BigDecimal[] u = vector(d);
        BigDecimal aa = dot(a, a);
        BigDecimal from = BigDecimal.ZERO;
        BigDecimal to = null;
        BigDecimal scale = BigDecimal.ZERO;
        BigDecimal slope = dot(u, a);
        BigDecimal half = big(row[4]).multiply(aa);
        BigDecimal along = dot(m, a);
        if (slope.signum() == 0) {
            if (along.abs().compareTo(half) > 0) {
                return null;
            }
        } else {
            BigDecimal t1 = half.negate().subtract(along).divide(slope, DIGITS);
            BigDecimal t2 = half.subtract(along).divide(slope, DIGITS);
            from = from.max(t1.min(t2));
            to = t1.max(t2);
            scale = t1.abs().add(t2.abs());
        }
        // Across the axis: |v|^2 - (v.a)^2 / a.a, times a.a.
        BigDecimal qa = aa.multiply(dot(u, u)).subtract(slope.pow(2));
        BigDecimal qb = aa.multiply(dot(m, u)).subtract(slope.multiply(along));
        BigDecimal qc = aa.multiply(dot(m, m))
                .subtract(along.pow(2))
                .subtract(aa.multiply(big(row[3]).pow(2)));
        if (qa.signum() == 0) {
            if (qc.signum() > 0) {
                return null;
            }
        } else {
            BigDecimal quarter = qb.pow(2).subtract(qa.multiply(qc));
            if (quarter.signum() < 0) {
                return null;
            }
            BigDecimal t1 = qb.negate().subtract(root(quarter)).divide(qa, DIGITS);
            BigDecimal t2 = qb.negate().add(root(quarter)).divide(qa, DIGITS);
            from = from.max(t1);
            to = to == null ? t2 : to.min(t2);
            scale = scale.add(t1.abs()).add(t2.abs());
        }
        return from.subtract(to).compareTo(TIE.multiply(scale)) > 0 ? null : from;
    }

    private static BigDecimal box(double[] o, double[] d, double[] row) {
        BigDecimal[] c = vector(row, 0, 1);
        BigDecimal[][] half = new BigDecimal[3][];
        for (int i = 0; i < 3; i++) {
            half[i] = times(vector(row, 6 + i, 3), big(row[3 + i]));
        }
        if (insideBox(minus(vector(o), c), row)) {
            return BigDecimal.ZERO;
        }
        BigDecimal least = null;
        for (int i = 0; i < 3; i++) {
            BigDecimal[] e = half[(i + 1) % 3];
            BigDecimal[] f = half[(i + 2) % 3];
            for (int side = -1; side <= 1; side += 2) {
                BigDecimal[] face = plus(c, times(half[i], BigDecimal.valueOf(side)));
                BigDecimal[] p = minus(minus(face, e), f);
                BigDecimal[] q = minus(plus(face, e), f);
                BigDecimal[] r = plus(plus(face, e), f);
                BigDecimal[] s = plus(minus(face, e), f);
                least = least(least, triangle(vector(o), vector(d), p, q, r));
                least = least(least, triangle(vector(o), vector(d), p, r, s));
            }
        }
        return least;
    }

    private static boolean insideBox(BigDecimal[] p, double[] row) {
        BigDecimal[] x = vector(row, 6, 3);
        BigDecimal[] y = vector(row, 7, 3);
        BigDecimal[] z = vector(row, 8, 3);
        BigDecimal det = det(x, y, z).abs();
        return det(p, y, z).abs().compareTo(det.multiply(big(row[3]))) <= 0
                && det(x, p, z).abs().compareTo(det.multiply(big(row[4]))) <= 0
                && det(x, y, p).abs().compareTo(det.multiply(big(row[5]))) <= 0;
    }

    private static BigDecimal prism(double[] o, double[] d, double[] row) {
        BigDecimal[] m = vector(o);
        BigDecimal[] u = vector(d);
        BigDecimal[] at = {m[0], m[2], m[0].add(m[2]), m[0].subtract(m[2]), m[1]};
        BigDecimal[] by = {u[0], u[2], u[0].add(u[2]), u[0].subtract(u[2]), u[1]};
        BigDecimal from = BigDecimal.ZERO;
        BigDecimal to = null;
        for (int i = 0; i < 5; i++) {
            BigDecimal low = big(row[2 * i]).subtract(at[i]);
            BigDecimal high = big(row[2 * i + 1]).subtract(at[i]);
            if (by[i].signum() == 0) {
                if (low.signum() > 0 || high.signum() < 0) {
                    return null;
                }
                continue;
            }
            BigDecimal t1 = low.divide(by[i], DIGITS);
            BigDecimal t2 = high.divide(by[i], DIGITS);
            from = from.max(t1.min(t2));
            to = to == null ? t1.max(t2) : to.min(t1.max(t2));
        }
        BigDecimal scale = from.abs().add(to.abs());
        return from.subtract(to).compareTo(TIE.multiply(scale)) > 0 ? null : from;
    }

    /** The parameter at which a ray meets a triangle, a segment or a point; null on a miss. */
    static BigDecimal triangle(BigDecimal[] o, BigDecimal[] d, BigDecimal[] a, BigDecimal[] b, BigDecimal[] c) {
        BigDecimal[] e = minus(b, a);
        BigDecimal[] f = minus(c, a);
        BigDecimal[] m = minus(o, a);
        // o + t d = a + v e + w f by Cramer's rule.
        BigDecimal det = det(e, f, d);
        if (det.signum() != 0) {
            int sign = det.signum();
            BigDecimal v = det(m, f, d);
            BigDecimal w = det(e, m, d);
            BigDecimal t = det(e, f, m).negate();
            boolean inside = v.signum() * sign >= 0
                    && w.signum() * sign >= 0
                    && v.add(w).abs().compareTo(det.abs()) <= 0
                    && t.signum() * sign >= 0;
            return inside ? t.divide(det, DIGITS) : null;
        }
        BigDecimal[] n = cross(e, f);
        if (!isZero(n)) {
            if (dot(n, m).signum() != 0) {
                return null;
            }
            // The start inside, in the plane: three areas of one sign.
            int s1 = dot(n, cross(e, m)).signum();
            int s2 = dot(n, cross(minus(c, b), minus(o, b))).signum();
            int s3 = dot(n, cross(minus(a, c), minus(o, c))).signum();
            if (s1 >= 0 && s2 >= 0 && s3 >= 0) {
                return BigDecimal.ZERO;
            }
        }
        return least(least(segment(o, d, a, b), segment(o, d, b, c)), segment(o, d, c, a));
    }

    private static BigDecimal segment(BigDecimal[] o, BigDecimal[] d, BigDecimal[] a, BigDecimal[] b) {
        BigDecimal[] e = minus(b, a);
        BigDecimal[] m = minus(a, o);
        BigDecimal dd = dot(d, d);
        BigDecimal ee = dot(e, e);
        BigDecimal de = dot(d, e);
        BigDecimal det = dd.multiply(ee).subtract(de.pow(2));
        if (det.signum() == 0) {
            if (!isZero(cross(m, d)) || !isZero(cross(minus(b, o), d))) {
                return null;
            }
            BigDecimal p = dot(m, d).divide(dd, DIGITS);
            BigDecimal q = dot(minus(b, o), d).divide(dd, DIGITS);
            return p.max(q).signum() < 0 ? null : p.min(q).max(BigDecimal.ZERO);
        }
        // The normal equations; then the two points must be one.
        BigDecimal t = dot(m, d).multiply(ee).subtract(dot(m, e).multiply(de));
        BigDecimal s = dot(m, d).multiply(de).subtract(dot(m, e).multiply(dd));
        BigDecimal[] gap = minus(plus(times(m, det), times(e, s)), times(d, t));
        boolean met = isZero(gap) && t.signum() >= 0 && s.signum() >= 0 && s.compareTo(det) <= 0;
        return met ? t.divide(det, DIGITS) : null;
    }

    static BigDecimal big(double value) {
        return new BigDecimal(value);
    }

    private static BigDecimal root(BigDecimal square) {
        return square.signum() == 0 ? BigDecimal.ZERO : DecimalRoot.of(square, DIGITS);
    }

    private static BigDecimal least(BigDecimal a, BigDecimal b) {
        return a == null ? b : b == null ? a : a.min(b);
    }

    private static BigDecimal[] vector(double[] v) {
        return vector(v, 0, 1);
    }

    private static BigDecimal[] vector(double[] v, int at, int step) {
        return new BigDecimal[] {big(v[at]), big(v[at + step]), big(v[at + 2 * step])};
    }

    private static BigDecimal det(BigDecimal[] a, BigDecimal[] b, BigDecimal[] c) {
        return dot(a, cross(b, c));
    }

    private static boolean isZero(BigDecimal[] a) {
        return a[0].signum() == 0 && a[1].signum() == 0 && a[2].signum() == 0;
    }
}
