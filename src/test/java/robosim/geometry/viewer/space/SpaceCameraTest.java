package robosim.geometry.viewer.space;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Point;
import robosim.geometry.model.RayPattern;

class SpaceCameraTest {
    private static final Bounds WORLD = new Bounds(-20, 0, -15, 20, 3, 15);

    private static SpaceCamera camera() {
        SpaceCamera camera = SpaceCamera.usual();
        camera.resize(800, 600);
        camera.look(WORLD);
        return camera;
    }

    private static void moveAtRandom(SpaceCamera camera, SplittableRandom random) {
        switch (random.nextInt(5)) {
            case 0 -> camera.orbit(random.nextDouble(-300, 300), random.nextDouble(-90, 90));
            case 1 -> camera.pan(random.nextDouble(-50, 50), random.nextDouble(-50, 50));
            case 2 -> camera.zoom(random.nextDouble(800), random.nextDouble(600), random.nextDouble(0.7, 1.4));
            case 3 -> camera.fly(random.nextInt(-2, 3), random.nextInt(-2, 3), random.nextInt(-2, 3));
            default -> camera.lookAround(random.nextDouble(-90, 90), random.nextDouble(-90, 90));
        }
    }

    private static double[] seen(SpaceView view, Point point) {
        double[] pixel = new double[3];
        assertThat(view.project(point.x(), point.y(), point.z(), pixel)).isTrue();
        return pixel;
    }

