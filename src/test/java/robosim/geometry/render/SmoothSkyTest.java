package robosim.geometry.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;

@Tag("slow")
class SmoothSkyTest {
    private static final Material WHITE = Material.of(Color.WHITE).withSpecular(0);
    private static final double REACH = 3;

    private static Geometry yard(boolean isEmpty) {
        Geometry world = new Geometry(40, 40, 40);
        world.addObject(new BoxObject(new Point(0, -0.5, 0), 20, 1, 20).withMaterial(WHITE));
        if (!isEmpty) {
            world.addObjectUnchecked(new BoxObject(new Point(0, 1, -2), 6, 2, 0.3).withMaterial(WHITE));
            world.addObjectUnchecked(new SphereObject(new Point(-1.5, 0.7, 0), 0.7).withMaterial(WHITE));
            world.addObjectUnchecked(new CylinderObject(new Point(1.5, 0.6, 0.5), 0.5, 1.2).withMaterial(WHITE));
        }
        return world;
    }

    private static ColorCamera camera() {
        return ColorCamera.of(150, 101, 50)
                .at(Pose.lookAt(new Point(3, 4, 6), new Point(0, 0.3, 0)))
                .withSamples(2);
    }

    private static int[] pixels(Geometry world, ColorCamera camera) {
        ColorFrame frame = new ColorFrame();
        camera.render(world, frame);
        return frame.pixels().clone();
    }

    /** The mean difference of two pictures, over all components. */
    private static double difference(int[] a, int[] b) {
        long sum = 0;
        for (int k = 0; k < a.length; k++) {
            for (int shift = 0; shift <= 16; shift += 8) {
                sum += Math.abs((a[k] >> shift & 0xff) - (b[k] >> shift & 0xff));
            }
        }
        return sum / (3.0 * a.length);
    }

    @Test
    void nothingIsDarkerWhereNothingHidesTheSky() {
        assertThat(pixels(yard(true), camera().withSmoothSky(2, REACH))).isEqualTo(pixels(yard(true), camera()));
    }

    @Test
    void fewRaysAreNearerToManyThanWithoutTheNeighbours() {
        int[] many = pixels(yard(false), camera().withSkyRays(64, REACH));
        int[] none = pixels(yard(false), camera());
        int[] few = pixels(yard(false), camera().withSkyRays(1, REACH)); // 4 for each pixel
        int[] smooth = pixels(yard(false), camera().withSmoothSky(3, REACH));
        double off = difference(smooth, many);
        assertThat(difference(none, many)).as("a picture with shadows").isGreaterThan(5);
        assertThat(off).isLessThan(difference(few, many) / 3);
        assertThat(off).isLessThan(1);
    }

    /** Before a wall the floor darkens evenly: its pixels differ from those beside them by no more than rounding makes. */
    @Test
    void noStepsOnAnEvenFloor() {
        Geometry world = new Geometry(40, 40, 40, Dimension.SPATIAL, Accuracy.EXACT);
        world.addObjectUnchecked(new BoxObject(new Point(0, -0.5, 0), 30, 1, 30));
        world.addObjectUnchecked(new BoxObject(new Point(0, 1, -1), 4, 2, 1));
        ColorFrame frame = new ColorFrame();
        ColorCamera.of(160, 100, 50)
                .at(Pose.lookAt(new Point(1, 5, 8), new Point(0, 0, 1)))
                .withLighting(Lighting.DAY.withoutLights())
                .withSmoothSky(1, 4)
                .render(world, frame);
        int[] steps = new int[256];
        for (int row = 50; row < 100; row++) { // below the wall
            for (int column = 1; column < frame.width(); column++) {
                steps[Math.abs((frame.pixel(column, row) & 0xff) - (frame.pixel(column - 1, row) & 0xff))]++;
            }
        }
        assertThat(steps[1]).as("where it darkens").isGreaterThan(200);
        assertThat(Arrays.stream(steps).skip(2).sum()).as("steps").isZero();
    }

    @Test
    void isTheSameOnAnyThreadsAndAgain() {
        Geometry world = yard(false);
        ColorCamera camera = camera().withSmoothSky(2, REACH);
        int[] alone = pixels(world, camera);
        ColorFrame frame = new ColorFrame();
        for (int threads = 2; threads <= 3; threads++) {
            camera.withThreads(threads).render(world.snapshot(), frame);
            assertThat(frame.pixels()).as("%d threads", threads).isEqualTo(alone);
        }
        camera.withSmoothSky(0, REACH).render(world, frame);
        assertThat(frame.pixels()).isEqualTo(pixels(world, camera()));
        camera.render(world, frame);
        assertThat(frame.pixels()).as("in a frame that had another picture").isEqualTo(alone);
    }

    /** A wide picture is made of several blocks; a part of it alone has others. */
    @Test
    void showsNoBordersOfBlocks() {
        int[] wide = pixels(
                yard(false),
                ColorCamera.of(256, 64, 50)
                        .at(Pose.lookAt(new Point(0, 9, 0.1), new Point(0, 0, 0)))
                        .withSmoothSky(2, 0.5));
        // The floor far from everything is even, also across the borders of blocks, every 64 pixels.
        for (int x = 1; x < 60; x++) {
            for (int shift = 0; shift <= 16; shift += 8) {
                int step = (wide[60 * 256 + x] >> shift & 0xff) - (wide[60 * 256] >> shift & 0xff);
                assertThat(Math.abs(step)).as("at %d", x).isLessThanOrEqualTo(1);
            }
        }
        int steps = 0;
        int most = 0;
        for (int x = 1; x < 256; x++) {
            int step = Math.abs((wide[50 * 256 + x] & 0xff) - (wide[50 * 256 + x - 1] & 0xff));
            if (x % 64 == 0) {
                steps = Math.max(steps, step);
            } else {
                most = Math.max(most, step);
            }
        }
        assertThat(steps).isLessThanOrEqualTo(most);
    }

    @Test
    void refusesWhatIsNoNumberOfRays() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> camera().withSmoothSky(257, 1))
                .withMessage("count must be from 0 to 256 (got: 257)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> camera().withSmoothSky(1, Double.NaN))
                .withMessage("reach must be above 0 (got: NaN)");
    }
}
