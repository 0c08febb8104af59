package robosim.geometry.cli;

import java.io.PrintStream;
import java.util.Map;
import java.util.function.IntSupplier;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.worlds.ViewCommand;

/** The command line: {@code --help} tells its commands. */
public final class Main {
    /** What a missing class begins with, and the sentence about it. */
    private static final Map<String, String> LIBRARIES = Map.of(
            "picocli/",
            "The command line needs picocli, which this jar has not inside: run the one whose name ends in -app.jar"
                    + " (java -jar robosim-geometry-...-app.jar), or put picocli's jar beside this one on the class path;"
                    + " on a module path also --add-modules info.picocli,java.desktop",
            "com/fasterxml/jackson/core/",
            "JSON lines, which recordings are made of, need Jackson: run the jar whose name ends in -app.jar, or put"
                    + " com.fasterxml.jackson.core:jackson-core on the class path",
            "org/snakeyaml/engine/",
            "ROS maps need snakeyaml-engine: run the jar whose name ends in -app.jar, or put"
                    + " org.snakeyaml:snakeyaml-engine on the class path",
            "java/awt/",
            "Pictures need the module java.desktop, which this Java runtime has not: run it with a whole JDK or JRE, or"
                    + " with --add-modules java.desktop",
            "javax/",
            "This needs a part of Java which this Java runtime has not: run it with a whole JDK or JRE");

    private Main() {}

    /**
     * Runs a command and exits with its code where that is not 0: 1 where something was found, 2 where it could not be
     * done.
     *
     * @param arguments the command and what it takes
     */
    public static void main(String[] arguments) {
        // No command but one needs a screen.
        if (arguments.length == 0 || !arguments[0].equals(ViewCommand.NAME)) {
            System.setProperty("java.awt.headless", "true");
        }
        int code = code(() -> Commands.run(arguments), System.err);
        if (code != 0) {
            System.exit(code);
        }
    }

    /** The code of a command; that of what was not done where it ends in an error, which is told in a sentence. */
    static int code(IntSupplier command, PrintStream err) {
        try {
            return command.getAsInt();
        } catch (NoClassDefFoundError missing) {
            err.println(sentence(missing));
        } catch (OutOfMemoryError full) {
            err.println("There is not enough memory; give Java more of it, like java -Xmx4g -jar ..., or ask for less"
                    + " (got: " + full.getMessage() + ")");
        } catch (StackOverflowError deep) {
            err.println("Something is nested too deep; give Java a larger stack, like java -Xss64m -jar ... (got: "
                    + deep + ")");
        } catch (Error other) {
            // Java itself would end with 1, which means that something was found.
            err.println("Java failed; please report this (got: " + other + ")");
        }
        return ExitCodes.UNUSABLE;
    }

    /** What to do about a class that is not there. */
    static String sentence(NoClassDefFoundError missing) {
        String name = String.valueOf(missing.getMessage());
        return LIBRARIES.entrySet().stream()
                        .filter(library -> name.startsWith(library.getKey()))
                        .map(Map.Entry::getValue)
                        .findAny()
                        .orElse("A class is missing; take the jar as it was built")
                + " (missing: " + name + ")";
    }
}
