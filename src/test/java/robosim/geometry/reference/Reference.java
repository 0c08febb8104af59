package robosim.geometry.reference;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/**
 * What is true about two objects, or a ray and an object, in the real-number geometry of the stored numbers: slow and
 * exact. Knows boxes, spheres, capsules and surfaces in any attitude, cylinders that stand upright, and groups that were not
 * moved. A capsule that leans beside a cylinder is known to {@link #FINE} of their sizes.
 */
public final class Reference {
    static final MathContext DIGITS = new MathContext(80);

    /** What a capsule beside a cylinder is told to, as a share of their sizes and offset. */
    private static final BigDecimal FINE = new BigDecimal("1e-36");

    private Reference() {}

    /**
     * A convex piece: the hull of points; round where it has a radius, and then a disc between two heights, or a ball that goes
     * from one point to another, which may be the same.
     */
    record Piece(List<Rational[]> points, Rational radius, boolean ball) {
        boolean round() {
            return radius.signum() >= 0;
        }

        boolean isCapsule() {
            return ball && Rational.dot(along(), along()).signum() > 0;
        }

        boolean leans() {
            return ball && (along()[0].signum() != 0 || along()[2].signum() != 0);
        }

        private Rational[] along() {
            return Rational.minus(points.get(1), points.get(0));
        }

        Rational low() {
            return points.get(0)[1].compareTo(points.get(1)[1]) <= 0 ? points.get(0)[1] : points.get(1)[1];
        }

        Rational high() {
            return points.get(0)[1].max(points.get(1)[1]);
        }
    }

    private static final Rational NOT_ROUND = Rational.of(-1);

    /** Whether two objects touch or overlap. */
    public static boolean overlap(GeometryObject a, GeometryObject b, Dimension dimension) {
        List<Piece> others = pieces(b);
        return pieces(a).stream().anyMatch(one -> others.stream().anyMatch(other -> meet(one, other, dimension)));
    }

    /** The distance along a ray to an object, at 80 digits; null where it misses, 0 where it starts in or on it. */
    public static @Nullable BigDecimal distance(Ray ray, GeometryObject object, Dimension dimension) {
        Rational[] start = exact(ray.start());
        Rational[] direction = exact(ray.direction());
        Rational[] way = dimension == Dimension.PLANAR ? flat(direction) : direction;
        BigDecimal length = DecimalRoot.of(Rational.dot(way, way).toDecimal(DIGITS), DIGITS);
        BigDecimal least = null;
        for (Piece piece : pieces(object)) {
            BigDecimal share = enter(start, direction, piece, dimension);
            if (share != null && (least == null || share.compareTo(least) < 0)) {
                least = share;
            }
        }
        return least == null ? null : least.multiply(length, DIGITS);
    }

    static List<Piece> pieces(GeometryObject object) {
        List<Piece> pieces = new ArrayList<>();
        switch (object.kind()) {
            case BOX -> pieces.add(new Piece(corners((BoxObject) object), NOT_ROUND, false));
            case SPHERE -> {
                Rational radius = Rational.of(((SphereObject) object).radius());
                pieces.add(new Piece(List.of(exact(object.center()), exact(object.center())), radius, true));
            }
            case CYLINDER -> pieces.add(axis((CylinderObject) object));
            case CAPSULE -> pieces.add(capsule((CapsuleObject) object));
            case MESH -> triangles((MeshObject) object, pieces);
            case GRID -> {
                GridObject grid = (GridObject) object;
                grid.occupied().stream()
                        .mapToObj(cell -> grid.box(cell % grid.columns(), cell / grid.columns()))
                        .forEach(box -> pieces.addAll(pieces(box)));
            }
            case GROUP -> {
                ObjectGroup group = (ObjectGroup) object;
                if (!group.equals(group.at(robosim.geometry.model.Pose.ORIGIN))) {
                    throw new IllegalArgumentException("group must stand at its origin (got: " + group + ")");
                }
                group.members().forEach(member -> pieces.addAll(pieces(member)));
            }
        }
        return pieces;
    }

    static Rational[] exact(Point point) {
        return new Rational[] {Rational.of(point.x()), Rational.of(point.y()), Rational.of(point.z())};
    }

