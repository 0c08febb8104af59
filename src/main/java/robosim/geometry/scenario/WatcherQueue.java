package robosim.geometry.scenario;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import robosim.geometry.net.watch.WatchServer;

/**
 * The steps waiting to be sent to one watcher. They are queued as objects and written as lines by the watcher's own
 * thread.
 */
abstract class WatcherQueue implements WatchServer.Lines {
    /** Maximum number of waiting steps: ten seconds at 1,000 steps a second. */
    static final int MOST_STEPS = 10_000;

    /** Maximum total weight of them, some 60 MB; a single step may have more. */
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

    /** Queues a step; if too much is waiting already, the watcher gets no more. Does not block. */
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
            writer = ScenarioWriter.recording(buffer, header, Long.MAX_VALUE);
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

    /** Writes a step; if that is not possible, tells the watcher why instead and ends. */
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

    /** A buffer for lines. Its size shrinks again after a large step. */
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
