package robosim.geometry.cli.terminal;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import robosim.geometry.world.ImportOptions;
import robosim.geometry.world.Skipped;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldException;
import robosim.geometry.world.WorldImport;

/** Files that a command reads. */
public final class Inputs {
    private static final int MOST_SKIPPED = 10;

    private Inputs() {}

    /**
     * A file that is there.
     *
     * @param parameter what the help calls it
     */
    public static Path file(CommandSpec spec, String parameter, Path file) {
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
        if (!Files.isRegularFile(file)) {
            throw new ParameterException(
                    spec.commandLine(),
                    parameter
                            + " must be a regular file; this is a pipe, a socket or a device, so save what it gives to"
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
     * Folders that are there.
     *
     * @param option what the help calls them
     */
    public static void folders(CommandSpec spec, String option, List<Path> folders) {
        for (Path folder : folders) {
            if (!Files.isDirectory(folder)) {
                throw new ParameterException(
                        spec.commandLine(), option + " must be a folder; there is none (got: " + folder + ")");
            }
        }
    }

    /**
     * A world of any format; what the file has and the world has not is told on the standard error.
     *
     * @param models folders for SDFormat's {@code model://}
     */
    public static World world(CommandSpec spec, Path file, List<Path> models) throws WorldException {
        folders(spec, "--models", models);
        WorldImport read = WorldImport.read(file, ImportOptions.DEFAULT.withModels(models));
        List<Skipped> skipped = read.skipped();
        PrintWriter err = spec.commandLine().getErr();
        skipped.stream().limit(MOST_SKIPPED).forEach(err::println);
        if (skipped.size() > MOST_SKIPPED) {
            err.println("... and " + (skipped.size() - MOST_SKIPPED) + " more, which `convert --all` names");
        }
        return read.world();
    }
}
