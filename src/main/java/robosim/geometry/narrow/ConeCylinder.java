package robosim.geometry.narrow;

import static robosim.geometry.narrow.RayMath.U;

/**
 * The least distance from a cone's apex to a solid cylinder inside the cone: a lower bound that is certain, within
 * 2^-40 of the truth (seen so down to grazes of 10^-13 of the radius, where the direction that proves the most is found
 * and weighed in pairs of doubles). Apart only where a plane proves it by more than 24u of the coordinates.
 *
 * <p>The distance is the largest {@code k(n) / s(n)} over directions n, where {@code k(n)} is the least n.x of the
 * cylinder and {@code s(n)} the support of the cone's part inside the unit sphere. Where the nearest point of the whole
 * cylinder is outside the cone only {@code n = v + t w} counts, t at least 0: v runs along the cone's border at some
 * angle about its axis, w is the border's outward normal there, and {@code s(n) = 1}. For one angle the best t is in
 * closed form; so is the point x of the cylinder, not beyond the border's tangent plane, that minimises v.x, and the
 * side of the border on which x lies tells on which side the best angle is. That is bisected; every step's
 * {@code k(n)}, less its rounding, is a certain lower bound whatever the step was worth.
 */
final class ConeCylinder {
    /** Halvings of the angle: then it is as good as doubles tell. */
    private static final int STEPS = 60;

    /** The share of the distance that a further halving must be able to add. */
    private static final double ENOUGH = 0x1p-44;

    /** k(v + t w) is a sum of few products of numbers below the extent times 1 + t, each off by a few u. */
    static final double BOUND_ERROR = 24 * U;

    /** Tried where rounding hides how large the best t is, as the cone all but misses. */
    private static final double GRAZING = 0x1p26;

    private final ConeCylinderFrame frame = new ConeCylinderFrame();
    private final ConeCylinderLean lean = new ConeCylinderLean();
    private final ConeCylinderRefine refine = new ConeCylinderRefine();

    // What the last angle told: the best certain bound, whether the cylinder is proved apart, where x lies aside of the
    // border, and how fast that changes the bound.
    private double best;
    private boolean isApart;
    private double aside;
    private double rate;

    // Its best t and what k(n) is there, rounding and all.
    private double value;
    private double share;
    private double lastY;
    private double lastZ;

    // The direction with the greatest k(n) of all that were looked at, without regard to rounding.
    private double bestValue;
    private double bestShare;
    private double bestY;
    private double bestZ;

    /** The distance; the apex is outside the cylinder. */
    double distance(Cone cone, double[] b, int j, double axisX, double axisY, double axisZ) {
        frame.set(cone, b, j, axisX, axisY, axisZ);
        best = Math.max(0, frame.nearest - BOUND_ERROR * frame.extent);
        if (frame.isNearestInside) {
            return best;
        }
        if (search() && best > 0) {
            best = Math.max(best, refine.polish(frame, b, j, axisX, axisY, axisZ, bestShare, bestY, bestZ));
            best = Math.max(best, refine.polish(frame, b, j, axisX, axisY, axisZ, share, lastY, lastZ));
        }
        return isApart ? Double.POSITIVE_INFINITY : best;
    }

    // Whether the bounds are worth another look: they are not where the cylinder is apart.
    private boolean search() {
        bestValue = Double.NEGATIVE_INFINITY;
        double alongAxis = frame.radius * Math.sqrt(Math.max(0, (1 - frame.ax) * (1 + frame.ax)))
                + frame.half * Math.abs(frame.ax);
        isApart = frame.cx + alongAxis < -BOUND_ERROR * frame.extent;
        if (isApart) {
            return false;
        }
        look(1, 0);
        if (isApart) {
            return false;
        }
        double fromY = 1;
        double fromZ = 0;
        double toY = 1;
        double toZ = 0;
        // From the first angle once around to itself; the halves of that, and of them, are no sums of their ends.
        double turn = aside >= 0 ? 1 : -1;
        double midY = -1;
        double midZ = 0;
        double width = 2 * Math.PI;
        double fromValue = value;
        for (int i = 0; i < STEPS; i++) {
            look(midY, midZ);
            if (isApart) {
                return false;
            }
            width /= 2;
            if (Math.abs(aside) * rate * width <= ENOUGH * best && i > 2) {
                break;
            }
            // What is at least as good as the beginning is all ahead of it without a gap: a worse place is beyond.
            boolean isAhead = aside * turn >= 0 && value >= fromValue;
            if (isAhead) {
                fromValue = value;
                fromY = midY;
                fromZ = midZ;
            } else {
                toY = midY;
                toZ = midZ;
            }
            if (i == 0) {
                midY = 0;
                midZ = isAhead ? -turn : turn;
            } else {
                double y = fromY + toY;
                double z = fromZ + toZ;
                double size = Math.sqrt(y * y + z * z);
                midY = y / size;
                midZ = z / size;
            }
        }
        isApart = frame.cx - alongAxis < 0 && lean.isApart(frame);
        return !isApart;
    }

