package robosim.geometry.scenario;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.exact.Checks;

/**
 * A world, a conversation and the answers, whole in memory. A long recording is better read by a {@link ScenarioReader}.
 *
 * @param header what it begins with
 * @param steps  the requests with their answers, in order
 * @param torn   the number of the file's last line where that broke off and was passed over; 0 otherwise
 */
public record Scenario(ScenarioHeader header, List<Step> steps, long torn) {
    /** Refuses null. */
    public Scenario {
        Checks.present("header", header);
        steps = Checks.list("steps", steps);
    }

    /** All of it. */
    public Scenario(ScenarioHeader header, List<Step> steps) {
        this(header, steps, 0);
    }

    /**
     * Reads a file, as {@link ScenarioReader#open(Path)} does.
     *
     * @throws ScenarioException naming file and line, where it cannot be read or is no scenario
     */
    public static Scenario read(Path file) throws IOException {
        try (ScenarioReader reader = ScenarioReader.open(file)) {
            return read(reader);
        }
    }

    /**
     * Reads a file, as {@link ScenarioReader#open(Path, Path)} does.
     *
     * @param root the folder outside of which no world is read that the file names
     * @throws ScenarioException naming file and line, where it cannot be read or is no scenario
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

    /** Writes it; worlds that its file named are written out. The stream is left open. */
    public void write(OutputStream out) throws IOException {
        ScenarioWriter writer = new ScenarioWriter(Checks.present("out", out), header);
        for (Step step : steps) {
            writer.write(step);
        }
    }
}
