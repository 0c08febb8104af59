package robosim.geometry.census;

import java.util.function.Supplier;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.mesh.NearestPairs;

/**
 * What the product says of two objects' distance in space, as worlds ask it and as {@code ContactQuery.distance} does,
 * beside a bracket that is known to hold it.
 */
final class DistanceProbe {
    /** What is said of the answer and of the bracket's width, as a share of the distance and of sizes and offset. */
    private static final double SAID = 0x1p-44;

    private final Scratch scratch = new Scratch();
    private final Distance distance = new Distance(scratch);
    private final NearestPairs nearest = new NearestPairs(scratch.overlap);

    /**
     * Compares with the truth, which is in [low, high].
     *
     * @param rounding how far low and high have been moved apart for the twin's own rounding
     */
    Visit compare(
            String regime,
            LeafColumn a,
            LeafColumn b,
            double low,
            double high,
            double size,
            double rounding,
            Supplier<String> objects) {
        double said = SAID * (high + size);
        if (high - low > said + 4 * rounding) {
            return Visit.wrong(regime, "the twin does not know: [%s, %s] of %s".formatted(low, high, objects.get()));
        }
        double answer = distance.between(Dimension.SPATIAL, a, 0, b, 0, Double.POSITIVE_INFINITY);
        for (double limit : new double[] {answer, 1.5 * answer}) {
            double again = distance.between(Dimension.SPATIAL, a, 0, b, 0, limit);
            if (again != answer) {
                return Visit.wrong(
                        regime, "%s, and %s with a limit of %s: %s".formatted(answer, again, limit, objects.get()));
            }
        }
        measure(Dimension.SPATIAL, a, b);
        double early = Math.max((low - answer) / said, ends(low - nearest.high(), rounding));
        double late = Math.max((answer - high) / said, ends(nearest.low() - high, rounding));
        return Visit.number(
                regime,
                Math.max(0, early),
                Math.max(0, late),
                (nearest.high() - nearest.low()) / said,
                () -> "%s and [%s, %s] of [%s, %s]: %s"
                        .formatted(answer, nearest.low(), nearest.high(), low, high, objects.get()));
    }

    /** Finds the bracket of the distance. */
    void measure(Dimension dimension, LeafColumn a, LeafColumn b) {
        nearest.start(dimension, a, b);
        while (!nearest.isMeasured()) {
            nearest.step();
        }
        nearest.close();
    }

    double low() {
        return nearest.low();
    }

    double high() {
        return nearest.high();
    }

    /** A proven end may not pass the truth at all. */
    private static double ends(double beyond, double rounding) {
        return beyond > 0 ? 1 + beyond / rounding : 0;
    }
}
