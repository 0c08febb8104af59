package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;

/** Counts how often bodies are stopped in a proof, by the reason; a proof says how many it takes for ordinary. */
public final class StopCount {
    private final Map<StepResult.Reason, Integer> stops = new EnumMap<>(StepResult.Reason.class);
    private String first = "none";
    private long bodySteps;

    /** Adds a step of so many bodies. */
    public synchronized void add(StepResult result, int bodies, String when) {
        assertThat(result.stops()).extracting(StepResult.Stop::body).isEqualTo(result.stopped());
        bodySteps += bodies;
        for (StepResult.Stop stop : result.stops()) {
            first = stops.isEmpty() ? when + ": " + stop : first;
            stops.merge(stop.reason(), 1, Integer::sum);
        }
    }

    /** Fails if more bodies were stopped than so many in a million times that a body made a step. */
    public void assertAtMost(int inAMillion) {
        long all = count();
        assertThat(bodySteps).isPositive();
        assertThat(all).as(toString()).isLessThanOrEqualTo(bodySteps * inAMillion / 1_000_000);
    }

    private synchronized long count() {
        return stops.values().stream().mapToLong(each -> each).sum();
    }

    @Override
    public synchronized String toString() {
        return String.format(
                Locale.ROOT, "%d of %,d body steps stopped: %s, first %s", count(), bodySteps, stops, first);
    }
}
