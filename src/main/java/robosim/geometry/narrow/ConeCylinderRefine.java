package robosim.geometry.narrow;

/** Bounds of the distance of a cylinder in a cone in pairs of doubles. */
final class ConeCylinderRefine {
    /** Roundoff of a bound in pairs, of which every step is good to 2^-100 of what goes in. */
    private static final double PAIRS_ERROR = 0x1p-94;

    /** From this t on the best is looked for once more. */
    private static final double STEEP = 256;

    private static final int NORMAL = Cone.FREE;
    private static final int CENTER = NORMAL + 3;
    private static final int BODY = CENTER + 3;
    private static final int CROSS = BODY + 3;
    private static final int SUPPORT = CROSS + 3;
    private static final int LEAST = SUPPORT + 1;
    private static final int PART = LEAST + 1;
    private static final int TEMPORARY = PART + 1;

    private ConeCylinderFrame frame = new ConeCylinderFrame();
    private double best;

    /**
     * The greatest certain bound for the direction v + t w at an angle and others near it: a large t comes out of a
     * difference in which most cancels, and is looked for by parabolas, closer and closer.
     */
    double polish(
            ConeCylinderFrame body,
            double[] b,
            int j,
            double axisX,
            double axisY,
            double axisZ,
            double t,
            double y,
            double z) {
        frame = body;
        best = 0;
        double value = inPairs(b, j, axisX, axisY, axisZ, t, y, z);
        double center = t;
        double width = t > STEEP ? 0.5 : 0;
        while (width > 0x1p-12) {
            double less = inPairs(b, j, axisX, axisY, axisZ, center * (1 - width), y, z);
            double more = inPairs(b, j, axisX, axisY, axisZ, center * (1 + width), y, z);
            double bend = (value - less) + (value - more);
            double step = bend > 0 ? (more - less) / (2 * bend) : more > less ? 1 : -1;
            double next = center * (1 + width * Math.max(-1, Math.min(1, step)));
            double there = inPairs(b, j, axisX, axisY, axisZ, next, y, z);
            if (there > value) {
                value = there;
                center = next;
            }
            width *= Math.abs(step) < 1 ? 0.25 : 0.75;
        }
        return best;
    }

    /**
     * The bound {@code k(n) / s(n)} once more in pairs of doubles, for the direction v + t w at an angle as rounded: where
     * the cone grazes the cylinder t is large, and of k(n) little is left.
     */
    private double inPairs(double[] b, int j, double axisX, double axisY, double axisZ, double t, double y, double z) {
        double across = frame.cone.sin + t * frame.cone.cos;
        double ahead = frame.cone.cos - t * frame.cone.sin;
        Pairs p = frame.cone.pairs;
        p.set(NORMAL, ahead * frame.cone.ux + across * (y * frame.ex + z * frame.fx));
        p.set(NORMAL + 1, ahead * frame.cone.uy + across * (y * frame.ey + z * frame.fy));
        p.set(NORMAL + 2, ahead * frame.cone.uz + across * (y * frame.ez + z * frame.fz));
        p.difference(CENTER, b[j], frame.cone.ox);
        p.difference(CENTER + 1, b[j + 1], frame.cone.oy);
        p.difference(CENTER + 2, b[j + 2], frame.cone.oz);
        p.set(BODY, axisX);
        p.set(BODY + 1, axisY);
        p.set(BODY + 2, axisZ);
        double value = ratio(p, b[j + 4], t);
        // Where the best n is square to the axis rounding must not make it reach along the axis.
        p.dot(PART, NORMAL, BODY, TEMPORARY);
        p.dot(LEAST, BODY, BODY, TEMPORARY);
        p.divide(PART, PART, LEAST);
        p.negate(PART);
        p.advance(NORMAL, NORMAL, PART, BODY, TEMPORARY);
        return Math.max(value, ratio(p, b[j + 4], t));
    }

    private double ratio(Pairs p, double halfHeight, double t) {
        // s(n): along the border's direction that is nearest to n; n itself is never inside the cone.
        p.dot(SUPPORT, NORMAL, Cone.AXIS, TEMPORARY);
        p.multiply(SUPPORT, SUPPORT, Cone.COS);
        p.cross(CROSS, NORMAL, Cone.AXIS, TEMPORARY);
        p.dot(LEAST, CROSS, CROSS, TEMPORARY);
        p.root(LEAST, LEAST);
        p.multiply(LEAST, LEAST, Cone.SIN);
        p.add(SUPPORT, SUPPORT, LEAST);
        // k(n) = n.m - r |n x a| / |a| - h |n.a|
        p.cross(CROSS, NORMAL, BODY, TEMPORARY);
        p.dot(PART, CROSS, CROSS, TEMPORARY);
        p.dot(LEAST, BODY, BODY, TEMPORARY);
        p.divide(PART, PART, LEAST);
        p.root(PART, PART);
        p.multiply(PART, PART, frame.radius);
        p.dot(LEAST, NORMAL, CENTER, TEMPORARY);
        p.subtract(LEAST, LEAST, PART);
        p.dot(PART, NORMAL, BODY, TEMPORARY);
        p.multiply(PART, PART, p.get(PART) < 0 ? -halfHeight : halfHeight);
        p.subtract(LEAST, LEAST, PART);
        p.divide(LEAST, LEAST, SUPPORT);
        double support = p.get(SUPPORT);
        if (support > 0) {
            double error = PAIRS_ERROR * frame.extent * (1 + t) / support;
            best = Math.max(best, Math.nextDown(p.get(LEAST) - error));
        }
        return p.get(LEAST);
    }
}
