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
 * Prevents two runs from writing to the same file of results, in this process or any other. The lock is held on a
 * separate file next to it, {@code FILE.lock}, because the results themselves are opened for reading and replaced at
 * the end, and when any channel of a file is closed, POSIX drops all locks of the process on that file. The lock file
 * is never removed: a run that had opened it just before would hold a lock on a file that no other run finds any more.
 */
final class SweepLock implements AutoCloseable {
    static final String ENDING = ".lock";

    /** The locks of this process: opening and closing a second channel would drop the first one's lock. */
    private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

    private final Path path;
    private final FileChannel channel;
    private final FileLock lock;

    private SweepLock(Path path, FileChannel channel, FileLock lock) {
        this.path = path;
        this.channel = channel;
        this.lock = lock;
    }

    /** Locks a file of results, which need not exist yet; throws if another run has it. */
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

    /** The same path for all aliases of the file. */
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

    /** Whether the lock is still held. */
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
