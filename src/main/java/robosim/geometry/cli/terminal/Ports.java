package robosim.geometry.cli.terminal;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Checks port numbers. */
public final class Ports {
    private Ports() {}

    public static void check(CommandSpec spec, int port, int least) {
        if (port < least || port > 65535) {
            throw new ParameterException(spec.commandLine(), "PORT must be " + least + " to 65535 (got: " + port + ")");
        }
    }
}
