package robosim.geometry.exact;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;

/**
 * How often the filters left a question to a later stage, for all threads of this JVM. Only what is slow anyway counts;
 * who wants a share counts the questions.
 */
public final class Stages {
    private static final Map<String, Counter> COUNTERS = new ConcurrentHashMap<>();

    private Stages() {}

    /** The counter of this name, which begins with the class whose stage it is. */
    public static Counter counter(String name) {
        return COUNTERS.computeIfAbsent(name, n -> new Counter());
    }

    /** All counts so far, those of classes in use, by name. A difference of two such maps tells of what lay between. */
    public static SortedMap<String, Long> counts() {
        SortedMap<String, Long> counts = new TreeMap<>();
        COUNTERS.forEach((name, counter) -> counts.put(name, counter.total()));
        return counts;
    }

    /** Questions that came to one stage. */
    public static final class Counter {
        private final AtomicLong total = new AtomicLong();

        private Counter() {}

        /** One question more. */
        public void count() {
            total.incrementAndGet();
        }

        /** Questions so far. */
        public long total() {
            return total.get();
        }
    }
}
