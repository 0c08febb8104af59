package robosim.geometry.census;

import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.Twofold;
import robosim.geometry.reference.Twofold.Vector;

/**
 * The distance of a cylinder in a cone from both sides, by a search that knows nothing of caps and mantles: the largest
 * {@code k(n) / s(n)} over all directions, whose sets of large values are convex, by golden sections within golden sections;
 * and the least of the border's rays beside the one that leads to. Both ends are then evaluated in {@link Twofold}s.
 */
final class CylinderConeTwin {
    private static final double GOLDEN = 0.6180339887498949;
    private static final double FLAT = 1e-7;

    private final double[] u;
    private final double cos;
    private final double sin;
    private final double[] m = new double[3];
    private final double[] a;
    private final double radius;
    private final double half;
    private final Vector exactAxis;
    private final Vector exactCenter;
    private final Vector exactWay;
    private final Twofold exactCos;
    private final Twofold exactSin;
    private final Twofold exactHalf;

    private final double[] e = new double[3];
    private final double[] f = new double[3];
    private final double[] n = new double[3];
    private final double[] best = new double[3];
    private double most;
    private double scale;

    /** Both ends; the lower is infinite where a plane proves silence, the upper where no common point was found. */
    double low;

    double high = Double.POSITIVE_INFINITY;

    /** Whether the cone holds the cylinder's own nearest point. */
    boolean isFoot;

    /** Which part of the cylinder the best direction touches. */
    boolean isCap;

    boolean isMantle;

    /** Where the apex is. */
    boolean isBetween;

    boolean isWithin;

    CylinderConeTwin(ConeQuestion q) {
        boolean isUpright = q.kind == LeafKind.UPRIGHT_CYLINDER;
        double[] row = q.row;
        double[] axis = isUpright ? new double[] {0, 1, 0} : new double[] {row[7], row[10], row[13]};
        Vector long3 = Vector.of(axis[0], axis[1], axis[2]);
        exactAxis = long3.unit();
        exactHalf = long3.length().times(row[4]);
        exactCenter = new Vector(
                Twofold.difference(row[0], q.apex[0]),
                Twofold.difference(row[1], q.apex[1]),
                Twofold.difference(row[2], q.apex[2]));
        exactWay = Vector.of(q.way[0], q.way[1], q.way[2]).unit();
        exactCos = Twofold.of(q.cos);
        exactSin = Twofold.difference(1, q.cos)
                .times(Twofold.difference(1, -q.cos))
                .root();
        u = heads(exactWay);
        a = heads(exactAxis);
        System.arraycopy(heads(exactCenter), 0, m, 0, 3);
        cos = q.cos;
        sin = exactSin.head();
        radius = row[3];
        half = exactHalf.head();
        solve();
    }

    private static double[] heads(Vector v) {
        return new double[] {v.x().head(), v.y().head(), v.z().head()};
    }

    private void solve() {
        foot();
        double size = Math.sqrt(dot(m, m));
        scale = size + radius + half;
        if (high < Double.POSITIVE_INFINITY) {
            return;
        }
        if (!(size > 0)) {
            return;
        }
        perpendicular(m, size);
        most = Double.NEGATIVE_INFINITY;
        double from = -1;
        double to = 1;
        double left = to - GOLDEN * (to - from);
        double right = from + GOLDEN * (to - from);
        double atLeft = along(left);
        double atRight = along(right);
        for (int i = 0; i < 44; i++) {
            if (atLeft >= atRight) {
                to = right;
                right = left;
                atRight = atLeft;
                left = to - GOLDEN * (to - from);
                atLeft = along(left);
            } else {
                from = left;
                left = right;
                atLeft = atRight;
                right = from + GOLDEN * (to - from);
                atRight = along(right);
            }
        }
        Vector found = Vector.of(best[0], best[1], best[2]);
        Twofold part = found.dot(exactAxis);
        Vector across = found.minus(exactAxis.times(part));
        Twofold length = found.length();
        isCap = across.length().head() <= FLAT * length.head();
        isMantle = Math.abs(part.head()) <= FLAT * length.head();
        bound(found);
        bound(exactAxis);
        bound(exactAxis.times(Twofold.of(-1)));
        if (across.length().head() > 0) {
            bound(across);
            if (isMantle) {
                around(across);
            }
        }
        border();
        rays();
    }

