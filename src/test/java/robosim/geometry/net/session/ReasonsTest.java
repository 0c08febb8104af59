package robosim.geometry.net.session;

import static org.assertj.core.api.Assertions.assertThat;

import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import robosim.geometry.MoveResult;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

class ReasonsTest {
    private static final GeometryObject WALL = new BoxObject(new Point(1, 2, 3), 4, 5, 6);

    private static String reason(double way, double turn, @Nullable GeometryObject obstacle) {
        return Reasons.of(new MoveResult(false, way, turn, obstacle, null, null));
    }

    @Test
    void sayWhatBlocksAndWhere() {
        assertThat(reason(0.25, 0, WALL.named("wall 3"))).isEqualTo("blocked by \"wall 3\" after 0.25 of the way");
        assertThat(reason(0, 0, WALL.named("a\"\n"))).isEqualTo("blocked by \"a\\\"\\u000a\" after 0 of the way");
        assertThat(reason(1, 0.5, null)).isEqualTo("blocked by the border of the world after 0.5 of the turn");
        assertThat(reason(1, 0, WALL)).isEqualTo("blocked by a box at (1, 2, 3) after 0 of the turn");
    }

    /** Double.toString(2e-3) and of 2e23 are others in JDK 17 than in 19 and later. */
    @Test
    void numbersReadTheSameOnEveryJvm() {
        assertThat(reason(0, 0, new BoxObject(new Point(2e-3, -0.0, 2e23), 4, 5, 6)))
                .contains("a box at (0.002, 0, 199999999999999983222784) after");
        assertThat(reason(0, 0, new BoxObject(new Point(-1.0625, 1e-300, 100), 4, 5, 6)))
                .contains("a box at (-1.062, 0, 100) after");
    }

    @Test
    void sharesAreRoundedDown() {
        assertThat(reason(0.1239999, 0, null)).contains("after 0.123 of");
        assertThat(reason(0.1, 0, null)).contains("after 0.1 of");
        assertThat(reason(0.01, 0, null)).contains("after 0.01 of");
        assertThat(reason(Math.nextDown(1.0), 0, null)).contains("after 0.999 of");
        assertThat(reason(1e-9, 0, null)).contains("after 0 of");
    }
}
