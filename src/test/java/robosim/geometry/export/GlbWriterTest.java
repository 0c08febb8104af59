package robosim.geometry.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.model.Bounds;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldReader;

/** Worlds as glTF: read back, every vertex where the objects are; and judged by Khronos' validator, where there is one. */
class GlbWriterTest {
    /** Round shapes have flat sides: they lack at most the sagitta of one of 48. */
    private static final double ROUND = 1 - Math.cos(Math.PI / 48);

    @TempDir
    Path folder;

    private JsonNode json = new ObjectMapper().createObjectNode();
    private ByteBuffer numbers = ByteBuffer.allocate(0);

    private World read(String world) throws IOException {
        World read = WorldReader.read(Path.of("worlds", world));
        Path file = folder.resolve("world.glb");
        GlbWriter.write(read, "a world", file, count -> {});
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
        assertThat(bytes.getInt()).isEqualTo(0x46546c67); // "glTF"
        assertThat(bytes.getInt()).isEqualTo(2);
        assertThat(bytes.getInt()).isEqualTo(bytes.limit());
        byte[] text = new byte[bytes.getInt()];
        assertThat(bytes.getInt()).isEqualTo(0x4e4f534a); // "JSON"
        bytes.get(text);
        json = new ObjectMapper().readTree(new String(text, StandardCharsets.UTF_8));
        assertThat(bytes.getInt()).isEqualTo(bytes.remaining() - 4);
        assertThat(bytes.getInt()).isEqualTo(0x004e4942); // "BIN"
        numbers = bytes.slice().order(ByteOrder.LITTLE_ENDIAN);
        return read;
    }

    /** Applies the scale, rotation and translation of a node to points. */
    private static List<double[]> moved(JsonNode node, List<double[]> points) {
        double[] t = numbers(node.get("translation"), 0, 0, 0);
        double[] q = numbers(node.get("rotation"), 0, 0, 0, 1);
        double[] s = numbers(node.get("scale"), 1, 1, 1);
        List<double[]> moved = new ArrayList<>();
        for (double[] p : points) {
            double x = p[0] * s[0];
            double y = p[1] * s[1];
            double z = p[2] * s[2];
            // p + 2 w (v x p) + 2 v x (v x p)
            double cx = q[1] * z - q[2] * y;
            double cy = q[2] * x - q[0] * z;
            double cz = q[0] * y - q[1] * x;
            moved.add(new double[] {
                x + 2 * (q[3] * cx + q[1] * cz - q[2] * cy) + t[0],
                y + 2 * (q[3] * cy + q[2] * cx - q[0] * cz) + t[1],
                z + 2 * (q[3] * cz + q[0] * cy - q[1] * cx) + t[2]
            });
        }
        return moved;
    }

    private static double[] numbers(JsonNode array, double... usual) {
        if (array == null) {
            return usual;
        }
        double[] numbers = new double[array.size()];
        Arrays.setAll(numbers, k -> array.get(k).asDouble());
        return numbers;
    }

    /** All vertices below a node, in its own parent's frame. */
    private List<double[]> points(int index) {
        JsonNode node = json.get("nodes").get(index);
        List<double[]> points = new ArrayList<>();
        for (JsonNode child : node.path("children")) {
            points.addAll(points(child.asInt()));
        }
        if (node.has("mesh")) {
            for (JsonNode primitive :
                    json.get("meshes").get(node.get("mesh").asInt()).get("primitives")) {
                JsonNode accessor = json.get("accessors")
                        .get(primitive.get("attributes").get("POSITION").asInt());
                JsonNode view =
                        json.get("bufferViews").get(accessor.get("bufferView").asInt());
                int stride = view.path("byteStride").asInt(12);
                int at = view.path("byteOffset").asInt()
                        + accessor.path("byteOffset").asInt();
                for (int k = 0; k < accessor.get("count").asInt(); k++) {
                    points.add(new double[] {
                        numbers.getFloat(at + stride * k),
                        numbers.getFloat(at + stride * k + 4),
                        numbers.getFloat(at + stride * k + 8)
                    });
                }
            }
        }
        return moved(node, points);
    }

    @ParameterizedTest
    @ValueSource(strings = {"rooms.xml", "meshes.xml"})
    void everyObjectIsWhereItIs(String name) throws IOException {
        World world = read(name);
        JsonNode scene = json.get("scenes").get(json.path("scene").asInt());
        assertThat(scene.get("nodes")).hasSize(1);
        JsonNode root = json.get("nodes").get(scene.get("nodes").get(0).asInt());
        assertThat(root.get("name").asText()).isEqualTo("a world");
        assertThat(root.get("children")).hasSize(world.objects().size());
        for (int k = 0; k < world.objects().size(); k++) {
            var object = world.objects().get(k).object();
            int index = root.get("children").get(k).asInt();
            if (object.name() != null) {
                assertThat(json.get("nodes").get(index).get("name").asText()).isEqualTo(object.name());
            }
            Bounds box = object.bounds();
            double[] least = {box.minX(), box.minY(), box.minZ()};
            double[] most = {box.maxX(), box.maxY(), box.maxZ()};
            double size = Math.max(most[0] - least[0], Math.max(most[1] - least[1], most[2] - least[2]));
            double error = 1e-5 * (1 + Math.abs(least[0]) + Math.abs(least[2])) + ROUND * size;
            List<double[]> points = points(index);
            for (int axis = 0; axis < 3; axis++) {
                int along = axis;
                assertThat(points.stream().mapToDouble(p -> p[along]).min().getAsDouble())
                        .as("%s of %s", object, name)
                        .isCloseTo(least[axis], within(error));
                assertThat(points.stream().mapToDouble(p -> p[along]).max().getAsDouble())
                        .as("%s of %s", object, name)
                        .isCloseTo(most[axis], within(error));
            }
        }
    }

    /** Where node and the package gltf-validator are, as by npm install in a folder that NODE_PATH names. */
    @Test
    @Timeout(120)
    void theValidatorFindsNothing() throws Exception {
        String node = Program.find("node").orElse("");
        Assumptions.assumeFalse(node.isEmpty(), "no node on the path, which runs the validator");
        String script = "const v = require('gltf-validator'), fs = require('fs');"
                + "v.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])))"
                + ".then(r => console.log(r.issues.numErrors, r.issues.numWarnings, JSON.stringify(r.issues.messages)));";
        read("rooms.xml");
        Program.Said said = Program.run(
                folder,
                60,
                Map.of(),
                List.of(node, "-e", script, folder.resolve("world.glb").toString()));
        Assumptions.assumeFalse(
                said.err().contains("Cannot find module"), "no package gltf-validator where NODE_PATH says");
        assertThat(said.out().strip()).isEqualTo("0 0 []");
    }
}
