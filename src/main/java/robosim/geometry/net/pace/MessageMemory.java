package robosim.geometry.net.pace;

import java.io.IOException;
import java.util.LinkedHashSet;
import java.util.Set;

/**
 * The memory that the messages of all connections may take together while they are read, processed and answered. A
 * connection that needs more than is left waits until others are done; meanwhile it is not read. The connection that
 * has waited or held memory longest may always go on, so that none waits forever.
 */
public final class MessageMemory {
    /** Memory per byte of a message: a sonar request of 41 bytes takes, with its answer, some 140. */
    static final int MEMORY_FOR_A_BYTE = 4;

    private final long most;
    private long taken;

    /** The shares that hold memory or wait for it, oldest first. */
    private final Set<Share> shares = new LinkedHashSet<>();

    /** Takes the limit in bytes of memory. */
    public MessageMemory(long most) {
        this.most = most;
    }

    /** An eighth of the maximum memory of the process. */
    public static MessageMemory ofThisProcess() {
        return new MessageMemory(Runtime.getRuntime().maxMemory() / 8);
    }

    /** A share for one connection, empty at first. */
    public Share share() {
        return new Share();
    }

    /** The memory in use, bytes. */
    public synchronized long taken() {
        return taken;
    }

    public final class Share {
        private long own;
        private boolean closed;

        private Share() {}

        /** Whether it has at least the given size. */
        boolean holds(long bytes) {
            return bytes <= own;
        }

        private boolean fits(long bytes) {
            return isEldest() || taken + bytes - own <= most;
        }

        /** Grows to the given size; waits until that is possible, and throws if it is closed. */
        public void growTo(long bytes) throws IOException {
            synchronized (MessageMemory.this) {
                shares.add(this);
                boolean interrupted = false;
                while (!closed && !fits(bytes)) {
                    try {
                        MessageMemory.this.wait();
                    } catch (InterruptedException e) {
                        interrupted = true;
                    }
                }
                if (interrupted) {
                    Thread.currentThread().interrupt();
                }
                if (closed) {
                    throw new IOException("the connection was closed while it waited for memory");
                }
                taken += Math.max(0, bytes - own);
                own = Math.max(own, bytes);
            }
        }

        private boolean isEldest() {
            return !shares.isEmpty() && shares.iterator().next() == this;
        }

        public void free() {
            if (own == 0 && !closed) {
                return; // as after nearly every message
            }
            synchronized (MessageMemory.this) {
                taken -= own;
                own = 0;
                if (shares.remove(this)) {
                    MessageMemory.this.notifyAll();
                }
            }
        }

        /** Returns all of it for good and wakes those that wait. */
        public void close() {
            synchronized (MessageMemory.this) {
                closed = true;
                free();
                MessageMemory.this.notifyAll();
            }
        }
    }
}
