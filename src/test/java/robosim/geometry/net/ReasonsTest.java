package robosim.geometry.net;

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
        assertThat(reason(1, 0, WALL))
                .isEqualTo("blocked by a box at (1.0, 2.0, 3.0) heading 0.0, 4.0 x 5.0 x 6.0 after 0 of the turn");
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
