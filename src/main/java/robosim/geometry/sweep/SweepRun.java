package robosim.geometry.sweep;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
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

/**
 * Carries out a sweep, or a shard of it, on some threads, into a file. Each outcome is appended when it is there, as a line
 * with a check sum: who is killed loses what was under way, one replicate a thread. At the end the file is written anew in
 * the order of the indices: its bytes then do not tell how many threads there were, or how often it was killed.
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
        return new SweepRun(sweep, file);
    }

    /** Only this part of it. */
    public SweepRun shard(Shard part) {
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
        progress = listener;
        return this;
    }

    /** How many replicates the shard has. */
    public long size() {
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
     * @throws SweepException where the file is there already, or is of another sweep
     */
    public SweepResults run() throws IOException, InterruptedException {
        SweepHeader header = sweep.header();
        try (FileChannel out = FileChannel.open(
                        file,
                        StandardOpenOption.WRITE,
                        isResumed ? StandardOpenOption.CREATE : StandardOpenOption.CREATE_NEW);
                FileLock lock = lock(out)) {
            BitSet done = new BitSet();
            begin(out, header, done);
            carryOut(out, done);
            if (!lock.isValid()) {
                throw new SweepException(file + ": the lock of the file was lost");
            }
            out.force(false);
        } catch (FileAlreadyExistsException e) {
            throw new SweepException(file + ": it must be a new file, or resume it (got: one that is there)", e);
        }
        SweepResults.read(List.of(file)).write(file, header);
        return SweepResults.read(List.of(file));
    }

    private FileLock lock(FileChannel out) throws IOException {
        FileLock lock;
        try {
            lock = out.tryLock();
        } catch (OverlappingFileLockException e) {
            throw new SweepException(file + ": another run must not write to it at the same time", e);
        }
        if (lock == null) {
            throw new SweepException(file + ": another process must not write to it at the same time");
        }
        return lock;
    }

    /** Finds what is done already, drops a line that broke off, and makes ready to go on. */
    private void begin(FileChannel out, SweepHeader header, BitSet done) throws IOException {
        SweepFile before = SweepFile.read(file, (outcome, offset, length) -> {
            if (outcome.index() >= sweep.size()) {
                throw new SweepException(file + ": it has more replicates than asked for (got: " + outcome.index()
                        + " of " + sweep.size() + ")");
            }
            done.set((int) outcome.index());
        });
        SweepHeader old = before.header();
        if (old != null && !old.isOfSame(header)) {
            throw new SweepException(
                    file + ": it must be of the same sweep to be resumed; it is of " + old + " and not of " + header);
        }
        out.truncate(before.end());
        out.position(before.end());
        if (old == null || old.replicates() != header.replicates()) {
            append(out, header.sealed());
        }
    }

    private static void append(FileChannel out, String line) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap((line + "\n").getBytes(StandardCharsets.UTF_8));
        while (bytes.hasRemaining()) {
            out.write(bytes);
        }
    }

    private void carryOut(FileChannel out, BitSet done) throws IOException, InterruptedException {
        if (sweep.size() > Integer.MAX_VALUE) {
            throw new IllegalArgumentException(
                    "a sweep must have at most " + Integer.MAX_VALUE + " replicates (got: " + sweep.size() + ")");
        }
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
                        synchronized (out) {
                            append(out, line);
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
