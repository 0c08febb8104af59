package robosim.geometry.net.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

class WorldExtentTest {
    @Test
    void theWorldHoldsAllWithAQuarterOfRoom() {
        GeometryObject wall = new BoxObject(new Point(-10, 2, 0), 4, 4, 8);
        GeometryObject ball = new SphereObject(new Point(1, 1, 1), 1);
        assertThat(WorldExtent.worldFor(List.of(wall, ball))).containsExactly(30, 14, 14);
        assertThat(WorldExtent.worldFor(List.of(ball))).containsExactly(6, 6, 6);
    }

    @Test
    void aWorldIsNeverTooLargeNorNothing() {
        assertThat(WorldExtent.worldFor(List.of())).containsExactly(2, 2, 2);
        GeometryObject far = new SphereObject(new Point(0x1p100, 0, -0x1p100), 0x1p100);
        assertThat(WorldExtent.worldFor(List.of(far))).containsExactly(0x1p101, 0x1p101, 0x1p101);
    }
}
