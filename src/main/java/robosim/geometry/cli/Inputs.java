package robosim.geometry.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Files that a command reads. */
final class Inputs {
    private Inputs() {}

    /**
     * A file that is there.
     *
     * @param parameter what the help calls it
     */
    static Path file(CommandSpec spec, String parameter, Path file) {
        if (Files.isDirectory(file)) {
            throw new ParameterException(
                    spec.commandLine(),
                    parameter + " must be a file; this is a folder, name one in it (got: " + file + ")");
        }
        if (!Files.exists(file)) {
            throw new ParameterException(
                    spec.commandLine(),
                    parameter + " must be a file; there is none, check the path (got: " + file + ")");
        }
        if (!Files.isReadable(file)) {
            throw new ParameterException(
                    spec.commandLine(),
                    parameter + " must be a file that you may read; check who owns it (got: " + file + ")");
        }
        return file;
    }
}
