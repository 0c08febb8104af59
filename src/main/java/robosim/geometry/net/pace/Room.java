package robosim.geometry.net.pace;

import java.io.IOException;
import java.util.LinkedHashSet;
import java.util.Set;

/**
 * The memory that messages of all connections may take together while they are read, carried out and answered. Who wants
 * more than there is waits until others are done, in the meantime unread by the module; the one that has waited or held
 * longest may always go on, so that all get there.
 */
public final class Room {
    /** Bytes of memory for each byte of a message: a sonar request of 41 bytes takes, with its answer, some 140. */
    static final int MEMORY_FOR_A_BYTE = 4;

    private final long most;
    private long taken;

    /** Those that hold some or wait for it, the eldest first. */
    private final Set<Share> shares = new LinkedHashSet<>();

    /** Of so many bytes of memory. */
    public Room(long most) {
        this.most = most;
    }

    /** An eighth of what the process may have. */
    public static Room ofThisProcess() {
        return new Room(Runtime.getRuntime().maxMemory() / 8);
    }

    /** Of one connection, nothing yet. */
    public Share share() {
        return new Share();
    }

    /** How much is taken, in bytes of memory. */
    public synchronized long taken() {
        return taken;
    }

    /** What one connection has of it. */
    public final class Share {
        private long own;
        private boolean closed;

        private Share() {}

        /** Whether it is so large already. */
        boolean holds(long bytes) {
            return bytes <= own;
        }

        private boolean fits(long bytes) {
            return isEldest() || taken + bytes - own <= most;
        }

        /**
         * Makes it so large; waits for that.
         *
         * @throws IOException where it is closed
         */
        public void growTo(long bytes) throws IOException {
            synchronized (Room.this) {
                shares.add(this);
                boolean interrupted = false;
                while (!closed && !fits(bytes)) {
                    try {
                        Room.this.wait();
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

        /** Gives all of it back. */
        public void free() {
            if (own == 0 && !closed) {
                return; // as after nearly every message
            }
            synchronized (Room.this) {
                taken -= own;
                own = 0;
                if (shares.remove(this)) {
                    Room.this.notifyAll();
                }
            }
        }

        /** Gives all of it back, for good; whoever waits for some is told. */
        public void close() {
            synchronized (Room.this) {
                closed = true;
                free();
                Room.this.notifyAll();
            }
        }
    }
}
