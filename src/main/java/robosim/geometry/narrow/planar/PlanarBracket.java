package robosim.geometry.narrow.planar;

/**
 * A bracket for the distance of any two planar shapes, from their support points: {@link #low} is certified by a
 * separating line, {@link #high} is attained by two points.
 *
 * <p>Let W be the set of differences of a point of the second shape and one of the first. The distance is the maximum
 * over unit directions n of f(n) = min (n . w). The best n has a positive product with every w, and so lies on the side
 * of n to which w(n) leans. The remaining arc of directions halves at least every second step, and shrinks much sooner
 * where the nearest point of the chord between the two ends of the arc gives the next direction (Gilbert, Johnson and
 * Keerthi 1988).
 */
public final class PlanarBracket {
    // Halving an arc of half a turn down to the last bit leaves some eight halvings to spare.
    private static final int STEPS = 2 * 64;

    // f is off by the shapes' errors in two coordinates, plus four roundings of values, which these errors cover.
    private static final double FILTER = 4;

    // Relative width below which further steps change only the last bits.
    private static final double TIGHT = 1 - 0x1p-50;

    /** A lower bound of the distance. */
    double low;

    /** An upper bound of the distance, up to rounding. */
    double high;

    /** The direction of the best separating line, from the first shape to the second. */
    public double normalX;

    public double normalZ;

    /** The error bound of f. */
    double error;

    private double arcFromX;
    private double arcFromZ;
    private double arcToX;
    private double arcToZ;
    private double fromX;
    private double fromZ;
    private double toX;
    private double toZ;
    private double innerX;
    private double innerZ;
    private boolean fromKnown;
    private boolean toKnown;
    private double triedX;
    private double triedZ;

    /** Whether a separating line is certain. */
    public boolean isApart() {
        return low > error;
    }

    /** The distance; 0 where no separating line is certain. */
    public double distance() {
        return isApart() ? low - error : 0;
    }

    /** Narrows the bracket as far as possible, or only until the verdict is certain. */
    public void find(PlanarShape p, PlanarShape q, boolean verdictOnly) {
        error = FILTER * (p.error + q.error);
        low = Double.NEGATIVE_INFINITY;
        innerX = middleX(q) - middleX(p);
        innerZ = middleZ(q) - middleZ(p);
        high = Math.sqrt(innerX * innerX + innerZ * innerZ);
        normalX = 1;
        normalZ = 0;
        if (!(high > error)) {
            high = 0;
            return;
        }
        triedX = innerX / high;
        triedZ = innerZ / high;
        normalX = triedX;
        normalZ = triedZ;
        arcFromX = triedZ;
        arcFromZ = -triedX;
        arcToX = -triedZ;
        arcToZ = triedX;
        fromKnown = false;
        toKnown = false;
        for (int step = 0; step < STEPS; step++) {
            if (!narrow(p, q) || high <= error || (verdictOnly && low > error) || low >= high * TIGHT) {
                return;
            }
            if (!next((step & 1) == 0)) {
                return;
            }
        }
    }

    // Evaluates one support point; false where the two certainly overlap, or nothing better is left.
    private boolean narrow(PlanarShape p, PlanarShape q) {
        double f = -q.support(-triedX, -triedZ) - p.support(triedX, triedZ);
        double wx = q.pointX - p.pointX;
        double wz = q.pointZ - p.pointZ;
        if (f > low) {
            low = f;
            normalX = triedX;
            normalZ = triedZ;
        }
        high = Math.min(high, Math.sqrt(wx * wx + wz * wz));
        double lean = triedX * wz - triedZ * wx;
        if (lean == 0) {
            high = Math.max(0, Math.min(high, f));
            return false;
        }
        if (lean > 0) {
            arcFromX = triedX;
            arcFromZ = triedZ;
            fromX = wx;
            fromZ = wz;
            fromKnown = true;
        } else {
            arcToX = triedX;
            arcToZ = triedZ;
            toX = wx;
            toZ = wz;
            toKnown = true;
        }
        return !(fromKnown && toKnown && surrounds());
    }

    // Whether the triangle of three known differences contains the origin.
    private boolean surrounds() {
        double a = fromX * toZ - fromZ * toX;
        double b = toX * innerZ - toZ * innerX;
        double c = innerX * fromZ - innerZ * fromX;
        boolean in = (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
        if (in) {
            high = 0;
        }
        return in;
    }

    // Chooses the next direction to try; false where the arc is exhausted.
    private boolean next(boolean chord) {
        if (chord && fromKnown && toKnown && chord()) {
            return true;
        }
        double nx = arcFromX + arcToX;
        double nz = arcFromZ + arcToZ;
        double length = Math.sqrt(nx * nx + nz * nz);
        if (!(length > 0x1p-30)) {
            // an arc of half a turn: nothing is known yet
            nx = -arcFromZ;
            nz = arcFromX;
            length = 1;
        }
        triedX = nx / length;
        triedZ = nz / length;
        return isWithinArc();
    }

    private boolean chord() {
        double ex = toX - fromX;
        double ez = toZ - fromZ;
        double square = ex * ex + ez * ez;
        // Both ends of the arc may have the same support point.
        double share = square > 0 ? -(fromX * ex + fromZ * ez) / square : 0;
        share = Math.max(0, Math.min(1, share));
        double vx = fromX + share * ex;
        double vz = fromZ + share * ez;
        double length = Math.sqrt(vx * vx + vz * vz);
        if (!(length > 0)) {
            high = 0;
            return false;
        }
        high = Math.min(high, length);
        if (share > 0 && share < 1) {
            // the chord's own normal is more accurate than its nearest point
            double root = Math.sqrt(square);
            double side = ex * vz - ez * vx > 0 ? 1 : -1;
            triedX = -ez / root * side;
            triedZ = ex / root * side;
        } else {
            triedX = vx / length;
            triedZ = vz / length;
        }
        return isWithinArc();
    }

    private boolean isWithinArc() {
        return arcFromX * triedZ - arcFromZ * triedX > 0 && triedX * arcToZ - triedZ * arcToX > 0;
    }

    private static double middleX(PlanarShape shape) {
        return switch (shape.outline) {
            case POLYGON -> middle(shape.x, shape.count);
            case DISC, OVAL -> shape.centerX;
        };
    }

    private static double middleZ(PlanarShape shape) {
        return switch (shape.outline) {
            case POLYGON -> middle(shape.z, shape.count);
            case DISC, OVAL -> shape.centerZ;
        };
    }

    private static double middle(double[] values, int count) {
        double sum = 0;
        for (int k = 0; k < count; k++) {
            sum += values[k];
        }
        return sum / count;
    }
}
