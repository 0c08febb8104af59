package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.check.NumberText;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.WireFiles;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.export.PageWriter;
import robosim.geometry.export.RosRecording;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.world.World;

/** Writes a world or a recording as a page for browsers. */
@Command(
        name = "export",
        description =
                "Writes a world or a recording as one HTML file that shows and plays it in three dimensions, in"
                        + " any browser, without a server and without a network; or a recording as messages of ROS 2 (.mcap) or a log for AdvantageScope (.wpilog).",
        footer = {
            "  robosim-geometry export worlds/rooms.xml rooms.html",
            "  robosim-geometry export recordings/session.scenario.jsonl session.html",
            "  robosim-geometry export recordings/session.scenario.jsonl session.mcap",
            "  robosim-geometry export robosim-demo --world robosim-demo/rooms.xml --steps 1-500 demo.html"
        })
public final class ExportCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            index = "0",
            paramLabel = "FILE",
            description = "a world in any format that convert reads, a recording (*.jsonl"
                    + "), or a folder with the demo's " + WireFiles.TO_MODULE + " and " + WireFiles.FROM_MODULE)
    private Path file = Path.of("");

    @Parameters(index = "1", paramLabel = "PAGE", description = "the page to write: .html; or .mcap or .wpilog")
    private Path page = Path.of("");

    @Option(
            names = "--world",
            paramLabel = "WORLD",
            description = "for a recording: a world file to take colours and the unit from")
    private @Nullable Path colours;

    @Mixin
    private WorldFiles files;

    @Option(
            names = "--steps",
            paramLabel = "FIRST-LAST",
            description = "for a recording: only these steps, counted from 1")
    private @Nullable String steps;

    @Option(
            names = "--tick",
            paramLabel = "SECONDS",
            description =
                    "for .mcap and .wpilog of a recording without steps: how long a bundle of moves takes (default: "
                            + RosRecording.TICK + ")")
    private @Nullable Double tick;

    @Option(names = "--title", paramLabel = "TEXT", description = "the page's title (default: the name of FILE)")
    private @Nullable String title;

    @Override
    public Integer call() throws Exception {
        boolean isLog =
                RosRecording.isLog(Arguments.output("PAGE", page, ".html", RosRecording.MCAP, RosRecording.WPILOG));
        StepRange range = StepRange.of(steps);
        Arguments.refuse(!Files.exists(file), "FILE must exist; check the path", file);
        files.check();
        boolean isDemo = WireFiles.at(file) != null;
        if (!isDemo) {
            Arguments.input("FILE", file);
        }
        boolean isRecording = RecordingOptions.isRecording(file);
        if (tick != null && !isLog) {
            throw new UsageException("--tick is for .mcap and .wpilog (got: " + page + ")");
        }
        if (isLog) {
            if (!isRecording || steps != null || colours != null || title != null) {
                throw new UsageException(
                        "an .mcap or .wpilog is written of a whole recording, without --steps, --world and --title"
                                + " (got: " + file + ")");
            }
            writeMessages(spec, file, page, tick == null ? RosRecording.TICK : tick);
            return ExitCodes.FINE;
        }
        World lender = colours == null ? null : files.world(Arguments.input("--world", colours));
        if (isRecording) {
            recording(lender, range);
        } else {
            if (steps != null) {
                throw new UsageException("--steps is for a recording, and FILE is a world (got: " + steps + ")");
            }
            if (colours != null) {
                throw new UsageException("--world is for a recording, and FILE is a world (got: " + colours + ")");
            }
            World world = files.world(file);
            write(new PageWriter(StateHistory.of(world)).described("", Pictures.unit(world)), 0);
        }
        return ExitCodes.FINE;
    }

    /** Writes a recording as messages of ROS 2 or a log for AdvantageScope. */
    static void writeMessages(CommandSpec spec, Path recording, Path out, double tick) throws IOException {
        if (!(tick > 0 && tick <= StepBundle.MAX_SECONDS)) {
            throw new UsageException(
                    "--tick must be above 0 and at most " + (int) StepBundle.MAX_SECONDS + " (got: " + tick + ")");
        }
        long count;
        try (StepReader reader = WireFiles.recording(recording);
                Progress progress = Progress.of(spec.commandLine(), "steps", 0)) {
            count = RosRecording.write(reader, tick, out, progress::at);
        }
        spec.commandLine()
                .getOut()
                .println("Wrote " + out + ": " + NumberText.count(count, "request") + ", "
                        + NumberText.count(Files.size(out), "byte"));
    }

    private void recording(@Nullable World lender, StepRange range) throws IOException {
        StateHistory film = RecordingOptions.read(spec, file, lender);
        if (film.size() == 0) {
            throw new UsageException("FILE must have a step (got: none in " + file + ")");
        }
        if (film.first() > 0) {
            spec.commandLine()
                    .getErr()
                    .println("The recording is too long for a page; its first " + NumberText.count(film.first(), "step")
                            + " are left out");
        }
        StepRange shown = range.within(film.first(), film.size());
        int first = shown.first();
        int end = shown.end();
        if (film.world(first) < 0) {
            throw new UsageException("FILE must begin with a world (got: none before its step " + (first + 1) + ")");
        }
        String words = NumberText.count(end - first, "step");
        write(new PageWriter(film).ofSteps(first, end).described(words, Pictures.unit(lender)), end - first);
    }

    private void write(PageWriter writer, int count) throws IOException {
        List<String> coarse =
                writer.titled(title == null ? Pictures.title(file) : title).write(page);
        PrintWriter out = spec.commandLine().getOut();
        coarse.forEach(out::println);
        out.println("Wrote " + page + ": " + (count > 0 ? NumberText.count(count, "step") + ", " : "")
                + NumberText.count(Files.size(page), "byte"));
    }
}
