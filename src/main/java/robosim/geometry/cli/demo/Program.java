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

/** A program of examples/ in a process of its own, on the class path of this module alone: its source, or its class. */
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
     * @param program its source file, or the class to be run and what names the program to it
     * @param watched whether what it writes as an error, and a progress bar with it, goes straight to this terminal
     */
    static Program start(List<String> program, boolean watched, List<String> arguments) throws IOException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
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

    /** Whether this module's classes are in a jar. */
    static boolean isInJar() {
        return Files.isRegularFile(home());
    }

    /** Where this module's classes are: a folder or a jar. */
    public static Path home() {
        CodeSource source = Program.class.getProtectionDomain().getCodeSource();
        if (source == null) {
            throw new IllegalStateException("the place of the module's classes must be known to start it again");
        }
        try {
            return Path.of(source.getLocation().toURI());
        } catch (URISyntaxException e) {
            throw new IllegalStateException("the place of the module's classes is no path: " + source.getLocation(), e);
        }
    }

    /** A file of the project: from the working directory, or else from the project that target/classes is in. */
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

    /** Its next line, which also counts as its text; null at the end. */
    @Nullable
    String line() throws IOException {
        String line = output.readLine();
        if (line != null) {
            text.append(line).append(System.lineSeparator());
        }
        return line;
    }

    /** Waits for its end and answers its exit code. */
    int end() throws IOException, InterruptedException {
        while (line() != null) {
            // line() keeps what it read.
        }
        return process.waitFor();
    }

    /** What it has written so far, as far as it was read. */
    String text() {
        return text.toString();
    }

    /** Ends it where it still runs. */
    @Override
    public void close() {
        process.destroy();
    }
}
