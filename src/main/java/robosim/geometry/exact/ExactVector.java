package robosim.geometry.exact;

/** A vector of three exact numbers, for decisions that doubles leave open. */
public record ExactVector(Dyadic x, Dyadic y, Dyadic z) {
    static final ExactVector ZERO = new ExactVector(Dyadic.ZERO, Dyadic.ZERO, Dyadic.ZERO);

    public static ExactVector of(double x, double y, double z) {
        return new ExactVector(Dyadic.of(x), Dyadic.of(y), Dyadic.of(z));
    }

    /** A vector of three consecutive numbers of an array. */
    public static ExactVector at(double[] row, int at) {
        return of(row, at, 1);
    }

    /** An object's own axis: a column of the rotation matrix, given the index of the column's first number. */
    public static ExactVector column(double[] row, int at) {
        return of(row, at, 3);
    }

    /** A vector of three numbers of an array, from {@code at} on, {@code step} apart. */
    public static ExactVector of(double[] row, int at, int step) {
        return of(row[at], row[at + step], row[at + 2 * step]);
    }

    public ExactVector plus(ExactVector o) {
        return new ExactVector(x.add(o.x), y.add(o.y), z.add(o.z));
    }

    public ExactVector minus(ExactVector o) {
        return new ExactVector(x.subtract(o.x), y.subtract(o.y), z.subtract(o.z));
    }

    public ExactVector times(Dyadic factor) {
        return new ExactVector(x.multiply(factor), y.multiply(factor), z.multiply(factor));
    }

    public ExactVector negate() {
        return new ExactVector(x.negate(), y.negate(), z.negate());
    }

    public ExactVector scale(int power) {
        return new ExactVector(x.scale(power), y.scale(power), z.scale(power));
    }

    public Dyadic dot(ExactVector o) {
        return x.multiply(o.x).add(y.multiply(o.y)).add(z.multiply(o.z));
    }

    public Dyadic square() {
        return dot(this);
    }

    public ExactVector cross(ExactVector o) {
        return new ExactVector(
                y.multiply(o.z).subtract(z.multiply(o.y)),
                z.multiply(o.x).subtract(x.multiply(o.z)),
                x.multiply(o.y).subtract(y.multiply(o.x)));
    }

    public boolean isZero() {
        return x.signum() == 0 && y.signum() == 0 && z.signum() == 0;
    }
}
