package robosim.geometry;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Commands that start another JVM of the kind that this one is. It runs for a second or so, hence with the first compiler
 * alone and without threads of a collector.
 */
public final class ChildJvm {
    /** What makes a short run of a JVM cheap. */
    public static final List<String> FLAGS = List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");

    private ChildJvm() {}

    /** The program {@code java} with these arguments. */
    public static List<String> command(String... arguments) {
        List<String> command = new ArrayList<>(FLAGS);
        command.add(0, Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(List.of(arguments));
        return command;
    }

    /** A program of this JVM's class path. */
    public static List<String> running(Class<?> program, String... arguments) {
        List<String> command = command("-cp", System.getProperty("java.class.path"), program.getName());
        command.addAll(List.of(arguments));
        return command;
    }
}
