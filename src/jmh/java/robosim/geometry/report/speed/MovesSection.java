package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import robosim.geometry.chart.Figure;
import robosim.geometry.chart.Panel;
import robosim.geometry.chart.Series;
import robosim.geometry.chart.Series.Dot;
import robosim.geometry.chart.Series.Line;
import robosim.geometry.model.Dimension;
import robosim.geometry.report.chart.Decades;
import robosim.geometry.report.chart.LogAxis;
import robosim.geometry.report.chart.NinesAxis;
import robosim.geometry.report.speed.Moves.Family;

/** Early and late stops, what is left of the two in each other, and who goes through walls. */
final class MovesSection {
    private static final String STUDY = "moves";
    private static final double LEAST = 1e-17;

    private MovesSection() {}

    static void add(Results results, Page page) {
        page.heading(2, "Moves");
        List<Panel> panels = new ArrayList<>();
        panels.add(panel(results, "early", "stops early: safe"));
        panels.add(panel(results, "late", "stops late: not safe"));
        page.picture(new Figure(
                "moves",
                "A straight move towards an obstacle: how early or late it stops",
                "Discs and boxes about 1 wide that go up to 20 units towards discs and turned boxes in the plane. The time of"
                        + " contact is compared with the true one, which is found by halving in exact arithmetic, and told"
                        + " as a length of the way. This module's sets are closed and its times rounded down; dyn4j's"
                        + " ConservativeAdvancement declares a tolerance. The strip of 0: neither early nor late at all, or"
                        + " by less than 1e-17.",
                panels,
                2,
                260));
        table(results, page);
        walls(results, page);
    }

    private static List<Subject> subjects(Dimension dimension) {
        return dimension == Dimension.PLANAR
                ? List.of(Subject.exact(dimension), Subject.peer(Subject.DYN4J))
                : List.of(Subject.exact(dimension));
    }

    private static Panel panel(Results results, String what, String title) {
        List<Series> series = new ArrayList<>();
        for (Subject subject : subjects(Dimension.PLANAR)) {
            for (Family family : Family.values()) {
                List<Dot> dots = new ArrayList<>();
                for (double share : Ecdf.SHARES) {
                    results.value(STUDY, subject, family.text, "move", what + " q" + share)
                            .ifPresent(off -> dots.add(new Dot(
                                    off < LEAST ? 0 : off,
                                    share,
                                    share == 0.99 && !subject.isModule() ? family.text : "")));
                }
                if (!dots.isEmpty()) {
                    Look look = Look.of(subject);
                    String name = subject.isModule() ? "this module, EXACT" : subject.engine();
                    series.add(look.series(name, Line.SOLID, dots));
                }
            }
        }
        return new Panel(
                title,
                new LogAxis("off by, world units", -17, -2, true, Decades::power),
                new NinesAxis("moves off by no more", 3),
                series);
    }

    private static void table(Results results, Page page) {
        List<List<String>> rows = new ArrayList<>();
        for (Family family : Family.values()) {
            for (Subject subject : subjects(family.dimension)) {
                OptionalDouble asked = results.value(STUDY, subject, family.text, "move", "asked");
                if (asked.isPresent()) {
                    List<String> row =
                            new ArrayList<>(List.of(family.text, subject.text(), Words.count(asked.getAsDouble())));
                    for (String what : List.of(
                            "early q0.99",
                            "early q1.0",
                            "late q0.99",
                            "late q1.0",
                            "penetration q1.0",
                            "through",
                            "invented")) {
                        row.add(Words.size(results.value(STUDY, subject, family.text, "move", what)));
                    }
                    rows.add(row);
                }
            }
        }
        page.paragraph(
                "Early and late in world units, apart; penetration is what the two are in each other at the stored"
                        + " place where the mover ends, in exact arithmetic.");
        page.table(
                List.of(
                        "move",
                        "who",
                        "asked",
                        "early, 99 %",
                        "most",
                        "late, 99 %",
                        "most",
                        "penetration, most",
                        "contact not seen",
                        "contact invented"),
                rows);
    }

    private static void walls(Results results, Page page) {
        List<List<String>> rows = new ArrayList<>();
        for (Subject subject :
                List.of(Subject.exact(Dimension.PLANAR), Subject.peer(Subject.DYN4J), Subject.peer(Moves.SAMPLING))) {
            OptionalDouble asked = results.value(STUDY, subject, Moves.WALLS, "move", "asked");
            OptionalDouble through = results.value(STUDY, subject, Moves.WALLS, "move", "through");
            if (asked.isPresent() && through.isPresent()) {
                double n = through.getAsDouble();
                rows.add(List.of(
                        subject.text(),
                        Words.count(n) + " of " + Words.count(asked.getAsDouble()),
                        n == 0
                                ? "below " + Words.size(3 / asked.getAsDouble()) + " (3/N, 95 %)"
                                : Words.percent(n / asked.getAsDouble())));
            }
        }
        page.heading(3, "Through a wall");
        page.paragraph("Fast discs of radius 1e-4 to 0.3 go 12 to 125 units across walls of 0.1 down to 1e-12 and of no"
                + " thickness at all.");
        page.table(List.of("who", "went through", "rate"), rows);
    }
}
