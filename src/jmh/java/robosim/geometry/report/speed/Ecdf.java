package robosim.geometry.report.speed;

import java.util.Arrays;

/** How values are spread: quantiles of all that were seen, never a mean. */
final class Ecdf {
    /** Shares at which a curve is written down: fine where it ends. */
    static final double[] SHARES = {
        0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.998, 0.999, 0.9995, 0.9998, 0.9999, 1
    };

    private static final double[] FEW = {0.5, 0.9, 0.99, 0.999, 0.9999, 1};

    private double[] values = new double[64];
    private int size;
    private boolean isSorted;

    void add(double value) {
        if (Double.isNaN(value)) {
            throw new IllegalArgumentException("no number has a bar of its own (got: NaN)");
        }
        if (size == values.length) {
            values = Arrays.copyOf(values, 2 * size);
        }
        values[size++] = value;
        isSorted = false;
    }

    int size() {
        return size;
    }

    /** The least value that at least a share of all values does not exceed. */
    double quantile(double share) {
        if (size == 0) {
            throw new IllegalStateException("nothing was seen (got: 0 values)");
        }
        if (!isSorted) {
            Arrays.sort(values, 0, size);
            isSorted = true;
        }
        int rank = (int) Math.ceil(share * size);
        return values[Math.max(0, Math.min(size, rank) - 1)];
    }

    /** Writes the whole curve down, a figure for each share that so many values can tell. */
    void putCurve(Study.Sink sink, Subject subject, String scene, String query, String what) {
        put(SHARES, sink, subject, scene, query, what);
    }

    /** Writes a few quantiles down. */
    void put(Study.Sink sink, Subject subject, String scene, String query, String what) {
        put(FEW, sink, subject, scene, query, what);
    }

    private void put(double[] shares, Study.Sink sink, Subject subject, String scene, String query, String what) {
        sink.put(subject, scene, query, what + " n", size);
        if (size == 0) {
            return;
        }
        for (double share : shares) {
            if (share == 1 || (1 - share) * size >= 0.999) {
                sink.put(subject, scene, query, what + " q" + share, quantile(share));
            }
        }
    }
}
