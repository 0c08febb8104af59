package robosim.geometry.reference;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.reference.Truth.Form;

/** Vectors of three decimals, without rounding. */
public final class Decimals {
    private Decimals() {}

    public static BigDecimal[] vector(double... p) {
        return new BigDecimal[] {new BigDecimal(p[0]), new BigDecimal(p[1]), new BigDecimal(p[2])};
    }

    public static BigDecimal dot(BigDecimal[] p, BigDecimal[] q) {
        return p[0].multiply(q[0]).add(p[1].multiply(q[1])).add(p[2].multiply(q[2]));
    }

    public static BigDecimal[] cross(BigDecimal[] p, BigDecimal[] q) {
        return new BigDecimal[] {
            p[1].multiply(q[2]).subtract(p[2].multiply(q[1])),
            p[2].multiply(q[0]).subtract(p[0].multiply(q[2])),
            p[0].multiply(q[1]).subtract(p[1].multiply(q[0]))
        };
    }

    public static BigDecimal[] plus(BigDecimal[] p, BigDecimal[] q) {
        return new BigDecimal[] {p[0].add(q[0]), p[1].add(q[1]), p[2].add(q[2])};
    }

    public static BigDecimal[] minus(BigDecimal[] p, BigDecimal[] q) {
        return new BigDecimal[] {p[0].subtract(q[0]), p[1].subtract(q[1]), p[2].subtract(q[2])};
    }

    public static BigDecimal[] times(BigDecimal[] p, BigDecimal f) {
        return new BigDecimal[] {p[0].multiply(f), p[1].multiply(f), p[2].multiply(f)};
    }

    /** The corners of a box or a triangle in space. */
    public static List<BigDecimal[]> corners(Form form, double[] row) {
        List<BigDecimal[]> corners = new ArrayList<>();
        if (form == Form.TRIANGLE) {
            for (int k = 0; k < 9; k += 3) {
                corners.add(vector(row[k], row[k + 1], row[k + 2]));
            }
            return corners;
        }
        for (int k = 0; k < 8; k++) {
            BigDecimal[] corner = vector(row);
            for (int m = 0; m < 3; m++) {
                BigDecimal half = new BigDecimal((k >> m & 1) == 0 ? row[3 + m] : -row[3 + m]);
                corner = plus(corner, times(vector(row[6 + m], row[9 + m], row[12 + m]), half));
            }
            corners.add(corner);
        }
        return corners;
    }
}
