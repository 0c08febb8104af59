package robosim.geometry.narrow;

import static robosim.geometry.reference.Decimals.vector;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.DecimalRoot;

/**
 * The slow twin of the planar sweeps, in decimals without rounding: two convex shapes meet on the way of a translation
 * where the origin lies in the hull of all differences of their corners before and after it, or within the radii of it.
 */
public final class FlatTwin {
    private static final MathContext DIGITS = new MathContext(160);

    private final List<BigDecimal[]> differences = new ArrayList<>();
    private final BigDecimal radius;
    private final BigDecimal dx;
    private final BigDecimal dz;

    public FlatTwin(LeafKind kindA, double[] a, double dx, double dz, LeafKind kindB, double[] b) {
        this.dx = new BigDecimal(dx);
        this.dz = new BigDecimal(dz);
        radius = radius(kindA, a).add(radius(kindB, b));
        for (BigDecimal[] p : corners(kindA, a)) {
            for (BigDecimal[] q : corners(kindB, b)) {
                add(q[0].subtract(p[0]), q[1].subtract(p[1]));
            }
        }
    }

    private void add(BigDecimal x, BigDecimal z) {
        if (differences.stream().noneMatch(p -> p[0].compareTo(x) == 0 && p[1].compareTo(z) == 0)) {
            differences.add(new BigDecimal[] {x, z});
        }
    }

    /** Whether the two touch anywhere from time 0 to {@code time}. */
    public boolean meetsBy(double time) {
        return meetsBy(new BigDecimal(time));
    }

    public boolean meetsBy(BigDecimal time) {
        List<BigDecimal[]> swept = new ArrayList<>(differences);
        swept.addAll(at(time));
        return isNear(swept);
    }

    public boolean touchesAtStart() {
        return isNear(differences);
    }

    /** Whether a very small part of the motion leaves the two deeper in each other than they are. */
    public boolean goesDeeper() {
        BigDecimal little = new BigDecimal(0x1p-200);
        BigDecimal change = depth(at(little)).subtract(depth(differences));
        return change.compareTo(new BigDecimal(0x1p-480)) > 0;
    }

    private List<BigDecimal[]> at(BigDecimal time) {
        List<BigDecimal[]> moved = new ArrayList<>();
        for (BigDecimal[] p : differences) {
            moved.add(new BigDecimal[] {p[0].subtract(dx.multiply(time)), p[1].subtract(dz.multiply(time))});
        }
        return moved;
    }

    private boolean isNear(List<BigDecimal[]> points) {
        if (containsOrigin(points)) {
            return true;
        }
        BigDecimal square = radius.multiply(radius);
        for (int i = 0; i < points.size(); i++) {
            for (int j = 0; j <= i; j++) {
                if (compareToSegment(points.get(i), points.get(j), square) <= 0) {
                    return true;
                }
            }
        }
        return false;
    }

    // Outside exactly where some point has all others strictly on one side of its ray from the origin, or ahead on it.
    private static boolean containsOrigin(List<BigDecimal[]> points) {
        for (BigDecimal[] p : points) {
            boolean extreme = true;
            for (BigDecimal[] q : points) {
                int side = cross(p, q).signum();
                if (side < 0 || side == 0 && dot(p, q).signum() <= 0) {
                    extreme = false;
                    break;
                }
            }
            if (extreme) {
                return false;
            }
        }
        return true;
    }

    // Compares the squared distance of the origin from a segment with a square.
    private static int compareToSegment(BigDecimal[] p, BigDecimal[] q, BigDecimal square) {
        BigDecimal[] edge = {q[0].subtract(p[0]), q[1].subtract(p[1])};
        BigDecimal length = dot(edge, edge);
        BigDecimal share = dot(p, edge).negate();
        if (share.signum() <= 0) {
            return dot(p, p).compareTo(square);
        }
        if (share.compareTo(length) >= 0) {
            return dot(q, q).compareTo(square);
        }
        return cross(p, edge).pow(2).compareTo(square.multiply(length));
    }

    private BigDecimal depth(List<BigDecimal[]> points) {
        BigDecimal least = null;
        boolean inside = containsOrigin(points);
        for (int i = 0; i < points.size(); i++) {
            for (int j = 0; j < points.size(); j++) {
                BigDecimal[] p = points.get(i);
                BigDecimal[] q = points.get(j);
                if (inside && !isHullEdge(p, q, points)) {
                    continue;
                }
                BigDecimal distance = distance(p, q, inside);
                least = least == null || distance.compareTo(least) < 0 ? distance : least;
            }
        }
        // Inside a hull without area: no depth at all but the radius.
        BigDecimal core = least == null ? BigDecimal.ZERO : least;
        return inside ? radius.add(core) : radius.subtract(core);
    }

    private static boolean isHullEdge(BigDecimal[] p, BigDecimal[] q, List<BigDecimal[]> points) {
        BigDecimal[] edge = {q[0].subtract(p[0]), q[1].subtract(p[1])};
        if (dot(edge, edge).signum() == 0) {
            return false;
        }
        for (BigDecimal[] r : points) {
            BigDecimal[] away = {r[0].subtract(p[0]), r[1].subtract(p[1])};
            if (cross(edge, away).signum() < 0) {
                return false;
            }
        }
        return true;
    }

