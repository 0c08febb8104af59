package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import org.junit.jupiter.api.Test;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.cone.Cone;
import robosim.geometry.reference.DecimalRoot;
import robosim.geometry.reference.Decimals;

/** How wrong a cone is about a point, against decimals of 60 digits, in which the cosine is the stored one. */
class ConeErrorTest {
    private static final MathContext DIGITS = new MathContext(60);

    private static BigDecimal root(BigDecimal square) {
        return square.signum() <= 0 ? BigDecimal.ZERO : DecimalRoot.of(square, DIGITS);
    }

    /** The bound of an edge's depth is not idle: that of a corner alone comes to more than a tenth of it. */
    @Test
    void theDepthOfACornerIsOffByATenthOfItsBound() {
        double[] d = {0.3477021455478506, -0.158260573066916, 0.4709351827179953};
        double[] p = {-0.2767906702525891, 0.14481970208000639, -0.0940296332316426};
        double cos = 0.9365061410686879;
        Cone cone = new Cone();
        double sin = Math.sqrt((1 - cos) * (1 + cos));
        cone.set(new BeamAxis().line(0.1, 0.2, 0.3, d[0], d[1], d[2]).widen(cos, sin), 0.2);
        BigDecimal[] q = Decimals.minus(CylinderTwin.decimals(p), CylinderTwin.decimals(0.1, 0.2, 0.3));
        BigDecimal[] axis = CylinderTwin.decimals(d);
        BigDecimal length = root(Decimals.dot(q, q));
        BigDecimal depth = Decimals.dot(q, axis)
                .divide(root(Decimals.dot(axis, axis)), DIGITS)
                .subtract(new BigDecimal(cos).multiply(length));
        BigDecimal off = new BigDecimal(cone.depth(p[0] - 0.1, p[1] - 0.2, p[2] - 0.3)).subtract(depth);
        assertThat(off.abs().doubleValue() / length.doubleValue()).isBetween(4.8 * 0x1p-53, 48 * 0x1p-53);
    }
}
