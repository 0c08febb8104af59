package robosim.geometry.bench;

/**
 * Another program on the machine, as far as the caches feel it: a thread that reads and writes through memory larger than any
 * cache, over and over, until it is closed. It wants a processor of its own.
 */
final class Neighbour implements AutoCloseable {
    /** A quarter of a gigabyte: the largest third-level cache that one core can fill today is smaller. */
    private static final int LONGS = 1 << 25;

    /** A line of 64 bytes. */
    private static final int LINE = 8;

    private final Thread thread = new Thread(this::sweep, "neighbour");
    private volatile boolean isClosed;

    Neighbour() {
        thread.setDaemon(true);
        thread.start();
    }

    private void sweep() {
        long[] memory = new long[LONGS];
        while (!isClosed) {
            for (int k = 0; k < LONGS; k += LINE) {
                memory[k]++;
            }
        }
    }

    @Override
    public void close() throws InterruptedException {
        isClosed = true;
        thread.join();
    }
}
