package robosim.geometry.reference;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.Kind;

/**
 * The signed distance of two convex objects at 80 digits, and its direction where that is unique: apart from the exact
 * nearest points of their hulls, overlapping from all planes through corners of one hull, or through an edge of each.
 *
 * @param direction a unit vector, off by no more than a double's rounding; null where several tie
 * @param apart     how far the hulls without their radii are apart; 0 where they overlap
 */
public record SignedTruth(BigDecimal signed, double @Nullable [] direction, double apart) {
    /** Directions less deep than the least by this may be the direction. */
    private static final double TIE = 1e-6;

    /** So many axes that are the same to rounding are evaluated exactly: those of a face have many, through any of its corners. */
    private static final int SAME = 6;

    /** Of two objects each of which is a box, sphere, capsule, triangle, or an upright cylinder. */
    public static SignedTruth of(GeometryObject a, GeometryObject b, Dimension dimension) {
        Gaps.Body one = Gaps.bodies(a).get(0);
        Gaps.Body other = Gaps.bodies(b).get(0);
        if (dimension == Dimension.PLANAR) {
            return swollen(one.outline(), other.outline(), one.radius().plus(other.radius()));
        }
        if (a.kind() != Kind.CYLINDER && b.kind() != Kind.CYLINDER) {
            return swollen(one.points(), other.points(), one.radius().plus(other.radius()));
        }
        return upright(one, other);
    }

    private static SignedTruth upright(Gaps.Body a, Gaps.Body b) {
        SignedTruth plane = swollen(a.outline(), b.outline(), a.radius().plus(b.radius()));
        BigDecimal up = a.low().minus(b.high()).toDecimal(Reference.DIGITS);
        BigDecimal down = b.low().minus(a.high()).toDecimal(Reference.DIGITS);
        double side = up.compareTo(down) >= 0 ? 1 : -1;
        BigDecimal height = up.max(down);
        double[] vertical = {0, side, 0};
        BigDecimal wide = plane.signed;
        if (wide.signum() > 0 && height.signum() > 0) {
            BigDecimal length = DecimalRoot.of(wide.multiply(wide).add(height.multiply(height)), Reference.DIGITS);
            double level = wide.divide(length, Reference.DIGITS).doubleValue();
            double rise = side * height.divide(length, Reference.DIGITS).doubleValue();
            double[] way = plane.direction;
            return new SignedTruth(length, way == null ? null : new double[] {level * way[0], rise, level * way[1]}, 1);
        }
        double[] level = plane.direction == null ? null : new double[] {plane.direction[0], 0, plane.direction[1]};
        boolean isTie = Math.abs(wide.doubleValue() - height.doubleValue()) < TIE;
        boolean isDouble = Math.abs(up.doubleValue() - down.doubleValue()) < TIE;
        return wide.compareTo(height) > 0
                ? new SignedTruth(wide, isTie ? null : level, plane.apart)
                : new SignedTruth(height, isTie || isDouble ? null : vertical, 0);
    }

    /** Of two hulls with a radius around them. */
    private static SignedTruth swollen(List<Rational[]> a, List<Rational[]> b, Rational radius) {
        Rational[] vector = new Nearest(a, b).vector();
        Rational square = Rational.dot(vector, vector);
        BigDecimal round = radius.toDecimal(Reference.DIGITS);
        if (square.signum() > 0) {
            BigDecimal distance = DecimalRoot.of(square.toDecimal(Reference.DIGITS), Reference.DIGITS);
            return new SignedTruth(distance.subtract(round), unit(vector, distance), distance.doubleValue());
        }
        SignedTruth core = depth(a, b);
        return new SignedTruth(core.signed.subtract(round), core.direction, 0);
    }

    private static double[] unit(Rational[] vector, BigDecimal length) {
        double[] unit = new double[vector.length];
        for (int k = 0; k < unit.length; k++) {
            unit[k] = vector[k]
                    .toDecimal(Reference.DIGITS)
                    .divide(length, Reference.DIGITS)
                    .doubleValue();
        }
        return unit;
    }

    private record Edge(Rational[] exact, double[] roughly) {}

    /** An axis across two edges, or one edge in the plane: roughly, and exactly when it is asked. */
    private record Axis(Rational[] u, Rational[] v, double[] roughly) {
        static void add(Edge first, Edge second, List<Axis> axes) {
            double[] p = first.roughly;
            double[] q = second.roughly;
            double[] cross = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
            double length = Math.sqrt(dot(cross, cross));
            // Crosses of edges that are parallel to rounding are sides of no shape.
            if (length > 1e-9 * Math.sqrt(dot(p, p) * dot(q, q))) {
                axes.add(new Axis(first.exact, second.exact, cross));
            }
        }

        double[] unit() {
            double length = Math.sqrt(dot(roughly, roughly));
            double[] unit = roughly.clone();
            for (int k = 0; k < unit.length; k++) {
                unit[k] /= length;
            }
            return unit;
        }

