package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Tasks that are measured in turn, round after round, so that a machine that drifts drifts for all of them alike. */
final class InTurn {
    /** Asks so many queries from one on, and answers something made of all answers. */
    interface Batch {
        double ask(int from, int count);
    }

    private static final class Task {
        final Subject subject;
        final String scene;
        final String query;
        final int queries;
        final Batch batch;
        int count = 1;
        final List<Double> nanos = new ArrayList<>();

        Task(Subject subject, String scene, String query, int queries, Batch batch) {
            this.subject = subject;
            this.scene = scene;
            this.query = query;
            this.queries = queries;
            this.batch = batch;
        }

        /** Nanoseconds for one batch: the first queries, the same in each round. */
        double round() {
            long start = System.nanoTime();
            used = batch.ask(0, count);
            long end = System.nanoTime();
            return end - start;
        }
    }

    /** What all tasks answered, so that none can be left out. */
    static volatile double used;

    private final Form form;
    private final List<Task> tasks = new ArrayList<>();

    InTurn(Form form) {
        this.form = form;
    }

    /** A task that knows so many different queries. */
    void add(Subject subject, String scene, String query, int queries, Batch batch) {
        tasks.add(new Task(subject, scene, query, queries, batch));
    }

    /**
     * Warms all up and measures: of each task the least and the median of its rounds, as nanoseconds a query, and the
     * median of the ratios to the first task of the same scene and query, round by round.
     */
    void run(Study.Sink sink, Study.Progress progress) {
        for (int k = 0; k < tasks.size(); k++) {
            warmUp(tasks.get(k));
            progress.at(0.7 * (k + 1) / tasks.size());
        }
        for (int round = 0; round < form.rounds(); round++) {
            for (Task task : tasks) {
                task.nanos.add(task.round() / task.count);
            }
            progress.at(0.7 + 0.3 * (round + 1) / form.rounds());
        }
        for (Task task : tasks) {
            double[] sorted = sorted(task.nanos);
            sink.put(task.subject, task.scene, task.query, Results.NANOS, sorted[0]);
            sink.put(task.subject, task.scene, task.query, "ns median", sorted[sorted.length / 2]);
            Task first = tasks.stream()
                    .filter(other -> other.scene.equals(task.scene) && other.query.equals(task.query))
                    .findFirst()
                    .orElseThrow();
            List<Double> ratios = new ArrayList<>();
            for (int k = 0; k < task.nanos.size(); k++) {
                ratios.add(task.nanos.get(k) / first.nanos.get(k));
            }
            double[] ratio = sorted(ratios);
            sink.put(task.subject, task.scene, task.query, "ratio", ratio[ratio.length / 2]);
        }
    }

    private static double[] sorted(List<Double> values) {
        double[] sorted = values.stream().mapToDouble(value -> value).toArray();
        Arrays.sort(sorted);
        return sorted;
    }

    /** Runs for a while; then a batch is made as long as a round is to be, but never longer than there are queries. */
    private void warmUp(Task task) {
        double spent = 0;
        double last = 0;
        int rounds = 0;
        while (spent < form.warmMillis() * 1e6 || rounds < 2) {
            last = task.round();
            spent += last;
            rounds++;
            if (last < form.batchMillis() * 5e5) {
                task.count = Math.min(task.queries, task.count * 2);
            }
        }
        double each = Math.max(1, last / task.count);
        double enough = Math.max(form.sample(), form.batchMillis() * 1e6 / each);
        task.count = (int) Math.min(task.queries, enough);
    }
}
