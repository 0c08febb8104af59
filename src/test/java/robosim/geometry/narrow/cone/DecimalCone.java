package robosim.geometry.narrow.cone;

import static robosim.geometry.reference.Decimals.cross;
import static robosim.geometry.reference.Decimals.minus;
import static robosim.geometry.reference.Decimals.plus;
import static robosim.geometry.reference.Decimals.vector;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** The nearest point of a triangle in a cone, by all places where it can be, in decimals of so many digits that none matters. */
final class DecimalCone {
    private static final MathContext DIGITS = new MathContext(70, RoundingMode.HALF_EVEN);

    /** What holds the nearest point: corners, edges, or the face; null if nothing is in the cone. */
    String feature;

    private final BigDecimal[] u;
    private final BigDecimal cos;
    private final BigDecimal sin;
    private BigDecimal least;

    DecimalCone(double[] way, double cosine) {
        BigDecimal[] d = vector(way);
        u = times(d, BigDecimal.ONE.divide(root(dot(d, d)), DIGITS));
        cos = new BigDecimal(cosine);
        sin = root(BigDecimal.ONE.subtract(cos.multiply(cos)));
    }

    /** The distance of a triangle, nine numbers, from an apex; infinite if nothing is in the cone. */
    double distance(double[] corners, double[] apex) {
        BigDecimal[][] v = new BigDecimal[3][3];
        for (int k = 0; k < 9; k++) {
            v[k / 3][k % 3] = new BigDecimal(corners[k]).subtract(new BigDecimal(apex[k % 3]));
        }
        for (int k = 0; k < 3; k++) {
            edge(v[k], v[(k + 1) % 3]);
        }
        face(v);
        return feature == null ? Double.POSITIVE_INFINITY : least.doubleValue();
    }

    private void edge(BigDecimal[] p, BigDecimal[] q) {
        take(p, "corner");
        BigDecimal[] e = minus(q, p);
        BigDecimal ee = dot(e, e);
        if (ee.signum() == 0) {
            return;
        }
        at(p, e, dot(p, e).negate().divide(ee, DIGITS), "edge");
        BigDecimal square = cos.multiply(cos);
        BigDecimal a = dot(e, u).pow(2).subtract(square.multiply(ee));
        BigDecimal b = dot(p, u).multiply(dot(e, u)).subtract(square.multiply(dot(p, e)));
        BigDecimal c = dot(p, u).pow(2).subtract(square.multiply(dot(p, p)));
        BigDecimal under = b.multiply(b).subtract(a.multiply(c));
        if (under.signum() < 0 || a.signum() == 0) {
            return;
        }
        for (int sign = -1; sign <= 1; sign += 2) {
            BigDecimal t =
                    root(under).multiply(BigDecimal.valueOf(sign)).subtract(b).divide(a, DIGITS);
            if (t.signum() >= 0 && t.compareTo(BigDecimal.ONE) <= 0) {
                BigDecimal[] x = plus(p, times(e, t));
                if (dot(x, u).signum() >= 0) {
                    keep(x, "border of an edge");
                }
            }
        }
    }

    private void at(BigDecimal[] p, BigDecimal[] e, BigDecimal t, String where) {
        if (t.signum() > 0 && t.compareTo(BigDecimal.ONE) < 0) {
            take(plus(p, times(e, t)), where);
        }
    }

    private void face(BigDecimal[][] v) {
        BigDecimal[] normal = cross(minus(v[1], v[0]), minus(v[2], v[0]));
        BigDecimal height = dot(normal, v[0]);
        if (height.signum() == 0 || dot(normal, normal).signum() == 0) {
            return;
        }
        BigDecimal[] n = times(normal, BigDecimal.valueOf(height.signum()).divide(root(dot(normal, normal)), DIGITS));
        BigDecimal ahead = dot(n, u);
        BigDecimal[] way = n;
        if (ahead.compareTo(cos) < 0) {
            BigDecimal[] aside = minus(n, times(u, ahead));
            way = plus(times(u, cos), times(aside, sin.divide(root(dot(aside, aside)), DIGITS)));
        }
        BigDecimal rate = dot(n, way);
        if (rate.signum() <= 0) {
            return;
        }
        BigDecimal[] x = times(way, dot(n, v[0]).divide(rate, DIGITS));
        for (int k = 0; k < 3; k++) {
            if (dot(cross(minus(v[(k + 1) % 3], v[k]), minus(x, v[k])), normal).signum() < 0) {
                return;
            }
        }
        keep(x, "face");
    }

    private void take(BigDecimal[] x, String where) {
        BigDecimal ahead = dot(x, u);
        if (ahead.signum() >= 0 && ahead.pow(2).compareTo(cos.pow(2).multiply(dot(x, x))) >= 0) {
            keep(x, where);
        }
    }

    private void keep(BigDecimal[] x, String where) {
        BigDecimal length = root(dot(x, x));
        if (feature == null || length.compareTo(least) < 0) {
            least = length;
            feature = where;
        }
    }

    private static BigDecimal root(BigDecimal square) {
        return square.signum() <= 0 ? BigDecimal.ZERO : square.sqrt(DIGITS);
    }

    private static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0])
                .add(a[1].multiply(b[1]))
                .add(a[2].multiply(b[2]))
                .round(DIGITS);
    }

    private static BigDecimal[] times(BigDecimal[] a, BigDecimal t) {
        return new BigDecimal[] {a[0].multiply(t, DIGITS), a[1].multiply(t, DIGITS), a[2].multiply(t, DIGITS)};
    }
}
