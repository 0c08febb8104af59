package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

class ObjReaderTest {
    private static MeshObject read(String text) throws WorldException {
        return WorldReader.readMesh(new ByteArrayInputStream(text.getBytes(StandardCharsets.ISO_8859_1)), "t.obj", 1);
    }

    private static MeshObject resource(String name) throws IOException {
        try (InputStream in = Objects.requireNonNull(ObjReaderTest.class.getResourceAsStream(name))) {
            return WorldReader.readMesh(in, name, 1);
        }
    }

    /** The volume that a closed surface encloses, with the sign of its faces' sense. */
    static double volume(MeshObject mesh) {
        double sum = 0;
        List<Point> vertices = mesh.vertices();
        for (int[] face : mesh.faces()) {
            for (int k = 2; k < face.length; k++) {
                Point a = vertices.get(face[0]);
                Point b = vertices.get(face[k - 1]);
                Point c = vertices.get(face[k]);
                sum += a.x() * (b.y() * c.z() - b.z() * c.y())
                        + a.y() * (b.z() * c.x() - b.x() * c.z())
                        + a.z() * (b.x() * c.y() - b.y() * c.x());
            }
        }
        return sum / 6;
    }

    @Test
    void readsAllFormsOfFaces() throws WorldException {
        MeshObject mesh = read("""
                # a comment, and a caf\u00e9
                mtllib some.mtl
                o thing
                v 0 0 0 # behind a statement
                v  1\t0 0 1.0
                v 0 1 0 0.5 nan 0.5
                vt 0 0
                vn 0 0 1
                g side
                usemtl red
                s off
                f 1 2 3
                f 1/1 2/1 3/1
                f 1//1 2//1 3//1
                f 1/1/1 2/1/1 3/1/1
                f -3 -2 -1
                f -3/-1/-1 \\
                  2 \\
                  3
                v 5 5 5
                f 1 2 3 4
                l 1 2
                p 1
                """);
        assertThat(mesh.vertices())
                .containsExactly(new Point(), new Point(1, 0, 0), new Point(0, 1, 0), new Point(5, 5, 5));
        int[][] faces = mesh.faces();
        assertThat(faces).hasNumberOfRows(7);
        assertThat(faces[6]).containsExactly(0, 1, 2, 3);
        assertThat(List.of(faces).subList(0, 6))
                .allSatisfy(face -> assertThat(face).containsExactly(0, 1, 2));
    }

    @Test
    void scales() throws WorldException {
        byte[] text = "v 1 2 -3\nf 1 1 1".getBytes(StandardCharsets.US_ASCII);
        assertThat(WorldReader.readMesh(new ByteArrayInputStream(text), "t.obj", 0.5)
                        .vertices())
                .containsExactly(new Point(0.5, 1, -1.5));
        for (double wrong : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> WorldReader.readMesh(new ByteArrayInputStream(text), "t.obj", wrong))
                    .withMessage("scale must be a number above 0, up to 2^100 (got: " + wrong + ")");
        }
    }

    @Test
    void readsALineThatEndsInAnyWay() throws WorldException {
        assertThat(read("\u00ef\u00bb\u00bfv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\nf 1 2 \\\r\n3"))
                .isEqualTo(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "v 0 0|1|a vertex must have x y z (got: v 0 0)",
                "v 0 0 nan|1|a number must be decimal and finite, like 12, -0.5 or 1.5e-3 (got: nan)",
                "v 0 0 1e999|1|(got: 1e999)",
                "v 0 0 1e99|1|must be a number from -2^100 to 2^100",
                "v 0 0 0;f 1 1|2|a face must have 3 to 1000 corners; cut larger ones (got: 2)",
                "v 0 0 0;;f 0 1 1|3|from 1 to 1 or -1 to -1 (got: 0)",
                "v 0 0 0;f 1 1 2|2|a face must use vertices defined before it, from 1 to 1 or -1 to -1 (got: 2)",
                "v 0 0 0;f 1 1 -2|2|(got: -2)",
                "v 0 0 0;f 1 1 99999999999|2|an index must be a whole number (got: 99999999999)",
                "v 0 0 0;f 1 1 x|2|(got: x)",
                "v 0 0 0;f 1 1 /1|2|(got: )",
                "f 1 2 3;v 0 0 0|1|vertices defined before it",
                "v 0 0 0;f 1 \\;1 \\;2|2|(got: 2)",
                "v 0 0 0;curv 0 1 1|2|of the file as polygons (got: curv)",
                "v 0 0 0;;hello|0|an OBJ file must have at least one face (got: none)",
                "v 0 0 0|0|an OBJ file must have at least one face (got: none)",
                "~~|0|an OBJ file must have at least one face",
            })
    void refusesWithPlaceAndRemedy(String text, int line, String message) {
        assertThatThrownBy(() -> read(text.replace(';', '\n')))
                .isInstanceOfSatisfying(WorldException.class, e -> {
                    assertThat(e.line()).isEqualTo(line);
                    assertThat(e.source()).isEqualTo("t.obj");
                })
                .hasMessageStartingWith(line == 0 ? "t.obj: " : "t.obj:" + line + ": ")
                .hasMessageContaining(message);
    }

    @Test
    void namesAFileThatIsNotThere() {
        assertThatThrownBy(() -> WorldReader.readMesh(Path.of("no such.obj")))
                .isInstanceOf(WorldException.class)
                .hasMessage("no such.obj: there is no such file; check the path");
    }

    // Files that nobody here wrote.

    @Test
    void readsACubeWithIndicesFromTheEnd() throws IOException {
        MeshObject cube = resource("negative_indices.obj");
        assertThat(cube.vertices()).hasSize(8);
        assertThat(cube.faces()).hasDimensions(6, 4);
        assertThat(cube.solid().isSolid()).isTrue();
        assertThat(volume(cube)).isEqualTo(8);
    }

    @Test
    void readsVerticesWithColoursThatAreNone() throws IOException {
        MeshObject cube = resource("nancolor.obj");
        assertThat(cube.vertices()).hasSize(8);
        assertThat(cube.faces()).hasDimensions(12, 3);
        assertThat(Math.abs(volume(cube.solid()))).isEqualTo(1);
    }

    @Test
    void readsTwoTetrahedraOnOneFace() throws IOException {
        MeshObject mesh = resource("joined_tetrahedra.obj");
        assertThat(mesh.vertices()).hasSize(5);
        assertThat(mesh.faces()).hasDimensions(8, 3);
        assertThat(mesh.solid().isSolid()).isTrue();
    }

    @Test
    void cutsPolygonsOfManyCornersAndKeepsTheHoleInTheWall() throws IOException {
        MeshObject wall = resource("wallhole.obj");
        assertThat(wall.vertices()).hasSize(92);
        assertThat(wall.faces()).hasDimensions(66, 3);
        assertThat(wall.solid().isSolid()).isTrue();
        // A cube of 10 with a passage of 10 x 5 x 2 and a pyramid of 5 on top.
        assertThat(volume(wall)).isCloseTo(1000 - 100 + 500 / 3.0, within(1e-9));
    }

    @Test
    void refusesAnEmptyFile() {
        assertThatThrownBy(() -> resource("empty.obj"))
                .isInstanceOf(WorldException.class)
                .hasMessage("empty.obj: an OBJ file must have at least one face (got: none)");
    }
}
