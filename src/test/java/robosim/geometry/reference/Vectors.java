package robosim.geometry.reference;

import robosim.geometry.reference.Quantity.Arithmetic;

/** Vectors of three quantities, and rotations. */
public final class Vectors {
    private Vectors() {}

    static Quantity[] of(Arithmetic n, double x, double y, double z) {
        return new Quantity[] {n.of(x), n.of(y), n.of(z)};
    }

    static Quantity[] plus(Quantity[] a, Quantity[] b) {
        return new Quantity[] {a[0].plus(b[0]), a[1].plus(b[1]), a[2].plus(b[2])};
    }

    static Quantity[] minus(Quantity[] a, Quantity[] b) {
        return new Quantity[] {a[0].minus(b[0]), a[1].minus(b[1]), a[2].minus(b[2])};
    }

    static Quantity[] times(Quantity[] a, Quantity k) {
        return new Quantity[] {a[0].times(k), a[1].times(k), a[2].times(k)};
    }

    static Quantity[] negate(Quantity[] a) {
        return new Quantity[] {a[0].negate(), a[1].negate(), a[2].negate()};
    }

    static Quantity dot(Quantity[] a, Quantity[] b) {
        return a[0].times(b[0]).plus(a[1].times(b[1])).plus(a[2].times(b[2]));
    }

    static Quantity[] cross(Quantity[] a, Quantity[] b) {
        return new Quantity[] {
            a[1].times(b[2]).minus(a[2].times(b[1])),
            a[2].times(b[0]).minus(a[0].times(b[2])),
            a[0].times(b[1]).minus(a[1].times(b[0]))
        };
    }

    static boolean isZero(Quantity[] a) {
        if (a[0].isPlainlyNotZero() || a[1].isPlainlyNotZero() || a[2].isPlainlyNotZero()) {
            return false;
        }
        return a[0].signum() == 0 && a[1].signum() == 0 && a[2].signum() == 0;
    }

    static Quantity abs(Quantity a) {
        return a.signum() < 0 ? a.negate() : a;
    }

    /** Whether a is at most b. */
    static boolean atMost(Quantity a, Quantity b) {
        return a.minus(b).signum() <= 0;
    }

    /** The matrix of a quaternion, of which a number is 2 over the square of its length. */
    public static double[] rotation(double s, double w, double x, double y, double z) {
        return new double[] {
            1 - s * (y * y + z * z),
            s * (x * y - w * z),
            s * (x * z + w * y),
            s * (x * y + w * z),
            1 - s * (x * x + z * z),
            s * (y * z - w * x),
            s * (x * z - w * y),
            s * (y * z + w * x),
            1 - s * (x * x + y * y)
        };
    }
}
