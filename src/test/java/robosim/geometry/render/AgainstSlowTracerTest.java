package robosim.geometry.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.image.PngWriter;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.world.WorldReader;

/**
 * Each pixel beside that of a slow tracer that shares no code: rounded from the same number to within a hundredth, wherever rays
 * a millionth of a radian beside it have much the same colour for that tracer.
 */
@Tag("slow")
class AgainstSlowTracerTest {
    private static final int WIDTH = 80;
    private static final int HEIGHT = 60;
    private static final double BESIDE = 1e-6;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void everyPixel(long seed) {
        RandomScenes random = new RandomScenes(seed);
        compare(random, random.scene(18, seed % 2 == 0));
    }

    /** Grids, and meshes whose images lie by texture coordinates, also read from OBJ, before mirrors. */
    @ParameterizedTest
    @ValueSource(longs = {11, 12, 13, 14, 15, 16})
    void gridsAndTextureCoordinates(long seed, @TempDir Path folder) throws Exception {
        RandomScenes random = new RandomScenes(seed);
        List<GeometryObject> objects = new ArrayList<>(random.scene(4, true));
        BitSet cells = new BitSet();
        for (int k = 0; k < 63; k++) {
            cells.set(k, random.next(0, 1) < 0.4);
        }
        objects.add(new GridObject(new Point(random.next(-1, 1), 0.45, 0.5), 0.4, 0.9, 9, 7, cells)
                .turned(0, seed % 2 == 0 ? 0 : random.next(-180, 180))
                .withMaterial(random.material((int) seed)));
        objects.add(random.textured().movedTo(new Point(random.next(-2, 0), 1.4, -1)));
        objects.add(objFile(random, folder).movedTo(new Point(random.next(0, 2), 1.6, -1)));
        objects.add(new BoxObject(new Point(0, 2, -3), 7, 4, 0.3)
                .withMaterial(Material.of(random.color()).withMirror(0.8)));
        compare(random, objects);
    }

    /** A tent of two quads in OBJ, with an image by MTL, on which it lies by {@code vt}. */
    private static MeshObject objFile(RandomScenes random, Path folder) throws Exception {
        int[] pixels = new int[6 * 4];
        for (int k = 0; k < pixels.length; k++) {
            pixels[k] = (int) random.next(0, 1 << 24);
        }
        try (OutputStream out = Files.newOutputStream(folder.resolve("cloth.png"))) {
            PngWriter.writeColour(out, 6, 4, pixels);
        }
        Files.writeString(folder.resolve("tent.mtl"), "newmtl cloth\nKd 1 1 1\nmap_Kd cloth.png\n");
        StringBuilder text = new StringBuilder("mtllib tent.mtl\nusemtl cloth\n");
        text.append("v -1 0 -1\nv 1 0 -1\nv 1 1 0\nv -1 1 0\nv 1 0 1\nv -1 0 1\n");
        for (int k = 0; k < 8; k++) {
            text.append("vt ")
                    .append(random.next(-1, 2))
                    .append(' ')
                    .append(random.next(-1, 2))
                    .append('\n');
        }
        text.append("f 1/1 4/2 3/3 2/4\nf 4/5 6/6 5/7 3/8\n");
        MeshObject tent = WorldReader.readMesh(Files.writeString(folder.resolve("tent.obj"), text.toString()));
        assertThat(tent.material().texture()).isInstanceOf(ImageTexture.class);
        assertThat(tent.textureCoordinates()).isNotNull();
        return tent;
    }

    private static void compare(RandomScenes random, List<GeometryObject> objects) {
        Lighting lighting = random.lighting();
        Geometry world = new Geometry(40, 40, 40);
        objects.forEach(object -> assertThat(world.addObjectUnchecked(object)).isTrue());
        Point eye = new Point(random.next(-5, 5), random.next(2.5, 5), 6);
        Pose pose = Pose.lookAt(eye, new Point(random.next(-1, 1), 0.5, 0));
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
            SlowTracer.V from = SlowTracer.V.of(eye);
            double[] expected = slow.color(from, forward.plus(right.times(z)).plus(up.times(y)));
            int got = frame.pixel(pixel % WIDTH, pixel / WIDTH);
            double[] is = {got >> 16, got >> 8 & 255, got & 255};
            if (differ(expected, is) <= 0.51) {
                continue;
            }
            // Only where a ray close beside it sees something else.
            boolean isDoubtful = false;
            for (int k = 0; k < 4; k++) {
                double dz = k == 0 ? BESIDE : k == 1 ? -BESIDE : 0;
                double dy = k == 2 ? BESIDE : k == 3 ? -BESIDE : 0;
                double[] color =
                        slow.color(from, forward.plus(right.times(z + dz)).plus(up.times(y + dy)));
                isDoubtful |= differ(expected, color) > 0.3;
            }
            assertThat(isDoubtful)
                    .as("pixel %d, %d: %x, expected %s", pixel % WIDTH, pixel / WIDTH, got, Arrays.toString(expected))
                    .isTrue();
            doubtful++;
        }
        assertThat(doubtful).isLessThan(WIDTH * HEIGHT / 100);
        assertThat(Arrays.stream(frame.pixels()).distinct().count()).isGreaterThan(500);
    }

    private static double differ(double[] a, double[] b) {
        return Math.max(Math.abs(a[0] - b[0]), Math.max(Math.abs(a[1] - b[1]), Math.abs(a[2] - b[2])));
    }
}
