package robosim.geometry.scenario;

import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.protocol.json.JsonRecord;

/**
 * The header of a scenario.
 *
 * @param title   a title for people
 * @param madeBy  the program that wrote it, for people; empty if unknown
 * @param options defaults for what its requests leave out
 */
public record ScenarioHeader(String title, String madeBy, SessionOptions options) {
    /** The version of the format, as given in headers. */
    public static final int VERSION = 1;

    /** Refuses null. */
    public ScenarioHeader {
        if (title == null || madeBy == null || options == null) {
            throw new IllegalArgumentException("title, madeBy and options must be given (got: null)");
        }
    }

    /** A header written by this module. */
    public ScenarioHeader(String title, SessionOptions options) {
        this(title, JsonLines.MODULE, options);
    }

    /** The file's first line. */
    String line() {
        Beam beam = options.beam();
        return JsonRecord.line(
                "type", "scenario",
                "version", VERSION,
                "title", title,
                "madeBy", madeBy,
                "options",
                        JsonRecord.fields(
                                "dimension", options.dimension(),
                                "accuracy", options.accuracy(),
                                "beam",
                                        JsonRecord.fields(
                                                "min", beam.min(), "max", beam.max(), "width", beam.width())));
    }

    static ScenarioHeader of(JsonRecord line) throws ProtocolException {
        line.only("type version title", "madeBy options");
        if (line.number("version") != VERSION) {
            throw line.refused("version must be " + VERSION + " (got: " + line.number("version") + ")");
        }
        SessionOptions options = line.has("options") ? options(line.record("options")) : SessionOptions.ROBOSIM;
        return new ScenarioHeader(line.text("title"), line.has("madeBy") ? line.text("madeBy") : "", options);
    }

    private static SessionOptions options(JsonRecord line) throws ProtocolException {
        line.only("dimension accuracy beam", "");
        JsonRecord beam = line.record("beam").only("min max width", "");
        double max = beam.isNull("max") ? Double.POSITIVE_INFINITY : beam.number("max");
        try {
            return new SessionOptions(
                    line.constant("dimension", Dimension.class),
                    line.constant("accuracy", Accuracy.class),
                    new Beam(beam.number("min"), max, beam.number("width")));
        } catch (IllegalArgumentException e) {
            throw beam.refused(String.valueOf(e.getMessage()));
        }
    }
}
