package robosim.geometry.cli.terminal;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;

/**
 * Checks arguments before a command starts its work: what is made in an hour has a place to go. Each method takes the
 * argument's name in the help and throws a {@link UsageException}.
 */
public final class Arguments {
    private Arguments() {}

    /** Returns a file if it exists and can be read. */
    public static Path input(String parameter, Path file) {
        refuse(Files.isDirectory(file), parameter + " must be a file, not a folder; name a file in it", file);
        refuse(!Files.exists(file), parameter + " must be a file that exists; check the path", file);
        refuse(
                !Files.isRegularFile(file),
                parameter + " must be a regular file, not a pipe, a socket or a device; save its contents to"
                        + " a file first",
                file);
        refuse(!Files.isReadable(file), parameter + " must be a file that you may read; check who owns it", file);
        return file;
    }

    /** Checks that folders exist. */
    public static void folders(String option, List<Path> folders) {
        for (Path folder : folders) {
            refuse(!Files.isDirectory(folder), option + " must be a folder that exists", folder);
        }
    }

    /**
     * Returns a file that can be written, as far as can be told without writing it.
     *
     * @param endings how its name may end, in lower case; none if that does not matter
     */
    public static Path output(String parameter, Path file, String... endings) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        refuse(
                endings.length > 0 && Arrays.stream(endings).noneMatch(name::endsWith),
                parameter + " must end in " + either(List.of(endings)),
                file);
        boolean isFolder = file.getFileName() == null || name.isEmpty() || Files.isDirectory(file);
        refuse(isFolder, parameter + " must be a file, not a folder", file);
        boolean isLocked = Files.exists(file) && !Files.isWritable(file);
        refuse(isLocked, parameter + " must be a file that you may write; check who owns it", file);
        Path folder = file.toAbsolutePath().resolveSibling("");
        refuse(
                !Files.isDirectory(folder),
                parameter + " must be in a folder that exists; create the folder first",
                file);
        // A file is written under another name and then moved to its own.
        refuse(
                !Files.isWritable(folder),
                parameter + " must be in a folder that you may write to; check who owns it",
                file);
        return file;
    }

    /** Returns a file that can be written and does not exist yet. */
    public static Path newFile(String parameter, Path file) {
        refuse(
                Files.exists(file),
                parameter + " must be a new file; remove this one, which is not overwritten, or choose another name",
                file);
        return output(parameter, file);
    }

    private static String either(List<String> words) {
        int last = words.size() - 1;
        return last < 1 ? String.join("", words) : String.join(", ", words.subList(0, last)) + " or " + words.get(last);
    }

    public static void port(int port, int least) {
        refuse(port < least || port > 65535, "PORT must be " + least + " to 65535", port);
    }

    /** Reads numbers between commas; null if they are others than numbers, or fewer or more than asked for. */
    public static double @Nullable [] numbers(String text, int least, int most) {
        String[] words = text.split(",", -1);
        if (words.length < least || words.length > most) {
            return null;
        }
        try {
            return Arrays.stream(words).mapToDouble(Double::parseDouble).toArray();
        } catch (NumberFormatException e) {
            return null;
        }
    }

    /**
     * Reads a point from three numbers between commas.
     *
     * @param form what the argument may be, in words
     */
    public static Point point(String parameter, String form, String text) {
        double[] at = numbers(text, 3, 3);
        try {
            if (at != null) {
                return new Point(at[0], at[1], at[2]);
            }
        } catch (IllegalArgumentException e) {
            // refused below
        }
        throw new UsageException(parameter + " must be " + form + " (got: " + text + ")");
    }

    /** Refuses an argument if something is so; {@code rule} says what it must be. */
    public static void refuse(boolean isSo, String rule, Object got) {
        if (isSo) {
            throw new UsageException(rule + " (got: " + got + ")");
        }
    }
}
