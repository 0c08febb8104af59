package robosim.geometry.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import java.util.zip.CRC32C;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;

/** One digest of what sensors with noise and cameras see, whatever the JVM, its mathematics and the number of threads. */
class SameFramesTest {
    /** Recorded on JDK 17 with one thread. */
    private static final long RECORDED = 621121486L;

    private static final Noise NOISE = Noise.gaussian(0.01)
            .and(Noise.proportional(0.01))
            .and(Noise.bias(0.1, 0.05))
            .and(Noise.dropout(0.02))
            .and(Noise.quantized(0.001));

    private static Snapshot world() {
        SplittableRandom random = new SplittableRandom(2020);
        int[] pixels = random.ints(24, 0, 1 << 24).toArray();
        List<Material> materials = List.of(
                Material.DEFAULT.withLabel(3).withReflectance(0.8),
                Material.of(Color.parse("#3070c0")).withMirror(0.4).withLabel(7),
                Material.DEFAULT.withTexture(new Texture.Checker(Color.BLACK, Color.WHITE, 0.3)),
                Material.DEFAULT.withTexture(new ImageTexture(6, 4, pixels, 0.7, 0.9)));
        List<GeometryObject> objects = new ArrayList<>();
        objects.add(new BoxObject(new Point(0, -0.5, 0), 20, 1, 20).withMaterial(materials.get(2)));
        for (int k = 0; k < 40; k++) {
            Point at = new Point(random.nextDouble(-8, 8), random.nextDouble(0.2, 2), random.nextDouble(-8, 8));
            GeometryObject object = switch (k % 5) {
                case 0 -> new BoxObject(at, 1, 0.7, 0.4);
                case 1 -> new CylinderObject(at, 0.4, 1);
                case 2 -> new SphereObject(at, 0.5);
                case 3 -> new CapsuleObject(at, 0.2, 0.8);
                default ->
                    new ObjectGroup(List.of(
                                    new BoxObject(new Point(), 0.5, 1, 0.5).withMaterial(materials.get(1)),
                                    new SphereObject(new Point(0.3, 0.4, 0), 0.4)))
                            .movedTo(at);
            };
            objects.add(object.turned(random.nextDouble(-60, 60), random.nextDouble(-180, 180))
                    .withMaterial(materials.get(k % 4)));
        }
        BitSet cells = new BitSet();
        random.ints(40, 0, 100).forEach(cells::set);
        objects.add(new GridObject(new Point(4, 0.5, 4), 0.3, 1, 10, 10, cells)
                .turned(0, 20)
                .withMaterial(materials.get(3)));
        objects.add(new MeshObject(
                        List.of(new Point(0, 0, 0), new Point(2, 0, 0), new Point(2, 2, 0), new Point(0, 2, 0)),
                        new int[][] {{0, 1, 2, 3}})
                .withTextureCoordinates(
                        new TextureCoordinates(new double[] {0, 0, 1.5, 0, 1.5, 2, 0, 2}, new int[] {0, 1, 2, 3}))
                .movedTo(new Point(-5, 0, -3))
                .turned(10, 35)
                .withMaterial(materials.get(3)));
        objects.add(new CylinderObject(new Point(0, 1, 6), 0.3, 0.6).moveable("robot"));
        Geometry world = new Geometry(60, 60, 60);
        objects.forEach(object -> assertThat(world.addObjectUnchecked(object)).isTrue());
        return world.snapshot();
    }

    private final CRC32C sum = new CRC32C();

    private void add(double... values) {
        for (double value : values) {
            add(Double.doubleToLongBits(value));
        }
    }

    private void add(long bits) {
        for (int k = 0; k < 64; k += 8) {
            sum.update((int) (bits >> k));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void oneDigest(int threads) {
        Snapshot world = world();
        Pose mount = Pose.of(new Point(0.1, 0.4, 0), 85);
        Intrinsics lens = Intrinsics.fieldOfView(64, 48, 80);
        LidarFrame turn = new LidarFrame(LidarFrame.Extra.INTENSITIES, LidarFrame.Extra.OBJECTS);
        DepthFrame depth = new DepthFrame();
        NormalFrame normals = new NormalFrame();
        SegmentationFrame labels = new SegmentationFrame();
        for (long frame = 0; frame < 3; frame++) {
            Lidar.velodyneVlp16(20)
                    .on("robot", mount)
                    .withMotion(new Twist(1, 0, 0.2, 40))
                    .withNoise(NOISE, 42, 1)
                    .withThreads(threads)
                    .read(world, frame, turn);
            add(turn.ranges());
            add(turn.intensities());
            DepthCamera.of(lens)
                    .withRange(0.1, 20)
                    .on("robot", mount)
                    .withNoise(NOISE.and(Noise.mixedPixels(0.3, 0.5)), 42, 2)
                    .withThreads(threads)
                    .read(world, frame, depth);
            add(depth.ranges());
            add(depth.depths());
        }
        NormalCamera.of(lens).on("robot", mount).withThreads(threads).read(world, normals);
        SegmentationCamera.of(lens).on("robot", mount).withThreads(threads).read(world, labels);
        for (int k = 0; k < labels.size(); k++) {
            add(normals.normalX(k), normals.normalY(k), normals.normalZ(k));
            add(labels.label(k));
        }
        ColorFrame picture = new ColorFrame();
        ColorCamera.of(90, 60, 70)
                .at(Pose.lookAt(new Point(-6, 5, 9), new Point(0, 0.5, 0)))
                .withSamples(2)
                .withThreads(threads)
                .render(world, picture);
        Arrays.stream(picture.pixels()).forEach(pixel -> add((long) pixel));
        assertThat(Arrays.stream(picture.pixels()).distinct().count()).isGreaterThan(1000);
        assertThat(Arrays.stream(depth.ranges()).distinct().count()).isGreaterThan(1000);
        assertThat(sum.getValue()).isEqualTo(RECORDED);
    }

    private static void refused(ThrowingCallable call, String because) {
        assertThatIllegalArgumentException().isThrownBy(call).withMessageContaining(because);
    }

    /** A billion pixels, no pixels, and a pose that is none are refused before there is memory for them. */
    @Test
    void imagesThatNobodyCanTake() {
        refused(() -> ColorCamera.of(40_000, 25_000, 60), "67108864 pixels (got: 40000 x 25000)");
        refused(() -> ColorCamera.of(Integer.MAX_VALUE, Integer.MAX_VALUE, 60), "(got: 2147483647 x 2147483647)");
        refused(() -> Intrinsics.fieldOfView(40_000, 25_000, 60), "rows of 40000 pixels (got: 25000)");
        refused(() -> Intrinsics.fieldOfView(0, 5, 60), "width must be from 1 to");
        refused(() -> new ImageTexture(0, 0, new int[0], 1, 1), "(got: 0");
        refused(() -> Pose.ORIGIN.oriented(new double[9]), "rotation");
        refused(() -> Pose.ORIGIN.oriented(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 0}), "rotation");
        refused(() -> new MeshObject(List.of(), new int[0][]), "");
    }
}
