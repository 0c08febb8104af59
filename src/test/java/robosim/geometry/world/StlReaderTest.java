package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.mesh.StlSurface;

class StlReaderTest {
    private static final String FACET =
            "facet normal 0 0 1;outer loop;vertex 0 0 0;vertex 1 0 0;vertex 0 1 0;endloop;endfacet;";

    private static MeshObject read(byte[] bytes) throws WorldException {
        return WorldReader.readMesh(new ByteArrayInputStream(bytes), "t.stl", 1);
    }

    private static MeshObject read(String text) throws WorldException {
        return read(text.replace(';', '\n').getBytes(StandardCharsets.ISO_8859_1));
    }

    private static byte[] bytes(String name) throws IOException {
        try (InputStream in = Objects.requireNonNull(StlReaderTest.class.getResourceAsStream(name))) {
            return in.readAllBytes();
        }
    }

    private static byte[] binary(float... numbers) {
        int count = numbers.length / 9;
        ByteBuffer buffer = ByteBuffer.allocate(84 + 50 * count).order(ByteOrder.LITTLE_ENDIAN);
        buffer.putInt(80, count).position(84);
        for (int k = 0; k < count; k++) {
            buffer.putFloat(Float.NaN).putFloat(0).putFloat(0); // a normal that is none
            for (int n = 0; n < 9; n++) {
                buffer.putFloat(numbers[9 * k + n]);
            }
            buffer.putShort((short) 0x1234);
        }
        return buffer.array();
    }

    private static double volume(MeshObject mesh) {
        double sum = 0;
        for (int[] face : mesh.faces()) {
            Point a = mesh.vertices().get(face[0]);
            Point b = mesh.vertices().get(face[1]);
            Point c = mesh.vertices().get(face[2]);
            sum += a.x() * (b.y() * c.z() - b.z() * c.y())
                    + a.y() * (b.z() * c.x() - b.x() * c.z())
                    + a.z() * (b.x() * c.y() - b.y() * c.x());
        }
        return sum / 6;
    }

    @Test
    void joinsEqualCornersAndNoOthers() throws WorldException {
        float next = Math.nextUp(1f);
        MeshObject mesh = read(binary(0, 0, 0, 1, 0, 0, 0, 1, 0, -0f, 0, 0, 0, 1, 0, next, 0, 0));
        assertThat(mesh.vertices())
                .containsExactly(new Point(), new Point(1, 0, 0), new Point(0, 1, 0), new Point(next, 0, 0));
        assertThat(mesh.faces()).isDeepEqualTo(new int[][] {{0, 1, 2}, {0, 2, 3}});
    }

    @Test
    void readsTextAsPeopleWriteIt() throws WorldException {
        MeshObject one = read("solid;" + FACET + "endsolid");
        assertThat(one.vertices()).containsExactly(new Point(), new Point(1, 0, 0), new Point(0, 1, 0));
        assertThat(read("  SOLID a facet of gold\r;" + FACET.toUpperCase(Locale.ROOT) + "EndSolid a facet; ;"))
                .isEqualTo(one);
        assertThat(read("solid\n" + FACET.replace(';', ' ').replace("normal 0 0 1", "normal nan -nan(ind) 0")
                        + "\nendsolid"))
                .isEqualTo(one);
        assertThat(read("solid a;" + FACET + "endsolid a;solid b;" + FACET + "endsolid b")
                        .faces())
                .isDeepEqualTo(new int[][] {{0, 1, 2}, {0, 1, 2}});
    }

    @Test
    void readsTheSameFromTextAndFromBytes() throws WorldException {
        SplittableRandom random = new SplittableRandom(7);
        float[] numbers = new float[9 * 200];
        StringBuilder text = new StringBuilder("solid random\n");
        for (int k = 0; k < numbers.length; k++) {
            numbers[k] = random.nextInt(4) * 0.375f - 1;
            text.append(k % 9 == 0 ? "facet normal 0 0 0\n outer loop\n" : "")
                    .append(k % 3 == 0 ? "  vertex" : "")
                    .append(' ')
                    .append(numbers[k])
                    .append(k % 3 == 2 ? "\n" : "")
                    .append(k % 9 == 8 ? " endloop\nendfacet\n" : "");
        }
        MeshObject mesh = read(binary(numbers));
        assertThat(read(text + "endsolid random\n")).isEqualTo(mesh);
        assertThat(mesh.faces()).hasNumberOfRows(200);
        assertThat(mesh.vertices()).hasSizeBetween(50, 64).doesNotHaveDuplicates();
    }

