package robosim.geometry.scenario;

import java.io.Closeable;
import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** A conversation that is read step by step, wherever it comes from. It belongs to one thread at a time. */
public interface StepReader extends Closeable {
    /** What the conversation begins with. */
    ScenarioHeader header();

    /**
     * Reads the next step; from a conversation that is still held, waits for it.
     *
     * @return null at the end
     * @throws IOException where it cannot be read; then nothing more can be
     */
    @Nullable
    Step next() throws IOException;
}