    private static BigDecimal distance(BigDecimal[] p, BigDecimal[] q, boolean toLine) {
        BigDecimal[] edge = {q[0].subtract(p[0]), q[1].subtract(p[1])};
        BigDecimal length = dot(edge, edge);
        BigDecimal share = dot(p, edge).negate();
        if (!toLine && (share.signum() <= 0 || length.signum() == 0)) {
            return DecimalRoot.of(dot(p, p), DIGITS);
        }
        if (!toLine && share.compareTo(length) >= 0) {
            return DecimalRoot.of(dot(q, q), DIGITS);
        }
        return cross(p, edge).abs().divide(DecimalRoot.of(length, DIGITS), DIGITS);
    }

    private static BigDecimal radius(LeafKind kind, double[] row) {
        return kind == LeafKind.UPRIGHT_CYLINDER || kind == LeafKind.SPHERE ? new BigDecimal(row[3]) : BigDecimal.ZERO;
    }

    static List<BigDecimal[]> corners(LeafKind kind, double[] row) {
        List<BigDecimal[]> corners = new ArrayList<>();
        BigDecimal[] centre = {new BigDecimal(row[0]), new BigDecimal(row[2])};
        switch (kind) {
            case UPRIGHT_CYLINDER, SPHERE -> corners.add(centre);
            case TRIANGLE -> {
                for (int k = 0; k < 9; k += 3) {
                    corners.add(new BigDecimal[] {new BigDecimal(row[k]), new BigDecimal(row[k + 2])});
                }
            }
            case PRISM -> slabs(row, corners);
            default -> {
                for (int k = 0; k < 8; k++) {
                    BigDecimal[] p = centre.clone();
                    for (int m = 0; m < 3; m++) {
                        BigDecimal h = new BigDecimal((k >> m & 1) == 0 ? row[3 + m] : -row[3 + m]);
                        p[0] = p[0].add(h.multiply(new BigDecimal(row[6 + m])));
                        p[1] = p[1].add(h.multiply(new BigDecimal(row[12 + m])));
                    }
                    corners.add(p);
                }
            }
        }
        return corners;
    }

    // All crossings of two of the eight lines that all eight bounds allow.
    private static void slabs(double[] row, List<BigDecimal[]> corners) {
        int[][] normal = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j < 8; j++) {
                int[] m = normal[i / 2];
                int[] n = normal[j / 2];
                int det = m[0] * n[1] - m[1] * n[0];
                if (det == 0) {
                    continue;
                }
                BigDecimal c = new BigDecimal(row[i]);
                BigDecimal d = new BigDecimal(row[j]);
                BigDecimal x = times(c, n[1]).subtract(times(d, m[1])).divide(BigDecimal.valueOf(det));
                BigDecimal z = times(d, m[0]).subtract(times(c, n[0])).divide(BigDecimal.valueOf(det));
                boolean known = corners.stream().anyMatch(p -> p[0].compareTo(x) == 0 && p[1].compareTo(z) == 0);
                if (!known && isWithin(row, x, z, normal)) {
                    corners.add(new BigDecimal[] {x, z});
                }
            }
        }
    }

    private static boolean isWithin(double[] row, BigDecimal x, BigDecimal z, int[][] normal) {
        for (int k = 0; k < 4; k++) {
            BigDecimal reach = times(x, normal[k][0]).add(times(z, normal[k][1]));
            if (reach.compareTo(new BigDecimal(row[2 * k])) < 0
                    || reach.compareTo(new BigDecimal(row[2 * k + 1])) > 0) {
                return false;
            }
        }
        return true;
    }

    private static BigDecimal times(BigDecimal p, int factor) {
        return p.multiply(BigDecimal.valueOf(factor));
    }

    private static BigDecimal dot(BigDecimal[] p, BigDecimal[] q) {
        return p[0].multiply(q[0]).add(p[1].multiply(q[1]));
    }

    private static BigDecimal cross(BigDecimal[] p, BigDecimal[] q) {
        return p[0].multiply(q[1]).subtract(p[1].multiply(q[0]));
    }

    /** The corners of a box or a triangle in space. */
    static List<BigDecimal[]> cornersInSpace(LeafKind kind, double[] row) {
        List<BigDecimal[]> corners = new ArrayList<>();
        if (kind == LeafKind.TRIANGLE) {
            for (int k = 0; k < 9; k += 3) {
                corners.add(vector(row[k], row[k + 1], row[k + 2]));
            }
            return corners;
        }
        for (int k = 0; k < 8; k++) {
            BigDecimal[] corner = vector(row[0], row[1], row[2]);
            for (int m = 0; m < 3; m++) {
                BigDecimal h = new BigDecimal((k >> m & 1) == 0 ? row[3 + m] : -row[3 + m]);
                for (int axis = 0; axis < 3; axis++) {
                    corner[axis] = corner[axis].add(h.multiply(new BigDecimal(row[6 + 3 * axis + m])));
                }
            }
            corners.add(corner);
        }
        return corners;
    }
}
