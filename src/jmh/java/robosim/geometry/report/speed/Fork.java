package robosim.geometry.report.speed;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dyn4j.world.World;
import org.locationtech.jts.index.strtree.STRtree;
import robosim.geometry.Geometry;
import robosim.geometry.bench.ClassPath;
import robosim.geometry.exact.FilterBound;

/** Runs a study in a JVM of its own. */
public final class Fork {
    private Fork() {}

    private static final String PROGRESS = "@";

    /** Options of every JVM that measures: one collector that no core of its own is needed for. */
    static final List<String> OPTIONS = List.of("-Xmx5g", "-XX:+UseSerialGC");

    /**
     * Runs a study with filters {@code on} or {@code alone}.
     *
     * @throws IOException with all that it said, where it failed
     */
    static void run(String study, String form, String filter, Results into, Study.Progress progress)
            throws IOException {
        List<String> command = new ArrayList<>(
                List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp", classPath()));
        command.addAll(OPTIONS);
        command.add("-D" + FilterBound.PROPERTY + "=" + filter);
        command.add("-Dpeers=" + System.getProperty("peers", ""));
        command.addAll(List.of(Fork.class.getName(), study, form));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        StringBuilder said = new StringBuilder();
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                if (line.startsWith(PROGRESS)) {
                    progress.at(Double.parseDouble(line.substring(1)));
                } else if (line.startsWith(study + ",")) {
                    Measure.of(line).forEach(into::add);
                } else {
                    said.append(line).append('\n');
                }
            }
        } finally {
            process.destroy();
        }
        try {
            if (process.waitFor() != 0) {
                throw new IOException(study + " must end well (said: " + said + ")");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException(study + " was interrupted", e);
        }
    }

    /**
     * Runs a study in this JVM and prints its figures as lines, and how far it is behind at signs.
     *
     * @param args the study's name and the form's
     */
    public static void main(String[] args) throws IOException {
        Study.of(args[0])
                .run(
                        Form.of(args[1]),
                        (subject, scene, query, metric, value) -> {
                            Measure measure = new Measure(args[0], subject, scene, query, metric, value);
                            System.out.println(measure.question() + "," + metric + "," + measure.number());
                        },
                        share -> System.out.println(PROGRESS + share));
    }

    static String classPath() {
        return ClassPath.of(Fork.class, Geometry.class, STRtree.class, World.class);
    }
}
