package robosim.geometry.census;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.proof.Witnesses;

/** What came of one kernel's cases, by regime. */
final class Count {
    private static final int FAILURES = 5;

    /** What came of one regime. */
    static final class Row {
        long random;
        long adversarial;
        double early;
        double late;
        double width;
        long wrong;
    }

    final Kernel kernel;
    final Map<String, Row> rows = new LinkedHashMap<>();
    final List<String> failures = new ArrayList<>();
    final Witnesses witnesses;

    private Count(Kernel kernel, long seed) {
        this.kernel = kernel;
        witnesses = new Witnesses(seed);
        for (String regime : kernel.regimes()) {
            if (rows.put(regime, new Row()) != null) {
                throw new IllegalArgumentException("two regimes of one name (got: " + regime + ")");
            }
        }
    }

    /** Asks as many plain cases and as many adversarial ones, times the effort. */
    static Count of(Kernel kernel, long seed, long cases) {
        Count count = new Count(kernel, seed);
        for (boolean adversarial : new boolean[] {false, true}) {
            SplittableRandom random =
                    new SplittableRandom(seed * 31 + kernel.name().hashCode() * 2L + (adversarial ? 1 : 0));
            for (long k = 0; k < Math.round(cases * kernel.effort()); k++) {
                Visit visit = kernel.ask(random.split(), adversarial);
                count.add(visit, adversarial);
                count.fail(visit.regime(), kernel.proof(count.witnesses));
            }
        }
        return count;
    }

    /** How many cases were asked. */
    long cases() {
        return rows.values().stream()
                .mapToLong(row -> row.random + row.adversarial)
                .sum();
    }

    private void add(Visit visit, boolean adversarial) {
        Row row = rows.get(visit.regime());
        if (row == null) {
            throw new IllegalArgumentException(kernel.name() + " has no such regime (got: " + visit.regime() + ")");
        }
        if (adversarial) {
            row.adversarial++;
        } else {
            row.random++;
        }
        row.early = Math.max(row.early, visit.early());
        row.late = Math.max(row.late, visit.late());
        row.width = Math.max(row.width, visit.width());
        if (visit.failure() != null) {
            row.wrong++;
        }
        fail(visit.regime(), visit.failure());
    }

    private void fail(String regime, @Nullable String failure) {
        if (failure != null && failures.size() < FAILURES) {
            failures.add(kernel.name() + ", " + regime + ": " + failure);
        }
    }
}
