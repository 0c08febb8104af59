package robosim.geometry.narrow.leaf;

/** The eight corners of an octagonal prism's base. */
public final class PrismCorners {
    private PrismCorners() {}

    /**
     * Writes the corners counter-clockwise as seen from below (x towards z), relative to an origin. Each bound is first
     * tightened to what the others allow, so that corners may coincide but never change their order by more than
     * rounding.
     */
    public static void load(double[] row, int at, double ox, double oz, double[] x, double[] z) {
        double x0 = row[at] - ox;
        double x1 = row[at + 1] - ox;
        double z0 = row[at + 2] - oz;
        double z1 = row[at + 3] - oz;
        double s0 = lessSum(row[at + 4], ox, oz);
        double s1 = lessSum(row[at + 5], ox, oz);
        double d0 = lessSum(row[at + 6], ox, -oz);
        double d1 = lessSum(row[at + 7], ox, -oz);
        double left = Math.max(x0, Math.max(0.5 * (s0 + d0), Math.max(s0 - z1, d0 + z0)));
        double right = Math.min(x1, Math.min(0.5 * (s1 + d1), Math.min(s1 - z0, d1 + z1)));
        double near = Math.max(z0, Math.max(0.5 * (s0 - d1), Math.max(s0 - x1, x0 - d1)));
        double far = Math.min(z1, Math.min(0.5 * (s1 - d0), Math.min(s1 - x0, x1 - d0)));
        s0 = Math.max(s0, left + near);
        s1 = Math.min(s1, right + far);
        d0 = Math.max(d0, left - far);
        d1 = Math.min(d1, right - near);
        x[0] = right;
        z[0] = right - d1;
        x[1] = right;
        z[1] = s1 - right;
        x[2] = s1 - far;
        z[2] = far;
        x[3] = d0 + far;
        z[3] = far;
        x[4] = left;
        z[4] = left - d0;
        x[5] = left;
        z[5] = s0 - left;
        x[6] = s0 - near;
        z[6] = near;
        x[7] = d1 + near;
        z[7] = near;
    }

    // v - (p + q), its rounding error is relative to the result, not to the numbers that cancel.
    private static double lessSum(double v, double p, double q) {
        double sum = p + q;
        double part = sum - p;
        double lost = (p - (sum - part)) + (q - part);
        return (v - sum) - lost;
    }
}
