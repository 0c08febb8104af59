package robosim.geometry.sweep;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Keeps a second run away from a file of results, in this process and in any other. What is locked is a file of its own
 * beside it, {@code FILE.lock}: the results themselves are opened to be read and replaced at the end, and where any channel
 * of a file is closed, POSIX drops all locks that the process has on it. It is never removed: a run that had opened it just
 * before would lock a file that nobody else finds any more.
 */
final class SweepLock implements AutoCloseable {
    static final String ENDING = ".lock";

    /** Those of this process: to open and close a second channel would drop the first one's lock. */
    private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

    private final Path path;
    private final FileChannel channel;
    private final FileLock lock;

    private SweepLock(Path path, FileChannel channel, FileLock lock) {
        this.path = path;
        this.channel = channel;
        this.lock = lock;
    }

    /**
     * Locks what is beside a file of results, which may not be there yet.
     *
     * @throws SweepException where another run has it
     */
    static SweepLock of(Path file) throws IOException {
        Path path = path(file);
        if (!HELD.add(path)) {
            throw new SweepException(file + ": another run must not write to it at the same time");
        }
        FileChannel channel = null;
        FileLock lock = null;
        try {
            channel = FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            lock = channel.tryLock();
            if (lock == null) {
                throw new SweepException(file + ": another process must not write to it at the same time");
            }
            return new SweepLock(path, channel, lock);
        } catch (OverlappingFileLockException e) {
            throw new SweepException(file + ": another run must not write to it at the same time", e);
        } finally {
            if (lock == null) {
                try {
                    if (channel != null) {
                        channel.close();
                    }
                } finally {
                    HELD.remove(path);
                }
            }
        }
    }

    /** The same whatever way leads to the file. */
    private static Path path(Path file) throws IOException {
        Path real;
        if (Files.exists(file)) {
            real = file.toRealPath();
        } else {
            Path absolute = file.toAbsolutePath().normalize();
            Path folder = absolute.getParent();
            Path name = absolute.getFileName();
            real = folder == null || name == null
                    ? absolute
                    : folder.toRealPath().resolve(name);
        }
        return real.resolveSibling(real.getFileName() + ENDING);
    }

    /** Whether it holds yet. */
    boolean isValid() {
        return lock.isValid();
    }

    @Override
    public void close() throws IOException {
        try (channel) {
            lock.release();
        } finally {
            HELD.remove(path);
        }
    }
}
