package robosim.geometry.report.speed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/** The smallest part of the report, from measuring to its pages. */
class ReportTest {
    @TempDir
    Path folder;

    private static Results measured(String... studies) throws IOException {
        Results results = new Results();
        Machine.describe(results, "tiny");
        for (String study : studies) {
            Study.of(study)
                    .run(
                            Form.of("tiny"),
                            (subject, scene, query, metric, value) ->
                                    results.add(new Measure(study, subject, scene, query, metric, value)),
                            share -> assertThat(share).isBetween(0.0, 1.0));
        }
        return results;
    }

    @Test
    void whatIsMeasuredComesToThePagesAndIsRight() throws IOException {
        Results results = measured("sizes", "verdicts", "distances");
        for (Dimension dimension : Dimension.values()) {
            Subject exact = Subject.exact(dimension);
            assertThat(results.value("sizes", exact, "100", "ray", "ns").orElseThrow())
                    .isPositive();
            assertThat(Resolution.worst(results, exact))
                    .as("EXACT is never wrong")
                    .hasValue(0);
            Subject sphere = WorldsSection.subject(Accuracy.SPHERE, dimension);
            assertThat(Resolution.worst(results, sphere).orElseThrow())
                    .as("a coarse level is")
                    .isPositive();
        }
        Report.write(results, folder);
        String page = Files.readString(folder.resolve("speed-against-error.md"));
        assertThat(page).contains("## Verdicts", "## Distances", "(sizes.svg)", "| seed | 20261121 |");
        assertThat(page).contains("EXACT, PLANAR", "JTS", "dyn4j");
        assertThat(Files.readString(folder.resolve("distances.svg"))).endsWith("</svg>\n");
    }

    @Test
    void figuresAreRenewedBetweenTheirMarksAndNowhereElse() {
        Results results = new Results();
        results.head("date", "today");
        results.head("jdk", "Temurin 17");
        String page = "before\n<!-- figures: machine -->\nold\n<!-- end -->\nafter\n";
        String renewed = Guide.renewed(page, results);
        assertThat(renewed).startsWith("before\n<!-- figures: machine -->\nMeasured on today,");
        assertThat(renewed).endsWith("<!-- end -->\nafter\n").doesNotContain("old");
        assertThat(Guide.renewed(renewed, results)).isEqualTo(renewed);
        assertThatThrownBy(() -> Guide.renewed("<!-- figures: machine -->\n", results))
                .hasMessageContaining("machine");
    }
}
