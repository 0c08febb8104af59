package robosim.geometry.report.speed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import robosim.geometry.chart.Figure;

/** The pages of a run, from its figures alone. */
final class Report {
    /** What each part of the page needs to have been measured, in the order of the parts. */
    private static final Map<List<String>, BiConsumer<Results, Page>> SECTIONS = new LinkedHashMap<>();

    static {
        SECTIONS.put(List.of("robots"), RobotsSection::add);
        SECTIONS.put(List.of("sizes", "verdicts", "cones"), TradeSection::add);
        SECTIONS.put(List.of("verdicts"), VerdictsSection::add);
        SECTIONS.put(List.of("distances"), DistancesSection::add);
        SECTIONS.put(List.of("cones"), ConesSection::add);
        SECTIONS.put(List.of("moves"), MovesSection::add);
        SECTIONS.put(List.of("worlds"), WorldsSection::add);
        SECTIONS.put(List.of("sizes"), SizesSection::add);
        SECTIONS.put(List.of("sensors"), SensorsSection::add);
        SECTIONS.put(List.of("filter"), FilterSection::add);
    }

    private Report() {}

    static void write(Results results, Path folder) throws IOException {
        Page page = page(results);
        Files.writeString(folder.resolve("speed-against-error.md"), page.text());
        for (Figure figure : page.figures()) {
            Files.writeString(folder.resolve(figure.name() + ".svg"), figure.svg());
        }
    }

    static Page page(Results results) {
        Page page = new Page("");
        page.heading(1, "Speed against error");
        page.paragraph(
                "How fast this module answers, and how far from the truth: every level of accuracy, both dimensions,"
                        + " with exact verdicts and with its filters alone, beside JTS and dyn4j in the same run. Truth is worked out"
                        + " from the stored numbers in exact arithmetic that shares no code with the module. All that is compared took"
                        + " turns on one machine; only ratios within a run carry over to another.");
        head(results, page);
        SECTIONS.forEach((studies, section) -> {
            if (studies.stream().noneMatch(study -> results.of(study).isEmpty())) {
                section.accept(results, page);
            }
        });
        PeersSection.add(results, page);
        return page;
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
