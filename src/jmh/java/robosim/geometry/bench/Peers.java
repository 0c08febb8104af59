package robosim.geometry.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.dyn4j.world.World;
import org.jspecify.annotations.Nullable;
import org.locationtech.jts.index.strtree.STRtree;
import org.openjdk.jmh.annotations.State;
import robosim.geometry.Geometry;

/**
 * The module on the inputs of native engines, and these engines beside it in the same run. One JVM differs from the next, so
 * there are several, one after the other; in each the module and the engines take turns, first alone and then beside a
 * {@link Neighbour} that leaves them nothing of the cache. Of each measure a line is printed, {@code peer workload size ns
 * hits checksum build_ms least=.. most=.. beside=..}: the median over the JVMs of each one's median, the least and the most
 * of these, and the same median beside the neighbour. Then the ratios, each of the two medians in one JVM, as median, least
 * and most; then the bytes of each structure, and an estimate of the {@link CacheLines} that a query waits for.
 *
 * <p>W1a is a ray among flat objects, W1b a disc tested among them, W1c their checked additions one after the other, W2 a
 * pair of meshes of 4,000 triangles each, W3 a ray at a mesh, W4 an attempted move of one of a swarm, W5 a ray among solids at
 * any attitude in space, W6 the rays of four camera frames among them. Hits and checksums must be those of the inputs' own
 * notes, or the run fails.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.bench.Peers
 * -Dpeers=FOLDER}, where the folder holds the inputs in {@code data} and, where there are any, the engines in
 * {@code bin} or in the folder of {@code -Dengines}. {@code -Dwork=W1a,W4} and {@code -Dsizes=100,10000} take a part,
 * {@code -Dforks=5} and {@code -Drounds=3} are how many JVMs and how many turns in each, {@code -Dneighbour=false} leaves the
 * neighbour out, and {@code -Dmodule=FILE.jar} measures another build of the module with the same programs, in JVMs that take
 * turns with this one's.
 */
public final class Peers {
    /** Which engine answers which workload; each is asked for all sizes at once. */
    private static final Map<String, String> ENGINES =
            Map.of("embree", "W1 W3 W5", "fcl", "W2", "parry", "W1 W2 W3 W5");

    private static final String OTHER = "robosim-other";

    private final Path folder = Path.of(System.getProperty("peers", "."));
    private final List<String> works =
            List.of(System.getProperty("work", "W1a,W1b,W1c,W2,W3,W4,W5,W6").split(",", -1));
    private final int rounds = Integer.getInteger("rounds", 3);
    private final boolean hasNeighbour =
            !System.getProperty("neighbour", "true").equals("false");
    private final @Nullable String module = System.getProperty("module");
    private final PeerTable table = new PeerTable();

    private Peers() {}

    /** Measures what the properties ask for. */
    public static void main(String[] args) throws IOException, InterruptedException {
        int forks = Integer.getInteger("forks", 5);
        if (forks < 1) {
            throw new IllegalArgumentException("forks must be at least 1 (got: " + forks + ")");
        }
        Peers peers = new Peers();
        for (int fork = 0; fork < forks; fork++) {
            peers.fork(fork, forks);
        }
        peers.table.lines().forEach(System.out::println);
    }

    /** One JVM of the module, or of each of its two builds, and the engines in turn with it. */
    private void fork(int fork, int forks) throws IOException, InterruptedException {
        List<Path> jars = new ArrayList<>();
        jars.add(Path.of(""));
        if (module != null) {
            jars.add(fork % 2, Path.of(module)); // who comes first takes turns too
        }
        boolean enginesAsked = false;
        for (Path jar : jars) {
            boolean isOther = !jar.toString().isEmpty();
            try (PeersChild child = new PeersChild(classPath(jar))) {
                for (boolean beside : hasNeighbour ? new boolean[] {false, true} : new boolean[] {false}) {
                    for (int round = 0; round < rounds; round++) {
                        System.err.printf(
                                Locale.ROOT,
                                "JVM %d of %d%s, turn %d of %d%s%n",
                                fork + 1,
                                forks,
                                isOther ? " of the other build" : "",
                                round + 1,
                                rounds,
                                beside ? " beside the neighbour" : "");
                        try (Neighbour neighbour = beside ? new Neighbour() : null) {
                            for (String line : child.ask("turn")) {
                                table.add(isOther ? line.replace(Workload.MODULE, OTHER) : line, fork, beside);
                            }
                            if (!enginesAsked) {
                                askEngines(fork, beside);
                            }
                        }
                    }
                }
                if (fork == forks - 1) {
                    for (String line : child.ask("facts")) {
                        table.addFact(isOther ? line.replace(Workload.MODULE, OTHER) : line);
                    }
                }
            }
            enginesAsked = true;
        }
    }

    private static String classPath(Path jar) {
        String all = ClassPath.of(Peers.class, Geometry.class, STRtree.class, World.class, State.class, Nullable.class);
        return jar.toString().isEmpty() ? all : jar + java.io.File.pathSeparator + all;
    }

    private void askEngines(int fork, boolean beside) throws IOException, InterruptedException {
        Path engines =
                Path.of(System.getProperty("engines", folder.resolve("bin").toString()));
        for (Map.Entry<String, String> engine : new TreeMap<>(ENGINES).entrySet()) {
            Path program = engines.resolve(engine.getKey()).toAbsolutePath();
            List<String> asked = new ArrayList<>(List.of(program.toString()));
            for (String work : engine.getValue().split(" ", -1)) {
                boolean isWanted = works.stream()
                        .map(each -> each.equals("W6") ? "W5" : each)
                        .anyMatch(each -> each.startsWith(work) && !each.equals("W1c"));
                if (isWanted) {
                    asked.add(work);
                }
            }
            if (asked.size() > 1 && Files.isExecutable(program)) {
                ProcessBuilder builder = new ProcessBuilder(asked);
                builder.environment().put("REPS", "1");
                builder.directory(folder.toFile()).redirectError(ProcessBuilder.Redirect.DISCARD);
                Process process = builder.start();
                try (var reader = process.inputReader()) {
                    for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                        table.add(line, fork, beside);
                    }
                }
                process.waitFor();
            }
        }
    }
}
