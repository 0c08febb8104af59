package robosim.geometry.cli;

import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.UsageMessageSpec;
import robosim.geometry.cli.demo.DemoCommand;
import robosim.geometry.cli.network.ConnectCommand;
import robosim.geometry.cli.network.ServeCommand;
import robosim.geometry.cli.studies.DrivingCommand;
import robosim.geometry.cli.studies.ReplayCommand;
import robosim.geometry.cli.studies.SweepCommand;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.FailureText;
import robosim.geometry.cli.terminal.PlainPrinter;
import robosim.geometry.cli.terminal.Terminal;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.Values;
import robosim.geometry.cli.terminal.Version;
import robosim.geometry.cli.worlds.AddCommand;
import robosim.geometry.cli.worlds.CheckCommand;
import robosim.geometry.cli.worlds.ConvertCommand;
import robosim.geometry.cli.worlds.ExportCommand;
import robosim.geometry.cli.worlds.RenderCommand;
import robosim.geometry.cli.worlds.ScanCommand;
import robosim.geometry.cli.worlds.ViewCommand;

/** All commands, and how their failures are reported. */
@Command(
        name = Version.PROGRAM,
        description = "Collision, motion and range queries for robot simulators, over TCP and on files.",
        synopsisSubcommandLabel = "COMMAND",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        exitCodeList = {
            ExitCodes.DONE,
            ExitCodes.FINDINGS + ":done, with findings: answers differ, or a world has findings",
            ExitCodes.UNUSABLE + ":not done: bad usage, input that cannot be read, a connection that failed"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  robosim-geometry demo",
            "  robosim-geometry check robosim-demo/rooms.xml",
            "  robosim-geometry render robosim-demo/rooms.xml -o rooms.svg",
            "  robosim-geometry COMMAND --help"
        })
public final class Commands implements Terminal.Program {
    /** What people who do not know a program type first. */
    private static final String HELP = "help";

    private static final Set<String> HELPS = Set.of(HELP, "--help", "-h");

    private static final List<Class<?>> COMMANDS = List.of(
            DemoCommand.class,
            CheckCommand.class,
            RenderCommand.class,
            ScanCommand.class,
            ViewCommand.class,
            ExportCommand.class,
            ConvertCommand.class,
            AddCommand.class,
            ServeCommand.class,
            ConnectCommand.class,
            DrivingCommand.class,
            ReplayCommand.class,
            SweepCommand.class,
            CompletionCommand.class);

    private final boolean standard;

    private Commands(boolean standard) {
        this.standard = standard;
    }

    static int run(String... arguments) {
        CommandLine line = isOverview(arguments) ? overview(true) : line(true, needed(arguments));
        // A file's name must not control the terminal; only help has colors.
        if (arguments.length > 0 && Arrays.stream(arguments).noneMatch(HELPS::contains)) {
            line.setOut(new PlainPrinter(System.out, charset("sun.stdout.encoding")));
            line.setErr(new PlainPrinter(System.err, charset("sun.stderr.encoding")));
        }
        return run(line, arguments);
    }

    private static Charset charset(String property) {
        String name = System.getProperty(property);
        return name == null ? Charset.defaultCharset() : Charset.forName(name);
    }

    /** Runs a command with its output redirected, and returns its exit code. */
    static int run(PrintWriter out, PrintWriter err, String... arguments) {
        CommandLine line = isOverview(arguments) ? overview(false) : line(false, needed(arguments));
        line.setOut(out);
        line.setErr(err);
        return run(line, arguments);
    }

    /** The command line with all its commands, before arguments are parsed. */
    static CommandLine line(boolean standard) {
        return line(standard, COMMANDS);
    }

    private static CommandLine line(boolean standard, List<Class<?>> commands) {
        CommandLine line = new CommandLine(new Commands(standard));
        commands.forEach(line::addSubcommand);
        Values.register(line);
        describe(line);
        return line;
    }

    /** Whether only the list of all commands is wanted. */
    private static boolean isOverview(String... arguments) {
        return arguments.length == 0 || (arguments.length == 1 && HELPS.contains(arguments[0]));
    }

    /** The command line with the names and descriptions of its commands, without their options: those take most of the time. */
    private static CommandLine overview(boolean standard) {
        CommandLine line = line(standard, List.of());
        for (Class<?> command : COMMANDS) {
            Command described = command.getAnnotation(Command.class);
            CommandSpec name = CommandSpec.create().name(described.name());
            name.usageMessage().description(described.description());
            line.addSubcommand(described.name(), name);
        }
        return line;
    }

    /** What the help of all commands has in common. */
    private static void describe(CommandLine line) {
        CommandSpec spec = line.getCommandSpec().versionProvider(new Version());
        spec.mixinStandardHelpOptions(true);
        UsageMessageSpec help = spec.usageMessage().exitCodeListHeading("%nExit codes:%n");
        if (help.exitCodeList().isEmpty()) {
            help.exitCodeList(UsageMessageSpec.keyValuesMap(ExitCodes.DONE, ExitCodes.REFUSED));
        }
        if (help.footerHeading().isEmpty()) {
            help.footerHeading("%nExamples:%n");
        }
        line.getSubcommands().values().forEach(Commands::describe);
    }

    /** The command that is called, if one is: to describe all of them takes a third of the time of a short one. */
    private static List<Class<?>> needed(String... arguments) {
        for (Class<?> command : COMMANDS) {
            Command described = command.getAnnotation(Command.class);
            boolean isCalled = arguments.length > 0
                    && described != null
                    && described.name().equals(arguments[0]);
            if (isCalled && command != CompletionCommand.class) {
                return List.of(command);
            }
        }
        return COMMANDS;
    }

    @Override
    public boolean writesToStandardError() {
        return standard;
    }

    private static int run(CommandLine line, String... arguments) {
        line.setExecutionExceptionHandler((failure, command, parsed) -> {
            command.getErr().println(FailureText.of(failure));
            return failure instanceof UsageException ? pointToHelp(command) : ExitCodes.UNUSABLE;
        });
        // Only what is wrong; the full help is printed on request.
        line.setParameterExceptionHandler((refused, given) -> {
            CommandLine command = refused.getCommandLine();
            command.getErr().println(refused.getMessage());
            CommandLine.UnmatchedArgumentException.printSuggestions(refused, command.getErr());
            return pointToHelp(command);
        });
        if (arguments.length == 0) {
            line.usage(line.getErr());
            return ExitCodes.UNUSABLE;
        }
        return line.execute(arguments[0].equals(HELP) ? asked(line, arguments) : arguments);
    }

    private static int pointToHelp(CommandLine command) {
        command.getErr().println("See: " + command.getCommandSpec().qualifiedName() + " --help");
        return ExitCodes.UNUSABLE;
    }

    /** {@code help sweep} is turned into {@code sweep --help}; an unknown command stays as it is and is refused. */
    private static String[] asked(CommandLine line, String... arguments) {
        List<String> words = new ArrayList<>(List.of(arguments).subList(1, arguments.length));
        CommandLine command = line;
        for (String word : words) {
            command = command.getSubcommands().get(word);
            if (command == null) {
                return words.toArray(new String[0]);
            }
        }
        words.add("--help");
        return words.toArray(new String[0]);
    }
}
