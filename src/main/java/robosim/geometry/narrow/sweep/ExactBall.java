package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactMath;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.sat.ExactCapsule;
import robosim.geometry.narrow.sat.ExactPolytope;

/**
 * A sphere translated against a sphere, box or triangle at rest, decided without rounding: its centre hits the set of
 * points within the radius of a corner, an edge or a side. Roots are compared by squaring. Slow.
 */
final class ExactBall {
    private static final StageCounters.Counter EXACT = StageCounters.counter("MovingBall");
    private static final double NEVER = Double.POSITIVE_INFINITY;

    private final ExactVector centre;
    private final ExactVector move;
    private final Dyadic radius;
    private final Dyadic radiusSquare;

    private ExactBall(ExactVector centre, Dyadic radius, ExactVector move) {
        this.centre = centre;
        this.radius = radius;
        this.move = move;
        radiusSquare = radius.square();
    }

    /** As {@link SpatialSweep#translation}, for a sphere against a sphere, box or triangle. */
    static double time(Leaf a, double dx, double dy, double dz, Leaf b) {
        EXACT.count();
        ExactVector move = ExactVector.of(dx, dy, dz);
        Dyadic radius = Dyadic.of(a.get(Leaf.SIZE));
        if (b.kind == LeafKind.SPHERE) {
            ExactBall ball = new ExactBall(ExactVector.at(a.row, a.at), radius.add(Dyadic.of(b.get(Leaf.SIZE))), move);
            ExactVector way = ExactVector.at(b.row, b.at).minus(ball.centre);
            boolean contact = way.square().compareTo(ball.radiusSquare) <= 0;
            return contact ? way.dot(move).signum() > 0 ? 0 : NEVER : ball.cornerTime(ExactVector.at(b.row, b.at));
        }
        ExactBall ball = new ExactBall(ExactVector.at(a.row, a.at), radius, move);
        ExactPolytope polytope = new ExactPolytope(b);
        if (new ExactCapsule(a).touchesPolytope(polytope)) {
            boolean blocked = polytope.contains(ball.centre) ? ball.deeperInside(polytope) : ball.deeper(polytope);
            return blocked ? 0 : NEVER;
        }
        double first = NEVER;
        for (ExactPolytope.Edge edge : polytope.outline()) {
            first = Math.min(first, ball.cornerTime(edge.from()));
            first = Math.min(first, ball.cornerTime(edge.from().plus(edge.along())));
            first = Math.min(first, ball.edgeTime(edge));
        }
        for (ExactPolytope.Side side : polytope.sides()) {
            first = Math.min(first, ball.sideTime(side));
        }
        return first;
    }

    private double cornerTime(ExactVector corner) {
        ExactVector v = corner.minus(centre);
        Dyadic ahead = v.dot(move);
        Dyadic square = move.square();
        Dyadic chord = radiusSquare.multiply(square).subtract(v.cross(move).square());
        return rootTime(v.square().subtract(radiusSquare), ahead, square, chord);
    }

    /** The infinite cylinder around the edge, where its foot lies on the edge; the ends are corners. */
    private double edgeTime(ExactPolytope.Edge edge) {
        ExactVector e = edge.along();
        ExactVector v = edge.from().minus(centre);
        ExactVector away = v.cross(e);
        ExactVector way = move.cross(e);
        Dyadic length = e.square();
        Dyadic square = way.square();
        Dyadic beyond = away.square().subtract(radiusSquare.multiply(length));
        Dyadic ahead = away.dot(way);
        Dyadic chord = radiusSquare
                .multiply(square)
                .subtract(v.cross(move).dot(e).square())
                .multiply(length);
        double time = rootTime(beyond, ahead, square, chord);
        if (time == NEVER) {
            return time;
        }
        // The foot is along the edge by (a - b sqrt(chord)) / square.
        Dyadic b = move.dot(e);
        Dyadic a = ahead.multiply(b).subtract(square.multiply(v.dot(e)));
        boolean on = ExactMath.compareToRoot(a, b, chord) >= 0
                && ExactMath.compareToRoot(a.subtract(length.multiply(square)), b, chord) <= 0;
        return on ? time : NEVER;
    }

    /** The first root (ahead - sqrt(chord)) / square of what is outside at 0, where it lies from 0 to 1. */
    private static double rootTime(Dyadic beyond, Dyadic ahead, Dyadic square, Dyadic chord) {
        if (beyond.signum() <= 0
                || ahead.signum() <= 0
                || chord.signum() < 0
                || ExactMath.compareToRoot(ahead.subtract(square), Dyadic.ONE, chord) > 0) {
            return NEVER;
        }
        double time = ExactMath.floorQuotient(beyond, ahead.add(ExactMath.sqrtUp(chord)));
        Dyadic left = ahead.subtract(square.multiply(Dyadic.of(Math.nextUp(time))));
        return ExactMath.compareToRoot(left, Dyadic.ONE, chord) >= 0 ? Math.nextUp(time) : time;
    }

