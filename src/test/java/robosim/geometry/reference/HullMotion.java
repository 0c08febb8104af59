package robosim.geometry.reference;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** When a hull of points that moves straight on meets another: a ray into the hull of all differences, as a ratio. */
public final class HullMotion {
    private final Rational time;

    private HullMotion(Rational time) {
        this.time = time;
    }

    /** Null where the two never meet. */
    public static @Nullable HullMotion of(List<BigDecimal[]> mover, List<BigDecimal[]> rest, double... move) {
        List<Rational[]> differences = new ArrayList<>();
        for (BigDecimal[] p : mover) {
            for (BigDecimal[] q : rest) {
                Rational[] difference = new Rational[move.length];
                for (int k = 0; k < move.length; k++) {
                    difference[k] = rational(q[k].subtract(p[k]));
                }
                differences.add(difference);
            }
        }
        Rational[] start = new Rational[move.length];
        Rational[] direction = new Rational[move.length];
        for (int k = 0; k < move.length; k++) {
            start[k] = Rational.ZERO;
            direction[k] = Rational.of(move[k]);
        }
        Rational enter = Simplex.enter(start, direction, differences);
        return enter == null ? null : new HullMotion(enter);
    }

    /** Compares the time with a double. */
    public int compareTo(double other) {
        return time.compareTo(Rational.of(other));
    }

    /** Compares the time with a decimal of finitely many binary places. */
    public int compareTo(BigDecimal other) {
        return time.compareTo(rational(other));
    }

    private static Rational rational(BigDecimal value) {
        int places = Math.max(0, value.scale());
        BigInteger over =
                value.multiply(new BigDecimal(BigInteger.TWO.pow(places))).toBigIntegerExact();
        return Rational.of(over, BigInteger.TWO.pow(places));
    }
}
