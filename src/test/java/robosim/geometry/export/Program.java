package robosim.geometry.export;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** A program of the machine that a test uses where it is there. */
final class Program {
    private Program() {}

    /** The first of these that the search path has. */
    static Optional<String> find(String... names) {
        String path = System.getenv("PATH");
        for (String name : names) {
            Optional<String> found = Stream.of(path == null ? new String[0] : path.split(File.pathSeparator))
                    .map(folder -> Path.of(folder, name))
                    .filter(Files::isExecutable)
                    .map(Path::toString)
                    .findFirst();
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }

    /** What it printed: on its standard output, and as its errors. */
    record Said(int code, String out, String err) {}

    static Said run(Path folder, long seconds, Map<String, String> environment, List<String> command)
            throws IOException, InterruptedException {
        Path out = folder.resolve("program.out");
        Path err = folder.resolve("program.err");
        ProcessBuilder builder =
                new ProcessBuilder(command).redirectOutput(out.toFile()).redirectError(err.toFile());
        builder.environment().putAll(environment);
        Process process = builder.start();
        if (!process.waitFor(seconds, TimeUnit.SECONDS)) {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
            throw new IOException("not done after " + seconds + " s: " + command + "\n"
                    + Files.readString(err, StandardCharsets.UTF_8));
        }
        return new Said(process.exitValue(), Files.readString(out), Files.readString(err));
    }
}
