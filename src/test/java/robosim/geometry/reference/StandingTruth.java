package robosim.geometry.reference;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.reference.Reference.Piece;

/**
 * Whether a straight move is allowed by the rules of a move, contacts at the start included: slow and exact, by linear
 * programs in integers and by distances of hulls. It knows no faces, no axes and no planes.
 *
 * <p>Movers are boxes, spheres and surfaces, obstacles boxes and surfaces; in the plane, upright cylinders move too. A move
 * is from a stored place to another, with the attitude kept.
 */
public final class StandingTruth {
    /** What is true of a move. */
    public enum Answer {
        FREE,
        BLOCKED,
        /** It starts in an overlap with a ball's or disc's centre inside, which is not known here. */
        UNKNOWN
    }

    /** How two pieces stand to each other at the start. */
    private enum Start {
        APART,
        TOUCHING,
        OVERLAPPING
    }

    /** A piece of the mover: where it is, its way as a set of points, and its radius, 0 for a polytope. */
    private record Mover(List<Rational[]> from, List<Rational[]> way, Rational radius) {}

    private final boolean flat;
    private final List<Mover> movers = new ArrayList<>();
    private final List<List<Rational[]>> others = new ArrayList<>();
    private final Rational[] displacement;

    private StandingTruth(GeometryObject from, GeometryObject to, List<GeometryObject> obstacles, Dimension dimension) {
        flat = dimension == Dimension.PLANAR;
        List<Piece> starts = Reference.pieces(from);
        List<Piece> ends = Reference.pieces(to);
        for (int k = 0; k < starts.size(); k++) {
            Piece piece = starts.get(k);
            boolean isRound = piece.round() && piece.radius().signum() > 0;
            if (isRound && !flat && !piece.ball()) {
                throw new IllegalArgumentException("no cylinders in space (got: " + from + ")");
            }
            List<Rational[]> start = points(isRound ? piece.points().subList(0, 1) : piece.points());
            List<Rational[]> way = new ArrayList<>(start);
            way.addAll(points(
                    isRound ? ends.get(k).points().subList(0, 1) : ends.get(k).points()));
            movers.add(new Mover(start, way, isRound ? piece.radius() : Rational.ZERO));
        }
        for (GeometryObject obstacle : obstacles) {
            for (Piece piece : Reference.pieces(obstacle)) {
                if (piece.round()) {
                    throw new IllegalArgumentException("obstacles must have corners (got: " + obstacle + ")");
                }
                others.add(points(piece.points()));
            }
        }
        Rational[] d = Rational.minus(Reference.exact(to.center()), Reference.exact(from.center()));
        displacement = flat ? Reference.flat(d) : d;
    }

    /** Whether a move from one stored place of an object to another is allowed. */
    public static Answer move(
            GeometryObject from, GeometryObject to, List<GeometryObject> obstacles, Dimension dimension) {
        return new StandingTruth(from, to, obstacles, dimension).answer();
    }

    /** Whether something that would block a move is behind a plane of a contact at the start, and so does not. */
    public static boolean isExcused(
            GeometryObject from, GeometryObject to, List<GeometryObject> obstacles, Dimension dimension) {
        StandingTruth truth = new StandingTruth(from, to, obstacles, dimension);
        return truth.movers.stream()
                .anyMatch(k ->
                        truth.others.stream().anyMatch(q -> truth.blocks(k, q) != Answer.FREE && truth.isBehind(k, q)));
    }

    private List<Rational[]> points(List<Rational[]> of) {
        return flat ? of.stream().map(Reference::flat).toList() : of;
    }

    private Answer answer() {
        boolean moves = false;
        for (Rational d : displacement) {
            moves |= d.signum() != 0;
        }
        Answer answer = Answer.FREE;
        for (Mover k : movers) {
            for (List<Rational[]> q : others) {
                Answer one = moves ? blocks(k, q) : Answer.FREE;
                if (one != Answer.FREE && !isBehind(k, q)) {
                    if (one == Answer.BLOCKED) {
                        return one;
                    }
                    answer = one;
                }
            }
        }
        return answer;
    }

