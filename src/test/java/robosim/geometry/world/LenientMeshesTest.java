package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.model.MeshObject;

/** Files that other programs read too, where nothing is lost. */
class LenientMeshesTest {
    private static final String OBJ = "o t\u00fcr\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    private static final String STL =
            "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
                    + "endloop\nendfacet\nendsolid t\n";
    private static final String PLY = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            + "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n";

    @TempDir
    Path folder;

    private MeshObject read(String name, byte[] bytes) throws IOException {
        Path file = Files.write(folder.resolve(name), bytes);
        return (MeshObject) WorldReader.read(file).objects().get(0).object();
    }

    private static byte[] marked(String text, Charset charset, int... mark) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (int each : mark) {
            bytes.write(each);
        }
        bytes.write(text.getBytes(charset));
        return bytes.toByteArray();
    }

    @ParameterizedTest
    @ValueSource(strings = {"obj", "stl", "ply"})
    void byteOrderMarks(String format) throws IOException {
        String text = format.equals("obj") ? OBJ : format.equals("stl") ? STL : PLY;
        String name = "m." + format;
        MeshObject plain = read(name, text.getBytes(StandardCharsets.UTF_8));
        assertThat(read(name, marked(text, StandardCharsets.UTF_8, 0xef, 0xbb, 0xbf)))
                .isEqualTo(plain);
        assertThat(read(name, marked(text, StandardCharsets.UTF_16LE, 0xff, 0xfe)))
                .isEqualTo(plain);
        assertThat(read(name, marked(text, StandardCharsets.UTF_16BE, 0xfe, 0xff)))
                .isEqualTo(plain);
    }

    @Test
    void whatNobodyKnowsIsIgnoredUnlessAShapeIsLost() throws IOException {
        MeshObject plain = read("m.obj", OBJ.getBytes(StandardCharsets.UTF_8));
        String more = OBJ + "vw 1 0.5\nt crease 1/1/1 2 0 1.0\nxyzzy\n";
        assertThat(read("m.obj", more.getBytes(StandardCharsets.UTF_8))).isEqualTo(plain);
        for (String curved : new String[] {"cstype bezier", "surf 0 1 0 1 1 2 3 4", "curv 0 1 1 2"}) {
            assertThatThrownBy(() -> read("m.obj", (OBJ + curved + "\n").getBytes(StandardCharsets.UTF_8)))
                    .hasMessageContainingAll(
                            "m.obj:7: ", "export the curves and curved surfaces", curved.split(" ")[0]);
        }
        String header = PLY.replace("element face", "remark by hand\nelement face");
        assertThat(read("m.ply", header.getBytes(StandardCharsets.UTF_8)))
                .isEqualTo(read("m.ply", PLY.getBytes(StandardCharsets.UTF_8)));
    }

    private static byte[] binary(String begin, int count, int length) {
        ByteBuffer stl = ByteBuffer.allocate(Math.max(length, 84 + 50 * count)).order(ByteOrder.LITTLE_ENDIAN);
        stl.put(begin.getBytes(StandardCharsets.US_ASCII)).putInt(80, count);
        for (int k = 0; k < count; k++) {
            stl.putFloat(84 + 50 * k + 24, 1 + k).putFloat(84 + 50 * k + 40, 1);
        }
        return Arrays.copyOf(stl.array(), length);
    }

    /** Some programs write more behind the last triangle; where that might be triangles, or some are missing, it is refused. */
    @ParameterizedTest
    @CsvSource({
        "solid x, 0, true",
        "made by, 11, true",
        "solid x, 49, true",
        "made by, 100, false",
        "solid x, -30, false",
        "made by, -50, false"
    })
    void bytesBehindABinaryFile(String begin, int more, boolean isRead) throws IOException {
        byte[] bytes = binary(begin, 12, 84 + 600 + more);
        if (isRead) {
            assertThat(read("m.stl", bytes)).isEqualTo(read("m.stl", binary(begin, 12, 684)));
        } else {
            assertThatThrownBy(() -> read("m.stl", bytes))
                    .hasMessageContaining(more < 0 ? "it is truncated" : "it has more triangles than it says");
        }
    }

    @Test
    void commasAreNamed() throws IOException {
        assertThatThrownBy(() -> read("m.obj", OBJ.replace("v 1 1", "v 1,5 1").getBytes(StandardCharsets.UTF_8)))
                .hasMessageContainingAll("m.obj:4: ", "write decimals with a point", "(got: 1,5)");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "w.yaml | world: {height: 10}\\nrobot:\\n  - shape: {name: circle}\\nobstacle:\\n  - state: [5, 5]\\n | IR-SIM",
                "w.yaml | properties: {}\\nlayers:\\n  - name: 2d\\n    map: floor.yaml\\nmodels: []\\n | Flatland, which is not supported; read the ROS map of one of its layers, such as floor.yaml",
                "w.xml | <mvsim_world version=\"1.0\"/> | MVSim",
                "w.xml | <mujoco model=\"m\"><worldbody/></mujoco> | MJCF",
                "w.mjcf | <mujoco/> | MJCF",
                "w.wbt | #VRML_SIM R2023b utf8\\nWorldInfo {} | Webots",
                "w.xml | #VRML_SIM R2023b utf8\\nWorldInfo {} | Webots",
                "w.usda | #usda 1.0 | USD",
                "w.usdz | PK | USD",
                "w.sdf | PXR-USDC | USD"
            })
    void filesOfOthersAreNamed(String name, String content, String expected) throws IOException {
        Path file = Files.writeString(folder.resolve(name), content.replace("\\n", "\n"));
        assertThatThrownBy(() -> WorldReader.read(file)).hasMessageContainingAll("this is ", expected);
    }

    private Path robot(String path, String filename) throws IOException {
        Path file = folder.resolve(path);
        Files.createDirectories(file.getParent());
        return Files.writeString(
                file,
                "<robot name='r'><link name='l'><collision><geometry><mesh filename='" + filename
                        + "'/></geometry></collision></link></robot>");
    }

    /** A repository is mostly cloned into a folder of another name than that of its package. */
    @Test
    void aPackageIsCalledWhatItsManifestSays() throws IOException {
        Path robot = robot("robot-main/urdf/r.urdf", "package://robot_description/meshes/a%20b.stl");
        Path meshes = Files.createDirectories(folder.resolve("robot-main/meshes"));
        Files.write(meshes.resolve("a b.stl"), STL.getBytes(StandardCharsets.UTF_8));
        Path manifest = folder.resolve("robot-main/package.xml");
        Files.writeString(manifest, "<package><!-- <name>other</name> --><name> robot_description </name></package>");
        assertThat(WorldReader.read(robot).objects()).hasSize(1);
        // From elsewhere, in a workspace that is given.
        Path elsewhere = robot("other/e.urdf", "package://robot_description/meshes/a%20b.stl");
        ImportOptions options = ImportOptions.DEFAULT.withModels(java.util.List.of(folder));
        assertThat(WorldImport.read(elsewhere, options).isWhole()).isTrue();
        Files.writeString(manifest, "<package><name>other</name></package>");
        assertThatThrownBy(() -> WorldReader.read(robot)).hasMessageContaining("there is no such file");
    }

    @Test
    void mistakesAreToldInTheWordsOfUrdf() throws IOException {
        Path file = folder.resolve("r.urdf");
        for (String[] each : new String[][] {
            {"<origin xyz='0, 0, 1'/><geometry><box size='1 1 1'/></geometry>", "xyz of <origin>: a number must"},
            {"<geometry><box size='1 1'/></geometry>", "size of <box> must be 3 numbers (got: 2)"},
            {"<geometry><cylinder radius='a' length='1'/></geometry>", "radius of <cylinder>: a number must"},
            {"<geometry><mesh filename='a\\b.stl'/></geometry>", "filename of <mesh> must be a path with /"}
        }) {
            Files.writeString(
                    file, "<robot name='r'><link name='l'><collision>" + each[0] + "</collision></link></robot>");
            assertThatThrownBy(() -> WorldReader.read(file))
                    .hasMessageContaining(each[1])
                    .message()
                    .doesNotContain("<pose>", "<uri>", "<size>", "<radius>");
        }
    }

    @Test
    void allWrongElementsAreListed() throws IOException {
        Path file = Files.writeString(folder.resolve("both.xml"), """
                <world xmlns="urn:robosim:world:1" width="10" height="2" length="10">
                  <wall center="0 0 -4" width="9" height="1" length="0.1"/>
                  <robot name="student" center="-4 0 -4" radius="0.2"/>
                  <cylinder name="a" radius="0.2" hight="1"/>
                  <box width="1" height="1" length="1"/>
                  <ball radius="1"/>
                </world>
                """);
        String start = file + ":";
        assertThat(WorldReader.problems(file).stream()
                        .map(each -> String.valueOf(each.getMessage()).replace(start, "")))
                .satisfiesExactly(
                        wall -> assertThat(wall)
                                .matches("2:\\d+: "
                                        + java.util.regex.Pattern.quote(
                                                "<wall> is not allowed in <world>; allowed here: ")
                                        + ".*"),
                        robot -> assertThat(robot)
                                .matches("3:\\d+: "
                                        + java.util.regex.Pattern.quote(
                                                "<robot> is not allowed in <world>; allowed here: ")
                                        + ".*"),
                        hight -> assertThat(hight)
                                .matches("4:\\d+: " + java.util.regex.Pattern.quote("<cylinder> has no attribute hight")
                                        + ".*"),
                        height -> assertThat(height)
                                .matches("4:\\d+: "
                                        + java.util.regex.Pattern.quote("<cylinder> needs the attribute height")
                                        + ".*"),
                        ball -> assertThat(ball)
                                .matches("6:\\d+: "
                                        + java.util.regex.Pattern.quote(
                                                "<ball> is not allowed in <world>; allowed here: ")
                                        + ".*"));
    }
}
