package robosim.geometry.reference;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.Kind;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/**
 * What {@link Reference} knows, and further: how far apart two objects are, and where on a straight way they first
 * touch. A solid mesh is taken for the hull of its corners, which is only right where it is convex; a cylinder that does
 * not stand upright is known beside a ball.
 */
public final class Gaps {
    private Gaps() {}

    /** Convex: the hull of points, swollen by a radius to all sides or, where it is a disc, to the sides only. */
    record Body(List<Rational[]> points, Rational radius, boolean disc, boolean ball, boolean straight) {
        Rational low() {
            return points.stream()
                    .map(p -> p[1])
                    .reduce((p, q) -> p.compareTo(q) <= 0 ? p : q)
                    .orElseThrow();
        }

        Rational high() {
            return points.stream().map(p -> p[1]).reduce(Rational::max).orElseThrow();
        }

        Box box() {
            return Box.around(points, radius);
        }

        Reference.Piece piece() {
            return new Reference.Piece(points, radius, ball);
        }

        boolean leans() {
            return ball && piece().leans();
        }

        List<Rational[]> outline() {
            return points.stream().map(Reference::flat).toList();
        }
    }

    /** Whether two objects touch or overlap. */
    public static boolean overlap(GeometryObject a, GeometryObject b, Dimension dimension) {
        if (isLyingCylinder(a) || isLyingCylinder(b)) {
            return distance(a, b, dimension).signum() == 0;
        }
        List<Reference.Piece> others = pieces(b);
        boolean planar = dimension == Dimension.PLANAR;
        List<Box> boxes = others.stream()
                .map(other -> Box.around(other.points(), other.radius()))
                .toList();
        for (Reference.Piece one : pieces(a)) {
            Box box = Box.around(one.points(), one.radius());
            for (int k = 0; k < boxes.size(); k++) {
                if (box.apart(boxes.get(k), planar) == 0 && Reference.meet(one, others.get(k), dimension)) {
                    return true;
                }
            }
        }
        return false;
    }

    private static List<Reference.Piece> pieces(GeometryObject object) {
        if (object instanceof MeshObject mesh && mesh.isSolid()) {
            MeshObject surface = new MeshObject(mesh.vertices(), mesh.faces()).at(mesh.pose());
            List<Rational[]> corners = new ArrayList<>();
            Reference.pieces(surface).forEach(face -> corners.addAll(face.points()));
            return List.of(new Reference.Piece(corners, Rational.of(-1), false));
        }
        return Reference.pieces(object);
    }

    private static boolean isLyingCylinder(GeometryObject object) {
        return object.kind() == Kind.CYLINDER && Math.abs(object.rotation()[4]) != 1;
    }

    static List<Body> bodies(GeometryObject object) {
        boolean straight =
                object.kind() == Kind.CYLINDER || (object instanceof BoxObject && Math.abs(object.rotation()[4]) == 1);
        List<Body> bodies = new ArrayList<>();
        List<Reference.Piece> pieces = pieces(object);
        if (isCapsule(pieces)) {
            List<Rational[]> ends = List.of(
                    pieces.get(1).points().get(0), pieces.get(2).points().get(0));
            return List.of(new Body(ends, pieces.get(0).radius(), false, true, false));
        }
        for (Reference.Piece piece : pieces) {
            boolean disc = piece.round() && !piece.ball();
            bodies.add(new Body(piece.points(), piece.radius().max(Rational.ZERO), disc, piece.ball(), straight));
        }
        return bodies;
    }

