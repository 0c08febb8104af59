package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.export.GlbWriter;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

/** glTF 2.0: binary files, and JSON with its buffers in it or beside it. */
@Timeout(120)
class GltfFilesTest {
    /** Vertices at 0 0 0, 1 0 0, 0 1 0, 1 1 0 and 0 0 5, as floats, and behind them 0 1 2 1 3 2 as bytes. */
    private static final byte[] BUFFER = buffer();

    @TempDir
    Path folder;

    private static byte[] buffer() {
        ByteBuffer bytes = ByteBuffer.allocate(66).order(ByteOrder.LITTLE_ENDIAN);
        for (float each : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 5}) {
            bytes.putFloat(each);
        }
        bytes.put(new byte[] {0, 1, 2, 1, 3, 2});
        return bytes.array();
    }

    private static String uri(byte[] bytes) {
        return "data:application/octet-stream;base64," + Base64.getEncoder().encodeToString(bytes);
    }

    /** A file with the mesh of two triangles, in single quotes. */
    private static String gltf(String nodes, String primitive, String more) {
        return ("{'asset':{'version':'2.0'},'scene':0,'scenes':[{'nodes':[0]}],'nodes':[" + nodes + "],"
                        + "'meshes':[{'name':'shape','primitives':[" + primitive + "]}]," + more
                        + "'buffers':[{'byteLength':66,'uri':'" + uri(BUFFER) + "'}],"
                        + "'bufferViews':[{'buffer':0,'byteLength':60},{'buffer':0,'byteOffset':60,'byteLength':6}],"
                        + "'accessors':[{'bufferView':0,'componentType':5126,'count':5,'type':'VEC3'},"
                        + "{'bufferView':1,'componentType':5121,'count':6,'type':'SCALAR'}]}")
                .replace('\'', '"');
    }

    private static final String PRIMITIVE = "{'attributes':{'POSITION':0},'indices':1}";

    private WorldImport imported(String json) throws IOException {
        return WorldImport.read(Files.writeString(folder.resolve("t.gltf"), json), ImportOptions.DEFAULT);
    }

    private MeshObject read(String json) throws IOException {
        return MeshTriangles.mesh(imported(json));
    }

    private static byte[] glb(String json, byte[] bytes) {
        byte[] text = json.getBytes(StandardCharsets.UTF_8);
        int textLength = (text.length + 3) / 4 * 4;
        int length = (bytes.length + 3) / 4 * 4;
        ByteBuffer out = ByteBuffer.allocate(28 + textLength + length).order(ByteOrder.LITTLE_ENDIAN);
        out.put("glTF".getBytes(StandardCharsets.US_ASCII)).putInt(2).putInt(out.capacity());
        out.putInt(textLength).put("JSON".getBytes(StandardCharsets.US_ASCII)).put(text);
        while (out.position() < 20 + textLength) {
            out.put((byte) ' ');
        }
        out.putInt(length).put("BIN\0".getBytes(StandardCharsets.US_ASCII)).put(bytes);
        return out.array();
    }

    @Test
    void aSquareWithTheSameFacesInEveryKindOfFile() throws IOException {
        String json = gltf("{'mesh':0}", PRIMITIVE, "");
        WorldImport read = imported(json);
        MeshObject mesh = MeshTriangles.mesh(read);
        assertThat(mesh.vertices())
                .as("Y is up already, and no face uses the last vertex")
                .containsExactly(new Point(0, 0, 0), new Point(1, 0, 0), new Point(0, 1, 0), new Point(1, 1, 0));
        assertThat(mesh.faces()).isDeepEqualTo(new int[][] {{0, 1, 2}, {1, 3, 2}});
        assertThat(read.format()).isEqualTo("glTF");
        assertThat(read.isWhole()).isTrue();
        assertThat(read.world().unit()).isEqualTo(Unit.METRE);

        String beside = json.replace(uri(BUFFER), "parts/my%20buffer.bin");
        Files.createDirectory(folder.resolve("parts"));
        Files.write(folder.resolve("parts/my buffer.bin"), BUFFER);
        assertThat(MeshTriangles.of(read(beside))).isEqualTo(MeshTriangles.of(mesh));

        byte[] binary = glb(json.replace(",\"uri\":\"" + uri(BUFFER) + "\"", ""), BUFFER);
        MeshObject fromBinary = MeshTriangles.read(Files.write(folder.resolve("t.GLB"), binary));
        assertThat(MeshTriangles.of(fromBinary)).isEqualTo(MeshTriangles.of(mesh));
    }

    @Test
    void withAndWithoutIndicesAndWithStripsAndFans() throws IOException {
        String plain = "{'attributes':{'POSITION':0}%s}";
        assertThat(read(gltf("{'mesh':0}", plain.formatted(",'mode':5"), "")).faces())
                .isDeepEqualTo(new int[][] {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}});
        assertThat(read(gltf("{'mesh':0}", plain.formatted(",'mode':6"), "")).faces())
                .isDeepEqualTo(new int[][] {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
        assertThatThrownBy(() -> read(gltf("{'mesh':0}", plain.formatted(""), "")))
                .hasMessageContaining("meshes[0].primitives[0]: triangles must have 3 corners each (got: 5 corners");
        // Lines and points have no surface.
        assertThat(read(gltf("{'mesh':0}", plain.formatted(",'mode':1") + "," + PRIMITIVE, ""))
                        .faces())
                .hasDimensions(2, 3);
    }

    @Test
    void aNodesMatrixIsColumnByColumn() throws IOException {
        MeshObject mesh = read(gltf("{'mesh':0,'matrix':[0,0,-1,0, 0,2,0,0, 1,0,0,0, 10,20,30,1]}", PRIMITIVE, ""));
        assertThat(mesh.vertices())
                .containsExactly(
                        new Point(10, 20, 30), new Point(10, 20, 29), new Point(10, 22, 30), new Point(10, 22, 29));
        MeshObject mirrored = read(gltf("{'mesh':0,'scale':[-1,1,1]}", PRIMITIVE, ""));
        assertThat(MeshTriangles.of(mirrored))
                .as("a mirrored face is turned round")
                .isEqualTo(MeshTriangles.sorted(List.of(
                        MeshTriangles.turned(new Point(0, 0, 0), new Point(0, 1, 0), new Point(-1, 0, 0)),
                        MeshTriangles.turned(new Point(-1, 0, 0), new Point(0, 1, 0), new Point(-1, 1, 0)))));
    }

    /** Trees of random nodes, against a walk that turns vectors by the product of quaternions. */
    @Test
    void nodesWithinNodes() throws IOException {
        SplittableRandom random = new SplittableRandom(22_002);
        for (int k = 0; k < Effort.cases(30); k++) {
            int depth = 1 + random.nextInt(5);
            StringBuilder nodes = new StringBuilder();
            double[] point = {1, 1, 0};
            double[][] transforms = new double[depth][10];
            for (int node = 0; node < depth; node++) {
                double[] t = transforms[node];
                double length = 0;
                for (int n = 0; n < 10; n++) {
                    t[n] = n < 7 ? random.nextDouble(-2, 2) : random.nextDouble(.5, 2);
                    length += n >= 3 && n < 7 ? t[n] * t[n] : 0;
                }
                for (int n = 3; n < 7; n++) {
                    t[n] /= Math.sqrt(length);
                }
                nodes.append(node == 0 ? "" : ",")
                        .append("{'translation':[%s,%s,%s],'rotation':[%s,%s,%s,%s],'scale':[%s,%s,%s],"
                                .formatted(t[0], t[1], t[2], t[3], t[4], t[5], t[6], t[7], t[8], t[9]))
                        .append(node + 1 < depth ? "'children':[" + (node + 1) + "]}" : "'mesh':0}");
            }
            for (int node = depth - 1; node >= 0; node--) {
                point = placed(transforms[node], point);
            }
            Point found = read(gltf(nodes.toString(), PRIMITIVE, "")).vertices().get(3);
            assertThat(found.x()).isCloseTo(point[0], within(1e-12));
            assertThat(found.y()).isCloseTo(point[1], within(1e-12));
            assertThat(found.z()).isCloseTo(point[2], within(1e-12));
        }
    }

    private static double[] placed(double[] t, double[] p) {
        double[] scaled = {p[0] * t[7], p[1] * t[8], p[2] * t[9], 0};
        double[] q = {t[3], t[4], t[5], t[6]};
        double[] turned = product(product(q, scaled), new double[] {-q[0], -q[1], -q[2], q[3]});
        return new double[] {turned[0] + t[0], turned[1] + t[1], turned[2] + t[2]};
    }

    private static double[] product(double[] a, double[] b) {
        return new double[] {
            a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
            a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
            a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
            a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]
        };
    }

    @Test
    void instancesOfAMeshAndScenes() throws IOException {
        String nodes =
                "{'children':[1,2]},{'mesh':0,'translation':[0,0,1]},{'mesh':0,'translation':[0,0,2],'name':'far'},"
                        + "{'mesh':0,'translation':[0,0,3]}";
        assertThat(read(gltf(nodes, PRIMITIVE, "")).faces())
                .as("not those of no scene")
                .hasDimensions(4, 3);
        String unseen = gltf(nodes, PRIMITIVE, "").replace("\"scene\":0,\"scenes\":[{\"nodes\":[0]}],", "");
        assertThat(read(unseen).faces()).as("without a scene all").hasDimensions(6, 3);
    }

    /** Every type of index and coordinate, with and without strides and offsets. */
    @ParameterizedTest
    @CsvSource({
        "5126, false, 5121, 0", "5126, false, 5123, 20", "5126, false, 5125, 16", "5120, false, 5121, 4",
        "5121, false, 5123, 8", "5122, false, 5125, 0", "5123, false, 5121, 8", "5120, true, 5123, 4",
        "5121, true, 5121, 4", "5122, true, 5123, 8", "5123, true, 5125, 12"
    })
    void everyType(int type, boolean isNormalized, int indexType, int stride) throws IOException {
        int size = size(type);
        int step = stride == 0 ? 3 * size : stride;
        int[][] corners = {{0, 0, 0}, {100, 0, 7}, {0, 120, 3}, {1, 2, 127}};
        int[] indices = {2, 0, 1, 3, 2, 1};
        ByteBuffer bytes = ByteBuffer.allocate(200).order(ByteOrder.LITTLE_ENDIAN);
        List<Point> points = new ArrayList<>();
        for (int k = 0; k < 4; k++) {
            double[] xyz = new double[3];
            for (int n = 0; n < 3; n++) {
                int at = 8 + k * step + n * size;
                switch (type) {
                    case 5120, 5121 -> bytes.put(at, (byte) corners[k][n]);
                    case 5122, 5123 -> bytes.putShort(at, (short) corners[k][n]);
                    default -> bytes.putFloat(at, corners[k][n]);
                }
                double whole = type == 5120 ? 127 : type == 5121 ? 255 : type == 5122 ? 32767 : 65535;
                xyz[n] = isNormalized ? corners[k][n] / whole : corners[k][n];
            }
            points.add(new Point(xyz[0], xyz[1], xyz[2]));
        }
        for (int k = 0; k < indices.length; k++) {
            int at = 120 + k * size(indexType);
            switch (indexType) {
                case 5121 -> bytes.put(at, (byte) indices[k]);
                case 5123 -> bytes.putShort(at, (short) indices[k]);
                default -> bytes.putInt(at, indices[k]);
            }
        }
        String json = ("{'asset':{'version':'2.0'},'nodes':[{'mesh':0}],'meshes':[{'primitives':[" + PRIMITIVE
                        + "]}],'extensionsRequired':['KHR_mesh_quantization'],'buffers':[{'byteLength':200,'uri':'"
                        + uri(bytes.array()) + "'}],'bufferViews':[{'buffer':0,'byteOffset':4,'byteLength':100"
                        + (stride == 0 ? "" : ",'byteStride':" + stride)
                        + "},{'buffer':0,'byteOffset':120,'byteLength':80}],'accessors':[{'bufferView':0,'byteOffset':4,"
                        + "'componentType':" + type + ",'normalized':" + isNormalized + ",'count':4,'type':'VEC3'},"
                        + "{'bufferView':1,'componentType':" + indexType + ",'count':6,'type':'SCALAR'}]}")
                .replace('\'', '"');
        List<List<Point>> expected = List.of(
                MeshTriangles.turned(points.get(2), points.get(0), points.get(1)),
                MeshTriangles.turned(points.get(3), points.get(2), points.get(1)));
        assertThat(MeshTriangles.of(read(json))).isEqualTo(MeshTriangles.sorted(expected));
    }

    private static int size(int type) {
        return type < 5122 ? 1 : type < 5124 ? 2 : 4;
    }

    @Test
    void sparseElementsReplaceOthers() throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(80).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(BUFFER).position(66);
        bytes.put((byte) 2).put((byte) 0).putFloat(7).putFloat(8).putFloat(9);
        String json = gltf("{'mesh':0}", PRIMITIVE, "")
                .replace(uri(BUFFER), uri(bytes.array()))
                .replace("\"byteLength\":66", "\"byteLength\":80")
                .replace("\"byteLength\":6}]", "\"byteLength\":6},{\"buffer\":0,\"byteOffset\":66,\"byteLength\":14}]")
                .replace(
                        "\"count\":5,",
                        "\"count\":5,\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":2,\"componentType\":5121},"
                                + "\"values\":{\"bufferView\":2,\"byteOffset\":2}},");
        assertThat(read(json).vertices().get(2)).isEqualTo(new Point(7, 8, 9));
    }

    @Test
    void aWorldThatThisModuleWroteComesBack() throws IOException {
        MeshObject mesh = new MeshObject(
                List.of(new Point(), new Point(4, 0, 0), new Point(0, 3, 0), new Point(0, 0, 2)),
                new int[][] {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
        World world = new World(
                50,
                50,
                50,
                Unit.METRE,
                Dimension.SPATIAL,
                Accuracy.EXACT,
                List.of(new WorldObject(
                        mesh.named("a").movedTo(new Point(1, 2, 3)).turned(0, 90))));
        Path file = folder.resolve("world.glb");
        GlbWriter.write(world, "world", file, done -> {});
        WorldImport read = WorldImport.read(file, ImportOptions.DEFAULT);
        assertThat(read.isWhole()).isTrue();
        Path obj = folder.resolve("world.obj");
        WorldWriter.writeObj(world, obj, done -> {});
        assertThat(MeshTriangles.of(MeshTriangles.mesh(read))).isEqualTo(MeshTriangles.of(MeshTriangles.read(obj)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"t.gltf", "t.glb"})
    void inSdformatItsAxesAreTheModels(String name) throws IOException {
        String json = gltf("{'name':'far','mesh':0,'translation':[0,0,5]},{'mesh':0}", PRIMITIVE, "");
        Files.write(
                folder.resolve(name), name.endsWith("f") ? json.getBytes(StandardCharsets.UTF_8) : glb(json, BUFFER));
        for (String submesh :
                List.of("", "<submesh><name>far</name></submesh>", "<submesh><name>shape</name></submesh>")) {
            Path world = Files.writeString(
                    folder.resolve("w.sdf"),
                    "<sdf version=\"1.9\"><model name=\"m\"><static>true</static><link name=\"l\">"
                            + "<collision name=\"c\"><geometry><mesh><uri>" + name + "</uri>" + submesh
                            + "</mesh></geometry></collision></link></model></sdf>");
            assertThat(MeshTriangles.read(world).vertices())
                    .containsExactly(new Point(0, 5, 0), new Point(1, 5, 0), new Point(0, 5, -1), new Point(1, 5, -1));
        }
    }

    /** One bad part costs that part: its path and the reason are told. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '#',
            value = {
                "{'attributes':{'POSITION':2},'extensions':{'KHR_draco_mesh_compression':{'bufferView':0}}}"
                        + "| meshes[0].primitives[1]: it is compressed by KHR_draco_mesh_compression, which is not"
                        + " supported; save the file without compression",
                "{'attributes':{'POSITION':9}} | meshes[0].primitives[1]: accessors must have one of number 9 (got: 5",
                "{'attributes':{'POSITION':1}} | meshes[0].primitives[1]: accessors[1]: its type must be VEC3",
                "{'attributes':{}} | meshes[0].primitives[1]: meshes[0].primitives[1].attributes.POSITION must be a whole",
                "{'attributes':{'POSITION':0},'indices':0} | accessors[0]: its type must be SCALAR (got: VEC3)",
                "{'attributes':{'POSITION':3},'indices':1} | indices must be below 3, the number of vertices (got: 3.0)",
                "{'attributes':{'POSITION':4}} | accessors[4]: its elements must end before their bytes do",
                "7 | primitives[1] must be an object"
            })
    void aBadPrimitiveIsLeftOut(String bad, String message) throws IOException {
        String accessors = "\"type\":\"SCALAR\"},{\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
                + "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
                + "{\"bufferView\":0,\"componentType\":5126,\"count\":6,\"type\":\"VEC3\"}]";
        String json = gltf("{'mesh':0}", PRIMITIVE + "," + bad, "").replace("\"type\":\"SCALAR\"}]", accessors);
        WorldImport read = imported(json);
        assertThat(MeshTriangles.mesh(read).faces()).hasDimensions(2, 3);
        assertThat(read.skipped()).hasSize(1);
        assertThat(read.skipped().get(0).toString())
                .startsWith(folder.resolve("t.gltf") + ": left out meshes[0].primitives[1]: ")
                .contains(message.strip());
        assertThatThrownBy(() -> imported(gltf("{'mesh':0}", bad, "").replace("\"type\":\"SCALAR\"}]", accessors)))
                .as("nothing left")
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("nothing in its scene can be read: meshes[0].primitives[0]: ");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '#',
            value = {
                "{'children':[1,2]},{'mesh':5} | left out nodes[1]: meshes must have one of number 5",
                "{'children':[1,2]},{'mesh':0,'rotation':[0,0,0,0]} | left out nodes[1]: nodes[1]: a rotation must not",
                "{'children':[1,2]},{'mesh':0,'matrix':[1]} | left out nodes[1]: nodes[1].matrix must have 16 numbers",
                "{'children':[1,2]},{'mesh':0,'extensions':{'EXT_mesh_gpu_instancing':{}}} | left out nodes[1]: its"
                        + " instances are made by EXT_mesh_gpu_instancing, which is not supported",
                "{'children':[1,2,7]},{} | left out nodes[7]: nodes must have one of number 7 (got: 3, counted from 0)"
            })
    void aBadNodeIsLeftOut(String bad, String message) throws IOException {
        WorldImport read = imported(gltf(bad + ",{'mesh':0}", PRIMITIVE, ""));
        assertThat(MeshTriangles.mesh(read).faces()).hasDimensions(2, 3);
        assertThat(read.skipped().toString()).contains(message.strip());
    }

    @Test
    void requiredExtensionsThatAreNotKnownAreTold() throws IOException {
        String json = gltf("{'mesh':0}", PRIMITIVE, "'extensionsRequired':['KHR_materials_unlit','ACME_subdivision'],");
        WorldImport read = imported(json);
        assertThat(read.skipped()).hasSize(1);
        assertThat(read.skipped().get(0).toString())
                .contains("left out extension ACME_subdivision: it is not supported, so what it adds or changes is");
        String compressed = gltf("{'mesh':0}", PRIMITIVE, "'extensionsRequired':['EXT_meshopt_compression'],")
                .replace(
                        "{\"buffer\":0,\"byteLength\":60}",
                        "{\"buffer\":1,\"byteLength\":60,\"extensions\":{\"EXT_meshopt_compression\":{}}}")
                .replace("}],\"bufferViews\"", "},{\"byteLength\":60}],\"bufferViews\"");
        assertThatThrownBy(() -> imported(compressed))
                .hasMessageContaining("bufferViews[0]: its bytes are compressed, which is not supported; save the file"
                        + " without compression (got: EXT_meshopt_compression)");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '#',
            value = {
                "'2.0' | '1.0' | glTF must be of version 2.0; save it as that (got: asset.version 1.0)",
                "{'asset' | {'asset: | :1: : must come next (got: version",
                "{'asset' | {asset' | :1: a name in quotes must come next (got: asset",
                "'mesh':0 | 'mesh':0 0 | :1: a comma or } must come next (got: 0}",
                "'mesh':0 | 'mesh':1e999 | :1: a number must be decimal and finite",
                "'mesh':0 | 'mesh':tru | :1: a value must come next",
                "'mesh':0 | 'name':'\\x' | :1: a \\ in a string must be followed by one of",
                "'byteLength':66 | 'byteLength':67 | buffers[0]: a buffer must have the bytes that it says; it is trunc",
                "'byteLength':60 | 'byteLength':67 | bufferViews[0]: a view must end before its buffer does",
                "data:application/octet-stream;base64, | data:application/octet-stream, | buffers[0]: a buffer must be data",
                "base64, | base64,? | buffers[0]: uri must be data in base64",
                "data:application/octet-stream;base64, | http://example.com/ | buffers[0]: a buffer must be data in base64,",
                "data:application/octet-stream;base64, | a%zz | buffers[0]: uri: % must be followed by two hexadecimal digits",
                "data:application/octet-stream;base64, | ../ | buffers[0]: uri: file must be a path with / relative to the",
                "'componentType':5126 | 'componentType':5124 | accessors[0]: componentType must be 5120 to 5123, 5125 or",
                "'count':5 | 'count':2000000000 | all primitives together must have at most 20000000 numbers",
                "'nodes':[{'mesh':0}] | 'nodes':[{'children':[0]}] | no node may contain itself",
                "'nodes':[0] | 'nodes':[] | the scene of a glTF file must show at least one triangle (got: none)"
            })
    void whatIsWrongIsTold(String right, String wrong, String message) {
        String json = gltf("{'mesh':0}", PRIMITIVE, "");
        String changed =
                json.replace(right.strip().replace('\'', '"'), wrong.strip().replace('\'', '"'));
        assertThat(changed).isNotEqualTo(json);
        assertThatThrownBy(() -> read(changed))
                .isInstanceOf(WorldException.class)
                .hasMessageStartingWith(folder.resolve("t.gltf").toString())
                .hasMessageContaining(message.strip());
    }

    /** A list of a thousand of itself at each of 200 levels. */
    @Test
    void nodesThatGrowWithoutEnd() {
        StringBuilder nodes = new StringBuilder();
        for (int k = 0; k < 100; k++) {
            nodes.append("{'children':[")
                    .append(k + 1)
                    .append(",".concat(Integer.toString(k + 1)).repeat(9))
                    .append("]},");
        }
        assertThatThrownBy(() -> read(gltf(nodes + "{'mesh':0}", PRIMITIVE, "")))
                .hasMessageContaining("nested at most 200 deep, and no node may contain itself");
        assertThatThrownBy(() -> read("[".repeat(100_000))).hasMessageContaining("nested at most 200 deep");
    }

    @Test
    void binaryFilesThatAreCutOffAreRefused() throws IOException {
        String json = gltf("{'mesh':0}", PRIMITIVE, "").replace(",\"uri\":\"" + uri(BUFFER) + "\"", "");
        byte[] whole = glb(json, BUFFER);
        Path file = folder.resolve("cut.glb");
        for (int length = 0; length < whole.length - 2; length++) {
            Files.write(file, Arrays.copyOf(whole, length));
            assertThatThrownBy(() -> MeshTriangles.read(file))
                    .as("%d bytes", length)
                    .isInstanceOf(WorldException.class);
        }
    }

    @Test
    void otherNamesAreTold() throws IOException {
        Path file = Files.write(folder.resolve("a.obj"), glb("{}", BUFFER));
        assertThatThrownBy(() -> WorldReader.read(file))
                .hasMessageContaining("this is glTF in its binary form; give it");
        Path json = Files.writeString(folder.resolve("a.dae"), gltf("{'mesh':0}", PRIMITIVE, ""));
        assertThatThrownBy(() -> WorldReader.read(json)).hasMessageContaining("this is glTF; give it a name that ends");
    }
}
