package robosim.geometry.narrow;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The slow twin of the overlap of boxes and triangles: corners in decimals, and far more axes than are needed. Cross
 * products of all edges and normals of both and of the world's axes.
 */
public final class DecimalAxes {
    private DecimalAxes() {}

    public static boolean overlap(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        List<BigDecimal[]> cornersA = corners(kindA, a);
        List<BigDecimal[]> cornersB = corners(kindB, b);
        List<BigDecimal[]> directions = new ArrayList<>(directions(kindA, a, cornersA));
        directions.addAll(directions(kindB, b, cornersB));
        int edges = directions.size();
        for (int k = 0; k < 3; k++) {
            BigDecimal[] unit = {BigDecimal.ZERO, BigDecimal.ZERO, BigDecimal.ZERO};
            unit[k] = BigDecimal.ONE;
            directions.add(unit);
        }
        if (kindA == LeafKind.TRIANGLE) {
            directions.add(cross(directions.get(0), directions.get(1)));
        }
        if (kindB == LeafKind.TRIANGLE) {
            directions.add(cross(directions.get(edges - 1), directions.get(edges - 2)));
        }
        for (int k = 0; k < directions.size(); k++) {
            if (separates(directions.get(k), cornersA, cornersB)) {
                return false;
            }
            for (int m = k + 1; m < directions.size(); m++) {
                if (separates(cross(directions.get(k), directions.get(m)), cornersA, cornersB)) {
                    return false;
                }
            }
        }
        return true;
    }

    static List<BigDecimal[]> corners(LeafKind kind, double[] row) {
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

    private static List<BigDecimal[]> directions(LeafKind kind, double[] row, List<BigDecimal[]> corners) {
        List<BigDecimal[]> directions = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            directions.add(
                    kind == LeafKind.TRIANGLE
                            ? minus(corners.get((k + 1) % 3), corners.get(k))
                            : vector(row[6 + k], row[9 + k], row[12 + k]));
        }
        return directions;
    }

    private static boolean separates(BigDecimal[] axis, List<BigDecimal[]> a, List<BigDecimal[]> b) {
        if (axis[0].signum() == 0 && axis[1].signum() == 0 && axis[2].signum() == 0) {
            return false;
        }
        return least(axis, a).compareTo(greatest(axis, b)) > 0 || least(axis, b).compareTo(greatest(axis, a)) > 0;
    }

    private static BigDecimal least(BigDecimal[] axis, List<BigDecimal[]> corners) {
        return corners.stream().map(c -> dot(axis, c)).reduce(BigDecimal::min).orElseThrow();
    }

    private static BigDecimal greatest(BigDecimal[] axis, List<BigDecimal[]> corners) {
        return corners.stream().map(c -> dot(axis, c)).reduce(BigDecimal::max).orElseThrow();
    }

    private static BigDecimal[] vector(double x, double y, double z) {
        return new BigDecimal[] {new BigDecimal(x), new BigDecimal(y), new BigDecimal(z)};
    }

    private static BigDecimal[] minus(BigDecimal[] p, BigDecimal[] q) {
        return new BigDecimal[] {p[0].subtract(q[0]), p[1].subtract(q[1]), p[2].subtract(q[2])};
    }

    private static BigDecimal dot(BigDecimal[] p, BigDecimal[] q) {
        return p[0].multiply(q[0]).add(p[1].multiply(q[1])).add(p[2].multiply(q[2]));
    }

    private static BigDecimal[] cross(BigDecimal[] p, BigDecimal[] q) {
        return new BigDecimal[] {
            p[1].multiply(q[2]).subtract(p[2].multiply(q[1])),
            p[2].multiply(q[0]).subtract(p[0].multiply(q[2])),
            p[0].multiply(q[1]).subtract(p[1].multiply(q[0]))
        };
    }
}
