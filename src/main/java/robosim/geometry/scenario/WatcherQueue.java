package robosim.geometry.scenario;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import robosim.geometry.net.WatchServer;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.SonarRequestBundle;

/**
 * Steps that wait to be told to one watcher. They are handed over as they are, and written as lines by the watcher's own
 * thread.
 */
abstract class WatcherQueue implements WatchServer.Lines {
    /** Most steps that wait: at 1,000 steps a second, ten seconds. */
    static final int MOST_STEPS = 10_000;

    /** Most objects, moves and distances in them, some 60 MB; a single step may have more. */
    static final long MOST_REQUESTS = 1_000_000;

    private final Runnable breakOff;
    private final BlockingQueue<Step> steps = new ArrayBlockingQueue<>(MOST_STEPS);
    private final AtomicLong requests = new AtomicLong();
    private final ByteArrayOutputStream buffer = new ByteArrayOutputStream();
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
        long weight = weight(step.request());
        boolean fits = requests.addAndGet(weight) <= MOST_REQUESTS || steps.isEmpty();
        if (!fits || !steps.offer(step)) {
            problem = "it reads too slowly: " + steps.size() + " steps wait for it";
            steps.clear();
            breakOff.run();
        }
    }

    private static long weight(Bundle request) {
        if (request instanceof InitBundle init) {
            return 1L + init.objects().size();
        }
        if (request instanceof MoveBundle moves) {
            return 1L + moves.moves().size();
        }
        return request instanceof SonarRequestBundle sonars
                ? 1L + sonars.requests().size()
                : 1;
    }

    @Override
    public final byte[] next(long millis) throws IOException, InterruptedException {
        buffer.reset();
        if (writer == null) {
            writer = new ScenarioWriter(buffer, header);
            return buffer.toByteArray();
        }
        Step step = steps.poll(millis, TimeUnit.MILLISECONDS);
        String known = problem;
        if (known != null) {
            throw new IOException(known);
        }
        if (step != null) {
            requests.addAndGet(-weight(step.request()));
            write(writer, step);
        }
        return buffer.toByteArray();
    }

    private void write(ScenarioWriter to, Step step) throws IOException {
        try {
            to.write(step);
        } catch (IOException | IllegalArgumentException e) {
            problem = "a step cannot be written as lines: " + e.getMessage();
            throw e;
        }
    }

    @Override
    public final @Nullable String problem() {
        return problem;
    }
}
