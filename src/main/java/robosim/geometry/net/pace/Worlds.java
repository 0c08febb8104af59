package robosim.geometry.net.pace;

import org.jspecify.annotations.Nullable;

/** The memory that the worlds of all connections may take together, as far as their messages tell it. */
public final class Worlds {
    /** Bytes of memory for each byte of a message: a box of 50 bytes takes some 400, a triangle of 34 some 240. */
    static final int MEMORY_FOR_A_BYTE = 8;

    /** Worlds from messages below that are not counted: 256 of them take 32 MiB. */
    public static final int SMALL_BYTES = 1 << 14;

    private final long most;
    private long taken;

    /** Of so many bytes of memory. */
    public Worlds(long most) {
        this.most = most;
    }

    /** Half of what the process may have. */
    public static Worlds ofThisProcess() {
        return new Worlds(Runtime.getRuntime().maxMemory() / 2);
    }

    /** Of one connection. */
    public Plot plot() {
        return new Plot();
    }

    /** What the world of one connection takes; its connection's thread calls it. */
    public final class Plot {
        private long own;

        private Plot() {}

        /**
         * There shall be a world from so many bytes of a message beside the one that is there.
         *
         * @return null where there may; else why not
         */
        @Nullable
        public String claim(int messageBytes) {
            long wanted = messageBytes < SMALL_BYTES ? 0 : (long) MEMORY_FOR_A_BYTE * messageBytes;
            synchronized (Worlds.this) {
                long others = taken - own;
                if (wanted > 0 && others > 0 && others + wanted > most) {
                    return "the worlds of all connections must fit into " + (most >> 20) + " MiB of memory (got: some "
                            + (wanted >> 20) + " MiB more, beside " + (others >> 20)
                            + " MiB); ask for a smaller world, or give the module more memory (-Xmx)";
                }
                taken += wanted - own;
                own = wanted;
                return null;
            }
        }

        /** There is no world any more. */
        public void free() {
            synchronized (Worlds.this) {
                taken -= own;
                own = 0;
            }
        }
    }
}
