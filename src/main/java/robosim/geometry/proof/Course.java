package robosim.geometry.proof;

import java.util.Arrays;
import java.util.List;

/** A {@link Path} in plain doubles. */
final class Course {
    final double[][] rows;
    final double[] way;
    final double[] axis;
    final double[] pivot;
    final double cosine;
    final double end;

    private Course(double[][] rows, double[] way, double[] axis, double[] pivot, double cosine, double end) {
        this.rows = rows;
        this.way = way;
        this.axis = axis;
        this.pivot = pivot;
        this.cosine = cosine;
        this.end = end;
    }

    static Course along(double[][] rows, double[] way, double end) {
        return new Course(rows, way, new double[3], new double[3], 0, end);
    }

    static Course turn(double[][] rows, double[] axis, double[] pivot, double end) {
        return new Course(rows, new double[3], axis, pivot, 0, end);
    }

    static Course cone(double[] apex, double[] way, double cosine, double end) {
        double[] row = {apex[0], apex[1], apex[2], 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0};
        return new Course(new double[][] {row}, way, new double[3], new double[3], cosine, end);
    }

    boolean isTurn() {
        return axis[0] != 0 || axis[1] != 0 || axis[2] != 0;
    }

    /** Whether nothing moves, so that one moment is all. */
    boolean isStill() {
        return cosine == 0 && end == 0;
    }

    Path exact() {
        List<Piece> pieces = Arrays.stream(rows).map(Piece::new).toList();
        return new Path(pieces, vec(way), vec(axis), vec(pivot), Num.of(cosine), Num.of(end));
    }

    private static Vec vec(double[] v) {
        return Vec.of(v[0], v[1], v[2]);
    }

    /** Magnitudes that go into a product with a piece. */
    double size(int i) {
        return 2 * Rows.size(rows[i])
                + Math.abs(pivot[0])
                + Math.abs(pivot[1])
                + Math.abs(pivot[2])
                + end * (cosine > 0 ? 1 : Rows.length(way));
    }

    /** The largest product of a normal with a piece from one parameter to another. */
    double top(int i, double[] n, double from, double to) {
        double[] row = rows[i];
        if (cosine > 0) {
            return Rows.dot(row, 0, n) + sector(n);
        }
        if (!isTurn()) {
            double rate = Rows.product(n, way);
            return Rows.most(row, n) + Math.max(rate * from, rate * to);
        }
        double length = Rows.length(axis);
        double[] turned = {2 * StrictMath.atan(from * length), 2 * StrictMath.atan(to * length)};
        double most = Double.NEGATIVE_INFINITY;
        for (double[] corner : Rows.corners(row)) {
            double[] x = {corner[0] - pivot[0], corner[1] - pivot[1], corner[2] - pivot[2]};
            most = Math.max(most, sinusoid(x, n, turned, length, 1));
        }
        double round = row.length == 9
                ? 0
                : isTurningDisc(row) ? Rows.round(row, n, along(i, n, from, to)) : Rows.round(row, n);
        return most + Rows.product(n, pivot) + round;
    }

    /** A number that the product of a normal with the axis of a turning disc is never nearer to 0 than; 0 if it is no use. */
    double along(int i, double[] n, double from, double to) {
        double[] row = rows[i];
        if (row.length == 9 || row[15] == 0) {
            return 0;
        }
        double[] up = {row[4], row[7], row[10]};
        if (!isTurningDisc(row)) {
            return Rows.product(up, n);
        }
        double length = Rows.length(axis);
        double[] turned = {2 * StrictMath.atan(from * length), 2 * StrictMath.atan(to * length)};
        double high = sinusoid(up, n, turned, length, 1);
        double low = -sinusoid(up, n, turned, length, -1);
        double spare = 0x1p-45;
        return low > spare ? low - spare : high < -spare ? high + spare : 0;
    }

    /** Whether it is a disc whose axis turns. */
    private boolean isTurningDisc(double[] row) {
        double[] across = Rows.cross(new double[] {row[4], row[7], row[10]}, axis);
        return row[15] > 0 && (across[0] != 0 || across[1] != 0 || across[2] != 0);
    }