    /** The corners of the world are in the picture, and one of them is near its edge. */
    private static void assertShowsAll(SpaceView view) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 8; k++) {
            double[] pixel =
                    seen(view, new Point((k & 1) == 0 ? -20 : 20, (k & 2) == 0 ? 0 : 3, (k & 4) == 0 ? -15 : 15));
            assertThat(pixel[0]).isBetween(0.0, (double) view.width());
            assertThat(pixel[1]).isBetween(0.0, (double) view.height());
            nearest = Math.min(nearest, Math.min(pixel[0], view.width() - pixel[0]) / view.width());
            nearest = Math.min(nearest, Math.min(pixel[1], view.height() - pixel[1]) / view.height());
        }
        assertThat(nearest).isLessThan(0.1);
    }

    @Test
    void theWholeWorldFitsIntoAnyWindow() {
        SpaceCamera camera = camera();
        for (int[] size : new int[][] {{800, 600}, {300, 900}, {1600, 200}, {1024, 1024}}) {
            camera.resize(size[0], size[1]);
            assertShowsAll(camera.view());
        }
        camera.orbit(100, 20);
        camera.zoom(10, 10, 3);
        camera.fit();
        assertShowsAll(camera.view());
    }

    @Test
    void aViewFindsWhatItShows() {
        SplittableRandom random = new SplittableRandom(1);
        SpaceCamera camera = camera();
        for (int k = 0; k < 500; k++) {
            moveAtRandom(camera, random);
            SpaceView view = camera.view();
            double x = random.nextDouble(800);
            double y = random.nextDouble(600);
            Point way = view.direction(x, y);
            Point eye = view.pose().center();
            double far = random.nextDouble(0.1, 100);
            double[] pixel =
                    seen(view, new Point(eye.x() + far * way.x(), eye.y() + far * way.y(), eye.z() + far * way.z()));
            assertThat(pixel[0]).isCloseTo(x, within(1e-6));
            assertThat(pixel[1]).isCloseTo(y, within(1e-6));
            // And nothing behind it.
            assertThat(view.project(eye.x() - way.x(), eye.y() - way.y(), eye.z() - way.z(), pixel))
                    .isFalse();
        }
    }

    @Test
    void theMiddlesOfPixelsAreWhereThePatternAims() {
        SpaceView view = camera().view();
        RayPattern pattern = RayPattern.pinhole(800, 600, view.fieldOfView());
        double[] r = view.pose().rotation();
        for (int pixel = 0; pixel < pattern.size(); pixel += 997) {
            double x = pattern.x(pixel);
            double y = pattern.y(pixel);
            double z = pattern.z(pixel);
            Point way = view.direction(pixel % 800 + 0.5, pixel / 800 + 0.5);
            assertThat(way.x()).isCloseTo(r[0] * x + r[1] * y + r[2] * z, within(1e-12));
            assertThat(way.y()).isCloseTo(r[3] * x + r[4] * y + r[5] * z, within(1e-12));
            assertThat(way.z()).isCloseTo(r[6] * x + r[7] * y + r[8] * z, within(1e-12));
        }
    }

    @Test
    void anOrbitKeepsThePointAndTheDistance() {
        SplittableRandom random = new SplittableRandom(2);
        SpaceCamera camera = camera();
        Point target = camera.target();
        double distance = camera.distance();
        for (int k = 0; k < 200; k++) {
            camera.orbit(random.nextDouble(-500, 500), random.nextDouble(-500, 500));
            double[] pixel = seen(camera.view(), target);
            assertThat(pixel[0]).isCloseTo(400, within(1e-6));
            assertThat(pixel[1]).isCloseTo(300, within(1e-6));
            assertThat(pixel[2]).isCloseTo(distance, within(1e-9));
            // It stays upright: a point above is shown above, unless one looks straight down.
            double[] r = camera.view().pose().rotation();
            assertThat(r[4]).isGreaterThanOrEqualTo(0);
        }
        camera.orbit(0, 1e6);
        assertThat(camera.view().pose().rotation(3)).isEqualTo(-1); // straight down
    }

    @Test
    void whatIsInFrontFollowsTheHand() {
        SpaceCamera camera = camera();
        Point front = new Point(0, 3, 15);
        double[] before = seen(camera.view(), front);
        camera.orbit(10, 0);
        assertThat(seen(camera.view(), front)[0]).isGreaterThan(before[0]);
        before = seen(camera.view(), front);
        camera.orbit(0, 10);
        assertThat(seen(camera.view(), front)[1]).isGreaterThan(before[1]);
        before = seen(camera.view(), camera.target());
        Point point = camera.target();
        camera.pan(30, -20);
        double[] after = seen(camera.view(), point);
        assertThat(after[0]).isCloseTo(before[0] + 30, within(1e-6));
        assertThat(after[1]).isCloseTo(before[1] - 20, within(1e-6));
    }

    @Test
    void zoomKeepsWhatIsAtThePointer() {
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < 200; k++) {
            SpaceCamera camera = camera();
            camera.orbit(random.nextDouble(-500, 500), random.nextDouble(-50, 50));
            double x = random.nextDouble(800);
            double y = random.nextDouble(600);
            SpaceView view = camera.view();
            Point way = view.direction(x, y);
            Point eye = view.pose().center();
            double ahead = view.pose().rotation(0) * way.x()
                    + view.pose().rotation(3) * way.y()
                    + view.pose().rotation(6) * way.z();
            double far = camera.distance() / ahead;
            Point there = new Point(eye.x() + far * way.x(), eye.y() + far * way.y(), eye.z() + far * way.z());
            camera.zoom(x, y, random.nextDouble(0.8, 2));
            double[] pixel = seen(camera.view(), there);
            assertThat(pixel[0]).isCloseTo(x, within(1e-6));
            assertThat(pixel[1]).isCloseTo(y, within(1e-6));
        }
    }

    @Test
    void lookingAroundLeavesTheEyeWhereItIs() {
        SpaceCamera camera = camera();
        Point eye = camera.view().pose().center();
        camera.lookAround(200, -30);
        Point after = camera.view().pose().center();
        assertThat(after.x()).isCloseTo(eye.x(), within(1e-9));
        assertThat(after.y()).isCloseTo(eye.y(), within(1e-9));
        assertThat(after.z()).isCloseTo(eye.z(), within(1e-9));
        assertThat(camera.view().pose().rotation(0))
                .isNotCloseTo(camera().view().pose().rotation(0), within(0.1));
    }

    @Test
    void flightGoesWhereItLooks() {
        SpaceCamera camera = camera();
        Point eye = camera.view().pose().center();
        double distance = camera.distance();
        double[] r = camera.view().pose().rotation();
        camera.fly(1, 0, 0);
        Point after = camera.view().pose().center();
        double stride = SpaceCamera.STRIDE * distance;
        assertThat(after.x() - eye.x()).isCloseTo(r[0] * stride, within(1e-9));
        assertThat(after.y() - eye.y()).isCloseTo(r[3] * stride, within(1e-9));
        assertThat(after.z() - eye.z()).isCloseTo(r[6] * stride, within(1e-9));
        assertThat(camera.distance()).isEqualTo(distance);
    }

    @Test
    void nobodyGetsLost() {
        SpaceCamera camera = camera();
        for (int k = 0; k < 1000; k++) {
            camera.fly(5, 5, 5);
            camera.zoom(0, 0, 0.5);
        }
        assertThat(camera.target().x()).isBetween(-100.0, 100.0);
        assertThat(camera.distance()).isBetween(1000.0, 2000.0);
        for (int k = 0; k < 1000; k++) {
            camera.zoom(400, 300, 2);
        }
        assertThat(camera.distance()).isBetween(1e-3, 1e-1);
    }

    @Test
    void theSameWorldAnewTakesNothingAway() {
        SpaceCamera camera = camera();
        camera.orbit(50, 5);
        SpaceView view = camera.view();
        camera.look(WORLD);
        camera.resize(800, 600);
        assertThat(camera.view()).isEqualTo(view);
        camera.look(new Bounds(-20, 0, -15, 20, 3, 16));
        assertThat(camera.view()).isNotEqualTo(view);
    }

    @Test
    void badArgumentsAreNamed() {
        assertThatThrownBy(() -> new SpaceCamera(Double.NaN, 0)).hasMessageContaining("azimuth");
        assertThatThrownBy(() -> new SpaceCamera(0, 91))
                .hasMessageContaining("elevation")
                .hasMessageContaining("91");
        assertThatThrownBy(() -> new SpaceView(camera().view().pose(), 180, 1, 1))
                .hasMessageContaining("fieldOfView");
        assertThatThrownBy(() -> SpaceView.of(camera().view().pose(), 0, 1)).hasMessageContaining("0 x 1");
    }
}