    // The cylinder's own nearest point, and whether the cone holds it.
    private void foot() {
        Twofold along = exactCenter.dot(exactAxis);
        Vector away = exactCenter.minus(exactAxis.times(along));
        Twofold distance = away.length();
        isBetween = !exactHalf.isBelow(along.abs());
        isWithin = !Twofold.of(radius).isBelow(distance);
        Twofold kept = isBetween ? Twofold.ZERO : along.signum() > 0 ? along.minus(exactHalf) : along.plus(exactHalf);
        Vector point = exactAxis.times(kept);
        if (!isWithin) {
            point = point.plus(away.times(distance.minus(Twofold.of(radius)).over(distance)));
        }
        low = Math.nextDown(point.length().head() * (1 - 0x1p-52));
        if (isBetween && isWithin) {
            low = 0;
            high = 0;
            return;
        }
        Twofold ahead = point.dot(exactWay);
        Twofold aside = point.cross(exactWay).length();
        isFoot = aside.times(exactCos).minus(ahead.times(exactSin)).signum() <= 0;
        if (isFoot) {
            high = Math.nextUp(point.length().head() * (1 + 0x1p-52));
        }
    }

    private void perpendicular(double[] v, double size) {
        int least = Math.abs(v[0]) < Math.abs(v[1])
                ? (Math.abs(v[0]) < Math.abs(v[2]) ? 0 : 2)
                : (Math.abs(v[1]) < Math.abs(v[2]) ? 1 : 2);
        double[] x = new double[3];
        x[least] = 1;
        cross(v, x, e);
        double length = Math.sqrt(dot(e, e));
        for (int k = 0; k < 3; k++) {
            e[k] /= length;
        }
        cross(v, e, f);
        for (int k = 0; k < 3; k++) {
            f[k] /= size;
        }
    }

    // The greatest value on the great circle of an angle about the centre's direction: both angles as shares from -1 to
    // 1.
    private double along(double share) {
        double from = -1;
        double to = 1;
        double left = to - GOLDEN * (to - from);
        double right = from + GOLDEN * (to - from);
        double atLeft = value(share, left);
        double atRight = value(share, right);
        for (int i = 0; i < 42; i++) {
            if (atLeft >= atRight) {
                to = right;
                right = left;
                atRight = atLeft;
                left = to - GOLDEN * (to - from);
                atLeft = value(share, left);
            } else {
                from = left;
                left = right;
                atLeft = atRight;
                right = from + GOLDEN * (to - from);
                atRight = value(share, right);
            }
        }
        return Math.max(atLeft, atRight);
    }

    private double value(double first, double second) {
        double x = first / (1 - first * first);
        double y = second / (1 - second * second) * Math.sqrt(1 + x * x);
        double size = Math.sqrt(dot(m, m));
        for (int k = 0; k < 3; k++) {
            n[k] = m[k] / size + x * e[k] + y * f[k];
        }
        double part = dot(n, a);
        double square = dot(n, n);
        double k = dot(n, m) - radius * Math.sqrt(Math.max(0, square - part * part)) - half * Math.abs(part);
        double result = k;
        if (k > 0) {
            double ahead = dot(n, u);
            double aside = Math.sqrt(Math.max(0, square - ahead * ahead));
            double s = cos * aside <= sin * ahead ? Math.sqrt(square) : cos * ahead + sin * aside;
            result = s > 0 ? Math.min(1e300, k / s) : 1e300;
        }
        if (result > most) {
            most = result;
            System.arraycopy(n, 0, best, 0, 3);
        }
        return result;
    }

    private void bound(Vector v) {
        Twofold part = v.dot(exactAxis);
        Twofold k = v.dot(exactCenter)
                .minus(v.cross(exactAxis).length().times(radius))
                .minus(part.abs().times(exactHalf));
        double size = v.length().head();
        double error = 0x1p-92 * scale * size;
        if (!(k.head() > error)) {
            return;
        }
        Twofold ahead = v.dot(exactWay);
        Twofold aside = v.cross(exactWay).length();
        boolean isIn = aside.times(exactCos).minus(ahead.times(exactSin)).signum() <= 0;
        Twofold s = isIn ? v.length() : ahead.times(exactCos).plus(aside.times(exactSin));
        double support = s.head() + 0x1p-92 * size;
        double value = support > 0 ? (k.head() - error) / support : Double.POSITIVE_INFINITY;
        low = Math.max(low, value > 2 * scale ? Double.POSITIVE_INFINITY : value * (1 - 0x1p-51));
    }

    // Beside a direction across the axis, in ever smaller steps.
    private void around(Vector start) {
        Vector at = start.unit();
        Vector turn = exactAxis.cross(at);
        double before = low;
        for (double step = 1e-6; step > 1e-15; step *= 0.5) {
            for (int sign = -1; sign <= 1; sign += 2) {
                Vector next = at.plus(turn.times(Twofold.of(sign * step)));
                bound(next);
                if (low > before) {
                    before = low;
                    at = next;
                    turn = exactAxis.cross(at);
                }
            }
            if (low == Double.POSITIVE_INFINITY) {
                return;
            }
        }
    }

