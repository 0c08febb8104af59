package robosim.geometry.scenario;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.check.Checks;

/**
 * A world, a conversation and the answers, all in memory. For long recordings use a {@link ScenarioReader}.
 *
 * @param header the header
 * @param steps  the requests with their answers, in order
 * @param torn   the number of the file's last line if it was incomplete and skipped; 0 otherwise
 */
public record Scenario(ScenarioHeader header, List<Step> steps, long torn) {
    /** Refuses null. */
    public Scenario {
        Checks.present("header", header);
        steps = Checks.list("steps", steps);
    }

    /** A complete scenario. */
    public Scenario(ScenarioHeader header, List<Step> steps) {
        this(header, steps, 0);
    }

    /**
     * Reads a file, as {@link ScenarioReader#open(Path)} does.
     *
     * @throws ScenarioException if it cannot be read or is not a scenario; names file and line
     */
    public static Scenario read(Path file) throws IOException {
        try (ScenarioReader reader = ScenarioReader.open(file)) {
            return read(reader);
        }
    }

    /**
     * Reads a file, as {@link ScenarioReader#open(Path, Path)} does.
     *
     * @param root worlds that the file names are read from within this folder only
     * @throws ScenarioException if it cannot be read or is not a scenario; names file and line
     */
    public static Scenario read(Path file, Path root) throws IOException {
        try (ScenarioReader reader = ScenarioReader.open(file, root)) {
            return read(reader);
        }
    }

    private static Scenario read(ScenarioReader reader) throws ScenarioException {
        List<Step> steps = new ArrayList<>();
        for (Step step = reader.next(); step != null; step = reader.next()) {
            steps.add(step);
        }
        return new Scenario(reader.header(), steps, reader.torn());
    }

    /** Writes it; worlds that its file referred to by name are written in full. The stream is left open. */
    public void write(OutputStream out) throws IOException {
        ScenarioWriter writer = new ScenarioWriter(Checks.present("out", out), header);
        for (Step step : steps) {
            writer.write(step);
        }
    }
}
