package robosim.geometry.report.speed;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
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
    /** Two more than a page shows. */
    private static final MathContext DIGITS = new MathContext(9);

    static final String HEAD = "study,engine,level,dimension,filter,scene,query,metric,value,metric,value...";

    /** Refuses words that would not come back. */
    Measure {
        for (String word : List.of(study, subject.engine(), scene, query, metric)) {
            if (word.indexOf(',') >= 0 || word.indexOf('\n') >= 0) {
                throw new IllegalArgumentException("words of a figure must be without commas (got: " + word + ")");
            }
        }
    }

    /** What was measured: all that several figures of one question share. */
    String question() {
        return String.join(
                ",", study, subject.engine(), subject.level(), subject.dimension(), subject.filter(), scene, query);
    }

    /** The value as it is written. */
    String number() {
        return value == Math.rint(value) && Math.abs(value) < 1e15
                ? Long.toString((long) value)
                : Double.toString(Double.isFinite(value) ? new BigDecimal(value, DIGITS).doubleValue() : value);
    }

    /** The figures of a line: one question, and a value for each of its metrics. */
    static List<Measure> of(String line) {
        String[] parts = line.split(",", -1);
        if (parts.length < 9 || parts.length % 2 == 0) {
            throw new IllegalArgumentException("a line must have 7 parts and pairs behind (got: " + line + ")");
        }
        List<Measure> measures = new ArrayList<>();
        Subject subject = new Subject(parts[1], parts[2], parts[3], parts[4]);
        for (int k = 7; k < parts.length; k += 2) {
            measures.add(
                    new Measure(parts[0], subject, parts[5], parts[6], parts[k], Double.parseDouble(parts[k + 1])));
        }
        return measures;
    }
}
