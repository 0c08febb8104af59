package robosim.geometry.cli.worlds;

import java.io.PrintWriter;
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
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.world.ImportOptions;
import robosim.geometry.world.WorldException;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.WorldReader;
import robosim.geometry.world.check.WorldCheck;
import robosim.geometry.world.shared.JsonText;

/** Examines a world file before robots are simulated in it. */
@Command(
        name = "check",
        description = {
            "Validates a world file and reports what is in it: counts, overlaps, objects outside the world, robots that"
                    + " start in contact or are shut in, and which accuracy and dimension its questions need.",
            "",
            "Shut in: each robot explores a grid from its own place, by straight moves along X and Z at its height"
                    + " (and, unless it is round, turns by 45 degrees), each of which the module checks against the static"
                    + " objects. The first step is coarse. It is refined to half of the robot's smaller side, or less far in"
                    + " a large world, and halved twice more if not every robot is reached. Two areas are"
                    + " printed, that of the places reached and the most that any motion could reach: a way off the"
                    + " grid may be missed, so the step is reported."
                    + " Robots share a room if one gets within their sizes and two steps of the other, and from"
                    + " there straight to it without touching anything else. A robot that starts in contact is not tested."
                    + " If the step had to be coarser than half of the robot's smaller side, and a finer search near"
                    + " its start did not finish, it is unknown whether the robot is shut in; this is not a finding.",
            "",
            "Needs: up to 600 places, with moves and sonar readings of the robots, from a fixed seed, tried with each of the"
                    + " ten settings until it answers otherwise, and until no setting could still be recommended; a setting is enough if it answers all of them as EXACT does in the world's own dimension."
                    + " Without a robot a stand-in on the floor is asked. Unknown if no robot has room for 50 moves and distances, if nothing was"
                    + " hit, or if objects are outside the world or were left out of the file.",
            "",
            "Static objects may overlap, as the walls of a plan do; such overlaps are listed but are not findings."
        },
        exitCodeList = {
            ExitCodes.FINE + ":the world is fine",
            ExitCodes.FINDINGS
                    + ":it was read, but part of the file was left out, an object is outside the world, or"
                    + " a robot starts in contact, is shut in or cannot move",
            ExitCodes.UNUSABLE
                    + ":not done: bad usage, or a file that is missing or is not a world; every error in it is"
                    + " reported with its line"
        },
        footer = {
            "  robosim-geometry check worlds/rooms.xml",
            "  robosim-geometry check --json worlds/maze.xml",
            "  robosim-geometry check arena.world --models ~/.gazebo/models"
        })
public final class CheckCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "WORLD", description = "a world file")
    private Path file = Path.of("");

    @Mixin
    private WorldFiles files;

    @Option(names = "--json", description = "print one JSON object for scripts instead of text")
    private boolean json;

    private @Nullable Progress progress;
    private String work = "";

    @Override
    public Integer call() {
        Arguments.input("WORLD", file);
        ImportOptions options = ImportOptions.DEFAULT.withModels(files.folders());
        WorldImport read;
        try {
            read = WorldImport.read(file, options);
        } catch (WorldException first) {
            List<WorldException> all = WorldReader.problems(file, options);
            problems(all.isEmpty() ? List.of(first) : all);
            return ExitCodes.UNUSABLE;
        }
        WorldCheck check = check(read);
        PrintWriter out = spec.commandLine().getOut();
        out.print(
                json
                        ? JsonText.of(CheckJson.of(file, check, read)) + System.lineSeparator()
                        : CheckText.of(file, check, read));
        out.flush();
        return check.isFine() && read.isWhole() ? ExitCodes.FINE : ExitCodes.FINDINGS;
    }

    private void problems(List<WorldException> problems) {
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(JsonText.of(CheckJson.problems(file, problems)));
        } else {
            problems.forEach(problem -> spec.commandLine().getErr().println(problem.getMessage()));
            spec.commandLine().getErr().println(problems.size() == 1 ? "1 problem" : problems.size() + " problems");
        }
        out.flush();
    }

    private WorldCheck check(WorldImport read) {
        try {
            return WorldCheck.of(read, this::tell);
        } finally {
            close();
        }
    }

    /** A progress bar for each kind of work. */
    private void tell(String now, long done, long total) {
        Progress bar = progress;
        if (bar == null || !now.equals(work)) {
            close();
            work = now;
            bar = Progress.of(spec.commandLine(), now, total);
            progress = bar;
        }
        bar.at(done);
    }

    private void close() {
        if (progress != null) {
            progress.close();
        }
    }
}
