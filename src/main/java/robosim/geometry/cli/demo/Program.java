package robosim.geometry.cli.demo;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A program of examples/, run from source or from its class in a process of its own with only this module on the class
 * path.
 */
public final class Program implements AutoCloseable {
    private final Process process;
    private final BufferedReader output;
    private final StringBuilder text = new StringBuilder();

    private Program(Process process) {
        this.process = process;
        this.output = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    }

    /**
     * Starts a program.
     *
     * @param program its source file, or the class to run followed by the program's name
     * @param watched whether its standard error, including a progress bar, goes straight to this terminal
     */
    static Program start(List<String> program, boolean watched, List<String> arguments) throws IOException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        // It runs for seconds, most of them to compile the program: the JVM's second compiler takes more than it saves.
        command.add("-XX:TieredStopAtLevel=1");
        command.add("-Dstdout.encoding=UTF-8");
        command.add("-Dfile.encoding=UTF-8");
        command.add("-cp");
        command.add(home().toString());
        command.addAll(program);
        command.addAll(arguments);
        ProcessBuilder builder = new ProcessBuilder(command);
        if (watched) {
            builder.redirectError(ProcessBuilder.Redirect.INHERIT);
        } else {
            builder.redirectErrorStream(true);
        }
        Process process = builder.start();
        process.getOutputStream().close();
        return new Program(process);
    }

    /** Whether this module runs from a jar. */
    static boolean isInJar() {
        return Files.isRegularFile(home());
    }

    /** The folder or jar that holds this module's classes. */
    public static Path home() {
        CodeSource source = Program.class.getProtectionDomain().getCodeSource();
        if (source == null) {
            throw new IllegalStateException(
                    "the location of the module's classes is unknown, so it cannot be started again");
        }
        try {
            return Path.of(source.getLocation().toURI());
        } catch (URISyntaxException e) {
            throw new IllegalStateException(
                    "the location of the module's classes is not a path: " + source.getLocation(), e);
        }
    }

    /**
     * A file of the project, looked up in the working directory and then in the project that target/classes belongs to;
     * null if it is in neither.
     */
    static @Nullable Path projectFile(String name) {
        Path here = Path.of(name);
        if (Files.exists(here)) {
            return here;
        }
        Path classes = home();
        Path project =
                classes.endsWith("classes") ? classes.resolve("../..").normalize() : classes.resolveSibling("..");
        Path there = project.resolve(name).normalize();
        return Files.exists(there) ? there : null;
    }

    /** The next line of its output; null at the end. {@link #text} includes it. */
    @Nullable
    String line() throws IOException {
        String line = output.readLine();
        if (line != null) {
            text.append(line).append(System.lineSeparator());
        }
        return line;
    }

    /** Waits for the program to end and returns its exit code. */
    int end() throws IOException, InterruptedException {
        while (line() != null) {
            // line() stores what it reads.
        }
        return process.waitFor();
    }

    /** The output read so far. */
    String text() {
        return text.toString();
    }

    /** Ends the program if it is still running. */
    @Override
    public void close() {
        process.destroy();
    }
}