    /** A cylinder and two balls at its ends, in this order, up to a rounding of where it ends. */
    private static boolean isCapsule(List<Reference.Piece> pieces) {
        if (pieces.size() != 3
                || pieces.get(0).ball()
                || !pieces.get(1).ball()
                || !pieces.get(2).ball()) {
            return false;
        }
        Reference.Piece axis = pieces.get(0);
        boolean same = true;
        for (int end = 0; end < 2; end++) {
            same &= pieces.get(1 + end).radius().equals(axis.radius());
            Rational[] off = Rational.minus(
                    pieces.get(1 + end).points().get(0), axis.points().get(end));
            same &= Rational.dot(off, off)
                            .compareTo(axis.radius().times(Rational.of(0x1p-44)).square())
                    <= 0;
        }
        return same;
    }

    /** The least distance between two objects at 80 digits, 0 where they touch or overlap. */
    public static BigDecimal distance(GeometryObject a, GeometryObject b, Dimension dimension) {
        if (isLyingCylinder(a) || isLyingCylinder(b)) {
            return isLyingCylinder(a) ? ballAndCylinder(b, a, dimension) : ballAndCylinder(a, b, dimension);
        }
        record Pair(Body one, Body other, double atLeast) {}
        boolean planar = dimension == Dimension.PLANAR;
        List<Pair> pairs = new ArrayList<>();
        for (Body one : bodies(a)) {
            for (Body other : bodies(b)) {
                pairs.add(new Pair(one, other, one.box().apart(other.box(), planar)));
            }
        }
        pairs.sort(Comparator.comparingDouble(Pair::atLeast));
        BigDecimal least = null;
        for (Pair pair : pairs) {
            if (least == null || pair.atLeast <= least.doubleValue() * 1.001) {
                BigDecimal gap = distance(pair.one, pair.other, planar);
                least = least == null ? gap : least.min(gap);
            }
        }
        return least;
    }

    /** A box around something, a little too large: to leave out what can not be the nearest. */
    private record Box(double[] low, double[] high) {
        static Box around(List<Rational[]> points, Rational radius) {
            double swollen = Math.max(0, rounded(radius));
            double[] low = new double[3];
            double[] high = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                int k = axis;
                double[] along = points.stream().mapToDouble(p -> rounded(p[k])).toArray();
                double least = Arrays.stream(along).min().orElseThrow() - swollen;
                double most = Arrays.stream(along).max().orElseThrow() + swollen;
                double rounding = 1e-12 * (Math.abs(least) + Math.abs(most) + swollen);
                low[k] = least - rounding;
                high[k] = most + rounding;
            }
            return new Box(low, high);
        }

        private static double rounded(Rational number) {
            return number.toDecimal(MathContext.DECIMAL64).doubleValue();
        }

