package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.check.NumberText;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Inputs;
import robosim.geometry.cli.terminal.Outputs;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.Version;
import robosim.geometry.cli.terminal.WireFiles;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.export.Films;
import robosim.geometry.export.PageWriter;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.world.World;

/** Writes a world or a recording as a page for browsers. */
@Command(
        name = "export",
        description = "Writes a world or a recording as one HTML file that shows and plays it in three dimensions, in"
                + " any browser, without a server and without a network.",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        exitCodeListHeading = ExitCodes.HEADING,
        exitCodeList = {ExitCodes.DONE, ExitCodes.REFUSED},
        footerHeading = "%nExamples:%n",
        footer = {
            "  robosim-geometry export worlds/rooms.xml rooms.html",
            "  robosim-geometry export recordings/session.scenario.jsonl session.html",
            "  robosim-geometry export robosim-demo --world robosim-demo/rooms.xml --steps 1-500 demo.html"
        })
public final class ExportCommand implements Callable<Integer> {
    private static final Pattern STEPS = Pattern.compile("(\\d{1,9})-(\\d{1,9})");

    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CommandSpec spec;

    @Parameters(
            index = "0",
            paramLabel = "FILE",
            description = "a world in any format that convert reads, a recording (*" + ScenarioReader.ENDING
                    + "), or a folder with the demo's " + WireFiles.TO_MODULE + " and " + WireFiles.FROM_MODULE)
    private Path file = Path.of("");

    @Parameters(index = "1", paramLabel = "PAGE", description = "the page to write: .html")
    private Path page = Path.of("");

    @Option(
            names = "--world",
            paramLabel = "WORLD",
            description = "for a recording: a world file to take colours and the unit from")
    private @Nullable Path colours;

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private WorldFiles files;

    @Option(
            names = "--steps",
            paramLabel = "FIRST-LAST",
            description = "for a recording: only these steps, counted from 1")
    private @Nullable String steps;

    @Option(names = "--title", paramLabel = "TEXT", description = "the page's title (default: the name of FILE)")
    private @Nullable String title;

    private ExportCommand() {}

    @Override
    public Integer call() throws Exception {
        Outputs.file(spec, "PAGE", page, ".html");
        Matcher range = STEPS.matcher(steps == null ? "" : steps);
        if (steps != null && !range.matches()) {
            throw refused("--steps must be FIRST-LAST, such as 1-500 (got: " + steps + ")");
        }
        if (!Files.exists(file)) {
            throw refused("FILE must exist; check the path (got: " + file + ")");
        }
        files.check();
        Path toModule = WireFiles.at(file);
        if (toModule == null) {
            Inputs.file(spec, "FILE", file);
        }
        World lender = colours == null ? null : files.world(Inputs.file(spec, "--world", colours));
        if (toModule != null) {
            try (StepReader reader = WireFiles.open(toModule)) {
                recording(reader, lender, range);
            }
        } else if (file.toString().toLowerCase(Locale.ROOT).endsWith(".jsonl")) {
            try (StepReader reader = StepReader.of(ScenarioReader.open(file))) {
                recording(reader, lender, range);
            }
        } else {
            if (steps != null) {
                throw refused("--steps is for a recording, and FILE is a world (got: " + steps + ")");
            }
            if (colours != null) {
                throw refused("--world is for a recording, and FILE is a world (got: " + colours + ")");
            }
            World world = files.world(file);
            write(new PageWriter(Films.of(world)).described("", Pictures.unit(world)), 0);
        }
        return ExitCodes.FINE;
    }

    private void recording(StepReader reader, @Nullable World lender, Matcher range) throws IOException {
        StateHistory film;
        try (Progress progress = Progress.of(spec.commandLine(), "steps", 0)) {
            film = Films.of(reader, lender == null ? Colours.NONE : Colours.of(lender), progress::at);
        }
        if (film.size() == 0) {
            throw refused("FILE must have a step (got: none in " + file + ")");
        }
        if (film.first() > 0) {
            spec.commandLine()
                    .getErr()
                    .println("The recording is too long for a page; its first " + NumberText.count(film.first(), "step")
                            + " are left out");
        }
        int first = film.first();
        int end = film.size();
        if (steps != null) {
            first = Integer.parseInt(range.group(1)) - 1;
            end = Integer.parseInt(range.group(2));
            if (first < film.first() || first >= end || end > film.size()) {
                throw refused(
                        "--steps must be within " + (film.first() + 1) + "-" + film.size() + " (got: " + steps + ")");
            }
        }
        if (film.world(first) < 0) {
            throw refused("FILE must begin with a world (got: none before its step " + (first + 1) + ")");
        }
        String words = NumberText.count(end - first, "step");
        write(
                new PageWriter(film).ofSteps(first, end).described(words, lender == null ? "" : Pictures.unit(lender)),
                end - first);
    }

    private void write(PageWriter writer, int count) throws IOException {
        List<String> coarse =
                writer.titled(title == null ? Pictures.title(file) : title).write(page);
        PrintWriter out = spec.commandLine().getOut();
        coarse.forEach(out::println);
        out.println("Wrote " + page + ": " + (count > 0 ? NumberText.count(count, "step") + ", " : "")
                + NumberText.count(Files.size(page), "byte"));
    }

    private ParameterException refused(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