    /** What the border at the angle with this cosine and sine tells. */
    private void look(double y, double z) {
        lastY = y;
        lastZ = z;
        double c = frame.cone.cos;
        double s = frame.cone.sin;
        // Along the border, outward, and around: centre and axis in that frame.
        double outwardC = frame.cy * y + frame.cz * z;
        double outwardA = frame.ay * y + frame.az * z;
        double mv = c * frame.cx + s * outwardC;
        double mw = c * outwardC - s * frame.cx;
        double mb = frame.cz * y - frame.cy * z;
        double av = c * frame.ax + s * outwardA;
        double aw = c * outwardA - s * frame.ax;
        double ab = frame.az * y - frame.ay * z;
        double kappa = Math.sqrt(av * av + ab * ab);
        if (mw - frame.radius * kappa - frame.half * Math.abs(aw) > BOUND_ERROR * frame.extent) {
            isApart = true;
            return;
        }
        double fv = kappa > 0 ? av / kappa : 1;
        double gv = kappa > 0 ? -ab / kappa : 0;
        double t = bound(0, mv, mw, av, aw, ab, 0);
        t = bound(-av / aw, mv, mw, av, aw, ab, t);
        t = bound(stationary(mw - frame.half * aw, kappa, av * aw, gv), mv, mw, av, aw, ab, t);
        t = bound(stationary(mw + frame.half * aw, kappa, av * aw, gv), mv, mw, av, aw, ab, t);
        rate = s + t * c;
        value = least(t, mv, mw, av, aw, ab);
        share = t;
        if (value > bestValue) {
            bestValue = value;
            bestShare = t;
            bestY = y;
            bestZ = z;
        }
        aside = t == 0 ? freePoint(mb, av, aw, ab) : section(mv, mw, mb, aw, kappa, fv, gv);
    }

    // Where k(v + t w) is stationary beside its kink: the radius's part has the slope that the rest has.
    private double stationary(double slope, double kappa, double product, double gv) {
        double square = (frame.radius * kappa - slope) * (frame.radius * kappa + slope);
        if (slope > 0 && !(square > 0)) {
            return GRAZING;
        }
        return slope * Math.abs(gv) / (kappa * Math.sqrt(square)) + product / (kappa * kappa);
    }

    // Takes the bound at t into account where t is a number; answers the t of the better of it and another.
    private double bound(double t, double mv, double mw, double av, double aw, double ab, double other) {
        if (!(t > 0 && t < 0x1p50) && t != 0) {
            return other;
        }
        double value = least(t, mv, mw, av, aw, ab);
        best = Math.max(best, value - BOUND_ERROR * frame.extent * (1 + t));
        return t == 0 || value > least(other, mv, mw, av, aw, ab) ? t : other;
    }

    private double least(double t, double mv, double mw, double av, double aw, double ab) {
        double along = av + t * aw;
        double turn = aw - t * av;
        double across = Math.sqrt((1 + t * t) * ab * ab + turn * turn);
        return mv + t * mw - frame.radius * across - frame.half * Math.abs(along);
    }

    // The point of the cylinder with the least v.x is not beyond the tangent plane: where it lies around the border.
    private double freePoint(double mb, double av, double aw, double ab) {
        // v less its part along the axis, in the frame (v, w, around).
        double qv = aw * aw + ab * ab;
        double qw = -av * aw;
        double qb = -av * ab;
        double size = RayMath.length(qv, qw, qb);
        double inward = size > 0 ? frame.radius / size : 0;
        return mb - (av > 0 ? frame.half : -frame.half) * ab - inward * qb;
    }

    /**
     * Where around the border the point of the tangent plane's section with the least v.x lies. In the plane f runs along
     * the axis's image and g across it; the section is {@code |kappa f - m.a| <= half},
     * {@code (g - m.g)^2 + (aw f - m.k)^2 <= r^2} with {@code k = aw f - kappa w}.
     */
    private double section(double mv, double mw, double mb, double aw, double kappa, double fv, double gv) {
        // f = (fv, -gv) and g = (gv, fv) in (v, around).
        double mf = mv * fv - mb * gv;
        double mg = mv * gv + mb * fv;
        double ma = mf * kappa + mw * aw;
        double mk = aw * mf - kappa * mw;
        double low = Double.NEGATIVE_INFINITY;
        double high = Double.POSITIVE_INFINITY;
        if (kappa > 0) {
            low = (ma - frame.half) / kappa;
            high = (ma + frame.half) / kappa;
        }
        double steep = Math.abs(aw);
        if (steep > 0) {
            double center = mk / aw;
            low = Math.max(low, center - frame.radius / steep);
            high = Math.min(high, center + frame.radius / steep);
        }
        double norm = Math.sqrt(fv * fv + gv * gv * aw * aw);
        double f = fv > 0 ? low : high;
        if (steep > 0 && norm > 0) {
            double free = (mk - Math.copySign(frame.radius, aw) * fv / norm) / aw;
            f = Math.max(low, Math.min(high, free));
        }
        double off = aw * f - mk;
        double chord = Math.sqrt(Math.max(0, (frame.radius - off) * (frame.radius + off)));
        if (gv == 0) {
            // All of the chord is as near: the border passes through it or on one side.
            double g = Math.max(mg - chord, Math.min(mg + chord, 0));
            return g * fv;
        }
        double g = mg - Math.copySign(chord, gv);
        return g * fv - f * gv;
    }
}
