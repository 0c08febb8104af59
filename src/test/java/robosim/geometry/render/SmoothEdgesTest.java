package robosim.geometry.render;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;

class SmoothEdgesTest {
    private static final ColorCamera CAMERA =
            ColorCamera.of(150, 101, 50).at(Pose.lookAt(new Point(3, 4, 6), new Point(0, 0.3, 0)));

    private static Geometry yard() {
        Geometry world = new Geometry(40, 40, 40);
        world.addObject(new BoxObject(new Point(0, -0.5, 0), 20, 1, 20).withMaterial(Material.of(Color.WHITE)));
        world.addObjectUnchecked(new BoxObject(new Point(0, 1, -2), 6, 2, 0.3).withMaterial(Material.of(Color.BLACK)));
        world.addObjectUnchecked(new SphereObject(new Point(-1.5, 0.7, 0), 0.7));
        world.addObjectUnchecked(new CylinderObject(new Point(1.5, 0.6, 0.5), 0.5, 1.2));
        return world;
    }

    private static int[] pixels(ColorCamera camera) {
        ColorFrame frame = new ColorFrame();
        camera.render(yard(), frame);
        return frame.pixels().clone();
    }

    private static double difference(int[] a, int[] b) {
        long sum = 0;
        for (int k = 0; k < a.length; k++) {
            for (int shift = 0; shift <= 16; shift += 8) {
                int off = (a[k] >> shift & 0xff) - (b[k] >> shift & 0xff);
                sum += (long) off * off;
            }
        }
        return sum / (3.0 * a.length);
    }

    @Test
    void fewSamplesAtEdgesAreNearerToManyEverywhere() {
        int[] many = pixels(CAMERA.withSamples(6));
        double one = difference(pixels(CAMERA), many);
        double edges = difference(pixels(CAMERA.withSmoothEdges(2)), many);
        double grid = difference(pixels(CAMERA.withSamples(2)), many);
        assertThat(one).as("a picture with edges").isGreaterThan(20);
        assertThat(edges).isLessThan(one / 4);
        assertThat(edges).isLessThan(grid);
    }

    @Test
    void evenSurfacesHaveOneSample() {
        int[] one = pixels(CAMERA);
        int[] edges = pixels(CAMERA.withSmoothEdges(3));
        int same = 0;
        for (int k = 0; k < one.length; k++) {
            same += one[k] == edges[k] ? 1 : 0;
        }
        assertThat(same).isBetween(one.length / 2, one.length - 150);
    }

    @Test
    void isTheSameOnAnyThreadsAndWithShadowsOfTheSky() {
        ColorCamera camera = CAMERA.withSmoothEdges(2).withSmoothSky(1, 3);
        int[] alone = pixels(camera);
        ColorFrame frame = new ColorFrame();
        camera.withThreads(3).render(yard().snapshot(), frame);
        assertThat(frame.pixels()).isEqualTo(alone);
        int[] many = pixels(CAMERA.withSamples(3).withSkyRays(8, 3));
        double one = difference(pixels(CAMERA.withSmoothSky(1, 3)), many);
        assertThat(difference(alone, many)).isLessThan(one);
    }

    @Test
    void whiteInTheDefaultLightIsBrightAndNotClipped() {
        Geometry world = new Geometry(40, 40, 40);
        world.addObject(new BoxObject(new Point(), 1, 1, 1)
                .withMaterial(Material.of(Color.WHITE).withSpecular(0)));
        ColorFrame frame = new ColorFrame();
        CAMERA.at(Pose.lookAt(new Point(-3, 4, 6), new Point())).render(world, frame);
        int pixel = frame.pixel(75, 40); // the top
        for (int shift = 0; shift <= 16; shift += 8) {
            assertThat(pixel >> shift & 0xff).isBetween(225, 254);
        }
    }
}