    /** Whether a piece blocks another on its own. */
    private Answer blocks(Mover k, List<Rational[]> q) {
        return switch (start(k, q)) {
            case APART -> of(compare(k.way, q, k.radius) <= 0);
            case TOUCHING -> of(!hasBetween(k.way, q, k.radius));
            case OVERLAPPING -> deepens(k, q);
        };
    }

    private static Answer of(boolean isBlocked) {
        return isBlocked ? Answer.BLOCKED : Answer.FREE;
    }

    private Start start(Mover k, List<Rational[]> q) {
        if (compare(k.from, q, k.radius) > 0) {
            return Start.APART;
        }
        return hasBetween(k.from, q, k.radius) ? Start.TOUCHING : Start.OVERLAPPING;
    }

    /** Whether a contact at the start has a plane that the move does not cross and a piece is wholly behind. */
    private boolean isBehind(Mover k, List<Rational[]> q) {
        for (Mover i : movers) {
            if (i.radius.signum() > 0 && i != k) {
                throw new IllegalArgumentException("what is round must be one piece (got: " + movers.size() + ")");
            }
            for (List<Rational[]> p : others) {
                if (start(i, p) == Start.TOUCHING) {
                    List<Rational[]> upper = new ArrayList<>(i.way);
                    upper.addAll(i == k ? List.of() : k.way);
                    List<Rational[]> lower = new ArrayList<>(p);
                    lower.addAll(q);
                    if (hasBetween(upper, lower, k.radius)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** Sign of the distance of two hulls less a radius. */
    private static int compare(List<Rational[]> a, List<Rational[]> b, Rational radius) {
        if (Simplex.meet(a, b)) {
            return radius.signum() > 0 ? -1 : 0;
        }
        return radius.signum() == 0 ? 1 : square(differences(a, b)).compareTo(radius.square());
    }

    /**
     * Whether a plane is between two hulls, the one grown by a radius; asked where they touch or overlap. For a radius of 0
     * there is none where each direction leads from the origin into the hull of the differences.
     */
    private static boolean hasBetween(List<Rational[]> upper, List<Rational[]> lower, Rational radius) {
        if (radius.signum() > 0) {
            return compare(upper, lower, radius) >= 0;
        }
        List<Rational[]> differences = differences(upper, lower);
        int axes = upper.get(0).length;
        for (int k = 0; k <= axes; k++) {
            Rational[] start = new Rational[axes];
            Rational[] back = new Rational[axes];
            for (int m = 0; m < axes; m++) {
                start[m] = Rational.of(k == axes ? -1 : k == m ? 1 : 0);
                back[m] = start[m].negate();
            }
            Rational enter = Simplex.enter(start, back, differences);
            if (enter == null || enter.compareTo(Rational.of(1)) >= 0) {
                return true;
            }
        }
        return false;
    }

    private static List<Rational[]> differences(List<Rational[]> a, List<Rational[]> b) {
        List<Rational[]> differences = new ArrayList<>();
        for (Rational[] p : a) {
            for (Rational[] q : b) {
                differences.add(Rational.minus(q, p));
            }
        }
        return differences;
    }

    /** The square of the distance from the origin to a hull that does not hold it: over all corners, pairs and triples. */
    private static Rational square(List<Rational[]> hull) {
        Rational least = null;
        for (int i = 0; i < hull.size(); i++) {
            Rational[] w = hull.get(i);
            least = lesser(least, Rational.dot(w, w));
            for (int j = i + 1; j < hull.size(); j++) {
                Rational[] e = Rational.minus(hull.get(j), w);
                least = lesser(least, ofSegment(w, e));
                for (int k = j + 1; k < hull.size() && w.length == 3; k++) {
                    least = lesser(least, ofTriangle(w, e, Rational.minus(hull.get(k), w)));
                }
            }
        }
        if (least == null) {
            throw new IllegalArgumentException("hull must have points");
        }
        return least;
    }

    private static @Nullable Rational lesser(@Nullable Rational a, @Nullable Rational b) {
        return a == null || (b != null && b.compareTo(a) < 0) ? b : a;
    }

    private static @Nullable Rational ofSegment(Rational[] w, Rational[] e) {
        Rational along = Rational.dot(w, e).negate();
        Rational length = Rational.dot(e, e);
        return along.signum() > 0 && along.compareTo(length) < 0
                ? Rational.dot(w, w).minus(along.square().over(length))
                : null;
    }

    private static @Nullable Rational ofTriangle(Rational[] w, Rational[] e, Rational[] f) {
        Rational ee = Rational.dot(e, e);
        Rational ef = Rational.dot(e, f);
        Rational ff = Rational.dot(f, f);
        Rational we = Rational.dot(w, e).negate();
        Rational wf = Rational.dot(w, f).negate();
        Rational area = ee.times(ff).minus(ef.square());
        if (area.signum() == 0) {
            return null;
        }
        Rational u = we.times(ff).minus(wf.times(ef)).over(area);
        Rational v = wf.times(ee).minus(we.times(ef)).over(area);
        if (u.signum() < 0 || v.signum() < 0 || u.plus(v).compareTo(Rational.of(1)) > 0) {
            return null;
        }
        return Rational.dot(w, w).minus(u.times(we)).minus(v.times(wf));
    }

    /** Whether a move out of an overlap is against every direction of least depth. */
    private Answer deepens(Mover k, List<Rational[]> q) {
        if (k.radius.signum() > 0) {
            return Answer.UNKNOWN;
        }
        Rational least = null;
        boolean against = true;
        for (Rational[] normal : normals(edges(k.from), edges(q))) {
            for (int side = -1; side <= 1; side += 2) {
                Rational[] n = new Rational[normal.length];
                for (int m = 0; m < n.length; m++) {
                    n[m] = side < 0 ? normal[m].negate() : normal[m];
                }
                Rational depth = greatest(n, q).minus(least(n, k.from));
                Rational square = depth.square().over(Rational.dot(n, n));
                int order = least == null ? -1 : square.compareTo(least);
                boolean isAgainst = Rational.dot(n, displacement).signum() < 0;
                if (order < 0) {
                    least = square;
                    against = isAgainst;
                } else if (order == 0) {
                    against &= isAgainst;
                }
            }
        }
        return of(against);
    }

    private static List<Rational[]> edges(List<Rational[]> corners) {
        List<Rational[]> edges = new ArrayList<>();
        for (int k = 0; k < corners.size(); k++) {
            // Of a box from its first corner, of a triangle from each to the next.
            boolean isBox = corners.size() == 8;
            int to = isBox ? k : (k + 1) % corners.size();
            if (!isBox || Integer.bitCount(k) == 1) {
                edges.add(Rational.minus(corners.get(to), corners.get(isBox ? 0 : k)));
            }
        }
        return edges;
    }

    /** Directions of the sides of the difference of two polytopes, among others. */
    private List<Rational[]> normals(List<Rational[]> a, List<Rational[]> b) {
        List<Rational[]> all = new ArrayList<>(a);
        all.addAll(b);
        List<Rational[]> normals = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            Rational[] e = all.get(i);
            if (flat) {
                normals.add(new Rational[] {e[1].negate(), e[0]});
                continue;
            }
            for (int j = i + 1; j < all.size(); j++) {
                Rational[] f = all.get(j);
                normals.add(new Rational[] {
                    e[1].times(f[2]).minus(e[2].times(f[1])),
                    e[2].times(f[0]).minus(e[0].times(f[2])),
                    e[0].times(f[1]).minus(e[1].times(f[0]))
                });
            }
        }
        normals.removeIf(n -> Rational.dot(n, n).signum() == 0);
        return normals;
    }

    private static Rational greatest(Rational[] n, List<Rational[]> points) {
        Rational most = Rational.dot(n, points.get(0));
        for (Rational[] p : points) {
            most = most.max(Rational.dot(n, p));
        }
        return most;
    }

    private static Rational least(Rational[] n, List<Rational[]> points) {
        Rational least = Rational.dot(n, points.get(0));
        for (Rational[] p : points) {
            least = least.negate().max(Rational.dot(n, p).negate()).negate();
        }
        return least;
    }
}
