package robosim.geometry.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import robosim.geometry.Allocated;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.image.PngReader;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SenseOptions.Carrier;

class ColorCameraTest {
    private static Geometry scene(long seed) {
        Geometry world = new Geometry(40, 40, 40);
        new RandomScenes(seed)
                .scene(24, true)
                .forEach(object -> assertThat(world.addObjectUnchecked(object)).isTrue());
        return world;
    }

    private static ColorCamera camera(int samples) {
        return ColorCamera.of(93, 61, 65)
                .at(Pose.lookAt(new Point(2, 4, 6), new Point(0, 0.5, 0)))
                .withSamples(samples)
                .withSkyRays(samples == 2 ? 3 : 0, 2);
    }

    /** A picture of one block, in which mirrors and lights make most of the work: it gives way between them, and may end there. */
    @Test
    void aBlockGivesWayBetweenItsLightsAndItsMirrors() {
        Geometry world = new Geometry(40, 40, 40);
        Material mirror = Material.DEFAULT.withMirror(0.9);
        world.addObject(new BoxObject(new Point(0, 0, -3), 10, 10, 1).withMaterial(mirror));
        world.addObject(new BoxObject(new Point(0, 0, 3), 10, 10, 1).withMaterial(mirror));
        List<Light> lamps = Collections.nCopies(5, new Light.Lamp(new Point(1, 1, 0.5), new Color(1, 1, 1), 1));
        ColorCamera camera = ColorCamera.of(16, 16, 40)
                .at(Pose.lookAt(new Point(), new Point(0, 0.01, 3)))
                .withMirrors(7)
                .withLighting(new Lighting(Sky.NONE, lamps));
        ColorFrame whole = new ColorFrame();
        int[] breaks = {0};
        camera.render(world, whole, percent -> breaks[0]++);
        assertThat(breaks[0]).as("8 surfaces of 5 lights each").isGreaterThan(40);
        for (int end : new int[] {1, 7, 23, 40}) {
            ColorFrame frame = new ColorFrame();
            int[] left = {end};
            assertThatIllegalStateException()
                    .isThrownBy(() -> camera.render(world, frame, percent -> {
                        if (--left[0] == 0) {
                            throw new IllegalStateException("ended");
                        }
                    }));
            assertThat(frame.width()).isZero();
            camera.render(world, frame);
            assertThat(frame.pixels()).isEqualTo(whole.pixels());
        }
    }

    /** The same on each JVM: textures on round shapes go through StrictMath, all else through the four operations. */
    @Test
    void pixelsDoNotDependOnThreadsNorOnTheJvm() {
        int[] sums = new int[4];
        for (int samples = 1; samples <= 4; samples++) {
            Geometry world = scene(samples);
            Snapshot snapshot = world.snapshot();
            ColorFrame one = new ColorFrame();
            camera(samples).render(world, one);
            for (int threads : new int[] {1, 2, 5}) {
                ColorFrame frame = new ColorFrame();
                camera(samples).withThreads(threads).render(snapshot, frame);
                assertThat(frame.pixels()).isEqualTo(one.pixels());
            }
            sums[samples - 1] = Arrays.hashCode(one.pixels());
        }
        assertThat(sums).isEqualTo(new int[] {-809282546, 1778616417, -1745414312, -1928570383});
    }

    @Test
    void aFrameIsUsedAgainWithoutAllocation() {
        Geometry world = scene(9);
        ColorCamera camera = camera(1);
        ColorFrame frame = new ColorFrame();
        for (int k = 0; k < 3; k++) {
            camera.render(world, frame);
        }
        int[] pixels = frame.pixels();
        long each = Allocated.everyTime(() -> camera.render(world, frame));
        assertThat(frame.pixels()).isSameAs(pixels);
        assertThat(each).isLessThan(93 * 61); // less than a byte a pixel
    }

    @Test
    void aCameraOnARobotMovesWithIt() {
        Geometry world = new Geometry(40, 40, 40);
        world.addObject(new BoxObject(new Point(8, 0, 0), 1, 6, 20).withMaterial(Material.of(Color.parse("#c03010"))));
        world.addObject(new BoxObject(new Point(0, 0, -8), 10, 6, 1).withMaterial(Material.of(Color.parse("#1030c0"))));
        world.addObject(new CylinderObject(new Point(), 0.5, 1).moveable("r"));
        ColorCamera camera = ColorCamera.of(32, 24, 40).on("r", Pose.of(new Point(0, 0.2, 0), 0));
        ColorFrame frame = new ColorFrame();
        camera.render(world, frame);
        int red = frame.pixel(16, 12);
        assertThat(red >> 16).isGreaterThan(3 * (red & 255));
        assertThat(world.simpleTurn("r", 90)).isTrue();
        camera.render(world, frame);
        int blue = frame.pixel(16, 12);
        assertThat(blue & 255).isGreaterThan(3 * (blue >> 16));
        ColorFrame free = new ColorFrame();
        Geometry without = world.snapshot().toGeometry();
        without.removeObject("r");
        camera.at(Pose.of(new Point(0, 0.2, 0), 90)).render(without, free);
        assertThat(free.pixels()).isEqualTo(frame.pixels());
        camera.withCarrier(Carrier.SEEN).render(world, frame);
        int inside = frame.pixel(16, 12); // of the robot, which is grey
        assertThat((inside & 255) - (inside >> 16)).isBetween(0, 40);
    }

