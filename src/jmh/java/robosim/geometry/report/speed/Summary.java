package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/** The few figures that a reader of the README sees. */
final class Summary {
    private Summary() {}

    static void add(Results results, Page page) {
        String scene = TradeSection.scene(results);
        List<Subject> subjects = new ArrayList<>();
        for (Dimension dimension : List.of(Dimension.PLANAR, Dimension.SPATIAL)) {
            for (Accuracy level : List.of(Accuracy.EXACT, Accuracy.AABB)) {
                subjects.add(WorldsSection.subject(level, dimension));
            }
        }
        subjects.add(Subject.peer(Subject.JTS));
        subjects.add(Subject.peer(Subject.DYN4J));
        List<List<String>> rows = new ArrayList<>();
        for (Subject subject : subjects) {
            OptionalDouble gap = Resolution.worst(results, subject);
            List<String> row = new ArrayList<>(List.of(subject.text()));
            row.add(Words.nanos(results.value("sizes", subject, scene, "overlap", Results.NANOS)));
            row.add(Words.nanos(results.value("sizes", subject, scene, "ray", Results.NANOS)));
            row.add(Words.nanos(results.value("sizes", subject, scene, "cone", Results.NANOS)));
            row.add(Words.size(gap));
            rows.add(row);
        }
        page.table(
                List.of(
                        Words.count(Double.parseDouble(scene)) + " objects",
                        "overlap, ns",
                        "ray, ns",
                        "cone of 15\u00b0, ns",
                        "widest misclassified gap"),
                rows);
        page.paragraph(
                "One thread, through the public API; the gap is the widest between two objects about 1 wide about which"
                        + " more than 5 % of the verdicts are wrong, in world units. " + Guide.machine(results));
    }
}
