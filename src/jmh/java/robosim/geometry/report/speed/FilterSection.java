package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/** What exact verdicts take beside filters that are believed. */
final class FilterSection {
    private static final String STUDY = "filter";
    private static final List<String> QUERIES = List.of("ray", "cone", "overlap", "move");

    private FilterSection() {}

    static void add(Results results, Page page) {
        page.heading(2, "Filter alone and exact");
        page.paragraph(
                "The time with filters and exact paths over the time of the same code that believes the sign of its"
                        + " filters: JVMs of both sorts took turns, the least time of each counts. What it buys is in the verdicts"
                        + " above. Differences of a few per cent are within what a busy machine adds; `bench.Exactness` measures"
                        + " this one figure with an interval.");
        List<List<String>> rows = new ArrayList<>();
        for (String scene : results.distinct(STUDY, Measure::scene)) {
            for (Dimension dimension : List.of(Dimension.SPATIAL, Dimension.PLANAR)) {
                List<String> row = new ArrayList<>(List.of(scene, dimension.name()));
                for (String query : QUERIES) {
                    row.add(Words.ratio(ratio(results, scene, dimension, query)));
                }
                rows.add(row);
            }
        }
        page.table(List.of("scene", "dimension", "ray", "cone", "overlap", "move"), rows);
        page.paragraph("All together, as a geometric mean: **" + Words.ratio(mean(results)) + "**.");
    }

    /** Exact over filter alone. */
    static OptionalDouble ratio(Results results, String scene, Dimension dimension, String query) {
        Subject alone = new Subject(Subject.MODULE, Accuracy.EXACT.name(), dimension.name(), "alone");
        OptionalDouble on = results.value(STUDY, Subject.exact(dimension), scene, query, Results.NANOS);
        OptionalDouble off = results.value(STUDY, alone, scene, query, Results.NANOS);
        return on.isPresent() && off.isPresent()
                ? OptionalDouble.of(on.getAsDouble() / off.getAsDouble())
                : OptionalDouble.empty();
    }

    static OptionalDouble mean(Results results) {
        double sum = 0;
        int count = 0;
        for (String scene : results.distinct(STUDY, Measure::scene)) {
            for (Dimension dimension : Dimension.values()) {
                for (String query : QUERIES) {
                    OptionalDouble ratio = ratio(results, scene, dimension, query);
                    if (ratio.isPresent()) {
                        sum += Math.log(ratio.getAsDouble());
                        count++;
                    }
                }
            }
        }
        return count == 0 ? OptionalDouble.empty() : OptionalDouble.of(Math.exp(sum / count));
    }
}
