package robosim.geometry.report.speed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.chart.Figure;

/** The pages of a run, from its figures alone. */
final class Report {
    private Report() {}

    static void write(Results results, Path folder) throws IOException {
        Page page = page(results);
        Files.writeString(folder.resolve("speed-against-error.md"), Markdown.write(page, ""));
        Files.writeString(folder.resolve("speed-against-error.html"), Html.write(page));
        for (Figure figure : page.figures()) {
            Files.writeString(folder.resolve(figure.name() + ".svg"), figure.svg());
        }
    }

    static Page page(Results results) {
        Page page = new Page();
        page.heading(1, "Speed against error");
        page.paragraph(
                "How fast this module answers, and how far from the truth: every level of accuracy, both dimensions,"
                        + " with exact verdicts and with its filters alone, beside JTS and dyn4j in the same run. Truth is worked out"
                        + " from the stored numbers in exact arithmetic that shares no code with the module. All that is compared took"
                        + " turns on one machine; only ratios within a run carry over to another.");
        head(results, page);
        if (has(results, "robots")) {
            RobotsSection.add(results, page);
        }
        if (has(results, "sizes") && has(results, "verdicts") && has(results, "cones")) {
            TradeSection.add(results, page);
        }
        if (has(results, "verdicts")) {
            VerdictsSection.add(results, page);
        }
        if (has(results, "distances")) {
            DistancesSection.add(results, page);
        }
        if (has(results, "cones")) {
            ConesSection.add(results, page);
        }
        if (has(results, "moves")) {
            MovesSection.add(results, page);
        }
        if (has(results, "worlds")) {
            WorldsSection.add(results, page);
        }
        if (has(results, "sizes")) {
            SizesSection.add(results, page);
        }
        if (has(results, "latency")) {
            LatencySection.add(results, page);
        }
        if (has(results, "sensors")) {
            SensorsSection.add(results, page);
        }
        if (has(results, "filter")) {
            FilterSection.add(results, page);
        }
        PeersSection.add(results, page);
        return page;
    }

    private static boolean has(Results results, String study) {
        return !results.of(study).isEmpty();
    }

    private static void head(Results results, Page page) {
        page.code(results.head("command"));
        List<List<String>> rows = new ArrayList<>();
        results.head().forEach((key, value) -> {
            if (!key.equals("command")) {
                rows.add(List.of(key, value));
            }
        });
        page.table(List.of("measured", "on"), rows);
        page.paragraph(
                "Every figure is a line of `speed-against-error.csv`, and this page is written from that file alone.");
    }
}
