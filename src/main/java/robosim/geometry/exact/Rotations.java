package robosim.geometry.exact;

/**
 * Rotation matrices as nine doubles in an array, row-major; the columns are an object's own axes in the world.
 *
 * <p><b>Orthonormality does not degrade.</b> After a turn or a {@link #yaw}, whatever came before, each dot product of
 * two columns is within {@link #ORTHONORMALITY} of 0 or 1. With u = 2<sup>-53</sup>: a yaw's cosine and sine are off by
 * 1.5 ulp, 3u of themselves, so the sum of their squares by 6u; a composed turn is corrected by products that are off
 * by at most 3u (three products and two sums, and by Cauchy the magnitudes sum to 1), and the corrected numbers are
 * rounded once more, which costs 2u a product; the Newton step leaves only the square of the error that the turn itself
 * added, and of a given rotation's 1e-9. Quarter turns permute columns and add no error.
 *
 * <p><b>The direction.</b> A composed turn is off by at most {@link #TURN_ERROR} radians: 3u for its cosine and sine,
 * 2.5u for its products and sums (3.5u in the Frobenius norm; the angle is the skew-symmetric part over the root of
 * two), and 1.25u for the rounding of the corrected numbers. So n composed turns are off by at most n times that, and
 * by about the square root of n times that if their errors are independent. The symmetric correction adds no rotation.
 */
public final class Rotations {
    /** Number of doubles in a rotation. */
    public static final int SIZE = 9;

    /**
     * How far the dot product of two columns may be from 0 or 1 after any number of turns: 8u, of which 6u are derived
     * above.
     */
    public static final double ORTHONORMALITY = 0x1p-50;

    /** The largest angular error of a composed turn, in radians: 7u. */
    public static final double TURN_ERROR = 7 * 0x1p-53;

    /** How far each dot product of two columns of a given rotation may be from 0 or 1. */
    private static final double ORTHONORMAL = 1e-9;

    private Rotations() {}

    /** Writes the identity. */
    public static void identity(double[] r, int at) {
        upright(1, 0, r, at);
    }

    /** Writes the rotation about the vertical by the compensated angle {@code hi + lo} degrees. */
    public static void yaw(double hi, double lo, double[] r, int at) {
        upright(Degrees.cos(hi, lo), Degrees.sin(hi, lo), r, at);
    }

    /** Writes the rotation about the vertical by the angle with this cosine and sine. */
    public static void upright(double cos, double sin, double[] r, int at) {
        r[at] = cos;
        r[at + 1] = 0;
        r[at + 2] = sin;
        r[at + 3] = 0;
        r[at + 4] = 1;
        r[at + 5] = 0;
        r[at + 6] = 0.0 - sin;
        r[at + 7] = 0;
        r[at + 8] = cos;
    }

    /** Turns about the own Y axis: {@code R <- R * Ry(degrees)}. Quarter turns only permute columns and change signs. */
    public static void turnOwnY(double[] r, int at, double degrees) {
        turn(r, at, 0, 2, 3, degrees);
    }

    /** Turns about the own X axis: {@code R <- R * Rx(degrees)}. Quarter turns only permute columns and change signs. */
    public static void turnOwnX(double[] r, int at, double degrees) {
        turn(r, at, 2, 1, 3, degrees);
    }

    /** Turns about the world's vertical: {@code R <- Ry(degrees) * R}. Quarter turns only permute rows and change signs. */
    public static void turnVertically(double[] r, int at, double degrees) {
        turn(r, at, 6, 0, 1, degrees);
    }

    /** Turns about the world's X axis: {@code R <- Rx(degrees) * R}. Quarter turns only permute rows and change signs. */
    public static void turnWorldX(double[] r, int at, double degrees) {
        turn(r, at, 3, 6, 1, degrees);
    }

