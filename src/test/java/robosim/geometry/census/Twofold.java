package robosim.geometry.census;

/**
 * A number as the sum of two doubles, some 100 bits (Dekker 1971; Knuth, The Art of Computer Programming 2, 4.2.2). For twins:
 * it shares no code with the product.
 */
record Twofold(double head, double tail) {
    static final Twofold ZERO = new Twofold(0, 0);
    static final Twofold ONE = new Twofold(1, 0);

    static Twofold of(double value) {
        return new Twofold(value, 0);
    }

    static Twofold difference(double a, double b) {
        return of(a).plus(of(-b));
    }

    private static Twofold quick(double a, double b) {
        double s = a + b;
        return new Twofold(s, b - (s - a));
    }

    Twofold plus(Twofold o) {
        double s = head + o.head;
        double v = s - head;
        double e = (head - (s - v)) + (o.head - v);
        double t = tail + o.tail;
        double w = t - tail;
        double f = (tail - (t - w)) + (o.tail - w);
        Twofold first = quick(s, e + t);
        return quick(first.head, first.tail + f);
    }

    Twofold negated() {
        return new Twofold(-head, -tail);
    }

    Twofold minus(Twofold o) {
        return plus(o.negated());
    }

    Twofold times(Twofold o) {
        double p = head * o.head;
        double e = Math.fma(head, o.head, -p);
        return quick(p, e + (head * o.tail + tail * o.head));
    }

    Twofold times(double o) {
        return times(of(o));
    }

    Twofold over(Twofold o) {
        double q = head / o.head;
        Twofold rest = minus(o.times(q));
        double r = rest.head / o.head;
        Twofold more = rest.minus(o.times(r));
        return quick(q, r).plus(of(more.head / o.head));
    }

    /** The root; of what is negative 0. */
    Twofold root() {
        if (!(head > 0)) {
            return ZERO;
        }
        double r = Math.sqrt(head);
        Twofold rest = minus(of(r).times(r));
        return quick(r, rest.head / (2 * r));
    }

    Twofold abs() {
        return signum() < 0 ? negated() : this;
    }

    int signum() {
        return head > 0 || (head == 0 && tail > 0) ? 1 : head < 0 || tail < 0 ? -1 : 0;
    }

    boolean isBelow(Twofold o) {
        return minus(o).signum() < 0;
    }

    /** A vector of such numbers. */
    record Vector(Twofold x, Twofold y, Twofold z) {
        static Vector of(double x, double y, double z) {
            return new Vector(Twofold.of(x), Twofold.of(y), Twofold.of(z));
        }

        Vector plus(Vector o) {
            return new Vector(x.plus(o.x), y.plus(o.y), z.plus(o.z));
        }

        Vector minus(Vector o) {
            return new Vector(x.minus(o.x), y.minus(o.y), z.minus(o.z));
        }

        Vector times(Twofold f) {
            return new Vector(x.times(f), y.times(f), z.times(f));
        }

        Twofold dot(Vector o) {
            return x.times(o.x).plus(y.times(o.y)).plus(z.times(o.z));
        }

        Vector cross(Vector o) {
            return new Vector(
                    y.times(o.z).minus(z.times(o.y)),
                    z.times(o.x).minus(x.times(o.z)),
                    x.times(o.y).minus(y.times(o.x)));
        }

        Twofold length() {
            return dot(this).root();
        }

        Vector unit() {
            Twofold length = length();
            return new Vector(x.over(length), y.over(length), z.over(length));
        }
    }
}
