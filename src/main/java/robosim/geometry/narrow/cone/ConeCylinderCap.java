package robosim.geometry.narrow.cone;

import robosim.geometry.exact.VectorMath;

/**
 * The nearest common point of a cone and a cylinder's cap. In the cap's plane, the cone is the inside of one branch of
 * a conic, whose axis is the projection of the cone's and whose vertex is nearest to the apex's foot; the cap is a
 * disc.
 *
 * <p>Perpendicular to that axis both have chords. The {@code gap} from the conic's chord to the disc's is a convex
 * function of the position along the axis. Where it is negative the two meet; where it is 0 the rim is on the cone's
 * border.
 */
final class ConeCylinderCap {
    private static final int STEPS = 110;
    private static final double BESIDE = 0x1p-70;

    private ConeCylinderFrame f = new ConeCylinderFrame();

    /** Whether disc and conic are apart, according to doubles. */
    boolean isMissed;

    /** The point, or the conic's point nearest to the disc: along the axis, away from it and across. */
    double height;

    double p;
    double q;

    /** Where they are apart, a point between the conic and the disc. */
    double betweenP;

    double betweenQ;

    // The plane, turned so that it is above the apex: its height, the cone's axis along it, and the angles at which the
    // conic begins and ends, seen from the apex: sines and cosines, not of length 1.
    private double level;
    private double beginCos;
    private double beginSin;
    private double endCos;
    private double endSin;

    // The disc's centre, along the conic's axis and beside it.
    private double centerAlong;
    private double centerAside;

    // At the last position evaluated.
    private double chord;
    private double aside;
    private double gap;
    private double slope;

    private void set(ConeCylinderFrame frame, double at) {
        f = frame;
        // A plane through the apex would have only directions in common with the cone, so a plane beside it is used.
        level = Math.max(Math.abs(at), BESIDE * f.extent);
        height = Math.copySign(level, at);
        double ua = at < 0 ? -f.ua : f.ua;
        double c = f.cone.cos;
        double s = f.cone.sin;
        beginCos = ua * c + f.across * s;
        beginSin = f.across * c - ua * s;
        endCos = ua * c - f.across * s;
        endSin = f.across * c + ua * s;
        boolean isTurned = f.across > 0;
        centerAlong = isTurned ? f.away * (f.up / f.across) : f.away;
        centerAside = isTurned ? f.away * (f.uq / f.across) : 0;
    }

    /** Whether the cone does not reach the plane, according to doubles. */
    boolean isBehind(ConeCylinderFrame frame, double at) {
        set(frame, at);
        return !(beginCos > 0);
    }

    /** Whether the cap contains its plane's nearest point in the cone, which is stored in {@link #p} and {@link #q}. */
    boolean holdsFoot(ConeCylinderFrame frame, double at) {
        set(frame, at);
        double along = beginSin > 0 ? level * beginSin / beginCos : 0;
        place(along, 0);
        double dx = along - centerAlong;
        return dx * dx + centerAside * centerAside <= f.radius * f.radius;
    }

    /** Finds the nearest common point of the rim and the cone's border. */
    void solve(ConeCylinderFrame frame, double at) {
        set(frame, at);
        double begin = beginCos > 0 ? level * beginSin / beginCos : 0;
        double end = endCos > 0 ? level * endSin / endCos : Double.POSITIVE_INFINITY;
        double low = Math.max(begin, centerAlong - f.radius);
        double high = Math.min(end, centerAlong + f.radius);
        isMissed = !(low <= high);
        if (isMissed) {
            place((low + high) / 2, centerAside);
            betweenP = p;
            betweenQ = q;
            place(low == begin ? begin : end, 0);
            return;
        }
        double middle = lowest(low, high);
        if (gap > 0) {
            isMissed = true;
            place(middle, (chord + aside) / 2);
            betweenP = p;
            betweenQ = q;
            place(middle, chord);
            return;
        }
        double first = crossing(low, middle);
        double firstAside = chord;
        double last = crossing(high, middle);
        if (first * first + firstAside * firstAside <= last * last + chord * chord) {
            place(first, firstAside);
        } else {
            place(last, chord);
        }
    }

    private void place(double along, double beside) {
        boolean isTurned = f.across > 0;
        double c = isTurned ? f.up / f.across : 1;
        double s = isTurned ? f.uq / f.across : 0;
        p = along * c + beside * s;
        q = along * s - beside * c;
    }

    // The position with the least gap, or the first found where it is negative.
    private double lowest(double low, double high) {
        double from = low;
        double to = high;
        double at = low + (high - low) / 2;
        for (int i = 0; i < STEPS; i++) {
            at = from + (to - from) / 2;
            look(at);
            if (gap <= 0 || slope == 0 || !(at > from && at < to)) {
                break;
            }
            if (slope < 0) {
                from = at;
            } else {
                to = at;
            }
        }
        return at;
    }

    // Where the gap is 0 between an end where it is not negative and a middle where it is not positive.
    private double crossing(double end, double middle) {
        look(end);
        if (gap <= 0) {
            chord = Math.max(0, aside);
            return end;
        }
        double outside = end;
        double inside = middle;
        double atOutside = gap;
        look(middle);
        double atInside = gap;
        int side = 0;
        for (int i = 0; i < STEPS; i++) {
            double at = inside + (outside - inside) * (atInside / (atInside - atOutside));
            boolean isBetween = Math.min(inside, outside) < at && at < Math.max(inside, outside);
            if (i % 3 == 2 || !isBetween) {
                at = inside + (outside - inside) / 2;
                isBetween = Math.min(inside, outside) < at && at < Math.max(inside, outside);
            }
            if (!isBetween) {
                break;
            }
            look(at);
            if (Math.abs(gap) <= 2 * VectorMath.U * (chord + Math.abs(aside))) {
                return at;
            }
            if (gap > 0) {
                outside = at;
                atOutside = gap;
                atInside = side > 0 ? 0.5 * atInside : atInside;
                side = 1;
            } else {
                inside = at;
                atInside = gap;
                atOutside = side < 0 ? 0.5 * atOutside : atOutside;
                side = -1;
            }
        }
        look(inside);
        return inside;
    }

    private void look(double along) {
        double begin = beginCos * along - beginSin * level;
        double end = endSin * level - endCos * along;
        double square = Math.max(0, begin * end);
        chord = Math.sqrt(square) / f.cone.cos;
        double off = along - centerAlong;
        double half = Math.sqrt(Math.max(0, (f.radius - off) * (f.radius + off)));
        aside = centerAside - half;
        gap = aside - chord;
        double rise = (beginCos * end - endCos * begin) / 2;
        slope = off / half - rise / (chord * f.cone.cos * f.cone.cos);
    }
}
