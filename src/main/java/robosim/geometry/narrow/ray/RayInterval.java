package robosim.geometry.narrow.ray;

import robosim.geometry.exact.Filter;
import robosim.geometry.exact.VectorMath;

/**
 * The part of a ray inside one slab after the other (any set that a line meets in an interval), each end known to a
 * bound. Certain verdicts come out of it, or doubt.
 */
final class RayInterval {
    private static final double U = Filter.bound(VectorMath.U);

    /** About where the ray enters; 0 where it starts inside. */
    double enter;

    /** Which slab it enters last; -1 where it starts inside all. */
    int face;

    // What is known of the entry into that slab, and the latest that the entry into any other may be.
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
     * Keeps what lies in {@code low <= t b <= high}, the three numbers known to the errors that follow them. A slope is
     * taken for 0 only where its error is 0.
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

    /** Whether a quotient of it may underflow, to 0 even, which it is not. */
    private static boolean isVanishing(double offset) {
        return offset != 0 && Math.abs(offset) < 0x1p-900;
    }

    /** Keeps what lies between two parameters, each known to the error that follows it. */
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
            // On the border counts as inside, and is certain where nothing was rounded.
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

    /** Nothing of the ray is left, certainly. */
    boolean isEmpty() {
        return enterLow > leaveHigh;
    }

    /**
     * Something of the ray is left, certainly, and whether it starts inside is certain too, and which slab it enters last:
     * by an edge two are as good as tied, and the distance to the wrong one would be off by more than a few ulp.
     */
    boolean isCertain() {
        return !doubtful && enterHigh <= leaveLow && (enterHigh == 0 || (enterLow > 0 && othersHigh <= faceLow));
    }
}
