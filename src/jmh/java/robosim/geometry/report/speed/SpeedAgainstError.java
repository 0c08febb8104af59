package robosim.geometry.report.speed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;

/**
 * Measures speed against error, of this module at every level, dimension and with filters alone, beside JTS and dyn4j, and
 * writes a report: {@code speed-against-error.csv}, and from that alone {@code .md} and a picture in SVG for each
 * plot, into {@code target/report}.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test
 * -Dexec.mainClass=robosim.geometry.report.speed.SpeedAgainstError}
 *
 * <ul>
 *   <li>{@code -Dquick}: seconds, with few cases, to see that it works.
 *   <li>{@code -Dpeers.csv=FILE}: figures of native engines, lines as {@code bench.Peers} prints them.
 *   <li>{@code -Dpeers=FOLDER}: asks Embree in its {@code bin} about the frames of sensors, too.
 *   <li>{@code -Dpublish}: writes to {@code docs/report}, and renews the figures in the guide and in the README.
 *   <li>{@code -Dreport=FOLDER}: writes elsewhere.
 *   <li>{@code -Dcsv=FILE}: measures nothing and writes the pages of an earlier run; with {@code -Dagain=robots}, some
 *       studies are measured again and take the place of the earlier ones.
 *   <li>{@code -Dstudies=robots,cones}: measures some parts only.
 * </ul>
 */
public final class SpeedAgainstError {
    /** A study with filters on or alone, and about how much of the time it takes. */
    private record Part(String study, String filter, double weight) {}

    private SpeedAgainstError() {}

    /** Measures and writes. */
    public static void main(String[] args) throws IOException {
        boolean isPublished = System.getProperty("publish") != null;
        Path folder = Path.of(System.getProperty("report", isPublished ? "docs/report" : "target/report"));
        if (isPublished && !System.getProperty("studies", "").isEmpty()) {
            throw new IllegalArgumentException(
                    "only a whole run is published (got: " + System.getProperty("studies") + ")");
        }
        String earlier = System.getProperty("csv", "");
        Results results = new Results();
        if (earlier.isEmpty()) {
            measure(results, System.getProperty("studies", ""));
        } else {
            results = Results.read(Path.of(earlier));
            String again = System.getProperty("again", "");
            if (!again.isEmpty()) {
                for (String study : again.split(",", -1)) {
                    results.forget(study);
                    results.head(study, "measured anew at " + Instant.now().truncatedTo(ChronoUnit.MINUTES));
                }
                measure(results, again);
            }
        }
        String peers = System.getProperty("peers.csv", "");
        if (!peers.isEmpty()) {
            List<Measure> lines = PeerLines.read(Path.of(peers));
            results.forget(PeerLines.STUDY); // of an earlier run
            lines.forEach(results::add);
            results.head("native engines", "figures of " + Path.of(peers).getFileName());
        }
        Files.createDirectories(folder);
        results.write(folder.resolve("speed-against-error.csv"));
        Report.write(results, folder);
        System.out.println(folder.resolve("speed-against-error.md"));
        Guide.write(results, isPublished ? Path.of("docs") : folder, isPublished);
    }

    private static void measure(Results results, String studies) throws IOException {
        String form = System.getProperty("quick") == null ? "full" : "quick";
        List<String> wanted = List.of(studies.split(",", -1));
        List<Part> parts = parts(Form.of(form).forks()).stream()
                .filter(part -> wanted.contains("") || wanted.contains(part.study))
                .toList();
        if (results.head().isEmpty()) {
            Machine.describe(results, form);
        }
        double whole = parts.stream().mapToDouble(Part::weight).sum();
        Bar bar = new Bar(System.out, Bar.isTerminal(), whole);
        for (Part part : parts) {
            String name = part.study + (part.filter.equals("on") ? "" : ", filter " + part.filter);
            bar.show(name, part.weight, 0);
            Fork.run(part.study, form, part.filter, results, share -> bar.show(name, part.weight, share));
            bar.finish(name, part.weight);
        }
        bar.end();
    }

    /** What is compared stands beside each other in time too. */
    private static List<Part> parts(int forks) {
        List<Part> parts = new ArrayList<>(List.of(
                new Part("sizes", "on", 90),
                new Part("worlds", "on", 90),
                new Part("cones", "on", 50),
                new Part("robots", "on", 40),
                new Part("sensors", "on", 90)));
        for (int fork = 0; fork < forks; fork++) {
            // Now one goes first, now the other.
            parts.add(new Part("filter", fork % 2 == 0 ? "on" : "alone", 20));
            parts.add(new Part("filter", fork % 2 == 0 ? "alone" : "on", 20));
        }
        parts.addAll(List.of(
                new Part("verdicts", "on", 60),
                new Part("verdicts", "alone", 60),
                new Part("distances", "on", 30),
                new Part("distances", "alone", 30),
                new Part("moves", "on", 90)));
        return parts;
    }
}
