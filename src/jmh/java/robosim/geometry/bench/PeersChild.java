package robosim.geometry.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** A JVM that holds the module's workloads and measures them once each time that it is told to; {@link Peers} starts it. */
public final class PeersChild implements AutoCloseable {
    /** Ends each answer. */
    private static final String DONE = "done";

    /** One collector that no core of its own is needed for, and room for a million objects. */
    private static final List<String> OPTIONS = List.of("-Xmx5g", "-XX:+UseSerialGC");

    private static final List<String> PROPERTIES = List.of("peers", "work", "sizes", "clock");

    private final Process process;
    private final PrintStream to;
    private final BufferedReader from;

    PeersChild(String classPath) throws IOException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(OPTIONS);
        for (String name : PROPERTIES) {
            if (System.getProperty(name) != null) {
                command.add("-D" + name + "=" + System.getProperty(name));
            }
        }
        command.addAll(List.of("-cp", classPath, PeersChild.class.getName()));
        process = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        to = new PrintStream(process.getOutputStream(), true, StandardCharsets.UTF_8);
        from = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    }

    /** What the JVM prints about a word. */
    List<String> ask(String word) throws IOException {
        to.println(word);
        List<String> lines = new ArrayList<>();
        for (String line = from.readLine(); !DONE.equals(line); line = from.readLine()) {
            if (line == null) {
                throw new IOException(
                        "the JVM that measures must answer " + word + " (it ended; see what it said above)");
            }
            lines.add(line);
        }
        return lines;
    }

    @Override
    public void close() {
        process.destroy();
    }

    /** Builds and warms up the workloads, then measures all of them at each line that it reads. */
    public static void main(String[] args) throws IOException, IllegalAccessException {
        List<String> works =
                List.of(System.getProperty("work", "W1a,W1b,W1c,W2,W3,W4,W5,W6").split(",", -1));
        List<String> sizes = List.of(System.getProperty("sizes", "").split(",", -1));
        List<Workload> all = PeerWorkloads.of(new PeerInputs(Path.of(System.getProperty("peers", "."))), works, sizes);
        all.forEach(Workload::warmUp);
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            for (Workload workload : all) {
                if (line.equals("facts")) {
                    facts(workload);
                } else {
                    workload.measure(); // as the engines: once for the caches, then by the clock
                    workload.print(workload.measure());
                }
            }
            System.out.println(DONE);
        }
    }

    private static void facts(Workload workload) throws IllegalAccessException {
        Workload.Structure structure = workload.structure();
        if (structure != null) {
            double bytes = Memory.sum(Memory.parts(structure.root())) / (double) structure.parts();
            double lines = CacheLines.of(structure.queries(), structure.ask());
            Timing.print(
                    "%s %s %s %.1f bytes a part, %.1f cache lines a query",
                    workload.peer(), workload.work(), workload.size(), bytes, lines);
        }
    }
}