        Rational[] exactly(int sign) {
            Rational[] axis = u.length == 2
                    ? new Rational[] {u[1], u[0].negate()}
                    : new Rational[] {
                        u[1].times(v[2]).minus(u[2].times(v[1])),
                        u[2].times(v[0]).minus(u[0].times(v[2])),
                        u[0].times(v[1]).minus(u[1].times(v[0]))
                    };
            for (int k = 0; k < axis.length; k++) {
                axis[k] = sign < 0 ? axis[k].negate() : axis[k];
            }
            return axis;
        }
    }

    /** The least depth over all planes that may bound the difference of two hulls; 0 and no direction where it has none. */
    private static SignedTruth depth(List<Rational[]> a, List<Rational[]> b) {
        List<Axis> axes = a.get(0).length == 2 ? sides(a, b) : planes(a, b);
        List<double[]> roughA = a.stream().map(SignedTruth::doubles).toList();
        List<double[]> roughB = b.stream().map(SignedTruth::doubles).toList();
        double least = Double.POSITIVE_INFINITY;
        for (Axis axis : axes) {
            least = Math.min(least, Math.min(roughly(roughA, roughB, axis, 1), roughly(roughA, roughB, axis, -1)));
        }
        BigDecimal depth = null;
        double[] direction = null;
        boolean isUnique = true;
        int tried = 0;
        for (Axis axis : axes) {
            for (int sign = -1; sign <= 1; sign += 2) {
                if (roughly(roughA, roughB, axis, sign) > least + TIE
                        || (direction != null && tried >= SAME && sign * dot(axis.unit(), direction) > 1 - 1e-13)) {
                    continue;
                }
                tried++;
                Rational[] n = axis.exactly(sign);
                BigDecimal length = DecimalRoot.of(Rational.dot(n, n).toDecimal(Reference.DIGITS), Reference.DIGITS);
                BigDecimal exact = most(b, n)
                        .minus(least(a, n))
                        .toDecimal(Reference.DIGITS)
                        .divide(length, Reference.DIGITS);
                double[] unit = unit(n, length);
                isUnique &= direction == null || dot(direction, unit) > 1 - 1e-12;
                if (depth == null || exact.compareTo(depth) < 0) {
                    depth = exact;
                    direction = unit;
                }
            }
        }
        return new SignedTruth(depth == null ? BigDecimal.ZERO : depth.negate(), isUnique ? direction : null, 0);
    }

    private static double roughly(List<double[]> a, List<double[]> b, Axis axis, int sign) {
        double[] n = axis.roughly;
        double mostB = Double.NEGATIVE_INFINITY;
        double leastA = Double.POSITIVE_INFINITY;
        for (double[] point : b) {
            mostB = Math.max(mostB, sign * dot(n, point));
        }
        for (double[] point : a) {
            leastA = Math.min(leastA, sign * dot(n, point));
        }
        return (mostB - leastA) / Math.sqrt(dot(n, n));
    }

    private static double[] doubles(Rational[] point) {
        double[] numbers = new double[point.length];
        for (int k = 0; k < numbers.length; k++) {
            numbers[k] = point[k].toDecimal(MathContext.DECIMAL64).doubleValue();
        }
        return numbers;
    }

    private static double dot(double[] u, double[] v) {
        double sum = 0;
        for (int k = 0; k < u.length; k++) {
            sum += u[k] * v[k];
        }
        return sum;
    }

    private static Rational most(List<Rational[]> points, Rational[] axis) {
        return points.stream()
                .map(p -> Rational.dot(p, axis))
                .reduce(Rational::max)
                .orElseThrow();
    }

    private static Rational least(List<Rational[]> points, Rational[] axis) {
        return points.stream()
                .map(p -> Rational.dot(p, axis))
                .reduce((p, q) -> p.compareTo(q) <= 0 ? p : q)
                .orElseThrow();
    }

    private static List<Axis> sides(List<Rational[]> a, List<Rational[]> b) {
        List<Axis> axes = new ArrayList<>();
        for (List<Rational[]> hull : List.of(a, b)) {
            for (Edge edge : edges(hull)) {
                axes.add(new Axis(edge.exact, edge.exact, new double[] {edge.roughly[1], -edge.roughly[0]}));
            }
        }
        return axes;
    }

    private static List<Axis> planes(List<Rational[]> a, List<Rational[]> b) {
        List<Axis> axes = new ArrayList<>();
        List<Edge> edgesA = edges(a);
        List<Edge> edgesB = edges(b);
        for (List<Edge> edges : List.of(edgesA, edgesB)) {
            for (int i = 0; i < edges.size(); i++) {
                for (int j = i + 1; j < edges.size(); j++) {
                    Axis.add(edges.get(i), edges.get(j), axes);
                }
            }
        }
        for (Edge edge : edgesA) {
            for (Edge other : edgesB) {
                Axis.add(edge, other, axes);
            }
        }
        return axes;
    }

    /** Between any two corners: a segment within a hull is no harm, as no plane makes a depth too small. */
    private static List<Edge> edges(List<Rational[]> hull) {
        List<Edge> edges = new ArrayList<>();
        for (int i = 0; i < hull.size(); i++) {
            for (int j = i + 1; j < hull.size(); j++) {
                Rational[] edge = Rational.minus(hull.get(j), hull.get(i));
                if (Rational.dot(edge, edge).signum() > 0) {
                    edges.add(new Edge(edge, doubles(edge)));
                }
            }
        }
        return edges;
    }
}
