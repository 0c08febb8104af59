package robosim.geometry.cli.worlds;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Inputs;
import robosim.geometry.cli.terminal.Json;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.Version;
import robosim.geometry.world.ImportOptions;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldException;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.WorldReader;
import robosim.geometry.world.check.WorldCheck;

/** Tells what there is to know of a world before robots are let loose in it. */
@Command(
        name = "check",
        description = {
            "Validates a world file and tells what is in it: counts, overlaps, objects outside of the world, robots that"
                    + " start in contact or are shut in, and which accuracy and dimension its questions need.",
            "",
            "Shut in: each robot is taken over a grid from its own place, by straight moves along X and Z at its height"
                    + " (and, unless it is round, turns by 45 degrees) that the module itself allows among what cannot"
                    + " move. The step is half of the robot's smaller side, or coarser in a large world, and is halved"
                    + " twice where not every robot is met; it is told, as a way between the grid's may have been missed."
                    + " Robots share a room where one gets as near to the other as their sizes and two steps, and from"
                    + " there straight to the other without meeting anything else. Who starts in contact is not asked."
                    + " Where the step had to be coarser than half of the robot's smaller side, and a finer search near"
                    + " its start came to no end, it could not be told whether it is shut in, which is no finding.",
            "",
            "Needs: 2,000 places, moves and sonars of the world's robots from a fixed seed, asked at each of the ten"
                    + " settings; enough is what answers all of them as EXACT does in the world's own dimension. Where"
                    + " there is no robot, nobody has room for 50 moves and distances, or nothing was met, it cannot be"
                    + " told.",
            "",
            "Static objects may overlap, as the walls of a plan do; they are told and are no finding."
        },
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        exitCodeListHeading = ExitCodes.HEADING,
        exitCodeList = {
            ExitCodes.FINE + ":the world is fine",
            ExitCodes.FINDINGS
                    + ":it can be read, and something of the file was left out, an object is outside of the world, or"
                    + " a robot starts in contact, is shut in or cannot move",
            ExitCodes.UNUSABLE
                    + ":not done: bad usage, or a file that is missing or no world; all that is wrong in it is"
                    + " told with its line"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  robosim-geometry check worlds/rooms.xml",
            "  robosim-geometry check --json worlds/maze.xml",
            "  robosim-geometry check arena.world --models ~/.gazebo/models"
        })
public final class CheckCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CommandSpec spec;

    @Parameters(paramLabel = "WORLD", description = "a world file")
    private Path file = Path.of("");

    @Option(
            names = "--models",
            paramLabel = "DIR",
            description = "a folder of models for SDFormat's model://, beside that of WORLD; may be given again")
    private List<Path> models = new ArrayList<>();

    @Option(names = "--json", description = "print one JSON object for scripts instead of text")
    private boolean json;

    private @Nullable Progress progress;
    private String work = "";

    private CheckCommand() {}

    @Override
    public Integer call() {
        Inputs.file(spec, "WORLD", file);
        Inputs.folders(spec, "--models", models);
        ImportOptions options = ImportOptions.DEFAULT.withModels(models);
        WorldImport read;
        try {
            read = WorldImport.read(file, options);
        } catch (WorldException first) {
            List<WorldException> all = WorldReader.problems(file, options);
            problems(all.isEmpty() ? List.of(first) : all);
            return ExitCodes.UNUSABLE;
        }
        WorldCheck check = check(read.world());
        PrintWriter out = spec.commandLine().getOut();
        out.print(
                json
                        ? Json.of(CheckJson.of(file, check, read)) + System.lineSeparator()
                        : CheckText.of(file, check, read));
        out.flush();
        return check.isFine() && read.isWhole() ? ExitCodes.FINE : ExitCodes.FINDINGS;
    }

    private void problems(List<WorldException> problems) {
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(Json.of(CheckJson.problems(file, problems)));
        } else {
            problems.forEach(problem -> spec.commandLine().getErr().println(problem.getMessage()));
            spec.commandLine().getErr().println(problems.size() == 1 ? "1 problem" : problems.size() + " problems");
        }
        out.flush();
    }

    private WorldCheck check(World world) {
        try {
            return WorldCheck.of(world, this::tell);
        } finally {
            close();
        }
    }

    /** A bar for each kind of work. */
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
