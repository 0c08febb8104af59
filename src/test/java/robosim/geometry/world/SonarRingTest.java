package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

class SonarRingTest {
    @Test
    void looksCounterClockwiseFromForward() {
        SonarRing ring = new SonarRing(4, 0.1, 5, 15);
        assertThat(ring).isEqualTo(new SonarRing(4, 0, 90, 0.1, 5, 15));
        assertThat(ring.direction(0)).isEqualTo(new Point(1, 0, 0));
        assertThat(ring.direction(1)).isEqualTo(new Point(0, 0, -1));
        assertThat(ring.direction(2)).isEqualTo(new Point(-1, 0, 0));
        assertThat(ring.direction(3)).isEqualTo(new Point(0, 0, 1));
        Point right = new SonarRing(2, -30, 60, 0, 1, 0).direction(0);
        assertThat(right.x()).isCloseTo(Math.sqrt(3) / 2, within(0x1p-52));
        assertThat(right.z()).isEqualTo(0.5);
        assertThat(ring.mount(1)).isEqualTo(new Ray(new Point(), new Point(0, 0, -1)));
    }

    @Test
    void refusesWhatNoSensorIs() {
        refused(() -> new SonarRing(0, 0, 1, 0), "count must be 1 to 10000 (got: 0)");
        refused(() -> new SonarRing(10_001, 0, 1, 0), "count must be 1 to 10000 (got: 10001)");
        refused(() -> new SonarRing(1, Double.NaN, 1, 0, 1, 0), "first must be a finite angle in degrees (got: NaN)");
        refused(
                () -> new SonarRing(1, 0, Double.POSITIVE_INFINITY, 0, 1, 0),
                "step must be a finite angle in degrees (got: Infinity)");
        refused(() -> new SonarRing(1, -1, 1, 0), "min must be from 0 to 2^100 (got: -1.0)");
        refused(() -> new SonarRing(1, Double.NaN, 1, 0), "min must be from 0 to 2^100 (got: NaN)");
        refused(() -> new SonarRing(1, 2, 1, 0), "max must be at least min, 2.0 (got: 1.0)");
        refused(() -> new SonarRing(1, 0, Double.NaN, 0), "max must be at least min, 0.0 (got: NaN)");
        refused(() -> new SonarRing(1, 0, 1, 180), "width must be 0 to below 180 degrees (got: 180.0)");
        refused(() -> new SonarRing(1, 0, 1, Double.NaN), "width must be 0 to below 180 degrees (got: NaN)");
        refused(() -> new SonarRing(3, 0, 1, 0).direction(3), "sensor must be 0 to 2 (got: 3)");
        refused(
                () -> new WorldObject(new SphereObject(new Point(), 1), "red", List.of()),
                "color must be # and six hexadecimal digits (got: red)");
        refused(
                () -> new WorldObject(new SphereObject(new Point(), 1), null, List.of(new SonarRing(1, 0, 1, 0))),
                "an object with sonars must have a name (got: sphere at (0.0, 0.0, 0.0) heading 0.0, radius 1.0)");
    }

    private static void refused(ThrowingCallable call, String message) {
        assertThatIllegalArgumentException().isThrownBy(call).withMessage(message);
    }
}
