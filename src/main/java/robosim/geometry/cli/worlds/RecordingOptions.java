package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.WireFiles;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.Replayer;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.world.World;

/** Which steps of a recording are pictures. */
public final class RecordingOptions {
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

    /** Whether a file is a recording by its name, or a folder with those of the demo. */
    static boolean isRecording(Path file) {
        return WireFiles.at(file) != null
                || file.toString().toLowerCase(Locale.ROOT).endsWith(".jsonl");
    }

    /** Refuses the options of recordings where there is none. */
    void refuse() {
        if (steps != null) {
            throw new UsageException("--steps is for a recording, and WORLD is a world (got: " + steps + ")");
        }
    }

    /** Reads a recording; the lender, if there is one, lends the colours of its objects. */
    static StateHistory read(CommandSpec spec, Path file, @Nullable World lender) throws IOException {
        try (StepReader reader = WireFiles.recording(file);
                Progress progress = Progress.of(spec.commandLine(), "steps", 0)) {
            return Replayer.film(reader, Colours.of(lender), progress::at);
        }
    }

    /** The first step of a history that has a world. */
    static int first(StateHistory film, String parameter, Path file) {
        for (int first = film.first(); first < film.size(); first++) {
            if (film.world(first) >= 0) {
                return first;
            }
        }
        throw new UsageException(parameter + " must be a recording with a world (got: none in " + file + ")");
    }

    /** The numbers of the frames to show, in order; each has a world. */
    int[] frames(StateHistory film, Path file) {
        StepRange range = StepRange.of(steps);
        Arguments.refuse(every < 1, "--every must be at least 1", every);
        StepRange shown = range.within(first(film, "WORLD", file), film.size());
        int first = shown.first();
        int end = shown.end();
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
}
