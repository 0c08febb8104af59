package robosim.geometry.report.speed;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.report.chart.Panel;
import robosim.geometry.report.chart.Series;

class PeersSectionTest {
    @Test
    void enginesOfOnePictureDifferInColourAndMarker() {
        Results results = new Results();
        results.add(measure("flat-0", "W1a"));
        for (int other = 0; other < 7; other++) {
            results.add(measure("mesh-" + other, "W2")); // in the table alone
        }
        for (int flat = 1; flat < 6; flat++) {
            results.add(measure("flat-" + flat, "W1b"));
            results.add(measure("flat-" + flat, "W1a"));
        }
        Page page = new Page();
        PeersSection.add(results, page);
        assertThat(page.figures()).hasSize(1);
        for (Panel panel : page.figures().get(0).panels()) {
            assertThat(panel.series()).hasSizeBetween(5, 6);
            assertThat(panel.series()).extracting(Series::colour).doesNotHaveDuplicates();
            assertThat(panel.series()).extracting(Series::marker).doesNotHaveDuplicates();
        }
    }

    private static Measure measure(String engine, String work) {
        return new Measure(PeerLines.STUDY, new Subject(engine, "", "", ""), "100", work, Results.NANOS, 5);
    }
}
