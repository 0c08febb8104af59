package robosim.geometry.cli.terminal;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Files that a command writes, which are checked before its work starts: what is made in an hour has a place to go. */
public final class Outputs {
    private Outputs() {}

    /**
     * Returns a file that can be written, as far as can be told without writing it.
     *
     * @param parameter its name in the help
     * @param endings   how its name may end, in lower case; none if that does not matter
     */
    public static Path file(CommandSpec spec, String parameter, Path file, String... endings) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        List<String> allowed = List.of(endings);
        if (!allowed.isEmpty() && allowed.stream().noneMatch(name::endsWith)) {
            throw refused(spec, parameter + " must end in " + either(allowed), file);
        }
        if (file.getFileName() == null || file.toString().isEmpty() || Files.isDirectory(file)) {
            throw refused(spec, parameter + " must be a file, not a folder", file);
        }
        if (Files.exists(file) && !Files.isWritable(file)) {
            throw refused(spec, parameter + " must be a file that you may write; check who owns it", file);
        }
        Path folder = file.toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw refused(spec, parameter + " must be in a folder that exists; create the folder first", file);
        }
        // A file is written under another name and then moved to its own.
        if (!Files.isWritable(folder)) {
            throw refused(spec, parameter + " must be in a folder that you may write to; check who owns it", file);
        }
        return file;
    }

    /**
     * Returns a file that can be written and does not exist yet.
     *
     * @param parameter its name in the help
     */
    public static Path newFile(CommandSpec spec, String parameter, Path file) {
        if (Files.exists(file)) {
            throw refused(spec, parameter + " must be a new file; existing files are not overwritten", file);
        }
        return file(spec, parameter, file);
    }

    private static String either(List<String> words) {
        int last = words.size() - 1;
        return last == 0 ? words.get(0) : String.join(", ", words.subList(0, last)) + " or " + words.get(last);
    }

    private static ParameterException refused(CommandSpec spec, String message, Path file) {
        return new ParameterException(spec.commandLine(), message + " (got: " + file + ")");
    }
}
