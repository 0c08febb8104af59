package robosim.geometry.narrow;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.DecimalRoot;

/**
 * The slow twin of the planar kernels: decimal numbers that hold every double, hulls, and segments that cross; no
 * separating axes, no filters, nothing of the product but the layout of a row.
 */
public final class PlanarReference {
    private static final MathContext DIGITS = new MathContext(80);

    public record Place(BigDecimal x, BigDecimal z) {
        Place minus(Place other) {
            return new Place(x.subtract(other.x), z.subtract(other.z));
        }

        BigDecimal cross(Place other) {
            return x.multiply(other.z).subtract(z.multiply(other.x));
        }

        BigDecimal dot(Place other) {
            return x.multiply(other.x).add(z.multiply(other.z));
        }
    }

    /** A hull (in order, one corner or more) grown by a radius. */
    public record Shape(List<Place> hull, BigDecimal radius) {}

    private PlanarReference() {}

    public static Place place(double x, double z) {
        return new Place(new BigDecimal(x), new BigDecimal(z));
    }

    public static Shape of(LeafKind kind, double[] row, int at) {
        List<Place> corners = new ArrayList<>();
        BigDecimal radius = BigDecimal.ZERO;
        if (kind == LeafKind.TRIANGLE) {
            for (int k = 0; k < 9; k += 3) {
                corners.add(place(row[at + k], row[at + k + 2]));
            }
        } else {
            corners.add(place(row[at], row[at + 2]));
            if (kind == LeafKind.SPHERE || kind == LeafKind.UPRIGHT_CYLINDER) {
                radius = new BigDecimal(row[at + 3]);
            } else {
                for (int axis = 0; axis < 3; axis++) {
                    BigDecimal half = new BigDecimal(row[at + 3 + axis]);
                    BigDecimal gx = half.multiply(new BigDecimal(row[at + 6 + axis]));
                    BigDecimal gz = half.multiply(new BigDecimal(row[at + 12 + axis]));
                    List<Place> more = new ArrayList<>();
                    for (Place c : corners) {
                        more.add(new Place(c.x.add(gx), c.z.add(gz)));
                        more.add(new Place(c.x.subtract(gx), c.z.subtract(gz)));
                    }
                    corners = more;
                }
            }
        }
        return new Shape(hull(corners), radius);
    }

    // Gift wrapping.
    private static List<Place> hull(List<Place> corners) {
        Place start = corners.get(0);
        for (Place c : corners) {
            int byX = c.x.compareTo(start.x);
            if (byX < 0 || (byX == 0 && c.z.compareTo(start.z) < 0)) {
                start = c;
            }
        }
        List<Place> hull = new ArrayList<>();
        Place here = start;
        do {
            hull.add(here);
            Place next = here;
            for (Place c : corners) {
                if (same(c, here)) {
                    continue;
                }
                if (same(next, here)) {
                    next = c;
                    continue;
                }
                Place to = next.minus(here);
                Place other = c.minus(here);
                int turn = to.cross(other).signum();
                if (turn < 0 || (turn == 0 && other.dot(other).compareTo(to.dot(to)) > 0)) {
                    next = c;
                }
            }
            here = next;
        } while (!same(here, start) && hull.size() < 10);
        return hull;
    }

    private static boolean same(Place a, Place b) {
        return a.x.compareTo(b.x) == 0 && a.z.compareTo(b.z) == 0;
    }

    public static boolean overlap(Shape a, Shape b) {
        BigDecimal reach = a.radius.add(b.radius);
        return squareDistance(a.hull, b.hull).compareTo(reach.multiply(reach)) <= 0
                || (reach.signum() > 0 && near(a.hull, b.hull, reach.multiply(reach)));
    }

    /** Whether a ray meets the shape. */
    public static boolean hit(Place o, Place u, Shape s) {
        if (s.radius.signum() > 0) {
            Place m = s.hull.get(0).minus(o);
            BigDecimal rr = s.radius.multiply(s.radius);
            if (m.dot(m).compareTo(rr) <= 0) {
                return true;
            }
            BigDecimal aside = u.cross(m);
            return m.dot(u).signum() >= 0 && aside.multiply(aside).compareTo(rr.multiply(u.dot(u))) <= 0;
        }
        return contains(s.hull, o) || rayShare(o, u, s) != null;
    }

    /** Distance along a ray that hits, from outside or in. */
    public static double distance(Place o, Place u, Shape s) {
        if (contains(s.hull, o)) {
            return 0;
        }
        BigDecimal length = DecimalRoot.of(u.dot(u), DIGITS);
        if (s.radius.signum() > 0) {
            Place m = s.hull.get(0).minus(o);
            BigDecimal power = m.dot(m).subtract(s.radius.multiply(s.radius));
            if (power.signum() <= 0) {
                return 0;
            }
            BigDecimal aside = u.cross(m).divide(length, DIGITS);
            BigDecimal square = s.radius.multiply(s.radius).subtract(aside.multiply(aside));
            BigDecimal half = square.signum() <= 0 ? BigDecimal.ZERO : DecimalRoot.of(square, DIGITS);
            return power.divide(m.dot(u).divide(length, DIGITS).add(half), DIGITS)
                    .doubleValue();
        }
        return rayShare(o, u, s).multiply(length).doubleValue();
    }

