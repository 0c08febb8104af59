package robosim.geometry.exact;

/**
 * Numbered registers that hold double-doubles, and the arithmetic of {@link DoubleDouble} on them. A vector is three
 * consecutive registers, given by the first.
 */
public final class DoubleDoubles {
    private final double[] v;

    public DoubleDoubles(int count) {
        v = new double[2 * count];
    }

    public double get(int i) {
        return v[2 * i];
    }

    /** The low part of a register, which {@link #get} leaves out. */
    public double rest(int i) {
        return v[2 * i + 1];
    }

    public void set(int i, double value) {
        set(i, value, 0);
    }

    public void set(int i, double hi, double lo) {
        v[2 * i] = hi;
        v[2 * i + 1] = lo;
    }

    /** Sets a register to the difference of two doubles. */
    public void difference(int i, double a, double b) {
        DoubleDouble.sum(a, -b, v, 2 * i);
    }

    /** Sets a register to the product of two doubles. */
    public void product(int i, double a, double b) {
        DoubleDouble.product(a, b, v, 2 * i);
    }

    public void add(int i, int a, int b) {
        DoubleDouble.add(v[2 * a], v[2 * a + 1], v[2 * b], v[2 * b + 1], v, 2 * i);
    }

    public void subtract(int i, int a, int b) {
        DoubleDouble.subtract(v[2 * a], v[2 * a + 1], v[2 * b], v[2 * b + 1], v, 2 * i);
    }

    public void multiply(int i, int a, int b) {
        DoubleDouble.multiply(v[2 * a], v[2 * a + 1], v[2 * b], v[2 * b + 1], v, 2 * i);
    }

    public void multiply(int i, int a, double b) {
        DoubleDouble.multiply(v[2 * a], v[2 * a + 1], b, 0, v, 2 * i);
    }

    public void divide(int i, int a, int b) {
        DoubleDouble.divide(v[2 * a], v[2 * a + 1], v[2 * b], v[2 * b + 1], v, 2 * i);
    }

    public void negate(int i) {
        set(i, -v[2 * i], -v[2 * i + 1]);
    }

    /** Sets a register to the square root of another; a negative number counts as 0. */
    public void root(int i, int a) {
        DoubleDouble.sqrt(Math.max(0, v[2 * a]), v[2 * a] > 0 ? v[2 * a + 1] : 0, v, 2 * i);
    }

    /** Sets a register to a dot product; overwrites the register {@code temporary}. */
    public void dot(int i, int a, int b, int temporary) {
        int from = i == a || i == b ? temporary : i;
        multiply(from, a, b);
        multiply(temporary + 1, a + 1, b + 1);
        add(from, from, temporary + 1);
        multiply(temporary + 1, a + 2, b + 2);
        add(i, from, temporary + 1);
    }

    /** Sets a vector to a cross product; {@code i} must be a vector other than a and b. */
    public void cross(int i, int a, int b, int temporary) {
        for (int k = 0; k < 3; k++) {
            int l = (k + 1) % 3;
            int m = (k + 2) % 3;
            multiply(i + k, a + l, b + m);
            multiply(temporary, a + m, b + l);
            subtract(i + k, i + k, temporary);
        }
    }

    /** Sets a vector to {@code a + f b}. */
    public void advance(int i, int a, int f, int b, int temporary) {
        for (int k = 0; k < 3; k++) {
            multiply(temporary, f, b + k);
            add(i + k, a + k, temporary);
        }
    }

    public void subtractVector(int i, int a, int b) {
        for (int k = 0; k < 3; k++) {
            subtract(i + k, a + k, b + k);
        }
    }
}
