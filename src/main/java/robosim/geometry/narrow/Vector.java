package robosim.geometry.narrow;

import robosim.geometry.exact.Dyadic;

/** Exact vectors of three, for the decisions that doubles could not make. */
record Vector(Dyadic x, Dyadic y, Dyadic z) {
    static Vector of(double x, double y, double z) {
        return new Vector(Dyadic.of(x), Dyadic.of(y), Dyadic.of(z));
    }

    /** Three numbers of a row, one after the other. */
    static Vector at(double[] row, int at) {
        return of(row[at], row[at + 1], row[at + 2]);
    }

    /** An own axis: a column of the rotation that begins at an index. */
    static Vector column(double[] row, int at) {
        return of(row[at], row[at + 3], row[at + 6]);
    }

    Vector plus(Vector v) {
        return new Vector(x.add(v.x), y.add(v.y), z.add(v.z));
    }

    Vector minus(Vector v) {
        return new Vector(x.subtract(v.x), y.subtract(v.y), z.subtract(v.z));
    }

    Vector times(Dyadic s) {
        return new Vector(x.multiply(s), y.multiply(s), z.multiply(s));
    }

    Vector negate() {
        return new Vector(x.negate(), y.negate(), z.negate());
    }

    Dyadic dot(Vector v) {
        return x.multiply(v.x).add(y.multiply(v.y)).add(z.multiply(v.z));
    }

    Dyadic square() {
        return dot(this);
    }

    Vector cross(Vector v) {
        return new Vector(
                y.multiply(v.z).subtract(z.multiply(v.y)),
                z.multiply(v.x).subtract(x.multiply(v.z)),
                x.multiply(v.y).subtract(y.multiply(v.x)));
    }

    boolean isZero() {
        return x.signum() == 0 && y.signum() == 0 && z.signum() == 0;
    }
}
