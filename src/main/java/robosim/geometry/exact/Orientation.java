package robosim.geometry.exact;

import java.util.Arrays;

/**
 * Signs of determinants of points, exact for every finite input.
 *
 * <p>Three stages: plain doubles where a derived bound makes their sign certain, expansions where the exponents allow
 * it, big integers otherwise.
 */
public final class Orientation {
    // u = 2^-53; Shewchuk 1997, 4.2 and 4.3: the double determinant is off by at most this much of its permanent.
    private static final double U = 0x1p-53;
    private static final double SIDE_FILTER = FilterBound.bound((3 + 16 * U) * U);
    private static final double VOLUME_FILTER = FilterBound.bound((7 + 56 * U) * U);

    // A product that underflows is off by 2^-1075 more; there are at most six, and the bound itself is rounded.
    private static final double UNDERFLOW = 0x1p-1070;

    private static final StageCounters.Counter SIDE = StageCounters.counter("Orientation.side expanded");
    private static final StageCounters.Counter BIG_SIDE = StageCounters.counter("Orientation.side big");
    private static final StageCounters.Counter VOLUME = StageCounters.counter("Orientation.volume expanded");
    private static final StageCounters.Counter BIG_VOLUME = StageCounters.counter("Orientation.volume big");

    private Orientation() {}

    /**
     * Sign of {@code (bx - ax) * (pz - az) - (bz - az) * (px - ax)}, exact: the side of the line a->b on which the
     * point p lies, 0 if on the line. With X drawn to the right and Z upwards, +1 is left.
     *
     * <p>{@code side(a, b, p) == side(b, p, a) == -side(b, a, p)}.
     */
    public static int side(double ax, double az, double bx, double bz, double px, double pz) {
        int quick = quickSide(ax, az, bx, bz, px, pz);
        return quick != 0 ? quick : exactSide(ax, az, bx, bz, px, pz);
    }

    /**
     * Sign of the determinant of {@code b - a}, {@code c - a}, {@code d - a}, exact: +1 if the three vectors are
     * right-handed, 0 if the four points lie in a plane.
     *
     * @param t the corners a, b and c of a triangle: nine numbers
     */
    public static int volume(double[] t, double dx, double dy, double dz) {
        int quick = quickVolume(t, dx, dy, dz);
        return quick != 0 ? quick : exactVolume(t, dx, dy, dz);
    }

    /** Sign of {@code a * b - c * d}, exact. */
    public static int compareProducts(double a, double b, double c, double d) {
        double left = a * b;
        double right = c * d;
        if (!FilterBound.isDoubting() && (left < right || left > right)) {
            return left > right ? 1 : -1; // rounding never reverses the order of two products
        }
        boolean fits = !FilterBound.isOff()
                && Expansion.fits(a, 2)
                && Expansion.fits(b, 2)
                && Expansion.fits(c, 2)
                && Expansion.fits(d, 2);
        if (fits) {
            double leftTail = DoubleDouble.productTail(a, b, left);
            double rightTail = DoubleDouble.productTail(c, d, right);
            return Dyadic.signOfSum(left, leftTail, -right, -rightTail);
        }
        return Dyadic.product(a, b).compareTo(Dyadic.product(c, d));
    }

    // The sign if plain doubles are certain of it, else 0.
    static int quickSide(double ax, double az, double bx, double bz, double px, double pz) {
        double left = (bx - ax) * (pz - az);
        double right = (bz - az) * (px - ax);
        double det = left - right;
        double bound = SIDE_FILTER * (Math.abs(left) + Math.abs(right)) + UNDERFLOW;
        return det > bound ? 1 : det < -bound ? -1 : 0;
    }

    static int exactSide(double ax, double az, double bx, double bz, double px, double pz) {
        boolean fits = !FilterBound.isOff()
                && Expansion.fits(ax, 2)
                && Expansion.fits(az, 2)
                && Expansion.fits(bx, 2)
                && Expansion.fits(bz, 2)
                && Expansion.fits(px, 2)
                && Expansion.fits(pz, 2);
        (fits ? SIDE : BIG_SIDE).count();
        return fits ? expandedSide(ax, az, bx, bz, px, pz) : dyadicSide(ax, az, bx, bz, px, pz);
    }

    static int expandedSide(double ax, double az, double bx, double bz, double px, double pz) {
        double[] sum = new double[12];
        int n = 0;
        n = addProduct(sum, n, bx, pz);
        n = addProduct(sum, n, -bx, az);
        n = addProduct(sum, n, -ax, pz);
        n = addProduct(sum, n, -bz, px);
        n = addProduct(sum, n, bz, ax);
        n = addProduct(sum, n, az, px);
        return Expansion.sign(sum, n);
    }

