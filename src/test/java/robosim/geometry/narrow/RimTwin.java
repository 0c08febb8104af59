package robosim.geometry.narrow;

import static robosim.geometry.reference.Decimals.dot;

import java.math.BigDecimal;
import java.math.MathContext;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.DecimalRoot;
import robosim.geometry.reference.Decimals;

/** The slow twin of a sphere that moves straight on at a cylinder in any attitude: the distance at 60 digits. */
public final class RimTwin {
    private static final MathContext DIGITS = new MathContext(60);
    private static final BigDecimal TWO = BigDecimal.valueOf(2);

    private final double[] sphere;
    private final double[] d;
    private final double[] cylinder;
    private final BigDecimal[] axis;
    private final BigDecimal axisSquare;

    public RimTwin(double[] sphere, double[] d, LeafKind kind, double[] cylinder) {
        this.sphere = sphere;
        this.d = d;
        this.cylinder = cylinder;
        axis = kind == LeafKind.CYLINDER
                ? Decimals.vector(cylinder[7], cylinder[10], cylinder[13])
                : Decimals.vector(0, 1, 0);
        axisSquare = dot(axis, axis);
    }

    /** How far apart the two are at a time; not above 0 where they touch. */
    public BigDecimal gap(BigDecimal time) {
        BigDecimal[] w = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            w[k] = new BigDecimal(sphere[k])
                    .add(new BigDecimal(d[k]).multiply(time))
                    .subtract(new BigDecimal(cylinder[k]));
        }
        BigDecimal length = DecimalRoot.of(axisSquare, DIGITS);
        BigDecimal along = dot(w, axis);
        BigDecimal aside = dot(w, w).subtract(along.pow(2).divide(axisSquare, DIGITS));
        BigDecimal beyond = along.abs().divide(length, DIGITS).subtract(new BigDecimal(cylinder[4]).multiply(length));
        BigDecimal outside = DecimalRoot.of(aside.max(BigDecimal.ZERO), DIGITS).subtract(new BigDecimal(cylinder[3]));
        BigDecimal p = beyond.max(BigDecimal.ZERO);
        BigDecimal q = outside.max(BigDecimal.ZERO);
        return DecimalRoot.of(p.pow(2).add(q.pow(2)), DIGITS).subtract(new BigDecimal(sphere[3]));
    }

    /** The time of least gap: it falls before and grows after. */
    public BigDecimal nearest() {
        BigDecimal lo = BigDecimal.ZERO;
        BigDecimal hi = BigDecimal.ONE;
        for (int k = 0; k < 90; k++) {
            BigDecimal third = hi.subtract(lo).divide(BigDecimal.valueOf(3), DIGITS);
            BigDecimal p = lo.add(third);
            BigDecimal q = hi.subtract(third);
            if (gap(p).compareTo(gap(q)) <= 0) {
                hi = q;
            } else {
                lo = p;
            }
        }
        return lo;
    }

    /** The time of first contact before the time of least gap, at which they overlap. */
    public BigDecimal contact(BigDecimal nearest) {
        BigDecimal lo = BigDecimal.ZERO;
        BigDecimal hi = nearest;
        for (int k = 0; k < 100; k++) {
            BigDecimal middle = lo.add(hi).divide(TWO, DIGITS);
            if (gap(middle).signum() > 0) {
                lo = middle;
            } else {
                hi = middle;
            }
        }
        return lo;
    }
}
