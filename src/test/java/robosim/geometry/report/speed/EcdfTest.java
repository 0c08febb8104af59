package robosim.geometry.report.speed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.Dimension;

class EcdfTest {
    private static Ecdf of(int count) {
        Ecdf ecdf = new Ecdf();
        for (int k = count; k >= 1; k--) {
            ecdf.add(k);
        }
        return ecdf;
    }

    @Test
    void quantilesAreValuesThatWereSeen() {
        Ecdf ecdf = of(1000);
        assertThat(ecdf.quantile(0)).isEqualTo(1);
        assertThat(ecdf.quantile(0.5)).isEqualTo(500);
        assertThat(ecdf.quantile(0.99)).isEqualTo(990);
        assertThat(ecdf.quantile(0.999)).isEqualTo(999);
        assertThat(ecdf.quantile(1)).isEqualTo(1000);
        ecdf.add(5000);
        assertThat(ecdf.quantile(1)).as("one more").isEqualTo(5000);
    }

    @Test
    void onlyWhatSoManyValuesCanTellIsWrittenDown() {
        List<String> metrics = new ArrayList<>();
        of(1000).put(
                        (subject, scene, query, metric, value) -> metrics.add(metric),
                        Subject.exact(Dimension.PLANAR),
                        "scene",
                        "ray",
                        "off");
        assertThat(metrics).containsExactly("off n", "off q0.5", "off q0.9", "off q0.99", "off q0.999", "off q1.0");
    }

    @Test
    void whatIsNoNumberIsRefused() {
        assertThatThrownBy(() -> of(1).add(Double.NaN)).hasMessageContaining("got: NaN");
        assertThatThrownBy(() -> new Ecdf().quantile(0.5)).hasMessageContaining("got: 0 values");
    }

    @Test
    void theWidestGapToldWrongNeedsMoreThanAFew() {
        Wrongs wrongs = new Wrongs();
        for (int k = 1; k <= 400; k++) {
            // Every tenth below 0.1 is wrong, and a single one far out.
            wrongs.add(k * 1e-3, (k % 10 == 0 && k < 100) || k == 350);
            wrongs.add(-k * 1e-3, false);
            wrongs.add(0, true);
        }
        assertThat(wrongs.widest(0.05)).isEqualTo(0.09);
        assertThat(new Wrongs().widest(0.05)).isZero();
    }
}
