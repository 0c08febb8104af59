package robosim.geometry.exact;

/** The sine and cosine of an angle in radians, the same bits everywhere; quick for the small angles of a step. */
public final class SinCos {
    /** Up to here the series below are as good as doubles: the first terms left out are below 2^-54. */
    private static final double SMALL = 0.5;

    /** Of the angle given last. */
    public double cos;

    public double sin;

    /** Works out both for an angle. */
    public void by(double angle) {
        if (Math.abs(angle) > SMALL) {
            cos = Radians.cos(angle);
            sin = Radians.sin(angle);
            return;
        }
        double s = angle * angle;
        double odd = -1.0 / 39916800 + s / 6227020800.0;
        odd = 1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 + s * odd));
        sin = angle * (1 + s * (-1.0 / 6 + s * odd));
        double even = 1.0 / 40320 + s * (-1.0 / 3628800 + s / 479001600.0);
        even = 1.0 / 24 + s * (-1.0 / 720 + s * even);
        cos = 1 + s * (-0.5 + s * even);
    }
}
