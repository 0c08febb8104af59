package robosim.geometry.reference;

import java.math.BigDecimal;
import java.util.ArrayList;
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
    private record Body(List<Rational[]> points, Rational radius, boolean disc, boolean ball, boolean straight) {
        Rational low() {
            return points.stream()
                    .map(p -> p[1])
                    .reduce((p, q) -> p.compareTo(q) <= 0 ? p : q)
                    .orElseThrow();
        }

        Rational high() {
            return points.stream().map(p -> p[1]).reduce(Rational::max).orElseThrow();
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
        return pieces(a).stream()
                .anyMatch(one -> others.stream().anyMatch(other -> Reference.meet(one, other, dimension)));
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

    private static List<Body> bodies(GeometryObject object) {
        boolean straight =
                object.kind() == Kind.CYLINDER || (object instanceof BoxObject && Math.abs(object.rotation()[4]) == 1);
        List<Body> bodies = new ArrayList<>();
        for (Reference.Piece piece : pieces(object)) {
            boolean disc = piece.round() && !piece.ball();
            bodies.add(new Body(piece.points(), piece.radius().max(Rational.ZERO), disc, piece.ball(), straight));
        }
        return bodies;
    }

    /** The least distance between two objects at 80 digits, 0 where they touch or overlap. */
    public static BigDecimal distance(GeometryObject a, GeometryObject b, Dimension dimension) {
        if (isLyingCylinder(a) || isLyingCylinder(b)) {
            return isLyingCylinder(a) ? ballAndCylinder(b, a, dimension) : ballAndCylinder(a, b, dimension);
        }
        BigDecimal least = null;
        for (Body one : bodies(a)) {
            for (Body other : bodies(b)) {
                BigDecimal gap = distance(one, other, dimension == Dimension.PLANAR);
                least = least == null ? gap : least.min(gap);
            }
        }
        return least;
    }

    private static BigDecimal distance(Body a, Body b, boolean planar) {
        if (planar) {
            return less(new Nearest(a.outline(), b.outline()).square(), a.radius.plus(b.radius));
        }
        if (!a.disc && !b.disc) {
            return less(new Nearest(a.points, b.points).square(), a.radius.plus(b.radius));
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
        return square.sqrt(Reference.DIGITS)
                .subtract(ball.toDecimal(Reference.DIGITS))
                .max(BigDecimal.ZERO);
    }

    /** A root less a radius; exactly 0 where the radius reaches. */
    private static BigDecimal less(Rational square, Rational radius) {
        if (square.compareTo(radius.square()) <= 0) {
            return BigDecimal.ZERO;
        }
        return square.toDecimal(Reference.DIGITS).sqrt(Reference.DIGITS).subtract(radius.toDecimal(Reference.DIGITS));
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
        BigDecimal size = length.toDecimal(Reference.DIGITS).sqrt(Reference.DIGITS);
        BigDecimal beyond = along.toDecimal(Reference.DIGITS)
                .abs()
                .divide(size, Reference.DIGITS)
                .subtract(new BigDecimal(cylinder.height() / 2).multiply(size))
                .max(BigDecimal.ZERO);
        return aside.multiply(aside)
                .add(beyond.multiply(beyond))
                .sqrt(Reference.DIGITS)
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
                BigDecimal share = touch(one, exactWay, other, dimension == Dimension.PLANAR);
                if (share != null && (first == null || share.compareTo(first) < 0)) {
                    first = share;
                }
            }
        }
        return first;
    }

    private static @Nullable BigDecimal touch(Body a, Rational[] way, Body b, boolean planar) {
        Rational from = Rational.ZERO;
        Rational to = Rational.of(1);
        boolean level = planar || a.disc || b.disc;
        if (!planar && level) {
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
        if (from.compareTo(to) > 0 || !sweeps(a, way, from, to, b, level)) {
            return null;
        }
        if (sweeps(a, way, from, from, b, level)) {
            return from.toDecimal(Reference.DIGITS);
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
