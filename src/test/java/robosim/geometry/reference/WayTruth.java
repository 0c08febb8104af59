package robosim.geometry.reference;

import static robosim.geometry.reference.Vectors.atMost;
import static robosim.geometry.reference.Vectors.cross;
import static robosim.geometry.reference.Vectors.dot;
import static robosim.geometry.reference.Vectors.minus;
import static robosim.geometry.reference.Vectors.plus;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.reference.Quantity.Arithmetic;
import robosim.geometry.reference.Truth.Form;

/**
 * Yes or no about a form that moves straight on against one at rest, the two being apart at the start: whether they touch
 * by the end of the way.
 *
 * <p>Where two polytopes first touch, a corner of one is on the other or two edges cross that are not parallel; so corners
 * are drawn along the way as segments, and for edges the crossing is solved for. Edges that move in the plane of both touch
 * sooner at a corner.
 */
public final class WayTruth {
    private WayTruth() {}

    /** In the plane: rounds and polygons. */
    public static boolean planar(Arithmetic n, Form formA, double[] a, double dx, double dz, Form formB, double[] b) {
        return planar(n, formA, a, Vectors.of(n, dx, 0, dz), formB, b);
    }

    /** The same for the first part of a way, that is, for {@code share - less} of it. */
    public static boolean planarBy(
            Arithmetic n,
            Form formA,
            double[] a,
            double dx,
            double dz,
            double share,
            double less,
            Form formB,
            double[] b) {
        Quantity part = n.of(share).minus(n.of(less));
        return planar(n, formA, a, Vectors.times(Vectors.of(n, dx, 0, dz), part), formB, b);
    }

    private static boolean planar(Arithmetic n, Form formA, double[] a, Quantity[] way, Form formB, double[] b) {
        if (!formA.isRound() && formB.isRound()) {
            return planar(n, formB, b, Vectors.negate(way), formA, a);
        }
        if (!formA.isRound()) {
            return cornersMeet(Truth.outline(n, formA, a), way, Truth.outline(n, formB, b));
        }
        return roundMeets(n, Vectors.of(n, a[0], 0, a[2]), way, a[3], formB, b, n.of(1));
    }

    /** A disc on its way against a disc or a polygon, which are to be taken so many times their size. */
    private static boolean roundMeets(
            Arithmetic n, Quantity[] from, Quantity[] way, double r, Form formB, double[] b, Quantity times) {
        Quantity radius = n.of(r).times(times);
        if (formB.isRound()) {
            Quantity both = radius.plus(n.of(b[3]).times(times));
            Quantity[] w = minus(Vectors.times(Vectors.of(n, b[0], 0, b[2]), times), from);
            return Hull.isNearSegment(w, way, both.times(both));
        }
        Hull polygon = Truth.outline(n, formB, b).enlarged(times);
        Quantity[] to = plus(from, way);
        if (polygon.meetsSegment(from, to) || polygon.isWithin(from, radius) || polygon.isWithin(to, radius)) {
            return true;
        }
        for (Quantity[] corner : polygon.corners) {
            if (Hull.isNearSegment(minus(corner, from), way, radius.times(radius))) {
                return true;
            }
        }
        return false;
    }

    /**
     * In space, an upright cylinder against what is upright: a disc on that part of its way on which the heights touch. The
     * part begins and ends at fractions, so all is taken as many times its size as both denominators.
     */
    public static boolean upright(Arithmetic n, double[] a, double[] d, Form formB, double[] b) {
        Quantity above = n.of(a[1]).minus(n.of(b[1]));
        Quantity most = n.of(a[4]).plus(n.of(b[4]));
        Quantity rise = n.of(d[1]);
        Quantity begin = n.of(0);
        Quantity beginUnder = n.of(1);
        Quantity end = n.of(1);
        Quantity endUnder = n.of(1);
        for (int side = -1; side <= 1; side += 2) {
            Quantity inside = side < 0 ? most.plus(above) : most.minus(above);
            Quantity slope = side < 0 ? rise : rise.negate();
            Quantity last = inside.plus(slope);
            if (inside.signum() < 0) {
                if (last.signum() < 0) {
                    return false;
                }
                begin = inside.negate();
                beginUnder = slope;
            } else if (last.signum() < 0) {
                end = inside;
                endUnder = slope.negate();
            }
        }
        Quantity[] start = Vectors.of(n, a[0], 0, a[2]);
        Quantity[] way = Vectors.of(n, d[0], 0, d[2]);
        Quantity[] from = Vectors.times(plus(Vectors.times(start, beginUnder), Vectors.times(way, begin)), endUnder);
        Quantity[] to = Vectors.times(plus(Vectors.times(start, endUnder), Vectors.times(way, end)), beginUnder);
        return roundMeets(n, from, minus(to, from), a[3], formB, b, beginUnder.times(endUnder));
    }

