package robosim.geometry.cli.terminal;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import robosim.geometry.world.ImportOptions;
import robosim.geometry.world.Skipped;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldException;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.WorldReader;

/** The worlds that a command reads: where it looks for their models, and which files they came from. */
public final class WorldFiles {
    private static final int MOST_SKIPPED = 10;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Option(
            names = "--models",
            paramLabel = "DIR",
            description =
                    "a folder of models for SDFormat's model://, in addition to the world file's own; may be repeated")
    private List<Path> models = new ArrayList<>();

    private final Set<Path> opened = new LinkedHashSet<>();

    /** Refuses a folder of models that does not exist. */
    public void check() {
        Arguments.folders("--models", models);
    }

    /** The folders given, which must exist, and those of the environment. */
    public List<Path> folders() {
        check();
        return ModelFolders.with(models);
    }

    /** Reads a world of any format; models are those of {@link #folders()}, not of the options. */
    public WorldImport read(Path file, ImportOptions options) throws WorldException {
        ImportOptions all = options.withModels(folders());
        try {
            return WorldImport.read(file, all, opened::add);
        } catch (WorldException first) {
            // The command ends with the last one.
            List<WorldException> problems = WorldReader.problems(file, all);
            if (problems.size() < 2) {
                throw first;
            }
            PrintWriter err = spec.commandLine().getErr();
            problems.subList(0, problems.size() - 1).forEach(each -> err.println(each.getMessage()));
            throw problems.get(problems.size() - 1);
        }
    }

    /** Reads a world of any format; what is left out of the file is reported on the standard error. */
    public World world(Path file) throws WorldException {
        WorldImport read = read(file, ImportOptions.DEFAULT);
        List<Skipped> skipped = read.skipped();
        PrintWriter err = spec.commandLine().getErr();
        skipped.stream().limit(MOST_SKIPPED).forEach(err::println);
        if (skipped.size() > MOST_SKIPPED) {
            err.println("... and " + (skipped.size() - MOST_SKIPPED) + " more; `convert --all` lists them all");
        }
        return read.world();
    }

    /** Names another file that this command reads. */
    public void opened(Path file) {
        opened.add(file);
    }

    /** Whether more files than one were read, as where one includes others. */
    public boolean areSeveral() {
        return opened.size() > 1;
    }

    /** Refuses a file to write that is one of those read: it would be lost. */
    public Path output(String parameter, Path file) throws IOException {
        if (Files.exists(file)) {
            for (Path input : opened) {
                Arguments.refuse(
                        Files.exists(input) && Files.isSameFile(file, input),
                        parameter + " must not be a file that is read, which it would overwrite; name another",
                        file);
            }
        }
        return file;
    }
}