    /** Turns three pairs of numbers, the first number of each towards the second one, with so many numbers from pair to pair. */
    private static void turn(double[] r, int at, int first, int second, int step, double degrees) {
        double c = Degrees.cos(degrees);
        double s = Degrees.sin(degrees);
        for (int k = 0; k < 3 * step; k += step) {
            double p = r[at + first + k];
            double q = r[at + second + k];
            r[at + first + k] = c * p - s * q + 0.0;
            r[at + second + k] = s * p + c * q + 0.0;
        }
        if (c != 0 && s != 0) {
            orthonormalise(r, at);
        }
    }

    /** Writes the product {@code a * b}, which may replace either factor. The product is not re-orthonormalized. */
    public static void multiply(double[] a, int i, double[] b, int j, double[] out, int at) {
        double b00 = b[j];
        double b01 = b[j + 1];
        double b02 = b[j + 2];
        double b10 = b[j + 3];
        double b11 = b[j + 4];
        double b12 = b[j + 5];
        double b20 = b[j + 6];
        double b21 = b[j + 7];
        double b22 = b[j + 8];
        // Row by row, in the order that is safe if both overlap: if out follows a in the same array, each row is read
        // before it is overwritten.
        for (int row = 0; row < SIZE; row += 3) {
            double x = a[i + row];
            double y = a[i + row + 1];
            double z = a[i + row + 2];
            out[at + row] = x * b00 + y * b10 + z * b20 + 0.0;
            out[at + row + 1] = x * b01 + y * b11 + z * b21 + 0.0;
            out[at + row + 2] = x * b02 + y * b12 + z * b22 + 0.0;
        }
    }

    /** Whether the columns are orthonormal to 1e-9 and right-handed; false for NaN. */
    public static boolean isOrthonormal(double[] r, int at) {
        for (int p = 0; p < 3; p++) {
            for (int q = p; q < 3; q++) {
                double product = columns(r, at, p, q);
                if (!(Math.abs(product - (p == q ? 1 : 0)) <= ORTHONORMAL)) {
                    return false;
                }
            }
        }
        return determinant(r, at) > 0;
    }

    /** Whether the object's own Y axis is exactly the world's, and the other two are exactly horizontal. */
    public static boolean isUpright(double[] r, int at) {
        return r[at + 1] == 0 && r[at + 3] == 0 && r[at + 4] == 1 && r[at + 5] == 0 && r[at + 7] == 0;
    }

    public static double determinant(double[] r, int at) {
        return r[at] * (r[at + 4] * r[at + 8] - r[at + 5] * r[at + 7])
                - r[at + 1] * (r[at + 3] * r[at + 8] - r[at + 5] * r[at + 6])
                + r[at + 2] * (r[at + 3] * r[at + 7] - r[at + 4] * r[at + 6]);
    }

    /**
     * One Newton step towards the nearest orthonormal matrix, {@code R <- R (3I - R'R) / 2}: an error e becomes about
     * e*e. Axes that are exactly along the world's stay so.
     */
    public static void orthonormalise(double[] r, int at) {
        double xx = columns(r, at, 0, 0);
        double xy = columns(r, at, 0, 1);
        double xz = columns(r, at, 0, 2);
        double yy = columns(r, at, 1, 1);
        double yz = columns(r, at, 1, 2);
        double zz = columns(r, at, 2, 2);
        for (int row = at; row < at + SIZE; row += 3) {
            double x = r[row];
            double y = r[row + 1];
            double z = r[row + 2];
            // Written as a small correction, so that the rounding of the factor 3 - xx does not matter.
            r[row] = x + 0.5 * (x * (1 - xx) - y * xy - z * xz);
            r[row + 1] = y + 0.5 * (y * (1 - yy) - x * xy - z * yz);
            r[row + 2] = z + 0.5 * (z * (1 - zz) - x * xz - y * yz);
        }
    }

    private static double columns(double[] r, int at, int p, int q) {
        return r[at + p] * r[at + q] + r[at + 3 + p] * r[at + 3 + q] + r[at + 6 + p] * r[at + 6 + q];
    }
}