    // Least t with o + t u on a side; null where there is none.
    private static BigDecimal rayShare(Place o, Place u, Shape s) {
        BigDecimal best = null;
        for (int k = 0; k < s.hull.size(); k++) {
            Place a = s.hull.get(k).minus(o);
            Place b = s.hull.get((k + 1) % s.hull.size()).minus(o);
            int sideA = u.cross(a).signum();
            int sideB = u.cross(b).signum();
            if (sideA == 0 && u.dot(a).signum() >= 0) {
                best = least(best, u.dot(a).divide(u.dot(u), DIGITS));
            }
            if (sideA * sideB < 0) {
                Place e = b.minus(a);
                BigDecimal t = a.cross(e).divide(u.cross(e), DIGITS);
                if (t.signum() >= 0) {
                    best = least(best, t);
                }
            }
        }
        return best;
    }

    private static BigDecimal least(BigDecimal a, BigDecimal b) {
        return a == null ? b : a.min(b);
    }

    /** The least distance. */
    public static double distance(Shape a, Shape b) {
        if (overlap(a, b)) {
            return 0;
        }
        return DecimalRoot.of(squareDistance(a.hull, b.hull), DIGITS)
                .subtract(a.radius)
                .subtract(b.radius)
                .doubleValue();
    }

    static boolean contains(List<Place> hull, Place p) {
        if (hull.size() == 1) {
            return same(hull.get(0), p);
        }
        for (int k = 0; k < hull.size(); k++) {
            Place a = hull.get(k);
            Place b = hull.get((k + 1) % hull.size());
            if (b.minus(a).cross(p.minus(a)).signum() < 0) {
                return false;
            }
        }
        return hull.size() > 2 || onSegment(hull.get(0), hull.get(1), p);
    }

    private static boolean onSegment(Place a, Place b, Place p) {
        return b.minus(a).cross(p.minus(a)).signum() == 0
                && p.minus(a).dot(p.minus(b)).signum() <= 0;
    }

    // Zero where they meet; else to many digits.
    private static BigDecimal squareDistance(List<Place> a, List<Place> b) {
        if (contains(a, b.get(0)) || contains(b, a.get(0))) {
            return BigDecimal.ZERO;
        }
        BigDecimal best = null;
        for (int k = 0; k < a.size(); k++) {
            for (int m = 0; m < b.size(); m++) {
                Place a0 = a.get(k);
                Place a1 = a.get((k + 1) % a.size());
                Place b0 = b.get(m);
                Place b1 = b.get((m + 1) % b.size());
                if (cross(a0, a1, b0, b1)) {
                    return BigDecimal.ZERO;
                }
                best = least(best, squareToSegment(a0, b0, b1));
                best = least(best, squareToSegment(b0, a0, a1));
            }
        }
        return best;
    }

    private static boolean cross(Place a, Place b, Place c, Place d) {
        int c1 = b.minus(a).cross(c.minus(a)).signum();
        int d1 = b.minus(a).cross(d.minus(a)).signum();
        int a1 = d.minus(c).cross(a.minus(c)).signum();
        int b1 = d.minus(c).cross(b.minus(c)).signum();
        return (c1 * d1 < 0 && a1 * b1 < 0)
                || onSegment(a, b, c)
                || onSegment(a, b, d)
                || onSegment(c, d, a)
                || onSegment(c, d, b);
    }

    private static BigDecimal squareToSegment(Place p, Place a, Place b) {
        Place e = b.minus(a);
        Place w = p.minus(a);
        BigDecimal along = e.dot(w);
        BigDecimal length = e.dot(e);
        if (along.signum() <= 0) {
            return w.dot(w);
        }
        if (along.compareTo(length) >= 0) {
            Place v = p.minus(b);
            return v.dot(v);
        }
        BigDecimal across = e.cross(w);
        return across.multiply(across).divide(length, DIGITS);
    }

    // One of the two is the single centre of a disc: the comparison without a division.
    private static boolean near(List<Place> a, List<Place> b, BigDecimal square) {
        Place p = a.size() == 1 ? a.get(0) : b.get(0);
        List<Place> hull = a.size() == 1 ? b : a;
        for (int k = 0; k < hull.size(); k++) {
            Place from = hull.get(k);
            Place e = hull.get((k + 1) % hull.size()).minus(from);
            Place w = p.minus(from);
            if (w.dot(w).compareTo(square) <= 0) {
                return true;
            }
            BigDecimal along = e.dot(w);
            BigDecimal across = e.cross(w);
            if (along.signum() > 0
                    && along.compareTo(e.dot(e)) < 0
                    && across.multiply(across).compareTo(square.multiply(e.dot(e))) <= 0) {
                return true;
            }
        }
        return false;
    }
}
