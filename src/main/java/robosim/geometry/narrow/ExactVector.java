package robosim.geometry.narrow;

import robosim.geometry.exact.Dyadic;

/** An exact vector of three numbers, for the decisions that doubles could not make. */
record ExactVector(Dyadic x, Dyadic y, Dyadic z) {
    static final ExactVector ZERO = new ExactVector(Dyadic.ZERO, Dyadic.ZERO, Dyadic.ZERO);

    static ExactVector of(double x, double y, double z) {
        return new ExactVector(Dyadic.of(x), Dyadic.of(y), Dyadic.of(z));
    }

    /** Three numbers of a row, one after the other. */
    static ExactVector at(double[] row, int at) {
        return of(row, at, 1);
    }

    /** An own axis: a column of the rotation that begins at an index. */
    static ExactVector column(double[] row, int at) {
        return of(row, at, 3);
    }

    /** The three numbers from {@code at} on, each {@code step} apart. */
    static ExactVector of(double[] row, int at, int step) {
        return of(row[at], row[at + step], row[at + 2 * step]);
    }

    ExactVector plus(ExactVector o) {
        return new ExactVector(x.add(o.x), y.add(o.y), z.add(o.z));
    }

    ExactVector minus(ExactVector o) {
        return new ExactVector(x.subtract(o.x), y.subtract(o.y), z.subtract(o.z));
    }

    ExactVector times(Dyadic factor) {
        return new ExactVector(x.multiply(factor), y.multiply(factor), z.multiply(factor));
    }

    ExactVector negate() {
        return new ExactVector(x.negate(), y.negate(), z.negate());
    }

    ExactVector scale(int power) {
        return new ExactVector(x.scale(power), y.scale(power), z.scale(power));
    }

    Dyadic dot(ExactVector o) {
        return x.multiply(o.x).add(y.multiply(o.y)).add(z.multiply(o.z));
    }

    Dyadic square() {
        return dot(this);
    }

    ExactVector cross(ExactVector o) {
        return new ExactVector(
                y.multiply(o.z).subtract(z.multiply(o.y)),
                z.multiply(o.x).subtract(x.multiply(o.z)),
                x.multiply(o.y).subtract(y.multiply(o.x)));
    }

    boolean isZero() {
        return x.signum() == 0 && y.signum() == 0 && z.signum() == 0;
    }
}
