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
import robosim.geometry.exact.Checks;
import robosim.geometry.sweep.lines.SweepLines;

/**
 * Carries out a sweep, or a shard of it, on some threads, into a file. Each outcome is appended when it is there, as a line
 * with a check sum: who is killed loses what was under way, one replicate a thread. At the end the file is written anew in
 * the order of the indices: its bytes then do not tell how many threads there were, or how often it was killed. All the
 * while an empty file beside it, {@code FILE.lock}, which stays, keeps other runs away.
 */
public final class SweepRun {
    private final Sweep sweep;
    private final Path file;
    private Shard shard = Shard.ALL;
    private int threads = 1;
    private boolean isResumed;
    private LongConsumer progress = done -> {};

    private SweepRun(Sweep sweep, Path file) {
        this.sweep = sweep;
        this.file = file;
    }

    /** A sweep into a new file; all of it, on one thread. */
    public static SweepRun of(Sweep sweep, Path file) {
        Checks.present("sweep", sweep);
        Checks.present("file", file);
        return new SweepRun(sweep, file);
    }

    /** Only this part of it. */
    public SweepRun shard(Shard part) {
        Checks.present("shard", part);
        shard = part;
        return this;
    }

    /** On so many threads, at least 1. */
    public SweepRun threads(int count) {
        if (count < 1) {
            throw new IllegalArgumentException("threads must be at least 1 (got: " + count + ")");
        }
        threads = count;
        return this;
    }

    /**
     * Goes on where the file ends, if there is one: of the same sweep, maybe with fewer replicates of each cell. What is
     * there is not carried out again.
     */
    public SweepRun resume() {
        isResumed = true;
        return this;
    }

    /** Told, from any of the threads, how many replicates of the shard are done. */
    public SweepRun progress(LongConsumer listener) {
        Checks.present("progress", listener);
        progress = listener;
        return this;
    }

    /**
     * How many replicates the shard has.
     *
     * @throws IllegalArgumentException where the sweep has more than {@link #run()} can carry out
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
     * @return the results, also of earlier runs
     * @throws SweepException where the file is there already, or is of another sweep, or cannot be written
     * @throws IllegalArgumentException where the sweep has too many replicates, or what its file begins with is too long
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

    /** Its header, where all of the sweep can be carried out and read again. */
    private SweepHeader checked() {
        checkSize();
        SweepHeader header = sweep.header();
        header.check();
        return header;
    }

    private void checkSize() {
        if (sweep.size() > Integer.MAX_VALUE) {
            throw new IllegalArgumentException(
                    "a sweep must have at most " + Integer.MAX_VALUE + " replicates (got: " + sweep.size() + ")");
        }
    }

    private SweepException isThere(@Nullable IOException cause) {
        return new SweepException(file + ": it must be a new file, or resume it (got: one that is there)", cause);
    }

    /** Finds what is done already, drops a line that broke off, and appends what is missing. */
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
        // No channel: that would be closed by a scenario that leaves its thread interrupted.
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
                        Thread.interrupted(); // of the scenario's doing: nobody else knows this thread
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
