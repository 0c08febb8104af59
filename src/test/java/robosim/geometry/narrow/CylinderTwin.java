package robosim.geometry.narrow;

import static robosim.geometry.reference.Decimals.cross;
import static robosim.geometry.reference.Decimals.dot;

import java.math.BigDecimal;
import java.math.MathContext;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.DecimalRoot;

/** Two cylinders in decimals of 60 digits: slabs that are empty, and points that both hold. Shares no code with the kernels. */
public final class CylinderTwin {
    static final MathContext DIGITS = new MathContext(60);

    private final BigDecimal[] centre = new BigDecimal[3];
    private final BigDecimal[] axis = new BigDecimal[3];
    private final BigDecimal radius;
    private final BigDecimal half;

    public CylinderTwin(LeafKind kind, double[] row) {
        for (int k = 0; k < 3; k++) {
            centre[k] = new BigDecimal(row[k]);
            axis[k] = kind == LeafKind.CYLINDER ? new BigDecimal(row[7 + 3 * k]) : BigDecimal.valueOf(k == 1 ? 1 : 0);
        }
        radius = new BigDecimal(row[3]);
        half = new BigDecimal(row[4]);
    }

    /** The width of the slab across n between this and another, this one below; negative where they overlap along n. */
    public BigDecimal gap(CylinderTwin other, BigDecimal[] n) {
        BigDecimal width = other.reach(negate(n)).add(reach(n)).negate();
        return width.divide(root(dot(n, n)), DIGITS);
    }

    /** The widest slab between two across an axis of theirs or across both. */
    public double widestOfCaps(CylinderTwin other) {
        double widest = Double.NEGATIVE_INFINITY;
        for (BigDecimal[] n : new BigDecimal[][] {axis, other.axis, cross(axis, other.axis)}) {
            if (dot(n, n).signum() > 0) {
                widest = Math.max(widest, gap(other, n).doubleValue());
                widest = Math.max(widest, gap(other, negate(n)).doubleValue());
            }
        }
        return widest;
    }

    /** How far this reaches along n, times its length. */
    private BigDecimal reach(BigDecimal[] n) {
        BigDecimal[] cross = cross(n, axis);
        BigDecimal across = root(dot(cross, cross).divide(dot(axis, axis), DIGITS));
        return dot(n, centre).add(half.multiply(dot(n, axis).abs())).add(radius.multiply(across), DIGITS);
    }

    /** The point that is furthest along n; a middle of those where several are. */
    public BigDecimal[] furthest(BigDecimal[] n) {
        BigDecimal along = dot(n, axis);
        BigDecimal square = dot(axis, axis);
        BigDecimal[] out = new BigDecimal[3];
        BigDecimal[] aside = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            aside[k] = n[k].multiply(square).subtract(along.multiply(axis[k]));
        }
        BigDecimal length = root(dot(aside, aside));
        for (int k = 0; k < 3; k++) {
            out[k] = centre[k].add(axis[k].multiply(half).multiply(BigDecimal.valueOf(along.signum())));
            if (length.signum() > 0) {
                out[k] = out[k].add(aside[k].multiply(radius).divide(length, DIGITS), DIGITS);
            }
        }
        return out;
    }

    public boolean holds(BigDecimal[] point) {
        BigDecimal[] w = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            w[k] = point[k].subtract(centre[k]);
        }
        BigDecimal square = dot(axis, axis);
        BigDecimal[] cross = cross(w, axis);
        return dot(w, axis).abs().compareTo(half.multiply(square)) <= 0
                && dot(cross, cross).compareTo(radius.multiply(radius).multiply(square)) <= 0;
    }

    public static BigDecimal root(BigDecimal square) {
        return square.signum() <= 0 ? BigDecimal.ZERO : DecimalRoot.of(square, DIGITS);
    }

    public static BigDecimal[] negate(BigDecimal[] a) {
        return new BigDecimal[] {a[0].negate(), a[1].negate(), a[2].negate()};
    }

    public static BigDecimal[] decimals(double... v) {
        return new BigDecimal[] {new BigDecimal(v[0]), new BigDecimal(v[1]), new BigDecimal(v[2])};
    }
}
