package robosim.geometry.sweep;

import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.sweep.lines.SweepLines;

/**
 * Runs a sweep, or a shard of it, on a number of threads and writes the results to a file. Each outcome is appended
 * when it is known, as a line with a checksum; if the process is killed, only the replicates under way are lost, one
 * per thread. At the end the file is rewritten in the order of the indices, so that its bytes do not depend on the
 * number of threads or on interruptions. Meanwhile an empty file next to it, {@code FILE.lock}, which remains, keeps
 * other runs from writing to it.
 */
public final class SweepRun {
    private final ParameterSweep sweep;
    private final Path file;
    private Shard shard = Shard.ALL;
    private int threads = 1;
    private boolean isResumed;
    private LongConsumer progress = done -> {};

    private SweepRun(ParameterSweep sweep, Path file) {
        this.sweep = sweep;
        this.file = file;
    }

    /** A run of the whole sweep into a new file, on one thread. */
    public static SweepRun of(ParameterSweep sweep, Path file) {
        Checks.present("sweep", sweep);
        Checks.present("file", file);
        return new SweepRun(sweep, file);
    }

    /** A run of only this part of the sweep. */
    public SweepRun shard(Shard part) {
        Checks.present("shard", part);
        shard = part;
        return this;
    }

    /** A run on a number of threads, at least 1. */
    public SweepRun withThreads(int count) {
        Checks.refuse(count < 1, "threads must be at least 1", count);
        threads = count;
        return this;
    }

    /**
     * A run that continues an existing file, if there is one, of the same sweep, possibly with fewer replicates of each
     * cell. Replicates in the file are not run again.
     */
    public SweepRun resume() {
        isResumed = true;
        return this;
    }

    /** A run with a listener that is called, on any of the threads, with the number of replicates done. */
    public SweepRun progress(LongConsumer listener) {
        Checks.present("progress", listener);
        progress = listener;
        return this;
    }

    /**
     * The number of replicates of the shard.
     *
     * @throws IllegalArgumentException if the sweep has more than {@link #run()} supports
     */
    public long size() {
        checkSize();
        long size = 0;
        for (long index = 0; index < sweep.size(); index++) {
            size += sweep.isOf(shard, index) ? 1 : 0;
        }
        return size;
    }

    /**
     * Carries it out.
     *
     * @return the results, those of earlier runs included
     * @throws IOException if the file already exists, belongs to another sweep, or cannot be written
     * @throws IllegalArgumentException if the sweep has too many replicates, or its header is too long
     */
    public SweepResults run() throws IOException, InterruptedException {
        SweepHeader header = checked();
        if (!isResumed && Files.exists(file)) {
            throw isThere(null);
        }
        try (SweepLock lock = SweepLock.of(file)) {
            if (!isResumed || !Files.exists(file)) {
                Files.createFile(file);
            }
            append(header);
            if (!lock.isValid()) {
                throw new SweepException(file + ": the lock of the file was lost");
            }
            SweepResults.read(List.of(file)).write(file, header);
            return SweepResults.read(List.of(file));
        } catch (FileAlreadyExistsException e) {
            throw isThere(e);
        }
    }

    /** The header, after checking that the sweep can be run and its results read again. */
    private SweepHeader checked() {
        checkSize();
        SweepHeader header = sweep.header();
        header.check();
        return header;
    }

    private void checkSize() {
        Checks.refuse(
                sweep.size() > Integer.MAX_VALUE,
                "a sweep must have at most " + Integer.MAX_VALUE + " replicates",
                sweep.size());
    }

    private SweepException isThere(@Nullable IOException cause) {
        return new SweepException(file + ": it must be a new file, or resume it (got: one that is there)", cause);
    }

    /** Finds the replicates already done, drops an incomplete last line, and appends the missing results. */
    private void append(SweepHeader header) throws IOException, InterruptedException {
        BitSet done = new BitSet();
        BitSet beyond = new BitSet();
        SweepFile before = SweepFile.read(file, header, (outcome, offset, length) -> {
            if (outcome.index() < sweep.size()) {
                done.set((int) outcome.index());
            } else {
                beyond.set(0);
            }
        });
        SweepHeader old = before.header();
        if (old != null && !old.isOfSame(header)) {
            throw new SweepException(
                    file + ": it must be of the same sweep to be resumed; it has " + old.differences(header));
        }
        if (old != null && !beyond.isEmpty()) {
            throw new SweepException(
                    file + ": it has more replicates than asked for (got: " + old.size() + " of " + sweep.size() + ")");
        }
        if (before.torn() > 0) {
            try (FileChannel whole = FileChannel.open(file, StandardOpenOption.WRITE)) {
                whole.truncate(before.end());
            }
        }
        // Not a channel, which would be closed if a scenario left its thread interrupted.
        try (FileOutputStream out = new FileOutputStream(file.toFile(), true)) {
            SweepLines lines = new SweepLines(out);
            if (old == null || old.replicates() != header.replicates()) {
                lines.append(header.sealed());
            }
            carryOut(lines, done);
            out.getFD().sync();
        } catch (IOException e) {
            throw SweepException.on(file, e);
        }
    }

    private void carryOut(SweepLines lines, BitSet done) throws IOException, InterruptedException {
        AtomicLong next = new AtomicLong();
        AtomicLong finished = new AtomicLong();
        AtomicBoolean isOver = new AtomicBoolean();
        AtomicReference<@Nullable Throwable> failure = new AtomicReference<>();
        for (int index = done.nextSetBit(0); index >= 0; index = done.nextSetBit(index + 1)) {
            finished.addAndGet(sweep.isOf(shard, index) ? 1 : 0);
        }
        progress.accept(finished.get());
        Runnable worker = () -> {
            try {
                for (long index = next.getAndIncrement();
                        index < sweep.size() && !isOver.get();
                        index = next.getAndIncrement()) {
                    if (sweep.isOf(shard, index) && !done.get((int) index)) {
                        String line = sweep.run(index).sealed();
                        Thread.interrupted(); // set by the scenario: no other code knows this thread
                        if (!lines.append(line)) {
                            return;
                        }
                        progress.accept(finished.incrementAndGet());
                    }
                }
            } catch (IOException | RuntimeException | Error e) {
                isOver.set(true);
                failure.compareAndSet(null, e);
            }
        };
        join(start(worker), isOver);
        Throwable cause = failure.get();
        if (cause instanceof IOException e) {
            throw e;
        }
        if (cause != null) {
            throw new IllegalStateException("a sweep must not fail itself: " + cause, cause);
        }
    }

    private List<Thread> start(Runnable worker) {
        List<Thread> workers = new ArrayList<>();
        for (int k = 0; k < threads; k++) {
            Thread thread = new Thread(worker, "sweep-" + k);
            thread.setDaemon(true);
            thread.start();
            workers.add(thread);
        }
        return workers;
    }

    private static void join(List<Thread> workers, AtomicBoolean isOver) throws InterruptedException {
        try {
            for (Thread worker : workers) {
                worker.join();
            }
        } catch (InterruptedException e) {
            isOver.set(true);
            for (Thread worker : workers) {
                worker.join();
            }
            throw e;
        }
    }
}