    static Rational[] flat(Rational[] point) {
        return new Rational[] {point[0], point[2]};
    }

    private static List<Rational[]> flat(List<Rational[]> points) {
        return points.stream().map(Reference::flat).toList();
    }

    private static List<Rational[]> corners(BoxObject box) {
        double[] r = box.rotation();
        double[] halves = {box.width() / 2, box.height() / 2, box.length() / 2};
        List<Rational[]> corners = new ArrayList<>();
        for (int corner = 0; corner < 8; corner++) {
            Rational[] point = exact(box.center());
            for (int axis = 0; axis < 3; axis++) {
                Rational half = Rational.of((corner >> axis & 1) == 0 ? -halves[axis] : halves[axis]);
                for (int k = 0; k < 3; k++) {
                    point[k] = point[k].plus(half.times(Rational.of(r[3 * k + axis])));
                }
            }
            corners.add(point);
        }
        return corners;
    }

    private static Piece capsule(CapsuleObject capsule) {
        double[] r = capsule.rotation();
        Rational half = Rational.of(capsule.segment() / 2);
        Rational[] low = exact(capsule.center());
        Rational[] high = exact(capsule.center());
        for (int k = 0; k < 3; k++) {
            Rational arm = half.times(Rational.of(r[3 * k + 1]));
            low[k] = low[k].minus(arm);
            high[k] = high[k].plus(arm);
        }
        return new Piece(List.of(low, high), Rational.of(capsule.radius()), true);
    }

    private static Piece axis(CylinderObject cylinder) {
        if (Math.abs(cylinder.rotation()[4]) != 1) {
            throw new IllegalArgumentException("cylinder must stand upright (got: " + cylinder + ")");
        }
        Rational half = Rational.of(cylinder.height() / 2);
        Rational[] low = exact(cylinder.center());
        Rational[] high = exact(cylinder.center());
        low[1] = low[1].minus(half);
        high[1] = high[1].plus(half);
        return new Piece(List.of(low, high), Rational.of(cylinder.radius()), false);
    }

    /** The placed vertices are doubles, each made in one order; a quad is its triangles on the diagonal 0-2. */
    private static void triangles(MeshObject mesh, List<Piece> pieces) {
        if (mesh.isSolid()) {
            throw new IllegalArgumentException("mesh must be a surface (got: " + mesh + ")");
        }
        double[] r = mesh.rotation();
        List<Rational[]> placed = new ArrayList<>();
        for (Point p : mesh.vertices()) {
            Point c = mesh.center();
            placed.add(new Rational[] {
                Rational.of(r[0] * p.x() + r[1] * p.y() + r[2] * p.z() + c.x()),
                Rational.of(r[3] * p.x() + r[4] * p.y() + r[5] * p.z() + c.y()),
                Rational.of(r[6] * p.x() + r[7] * p.y() + r[8] * p.z() + c.z())
            });
        }
        for (int[] face : mesh.faces()) {
            for (int k = 2; k < face.length; k++) {
                pieces.add(new Piece(
                        List.of(placed.get(face[0]), placed.get(face[k - 1]), placed.get(face[k])), NOT_ROUND, false));
            }
        }
    }

    static boolean meet(Piece a, Piece b, Dimension dimension) {
        if (!a.round() && b.round()) {
            return meet(b, a, dimension);
        }
        boolean planar = dimension == Dimension.PLANAR;
        if (!a.round()) {
            return planar ? Simplex.meet(flat(a.points), flat(b.points)) : Simplex.meet(a.points, b.points);
        }
        if (a.isCapsule() || b.isCapsule()) {
            return capsuleMeet(a, b, planar);
        }
        if (b.round()) {
            return roundMeet(a, b, planar);
        }
        if (planar) {
            return within(flat(a.points.get(0)), flat(b.points), a.radius);
        }
        if (a.ball) {
            return within(a.points.get(0), b.points, a.radius);
        }
        List<Rational[]> between = slab(b.points, a.points.get(0)[1], a.points.get(1)[1]);
        return !between.isEmpty() && within(flat(a.points.get(0)), flat(between), a.radius);
    }

