package robosim.geometry.cli;

import java.io.PrintWriter;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** All commands, and what becomes of their failures. */
@Command(
        name = "robosim-geometry",
        description = "Collision, motion and range queries for robot simulators, over TCP.",
        synopsisSubcommandLabel = "COMMAND",
        mixinStandardHelpOptions = true,
        version = "robosim-geometry 1.0.0-SNAPSHOT",
        subcommands = {
            DemoCommand.class,
            ServeCommand.class,
            ConnectCommand.class,
            RenderCommand.class,
            ReplayCommand.class
        })
final class Commands {
    /** The exit code where the module was found wrong. */
    static final int WRONG = 1;

    /** The exit code where it could not be asked. */
    static final int UNUSABLE = 2;

    private Commands() {}

    static int run(String... arguments) {
        return run(new CommandLine(new Commands()), arguments);
    }

    /** Runs a command that writes elsewhere. */
    static int run(PrintWriter out, PrintWriter err, String... arguments) {
        CommandLine line = new CommandLine(new Commands());
        line.setOut(out);
        line.setErr(err);
        return run(line, arguments);
    }

    private static int run(CommandLine line, String... arguments) {
        line.setCaseInsensitiveEnumValuesAllowed(true);
        line.setExecutionExceptionHandler((failure, command, parsed) -> {
            String message = failure.getMessage();
            command.getErr().println(message == null ? failure.toString() : message);
            return UNUSABLE;
        });
        if (arguments.length == 0) {
            line.usage(line.getErr());
            return UNUSABLE;
        }
        return line.execute(arguments);
    }
}
