package robosim.geometry.reference;

import static robosim.geometry.reference.Vectors.abs;
import static robosim.geometry.reference.Vectors.atMost;
import static robosim.geometry.reference.Vectors.cross;
import static robosim.geometry.reference.Vectors.dot;
import static robosim.geometry.reference.Vectors.minus;
import static robosim.geometry.reference.Vectors.plus;
import static robosim.geometry.reference.Vectors.times;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.reference.Quantity.Arithmetic;

/**
 * A cylinder in any attitude: the points x with {@code |(x - c) x a| <= r |a|} and {@code |(x - c) . a| <= h a . a}.
 *
 * <p>What a polytope has between the two planes of the caps is cut out, corner by corner as a vector over a weight, and
 * seen along the axis: the cylinder meets it where the axis does or where an edge of the cut is near enough.
 */
final class Tube {
    private final Quantity zero;
    private final Quantity one;
    private final Quantity[] centre;
    private final Quantity[] axis;
    private final Quantity radius;
    private final Quantity half;

    /** Half height and squared radius as the axis measures them. */
    private final Quantity reach;

    private final Quantity square;

    /** A point seen along the axis, times a weight above 0; and how far along the axis it lies, unweighted. */
    private record Seen(Quantity[] at, Quantity weight) {}

    private Tube(Arithmetic n, double[] row, Quantity[] axis) {
        zero = n.of(0);
        one = n.of(1);
        centre = Vectors.of(n, row[0], row[1], row[2]);
        this.axis = axis;
        radius = n.of(row[3]);
        half = n.of(row[4]);
        Quantity length = dot(axis, axis);
        reach = half.times(length);
        square = radius.times(radius).times(length);
    }

    static Tube upright(Arithmetic n, double[] row) {
        return new Tube(n, row, Vectors.of(n, 0, 1, 0));
    }

    static Tube turned(Arithmetic n, double[] row) {
        return new Tube(n, row, Vectors.of(n, row[7], row[10], row[13]));
    }

    boolean meets(Hull hull) {
        Quantity[] arm = times(axis, half);
        if (hull.meetsSegment(minus(centre, arm), plus(centre, arm))) {
            return true;
        }
        int count = hull.corners.size();
        Quantity[] along = new Quantity[count];
        Quantity[][] seen = new Quantity[count][];
        for (int k = 0; k < count; k++) {
            Quantity[] offset = minus(hull.corners.get(k), centre);
            along[k] = dot(offset, axis);
            seen[k] = cross(offset, axis);
        }
        List<Seen> bottom = section(hull, along, seen, reach.negate());
        List<Seen> top = section(hull, along, seen, reach);
        for (int[] edge : hull.edges) {
            Seen from = end(along, seen, edge[0], edge[1]);
            Seen to = end(along, seen, edge[1], edge[0]);
            if (from != null && to != null && isNear(from, to)) {
                return true;
            }
        }
        return anyNear(bottom) || anyNear(top);
    }

    /** Where the edge from p begins to be between the caps; null where it never is. */
    private @Nullable Seen end(Quantity[] along, Quantity[][] seen, int p, int q) {
        for (int cap = -1; cap <= 1; cap += 2) {
            Quantity mine = beyond(along[p], cap);
            if (mine.signum() > 0) {
                Quantity other = beyond(along[q], cap);
                return other.signum() > 0 ? null : between(seen[p], mine, seen[q], other);
            }
        }
        return new Seen(seen[p], one);
    }

    private Quantity beyond(Quantity along, int cap) {
        return cap < 0 ? along.negate().minus(reach) : along.minus(reach);
    }

    /** The point where a height that is above 0 at p and not above 0 at q is 0. */
    private static Seen between(Quantity[] p, Quantity heightP, Quantity[] q, Quantity heightQ) {
        return new Seen(minus(times(q, heightP), times(p, heightQ)), heightP.minus(heightQ));
    }

