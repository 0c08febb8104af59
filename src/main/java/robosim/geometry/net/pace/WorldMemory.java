package robosim.geometry.net.pace;

import org.jspecify.annotations.Nullable;

/** Limits the memory of the worlds of all connections together, as estimated from the sizes of their messages. */
public final class WorldMemory {
    /** Memory per byte of a message: a box of 50 bytes takes some 400, a triangle of 34 some 240, a byte of eight cells 8. */
    static final int MEMORY_FOR_A_BYTE = 8;

    /** Worlds from smaller messages are not counted: 256 of them take 32 MiB. */
    public static final int SMALL_BYTES = 1 << 14;

    private final long most;
    private long taken;

    /** Takes the limit in bytes of memory. */
    public WorldMemory(long most) {
        this.most = most;
    }

    /** Half of the maximum memory of the process. */
    public static WorldMemory ofThisProcess() {
        return new WorldMemory(Runtime.getRuntime().maxMemory() / 2);
    }

    public Share share() {
        return new Share();
    }

    /** The memory of one connection's world; called by the connection's thread. */
    public final class Share {
        private long own;

        /** The bytes of the messages that made the world. */
        private long bytes;

        private Share() {}

        /** Claims memory for a new world from a message of that size, beside the present one; returns why not, or null. */
        @Nullable
        public String claim(int messageBytes) {
            return claimAll(messageBytes);
        }

        /** Claims memory for objects that a message of the given size adds to the present world. */
        @Nullable
        public String claimMore(int messageBytes) {
            return claimAll(bytes + messageBytes);
        }

        /** Some of the world's objects have left it: gives back the share of memory that they had on average. */
        public void shrink(int present, int before) {
            long left = bytes * present / before;
            synchronized (WorldMemory.this) {
                long wanted = left < SMALL_BYTES ? 0 : MEMORY_FOR_A_BYTE * left;
                taken += wanted - own;
                own = wanted;
                bytes = left;
            }
        }

        private @Nullable String claimAll(long all) {
            long wanted = all < SMALL_BYTES ? 0 : MEMORY_FOR_A_BYTE * all;
            synchronized (WorldMemory.this) {
                long others = taken - own;
                if (wanted > 0 && others > 0 && others + wanted > most) {
                    return "the worlds of all connections must fit into " + (most >> 20) + " MiB of memory (got: some "
                            + (wanted >> 20) + " MiB more, beside " + (others >> 20)
                            + " MiB); ask for a smaller world, or give the module more memory (-Xmx)";
                }
                taken += wanted - own;
                own = wanted;
                bytes = all;
                return null;
            }
        }

        /** Releases the memory: there is no world any more. */
        public void free() {
            synchronized (WorldMemory.this) {
                taken -= own;
                own = 0;
                bytes = 0;
            }
        }
    }
}
