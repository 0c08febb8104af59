package robosim.geometry.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.material.Color;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.render.Light;
import robosim.geometry.render.Lighting;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

/** glTF files: as Khronos' validator wants them, and of the shapes that the world has. */
class GlbWriterTest {
    private static final String VALIDATE =
            "require('gltf-validator').validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[1])))"
                    + ".then(r => console.log(JSON.stringify(r.issues)))";

    @TempDir
    Path folder;

    private Path written(World world) throws IOException {
        Path file = folder.resolve("world.glb");
        GlbWriter.write(world, "a \"world\" of \u00e9", file, done -> {});
        return file;
    }

    private static World world(Unit unit, WorldObject... objects) {
        return new World(100, 100, 100, unit, Dimension.SPATIAL, Accuracy.EXACT, List.of(objects));
    }

    private static String json(byte[] glb) {
        ByteBuffer in = ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN);
        assertThat(in.getInt()).isEqualTo(0x46546c67);
        assertThat(in.getInt()).isEqualTo(2);
        assertThat(in.getInt()).isEqualTo(glb.length);
        int length = in.getInt();
        assertThat(length % 4).isZero();
        assertThat(in.getInt()).isEqualTo(0x4e4f534a);
        return new String(glb, 20, length, StandardCharsets.UTF_8);
    }

    /** Six times the volume within the triangles of a shape. */
    private static double volume(GlbShape shape) {
        float[] p = shape.points();
        int[] corners = shape.indices();
        double sum = 0;
        for (int k = 0; k < corners.length; k += 3) {
            int a = 3 * corners[k];
            int b = 3 * corners[k + 1];
            int c = 3 * corners[k + 2];
            sum += p[a] * ((double) p[b + 1] * p[c + 2] - (double) p[b + 2] * p[c + 1])
                    + p[a + 1] * ((double) p[b + 2] * p[c] - (double) p[b] * p[c + 2])
                    + p[a + 2] * ((double) p[b] * p[c + 1] - (double) p[b + 1] * p[c]);
        }
        return sum / 6;
    }

    /** All look outwards, of the volume that the shape has or a little less. */
    @Test
    void shapesAreOfTheirVolume() {
        assertThat(volume(GlbShape.box(1, 1, 1))).isCloseTo(1, within(1e-6));
        assertThat(volume(GlbShape.cylinder(1, 1))).isBetween(Math.PI * 0.99, Math.PI);
        assertThat(volume(GlbShape.capsule(1, 0))).isBetween(Math.PI * 4 / 3 * 0.99, Math.PI * 4 / 3);
        double capsule = Math.PI * 4 / 3 * 8 + Math.PI * 4 * 3;
        assertThat(volume(GlbShape.capsule(2, 3))).isBetween(capsule * 0.99, capsule);
        robosim.geometry.model.GridObject grid =
                (robosim.geometry.model.GridObject) Pages.kinds().get(6);
        assertThat(volume(GlbShape.grid(grid))).isCloseTo(13 * 0.5 * 0.5 * 0.8, within(1e-5));
    }

    @Test
    void nodesHaveNamesPlacesAndSizesInMetres() throws IOException {
        WorldObject box = new WorldObject(
                new BoxObject(new Point(10, 20, -30), 1, 2, 3).turned(0, 90).named("a\"b"), "#ff0080", List.of());
        String json = json(Files.readAllBytes(written(world(Unit.CENTIMETRE, box))));
        assertThat(json)
                .contains(
                        "{\"name\":\"a\\\"b\",\"translation\":[10.0, 20.0, -30.0],\"rotation\":[0.0, 0.707106781186547")
                .contains("\"scale\":[1.0, 2.0, 3.0],\"mesh\":0}")
                .contains("{\"name\":\"a \\\"world\\\" of \u00e9\",\"scale\":[0.01, 0.01, 0.01],\"children\":[0]}")
                .contains("\"baseColorFactor\":[1.0, 0.0, 0.2158605");
    }

    /** Each light shines along the -Z of its node, turned by the node's rotation. */
    @Test
    void lightsShineWhereTheyDoInTheWorld() throws Exception {
        List<Point> ways =
                List.of(new Point(0, -1, 0), new Point(0, 0, 2), new Point(0, 0, -2), new Point(0.3, -0.5, 0.8));
        Lighting lighting = Lighting.NONE;
        for (Point way : ways) {
            lighting = lighting.withLight(new Light.Sun(way, Color.WHITE, 0.5));
        }
        lighting = lighting.withLight(new Light.Lamp(
                        new Point(1, 2, 3),
                        Color.parse("#ff8000"),
                        2,
                        new Light.Falloff(10, 0.5, 0.25, 0.25),
                        Light.Shadows.NONE))
                .withLight(new Light.Spot(new Point(4, 5, 6), new Point(0, -1, 0), 90, Color.WHITE, 3));
        Path file = written(world(Unit.CENTIMETRE).withLighting(lighting));
        String json = json(Files.readAllBytes(file));
        Matcher turned = Pattern.compile("\"name\":\"directional[^}]*?\"rotation\":\\[([^]]*)]")
                .matcher(json);
        for (Point way : ways) {
            assertThat(turned.find()).isTrue();
            double[] q = Stream.of(turned.group(1).split(", ", -1))
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            double length = Math.sqrt(way.x() * way.x() + way.y() * way.y() + way.z() * way.z());
            // The third column of the matrix of a quaternion, with the other sign.
            assertThat(-2 * (q[0] * q[2] + q[3] * q[1])).isCloseTo(way.x() / length, within(1e-12));
            assertThat(-2 * (q[1] * q[2] - q[3] * q[0])).isCloseTo(way.y() / length, within(1e-12));
            assertThat(2 * (q[0] * q[0] + q[1] * q[1]) - 1).isCloseTo(way.z() / length, within(1e-12));
        }
        assertThat(json)
                .contains("{\"type\":\"directional\",\"color\":[1.0, 1.0, 1.0],\"intensity\":" + Math.PI / 2 + "}")
                .contains("\"intensity\":" + Math.PI * 2 * (0.01 * 0.01) + ",\"range\":0.1}")
                .contains("\"outerConeAngle\":" + Math.PI / 4)
                .contains("\"translation\":[4.0, 5.0, 6.0],\"rotation\":");
        validated(file);
    }

    @Test
    void sceneryIsShown() throws IOException {
        World world = world(null).withScenery(List.of(new BoxObject(new Point(1, 2, 3), 1, 1, 1)));
        assertThat(json(Files.readAllBytes(written(world)))).contains("\"scenery 1\",\"translation\":[1.0, 2.0, 3.0]");
    }

    /** A thousand boxes are one shape. */
    @Test
    void whatIsAlikeIsToldOnce() throws IOException {
        WorldObject[] boxes = new WorldObject[1000];
        for (int k = 0; k < boxes.length; k++) {
            boxes[k] = new WorldObject(new BoxObject(new Point(k / 100.0, 0, 0), 1 + k, 1, 1));
        }
        assertThat(Files.size(written(world(null, boxes)))).isLessThan(150_000);
    }

    private void validated(Path file) throws Exception {
        Assumptions.assumeTrue(Program.find("node").isPresent(), "no node on the path, which runs the validator");
        String paths = Stream.of(System.getenv("NODE_PATH"), "target/npm/node_modules")
                .filter(path -> path != null && !path.isEmpty())
                .reduce((a, b) -> a + java.io.File.pathSeparator + b)
                .orElse("");
        Program.Said said =
                Program.run(folder, 60, Map.of("NODE_PATH", paths), List.of("node", "-e", VALIDATE, file.toString()));
        Assumptions.assumeFalse(
                said.err().contains("Cannot find module 'gltf-validator'"),
                "no validator: npm install --prefix target/npm gltf-validator");
        assertThat(said.err()).isEmpty();
        assertThat(said.out()).contains("\"numErrors\":0,\"numWarnings\":0");
    }

    @ParameterizedTest
    @ValueSource(strings = {"rooms", "maze", "warehouse", "meshes", "cylinders", "hard"})
    void khronosValidatorFindsNothingWrong(String name) throws Exception {
        validated(written(WorldReader.read(Path.of("worlds", name + ".xml"))));
    }

    @Test
    void norInAllKindsInFlatThingsAndInAnEmptyWorld() throws Exception {
        validated(written(
                world(Unit.FOOT, Pages.kinds().stream().map(WorldObject::new).toArray(WorldObject[]::new))));
        validated(written(world(
                null,
                new WorldObject(new BoxObject(new Point(0, 0, 0), 1, 0, 0).turned(33, 44)),
                new WorldObject(new SphereObject(new Point(1, 2, 3), 0)),
                new WorldObject(new CylinderObject(new Point(1, 2, 3), 1, 0)),
                new WorldObject(new CapsuleObject(new Point(1e-9, -2e7, 3), 0, 2)))));
        validated(written(world(null)));
        validated(written(world(
                null, GlbMaterialsTest.dressed().stream().map(WorldObject::new).toArray(WorldObject[]::new))));
    }
}
