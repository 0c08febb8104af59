package robosim.geometry.scenario;

import java.io.Closeable;
import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** A conversation that is read step by step, from any source. It may be used by one thread at a time. */
public interface StepReader extends Closeable {
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
