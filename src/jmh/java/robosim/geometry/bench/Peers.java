package robosim.geometry.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/**
 * The module on the inputs of native engines, and these engines beside it in the same run: a line for each measure, as
 * theirs, {@code peer workload size ns hits checksum build_ms}, then the ratios of
 * the least of the interleaved rounds: what else runs on the machine only ever adds.
 *
 * <p>W1a is a ray among flat objects, W1b a disc tested among them, W1c their checked additions one after the other, W2 a
 * pair of meshes of 4,000 triangles each, W3 a ray at a mesh, W4 an attempted move of one of a swarm. Hits and checksums
 * must be those of the inputs' own notes, or the run fails.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.bench.Peers
 * -Dpeers=FOLDER}, where the folder holds the inputs in {@code data} and, where there are any, the engines in
 * {@code bin} or in the folder of {@code -Dengines}. {@code -Dwork=W1a,W4} and {@code -Dsizes=100,10000} take a part, {@code -Drounds=7} sets the rounds.
 */
public final class Peers {
    /** Which engine answers which workload; each is asked for all sizes at once. */
    private static final Map<String, String> ENGINES = Map.of("embree", "W1 W3", "fcl", "W2", "parry", "W1 W2 W3");

    private Peers() {}

    /** One measure of one peer in one round. */
    private record Line(String peer, String work, String size, double nanos) {}

    /** Measures what the properties ask for. */
    public static void main(String[] args) throws IOException, InterruptedException {
        Path folder = Path.of(System.getProperty("peers", "."));
        List<String> works =
                List.of(System.getProperty("work", "W1a,W1b,W1c,W2,W3,W4").split(",", -1));
        List<String> sizes = List.of(System.getProperty("sizes", "").split(",", -1));
        int rounds = Integer.getInteger("rounds", 5);
        List<Workload> ours = PeerWorkloads.of(new PeerInputs(folder), works, sizes);
        for (Workload workload : ours) {
            workload.warmUp();
        }
        List<Line> lines = new ArrayList<>();
        for (int round = 0; round < rounds; round++) {
            for (Workload workload : ours) {
                workload.measure(); // as the engines: once for the caches, then by the clock
                double nanos = workload.measure();
                lines.add(new Line(workload.peer(), workload.work(), workload.size(), nanos));
                if (round == rounds - 1) {
                    workload.print(least(lines, workload.peer(), workload.work(), workload.size()));
                }
            }
            askEngines(folder, works, lines, round == rounds - 1);
        }
        printRatios(ours, lines);
    }

    private static void askEngines(Path folder, List<String> works, List<Line> lines, boolean aloud)
            throws IOException, InterruptedException {
        Path engines =
                Path.of(System.getProperty("engines", folder.resolve("bin").toString()));
        for (Map.Entry<String, String> engine : new TreeMap<>(ENGINES).entrySet()) {
            Path program = engines.resolve(engine.getKey()).toAbsolutePath();
            List<String> asked = new ArrayList<>(List.of(program.toString()));
            for (String work : engine.getValue().split(" ", -1)) {
                if (works.stream().anyMatch(each -> each.startsWith(work) && !each.equals("W1c"))) {
                    asked.add(work);
                }
            }
            if (asked.size() > 1 && Files.isExecutable(program)) {
                ask(new ProcessBuilder(asked), folder, lines, aloud);
            }
        }
    }

    private static void ask(ProcessBuilder builder, Path folder, List<Line> lines, boolean aloud)
            throws IOException, InterruptedException {
        builder.environment().put("REPS", "1");
        Process process = builder.directory(folder.toFile())
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        try (BufferedReader reader =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                String[] words = line.split(" ", -1);
                lines.add(new Line(words[0], words[1], words[2], Double.parseDouble(words[3])));
                if (aloud) {
                    words[3] = String.format(Locale.ROOT, "%.1f", least(lines, words[0], words[1], words[2]));
                    System.out.println(String.join(" ", words));
                }
            }
        }
        process.waitFor();
    }

    private static void printRatios(List<Workload> ours, List<Line> lines) {
        for (Workload own : ours) {
            if (own.isPeer()) {
                continue;
            }
            double nanos = least(lines, own.peer(), own.work(), own.size());
            lines.stream()
                    .filter(line -> line.work.equals(own.work()) && line.size.equals(own.size()))
                    .map(Line::peer)
                    .filter(peer -> !peer.equals(own.peer()))
                    .distinct()
                    .forEach(peer -> Timing.print(
                            "ratio %s %s %.3f x %s",
                            own.work(), own.size(), nanos / least(lines, peer, own.work(), own.size()), peer));
        }
    }

    private static double least(List<Line> lines, String peer, String work, String size) {
        return lines.stream()
                .filter(line -> line.peer.equals(peer) && line.work.equals(work) && line.size.equals(size))
                .mapToDouble(Line::nanos)
                .min()
                .orElseThrow();
    }
}