    /** A capsule and anything, in either order. */
    private static boolean capsuleMeet(Piece a, Piece b, boolean planar) {
        boolean isDiscBeside = !planar && ((a.round() && !a.ball) || (b.round() && !b.ball));
        if (isDiscBeside && (a.leans() || b.leans())) {
            return a.ball ? besideDisc(a, b).signum() == 0 : besideDisc(b, a).signum() == 0;
        }
        if (isDiscBeside) {
            return roundMeet(a, b, false);
        }
        Rational square = planar
                ? new Nearest(flat(a.points), flat(b.points)).square()
                : new Nearest(a.points, b.points).square();
        return square.compareTo(a.radius.plus(b.radius.max(Rational.ZERO)).square()) <= 0;
    }

    /** The gap between a capsule and an upright cylinder, 0 where that is less than {@link #FINE}. */
    static BigDecimal besideDisc(Piece capsule, Piece disc) {
        BigDecimal[][] ends = new BigDecimal[2][3];
        Rational size = capsule.radius.plus(disc.radius);
        for (int k = 0; k < 3; k++) {
            Rational to = disc.points.get(0)[k];
            for (int end = 0; end < 2; end++) {
                Rational off = capsule.points.get(end)[k].minus(to);
                ends[end][k] = off.toDecimal(DIGITS);
                size = size.plus(off.max(off.negate()));
            }
        }
        BigDecimal height = disc.points.get(1)[1].minus(disc.points.get(0)[1]).toDecimal(DIGITS);
        BigDecimal radius = disc.radius.toDecimal(DIGITS);
        BigDecimal low = BigDecimal.ZERO;
        BigDecimal high = BigDecimal.ONE;
        BigDecimal third = BigDecimal.ONE.divide(BigDecimal.valueOf(3), DIGITS);
        BigDecimal least = toDisc(ends, low, height, radius).min(toDisc(ends, high, height, radius));
        // The distance of a point that goes along a line from what is convex falls and rises again.
        for (int step = 0; step < 250; step++) {
            BigDecimal part = high.subtract(low).multiply(third, DIGITS);
            BigDecimal first = low.add(part);
            BigDecimal second = high.subtract(part);
            BigDecimal atFirst = toDisc(ends, first, height, radius);
            BigDecimal atSecond = toDisc(ends, second, height, radius);
            least = least.min(atFirst).min(atSecond);
            if (least.signum() == 0) {
                break;
            }
            if (atFirst.compareTo(atSecond) <= 0) {
                high = second;
            } else {
                low = first;
            }
        }
        BigDecimal gap = least.subtract(capsule.radius.toDecimal(DIGITS));
        return gap.compareTo(FINE.multiply(size.toDecimal(DIGITS))) <= 0 ? BigDecimal.ZERO : gap;
    }

