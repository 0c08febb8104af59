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
    private static final double SIDE_FILTER = Filter.bound((3 + 16 * U) * U);
    private static final double VOLUME_FILTER = Filter.bound((7 + 56 * U) * U);

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
     */
    public static int volume(
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            double cx,
            double cy,
            double cz,
            double dx,
            double dy,
            double dz) {
        int quick = quickVolume(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz);
        return quick != 0 ? quick : exactVolume(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz);
    }

    /** Sign of {@code a * b - c * d}, exact. */
    public static int compareProducts(double a, double b, double c, double d) {
        double left = a * b;
        double right = c * d;
        if (!Filter.isDoubting() && (left < right || left > right)) {
            return left > right ? 1 : -1; // rounding never reverses the order of two products
        }
        boolean fits = !Filter.isOff()
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
        boolean fits = !Filter.isOff()
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

    static int quickVolume(
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            double cx,
            double cy,
            double cz,
            double dx,
            double dy,
            double dz) {
        double ux = bx - ax;
        double uy = by - ay;
        double uz = bz - az;
        double vx = cx - ax;
        double vy = cy - ay;
        double vz = cz - az;
        double wx = dx - ax;
        double wy = dy - ay;
        double wz = dz - az;
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

    static int exactVolume(
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            double cx,
            double cy,
            double cz,
            double dx,
            double dy,
            double dz) {
        boolean fits = !Filter.isOff() && fit(ax, ay, az) && fit(bx, by, bz) && fit(cx, cy, cz) && fit(dx, dy, dz);
        (fits ? VOLUME : BIG_VOLUME).count();
        return fits
                ? expandedVolume(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz)
                : dyadicVolume(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz);
    }

    static int expandedVolume(
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            double cx,
            double cy,
            double cz,
            double dx,
            double dy,
            double dz) {
        double[] first = minorTimes(by, ay, cz, az, bz, az, cy, ay, dx, ax);
        double[] second = minorTimes(bz, az, cx, ax, bx, ax, cz, az, dy, ay);
        double[] third = minorTimes(bx, ax, cy, ay, by, ay, cx, ax, dz, az);
        double[] two = new double[first.length + second.length];
        int n = Expansion.sum(first, first.length, second, second.length, two);
        double[] all = new double[n + third.length];
        return Expansion.sign(all, Expansion.sum(two, n, third, third.length, all));
    }

    static int dyadicVolume(
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            double cx,
            double cy,
            double cz,
            double dx,
            double dy,
            double dz) {
        Dyadic ux = Dyadic.difference(bx, ax);
        Dyadic uy = Dyadic.difference(by, ay);
        Dyadic uz = Dyadic.difference(bz, az);
        Dyadic vx = Dyadic.difference(cx, ax);
        Dyadic vy = Dyadic.difference(cy, ay);
        Dyadic vz = Dyadic.difference(cz, az);
        Dyadic x = uy.multiply(vz).subtract(uz.multiply(vy)).multiply(Dyadic.difference(dx, ax));
        Dyadic y = uz.multiply(vx).subtract(ux.multiply(vz)).multiply(Dyadic.difference(dy, ay));
        Dyadic z = ux.multiply(vy).subtract(uy.multiply(vx)).multiply(Dyadic.difference(dz, az));
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

    // ((a - b)(c - d) - (e - f)(g - h)) * (p - q); uses the whole array
    private static double[] minorTimes(
            double a, double b, double c, double d, double e, double f, double g, double h, double p, double q) {
        double[] left = product(a, b, c, d);
        double[] right = product(e, f, g, h);
        Expansion.negate(right, right.length);
        double[] minor = new double[left.length + right.length];
        int n = Expansion.sum(left, left.length, right, right.length, minor);
        double[] factor = new double[2];
        int m = Expansion.difference(p, q, factor);
        double[] result = new double[2 * n * m];
        return Arrays.copyOf(result, Expansion.product(minor, n, factor, m, result));
    }

    private static double[] product(double a, double b, double c, double d) {
        double[] first = new double[2];
        int n = Expansion.difference(a, b, first);
        double[] second = new double[2];
        int m = Expansion.difference(c, d, second);
        double[] result = new double[2 * n * m];
        return Arrays.copyOf(result, Expansion.product(first, n, second, m, result));
    }
}