    @Test
    void aPictureComesBackFromItsFile() throws IOException {
        ColorFrame frame = new ColorFrame();
        assertThatIllegalStateException().isThrownBy(() -> frame.writePng(new ByteArrayOutputStream()));
        camera(1).render(scene(3), frame);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        frame.writePng(out);
        PngReader.Pixels read = PngReader.read(new ByteArrayInputStream(out.toByteArray()));
        assertThat(read.width()).isEqualTo(93);
        assertThat(read.height()).isEqualTo(61);
        assertThat(read.pixels()).isEqualTo(frame.pixels());
    }

    @Test
    void refusesWhatIsNoCamera() {
        refused(() -> ColorCamera.of(0, 5, 60), "(got: 0 x 5)");
        refused(() -> ColorCamera.of(1 << 15, 1 << 15, 60), "67108864 pixels (got: 32768 x 32768)");
        refused(() -> ColorCamera.of(5, 5, 180), "(got: 180.0)");
        refused(() -> ColorCamera.of(5, 5, Double.NaN), "(got: NaN)");
        refused(() -> camera(0), "samples must be from 1 to 16 (got: 0)");
        refused(() -> camera(1).withMirrors(-1), "mirrors must be from 0 to 64 (got: -1)");
        refused(() -> camera(1).withSkyRays(1, 0), "reach must be above 0 (got: 0.0)");
        refused(() -> camera(1).withThreads(0), "(got: 0)");
        refused(() -> new Light.Sun(new Point(), Color.WHITE, 1), "direction must not be zero");
        refused(() -> new Light.Lamp(new Point(), Color.WHITE, -1), "strength must be from 0 to 2^100 (got: -1.0)");
        refused(
                () -> new Light.Spot(new Point(), new Point(1, 0, 0), 180, Color.WHITE, 1),
                "degrees must be above 0 and below 180 (got: 180.0)");
        refused(() -> Pose.lookAt(new Point(1, 2, 3), new Point(1, 2, 3)), "target must not be the eye itself");
        refused(() -> camera(1).on("nobody", Pose.ORIGIN).render(new Geometry(9, 9, 9), new ColorFrame()), "nobody");
        assertThat(camera(2)).isEqualTo(camera(2)).hasSameHashCodeAs(camera(2)).isNotEqualTo(camera(3));
    }

    /** A PLANAR world is seen with its heights, wherever they are, from the world and from its snapshot. */
    @Test
    void planarWorldsHaveHeights() {
        int[][] pictures = new int[3][];
        for (int k = 0; k < 3; k++) {
            Geometry world = new Geometry(40, 9, 40, k == 0 ? Dimension.SPATIAL : Dimension.PLANAR, Accuracy.EXACT);
            for (int n = 0; n < 9; n++) {
                world.addObjectUnchecked(new BoxObject(new Point(6 + n, n / 4.0 - 1, n - 4), 1, 1 + n / 3.0, 0.7));
            }
            world.addObject(new CylinderObject(new Point(), 0.3, 1).moveable("robot"));
            world.simpleMove("robot", 2, 0, 0);
            ColorCamera camera = camera(2).on("robot", Pose.of(new Point(0.4, 0.5, 0), 10));
            ColorFrame frame = new ColorFrame();
            for (int round = 0; round < 2; round++) { // the second time, the robot is elsewhere
                world.simpleMove("robot", 1, 0, 0.2);
                if (k == 2) {
                    camera.withThreads(2).render(world.snapshot(), frame);
                } else {
                    camera.render(world, frame);
                }
            }
            pictures[k] = frame.pixels().clone();
        }
        assertThat(pictures[1]).isEqualTo(pictures[0]);
        assertThat(pictures[2]).isEqualTo(pictures[0]);
        assertThat(Arrays.stream(pictures[0]).distinct().count()).isGreaterThan(50);
        Geometry tall = new Geometry(40, 1, 40, Dimension.PLANAR, Accuracy.EXACT);
        tall.addObject(new BoxObject(new Point(5, 700, 0), 1, 20, 1));
        assertThat(tall.snapshot().withHeights().height()).isEqualTo(1420);
        assertThat(tall.snapshot()
                        .withHeights()
                        .toGeometry()
                        .castRay(new Ray(new Point(0, 700, 0), new Point(1, 0, 0)), 9))
                .isNotNull();
        assertThat(tall.snapshot().withHeights().withHeights().objects()).isEqualTo(tall.objects());
    }

    private static void refused(ThrowingCallable call, String because) {
        assertThatIllegalArgumentException().isThrownBy(call).withMessageContaining(because);
    }
}