    static int dyadicSide(double ax, double az, double bx, double bz, double px, double pz) {
        Dyadic left = Dyadic.difference(bx, ax).multiply(Dyadic.difference(pz, az));
        Dyadic right = Dyadic.difference(bz, az).multiply(Dyadic.difference(px, ax));
        return left.compareTo(right);
    }

    static int quickVolume(double[] t, double dx, double dy, double dz) {
        double ux = t[3] - t[0];
        double uy = t[4] - t[1];
        double uz = t[5] - t[2];
        double vx = t[6] - t[0];
        double vy = t[7] - t[1];
        double vz = t[8] - t[2];
        double wx = dx - t[0];
        double wy = dy - t[1];
        double wz = dz - t[2];
        double yz = uy * vz;
        double zy = uz * vy;
        double zx = uz * vx;
        double xz = ux * vz;
        double xy = ux * vy;
        double yx = uy * vx;
        double det = wx * (yz - zy) + wy * (zx - xz) + wz * (xy - yx);
        double permanent = Math.abs(wx) * (Math.abs(yz) + Math.abs(zy))
                + Math.abs(wy) * (Math.abs(zx) + Math.abs(xz))
                + Math.abs(wz) * (Math.abs(xy) + Math.abs(yx));
        double bound = VOLUME_FILTER * permanent + UNDERFLOW * (1 + Math.abs(wx) + Math.abs(wy) + Math.abs(wz));
        return det > bound ? 1 : det < -bound ? -1 : 0;
    }

    static int exactVolume(double[] t, double dx, double dy, double dz) {
        boolean fits = !FilterBound.isOff()
                && fit(t[0], t[1], t[2])
                && fit(t[3], t[4], t[5])
                && fit(t[6], t[7], t[8])
                && fit(dx, dy, dz);
        (fits ? VOLUME : BIG_VOLUME).count();
        return fits ? expandedVolume(t, dx, dy, dz) : dyadicVolume(t, dx, dy, dz);
    }

    static int expandedVolume(double[] t, double dx, double dy, double dz) {
        double[] ux = difference(t[3], t[0]);
        double[] uy = difference(t[4], t[1]);
        double[] uz = difference(t[5], t[2]);
        double[] vx = difference(t[6], t[0]);
        double[] vy = difference(t[7], t[1]);
        double[] vz = difference(t[8], t[2]);
        double[] first = product(minor(uy, vz, uz, vy), difference(dx, t[0]));
        double[] second = product(minor(uz, vx, ux, vz), difference(dy, t[1]));
        double[] third = product(minor(ux, vy, uy, vx), difference(dz, t[2]));
        double[] all = sum(sum(first, second), third);
        return Expansion.sign(all, all.length);
    }

    static int dyadicVolume(double[] t, double dx, double dy, double dz) {
        Dyadic ux = Dyadic.difference(t[3], t[0]);
        Dyadic uy = Dyadic.difference(t[4], t[1]);
        Dyadic uz = Dyadic.difference(t[5], t[2]);
        Dyadic vx = Dyadic.difference(t[6], t[0]);
        Dyadic vy = Dyadic.difference(t[7], t[1]);
        Dyadic vz = Dyadic.difference(t[8], t[2]);
        Dyadic x = uy.multiply(vz).subtract(uz.multiply(vy)).multiply(Dyadic.difference(dx, t[0]));
        Dyadic y = uz.multiply(vx).subtract(ux.multiply(vz)).multiply(Dyadic.difference(dy, t[1]));
        Dyadic z = ux.multiply(vy).subtract(uy.multiply(vx)).multiply(Dyadic.difference(dz, t[2]));
        return x.add(y).add(z).signum();
    }

    private static boolean fit(double x, double y, double z) {
        return Expansion.fits(x, 3) && Expansion.fits(y, 3) && Expansion.fits(z, 3);
    }

    private static int addProduct(double[] sum, int n, double a, double b) {
        double p = a * b;
        int grown = Expansion.grow(sum, n, DoubleDouble.productTail(a, b, p));
        return Expansion.grow(sum, grown, p);
    }

    private static double[] minor(double[] a, double[] b, double[] c, double[] d) {
        double[] right = product(c, d);
        Expansion.negate(right, right.length);
        return sum(product(a, b), right);
    }

    private static double[] difference(double a, double b) {
        double[] result = new double[2];
        return Arrays.copyOf(result, Expansion.difference(a, b, result));
    }

    private static double[] sum(double[] a, double[] b) {
        double[] result = new double[a.length + b.length];
        return Arrays.copyOf(result, Expansion.sum(a, a.length, b, b.length, result));
    }

    private static double[] product(double[] a, double[] b) {
        double[] result = new double[2 * a.length * b.length];
        return Arrays.copyOf(result, Expansion.product(a, a.length, b, b.length, result));
    }
}
