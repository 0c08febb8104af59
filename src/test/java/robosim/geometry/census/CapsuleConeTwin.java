package robosim.geometry.census;

import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.Twofold;
import robosim.geometry.reference.Twofold.Vector;

/**
 * How far a cone hears a capsule, as the nearest of the balls along its segment. How far a ball is from being heard is a convex
 * function of its place, and how far it is heard has no more than one valley: both are found by golden sections in doubles, and
 * evaluated there in some 100 bits.
 */
final class CapsuleConeTwin {
    private static final double GOLDEN = 0.6180339887498949;
    private static final int SECTIONS = 90;

    /** What is nearest is heard at this distance. */
    final double distance;

    /** By how much the ball that is nearest to the cone reaches into it; negative where none does. */
    final double clearance;

    /** Whether the nearest point is on a round end, and whether the ball's centre is in the cone. */
    final boolean isEnd;

    final boolean isInside;

    private final Vector apexToCentre;
    private final Vector arm;
    private final Vector way;
    private final Twofold cos;
    private final Twofold sin;
    private final Twofold radius;

    CapsuleConeTwin(ConeQuestion q) {
        apexToCentre = new Vector(
                Twofold.difference(q.row[0], q.apex[0]),
                Twofold.difference(q.row[1], q.apex[1]),
                Twofold.difference(q.row[2], q.apex[2]));
        double[] axis = axis(q);
        arm = Vector.of(axis[0], axis[1], axis[2]).times(Twofold.of(q.row[4]));
        way = Vector.of(q.way[0], q.way[1], q.way[2]).unit();
        cos = Twofold.of(q.cos);
        sin = Twofold.ONE.minus(cos).times(Twofold.ONE.plus(cos)).root();
        radius = Twofold.of(q.row[3]);
        double nearest = lowest(place -> toCone(at(place)).head());
        clearance = radius.minus(toCone(at(nearest))).head();
        double heard = lowest(place -> key(at(place)));
        Twofold there = heard(at(heard));
        Twofold alsoThere = heard(at(nearest));
        distance = Math.min(there.head(), alsoThere.head());
        isEnd = Math.abs(heard) > 1 - 1e-12;
        isInside = past(at(heard)).signum() <= 0;
    }

    static double[] axis(ConeQuestion q) {
        return q.kind == LeafKind.CAPSULE ? new double[] {q.row[7], q.row[10], q.row[13]} : new double[] {0, 1, 0};
    }

    private interface Function {
        double of(double place);
    }

    /** Where a function with one valley is lowest, from -1 to 1. */
    private static double lowest(Function f) {
        double low = -1;
        double high = 1;
        double s = high - GOLDEN * (high - low);
        double t = low + GOLDEN * (high - low);
        double atS = f.of(s);
        double atT = f.of(t);
        for (int k = 0; k < SECTIONS; k++) {
            if (atS <= atT) {
                high = t;
                t = s;
                atT = atS;
                s = high - GOLDEN * (high - low);
                atS = f.of(s);
            } else {
                low = s;
                s = t;
                atS = atT;
                t = low + GOLDEN * (high - low);
                atT = f.of(t);
            }
        }
        double best = atS <= atT ? s : t; // not between the two: beyond a step there is silence
        for (double end : new double[] {-1, 1}) {
            best = f.of(end) <= f.of(best) ? end : best;
        }
        return best;
    }

    private Vector at(double place) {
        return apexToCentre.plus(arm.times(Twofold.of(place)));
    }

    /** How far a point is beside the cone's border; negative inside. */
    private Twofold past(Vector m) {
        return m.cross(way).length().times(cos).minus(m.dot(way).times(sin));
    }

    private Twofold along(Vector m) {
        return m.dot(way).times(cos).plus(m.cross(way).length().times(sin));
    }

    /** The distance of a point from the cone. */
    private Twofold toCone(Vector m) {
        Twofold past = past(m);
        return past.signum() <= 0 ? Twofold.ZERO : along(m).signum() >= 0 ? past : m.length();
    }

    /** How far the ball about a point is heard, infinite where it is silent. */
    private Twofold heard(Vector m) {
        Twofold distance = m.length();
        if (!radius.isBelow(distance)) {
            return Twofold.ZERO;
        }
        Twofold past = past(m);
        if (past.signum() <= 0) {
            return distance.minus(radius);
        }
        Twofold left = radius.minus(past);
        return left.signum() < 0 || along(m).signum() < 0
                ? Twofold.of(Double.POSITIVE_INFINITY)
                : along(m).minus(left.times(radius.plus(past)).root());
    }

    /** The distance where it is heard, and above all of those where it is not, the more the farther. */
    private double key(Vector m) {
        double heard = heard(m).head();
        return heard < Double.POSITIVE_INFINITY ? heard : 1e6 + toCone(m).head();
    }
}
