package robosim.geometry.narrow.ray;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.VectorMath;

/**
 * The part of a ray inside a sequence of slabs (any sets that a line meets in an interval), with an error bound for
 * each end. Yields certain verdicts, or doubt.
 */
final class RayInterval {
    private static final double U = FilterBound.bound(VectorMath.U);

    /** Approximately where the ray enters; 0 where it starts inside. */
    double enter;

    /** The slab that it enters last; -1 where it starts inside all. */
    int face;

    // The bounds of the entry into that slab, and the latest possible entry into any other.
    private double faceLow;
    private double faceHigh;
    private double othersHigh;

    private double enterLow;
    private double enterHigh;
    private double leaveLow;
    private double leaveHigh;
    private boolean doubtful;

    void reset() {
        enter = 0;
        face = -1;
        faceLow = 0;
        faceHigh = 0;
        othersHigh = 0;
        enterLow = 0;
        enterHigh = 0;
        leaveLow = Double.POSITIVE_INFINITY;
        leaveHigh = Double.POSITIVE_INFINITY;
        doubtful = false;
    }

    /**
     * Keeps the part where {@code low <= t b <= high}; each of the three numbers is followed by its error bound. A
     * slope counts as 0 only if its error is 0.
     */
    void clip(double low, double lowError, double high, double highError, double b, double bError, int id) {
        double certain = Math.abs(b) - bError;
        if (isVanishing(low) || isVanishing(high)) {
            doubtful = true;
            return;
        }
        if (!(certain > 0x1p-400)) {
            parallel(low, lowError, high, highError, b, bError);
            return;
        }
        boolean up = b > 0;
        double first = (up ? low : high) / b;
        double last = (up ? high : low) / b;
        double firstError = ((up ? lowError : highError) + Math.abs(first) * (bError + 2 * U * certain)) / certain;
        double lastError = ((up ? highError : lowError) + Math.abs(last) * (bError + 2 * U * certain)) / certain;
        clip(first, firstError * (1 + 8 * U), last, lastError * (1 + 8 * U), id);
    }

    /** Whether a quotient of it may underflow, possibly to 0 though it is not 0. */
    private static boolean isVanishing(double offset) {
        return offset != 0 && Math.abs(offset) < 0x1p-900;
    }

    /** Keeps the part between two parameters, each followed by its error bound. */
    void clip(double first, double firstError, double last, double lastError, int id) {
        if (first > enter) {
            othersHigh = Math.max(othersHigh, faceHigh);
            enter = first;
            face = id;
            faceLow = first - firstError;
            faceHigh = first + firstError;
        } else {
            othersHigh = Math.max(othersHigh, first + firstError);
        }
        enterLow = Math.max(enterLow, first - firstError);
        enterHigh = Math.max(enterHigh, first + firstError);
        leaveLow = Math.min(leaveLow, last - lastError);
        leaveHigh = Math.min(leaveHigh, last + lastError);
    }

    private void parallel(double low, double lowError, double high, double highError, double b, double bError) {
        if (b != 0 || bError != 0) {
            doubtful = true;
        } else if (low > lowError || high < -highError) {
            none();
        } else {
            // The border counts as inside, and is certain where nothing was rounded.
            doubtful |= !(low <= -lowError && high >= highError);
        }
    }

    void none() {
        leaveLow = Double.NEGATIVE_INFINITY;
        leaveHigh = Double.NEGATIVE_INFINITY;
    }

    void doubt() {
        doubtful = true;
    }

    /** Whether certainly nothing of the ray is left. */
    boolean isEmpty() {
        return enterLow > leaveHigh;
    }

    /**
     * Whether certainly something of the ray is left, and it is also certain whether it starts inside and which slab it
     * enters last. Near an edge two slabs almost tie, and the distance to the wrong one would be off by more than a few
     * ulp.
     */
    boolean isCertain() {
        return !doubtful && enterHigh <= leaveLow && (enterHigh == 0 || (enterLow > 0 && othersHigh <= faceLow));
    }
}
