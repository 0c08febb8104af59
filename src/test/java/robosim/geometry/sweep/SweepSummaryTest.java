package robosim.geometry.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.StringReader;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.xml.parsers.DocumentBuilderFactory;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

/** Means and deviations are those of decimals without an end; the plot has all of them. */
class SweepSummaryTest {
    private static Outcome outcome(long index, String step, double value) {
        return new Outcome(
                index, "rooms", Map.of("step", step), index, index, Map.of("nearest [m]", value, "made", 3.0), null);
    }

    @Test
    void againstDecimals() {
        SeededRandom random = new SeededRandom(4);
        SweepSummary summary = new SweepSummary();
        List<BigDecimal> values = new ArrayList<>();
        int none = 0;
        for (int k = 0; k < 500; k++) {
            double value = random.nextInt(10) == 0 ? Double.POSITIVE_INFINITY : 1e6 + random.nextGaussian();
            if (Double.isInfinite(value)) {
                none++;
            } else {
                values.add(new BigDecimal(value));
            }
            summary.accept(outcome(k, "1", value));
        }
        BigDecimal count = BigDecimal.valueOf(values.size());
        BigDecimal mean =
                values.stream().reduce(BigDecimal.ZERO, BigDecimal::add).divide(count, MathContext.DECIMAL128);
        BigDecimal squares =
                values.stream().map(value -> value.subtract(mean).pow(2)).reduce(BigDecimal.ZERO, BigDecimal::add);
        double deviation = squares.divide(count.subtract(BigDecimal.ONE), MathContext.DECIMAL128)
                .sqrt(MathContext.DECIMAL128)
                .doubleValue();
        SweepSummary.Spread spread = summary.spread("rooms", Map.of("step", "1"), "nearest [m]");
        assertThat(summary.spread("rooms", Map.of("step", "9"), "nearest [m]")).isNull();
        assertThat(summary.spread("rooms", Map.of("step", "1"), "farthest [m]")).isNull();
        assertThat(spread).isNotNull();
        assertThat(spread.mean()).isCloseTo(mean.doubleValue(), Offset.offset(1e-8));
        assertThat(spread.deviation()).isCloseTo(deviation, Offset.offset(1e-8));
        assertThat(spread.margin()).isCloseTo(1.96 * deviation / Math.sqrt(values.size()), Offset.offset(1e-8));
        assertThat(spread.none()).isEqualTo(none).isBetween(25L, 80L);
        assertThat(spread.count()).isEqualTo(values.size());
    }

    @Test
    void aPointForEachCellAndNumber() throws Exception {
        SweepSummary summary = new SweepSummary();
        int index = 0;
        for (String step : new String[] {"2", "0.5", "1"}) {
            for (double value : new double[] {1, 2, 4}) {
                summary.accept(outcome(index++, step, value));
            }
        }
        SweepHeader header = new SweepHeader("s<1>", "", 0, 3, Map.of("rooms", "0"), Map.of("step", "2,0.5,1"));
        String svg = SweepPlot.svg(header, summary);
        Document document =
                DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new InputSource(new StringReader(svg)));
        NodeList paths = document.getElementsByTagName("path");
        assertThat(paths.getLength())
                .as("a frame, a line, and a marker and a bar at each of 3 places")
                .isEqualTo(8);
        assertThat(svg)
                .contains(">nearest [m]<", ">step<", "s&lt;1&gt;, 3 replicates each", "made: 3 in every replicate")
                .doesNotContain("NaN", "Infinity");
        assertThat(SweepPlot.svg(header, summary)).isEqualTo(svg);
    }
}