        /** How far two boxes are apart, or less. */
        double apart(Box that, boolean planar) {
            double most = 0;
            for (int axis = 0; axis < 3; axis += planar ? 2 : 1) {
                most = Math.max(most, Math.max(low[axis] - that.high[axis], that.low[axis] - high[axis]));
            }
            return most;
        }
    }

    private static BigDecimal distance(Body a, Body b, boolean planar) {
        if (planar) {
            return less(new Nearest(a.outline(), b.outline()).square(), a.radius.plus(b.radius));
        }
        if (!a.disc && !b.disc) {
            return less(new Nearest(a.points, b.points).square(), a.radius.plus(b.radius));
        }
        if (a.leans() || b.leans()) {
            return a.ball ? Reference.besideDisc(a.piece(), b.piece()) : Reference.besideDisc(b.piece(), a.piece());
        }
        boolean ballBeside = a.ball || b.ball;
        if (!ballBeside && !(a.straight && b.straight)) {
            throw new IllegalArgumentException("cylinder must be beside what stands upright or a ball");
        }
        Rational up = a.low().minus(b.high()).max(b.low().minus(a.high())).max(Rational.ZERO);
        Rational side = ballBeside ? (a.disc ? a.radius : b.radius) : a.radius.plus(b.radius);
        BigDecimal aside = less(new Nearest(a.outline(), b.outline()).square(), side);
        BigDecimal square = aside.multiply(aside).add(up.square().toDecimal(Reference.DIGITS));
        Rational ball = ballBeside ? (a.disc ? b.radius : a.radius) : Rational.ZERO;
        return DecimalRoot.of(square, Reference.DIGITS)
                .subtract(ball.toDecimal(Reference.DIGITS))
                .max(BigDecimal.ZERO);
    }

    /** A root less a radius; exactly 0 where the radius reaches. */
    private static BigDecimal less(Rational square, Rational radius) {
        if (square.compareTo(radius.square()) <= 0) {
            return BigDecimal.ZERO;
        }
        return DecimalRoot.of(square.toDecimal(Reference.DIGITS), Reference.DIGITS)
                .subtract(radius.toDecimal(Reference.DIGITS));
    }

    private static BigDecimal ballAndCylinder(GeometryObject ball, GeometryObject lying, Dimension dimension) {
        if (dimension == Dimension.PLANAR || !(ball instanceof SphereObject sphere)) {
            throw new IllegalArgumentException("a cylinder that lies is known beside a ball only (got: " + ball + ")");
        }
        CylinderObject cylinder = (CylinderObject) lying;
        double[] r = cylinder.rotation();
        Rational[] axis = {Rational.of(r[1]), Rational.of(r[4]), Rational.of(r[7])};
        Rational[] apart = Rational.minus(Reference.exact(ball.center()), Reference.exact(lying.center()));
        Rational length = Rational.dot(axis, axis);
        Rational along = Rational.dot(apart, axis);
        Rational asideSquare = Rational.dot(apart, apart).minus(along.square().over(length));
        BigDecimal aside = less(asideSquare, Rational.of(cylinder.radius()));
        // The cylinder ends where (x - c).a = h a.a, that is, h |a| along the axis.
        BigDecimal size = DecimalRoot.of(length.toDecimal(Reference.DIGITS), Reference.DIGITS);
        BigDecimal beyond = along.toDecimal(Reference.DIGITS)
                .abs()
                .divide(size, Reference.DIGITS)
                .subtract(new BigDecimal(cylinder.height() / 2).multiply(size))
                .max(BigDecimal.ZERO);
        return DecimalRoot.of(aside.multiply(aside).add(beyond.multiply(beyond)), Reference.DIGITS)
                .subtract(new BigDecimal(sphere.radius()))
                .max(BigDecimal.ZERO);
    }

    /**
     * The share of a straight way at which the first object touches the second, at most 2^-60 too late; null where it
     * does not by its end.
     */
    public static @Nullable BigDecimal touch(GeometryObject a, Point way, GeometryObject b, Dimension dimension) {
        BigDecimal first = null;
        Rational[] exactWay = Reference.exact(way);
        for (Body one : bodies(a)) {
            for (Body other : bodies(b)) {
                if (misses(one, exactWay, other, dimension)) {
                    continue;
                }
                BigDecimal share = touch(one, exactWay, other, dimension);
                if (share != null && (first == null || share.compareTo(first) < 0)) {
                    first = share;
                }
            }
        }
        return first;
    }

    /** Whether the first object touches the second by a share of a straight way. */
    public static boolean touchesBy(double share, GeometryObject a, Point way, GeometryObject b, Dimension dimension) {
        Rational[] exactWay = Reference.exact(way);
        Rational most = Rational.of(share);
        for (Body one : bodies(a)) {
            for (Body other : bodies(b)) {
                if (misses(one, exactWay, other, dimension)) {
                    continue;
                }
                Rational[] span = heights(one, exactWay, other, dimension == Dimension.PLANAR);
                if (span != null && span[0].compareTo(most) <= 0) {
                    Rational end = span[1].compareTo(most) < 0 ? span[1] : most;
                    if (sweeps(one, exactWay, span[0], end, other, isLevel(one, other, dimension))) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** Whether the boxes around a way and what may be in it are apart. */
    private static boolean misses(Body a, Rational[] way, Body b, Dimension dimension) {
        List<Rational[]> swept = new ArrayList<>(a.points);
        a.points.forEach(p -> swept.add(new Rational[] {p[0].plus(way[0]), p[1].plus(way[1]), p[2].plus(way[2])}));
        return Box.around(swept, a.radius).apart(b.box(), dimension == Dimension.PLANAR) > 0;
    }

    private static boolean isLevel(Body a, Body b, Dimension dimension) {
        return dimension == Dimension.PLANAR || a.disc || b.disc;
    }

    private static @Nullable BigDecimal touch(Body a, Rational[] way, Body b, Dimension dimension) {
        Rational[] span = heights(a, way, b, dimension == Dimension.PLANAR);
        return span == null ? null : first(a, way, span[0], span[1], b, isLevel(a, b, dimension));
    }

    /** The shares between which heights meet, where a cylinder is in it and heights are apart from the rest. */
    private static Rational @Nullable [] heights(Body a, Rational[] way, Body b, boolean planar) {
        Rational from = Rational.ZERO;
        Rational to = Rational.of(1);
        if (!planar && (a.disc || b.disc)) {
            if (!(a.straight && b.straight)) {
                throw new IllegalArgumentException("the way of a cylinder is known beside what stands upright only");
            }
            Rational up = b.low().minus(a.high()); // a has to rise by this to this
            Rational over = b.high().minus(a.low());
            if (way[1].signum() == 0) {
                if (up.signum() > 0 || over.signum() < 0) {
                    return null;
                }
            } else {
                Rational enter = (way[1].signum() > 0 ? up : over).over(way[1]);
                Rational leave = (way[1].signum() > 0 ? over : up).over(way[1]);
                from = from.max(enter);
                to = to.compareTo(leave) < 0 ? to : leave;
            }
        }
        return from.compareTo(to) > 0 ? null : new Rational[] {from, to};
    }

    /** The first share from some share on, by the exact simplex method where nothing is round, else by halving. */
    private static @Nullable BigDecimal first(
            Body a, Rational[] way, Rational from, Rational to, Body b, boolean level) {
        if (a.radius.plus(b.radius).signum() == 0) {
            List<Rational[]> differences = new ArrayList<>();
            for (Rational[] p : b.points) {
                for (Rational[] q : a.points) {
                    differences.add(level ? Reference.flat(Rational.minus(p, q)) : Rational.minus(p, q));
                }
            }
            Rational[] direction = level ? Reference.flat(way) : way;
            Rational[] start = Arrays.stream(direction).map(from::times).toArray(Rational[]::new);
            Rational more = Simplex.enter(start, direction, differences);
            return more == null || from.plus(more).compareTo(to) > 0
                    ? null
                    : from.plus(more).toDecimal(Reference.DIGITS);
        }
        if (!sweeps(a, way, from, to, b, level)) {
            return null;
        }
        Rational before = from;
        Rational after = to;
        Rational half = Rational.of(0.5);
        for (int k = 0; k < 60; k++) {
            Rational middle = before.plus(after).times(half);
            if (sweeps(a, way, from, middle, b, level)) {
                after = middle;
            } else {
                before = middle;
            }
        }
        return after.toDecimal(Reference.DIGITS);
    }

    /** Whether the first touches the second anywhere between two shares of its way. */
    private static boolean sweeps(Body a, Rational[] way, Rational from, Rational to, Body b, boolean level) {
        List<Rational[]> swept = new ArrayList<>();
        for (Rational[] p : a.points) {
            for (Rational share : List.of(from, to)) {
                Rational[] q = {
                    p[0].plus(share.times(way[0])), p[1].plus(share.times(way[1])), p[2].plus(share.times(way[2]))
                };
                swept.add(level ? Reference.flat(q) : q);
            }
        }
        Rational square = new Nearest(swept, level ? b.outline() : b.points).square();
        return square.compareTo(a.radius.plus(b.radius).square()) <= 0;
    }
}
