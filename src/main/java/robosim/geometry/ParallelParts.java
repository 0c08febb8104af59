package robosim.geometry;

import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;

/**
 * Work in parts, each of which has the same answers whoever does it. The calling thread does all parts that nobody else has
 * taken, so it waits only for helpers that have begun.
 *
 * @param <W> what a thread works with, and no other one at the same time
 */
abstract class ParallelParts<W> {
    private final int parts;
    private final AtomicInteger taken = new AtomicInteger();

    /** Helpers at work. */
    private int helpers;

    /** Whether it is too late to begin. */
    private boolean isOver;

    private @Nullable Throwable failure;

    ParallelParts(int parts) {
        this.parts = parts;
    }

    /** Gives a helper what it works with. */
    abstract W begin();

    /** Does one part; nobody else does it. */
    abstract void part(W with, int part);

    /** Takes back what a helper has worked with. */
    abstract void end(W with);

    /** Does all parts, on up to so many threads; the calling one has what it works with. */
    final void run(W own, int threads) {
        try {
            for (int k = 1; k < Math.min(threads, parts); k++) {
                ForkJoinTask<?> unused = ForkJoinTask.adapt(this::help).fork();
            }
            work(own);
        } finally {
            awaitHelpers();
        }
        Throwable thrown = failure;
        if (thrown instanceof Error error) {
            throw error;
        }
        if (thrown instanceof RuntimeException exception) {
            throw exception;
        }
    }

    private void work(W with) {
        for (int part = taken.getAndIncrement(); part < parts; part = taken.getAndIncrement()) {
            part(with, part);
        }
    }

    private void help() {
        if (!isInTime()) {
            return;
        }
        Throwable thrown = null;
        try {
            W with = begin();
            work(with);
            end(with);
        } catch (RuntimeException | Error e) { // the calling thread throws it
            thrown = e;
        }
        leave(thrown);
    }

    private synchronized boolean isInTime() {
        if (isOver) {
            return false;
        }
        helpers++;
        return true;
    }

    private synchronized void leave(@Nullable Throwable thrown) {
        if (thrown != null) {
            failure = thrown;
        }
        helpers--;
        notifyAll();
    }

    private synchronized void awaitHelpers() {
        isOver = true;
        boolean isInterrupted = false;
        while (helpers > 0) {
            try {
                wait();
            } catch (InterruptedException e) {
                isInterrupted = true;
            }
        }
        if (isInterrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
