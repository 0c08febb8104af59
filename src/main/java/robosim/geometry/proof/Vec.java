package robosim.geometry.proof;

import robosim.geometry.model.Point;

/** Three exact numbers. */
record Vec(Num x, Num y, Num z) {
    static final Vec ZERO = new Vec(Num.ZERO, Num.ZERO, Num.ZERO);

    static Vec of(double x, double y, double z) {
        return new Vec(Num.of(x), Num.of(y), Num.of(z));
    }

    static Vec of(Point p) {
        return of(p.x(), p.y(), p.z());
    }

    Vec plus(Vec o) {
        return new Vec(x.plus(o.x), y.plus(o.y), z.plus(o.z));
    }

    Vec minus(Vec o) {
        return new Vec(x.minus(o.x), y.minus(o.y), z.minus(o.z));
    }

    Vec times(Num f) {
        return new Vec(x.times(f), y.times(f), z.times(f));
    }

    Vec negate() {
        return new Vec(x.negate(), y.negate(), z.negate());
    }

    /** The same at height 0. */
    Vec level() {
        return new Vec(x, Num.ZERO, z);
    }

    Num dot(Vec o) {
        return x.times(o.x).plus(y.times(o.y)).plus(z.times(o.z));
    }

    Vec cross(Vec o) {
        return new Vec(
                y.times(o.z).minus(z.times(o.y)),
                z.times(o.x).minus(x.times(o.z)),
                x.times(o.y).minus(y.times(o.x)));
    }

    boolean isZero() {
        return x.sign() == 0 && y.sign() == 0 && z.sign() == 0;
    }
}
