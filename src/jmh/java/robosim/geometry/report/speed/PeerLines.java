package robosim.geometry.report.speed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What native engines and this module printed when they were measured on shared inputs. */
final class PeerLines {
    static final String STUDY = "peers";

    /** The least and the most of the medians of each JVM, and the median beside a neighbour that sweeps through memory. */
    static final List<String> SPREAD = List.of("least", "most", "beside");

    /** Memory of what answers, in bytes for each object of a scene. */
    static final String BYTES = "bytes";

    static final String BUILD = "build ms";

    private static final String NUMBER = "[0-9.eE+]+";
    private static final Pattern MEMORY = Pattern.compile("(\\S+) (W\\S+) ([0-9]+) ([0-9.]+) bytes a part,.*");

    private static final String MEGABYTES = "mem_mb=";

    private PeerLines() {}

    /**
     * Figures of lines {@code peer workload size ns hits checksum build_ms}, parted by spaces or commas and perhaps with
     * {@code least=..}, {@code most=..}, {@code beside=..}, {@code mem_mb=..} and more behind them, and of lines {@code peer
     * workload size n bytes a part}; other lines, such as a head or ratios, are passed over.
     *
     * @throws IOException where no line is one
     */
    static List<Measure> read(Path file) throws IOException {
        List<Measure> measures = new ArrayList<>();
        for (String line : Files.readAllLines(file)) {
            Matcher memory = MEMORY.matcher(line);
            if (memory.matches()) {
                Subject subject = new Subject(memory.group(1), "", "", "");
                double bytes = Double.parseDouble(memory.group(4));
                measures.add(new Measure(STUDY, subject, memory.group(3), memory.group(2), BYTES, bytes));
            }
            String[] parts = line.strip().split("[\\s,]+");
            boolean isFigure = parts.length >= 7
                    && parts[1].startsWith("W")
                    && parts[3].matches(NUMBER)
                    && parts[4].matches(NUMBER)
                    && parts[6].matches(NUMBER);
            if (isFigure) {
                Subject subject = new Subject(parts[0], "", "", "");
                measures.add(measure(subject, parts, Results.NANOS, 3));
                measures.add(measure(subject, parts, "hits", 4));
                measures.add(measure(subject, parts, BUILD, 6));
                for (String part : parts) {
                    for (String metric : SPREAD) {
                        if (part.startsWith(metric + "=")) {
                            double value = Double.parseDouble(part.substring(metric.length() + 1));
                            measures.add(new Measure(STUDY, subject, parts[2], parts[1], metric, value));
                        }
                    }
                    if (part.startsWith(MEGABYTES) && parts[2].matches("[0-9]+")) {
                        double value = 1e6 * Double.parseDouble(part.substring(MEGABYTES.length()));
                        double objects = Double.parseDouble(parts[2]);
                        measures.add(new Measure(STUDY, subject, parts[2], parts[1], BYTES, value / objects));
                    }
                }
            }
        }
        if (measures.isEmpty()) {
            throw new IOException(
                    "lines must be: peer workload size ns hits checksum build_ms (got none in: " + file + ")");
        }
        return measures;
    }

    private static Measure measure(Subject subject, String[] parts, String metric, int at) {
        return new Measure(STUDY, subject, parts[2], parts[1], metric, Double.parseDouble(parts[at]));
    }
}
