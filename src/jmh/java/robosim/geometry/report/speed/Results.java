package robosim.geometry.report.speed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.Predicate;

/** All figures of a run and what ran where, as one file of lines: the head behind number signs, then the figures. */
final class Results {
    /** A time: of several the least is kept, as what else runs on a machine only ever adds. */
    static final String NANOS = "ns";

    private final Map<String, String> head = new LinkedHashMap<>();
    private final Map<String, Measure> measures = new LinkedHashMap<>();

    /** Says what ran where. */
    void head(String key, String value) {
        head.put(key, value.replace('\n', ' '));
    }

    Map<String, String> head() {
        return head;
    }

    String head(String key) {
        return head.getOrDefault(key, "?");
    }

    void add(Measure measure) {
        measures.merge(
                measure.question() + "," + measure.metric(),
                measure,
                (old, now) -> old.metric().equals(NANOS) && old.value() < now.value() ? old : now);
    }

    /** Forgets a study, of which another run takes the place: times of two runs would be mixed else. */
    void forget(String study) {
        measures.values().removeIf(measure -> measure.study().equals(study));
    }

    /** The figures of a study, in their order. */
    List<Measure> of(String study) {
        return where(measure -> measure.study().equals(study));
    }

    List<Measure> where(Predicate<Measure> condition) {
        return measures.values().stream().filter(condition).toList();
    }

    /** One figure; empty where it was not measured. */
    OptionalDouble value(String study, Subject subject, String scene, String query, String metric) {
        Measure asked = new Measure(study, subject, scene, query, metric, 0);
        Measure measure = measures.get(asked.question() + "," + metric);
        return measure == null ? OptionalDouble.empty() : OptionalDouble.of(measure.value());
    }

    /** The different values of something in a study, in the order of their first appearance. */
    <T> List<T> distinct(String study, Function<Measure, T> what) {
        return of(study).stream().map(what).distinct().toList();
    }

    void write(Path file) throws IOException {
        StringBuilder out = new StringBuilder();
        head.forEach((key, value) -> out.append("# " + key + ": " + value + "\n"));
        out.append(Measure.HEAD);
        String question = "";
        for (Measure measure : measures.values()) {
            out.append(measure.question().equals(question) ? "" : "\n" + measure.question());
            out.append("," + measure.metric() + "," + measure.number());
            question = measure.question();
        }
        Files.writeString(file, out.append("\n"));
    }

    static Results read(Path file) throws IOException {
        Results results = new Results();
        for (String line : Files.readAllLines(file)) {
            int colon = line.indexOf(": ");
            if (line.startsWith("# ") && colon > 0) {
                results.head(line.substring(2, colon), line.substring(colon + 2));
            } else if (!line.isEmpty() && !line.equals(Measure.HEAD)) {
                Measure.of(line).forEach(results::add);
            }
        }
        return results;
    }
}