    /** From a place on the way between two points to a cylinder that stands on the origin. */
    private static BigDecimal toDisc(BigDecimal[][] ends, BigDecimal share, BigDecimal height, BigDecimal radius) {
        BigDecimal[] p = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            p[k] = ends[0][k].add(ends[1][k].subtract(ends[0][k]).multiply(share, DIGITS), DIGITS);
        }
        BigDecimal up = p[1].subtract(height).max(p[1].negate()).max(BigDecimal.ZERO);
        BigDecimal aside = DecimalRoot.of(p[0].multiply(p[0]).add(p[2].multiply(p[2])), DIGITS)
                .subtract(radius)
                .max(BigDecimal.ZERO);
        return DecimalRoot.of(aside.multiply(aside).add(up.multiply(up)), DIGITS);
    }

    /** Balls and what stands upright: how far apart they are to the side, and what of a ball's radius is left there. */
    private static boolean roundMeet(Piece a, Piece b, boolean planar) {
        Rational[] aside = Rational.minus(flat(a.points.get(0)), flat(b.points.get(0)));
        Rational square = Rational.dot(aside, aside);
        Rational reach = a.radius.plus(b.radius);
        if (planar) {
            return square.compareTo(reach.square()) <= 0;
        }
        Rational gap = a.low().minus(b.high()).max(b.low().minus(a.high()));
        if (a.ball && b.ball) {
            return square.plus(gap.square()).compareTo(reach.square()) <= 0;
        }
        if (!a.ball && !b.ball) {
            return gap.signum() <= 0 && square.compareTo(reach.square()) <= 0;
        }
        Rational ball = a.ball ? a.radius : b.radius;
        Rational other = a.ball ? b.radius : a.radius;
        Rational up = gap.max(Rational.ZERO);
        if (up.compareTo(ball) > 0) {
            return false;
        }
        // aside <= other + sqrt(ball^2 - up^2): by squaring twice.
        Rational rest = ball.square().minus(up.square());
        Rational left = square.minus(other.square()).minus(rest);
        return left.signum() <= 0
                || left.square().compareTo(Rational.of(4).times(other.square()).times(rest)) <= 0;
    }

    /** The points that span the part of a hull between two heights. */
    private static List<Rational[]> slab(List<Rational[]> hull, Rational low, Rational high) {
        List<Rational[]> part = new ArrayList<>();
        for (Rational[] p : hull) {
            if (p[1].compareTo(low) >= 0 && p[1].compareTo(high) <= 0) {
                part.add(p);
            }
            for (Rational[] q : hull) {
                for (Rational height : List.of(low, high)) {
                    if (p[1].compareTo(height) < 0 && q[1].compareTo(height) > 0) {
                        Rational share = height.minus(p[1]).over(q[1].minus(p[1]));
                        part.add(new Rational[] {
                            p[0].plus(share.times(q[0].minus(p[0]))), height, p[2].plus(share.times(q[2].minus(p[2])))
                        });
                    }
                }
            }
        }
        return part;
    }

    /** Whether a point is in a hull or no farther from it than a radius: some corner, pair or three of them is as near. */
    private static boolean within(Rational[] point, List<Rational[]> hull, Rational radius) {
        if (Simplex.meet(List.<Rational[]>of(point), hull)) {
            return true;
        }
        Rational most = radius.square();
        for (int i = 0; i < hull.size(); i++) {
            Rational[] w = Rational.minus(point, hull.get(i));
            if (Rational.dot(w, w).compareTo(most) <= 0) {
                return true;
            }
            for (int j = i + 1; j < hull.size(); j++) {
                Rational[] e = Rational.minus(hull.get(j), hull.get(i));
                if (nearSegment(w, e, most)) {
                    return true;
                }
                for (int k = j + 1; k < hull.size() && point.length == 3; k++) {
                    if (nearTriangle(w, e, Rational.minus(hull.get(k), hull.get(i)), most)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** By the foot of the point, where that is on the segment. */
    private static boolean nearSegment(Rational[] w, Rational[] e, Rational most) {
        Rational along = Rational.dot(w, e);
        Rational length = Rational.dot(e, e);
        return along.signum() > 0
                && along.compareTo(length) < 0
                && Rational.dot(w, w).minus(most).times(length).compareTo(along.square()) <= 0;
    }

    /** By the foot of the point on the plane, where that is in the triangle. */
    private static boolean nearTriangle(Rational[] w, Rational[] e, Rational[] f, Rational most) {
        Rational ee = Rational.dot(e, e);
        Rational ef = Rational.dot(e, f);
        Rational ff = Rational.dot(f, f);
        Rational we = Rational.dot(w, e);
        Rational wf = Rational.dot(w, f);
        Rational area = ee.times(ff).minus(ef.square());
        if (area.signum() == 0) {
            return false;
        }
        Rational u = we.times(ff).minus(wf.times(ef));
        Rational v = wf.times(ee).minus(we.times(ef));
        return u.signum() >= 0
                && v.signum() >= 0
                && u.plus(v).compareTo(area) <= 0
                && Rational.dot(w, w)
                                .minus(most)
                                .times(area)
                                .compareTo(u.times(we).plus(v.times(wf)))
                        <= 0;
    }

    private static @Nullable BigDecimal enter(Rational[] start, Rational[] way, Piece piece, Dimension dimension) {
        boolean planar = dimension == Dimension.PLANAR;
        if (!piece.round()) {
            Rational share = planar
                    ? Simplex.enter(flat(start), flat(way), flat(piece.points))
                    : Simplex.enter(start, way, piece.points);
            return share == null ? null : share.toDecimal(DIGITS);
        }
        if (piece.isCapsule()) {
            return planar
                    ? enterCapsule(flat(start), flat(way), flat(piece.points), piece.radius)
                    : enterCapsule(start, way, piece.points, piece.radius);
        }
        boolean level = planar || !piece.ball;
        Rational[] m = Rational.minus(start, piece.points.get(0));
        Rational low = Rational.ZERO;
        Rational high = null;
        if (!planar && !piece.ball) {
            Rational[] heights = {piece.points.get(0)[1].minus(start[1]), piece.points.get(1)[1].minus(start[1])};
            if (way[1].signum() == 0) {
                if (heights[0].signum() > 0 || heights[1].signum() < 0) {
                    return null;
                }
            } else {
                boolean up = way[1].signum() > 0;
                low = low.max(heights[up ? 0 : 1].over(way[1]));
                high = heights[up ? 1 : 0].over(way[1]);
            }
        }
        return enterRound(level ? flat(m) : m, level ? flat(way) : way, piece.radius.square(), low, high);
    }

    /** The first of the balls about the ends and of what is beside the segment. */
    private static @Nullable BigDecimal enterCapsule(
            Rational[] start, Rational[] way, List<Rational[]> ends, Rational radius) {
        BigDecimal least = null;
        for (Rational[] end : ends) {
            least = first(least, enterRound(Rational.minus(start, end), way, radius.square(), Rational.ZERO, null));
        }
        Rational[] along = Rational.minus(ends.get(1), ends.get(0));
        Rational length = Rational.dot(along, along);
        if (length.signum() == 0) {
            return least;
        }
        Rational[] from = Rational.minus(start, ends.get(0));
        Rational begins = Rational.dot(from, along);
        Rational slope = Rational.dot(way, along);
        Rational low = Rational.ZERO;
        Rational high = null;
        if (slope.signum() == 0) {
            if (begins.signum() < 0 || begins.compareTo(length) > 0) {
                return least;
            }
        } else {
            Rational one = begins.negate().over(slope);
            Rational two = length.minus(begins).over(slope);
            low = low.max(slope.signum() > 0 ? one : two);
            high = slope.signum() > 0 ? two : one;
        }
        return first(
                least,
                enterRound(
                        across(from, along), across(way, along), radius.square().times(length), low, high));
    }

    private static @Nullable BigDecimal first(@Nullable BigDecimal one, @Nullable BigDecimal other) {
        return one == null ? other : other == null ? one : one.min(other);
    }

    /** The cross product, of one number in the plane. */
    private static Rational[] across(Rational[] u, Rational[] v) {
        if (u.length == 2) {
            return new Rational[] {u[0].times(v[1]).minus(u[1].times(v[0]))};
        }
        return new Rational[] {
            u[1].times(v[2]).minus(u[2].times(v[1])),
            u[2].times(v[0]).minus(u[0].times(v[2])),
            u[0].times(v[1]).minus(u[1].times(v[0]))
        };
    }

    /** The least t in [low, high] for which the square of m + t way is at most so much. */
    private static @Nullable BigDecimal enterRound(
            Rational[] m, Rational[] way, Rational square, Rational low, @Nullable Rational high) {
        if (high != null && high.compareTo(low) < 0) {
            return null;
        }
        Rational a = Rational.dot(way, way);
        Rational b = Rational.dot(m, way);
        Rational c = Rational.dot(m, m).minus(square);
        if (value(a, b, c, low).signum() <= 0) {
            return low.toDecimal(DIGITS);
        }
        if (a.signum() == 0) {
            return null;
        }
        Rational quarter = b.square().minus(a.times(c));
        Rational middle = b.negate().over(a);
        boolean ahead = middle.compareTo(low) > 0;
        if (quarter.signum() < 0 || !ahead) {
            return null;
        }
        if (high != null && high.compareTo(middle) < 0 && value(a, b, c, high).signum() > 0) {
            return null;
        }
        BigDecimal root = DecimalRoot.of(quarter.toDecimal(DIGITS), DIGITS);
        return middle.toDecimal(DIGITS).subtract(root.divide(a.toDecimal(DIGITS), DIGITS), DIGITS);
    }

    private static Rational value(Rational a, Rational b, Rational c, Rational t) {
        return a.times(t).plus(b).plus(b).times(t).plus(c);
    }
}
