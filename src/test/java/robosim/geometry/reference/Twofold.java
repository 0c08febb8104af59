package robosim.geometry.reference;

/**
 * A number as the sum of two doubles, some 100 bits (Dekker 1971; Knuth, The Art of Computer Programming 2, 4.2.2). For twins:
 * it shares no code with the product.
 */
public record Twofold(double head, double tail) {
    public static final Twofold ZERO = new Twofold(0, 0);
    public static final Twofold ONE = new Twofold(1, 0);

    public static Twofold of(double value) {
        return new Twofold(value, 0);
    }

    public static Twofold difference(double a, double b) {
        return of(a).plus(of(-b));
    }

    private static Twofold quick(double a, double b) {
        double s = a + b;
        return new Twofold(s, b - (s - a));
    }

    public Twofold plus(Twofold o) {
        double s = head + o.head;
        double v = s - head;
        double e = (head - (s - v)) + (o.head - v);
        double t = tail + o.tail;
        double w = t - tail;
        double f = (tail - (t - w)) + (o.tail - w);
        Twofold first = quick(s, e + t);
        return quick(first.head, first.tail + f);
    }

    public Twofold negated() {
        return new Twofold(-head, -tail);
    }

    public Twofold minus(Twofold o) {
        return plus(o.negated());
    }

    public Twofold times(Twofold o) {
        double p = head * o.head;
        double e = Math.fma(head, o.head, -p);
        return quick(p, e + (head * o.tail + tail * o.head));
    }

    public Twofold times(double o) {
        return times(of(o));
    }

    public Twofold over(Twofold o) {
        double q = head / o.head;
        Twofold rest = minus(o.times(q));
        double r = rest.head / o.head;
        Twofold more = rest.minus(o.times(r));
        return quick(q, r).plus(of(more.head / o.head));
    }

    /** The root; of what is negative 0. */
    public Twofold root() {
        if (!(head > 0)) {
            return ZERO;
        }
        double r = Math.sqrt(head);
        Twofold rest = minus(of(r).times(r));
        return quick(r, rest.head / (2 * r));
    }

    public Twofold abs() {
        return signum() < 0 ? negated() : this;
    }

    public int signum() {
        return head > 0 || (head == 0 && tail > 0) ? 1 : head < 0 || tail < 0 ? -1 : 0;
    }

    public boolean isBelow(Twofold o) {
        return minus(o).signum() < 0;
    }

    /** A vector of such numbers. */
    public record Vector(Twofold x, Twofold y, Twofold z) {
        public static Vector of(double x, double y, double z) {
            return new Vector(Twofold.of(x), Twofold.of(y), Twofold.of(z));
        }

        public Vector plus(Vector o) {
            return new Vector(x.plus(o.x), y.plus(o.y), z.plus(o.z));
        }

        public Vector minus(Vector o) {
            return new Vector(x.minus(o.x), y.minus(o.y), z.minus(o.z));
        }

        public Vector times(Twofold f) {
            return new Vector(x.times(f), y.times(f), z.times(f));
        }

        public Twofold dot(Vector o) {
            return x.times(o.x).plus(y.times(o.y)).plus(z.times(o.z));
        }

        public Vector cross(Vector o) {
            return new Vector(
                    y.times(o.z).minus(z.times(o.y)),
                    z.times(o.x).minus(x.times(o.z)),
                    x.times(o.y).minus(y.times(o.x)));
        }

        public Twofold length() {
            return dot(this).root();
        }

        public Vector unit() {
            Twofold length = length();
            return new Vector(x.over(length), y.over(length), z.over(length));
        }
    }
}
