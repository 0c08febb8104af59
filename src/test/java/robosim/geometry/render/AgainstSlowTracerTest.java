package robosim.geometry.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * Each pixel beside that of a slow tracer that shares no code: rounded from the same number to within a hundredth, wherever rays
 * a millionth of a radian beside it have much the same colour for that tracer.
 */
class AgainstSlowTracerTest {
    private static final int WIDTH = 80;
    private static final int HEIGHT = 60;
    private static final double BESIDE = 1e-6;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void everyPixel(long seed) {
        RandomScenes random = new RandomScenes(seed);
        List<GeometryObject> objects = random.scene(18, seed % 2 == 0);
        Lighting lighting = random.lighting();
        Geometry world = new Geometry(40, 40, 40);
        objects.forEach(object -> assertThat(world.addObjectUnchecked(object)).isTrue());
        Point eye = new Point(random.next(-5, 5), random.next(2.5, 5), 6);
        Pose pose = Viewpoints.lookAt(eye, new Point(random.next(-1, 1), 0.5, 0));
        ColorFrame frame = new ColorFrame();
        ColorCamera.of(WIDTH, HEIGHT, 70)
                .at(pose)
                .withLighting(lighting)
                .withMirrors(2)
                .render(world, frame);
        SlowTracer slow = new SlowTracer(objects, lighting, 2);
        double[] r = pose.rotation();
        SlowTracer.V forward = new SlowTracer.V(r[0], r[3], r[6]);
        SlowTracer.V up = new SlowTracer.V(r[1], r[4], r[7]);
        SlowTracer.V right = new SlowTracer.V(r[2], r[5], r[8]);
        double tangent = Math.tan(Math.toRadians(35));
        int doubtful = 0;
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            double z = ((pixel % WIDTH + 0.5) / WIDTH * 2 - 1) * tangent;
            double y = (1 - (pixel / WIDTH + 0.5) / HEIGHT * 2) * tangent * HEIGHT / WIDTH;
            double[] expected = null;
            boolean isDoubtful = false;
            for (int k = 0; k < 5; k++) {
                double dz = k == 1 ? BESIDE : k == 2 ? -BESIDE : 0;
                double dy = k == 3 ? BESIDE : k == 4 ? -BESIDE : 0;
                double[] color = slow.color(
                        SlowTracer.V.of(eye), forward.plus(right.times(z + dz)).plus(up.times(y + dy)));
                expected = expected == null ? color : expected;
                isDoubtful |= differ(expected, color) > 0.3;
            }
            if (isDoubtful) {
                doubtful++;
                continue;
            }
            int got = frame.pixel(pixel % WIDTH, pixel / WIDTH);
            double[] is = {got >> 16, got >> 8 & 255, got & 255};
            assertThat(differ(expected, is))
                    .as("pixel %d, %d: %x, expected %s", pixel % WIDTH, pixel / WIDTH, got, Arrays.toString(expected))
                    .isLessThanOrEqualTo(0.51);
        }
        assertThat(doubtful).isLessThan(WIDTH * HEIGHT / 100);
        assertThat(Arrays.stream(frame.pixels()).distinct().count()).isGreaterThan(500);
    }

    private static double differ(double[] a, double[] b) {
        return Math.max(Math.abs(a[0] - b[0]), Math.max(Math.abs(a[1] - b[1]), Math.abs(a[2] - b[2])));
    }
}
