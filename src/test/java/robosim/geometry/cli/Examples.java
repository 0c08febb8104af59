package robosim.geometry.cli;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import robosim.geometry.cli.demo.Program;

/** The programs of examples/, compiled as a user would compile them. */
public final class Examples {
    public static final Path FOLDER = Path.of("examples");

    private Examples() {}

    static List<Path> sources() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(file -> file.toString().endsWith(".java"))
                    .sorted()
                    .toList();
        }
    }

    /** Compiles sources against the module's classes alone and answers what the compiler said; empty is good. */
    public static String compile(List<Path> sources, Path into) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter said = new StringWriter();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
            List<String> options = List.of(
                    "-Xlint:all",
                    "-Werror",
                    "-proc:none",
                    "--release",
                    "17",
                    "-d",
                    into.toString(),
                    "-cp",
                    Program.home().toString());
            boolean compiled = compiler.getTask(
                            said, files, null, options, null, files.getJavaFileObjectsFromPaths(sources))
                    .call();
            return compiled ? said.toString() : "not compiled: " + said;
        }
    }

    /** What the audit of a recording writes, and its exit code at the end. */
    public static String audit(Path recording, Path compiled) throws Exception {
        URL[] place = {compiled.toUri().toURL()};
        try (URLClassLoader loader = new URLClassLoader(place, Examples.class.getClassLoader())) {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            PrintStream out = new PrintStream(bytes, true, StandardCharsets.UTF_8);
            Object code = loader.loadClass("ConversationAudit")
                    .getMethod("run", String[].class, PrintStream.class)
                    .invoke(null, new String[] {recording.toString()}, out);
            return bytes.toString(StandardCharsets.UTF_8) + "exit " + code;
        }
    }
}
