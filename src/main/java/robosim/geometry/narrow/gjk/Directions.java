package robosim.geometry.narrow.gjk;

/** A list of unit directions with the depth along each, of which those that tie for the least are kept. */
final class Directions {
    /** Two prisms have 70 from their sides and edges; a search adds some ten. */
    private static final int MOST = 160;

    /** Directions closer than this are one. */
    private static final double SAME = 0x1p-40;

    /** The accuracy of a direction found by a search, since depths are flat near a minimum. */
    private static final double FOUND_SAME = 0x1p-22;

    private int count;

    /** The index from which on the directions come from a search. */
    private int searched;

    private final double[] x = new double[MOST];
    private final double[] y = new double[MOST];
    private final double[] z = new double[MOST];
    private final double[] depths = new double[MOST];

    void clear() {
        count = 0;
        searched = MOST;
    }

    /** Directions added from now on come from a search and are less accurate. */
    void beginSearch() {
        searched = count;
    }

    int count() {
        return count;
    }

    double x(int k) {
        return x[k];
    }

    double y(int k) {
        return y[k];
    }

    double z(int k) {
        return z[k];
    }

    double depth(int k) {
        return depths[k];
    }

    void take(double dx, double dy, double dz, double depth) {
        x[count] = dx + 0.0; // no -0
        y[count] = dy + 0.0;
        z[count] = dz + 0.0;
        depths[count] = depth;
        count++;
    }

    /** The index of the first direction of least depth. */
    int best() {
        int best = 0;
        for (int k = 1; k < count; k++) {
            if (depths[k] < depths[best]) {
                best = k;
            }
        }
        return best;
    }

    double least() {
        return depths[best()];
    }

    /** Negates all directions. */
    void reverse() {
        for (int k = 0; k < count; k++) {
            x[k] = 0 - x[k];
            y[k] = 0 - y[k];
            z[k] = 0 - z[k];
        }
    }

    /** Turns all horizontal directions up or down, and gives them a new depth. */
    void tilt(double cosine, double up, double depth) {
        for (int k = 0; k < count; k++) {
            x[k] *= cosine;
            y[k] = up;
            z[k] *= cosine;
            depths[k] = depth;
        }
    }

    /** Keeps the directions with a depth up to a limit, each once, in the order in which they were added. */
    void keepTies(double limit) {
        int kept = 0;
        for (int k = 0; k < count; k++) {
            if (depths[k] <= limit && isNew(k, kept, k < searched ? SAME : FOUND_SAME)) {
                x[kept] = x[k];
                y[kept] = y[k];
                z[kept] = z[k];
                depths[kept] = depths[k];
                kept++;
            }
        }
        count = kept;
    }

    private boolean isNew(int k, int kept, double same) {
        for (int m = 0; m < kept; m++) {
            double apart = Math.max(Math.abs(x[k] - x[m]), Math.max(Math.abs(y[k] - y[m]), Math.abs(z[k] - z[m])));
            if (apart < same) {
                return false;
            }
        }
        return true;
    }
}
