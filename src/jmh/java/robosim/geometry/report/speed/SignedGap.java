package robosim.geometry.report.speed;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.reference.DecimalRoot;

/**
 * The true distance of two convex outlines in the plane, and below 0 how deep they overlap: the least way that takes them
 * apart. Corners are exact decimals, so that the sign is that of the stored numbers; the size is at 60 digits.
 */
final class SignedGap {
    private static final MathContext DIGITS = new MathContext(60);

    private SignedGap() {}

    /** The hull of corners, swollen by a radius. */
    record Shape(List<BigDecimal[]> corners, BigDecimal radius) {}

    static BigDecimal between(Shape a, Shape b) {
        List<BigDecimal[]> differences = new ArrayList<>();
        for (BigDecimal[] p : a.corners) {
            for (BigDecimal[] q : b.corners) {
                differences.add(new BigDecimal[] {q[0].subtract(p[0]), q[1].subtract(p[1])});
            }
        }
        return origin(hull(differences)).subtract(a.radius).subtract(b.radius);
    }

    /** How far the origin is from a hull, below 0 inside. */
    private static BigDecimal origin(List<BigDecimal[]> hull) {
        BigDecimal nearest = null;
        boolean isInside = hull.size() > 2;
        for (int k = 0; k < hull.size(); k++) {
            BigDecimal[] p = hull.get(k);
            BigDecimal[] q = hull.get((k + 1) % hull.size());
            isInside &= cross(p, q).signum() >= 0;
            BigDecimal square = squareToSegment(p, q);
            nearest = nearest == null || square.compareTo(nearest) < 0 ? square : nearest;
        }
        if (nearest == null) {
            throw new IllegalArgumentException("a shape must have corners (got: none)");
        }
        BigDecimal distance = DecimalRoot.of(nearest, DIGITS);
        return isInside ? distance.negate() : distance;
    }

    private static BigDecimal squareToSegment(BigDecimal[] p, BigDecimal[] q) {
        BigDecimal[] e = {q[0].subtract(p[0]), q[1].subtract(p[1])};
        BigDecimal length = dot(e, e);
        BigDecimal along = dot(p, e).negate();
        if (along.signum() <= 0 || length.signum() == 0) {
            return dot(p, p);
        }
        if (along.compareTo(length) >= 0) {
            return dot(q, q);
        }
        BigDecimal across = cross(p, e);
        return across.multiply(across).divide(length, DIGITS);
    }

    /** Counter-clockwise and without corners on edges: Andrew's chain. */
    private static List<BigDecimal[]> hull(List<BigDecimal[]> points) {
        List<BigDecimal[]> sorted = new ArrayList<>(points);
        sorted.sort((p, q) -> p[0].compareTo(q[0]) != 0 ? p[0].compareTo(q[0]) : p[1].compareTo(q[1]));
        List<BigDecimal[]> hull = new ArrayList<>();
        for (int side = 0; side < 2; side++) {
            int begin = hull.size();
            for (int k = 0; k < sorted.size(); k++) {
                BigDecimal[] p = sorted.get(side == 0 ? k : sorted.size() - 1 - k);
                while (hull.size() > begin + 1 && turn(hull, p) <= 0) {
                    hull.remove(hull.size() - 1);
                }
                hull.add(p);
            }
            hull.remove(hull.size() - 1);
        }
        return hull.isEmpty() ? List.<BigDecimal[]>of(sorted.get(0)) : hull;
    }

    private static int turn(List<BigDecimal[]> chain, BigDecimal[] p) {
        BigDecimal[] a = chain.get(chain.size() - 2);
        BigDecimal[] b = chain.get(chain.size() - 1);
        return cross(
                        new BigDecimal[] {b[0].subtract(a[0]), b[1].subtract(a[1])},
                        new BigDecimal[] {p[0].subtract(a[0]), p[1].subtract(a[1])})
                .signum();
    }

    static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1]));
    }

    private static BigDecimal cross(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[1]).subtract(a[1].multiply(b[0]));
    }
}