    @Test
    void scales() throws WorldException {
        byte[] bytes = binary(1, 2, -3, 1, 2, -3, 1, 2, -3);
        assertThat(WorldReader.readMesh(new ByteArrayInputStream(bytes), "t.stl", 0.5)
                        .vertices())
                .containsExactly(new Point(0.5, 1, -1.5));
        for (double wrong : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> WorldReader.readMesh(new ByteArrayInputStream(bytes), "t.stl", wrong))
                    .withMessage("scale must be a number above 0, up to 2^100 (got: " + wrong + ")");
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "~~|0|must begin with the word solid, or be binary with 84 + 50 bytes for each triangle (got: 0 bytes)",
                "solids|0|(got: 6 bytes)",
                "solid|1|facet or endsolid must come next (got: the end of the file)",
                "solid a;;endsolid a|0|an STL file must have at least one triangle (got: none)",
                "solid;facet 0 0 1|2|normal must come next (got: 0)",
                "solid;facet normal 0 0|2|a number of the normal must come next (got: the end of the file)",
                "solid;facet normal 0 0 1;loop|3|outer must come next (got: loop)",
                "solid;facet normal 0 0 1;outer loop;vertex 0 0 nan|4|z of a vertex: a number must be decimal",
                "solid;facet normal 0 0 1;outer loop;vertex 0 1e99 0|4|must be a number from -2^100 to 2^100",
                "solid;facet normal 0 0 1;outer loop;vertex 0 0 0;vertex 0 0 0;endloop|6|vertex must come next (got: endloop)",
                "solid;facet normal 0 0 1;outer loop;vertex 0 0 0;vertex 0 0 0;vertex 0 0 0;vertex 0 0 0|7|a facet is a triangle",
            })
    void refusesTextWithPlaceAndRemedy(String text, int line, String message) {
        assertThatThrownBy(() -> read(text))
                .isInstanceOfSatisfying(
                        WorldException.class, e -> assertThat(e.line()).isEqualTo(line))
                .hasMessageStartingWith(line == 0 ? "t.stl: " : "t.stl:" + line + ": ")
                .hasMessageContaining(message);
    }

    @Test
    void refusesWhatStandsBehindASolid() {
        assertThatThrownBy(() -> read("solid;" + FACET + "endsolid;rest"))
                .hasMessage("t.stl:10: solid or the file's end must come next (got: rest)");
    }

    @Test
    void refusesBytesThatAreCutOffOrNoNumbers() {
        byte[] whole = binary(0, 0, 0, 1, 0, 0, 0, 1, 0);
        assertThatThrownBy(() -> read(Arrays.copyOf(whole, 133)))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("(got: 133 bytes that would hold 1 triangles, which take 134)");
        assertThatThrownBy(() -> read(binary(0, 0, 0, 1, 0, 0, 0, Float.NaN, 0)))
                .isInstanceOf(WorldException.class)
                .hasMessageStartingWith("t.stl: corner 3 of triangle 1: y must be")
                .hasMessageEndingWith("(got: NaN)");
    }

    @Test
    void namesAFileThatIsNotThere() {
        assertThatThrownBy(() -> WorldReader.readMesh(Path.of("no such.stl")))
                .isInstanceOf(WorldException.class)
                .hasMessage("no such.stl: there is no such file; check the path");
    }

    /** Whatever the bytes are, the answer is a mesh or a refusal. */
    @Test
    void staysWithinItsOwnException() {
        SplittableRandom random = new SplittableRandom(8);
        byte[] text =
                ("solid x;" + FACET + FACET + "endsolid").replace(';', '\n').getBytes(StandardCharsets.US_ASCII);
        byte[] bytes = binary(0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5, 6, 6, 6, 7, 8, 9);
        int refused = 0;
        int count = 4000;
        for (int k = 0; k < count; k++) {
            byte[] damaged = (k % 2 == 0 ? text : bytes).clone();
            damaged[random.nextInt(damaged.length)] = (byte) random.nextInt(256);
            int length = random.nextInt(4) == 0 ? random.nextInt(damaged.length) : damaged.length;
            try {
                assertThat(read(Arrays.copyOf(damaged, length)).faces()).isNotEmpty();
            } catch (WorldException e) {
                assertThat(e).hasMessageStartingWith("t.stl").hasMessageNotContaining("Exception");
                refused++;
            }
        }
        assertThat(refused).isBetween(count * 3 / 10, count * 8 / 10);
    }

    @Test
    void standsWhereAWorldFileNamesIt(@TempDir Path folder) throws IOException {
        Files.write(folder.resolve("cube.STL"), bytes("unit_cube.STL"));
        Path file = Files.writeString(folder.resolve("w.xml"), """
                <world xmlns='urn:robosim:world:1' width='9' height='9' length='9'>
                <mesh file='cube.STL' solid='true' scale='2'/>
                <mesh file='cube.STL' scale='2' center='3 0 0'/></world>""");
        List<WorldObject> objects = WorldReader.read(file).objects();
        MeshObject cube = (MeshObject) objects.get(0).object();
        assertThat(volume(cube)).isEqualTo(8);
        assertThat(((MeshObject) objects.get(1).object()).triangles()).isSameAs(cube.triangles());
    }

    // Files that nobody here wrote.

    @Test
    void readsABinaryFileThatBeginsLikeText() throws IOException {
        MeshObject cube = read(bytes("unit_cube.STL"));
        assertThat(cube.vertices()).hasSize(8);
        assertThat(cube.faces()).hasDimensions(12, 3);
        assertThat(volume(cube.solid())).isEqualTo(1);
    }

    @Test
    void readsACubeWithLettersCutIntoItsSides() throws IOException {
        MeshObject cube = read(bytes("20mm-xyz-cube.stl"));
        assertThat(cube.faces()).hasDimensions(260, 3);
        assertThat(cube.vertices()).hasSize(132); // Euler: a closed surface without a handle has 2 + 260 / 2
        assertThat(cube.solid().isSolid()).isTrue();
        for (var axis : List.<ToDoubleFunction<Point>>of(Point::x, Point::y, Point::z)) {
            var range = cube.vertices().stream().mapToDouble(axis).summaryStatistics();
            assertThat(range.getMax() - range.getMin()).isCloseTo(20, within(1e-5));
        }
    }

    @Test
    void readsAPartThatIsClosedOnceItsCornersAreJoined() throws IOException {
        MeshObject part = read(bytes("busted.STL"));
        assertThat(part.faces()).hasDimensions(3878, 3);
        assertThat(part.vertices()).hasSize(1941); // 2 + 3878 / 2 again
        assertThat(part.solid().isSolid()).isTrue();
    }

    @Test
    void leavesASurfaceOpenThatIs() throws WorldException {
        MeshObject triangle = read("solid;" + FACET + "endsolid");
        assertThatIllegalArgumentException().isThrownBy(triangle::solid).withMessageContaining("closed");
    }

    @Test
    void refusesAFileWithoutTriangles() {
        assertThatThrownBy(() -> read(bytes("stl_empty_bin.stl")))
                .isInstanceOf(WorldException.class)
                .hasMessage("t.stl: an STL file must have at least one triangle (got: none)");
    }

    /** A binary file of triangles with the two bytes that are for each. */
    private static byte[] colored(String header, int... codes) {
        ByteBuffer file = ByteBuffer.allocate(84 + 50 * codes.length).order(ByteOrder.LITTLE_ENDIAN);
        file.put(header.getBytes(StandardCharsets.ISO_8859_1)).position(80);
        file.putInt(codes.length);
        for (int k = 0; k < codes.length; k++) {
            file.position(84 + 50 * k + 12);
            for (float number : new float[] {k, 0, 0, k + 1, 0, 0, k, 1, 0}) {
                file.putFloat(number);
            }
            file.putShort((short) codes[k]);
        }
        return file.array();
    }

    private static List<String> colors(byte[] file) throws Exception {
        MeshObject mesh = StlSurface.read(new ByteArrayInputStream(file), "c.stl", 1);
        Texture texture = mesh.material().texture();
        List<String> colors = new ArrayList<>();
        for (int k = 0; k < mesh.faces().length; k++) {
            if (texture instanceof ImageTexture image) {
                double u = mesh.triangles().textured(k, 0, 0);
                double v = mesh.triangles().textured(k, 0, 1);
                colors.add(String.format(
                        "#%06x", image.pixel((int) (u * image.width()), (int) ((1 - v) * image.height()))));
            } else {
                colors.add(
                        mesh.material().isDefault()
                                ? ""
                                : mesh.material().color().toString());
            }
        }
        return colors;
    }

    @Test
    void binaryFilesMayHaveColors() throws Exception {
        int red = 31 << 10;
        int blue = 31;
        int marked = 0x8000;
        String none = Material.DEFAULT.color().toString();
        assertThat(colors(colored("plain", 0, 0))).containsExactly("", "");
        assertThat(colors(colored("plain", red, blue))).containsExactly("", ""); // not marked, so not colours
        assertThat(colors(colored("plain", marked | red, marked | blue))).containsExactly("#ff0000", "#0000ff");
        assertThat(colors(colored("plain", marked | red, 0))).containsExactly("#ff0000", none);
        String magics = "COLOR=\u0010\u0080\u00c0\u00ff";
        assertThat(colors(colored(magics, 0, 0))).containsExactly("#1080c0", "#1080c0");
        assertThat(colors(colored(magics, red, marked))).containsExactly("#0000ff", "#1080c0");
        assertThat(colors(colored("x".repeat(72) + "COLOR=", marked | red))).containsExactly("#ff0000"); // cut off
    }
}
