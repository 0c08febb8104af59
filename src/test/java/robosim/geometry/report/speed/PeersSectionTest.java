package robosim.geometry.report.speed;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.chart.Panel;
import robosim.geometry.chart.Series;

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
        Page page = new Page("");
        PeersSection.add(results, page);
        assertThat(page.figures()).hasSize(1);
        for (Panel panel : page.figures().get(0).panels()) {
            assertThat(panel.series()).hasSizeBetween(5, 6);
            assertThat(panel.series()).extracting(Series::colour).doesNotHaveDuplicates();
            assertThat(panel.series()).extracting(Series::marker).doesNotHaveDuplicates();
        }
    }

    @Test
    void theTableTellsHowFarTheJvmsDifferAndWhatANeighbourCosts() {
        Results results = new Results();
        Subject engine = new Subject("engine", "", "", "");
        for (String metric : new String[] {Results.NANOS, "least", "most", "beside"}) {
            double value = switch (metric) {
                case "least" -> 71;
                case "most" -> 93;
                case "beside" -> 207;
                default -> 82;
            };
            results.add(new Measure(PeerLines.STUDY, engine, "100", "W5", metric, value));
        }
        Page page = new Page("");
        PeersSection.add(results, page);
        assertThat(page.text()).contains("| 82 | – | 71 to 93 | 207 |");
    }

    @Test
    void whatBuildingAndMemoryCostIsInATable() {
        Results results = new Results();
        Subject engine = new Subject("engine", "", "", "");
        results.add(new Measure(PeerLines.STUDY, engine, "1000", "W5", PeerLines.BUILD, 18.04));
        results.add(new Measure(PeerLines.STUDY, engine, "1000", "W5", PeerLines.BYTES, 303.8));
        Page page = new Page("");
        PeersSection.add(results, page);
        assertThat(page.text()).contains("| ray among solids in space | 1,000 | engine | 18 | 304 |");
    }

    private static Measure measure(String engine, String work) {
        return new Measure(PeerLines.STUDY, new Subject(engine, "", "", ""), "100", work, Results.NANOS, 5);
    }
}
