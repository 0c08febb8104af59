package robosim.geometry.report.speed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/**
 * The figures in pages that people write: what stands between a line {@code <!-- figures: NAME -->} and the next
 * {@code <!-- end -->} is written anew.
 */
final class Guide {
    /** Faster than this share of EXACT, and a level is worth a thought. */
    private static final double WORTH = 0.9;

    private Guide() {}

    /** Renews the guide's figures in its folder, and those of the README where the report is published. */
    static void write(Results results, Path folder, boolean isPublished) throws IOException {
        Path guide = Path.of("docs", "choosing-accuracy.md");
        if (Files.exists(guide)) {
            Files.writeString(folder.resolve("choosing-accuracy.md"), renewed(Files.readString(guide), results));
        }
        Path readme = Path.of("README.md");
        if (isPublished) {
            Files.writeString(readme, renewed(Files.readString(readme), results));
        }
    }

    static String renewed(String text, Results results) {
        StringBuilder out = new StringBuilder();
        String skipped = null;
        for (String line : text.split("\n", -1)) {
            if (skipped == null) {
                out.append(line).append('\n');
            }
            if (line.startsWith("<!-- figures: ")) {
                skipped = line.substring("<!-- figures: ".length(), line.indexOf(" -->"));
                out.append(figures(skipped, results)).append('\n');
            } else if (line.equals("<!-- end -->") && skipped != null) {
                skipped = null;
                out.append(line).append('\n');
            }
        }
        if (skipped != null) {
            throw new IllegalArgumentException("figures must have an end (got none: " + skipped + ")");
        }
        out.setLength(out.length() - 1);
        return out.toString();
    }

    private static String figures(String name, Results results) {
        Page page = new Page("report/");
        switch (name) {
            case "levels" -> levels(results, page);
            case "dimensions" -> dimensions(results, page);
            case "robots" -> RobotsSection.table(results, page);
            case "cones" -> ConesSection.addEqual(results, page);
            case "filter" ->
                page.paragraph("Exact over filter alone, the geometric mean over all worlds and questions: **"
                        + Words.ratio(FilterSection.mean(results)) + "**.");
            case "machine" -> page.paragraph(machine(results));
            case "summary" -> Summary.add(results, page);
            default -> throw new IllegalArgumentException("no figures of this name (got: " + name + ")");
        }
        return page.text().stripTrailing();
    }

    static String machine(Results results) {
        return "Measured on " + results.head("date") + ", " + results.head("machine") + ", JDK "
                + results.head("jdk").replaceFirst(".* ", "") + ", load " + results.head("load at the start")
                + " before the run, form " + results.head("form") + ".";
    }

    /** For each world and question: the coarsest level that pays, what it takes and what it adds. */
    private static void levels(Results results, Page page) {
        List<List<String>> rows = new ArrayList<>();
        for (String world : results.distinct(WorldsSection.STUDY, Measure::scene)) {
            for (Dimension dimension : List.of(Dimension.SPATIAL, Dimension.PLANAR)) {
                for (String query : WorldsSection.QUERIES) {
                    rows.add(level(results, world, dimension, query));
                }
            }
        }
        page.table(
                List.of(
                        "world",
                        "dimension",
                        "question",
                        "EXACT, ns",
                        "faster levels: time, error",
                        "no faster than EXACT"),
                rows);
    }

    private static List<String> level(Results results, String world, Dimension dimension, String query) {
        OptionalDouble exact =
                results.value(WorldsSection.STUDY, Subject.exact(dimension), world, query, Results.NANOS);
        List<String> faster = new ArrayList<>();
        List<String> slower = new ArrayList<>();
        for (Accuracy level : List.of(Accuracy.DOP, Accuracy.OBB, Accuracy.AABB, Accuracy.SPHERE)) {
            Subject subject = WorldsSection.subject(level, dimension);
            OptionalDouble nanos = results.value(WorldsSection.STUDY, subject, world, query, Results.NANOS);
            if (nanos.isEmpty() || exact.isEmpty()) {
                continue;
            }
            double ratio = nanos.getAsDouble() / exact.getAsDouble();
            if (ratio < WORTH) {
                faster.add(level + " " + Words.ratio(ratio) + error(results, subject, world, query));
            } else {
                slower.add(level.name());
            }
        }
        return List.of(
                world,
                dimension.name(),
                query,
                Words.nanos(exact),
                faster.isEmpty() ? "**none: take EXACT**" : String.join("; ", faster),
                String.join(", ", slower));
    }

    private static String error(Results results, Subject subject, String world, String query) {
        if (query.equals("move")) {
            return "";
        }
        if (query.equals("overlap")) {
            return ", adds "
                    + Words.percent(results.value(WorldsSection.STUDY, subject, world, query, "added share")
                            .orElse(0));
        }
        return ", short by "
                + Words.size(results.value(WorldsSection.STUDY, subject, world, query, "error q0.9")) + " / "
                + Words.size(WorldsSection.error(results, subject, world, query)) + " m";
    }

    /** What heights take, and what they tell. */
    private static void dimensions(Results results, Page page) {
        List<List<String>> rows = new ArrayList<>();
        for (String world : results.distinct(WorldsSection.STUDY, Measure::scene)) {
            List<String> row = new ArrayList<>(List.of(world));
            for (String query : WorldsSection.QUERIES) {
                OptionalDouble flat = results.value(
                        WorldsSection.STUDY, Subject.exact(Dimension.PLANAR), world, query, Results.NANOS);
                OptionalDouble space = results.value(
                        WorldsSection.STUDY, Subject.exact(Dimension.SPATIAL), world, query, Results.NANOS);
                row.add(
                        flat.isEmpty() || space.isEmpty()
                                ? Words.NONE
                                : Words.ratio(flat.getAsDouble() / space.getAsDouble()));
            }
            Subject planar = Subject.exact(Dimension.PLANAR);
            row.add(Words.percent(results.value(WorldsSection.STUDY, planar, world, "overlap", "of SPATIAL added share")
                    .orElse(0)));
            row.add(Words.size(results.value(WorldsSection.STUDY, planar, world, "ray", "of SPATIAL error q0.9"))
                    + " m");
            rows.add(row);
        }
        List<String> head = new ArrayList<>(List.of("world"));
        WorldsSection.QUERIES.forEach(query -> head.add(query + ", PLANAR over SPATIAL"));
        head.add("tests that collide in PLANAR only");
        head.add("1 ray in 10 is shorter by more than");
        page.table(head, rows);
    }
}
