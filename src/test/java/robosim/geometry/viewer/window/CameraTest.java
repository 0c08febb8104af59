package robosim.geometry.viewer.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;

class CameraTest {
    private static final Scene.View WORLD = Scene.View.world(40, 30);

    private static Camera camera() {
        Camera camera = new Camera();
        camera.resize(1000, 700);
        camera.look(WORLD);
        return camera;
    }

    private static void assertShowsAll(MapFrame frame) {
        assertThat(frame.x(-20)).isBetween(frame.left(), frame.right());
        assertThat(frame.x(20)).isBetween(frame.left(), frame.right());
        assertThat(frame.y(-15)).isBetween(frame.top(), frame.bottom());
        assertThat(frame.y(15)).isBetween(frame.top(), frame.bottom());
    }

    @Test
    void theWholeWorldFits() {
        Camera camera = camera();
        assertShowsAll(camera.frame());
        // And it fills one side.
        double share = Math.max(
                40 * camera.scale() / (camera.frame().right() - camera.frame().left()),
                30 * camera.scale() / (camera.frame().bottom() - camera.frame().top()));
        assertThat(share).isCloseTo(0.98, within(1e-9));
        camera.resize(500, 900);
        assertShowsAll(camera.frame());
    }

    @Test
    void whatIsAtThePointerStaysThere() {
        SplittableRandom random = new SplittableRandom(1);
        Camera camera = camera();
        for (int k = 0; k < 200; k++) {
            double x = random.nextDouble(50, 980);
            double y = random.nextDouble(20, 600);
            double worldX = camera.frame().worldX(x);
            double worldZ = camera.frame().worldZ(y);
            camera.zoom(x, y, StrictMath.pow(Camera.STEP, random.nextInt(-8, 9)));
            assertThat(camera.frame().x(worldX)).isCloseTo(x, within(1e-6));
            assertThat(camera.frame().y(worldZ)).isCloseTo(y, within(1e-6));
        }
    }

    @Test
    void zoomHasItsLimits() {
        Camera camera = camera();
        double fitted = camera.scale();
        camera.zoom(500, 300, 1e9);
        assertThat(camera.scale()).isCloseTo(5000 * fitted, within(1e-6));
        camera.zoom(500, 300, 1e-12);
        assertThat(camera.scale()).isCloseTo(fitted / 5, within(1e-9));
        camera.fit();
        assertThat(camera.scale()).isEqualTo(fitted);
    }

    @Test
    void theGroundFollowsTheMouse() {
        Camera camera = camera();
        camera.zoom(500, 300, 4);
        double x = camera.frame().x(3);
        double y = camera.frame().y(2);
        camera.pan(40, -25);
        assertThat(camera.frame().x(3)).isCloseTo(x + 40, within(1e-9));
        assertThat(camera.frame().y(2)).isCloseTo(y - 25, within(1e-9));
        // But not out of sight.
        camera.pan(-1e7, 1e7);
        MapFrame frame = camera.frame();
        assertThat(frame.worldX((frame.left() + frame.right()) / 2)).isCloseTo(20, within(1e-9));
        assertThat(frame.worldZ((frame.top() + frame.bottom()) / 2)).isCloseTo(-15, within(1e-9));
    }

    @Test
    void aWindowThatGrowsKeepsWhatWasChosen() {
        Camera camera = camera();
        camera.zoom(500, 300, 4);
        double scale = camera.scale();
        camera.resize(1200, 800);
        assertThat(camera.scale()).isEqualTo(scale);
        // The same world anew does not take it away, another one does.
        camera.look(Scene.View.world(40, 30));
        assertThat(camera.scale()).isEqualTo(scale);
        camera.look(Scene.View.world(41, 30));
        assertThat(camera.scale()).isNotEqualTo(scale);
        assertShowsAll(camera.frame());
    }
}
