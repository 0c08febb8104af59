package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.WireFiles;
import robosim.geometry.export.Films;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.world.World;

/** Which steps of a recording are pictures. */
public final class RecordingOptions {
    private static final Pattern STEPS = Pattern.compile("(\\d{1,9})-(\\d{1,9})");

    @Spec(Spec.Target.MIXEE)
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CommandSpec spec;

    @Option(
            names = "--steps",
            paramLabel = "FIRST-LAST",
            description = "for a recording: a picture of each of these steps, counted from 1 (default: all)")
    private @Nullable String steps;

    @Option(
            names = "--every",
            paramLabel = "N",
            defaultValue = "1",
            description = "for a recording: only every N-th of these steps (default: ${DEFAULT-VALUE})")
    private int every;

    private RecordingOptions() {}

    /** Whether a file is a recording, by its name. */
    static boolean isRecording(Path file) {
        return WireFiles.at(file) != null
                || file.toString().toLowerCase(Locale.ROOT).endsWith(ScenarioReader.ENDING);
    }

    /** Refuses the options of recordings where there is none. */
    void refuse() {
        if (steps != null) {
            throw refused("--steps is for a recording, and WORLD is a world (got: " + steps + ")");
        }
    }

    /**
     * Reads a recording.
     *
     * @param lender lends the colours of its objects; null for none
     */
    StateHistory read(Path file, @Nullable World lender) throws IOException {
        Path toModule = WireFiles.at(file);
        Colours colours = lender == null ? Colours.NONE : Colours.of(lender);
        try (StepReader reader =
                        toModule == null ? StepReader.of(ScenarioReader.open(file)) : WireFiles.open(toModule);
                Progress progress = Progress.of(spec.commandLine(), "steps", 0)) {
            return Films.of(reader, colours, progress::at);
        }
    }

    /** The numbers of the frames to show, in order; each has a world. */
    int[] frames(StateHistory film, Path file) {
        Matcher range = STEPS.matcher(steps == null ? "" : steps);
        if (steps != null && !range.matches()) {
            throw refused("--steps must be FIRST-LAST, such as 1-500 (got: " + steps + ")");
        }
        if (every < 1) {
            throw refused("--every must be at least 1 (got: " + every + ")");
        }
        int first = film.first();
        while (first < film.size() && film.world(first) < 0) {
            first++;
        }
        if (first >= film.size()) {
            throw refused("WORLD must be a recording with a world (got: none in " + file + ")");
        }
        int end = film.size();
        if (steps != null) {
            int from = Integer.parseInt(range.group(1)) - 1;
            end = Integer.parseInt(range.group(2));
            if (from < first || from >= end || end > film.size()) {
                throw refused("--steps must be within " + (first + 1) + "-" + film.size() + " (got: " + steps + ")");
            }
            first = from;
        }
        int[] frames = new int[(end - first + every - 1) / every];
        for (int k = 0; k < frames.length; k++) {
            frames[k] = first + k * every;
        }
        return frames;
    }

    /** Which steps frames are, in words: files are numbered from 0 without gaps, since programs that make videos want it so. */
    String told(int[] shown) {
        int first = shown[0] + 1;
        int last = shown[shown.length - 1] + 1;
        return shown.length == 1
                ? ": step " + first
                : ": steps " + first + " to " + last + (every == 1 ? "" : ", every " + every);
    }

    private ParameterException refused(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
