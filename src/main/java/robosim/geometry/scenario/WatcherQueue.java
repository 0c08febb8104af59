package robosim.geometry.scenario;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import robosim.geometry.net.WatchServer;

/**
 * Steps that wait to be told to one watcher. They are handed over as they are, and written as lines by the watcher's own
 * thread.
 */
abstract class WatcherQueue implements WatchServer.Lines {
    /** Most steps that wait: at 1,000 steps a second, ten seconds. */
    static final int MOST_STEPS = 10_000;

    /** Most weight in them, some 60 MB; a single step may have more. */
    static final long MOST_WEIGHT = 1_000_000;

    private final Runnable breakOff;
    private final BlockingQueue<Step> steps = new ArrayBlockingQueue<>(MOST_STEPS);
    private final AtomicLong weight = new AtomicLong();
    private final Buffer buffer = new Buffer();
    private final ScenarioHeader header;
    private @Nullable ScenarioWriter writer;
    private volatile @Nullable String problem;

    WatcherQueue(ScenarioHeader header, Runnable breakOff) {
        this.header = header;
        this.breakOff = breakOff;
    }

    /** Hands a step over; where too much waits already, the watcher is told no more. Waits for nobody. */
    final void offer(Step step) {
        if (problem != null) {
            return;
        }
        boolean fits = weight.addAndGet(StepWeight.of(step)) <= MOST_WEIGHT || steps.isEmpty();
        if (!fits || !steps.offer(step)) {
            problem = "it reads too slowly: " + steps.size() + " steps wait for it";
            steps.clear();
            breakOff.run();
        }
    }

    @Override
    public final byte[] next(long millis) throws IOException, InterruptedException {
        if (writer == null) {
            writer = new ScenarioWriter(buffer, header);
            return buffer.take();
        }
        Step step = problem != null ? null : steps.poll(millis, TimeUnit.MILLISECONDS);
        String known = problem;
        if (known != null) {
            throw new IOException(known);
        }
        if (step != null) {
            weight.addAndGet(-StepWeight.of(step));
            write(writer, step);
        }
        return buffer.take();
    }

    /** Where that is not possible, the watcher is told why instead, as the last thing. */
    private void write(ScenarioWriter to, Step step) throws IOException {
        try {
            to.write(step);
        } catch (IOException | IllegalArgumentException e) {
            problem = "a step cannot be written as lines: " + e.getMessage();
            steps.clear();
            to.note(problem);
        }
    }

    @Override
    public final @Nullable String problem() {
        return problem;
    }

    /** Lines on their way out. What a large step needed is not kept for the small ones after it. */
    static final class Buffer extends ByteArrayOutputStream {
        private static final int KEPT = 1 << 16;

        synchronized byte[] take() {
            byte[] all = toByteArray();
            reset();
            if (buf.length > KEPT) {
                buf = new byte[KEPT];
            }
            return all;
        }

        synchronized int room() {
            return buf.length;
        }
    }
}
