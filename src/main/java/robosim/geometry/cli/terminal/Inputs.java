package robosim.geometry.cli.terminal;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Files that a command reads. */
public final class Inputs {
    private Inputs() {}

    /**
     * Returns the file if it exists and can be read.
     *
     * @param parameter its name in the help
     */
    public static Path file(CommandSpec spec, String parameter, Path file) {
        if (Files.isDirectory(file)) {
            throw new ParameterException(
                    spec.commandLine(),
                    parameter + " must be a file, not a folder; name a file in it (got: " + file + ")");
        }
        if (!Files.exists(file)) {
            throw new ParameterException(
                    spec.commandLine(), parameter + " must be a file that exists; check the path (got: " + file + ")");
        }
        if (!Files.isRegularFile(file)) {
            throw new ParameterException(
                    spec.commandLine(),
                    parameter
                            + " must be a regular file, not a pipe, a socket or a device; save its contents to"
                            + " a file first (got: " + file + ")");
        }
        if (!Files.isReadable(file)) {
            throw new ParameterException(
                    spec.commandLine(),
                    parameter + " must be a file that you may read; check who owns it (got: " + file + ")");
        }
        return file;
    }

    /**
     * Checks that folders exist.
     *
     * @param option the option's name in the help
     */
    public static void folders(CommandSpec spec, String option, List<Path> folders) {
        for (Path folder : folders) {
            if (!Files.isDirectory(folder)) {
                throw new ParameterException(
                        spec.commandLine(), option + " must be a folder that exists (got: " + folder + ")");
            }
        }
    }
}
