package robosim.geometry;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/** How many bytes a piece of work allocates on the thread that does it. */
public final class Allocated {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final int ROUNDS = 6;

    private Allocated() {}

    /**
     * The bytes that the work allocates each time: the least of several rounds after a first one. What the JVM allocates on
     * its own account is not among them: where compiled code falls back to the interpreter, calls are linked there for
     * the first time, which takes up to 14 kB and comes at no fixed time.
     */
    public static long everyTime(Runnable work) {
        work.run();
        long least = Long.MAX_VALUE;
        for (int round = 0; round < ROUNDS && least > 0; round++) {
            least = Math.min(least, once(work));
        }
        return least;
    }

    /** The bytes that the work allocates this time. */
    public static long once(Runnable work) {
        long before = THREADS.getCurrentThreadAllocatedBytes();
        work.run();
        return THREADS.getCurrentThreadAllocatedBytes() - before;
    }
}
