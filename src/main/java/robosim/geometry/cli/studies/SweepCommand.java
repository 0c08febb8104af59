package robosim.geometry.cli.studies;

import java.io.IOException;
import java.io.PrintWriter;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
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
import robosim.geometry.cli.terminal.ProofOptions;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.Version;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.scenario.AnswerProofs;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.sweep.ParameterSweep;
import robosim.geometry.sweep.ScenarioSweep;
import robosim.geometry.sweep.Shard;
import robosim.geometry.sweep.SweepResults;
import robosim.geometry.sweep.SweepRun;
import robosim.geometry.sweep.SweepScenario;
import robosim.geometry.sweep.SweepWorld;

/** Runs a scenario over worlds, parameters and seeds. */
@Command(
        name = "sweep",
        description = "Runs a scenario over worlds, parameters and seeds, on any number of threads and machines,"
                + " with results that are the same to the bit.",
        subcommands = SweepMergeCommand.class,
        exitCodeList = {
            ExitCodes.DONE,
            ExitCodes.FINDINGS + ":replicates or proofs failed",
            ExitCodes.REFUSED,
            ExitCodes.ENDED
        },
        footerHeading = "%nParameters of a scenario file, each 0 unless given:%n",
        footer = {
            "  place    radius of the disc in which each robot starts, world units",
            "  heading  largest error of its starting heading, degrees",
            "  slip     standard deviation of each move, as a fraction of the move",
            "  aim      standard deviation of each beam's direction, degrees",
            "  range    standard deviation of each distance, world units",
            "For any scenario: accuracy and dimension (default: the world's).",
            "",
            "Examples:",
            "  robosim-geometry sweep wandering.scenario.jsonl -n 1000 -p place=0,0.5,1 --plot wandering.svg",
            "  robosim-geometry sweep wandering.scenario.jsonl -n 1000 --prove 0.01",
            "  robosim-geometry sweep com.example.Docking worlds/*.xml -n 200 -p speed=0.5,1 --threads 8",
            "  robosim-geometry sweep com.example.Docking worlds/*.xml -n 200 --shard 3/16 --resume",
            "  robosim-geometry sweep merge sweep-*-of-16.jsonl --digest"
        })
