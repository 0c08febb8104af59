package robosim.geometry.scenario.source;

import java.io.Closeable;
import java.io.IOException;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.Step;

/** A conversation that is read step by step, from any source. It may be used by one thread at a time. */
public interface StepReader extends Closeable {
    /** Reads the steps of a scenario; closing it closes the scenario. */
    static StepReader of(ScenarioReader scenario) {
        Checks.present("scenario", scenario);
        return new StepReader() {
            @Override
            public ScenarioHeader header() {
                return scenario.header();
            }

            @Override
            public @Nullable Step next() throws IOException {
                return scenario.next();
            }

            @Override
            public @Nullable ScenarioReader scenario() {
                return scenario;
            }

            @Override
            public void close() throws IOException {
                scenario.close();
            }
        };
    }

    /** The scenario that is read; null if the steps come from something else. */
    default @Nullable ScenarioReader scenario() {
        return null;
    }

    /** The header of the conversation. */
    ScenarioHeader header();

    /**
     * Reads the next step; if the conversation is still going on, waits for it.
     *
     * @return null at the end
     * @throws IOException if it cannot be read; then nothing more can be
     */
    @Nullable
    Step next() throws IOException;
}
