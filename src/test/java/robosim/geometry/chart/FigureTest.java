package robosim.geometry.chart;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import robosim.geometry.chart.Series.Dot;
import robosim.geometry.chart.Series.Line;
import robosim.geometry.report.chart.Decades;
import robosim.geometry.report.chart.LogAxis;

class FigureTest {
    private static Figure figure(List<Series> series) {
        Panel panel = new Panel(
                "a < b & c",
                new LogAxis("time", 0, 3, false, Decades::nanos),
                new LogAxis("error", -3, 1, true, Decades::plain),
                series);
        return new Figure("plot", "Title \"quoted\" <here>", "Caption & more.", List.of(panel, panel), 2, 200);
    }

    private static List<Series> everyLook() {
        List<Series> series = new ArrayList<>();
        for (Marker marker : Marker.values()) {
            for (Line line : Line.values()) {
                List<Dot> dots = List.of(new Dot(1 + series.size(), 0.01, "p" + series.size()), new Dot(900, 0, ""));
                series.add(new Series(marker + " & " + line, series.size() % Style.COLOURS, marker, line, false, dots));
            }
        }
        return series;
    }

    private static Document parsed(String svg) throws Exception {
        return DocumentBuilderFactory.newDefaultInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8)));
    }

    @Test
    void everyLookIsWellFormedAndNeedsNothingElse() throws Exception {
        String svg = figure(everyLook()).svg();
        Element root = parsed(svg).getDocumentElement();
        assertThat(root.getTagName()).isEqualTo("svg");
        assertThat(root.getElementsByTagName("title").item(0).getTextContent()).isEqualTo("Title \"quoted\" <here>");
        assertThat(svg)
                .contains("prefers-color-scheme:dark")
                .doesNotContain("href")
                .doesNotContain("url(");
        assertThat(svg).doesNotContain("NaN").doesNotContain("Infinity");
    }

    @Test
    void whatAPlotSaysIsInIt() throws Exception {
        Series series = new Series("engine", 0, Marker.CIRCLE, Line.SOLID, false, List.of(new Dot(10, 0.1, "EXACT")));
        Series other = new Series("other", 1, Marker.SQUARE, Line.SOLID, false, List.of(new Dot(100, 0, "0 wrong")));
        NodeList texts = parsed(figure(List.of(series, other)).svg()).getElementsByTagName("text");
        List<String> words = new ArrayList<>();
        for (int k = 0; k < texts.getLength(); k++) {
            words.add(texts.item(k).getTextContent());
        }
        assertThat(words)
                .contains(
                        "engine",
                        "other",
                        "EXACT",
                        "0 wrong",
                        "time",
                        "error",
                        "a < b & c",
                        "Caption & more.",
                        "10 ns");
    }

    @Test
    void wordsBesidePointsNeverMeet() {
        Labels labels = new Labels(new Labels.Place(0, 0, 300, 200));
        List<Labels.Place> places = new ArrayList<>();
        int refused = 0;
        for (int k = 0; k < 60; k++) {
            Labels.Place place = labels.find(100 + 7 * (k % 9), 100 + 3 * (k % 5), 40, 13);
            if (place == null) {
                refused++;
            } else {
                places.add(place);
            }
        }
        assertThat(places).hasSizeGreaterThan(5);
        assertThat(refused).as("no room for all").isPositive();
        for (int k = 0; k < places.size(); k++) {
            for (int m = 0; m < k; m++) {
                assertThat(places.get(k).meets(places.get(m))).isFalse();
            }
        }
    }

    @Test
    void captionsAreWrapped() {
        List<String> lines = TextWidths.wrap("one two three four five six seven", 12, 90);
        assertThat(lines).hasSizeGreaterThan(2).allMatch(line -> TextWidths.width(line, 12) <= 90);
        assertThat(String.join(" ", lines)).isEqualTo("one two three four five six seven");
    }
}