    /** In space, a sphere against a sphere, a box or a triangle. */
    public static boolean ball(Arithmetic n, double[] a, double[] d, Form formB, double[] b) {
        return ball(n, Vectors.of(n, a[0], a[1], a[2]), Vectors.of(n, d[0], d[1], d[2]), n.of(a[3]), formB, b);
    }

    /** The same for the first part of a way, that is, for {@code share - less} of it. */
    public static boolean ballBy(
            Arithmetic n, double[] a, double[] d, double share, double less, Form formB, double[] b) {
        Quantity part = n.of(share).minus(n.of(less));
        Quantity[] way = Vectors.times(Vectors.of(n, d[0], d[1], d[2]), part);
        return ball(n, Vectors.of(n, a[0], a[1], a[2]), way, n.of(a[3]), formB, b);
    }

    static boolean ball(Arithmetic n, Quantity[] from, Quantity[] way, Quantity radius, Form formB, double[] b) {
        if (formB == Form.SPHERE) {
            Quantity both = radius.plus(n.of(b[3]));
            return Hull.isNearSegment(minus(Vectors.of(n, b[0], b[1], b[2]), from), way, both.times(both));
        }
        Hull hull = Truth.hull(n, formB, b);
        Quantity[] to = plus(from, way);
        if (hull.meetsSegment(from, to) || hull.isWithin(from, radius) || hull.isWithin(to, radius)) {
            return true;
        }
        Quantity most = radius.times(radius);
        for (Quantity[] corner : hull.corners) {
            if (Hull.isNearSegment(minus(corner, from), way, most)) {
                return true;
            }
        }
        for (int k = 0; k < hull.edges.size(); k++) {
            Quantity[] start = hull.corners.get(hull.edges.get(k)[0]);
            if (isNearWithin(minus(start, from), way, hull.edge(k), most)) {
                return true;
            }
        }
        return false;
    }

    /** Whether two segments, w from the one's start to the other's, are near each other between their ends. */
    static boolean isNearWithin(Quantity[] w, Quantity[] way, Quantity[] edge, Quantity most) {
        Quantity[] across = cross(way, edge);
        Quantity whole = dot(across, across);
        if (whole.signum() == 0) {
            return false;
        }
        Quantity height = dot(w, across);
        return atMost(height.times(height), most.times(whole))
                && isShare(dot(cross(w, edge), across), whole, 1)
                && isShare(dot(cross(w, way), across), whole, 1);
    }

    /** In space: boxes and triangles. */
    public static boolean spatial(Arithmetic n, Form formA, double[] a, double[] d, Form formB, double[] b) {
        Hull mover = Truth.hull(n, formA, a);
        Hull other = Truth.hull(n, formB, b);
        Quantity[] way = Vectors.of(n, d[0], d[1], d[2]);
        if (isBeyond(mover, way, other) || isBeyond(other, Vectors.negate(way), mover)) {
            return false;
        }
        return cornersMeet(mover, way, other) || edgesCross(n, mover, way, other);
    }

    /** Whether all of the way leads past one side of the other. */
    private static boolean isBeyond(Hull mover, Quantity[] way, Hull other) {
        List<Quantity[]> points = new ArrayList<>(mover.corners);
        for (Quantity[] corner : mover.corners) {
            points.add(plus(corner, way));
        }
        return new Clip(points, other.slabs).isBeyond();
    }

    private static boolean cornersMeet(Hull mover, Quantity[] way, Hull other) {
        for (Quantity[] corner : mover.corners) {
            if (other.meetsSegment(corner, plus(corner, way))) {
                return true;
            }
        }
        for (Quantity[] corner : other.corners) {
            if (mover.meetsSegment(corner, minus(corner, way))) {
                return true;
            }
        }
        return false;
    }

    private static boolean edgesCross(Arithmetic n, Hull mover, Quantity[] way, Hull other) {
        Quantity zero = n.of(0);
        for (int k = 0; k < mover.edges.size(); k++) {
            Quantity[] e = mover.edge(k);
            Quantity[] from = mover.corners.get(mover.edges.get(k)[0]);
            Quantity[] sweep = cross(e, way);
            for (int m = 0; m < other.edges.size(); m++) {
                Quantity[] f = other.edge(m);
                Quantity whole = dot(sweep, f);
                int sign = whole.signum();
                if (sign == 0) {
                    continue;
                }
                // from + s e + t way = start + u f, each share over the same determinant
                Quantity[] w = minus(other.corners.get(other.edges.get(m)[0]), from);
                Quantity u = zero.minus(dot(sweep, w));
                if (isShare(u, whole, sign) && isShare(dot(cross(way, f), w), whole, sign)) {
                    if (isShare(dot(cross(f, e), w), whole, sign)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** Whether a number over another, whose sign is given, is between 0 and 1. */
    private static boolean isShare(Quantity over, Quantity under, int sign) {
        Quantity a = sign > 0 ? over : over.negate();
        return a.signum() >= 0 && atMost(a, sign > 0 ? under : under.negate());
    }
}
