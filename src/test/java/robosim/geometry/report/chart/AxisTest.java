package robosim.geometry.report.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.chart.Axis;

class AxisTest {
    private static List<String> labels(Axis axis) {
        return axis.ticks().stream()
                .map(Axis.Tick::label)
                .filter(label -> !label.isEmpty())
                .toList();
    }

    @Test
    void powersOfTenAreWrittenAsPeopleDo() {
        assertThat(List.of(Decades.plain(-2), Decades.plain(0), Decades.plain(3), Decades.plain(-16)))
                .containsExactly("0.01", "1", "1,000", "10\u207b\u00b9\u2076");
        assertThat(List.of(Decades.nanos(0), Decades.nanos(2), Decades.nanos(3), Decades.nanos(5), Decades.nanos(7)))
                .containsExactly("1 ns", "100 ns", "1 \u00b5s", "100 \u00b5s", "10 ms");
        assertThat(Decades.nanos(-1)).isEqualTo("10\u207b\u00b9 ns");
    }

    @Test
    void decadesOfPowersOfTenAreTheirOwn() {
        for (int exponent = -30; exponent <= 30; exponent++) {
            double power = Double.parseDouble("1e" + exponent);
            assertThat(Decades.floor(power)).isEqualTo(exponent);
            assertThat(Decades.ceil(power)).isEqualTo(exponent);
            assertThat(Decades.floor(Math.nextDown(power))).isEqualTo(exponent - 1);
            assertThat(Decades.ceil(Math.nextUp(power))).isEqualTo(exponent + 1);
        }
    }

    @Test
    void aLogarithmicAxisHasItsMarksAtPowersOfTen() {
        LogAxis axis = LogAxis.around("t", new double[] {30, 4000}, Decades::plain);
        assertThat(labels(axis)).containsExactly("10", "100", "1,000", "10,000");
        assertThat(axis.at(10)).isZero();
        assertThat(axis.at(10_000)).isEqualTo(1);
        assertThat(axis.at(316.2278)).isCloseTo(0.5, within(1e-6));
        assertThat(axis.at(1e9)).as("beyond the end").isEqualTo(1);
    }

    @Test
    void zerosHaveAStripOfTheirOwnBelowAllOthers() {
        LogAxis axis = LogAxis.around("e", new double[] {0, 1e-9, 1}, Decades::plain);
        assertThat(axis.ticks().get(0).label()).isEqualTo("0");
        assertThat(axis.at(0)).isLessThan(axis.breaks().get(0));
        assertThat(axis.at(1e-9)).isEqualTo(axis.breaks().get(0));
        assertThat(LogAxis.around("e", new double[] {0}, Decades::plain).ticks())
                .isNotEmpty();
    }

    @Test
    void manyDecadesAreNotAllWritten() {
        assertThat(labels(new LogAxis("e", -17, 2, false, Decades::plain))).hasSizeBetween(4, 10);
        assertThatThrownBy(() -> new LogAxis("e", 3, 3, false, Decades::plain)).hasMessageContaining("3 to 3");
    }

    @Test
    void signsGoToBothSidesOfAColumnForZero() {
        SignedLogAxis axis = new SignedLogAxis("gap", -16, 0);
        assertThat(axis.at(0)).isEqualTo(0.5);
        assertThat(axis.at(-1)).isZero();
        assertThat(axis.at(1)).isEqualTo(1);
        assertThat(axis.at(1e-16)).isGreaterThan(0.5);
        assertThat(axis.at(1e-8) + axis.at(-1e-8)).isCloseTo(1, within(1e-12));
        assertThat(axis.ticks()).isSortedAccordingTo((a, b) -> Double.compare(a.at(), b.at()));
        assertThat(labels(axis)).contains("0", "1", "\u22121");
    }

    @Test
    void sharesAreStretchedTowardsOne() {
        NinesAxis axis = new NinesAxis("share", 4);
        assertThat(axis.at(0)).isZero();
        assertThat(axis.at(1)).isEqualTo(1);
        assertThat(axis.at(0.9999) - axis.at(0.999)).isCloseTo(axis.at(0.99) - axis.at(0.9), within(1e-9));
        assertThat(labels(axis)).containsExactly("0 %", "50 %", "90 %", "99 %", "99.9 %", "99.99 %", "all");
    }
}
