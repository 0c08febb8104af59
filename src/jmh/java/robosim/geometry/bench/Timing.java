package robosim.geometry.bench;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.LongSupplier;

/** Several measures in turn, again and again, so that a machine that drifts drifts for all of them alike. */
final class Timing {
    private Timing() {}

    /**
     * Runs each task so many times in turn after as many unmeasured rounds as warm it up; by the clock of {@link Workload#now}.
     *
     * @return the nanoseconds of each round, by task; a task answers a number, so that its work can not be left out
     */
    static double[][] inTurn(int warmUp, int rounds, LongSupplier... tasks) {
        double[][] nanos = new double[tasks.length][rounds];
        long sum = 0;
        for (int round = -warmUp; round < rounds; round++) {
            for (int task = 0; task < tasks.length; task++) {
                long start = Workload.now();
                sum += tasks[task].getAsLong();
                long end = Workload.now();
                if (round >= 0) {
                    nanos[task][round] = end - start;
                }
            }
        }
        if (sum == 42) {
            System.out.print(""); // the sum is used
        }
        return nanos;
    }

    static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    /** The median, over the rounds, of one task's time over another's. */
    static double ratio(double[] slow, double[] fast) {
        double[] ratios = new double[slow.length];
        for (int k = 0; k < ratios.length; k++) {
            ratios[k] = slow[k] / fast[k];
        }
        return median(ratios);
    }

    static void print(String format, Object... values) {
        System.out.println(String.format(Locale.ROOT, format, values));
    }
}
