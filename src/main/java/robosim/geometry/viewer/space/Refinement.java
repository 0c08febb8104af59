package robosim.geometry.viewer.space;

import java.util.ArrayList;
import java.util.List;

/**
 * In which steps a picture becomes fine: first as coarse as it must be to appear at once, then each time with twice as many
 * pixels along each side, and last with several samples in each pixel.
 */
public final class Refinement {
    /** The side in pixels of the coarsest squares. */
    static final int COARSEST = 16;

    /** Samples along each side of a pixel in the last step. */
    static final int FINEST = 2;

    /** Time in nanoseconds that the first step may take: that of a frame while the mouse is dragged. */
    static final long AT_ONCE = 40_000_000;

    /** How much of a new measurement enters into the mean. */
    private static final double NEWER = 0.3;

    /** Nanoseconds that a sample takes, measured; at first a cautious guess. */
    private double perSample = 1500;

    /**
     * One rendering of the whole picture.
     *
     * @param side    of the squares in pixels that are rendered as one
     * @param samples along each side of a square
     */
    public record Step(int side, int samples) {
        /** The number of squares in a row or column of that many pixels: the last one may reach beyond it. */
        int squares(int pixels) {
            return (pixels + side - 1) / side;
        }

        /** How many rays a picture of that size takes. */
        long rays(int width, int height) {
            return (long) squares(width) * squares(height) * samples * samples;
        }
    }

    /** Learns from a finished step how long a sample takes. */
    void learn(long rays, long nanos) {
        double measured = Math.max(1.0, (double) nanos / rays);
        perSample += NEWER * (measured - perSample);
    }

    /** The first step of a picture: the finest one that appears at once. */
    Step first(int width, int height) {
        int side = 1;
        while (side < COARSEST && perSample * new Step(side, 1).rays(width, height) > AT_ONCE) {
            side *= 2;
        }
        return new Step(side, 1);
    }

    /** What follows a step; the step itself if the picture is as fine as it gets. */
    static Step after(Step step) {
        return step.side > 1 ? new Step(step.side / 2, 1) : new Step(1, FINEST);
    }

    /** All steps from the first one on. */
    static List<Step> from(Step first) {
        List<Step> steps = new ArrayList<>();
        Step step = first;
        while (steps.isEmpty() || !steps.get(steps.size() - 1).equals(step)) {
            steps.add(step);
            step = after(step);
        }
        return steps;
    }
}
