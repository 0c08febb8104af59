package robosim.geometry.cli.terminal;

import java.io.Console;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import picocli.CommandLine;

/** Tells whether the standard error is a terminal. */
public final class Terminal {
    /** On Linux, a link to what the standard error is connected to. */
    private static final Path ERROR = Path.of("/proc/self/fd/2");

    /** Prefixes of the names of terminals. */
    private static final String[] DEVICES = {"/dev/pts/", "/dev/tty", "/dev/console"};

    private Terminal() {}

    /** All commands together. */
    @FunctionalInterface
    public interface Program {
        /** Whether what a command writes as its error is the process's own. */
        boolean writesToStandardError();
    }

    /** Whether a command's errors go to a terminal that can redraw a line. */
    static boolean shows(CommandLine line) {
        return line.getCommandSpec().root().userObject() instanceof Program program
                && program.writesToStandardError()
                && isPresent();
    }

    /**
     * Whether this process's standard error is a terminal; where the system does not say, whether its standard input
     * and output are.
     */
    public static boolean isPresent() {
        if ("dumb".equals(System.getenv("TERM"))) {
            return false;
        }
        try {
            String device = Files.readSymbolicLink(ERROR).toString();
            for (String begin : DEVICES) {
                if (device.startsWith(begin)) {
                    return true;
                }
            }
            return false;
        } catch (IOException | UnsupportedOperationException | InvalidPathException elsewhere) {
            return isConsole();
        }
    }

    @SuppressWarnings("SystemConsoleNull") // null before Java 22 only; from then on isTerminal tells
    private static boolean isConsole() {
        Console console = System.console();
        if (console == null) {
            return false;
        }
        try {
            // From Java 22 on a console may exist without a terminal, and this method tells.
            return (boolean) Console.class.getMethod("isTerminal").invoke(console);
        } catch (ReflectiveOperationException before22) {
            return true;
        }
    }
}