    /** The plane of a side, moved out by the radius, where the foot lies in the side. */
    private double sideTime(ExactPolytope.Side side) {
        ExactVector w = centre.minus(side.corner());
        ExactVector n = w.dot(side.normal()).signum() < 0 ? side.normal().negate() : side.normal();
        Dyadic height = w.dot(n);
        Dyadic speed = n.dot(move).negate();
        Dyadic square = n.square();
        if (speed.signum() <= 0
                || ExactMath.compareToRoot(height, radius, square) < 0
                || ExactMath.compareToRoot(height.subtract(speed), radius, square) > 0
                || !isFootOn(side, w, height, speed)) {
            return NEVER;
        }
        Dyadic gap = height.square().subtract(radiusSquare.multiply(square));
        Dyadic whole = height.add(radius.multiply(ExactMath.sqrtUp(square))).multiply(speed);
        double time = ExactMath.floorQuotient(gap, whole);
        Dyadic left = height.subtract(speed.multiply(Dyadic.of(Math.nextUp(time))));
        return ExactMath.compareToRoot(left, radius, square) >= 0 ? Math.nextUp(time) : time;
    }

    // At the time (height - r |n|) / speed the foot's shares of the side's edges, times n.n and the speed, are a - b
    // |n|.
    private boolean isFootOn(ExactPolytope.Side side, ExactVector w, Dyadic height, Dyadic speed) {
        ExactVector n = side.normal();
        Dyadic square = n.square();
        Dyadic p = move.cross(side.q()).dot(n);
        Dyadic q = side.p().cross(move).dot(n);
        Dyadic shareP = w.cross(side.q()).dot(n).multiply(speed).add(height.multiply(p));
        Dyadic shareQ = side.p().cross(w).dot(n).multiply(speed).add(height.multiply(q));
        Dyadic whole = square.multiply(speed);
        if (ExactMath.compareToRoot(shareP, radius.multiply(p), square) < 0
                || ExactMath.compareToRoot(shareQ, radius.multiply(q), square) < 0) {
            return false;
        }
        if (side.isParallelogram()) {
            return ExactMath.compareToRoot(shareP.subtract(whole), radius.multiply(p), square) <= 0
                    && ExactMath.compareToRoot(shareQ.subtract(whole), radius.multiply(q), square) <= 0;
        }
        Dyadic sum = shareP.add(shareQ).subtract(whole);
        return ExactMath.compareToRoot(sum, radius.multiply(p.add(q)), square) <= 0;
    }

    /** In contact with the centre in a box: whether the move is against all the sides that are nearest. */
    private boolean deeperInside(ExactPolytope box) {
        Dyadic num = Dyadic.ZERO;
        Dyadic den = Dyadic.ZERO;
        boolean blocked = false;
        for (ExactPolytope.Side side : box.sides()) {
            ExactVector n = side.normal();
            int out = n.dot(side.corner().minus(box.centre)).signum();
            if (out == 0) {
                return false; // flat: out on either side
            }
            Dyadic depth = n.dot(side.corner().minus(centre)).square();
            boolean into = n.dot(move).signum() == -out;
            int order = den.signum() == 0 ? -1 : depth.multiply(den).compareTo(num.multiply(n.square()));
            if (order < 0) {
                num = depth;
                den = n.square();
                blocked = into;
            } else if (order == 0) {
                blocked &= into;
            }
        }
        return blocked;
    }

    /** In contact with the centre outside, or on a triangle: whether the move is towards the nearest point. */
    private boolean deeper(ExactPolytope polytope) {
        Dyadic num = Dyadic.ZERO;
        Dyadic den = Dyadic.ZERO;
        boolean blocked = false;
        for (ExactPolytope.Edge edge : polytope.outline()) {
            ExactVector e = edge.along();
            ExactVector v = edge.from().minus(centre);
            Dyadic length = e.square();
            Dyadic share = v.dot(e).negate();
            ExactVector inward;
            Dyadic scale = Dyadic.ONE;
            if (share.signum() <= 0) {
                inward = v;
            } else if (share.compareTo(length) >= 0) {
                inward = v.plus(e);
            } else {
                inward = v.times(length).plus(e.times(share));
                scale = length.square();
            }
            if (den.signum() == 0 || inward.square().multiply(den).compareTo(num.multiply(scale)) < 0) {
                num = inward.square();
                den = scale;
                blocked = inward.dot(move).signum() > 0;
            }
        }
        for (ExactPolytope.Side side : polytope.sides()) {
            Dyadic height = centre.minus(side.corner()).dot(side.normal());
            Dyadic square = side.normal().square();
            if (side.coversFootOf(centre, Dyadic.ONE)
                    && (den.signum() == 0 || height.square().multiply(den).compareTo(num.multiply(square)) < 0)) {
                num = height.square();
                den = square;
                blocked = side.normal().dot(move).signum() == -height.signum() && height.signum() != 0;
            }
        }
        return blocked;
    }
}
