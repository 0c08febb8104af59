package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;
import org.junit.jupiter.api.Test;
import robosim.geometry.check.Text;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

class BundleTest {
    private static void refuses(String argument, DoubleFunction<?> make, double... values) {
        for (double value : values) {
            assertThatThrownBy(() -> make.apply(value))
                    .as(argument + " = " + value)
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining(argument)
                    .hasMessageContaining("got: ")
                    .hasMessageContaining(String.valueOf(value));
        }
    }

    private static final double[] NO_COORDINATES = {
        Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Math.nextUp(0x1p100), -Math.nextUp(0x1p100)
    };

    private static final double[] NO_SIZES = {
        Double.NaN, Double.POSITIVE_INFINITY, Math.nextUp(0x1p101), -1, -Double.MIN_VALUE
    };

    @Test
    void numbersThatCannotBeAreRefusedByName() {
        refuses("x ", v -> new MoveRequest("a", v, 0, 0, 0, 0), NO_COORDINATES);
        refuses("y ", v -> new MoveRequest("a", 0, v, 0, 0, 0), NO_COORDINATES);
        refuses("z ", v -> new MoveRequest("a", 0, 0, v, 0, 0), NO_COORDINATES);
        refuses("rx ", v -> new MoveRequest("a", 0, 0, 0, v, 0), NO_COORDINATES);
        refuses("ry ", v -> new MoveRequest("a", 0, 0, 0, 0, v), NO_COORDINATES);
        refuses("xOffset ", v -> new SonarRequest("a", v, 1), NO_COORDINATES);
        refuses("zOffset ", v -> new SonarRequest("a", 1, v), NO_COORDINATES);
        refuses("zOffset ", v -> new SonarRequest("a", -0.0, v), 0, -0.0);
        refuses("min ", v -> new Beam(v, Double.POSITIVE_INFINITY, 0), NO_COORDINATES);
        refuses("min ", v -> new Beam(v, 5, 0), -1, -Double.MIN_VALUE);
        refuses("max ", v -> new Beam(2, v, 0), Double.NaN, 1.9, -1, Double.NEGATIVE_INFINITY);
        refuses("width ", v -> new Beam(0, 1, v), Double.NaN, -1, Math.PI, 4, Double.POSITIVE_INFINITY);
        refuses("width ", v -> new WorldSettings(v, 1, 1, Dimension.PLANAR, Accuracy.EXACT), NO_SIZES);
        refuses("height ", v -> new WorldSettings(1, v, 1, Dimension.PLANAR, Accuracy.EXACT), NO_SIZES);
        refuses("length ", v -> new WorldSettings(1, 1, v, Dimension.PLANAR, Accuracy.EXACT), NO_SIZES);
        refuses("distances[1] ", v -> new DistanceBundle(List.of(1.0, v)), -1, Double.NEGATIVE_INFINITY);
    }

    @Test
    void edgesOfWhatIsAllowed() {
        assertThat(new MoveRequest("", 0x1p100, -0x1p100, -0.0, -0x1p100, Double.MIN_VALUE).z())
                .isEqualTo(-0.0);
        assertThat(new Beam(3, 3, Math.nextDown(Math.PI)).max()).isEqualTo(3);
        assertThat(Beam.LINE).isEqualTo(new Beam(0, Double.POSITIVE_INFINITY, 0));
        assertThat(new SonarRequest("a", 0, Double.MIN_VALUE).beam()).isNull();
        assertThat(new DistanceBundle(List.of(Double.NaN, 0.0, Double.POSITIVE_INFINITY)).distances())
                .hasSize(3);
    }

    @Test
    void nothingIsNull() {
        assertThatThrownBy(() -> new MoveRequest(null, 0, 0, 0, 0, 0)).hasMessageContaining("objectName");
        assertThatThrownBy(() -> new SonarRequest(null, 0, 1)).hasMessageContaining("objectName");
        assertThatThrownBy(() -> new InitBundle(null)).hasMessageContaining("objects");
        assertThatThrownBy(() -> new MoveBundle(Arrays.asList(new MoveRequest("a", 0, 0, 0, 0, 0), null)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("moves[1]");
        assertThatThrownBy(() -> new DistanceBundle(Arrays.asList(1.0, null))).hasMessageContaining("distances[1]");
        assertThatThrownBy(() -> new SonarRequestBundle(null)).hasMessageContaining("requests");
        assertThatThrownBy(() -> WorldSettings.NONE.withDimension(null)).hasMessageContaining("dimension");
        assertThatThrownBy(() -> WorldSettings.NONE.withAccuracy(null)).hasMessageContaining("accuracy");
    }

    @Test
    void settingsMayBeLeftOutOneByOne() {
        assertThat(WorldSettings.NONE).isEqualTo(new WorldSettings(0, -0.0, 0, null, null));
        WorldSettings some = WorldSettings.NONE.withSize(1, 2, 3).withDimension(Dimension.SPATIAL);
        assertThat(some.isComplete()).isFalse();
        assertThat(some.withAccuracy(Accuracy.DOP))
                .isEqualTo(new WorldSettings(1, 2, 3, Dimension.SPATIAL, Accuracy.DOP));
        assertThat(some.withAccuracy(Accuracy.DOP).isComplete()).isTrue();
        assertThat(some.withAccuracy(Accuracy.DOP).withSize(1, 0, 3).isComplete())
                .isFalse();
    }

    /** Generics are no guard against a stream. */
    @Test
    @SuppressWarnings({"unchecked", "rawtypes"})
    void itemsAreOfTheirType() {
        List other = List.of("text");
        assertThatThrownBy(() -> new MoveBundle(other)).hasMessageContaining("moves[0] must be a MoveRequest");
        assertThatThrownBy(() -> new SonarRequestBundle(other)).hasMessageContaining("(got: java.lang.String)");
        assertThatThrownBy(() -> new InitBundle(other)).hasMessageContaining("objects[0] must be a GeometryObject");
        assertThatThrownBy(() -> new DistanceBundle(other)).hasMessageContaining("distances[0] must be a Double");
    }

    @Test
    void listsAreOfTheirOwn() {
        List<Double> given = new ArrayList<>(List.of(1.0));
        DistanceBundle bundle = new DistanceBundle(given);
        given.set(0, 2.0);
        assertThat(bundle.distances()).containsExactly(1.0);
        assertThatThrownBy(() -> bundle.distances().add(3.0)).isInstanceOf(UnsupportedOperationException.class);
    }

    @Test
    void textForALogStaysOnItsLine() {
        assertThat(Text.quoted("robot \"1\"\\\n\u202e\ud83e"))
                .isEqualTo("\"robot \\\"1\\\"\\\\\\u000a\\u202e\\ud83e\"");
        assertThat(Text.quoted("\u00e9\u4e2d")).isEqualTo("\"\u00e9\u4e2d\"");
        assertThat(Text.quoted("x".repeat(1000))).hasSize(105).endsWith("...\"");
        assertThat(Text.line("a\r\nb")).isEqualTo("a\\u000d\\u000ab");
    }
}
