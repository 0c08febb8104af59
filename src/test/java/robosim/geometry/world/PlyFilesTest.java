package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Effort;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

/** PLY files: text and both orders of bytes. */
class PlyFilesTest {
    private static final String SQUARE = """
            ply
            format ascii 1.0
            comment end_header
            obj_info made by hand
            element vertex 5
            property float x
            property float y
            property float z
            element face 1
            property list uchar int vertex_indices
            end_header
            0 0 0
            1 0 0
            1 1 0
            0 1 0
            9 9 9
            4 0 1 2 3
            """;

    @TempDir
    Path folder;

    private MeshObject read(String text) throws IOException {
        return read(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    private MeshObject read(byte[] bytes) throws IOException {
        return MeshTriangles.read(Files.write(folder.resolve("t.ply"), bytes));
    }

    @Test
    void aSquareInText() throws IOException {
        WorldImport read =
                WorldImport.read(Files.writeString(folder.resolve("square.ply"), SQUARE), ImportOptions.DEFAULT);
        MeshObject mesh = MeshTriangles.mesh(read);
        assertThat(mesh.vertices())
                .as("without the vertex that no face uses")
                .containsExactly(new Point(0, 0, 0), new Point(1, 0, 0), new Point(1, 1, 0), new Point(0, 1, 0));
        assertThat(mesh.faces()).isDeepEqualTo(new int[][] {{0, 1, 2, 3}});
        assertThat(read.format()).isEqualTo("PLY");
        assertThat(mesh.name()).isEqualTo("square");
        assertThat(MeshTriangles.of(read(SQUARE.replace("\n", "\r\n")))).isEqualTo(MeshTriangles.of(mesh));
    }

    /** Two triangles of a square, of which each has the mean colour of its corners. */
    @Test
    void coloursOfVertices() throws IOException {
        String coloured = """
                ply
                format ascii 1.0
                element vertex 4
                property float x
                property uchar red
                property uchar green
                property float y
                property uchar blue
                property float z
                element face 2
                property list uchar int vertex_indices
                end_header
                0 255 0 0 30 0
                1 255 0 0 60 0
                1 255 0 1 90 0
                0 0 200 1 0 0
                3 0 1 2
                3 0 2 3
                """;
        MeshObject mesh = read(coloured);
        assertThat(mesh.vertices()).hasSize(4);
        assertThat(mesh.material().texture()).isInstanceOf(ImageTexture.class);
        ImageTexture palette = (ImageTexture) mesh.material().texture();
        TextureCoordinates places = mesh.textureCoordinates();
        assertThat(places).isNotNull();
        int[] seen = new int[2];
        for (int face = 0; face < 2; face++) {
            double u = places.coordinate(places.corners()[3 * face], 0);
            seen[face] = palette.pixels()[(int) (u * palette.width())];
        }
        assertThat(seen).containsExactly(0xff003c, 0xaa4328); // 510 / 3, 200 / 3 and 120 / 3
        String one = coloured.replace("0 200 1 0 0", "255 0 1 60 0").replaceAll(" (30|90) 0\n", " 60 0\n");
        assertThat(read(one).material()).isEqualTo(Material.of(Color.parse("#ff003c")));
        String shares = one.replace("uchar red", "float red")
                .replace("uchar green", "float green")
                .replace("uchar blue", "double blue")
                .replace(" 255 0 ", " 1.0 0 ")
                .replace(" 60 0\n", " 0.2352941176470588 0\n");
        assertThat(read(shares).material()).isEqualTo(Material.of(Color.parse("#ff003c")));
        String partly = coloured.replace("uchar blue", "uchar alpha");
        assertThat(read(partly).material().isDefault())
                .as("no colour without blue")
                .isTrue();
    }

    @Test
    void upAndScaleAreThoseOfTheOptions() throws IOException {
        Path file = Files.writeString(folder.resolve("a.ply"), SQUARE);
        WorldImport read = WorldImport.read(file, new ImportOptions(2, 0.5, ImportOptions.Up.Z, List.of()));
        assertThat(List.of(
                        read.world().width(),
                        read.world().height(),
                        read.world().length()))
                .as("twice the farthest coordinates, and a margin of a quarter")
                .containsExactly(1.25, .25, 1.25);
    }

    @Test
    void aConcaveFaceIsCutWithinItsOutline() throws IOException {
        MeshObject mesh = read("""
                ply
                format ascii 1.0
                element vertex 5
                property double x
                property double y
                property double z
                element face 1
                property list uint8 uint32 vertex_index
                end_header
                0 0 0  4 0 0  4 4 0  2 1 0  0 4 0
                5 0 1 2 3 4
                """);
        double area = 0;
        for (List<Point> each : MeshTriangles.of(mesh)) {
            double twice = (each.get(1).x() - each.get(0).x())
                            * (each.get(2).y() - each.get(0).y())
                    - (each.get(2).x() - each.get(0).x())
                            * (each.get(1).y() - each.get(0).y());
            assertThat(twice).isPositive();
            area += twice / 2;
        }
        assertThat(area).isEqualTo(16 - 6);
    }

    @Test
    void stripsOfTriangles() throws IOException {
        MeshObject mesh = read("""
                ply
                format ascii 1.0
                element vertex 6
                property float x
                property float y
                property float z
                element tristrips 1
                property list int int vertex_indices
                end_header
                0 0 0  1 0 0  0 1 0  1 1 0  0 2 0  1 2 0
                8 0 1 2 3 -1 3 5 4
                """);
        assertThat(mesh.faces()).isDeepEqualTo(new int[][] {{0, 1, 2}, {2, 1, 3}, {3, 4, 5}});
    }

    /** A property of a random file. */
    private record Property(String name, String type, String count) {}

    private static final String[] WHOLE = {"char", "uchar", "short", "ushort", "int", "uint"};
    private static final String[] ALL = {"int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};

    private static void put(ByteArrayOutputStream out, ByteOrder order, String type, double number) {
        ByteBuffer bytes = ByteBuffer.allocate(8).order(order);
        switch (type) {
            case "char", "uchar", "int8", "uint8" -> bytes.put((byte) number);
            case "short", "ushort", "int16", "uint16" -> bytes.putShort((short) (int) number);
            case "int", "uint", "int32", "uint32" -> bytes.putInt((int) (long) number);
            case "float", "float32" -> bytes.putFloat((float) number);
            default -> bytes.putDouble(number);
        }
        out.write(bytes.array(), 0, bytes.position());
    }

    /**
     * Random files with random properties, elements and types: what is read of text, of little and of big ends is what was
     * written.
     */
    @Test
    void allFormatsSayTheSame() throws IOException {
        SplittableRandom random = new SplittableRandom(22_001);
        int cases = Effort.cases(60);
        int polygons = 0;
        for (int k = 0; k < cases; k++) {
            RandomPly ply = new RandomPly(random.split());
            MeshObject text = read(ply.bytes(null));
            assertThat(MeshTriangles.of(text)).as("seed case %d", k).isEqualTo(ply.triangles());
            for (ByteOrder order : List.of(ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN)) {
                MeshObject binary = read(ply.bytes(order));
                assertThat(binary.vertices()).as("case %d, %s", k, order).isEqualTo(text.vertices());
                assertThat(binary.faces()).isDeepEqualTo(text.faces());
            }
            polygons += ply.faces.size();
        }
        assertThat(polygons).isGreaterThan(cases);
    }

    /** Random contents of a file, with triangles and quads. */
    private static final class RandomPly {
        private final SplittableRandom random;
        private final long seed;
        private final List<double[]> vertices = new ArrayList<>();
        private final List<int[]> faces = new ArrayList<>();

        RandomPly(SplittableRandom random) {
            this.random = random;
            seed = random.nextLong();
            int count = 5 + random.nextInt(100);
            for (int k = 0; k < count; k++) {
                vertices.add(new double[] {random.nextInt(-100, 100), random.nextInt(-100, 100), k});
            }
            int polygons = 1 + random.nextInt(30);
            for (int k = 0; k < polygons; k++) {
                int first = random.nextInt(count - 3);
                faces.add(new int[] {first, first + 1, first + 2});
            }
        }

        List<List<Point>> triangles() {
            List<List<Point>> triangles = new ArrayList<>();
            for (int[] face : faces) {
                triangles.add(MeshTriangles.turned(point(face[0]), point(face[1]), point(face[2])));
            }
            return MeshTriangles.sorted(triangles);
        }

        private Point point(int k) {
            return new Point(vertices.get(k)[0], vertices.get(k)[1], vertices.get(k)[2]);
        }

        /** The file; of each order of bytes, and of text for null, the same. */
        byte[] bytes(ByteOrder order) {
            SplittableRandom same = new SplittableRandom(seed);
            List<Property> ofVertex = new ArrayList<>();
            for (String axis : same.nextBoolean() ? List.of("x", "y", "z") : List.of("z", "x", "y")) {
                others(same, ofVertex);
                ofVertex.add(new Property(axis, same.nextBoolean() ? "double" : "float", null));
            }
            others(same, ofVertex);
            List<Property> ofFace = new ArrayList<>();
            others(same, ofFace);
            ofFace.add(new Property(
                    same.nextBoolean() ? "vertex_indices" : "vertex_index",
                    WHOLE[same.nextInt(WHOLE.length)],
                    WHOLE[same.nextInt(WHOLE.length)]));
            others(same, ofFace);
            StringBuilder head = new StringBuilder("ply\nformat ");
            head.append(
                    order == null
                            ? "ascii"
                            : order == ByteOrder.LITTLE_ENDIAN ? "binary_little_endian" : "binary_big_endian");
            head.append(" 1.0\nelement vertex ").append(vertices.size()).append('\n');
            ofVertex.forEach(each -> head.append(line(each)));
            head.append("element edge 2\nproperty int a\nproperty list uchar float b\n");
            head.append("element face ").append(faces.size()).append('\n');
            ofFace.forEach(each -> head.append(line(each)));
            head.append("end_header\n");
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            out.writeBytes(head.toString().getBytes(StandardCharsets.US_ASCII));
            for (double[] vertex : vertices) {
                for (Property each : ofVertex) {
                    int axis = each.name.length() == 1 ? "xyz".indexOf(each.name) : -1;
                    value(out, order, same, each, axis < 0 ? null : new double[] {vertex[axis]});
                }
            }
            for (int k = 0; k < 2; k++) {
                value(out, order, same, new Property("a", "int", null), null);
                value(out, order, same, new Property("b", "float", "uchar"), null);
            }
            for (int[] face : faces) {
                for (Property each : ofFace) {
                    boolean isCorners = each.name.startsWith("vertex_");
                    value(out, order, same, each, isCorners ? new double[] {face[0], face[1], face[2]} : null);
                }
            }
            return out.toByteArray();
        }

        private static String line(Property each) {
            return "property " + (each.count == null ? "" : "list " + each.count + " ") + each.type + " " + each.name
                    + "\n";
        }

        private static void others(SplittableRandom same, List<Property> properties) {
            while (same.nextInt(3) == 0) {
                String count = same.nextBoolean() ? null : WHOLE[same.nextInt(WHOLE.length)];
                properties.add(new Property("p" + properties.size(), ALL[same.nextInt(ALL.length)], count));
            }
        }

        private static void value(
                ByteArrayOutputStream out, ByteOrder order, SplittableRandom same, Property each, double[] given) {
            double[] values = given;
            if (values == null) {
                values = new double[each.count == null ? 1 : same.nextInt(4)];
                for (int k = 0; k < values.length; k++) {
                    values[k] = same.nextInt(100);
                }
            }
            if (each.count != null) {
                write(out, order, each.count, values.length);
            }
            for (double value : values) {
                write(out, order, each.type, value);
            }
        }

        private static void write(ByteArrayOutputStream out, ByteOrder order, String type, double value) {
            if (order == null) {
                String text = type.contains("64") || type.startsWith("f") || type.equals("double")
                        ? Double.toString(value)
                        : Long.toString((long) value);
                out.writeBytes((text + " ").getBytes(StandardCharsets.US_ASCII));
            } else {
                put(out, order, type, value);
            }
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "format ascii 1.0 | format ascii16 1.0 | :2: format must be ascii, binary_little_endian",
                "format ascii 1.0 | comment none | :11: a PLY file must say its format before end_header",
                "element vertex 5 | element vertex -5 | :5: the number of elements must be a whole number",
                "element vertex 5 | element vertex 9999999999999999999 | :5: the number of elements must be a whole",
                "element vertex 5 | element vertex | :5: an element must have a name and a number (got: 1 words)",
                "element vertex 5 | element vertex 6 | :18: vertex_indices must come next (got: the end",
                "element face 1 | element face 2 | :18: vertex_indices must come next (got: the end",
                "property float y | property float w | the element vertex must have the properties x, y and z",
                "property float y | property flat y | :7: a type must be char, uchar",
                "property float y | property y | :7: a property must be TYPE NAME",
                "list uchar int | list float int | :10: the length of a list must be of a whole type (got: float)",
                "element vertex 5 | property int n | :5: a property must follow the element that has it",
                "4 0 1 2 3 | 4 0 1 2 5 | a corner must be from 0 and below 5, the number of vertices (got: 5)",
                "4 0 1 2 3 | 4 0 1 2 -1 | :17: face 1 of 1: a corner must be a whole number of at least 0 (got: -1.0)",
                "4 0 1 2 3 | 4 0 1 2 1.5 | :17: face 1 of 1: a corner must be a whole number of at least 0 (got: 1.5)",
                "4 0 1 2 3 | -4 0 1 2 3 | :17: face 1 of 1: the length of vertex_indices must be a whole number",
                "4 0 1 2 3 | 2 0 1 | a PLY file must have at least one face; a cloud of points must be made a surface",
                "1 1 0 | 1 x 0 | :14: y: a number must be decimal",
                "end_header% | ply% | the header of a PLY file must end with the line end_header"
            })
    void whatIsWrongIsToldByItsLine(String right, String wrong, String message) {
        String text = right.endsWith("%")
                ? SQUARE.substring(0, SQUARE.indexOf("\nend_header\n")) + "\n"
                : SQUARE.replace(right, wrong);
        assertThat(text).isNotEqualTo(SQUARE);
        assertThatThrownBy(() -> read(text))
                .isInstanceOf(WorldException.class)
                .hasMessageStartingWith(folder.resolve("t.ply").toString())
                .hasMessageContaining(message);
    }

    @Test
    void whatIsCutOffIsRefused() throws IOException {
        byte[] whole = new RandomPly(new SplittableRandom(5)).bytes(ByteOrder.LITTLE_ENDIAN);
        read(whole);
        for (int length = 0; length < whole.length; length++) {
            byte[] part = Arrays.copyOf(whole, length);
            assertThatThrownBy(() -> read(part)).as("%d bytes", length).isInstanceOf(WorldException.class);
        }
    }

    /** A header may claim anything; what is not there takes no memory. */
    @ParameterizedTest
    @CsvSource({
        "element vertex 9000000000000000000, vertex 1 of 9000000000000000000: the file ends before all elements",
        "'element other 9000000000000000000\nelement vertex 1', vertex 1 of 1: the file ends before"
    })
    void aHugeCount(String element, String message) {
        String text = "ply\nformat binary_big_endian 1.0\n" + element
                + "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
        assertThatThrownBy(() -> read(text)).isInstanceOf(WorldException.class).hasMessageContaining(message);
    }

    @Test
    void otherNamesAreTold() throws IOException {
        Path file = Files.writeString(folder.resolve("a.obj"), SQUARE);
        assertThatThrownBy(() -> WorldReader.read(file))
                .hasMessageContaining("this is PLY; give it a name that ends in .ply");
    }
}