    // The planes that touch the cone beside the best direction: one of them may prove silence where that is all but a
    // plane.
    private void border() {
        Vector v = Vector.of(best[0], best[1], best[2]);
        Vector side = v.minus(exactWay.times(v.dot(exactWay)));
        if (side.length().head() > 0) {
            bound(side.unit().times(exactCos).minus(exactWay.times(exactSin)));
        }
    }

    // The rays of the border beside the one that is nearest to the best direction.
    private void rays() {
        double ahead = dot(best, u);
        double[] x = new double[3];
        double[] y = new double[3];
        for (int k = 0; k < 3; k++) {
            x[k] = best[k] - ahead * u[k];
        }
        double size = Math.sqrt(dot(x, x));
        if (!(size > 0)) {
            return;
        }
        for (int k = 0; k < 3; k++) {
            x[k] /= size;
        }
        cross(u, x, y);
        double center = 0;
        double least = entry(x, y, 0);
        for (double width = 1e-2; width > 1e-12; width *= 1e-2) {
            double from = center - width;
            double to = center + width;
            for (int i = 0; i < 34; i++) {
                double left = to - GOLDEN * (to - from);
                double right = from + GOLDEN * (to - from);
                double atLeft = entry(x, y, left);
                double atRight = entry(x, y, right);
                if (Math.min(atLeft, atRight) < least) {
                    least = Math.min(atLeft, atRight);
                    center = atLeft < atRight ? left : right;
                }
                if (atLeft < atRight || (atLeft == atRight && center < (from + to) / 2)) {
                    to = right;
                } else {
                    from = left;
                }
            }
        }
        if (least < Double.POSITIVE_INFINITY) {
            for (double off : new double[] {0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-9, -1e-9}) {
                exactEntry(x, y, center + off);
            }
        }
    }

    // Where the ray of the border at an angle enters the cylinder, in doubles.
    private double entry(double[] x, double[] y, double angle) {
        double c = Math.cos(angle);
        double s = Math.sin(angle);
        double[] v = n;
        for (int k = 0; k < 3; k++) {
            v[k] = cos * u[k] + sin * (c * x[k] + s * y[k]);
        }
        double va = dot(v, a);
        double ma = dot(m, a);
        double near = Double.NEGATIVE_INFINITY;
        double far = Double.POSITIVE_INFINITY;
        if (va != 0) {
            near = (ma - Math.copySign(half, va)) / va;
            far = (ma + Math.copySign(half, va)) / va;
        } else if (Math.abs(ma) > half) {
            return Double.POSITIVE_INFINITY;
        }
        double square = 1 - va * va;
        double b = dot(v, m) - va * ma;
        double c0 = dot(m, m) - ma * ma - radius * radius;
        double under = b * b - square * c0;
        if (!(under >= 0) || !(square > 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double root = Math.sqrt(under);
        near = Math.max(near, (b - root) / square);
        far = Math.min(far, (b + root) / square);
        return near <= far && near >= 0 ? near : Double.POSITIVE_INFINITY;
    }

    // The same in Twofolds, where it is certain to be in both.
    private void exactEntry(double[] x, double[] y, double angle) {
        double c = StrictMath.cos(angle);
        double s = StrictMath.sin(angle);
        Vector side = Vector.of(c * x[0] + s * y[0], c * x[1] + s * y[1], c * x[2] + s * y[2]);
        side = side.minus(exactWay.times(side.dot(exactWay))).unit();
        Vector v = exactWay.times(exactCos).plus(side.times(exactSin));
        Twofold va = v.dot(exactAxis);
        Twofold ma = exactCenter.dot(exactAxis);
        Twofold b = v.dot(exactCenter).minus(va.times(ma));
        Twofold square = Twofold.ONE.minus(va.times(va));
        Vector across = exactCenter.minus(exactAxis.times(ma));
        Twofold c0 = across.dot(across).minus(Twofold.of(radius).times(radius));
        Twofold under = b.times(b).minus(square.times(c0));
        if (under.signum() < 0 || !(square.head() > 0)) {
            return;
        }
        Twofold near = b.minus(under.root()).over(square);
        Twofold far = b.plus(under.root()).over(square);
        if (va.signum() != 0) {
            Twofold h = va.signum() > 0 ? exactHalf : exactHalf.negated();
            Twofold in = ma.minus(h).over(va);
            Twofold out = ma.plus(h).over(va);
            near = near.isBelow(in) ? in : near;
            far = out.isBelow(far) ? out : far;
        }
        if (!far.isBelow(near) && near.signum() >= 0) {
            high = Math.min(high, Math.nextUp(near.head() * (1 + 0x1p-52)));
        }
    }

    private static double dot(double[] p, double[] q) {
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    }

    private static void cross(double[] p, double[] q, double[] out) {
        out[0] = p[1] * q[2] - p[2] * q[1];
        out[1] = p[2] * q[0] - p[0] * q[2];
        out[2] = p[0] * q[1] - p[1] * q[0];
    }
}