    /** The largest of the product of a normal, times a sign, with a vector that turns. */
    private double sinusoid(double[] x, double[] n, double[] turned, double length, int sign) {
        double share = Rows.product(axis, x) / (length * length);
        double fixed = sign * share * Rows.product(n, axis);
        double cos = sign * Rows.product(n, x) - fixed;
        double sin = sign * Rows.product(n, Rows.cross(axis, x)) / length;
        double peak = StrictMath.atan2(sin, cos);
        peak = peak < 0 ? peak + 2 * Math.PI : peak;
        if (peak >= turned[0] && peak <= turned[1]) {
            return fixed + StrictMath.hypot(sin, cos);
        }
        return fixed
                + Math.max(
                        cos * StrictMath.cos(turned[0]) + sin * StrictMath.sin(turned[0]),
                        cos * StrictMath.cos(turned[1]) + sin * StrictMath.sin(turned[1]));
    }

    /** Writes a point with the largest product with a normal of length 1, of what does not turn. */
    void support(int i, double[] n, double from, double to, double[] out) {
        Rows.support(rows[i], n, out);
        double[] far = new double[3];
        if (cosine == 0) {
            double t = Rows.product(n, way) > 0 ? to : from;
            far = new double[] {t * way[0], t * way[1], t * way[2]};
        } else if (sector(n) > 0) {
            double[] u = Rows.unit(way);
            double ahead = Rows.product(n, u);
            double[] aside = Rows.unit(new double[] {n[0] - ahead * u[0], n[1] - ahead * u[1], n[2] - ahead * u[2]});
            double sine = Math.sqrt((1 - cosine) * (1 + cosine));
            for (int k = 0; k < 3; k++) {
                far[k] = end * (ahead >= cosine ? n[k] : cosine * u[k] + sine * aside[k]);
            }
        }
        for (int k = 0; k < 3; k++) {
            out[k] += far[k];
        }
    }

    private double sector(double[] n) {
        double[] u = Rows.unit(way);
        double ahead = Rows.product(n, u);
        double length = Rows.length(n);
        if (ahead >= cosine * length) {
            return end * length;
        }
        double aside = Rows.length(Rows.cross(n, u));
        return Math.max(0, end * (ahead * cosine + aside * Math.sqrt((1 - cosine) * (1 + cosine))));
    }

    /** The same of a single piece, without heights. */
    Course level(int i) {
        return new Course(
                new double[][] {Rows.level(rows[i])}, new double[] {way[0], 0, way[2]}, axis, pivot, cosine, end);
    }

    /** A piece where it is at a parameter. */
    double[] at(int i, double t) {
        double[] row = rows[i].clone();
        if (!isTurn()) {
            for (int k = 0; k < (row.length == 9 ? 9 : 3); k++) {
                row[k] += t * way[k % 3];
            }
            return row;
        }
        if (row.length == 9) {
            for (int k = 0; k < 9; k += 3) {
                double[] x = turned(new double[] {row[k] - pivot[0], row[k + 1] - pivot[1], row[k + 2] - pivot[2]}, t);
                for (int axis = 0; axis < 3; axis++) {
                    row[k + axis] = x[axis] + pivot[axis];
                }
            }
            return row;
        }
        double[] x = turned(new double[] {row[0] - pivot[0], row[1] - pivot[1], row[2] - pivot[2]}, t);
        for (int k = 0; k < 3; k++) {
            row[k] = x[k] + pivot[k];
        }
        for (int column = 0; column < 3; column++) {
            double[] v = turned(new double[] {row[3 + column], row[6 + column], row[9 + column]}, t);
            for (int k = 0; k < 3; k++) {
                row[3 + 3 * k + column] = v[k];
            }
        }
        return row;
    }

    private double[] turned(double[] x, double t) {
        double[] w = Rows.cross(axis, x);
        double[] v = Rows.cross(axis, w);
        double over = 2 / (1 + t * t * Rows.product(axis, axis));
        double[] out = new double[3];
        for (int k = 0; k < 3; k++) {
            out[k] = x[k] + over * (t * w[k] + t * t * v[k]);
        }
        return out;
    }
}
