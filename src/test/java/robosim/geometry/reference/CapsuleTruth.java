package robosim.geometry.reference;

import static robosim.geometry.reference.Vectors.atMost;
import static robosim.geometry.reference.Vectors.cross;
import static robosim.geometry.reference.Vectors.dot;
import static robosim.geometry.reference.Vectors.minus;
import static robosim.geometry.reference.Vectors.plus;

import robosim.geometry.reference.Quantity.Arithmetic;
import robosim.geometry.reference.Truth.Form;

/** Yes or no about capsules: a capsule is all that a ball meets on its way from one end of the segment to the other. */
final class CapsuleTruth {
    private CapsuleTruth() {}

    /** In space, beside a sphere, a box, a triangle or another capsule. */
    static boolean spatial(Arithmetic n, Form formA, double[] a, Form formB, double[] b) {
        if (!formA.isCapsule()) {
            return spatial(n, formB, b, formA, a);
        }
        Quantity[] arm = arm(n, formA, a);
        Quantity[] from = minus(centre(n, a), arm);
        Quantity[] way = plus(arm, arm);
        if (!formB.isCapsule()) {
            if (formB.isCylinder()) {
                throw new IllegalArgumentException("no oracle for a capsule and a cylinder (got: " + formB + ")");
            }
            return WayTruth.ball(n, from, way, n.of(a[3]), formB, b);
        }
        Quantity[] otherArm = arm(n, formB, b);
        Quantity[] otherFrom = minus(centre(n, b), otherArm);
        Quantity[] otherWay = plus(otherArm, otherArm);
        Quantity both = n.of(a[3]).plus(n.of(b[3]));
        return areNear(from, way, otherFrom, otherWay, both.times(both));
    }

    /** Whether two segments are within a root of each other: at an end of either, or between all ends. */
    private static boolean areNear(Quantity[] p, Quantity[] d, Quantity[] q, Quantity[] e, Quantity most) {
        Quantity[] w = minus(q, p);
        return Hull.isNearSegment(w, d, most)
                || Hull.isNearSegment(plus(w, e), d, most)
                || Hull.isNearSegment(Vectors.negate(w), e, most)
                || Hull.isNearSegment(minus(d, w), e, most)
                || WayTruth.isNearWithin(w, d, e, most);
    }

    /** In the plane, a turned capsule beside a disc. */
    static boolean planar(Arithmetic n, Form formA, double[] a, Form formB, double[] b) {
        if (formA != Form.CAPSULE) {
            return planar(n, formB, b, formA, a);
        }
        if (!formB.isRound() || formB == Form.CAPSULE) {
            throw new IllegalArgumentException("no oracle for a turned capsule (got: beside " + formB + ")");
        }
        Quantity[] arm = flatArm(n, a);
        Quantity[] from = minus(Truth.flat(n, a), arm);
        Quantity both = n.of(a[3]).plus(n.of(b[3]));
        return Hull.isNearSegment(minus(Truth.flat(n, b), from), plus(arm, arm), both.times(both));
    }

    static boolean planarRay(Arithmetic n, Quantity[] start, Quantity[] direction, double[] row) {
        return isHit(start, direction, Truth.flat(n, row), flatArm(n, row), n.of(row[3]));
    }

    static boolean spatialRay(Arithmetic n, Quantity[] start, Quantity[] direction, Form form, double[] row) {
        return isHit(start, direction, centre(n, row), arm(n, form, row), n.of(row[3]));
    }

    /** Whether a ray passes a segment within a radius: at its start, at an end of the segment, or between these. */
    private static boolean isHit(
            Quantity[] start, Quantity[] direction, Quantity[] centre, Quantity[] arm, Quantity radius) {
        Quantity[] from = minus(centre, arm);
        Quantity[] along = plus(arm, arm);
        Quantity most = radius.times(radius);
        if (Hull.isNearSegment(minus(start, from), along, most)
                || Truth.ballIsHit(start, direction, from, radius)
                || Truth.ballIsHit(start, direction, plus(centre, arm), radius)) {
            return true;
        }
        // The two lines are nearest each other ahead of the start and between the ends.
        Quantity[] w = minus(from, start);
        Quantity[] across = cross(direction, along);
        Quantity whole = dot(across, across);
        if (whole.signum() == 0) {
            return false;
        }
        Quantity height = dot(w, across);
        Quantity share = dot(cross(w, direction), across);
        return atMost(height.times(height), most.times(whole))
                && dot(cross(w, along), across).signum() >= 0
                && share.signum() >= 0
                && atMost(share, whole);
    }

    private static Quantity[] arm(Arithmetic n, Form form, double[] row) {
        Quantity[] axis = form == Form.CAPSULE ? Vectors.of(n, row[7], row[10], row[13]) : Vectors.of(n, 0, 1, 0);
        return Vectors.times(axis, n.of(row[4]));
    }

    private static Quantity[] flatArm(Arithmetic n, double[] row) {
        return Vectors.times(Vectors.of(n, row[7], 0, row[13]), n.of(row[4]));
    }

    private static Quantity[] centre(Arithmetic n, double[] row) {
        return Vectors.of(n, row[0], row[1], row[2]);
    }
}
