package robosim.geometry.cli;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.Map;
import java.util.function.IntSupplier;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.world.xml.WorldSchema;

/** The entry point of the command line; {@code --help} lists the commands. */
public final class Main {
    /** From the beginning of a missing class's name to a sentence about what is missing. */
    private static final Map<String, String> LIBRARIES = Map.of(
            "picocli/",
            "The command line needs picocli, which this jar does not contain: run the jar whose name ends in -app.jar"
                    + " (java -jar robosim-geometry-...-app.jar), or put picocli's jar on the class path too;"
                    + " on a module path also --add-modules info.picocli,java.desktop",
            "com/fasterxml/jackson/core/",
            "Recordings and other JSON lines need Jackson: run the jar whose name ends in -app.jar, or put"
                    + " com.fasterxml.jackson.core:jackson-core on the class path",
            "org/snakeyaml/engine/",
            "ROS maps need snakeyaml-engine: run the jar whose name ends in -app.jar, or put"
                    + " org.snakeyaml:snakeyaml-engine on the class path",
            "java/awt/",
            "Pictures need the module java.desktop, which this Java runtime lacks: use a full JDK or JRE, or run"
                    + " with --add-modules java.desktop",
            "javax/",
            "This needs a part of Java that this Java runtime lacks: use a full JDK or JRE");

    private static final long USUAL_GIGABYTES = 4;

    private Main() {}

    /**
     * Runs a command and exits with its code unless that is 0: 1 means findings, 2 that the command could not be
     * carried out.
     *
     * @param arguments the command and its arguments
     */
    public static void main(String[] arguments) {
        System.setProperty("java.awt.headless", "true"); // pictures need no display
        int code = code(
                () -> {
                    if (Arrays.stream(arguments).anyMatch(argument -> argument.endsWith(".xml"))) {
                        WorldSchema.prepare(); // while the command line is parsed
                    }
                    return Commands.run(arguments);
                },
                System.err);
        if (code != 0) {
            System.exit(code);
        }
    }

    /**
     * Runs a command and returns its exit code. An error is reported as one sentence and gives {@link
     * ExitCodes#UNUSABLE}.
     */
    static int code(IntSupplier command, PrintStream err) {
        try {
            return command.getAsInt();
        } catch (NoClassDefFoundError missing) {
            err.println(sentence(missing));
        } catch (OutOfMemoryError full) {
            err.println("Not enough memory; give Java more, as in java -Xmx"
                    + moreGigabytes(Runtime.getRuntime().maxMemory())
                    + "g -jar ..., or use a smaller input (got: " + full.getMessage() + ")");
        } catch (StackOverflowError deep) {
            err.println("The input is nested too deep; give Java a larger stack, as in java -Xss64m -jar ... (got: "
                    + deep + ")");
        } catch (Error other) {
            // Java itself would exit with 1, which here means findings.
            err.println("Unexpected error; please report it (got: " + other + ")");
        }
        return ExitCodes.UNUSABLE;
    }

    /** Twice as much as there is, in gigabytes, and no less than is usually enough. */
    static long moreGigabytes(long most) {
        return Math.max(USUAL_GIGABYTES, (most >> 30) * 2 + 2);
    }

    static String sentence(NoClassDefFoundError missing) {
        String name = String.valueOf(missing.getMessage());
        return LIBRARIES.entrySet().stream()
                        .filter(library -> name.startsWith(library.getKey()))
                        .map(Map.Entry::getValue)
                        .findAny()
                        .orElse("A class is missing; use the jar as it was built")
                + " (missing: " + name + ")";
    }
}