    /** Where the edges meet the plane of a cap. */
    private static List<Seen> section(Hull hull, Quantity[] along, Quantity[][] seen, Quantity cap) {
        List<Seen> points = new ArrayList<>();
        for (int[] edge : hull.edges) {
            Quantity p = along[edge[0]].minus(cap);
            Quantity q = along[edge[1]].minus(cap);
            if (p.signum() > 0 && q.signum() <= 0) {
                points.add(between(seen[edge[0]], p, seen[edge[1]], q));
            } else if (q.signum() > 0 && p.signum() <= 0) {
                points.add(between(seen[edge[1]], q, seen[edge[0]], p));
            } else if (p.signum() < 0 && q.signum() == 0) {
                points.add(between(seen[edge[0]], p.negate(), seen[edge[1]], q));
            } else if (q.signum() < 0 && p.signum() == 0) {
                points.add(between(seen[edge[1]], q.negate(), seen[edge[0]], p));
            }
        }
        return points;
    }

    private boolean anyNear(List<Seen> points) {
        for (int i = 0; i < points.size(); i++) {
            for (int j = 0; j < i; j++) {
                if (isNear(points.get(i), points.get(j))) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean isNear(Seen a, Seen b) {
        Quantity[] from = times(a.at, b.weight);
        Quantity[] to = times(b.at, a.weight);
        Quantity weight = a.weight.times(b.weight);
        return Hull.isNearSegment(times(from, one.negate()), minus(to, from), square.times(weight.times(weight)));
    }

    boolean meetsBall(Quantity[] point, Quantity ball) {
        Quantity[] offset = minus(point, centre);
        Quantity above = abs(dot(offset, axis)).minus(reach);
        if (above.signum() < 0) {
            above = zero;
        }
        // All that follows is times the square of the axis's length.
        Quantity[] aside = cross(offset, axis);
        Quantity length = dot(axis, axis);
        Quantity left = ball.times(ball).times(length).minus(above.times(above));
        if (left.signum() < 0) {
            return false;
        }
        // aside <= radius + sqrt(left): by squaring twice
        Quantity rest = dot(aside, aside).minus(square).minus(left);
        return rest.signum() <= 0 || atMost(rest.times(rest), times4(square.times(left)));
    }

    private static Quantity times4(Quantity value) {
        Quantity twice = value.plus(value);
        return twice.plus(twice);
    }

    /** Against one whose axis is parallel, to the bit. */
    boolean meetsParallel(Tube that) {
        Quantity[] offset = minus(that.centre, centre);
        Quantity heights = reach.plus(that.half.times(abs(dot(axis, that.axis))));
        if (!atMost(abs(dot(offset, axis)), heights)) {
            return false;
        }
        Quantity[] aside = cross(offset, axis);
        Quantity both = radius.plus(that.radius);
        return atMost(dot(aside, aside), both.times(both).times(dot(axis, axis)));
    }

    boolean isHitBy(Quantity[] start, Quantity[] direction) {
        Quantity[] offset = minus(start, centre);
        Quantity along = dot(offset, axis);
        Quantity speed = dot(direction, axis);
        // When the ray comes between the planes of the caps and when it leaves: shares over something above 0.
        Quantity enter = zero;
        Quantity enterUnder = one;
        Quantity leave = null;
        Quantity leaveUnder = null;
        for (int cap = -1; cap <= 1; cap += 2) {
            Quantity inside = beyond(along, cap).negate();
            Quantity slope = cap < 0 ? speed : speed.negate();
            if (inside.signum() < 0) {
                if (slope.signum() <= 0) {
                    return false;
                }
                enter = inside.negate();
                enterUnder = slope;
            } else if (slope.signum() < 0) {
                leave = inside;
                leaveUnder = slope.negate();
            }
        }
        Quantity[] aside = cross(offset, axis);
        Quantity[] drift = cross(direction, axis);
        Quantity a = dot(drift, drift);
        Quantity b = dot(aside, drift);
        Quantity c = dot(aside, aside).minus(square);
        if (isInside(a, b, c, enter, enterUnder)) {
            return true;
        }
        if (leave != null && isInside(a, b, c, leave, leaveUnder)) {
            return true;
        }
        // Nearest in between, at -b / a.
        return a.signum() > 0
                && b.negate().times(enterUnder).minus(enter.times(a)).signum() > 0
                && (leave == null || leave.times(a).plus(b.times(leaveUnder)).signum() > 0)
                && atMost(a.times(c), b.times(b));
    }

    private static boolean isInside(Quantity a, Quantity b, Quantity c, Quantity over, Quantity under) {
        Quantity middle = b.plus(b).times(over).times(under);
        return a.times(over)
                        .times(over)
                        .plus(middle)
                        .plus(c.times(under).times(under))
                        .signum()
                <= 0;
    }
}