public final class SweepCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            index = "0",
            arity = "0..1",
            paramLabel = "SCENARIO",
            description = "a *" + ScenarioReader.ENDING
                    + ", or the name of a class on the class path that implements SweepScenario")
    private @Nullable String scenario;

    @Parameters(
            index = "1..*",
            paramLabel = "WORLD",
            description = "world files, in the order of the results; a scenario file has its own and needs none")
    private List<Path> worlds = List.of();

    @Option(
            names = {"-n", "--replicates"},
            paramLabel = "N",
            description = "runs of each world with each combination of values (default: ${DEFAULT-VALUE})",
            defaultValue = "100")
    private long replicates;

    @Option(names = "--seed", paramLabel = "N", description = "the root of all seeds (default: 0)")
    private long seed;

    @Option(
            names = {"-p", "--parameter"},
            paramLabel = "NAME=VALUE[,VALUE...]",
            description = "values of a parameter; repeat it for other parameters")
    private List<String> parameters = List.of();

    @Option(
            names = "--goal",
            paramLabel = "ROBOT@X,Z,RADIUS",
            description = "of a scenario file: also measure when the centre of a robot first is in this disc; may be"
                    + " repeated")
    private List<String> goals = List.of();

    @Option(names = "--threads", paramLabel = "N", description = "number of threads (default: number of processors)")
    private int threads = Runtime.getRuntime().availableProcessors();

    @Option(
            names = "--shard",
            paramLabel = "I/N",
            description = "run only the I-th of N parts, I from 0: one on each machine")
    private @Nullable String shard;

    @Option(names = "--resume", description = "continue where existing results end; nothing is run twice")
    private boolean resumed;

    @Option(
            names = {"-o", "--out"},
            paramLabel = "FILE",
            description = "file for the results, JSON lines (default: sweep.jsonl, for a shard sweep-I-of-N.jsonl)")
    private @Nullable Path target;

    @Mixin
    private WorldFiles files;

    @Mixin
    private SweepOutput output;

    @Mixin
    private ProofOptions proofs;

    private static final String NUMBER = "[-+]?[0-9]*\\.?[0-9]+(?:[eE][-+]?[0-9]{1,3})?";
    private static final Pattern GOAL = Pattern.compile("(.+)@(" + NUMBER + "),(" + NUMBER + "),(" + NUMBER + ")");

    @Override
    public Integer call() throws Exception {
        Shard part = shard == null ? Shard.ALL : Shard.parse(shard);
        Path file = target != null ? target : Path.of(part.count() == 1 ? "sweep.jsonl" : name(part));
        Arguments.output("--out", file);
        if (!resumed && Files.exists(file)) {
            throw new UsageException("--out must be a new file, or --resume must be given to go on with one (got: "
                    + file + ", which exists)");
        }
        output.check();
        ParameterSweep sweep = sweep();
        SweepRun run =
                SweepRun.of(sweep, files.output("--out", file)).shard(part).withThreads(threads);
        output.keep(files);
        if (!sweep.canDiffer()) {
            spec.commandLine()
                    .getErr()
                    .println("warning: the " + replicates + " replicates of each world and combination of values"
                            + " cannot differ: give place, heading, slip, aim or range a"
                            + " value above 0 that applies to what was recorded, or -n"
                            + " 1");
        }
        if (resumed) {
            run.resume();
        }
        long start = System.nanoTime();
        AtomicLong before = new AtomicLong(-1);
        SweepResults results;
        long size = run.size();
        try (Progress progress = Progress.of(spec.commandLine(), "replicates", size);
                Stopped stopped = Stopped.tell(done -> stopped(file, done, size))) {
            results = run.progress(done -> {
                        before.compareAndSet(-1, done);
                        stopped.at(done);
                        progress.at(done, () -> left(System.nanoTime() - start, done - before.get(), size - done));
                    })
                    .run();
        }
        PrintWriter out = spec.commandLine().getOut();
        int code = output.tell(results, out);
        long earlier = Math.max(0, before.get());
        out.printf(
                "%s on %s%s, %.1f s: %s%n",
                NumberText.count(size - earlier, "replicate"),
                NumberText.count(threads, "thread"),
                earlier > 0 ? String.format(", %,d done before", earlier) : "",
                (System.nanoTime() - start) / 1e9,
                file);
        out.flush();
        return proofs.tell(out) ? code : ExitCodes.FINDINGS;
    }

    /** What a user who stops a sweep should know. */
    private void stopped(Path file, long done, long size) {
        List<String> words =
                new ArrayList<>(spec.root().commandLine().getParseResult().originalArgs());
        if (!resumed) {
            words.add("--resume");
        }
        String command = words.stream().map(SweepCommand::quoted).collect(Collectors.joining(" "));
        PrintWriter err = spec.commandLine().getErr();
        err.printf(
                Locale.ROOT,
                "%nStopped after %,d of %s, which are in %s. To run the others:%n%s %s%n",
                done,
                NumberText.count(size, "replicate"),
                file,
                Version.PROGRAM,
                command);
        err.flush();
    }

    /** A word as a shell reads it. */
    private static String quoted(String word) {
        return word.matches("[\\w./:=,@%+-]+") ? word : "'" + word.replace("'", "'\\''") + "'";
    }

    private static String name(Shard part) {
        return "sweep-" + part.number() + "-of-" + part.count() + ".jsonl";
    }

    /** The estimated time left, as text for people. */
    public static String left(long nanos, long done, long remaining) {
        if (done < 1) {
            return "";
        }
        Duration left = Duration.ofSeconds((long) Math.ceil(nanos / 1e9 / done * remaining));
        return left.toHours() > 0
                ? "%d h %d min left".formatted(left.toHours(), left.toMinutesPart())
                : left.toMinutes() > 0
                        ? "%d min %d s left".formatted(left.toMinutes(), left.toSecondsPart())
                        : left.toSeconds() + " s left";
    }

    private ParameterSweep sweep() throws IOException {
        if (scenario == null) {
            throw new UsageException("SCENARIO must be given (got: none)");
        }
        ParameterSweep sweep;
        if (scenario.endsWith(ScenarioReader.ENDING) || Files.isRegularFile(Path.of(scenario))) {
            Path conversationFile = Arguments.input("SCENARIO", Path.of(scenario));
            files.opened(conversationFile);
            ScenarioSweep read = withGoals(ScenarioSweep.read(conversationFile));
            AnswerProofs answers = proofs.of(read.options());
            ScenarioSweep conversation = answers == null ? read : read.heardBy(answers);
            sweep = ParameterSweep.of(conversation);
            if (worlds.isEmpty()) {
                sweep = sweep.over(conversation.world());
            }
            for (Path world : worlds) {
                sweep = sweep.over(conversation.in(world(world)));
            }
        } else {
            if (!goals.isEmpty()) {
                throw new UsageException(
                        "--goal is for a scenario file; a class measures what it wants (got: " + goals.get(0) + ")");
            }
            if (proofs.of(SessionOptions.ROBOSIM) != null) {
                throw new UsageException(
                        "--prove is for a scenario file, whose answers it sees; a class can ask Geometry.prove() itself"
                                + " (got: " + scenario + ")");
            }
            sweep = ParameterSweep.of(made(scenario));
            if (worlds.isEmpty()) {
                throw new UsageException("WORLD must be given for a class; a scenario file has its own (got: none)");
            }
            for (Path world : worlds) {
                sweep = sweep.over(world(world));
            }
        }
        Set<String> names = new HashSet<>();
        for (String parameter : parameters) {
            int end = parameter.indexOf('=');
            Arguments.refuse(end < 1, "--parameter must be NAME=VALUE[,VALUE...]", parameter);
            String name = parameter.substring(0, end);
            if (!names.add(name)) {
                throw new UsageException(
                        "--parameter must name each parameter once, with commas between its values (got: " + name
                                + " again)");
            }
            sweep = sweep.vary(name, parameter.substring(end + 1).split(",", -1));
        }
        return sweep.replicates(replicates).seed(seed);
    }

    private ScenarioSweep withGoals(ScenarioSweep conversation) {
        ScenarioSweep sweep = conversation;
        for (String goal : goals) {
            Matcher words = GOAL.matcher(goal);
            Arguments.refuse(!words.matches(), "--goal must be ROBOT@X,Z,RADIUS, as in cart@4,-2,0.5", goal);
            try {
                sweep = sweep.toGoal(
                        words.group(1),
                        Double.parseDouble(words.group(2)),
                        Double.parseDouble(words.group(3)),
                        Double.parseDouble(words.group(4)));
            } catch (IllegalArgumentException e) {
                throw new UsageException("--goal: " + e.getMessage(), e);
            }
        }
        return sweep;
    }

    private SweepWorld world(Path file) throws IOException {
        return SweepWorld.of(file, files.world(Arguments.input("WORLD", file)));
    }

    private SweepScenario made(String name) {
        try {
            Object made = Class.forName(name).getConstructor().newInstance();
            if (made instanceof SweepScenario found) {
                return found;
            }
            throw new UsageException("SCENARIO must be a class that implements " + SweepScenario.class.getName()
                    + " (got: " + name + ")");
        } catch (ClassNotFoundException e) {
            throw new UsageException(
                    "SCENARIO must be a *" + ScenarioReader.ENDING
                            + " or a class on the class path, for which start this as java -cp JAR:FOLDER"
                            + " robosim.geometry.cli.Main; there is none of that name (got: " + name + ")",
                    e);
        } catch (InvocationTargetException | ExceptionInInitializerError e) {
            throw new UsageException(
                    "SCENARIO must be a class that can be instantiated (got: " + name + ", which failed with "
                            + e.getCause() + ")",
                    e);
        } catch (ReflectiveOperationException | LinkageError e) {
            throw new UsageException(
                    "SCENARIO must be a public class with a public constructor without arguments (got: " + name + ", "
                            + e + ")",
                    e);
        }
    }
}
