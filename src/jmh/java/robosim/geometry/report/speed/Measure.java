package robosim.geometry.report.speed;

import java.util.List;

/**
 * One figure.
 *
 * @param study  which part of the report measured it
 * @param scene  what was asked about
 * @param query  what was asked
 * @param metric what the figure is, with its unit where it has one
 */
record Measure(String study, Subject subject, String scene, String query, String metric, double value) {
    static final String HEAD = "study,engine,level,dimension,filter,scene,query,metric,value";

    /** Refuses words that would not come back. */
    Measure {
        for (String word : List.of(study, subject.engine(), scene, query, metric)) {
            if (word.indexOf(',') >= 0 || word.indexOf('\n') >= 0) {
                throw new IllegalArgumentException("words of a figure must be without commas (got: " + word + ")");
            }
        }
    }

    String line() {
        String number = value == Math.rint(value) && Math.abs(value) < 1e15
                ? Long.toString((long) value)
                : Double.toString(value);
        return String.join(
                ",",
                study,
                subject.engine(),
                subject.level(),
                subject.dimension(),
                subject.filter(),
                scene,
                query,
                metric,
                number);
    }

    static Measure of(String line) {
        String[] parts = line.split(",", -1);
        if (parts.length != 9) {
            throw new IllegalArgumentException("a figure must have 9 parts (got: " + line + ")");
        }
        return new Measure(
                parts[0],
                new Subject(parts[1], parts[2], parts[3], parts[4]),
                parts[5],
                parts[6],
                parts[7],
                Double.parseDouble(parts[8]));
    }
}
