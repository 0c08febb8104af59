package robosim.geometry.narrow;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.Decimals;

/** How far a leaf reaches in a direction, in decimals of 60 digits. Shares no code with the kernels. */
public final class SupportTwin {
    private final LeafKind kind;
    private final double[] row;
    private final List<BigDecimal[]> corners = new ArrayList<>();

    public SupportTwin(LeafKind kind, double[] row) {
        this.kind = kind;
        this.row = row;
        if (kind == LeafKind.PRISM) {
            octagon();
        }
    }

    /** The width of the slab across n between this, which lies on the side of n, and another; negative where they overlap. */
    public BigDecimal gap(SupportTwin other, BigDecimal[] n) {
        BigDecimal width = reach(CylinderTwin.negate(n)).add(other.reach(n)).negate();
        return width.divide(CylinderTwin.root(Decimals.dot(n, n)), CylinderTwin.DIGITS);
    }

    /** The greatest n . x. */
    BigDecimal reach(BigDecimal[] n) {
        switch (kind) {
            case TRIANGLE -> {
                BigDecimal[] a = CylinderTwin.decimals(row[0], row[1], row[2]);
                BigDecimal[] b = CylinderTwin.decimals(row[3], row[4], row[5]);
                BigDecimal[] c = CylinderTwin.decimals(row[6], row[7], row[8]);
                return Decimals.dot(n, a).max(Decimals.dot(n, b)).max(Decimals.dot(n, c));
            }
            case PRISM -> {
                return corners.stream()
                        .map(p -> Decimals.dot(n, p))
                        .max(BigDecimal::compareTo)
                        .orElseThrow();
            }
            default -> {
                BigDecimal[] centre = CylinderTwin.decimals(row[0], row[1], row[2]);
                return Decimals.dot(n, centre).add(fromCentre(n), CylinderTwin.DIGITS);
            }
        }
    }

    /** An octagonal prism's corners in doubles; of other leaves none. */
    public double[][] octagonCorners() {
        return corners.stream()
                .map(p -> new double[] {p[0].doubleValue(), p[1].doubleValue(), p[2].doubleValue()})
                .toArray(double[][]::new);
    }

    private BigDecimal fromCentre(BigDecimal[] n) {
        BigDecimal radius = new BigDecimal(row[3]);
        if (kind == LeafKind.SPHERE) {
            return radius.multiply(CylinderTwin.root(Decimals.dot(n, n)));
        }
        if (kind == LeafKind.UPRIGHT_BOX || kind == LeafKind.BOX) {
            BigDecimal sum = BigDecimal.ZERO;
            for (int k = 0; k < 3; k++) {
                BigDecimal[] own = CylinderTwin.decimals(row[6 + k], row[9 + k], row[12 + k]);
                sum = sum.add(
                        new BigDecimal(row[3 + k]).multiply(Decimals.dot(n, own).abs()));
            }
            return sum;
        }
        BigDecimal[] axis = kind == LeafKind.CYLINDER || kind == LeafKind.CAPSULE
                ? CylinderTwin.decimals(row[7], row[10], row[13])
                : CylinderTwin.decimals(0, 1, 0);
        if (kind.isCapsule()) {
            return new BigDecimal(row[4])
                    .multiply(Decimals.dot(n, axis).abs())
                    .add(radius.multiply(CylinderTwin.root(Decimals.dot(n, n))));
        }
        BigDecimal[] cross = Decimals.cross(n, axis);
        BigDecimal square = Decimals.dot(cross, cross).divide(Decimals.dot(axis, axis), CylinderTwin.DIGITS);
        return new BigDecimal(row[4])
                .multiply(Decimals.dot(n, axis).abs())
                .add(radius.multiply(CylinderTwin.root(square)));
    }

    /** All places where two of the octagon's lines meet and no other cuts them off. */
    private void octagon() {
        int[][] forms = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
        for (int p = 0; p < 8; p++) {
            for (int q = 0; q < p; q++) {
                int[] f = forms[p / 2];
                int[] g = forms[q / 2];
                int determinant = f[0] * g[1] - f[1] * g[0];
                if (determinant != 0) {
                    // 1 or 2, of either sign: its reciprocal
                    BigDecimal over = BigDecimal.valueOf(1.0 / determinant);
                    BigDecimal v = new BigDecimal(row[p]);
                    BigDecimal w = new BigDecimal(row[q]);
                    BigDecimal x = times(v, g[1]).subtract(times(w, f[1])).multiply(over);
                    BigDecimal z = times(w, f[0]).subtract(times(v, g[0])).multiply(over);
                    if (holds(forms, x, z)) {
                        corners.add(new BigDecimal[] {x, new BigDecimal(row[8]), z});
                        corners.add(new BigDecimal[] {x, new BigDecimal(row[9]), z});
                    }
                }
            }
        }
    }

    private boolean holds(int[][] forms, BigDecimal x, BigDecimal z) {
        for (int k = 0; k < 4; k++) {
            BigDecimal reach = times(x, forms[k][0]).add(times(z, forms[k][1]));
            if (reach.compareTo(new BigDecimal(row[2 * k])) < 0
                    || reach.compareTo(new BigDecimal(row[2 * k + 1])) > 0) {
                return false;
            }
        }
        return true;
    }

    private static BigDecimal times(BigDecimal v, int factor) {
        return v.multiply(BigDecimal.valueOf(factor));
    }
}
