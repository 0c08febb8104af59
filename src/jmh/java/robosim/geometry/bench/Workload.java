package robosim.geometry.bench;

import java.lang.management.ManagementFactory;
import java.util.function.Function;
import java.util.function.IntToDoubleFunction;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** One task of so many queries on a built scene, with the answer that it must give each time. */
final class Workload {
    /** How many hits a run of a task found, and the sum of what it answered. */
    record Answer(long hits, double sum) {
        boolean agrees(Answer other) {
            return hits == other.hits && Math.abs(sum - other.sum) <= 1e-9 * Math.abs(other.sum);
        }
    }

    /** What it is called: the module's own are measured against all others of the same work and size. */
    record Title(String peer, String work, String size) {}

    /**
     * What the queries of a workload read.
     *
     * @param root  what can be reached from it is counted in bytes, without the objects that a user holds anyway
     * @param parts how many objects or triangles it holds
     * @param ask   one of the queries, by its number below {@code queries}
     */
    record Structure(Object root, long parts, int queries, IntToDoubleFunction ask) {}

    /** What is made before the clock starts, and what is timed. */
    static final class Task<T> {
        private final Supplier<T> before;
        private final Function<T, Answer> timed;

        Task(Supplier<T> before, Function<T, Answer> timed) {
            this.before = before;
            this.timed = timed;
        }

        private Answer run(long[] nanos) {
            T made = before.get();
            nanos[0] = now();
            Answer answer = timed.apply(made);
            nanos[1] = now();
            return answer;
        }
    }

    /** Time, or with -Dclock=cpu what the thread has had of it: for a look at a machine that is busy with other things. */
    static long now() {
        return IS_CPU ? ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() : System.nanoTime();
    }

    private static final boolean IS_CPU = System.getProperty("clock", "").equals("cpu");

    static final String MODULE = "robosim";

    private final Title title;
    private final long queries;
    private final double buildMillis;
    private final Answer truth;
    private final Task<?> task;
    private final @Nullable Structure structure;
    private final long[] nanos = new long[2];

    /** A null truth takes the first answer for it. */
    Workload(Title title, long queries, double buildMillis, Task<?> task, @Nullable Answer truth) {
        this(title, queries, buildMillis, task, truth, null);
    }

    Workload(
            Title title,
            long queries,
            double buildMillis,
            Task<?> task,
            @Nullable Answer truth,
            @Nullable Structure structure) {
        this.structure = structure;
        this.title = title;
        this.queries = queries;
        this.buildMillis = buildMillis;
        this.task = task;
        this.truth = truth == null ? task.run(nanos) : truth;
    }

    Answer truth() {
        return truth;
    }

    String peer() {
        return title.peer;
    }

    String work() {
        return title.work;
    }

    String size() {
        return title.size;
    }

    @Nullable
    Structure structure() {
        return structure;
    }

    /** Runs for a second, but at least twice. */
    void warmUp() {
        long start = System.nanoTime();
        measure();
        do {
            measure();
        } while (System.nanoTime() - start < 1_000_000_000L);
    }

    /** Nanoseconds a query. */
    double measure() {
        Answer answer = task.run(nanos);
        if (!answer.agrees(truth)) {
            throw new IllegalStateException(title + " must answer " + truth + " (got: " + answer + ")");
        }
        return (nanos[1] - nanos[0]) / (double) queries;
    }

    void print(double nanos) {
        Timing.print(
                "%s %s %s %.1f %d %.6f %.2f",
                title.peer, title.work, title.size, nanos, truth.hits, truth.sum, buildMillis);
    }
}
