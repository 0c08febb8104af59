package robosim.geometry.exact;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Counts how often the filters left a decision to a later stage, over all threads of this JVM. Only the slow later
 * stages are counted; for a rate, count the calls separately.
 */
public final class StageCounters {
    private static final Map<String, Counter> COUNTERS = new ConcurrentHashMap<>();

    private StageCounters() {}

    /** The counter of a given name; a name begins with the class that the stage is in. */
    public static Counter counter(String name) {
        return COUNTERS.computeIfAbsent(name, n -> new Counter());
    }

    /**
     * All counts so far, by name, of classes loaded so far. The difference of two such maps is the count in between.
     */
    public static SortedMap<String, Long> counts() {
        SortedMap<String, Long> counts = new TreeMap<>();
        COUNTERS.forEach((name, counter) -> counts.put(name, counter.total()));
        return counts;
    }

    /** Counts the decisions that reached one stage. */
    public static final class Counter {
        private final AtomicLong total = new AtomicLong();

        private Counter() {}

        /** Counts one decision. */
        public void count() {
            total.incrementAndGet();
        }

        /** The number of decisions so far. */
        public long total() {
            return total.get();
        }
    }
}
