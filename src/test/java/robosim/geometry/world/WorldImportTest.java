package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.LogCapture;

/** One front door for all formats. */
class WorldImportTest {
    private static final Path FILES = Path.of("src/test/resources/robosim/geometry/world");

    /** What files of other formats have and worlds have not; the console does not get it. */
    private final LogCapture log = new LogCapture("robosim.geometry.world");

    @TempDir
    Path folder;

    @AfterEach
    void closeLog() {
        log.close();
    }

    static Stream<Path> realFiles() {
        return Stream.of(
                        "sdf/shapes.sdf",
                        "sdf/nested_model.sdf",
                        "sdf/export_occupancy_grid.sdf",
                        "sdf/inner_walls",
                        "sdf/turtlebot3_world/turtlebot3_world.world",
                        "maps/TenByTen.yaml",
                        "maps/tb3_sandbox.yaml",
                        "20mm-xyz-cube.stl",
                        "busted.STL",
                        "joined_tetrahedra.obj",
                        "negative_indices.obj",
                        "unit_cube.STL",
                        "wallhole.obj",
                        "../../../../../../worlds/rooms.xml",
                        "../../../../../../worlds/meshes.xml")
                .map(FILES::resolve);
    }

    /** What is written of a file reads back to the same world, to the bit. */
    @ParameterizedTest
    @MethodSource("realFiles")
    void roundTrips(Path file) throws IOException {
        WorldImport read = WorldImport.read(file, ImportOptions.DEFAULT);
        Path copy = folder.resolve("copy.xml");
        WorldWriter.write(read.world(), copy);
        WorldImport again = WorldImport.read(copy, ImportOptions.DEFAULT);
        assertThat(again.world()).isEqualTo(read.world());
        assertThat(again.format()).isEqualTo("world");
        assertThat(again.isWhole()).isTrue();
        assertThat(again.read())
                .isEqualTo(Map.of("object", read.world().objects().size()));
        assertThat(read.world().toGeometry().height()).isEqualTo(read.world().height());
        assertThat(Files.list(folder)).containsExactly(copy);
    }

    @Test
    void threeThousandShapesRoundTrip() throws IOException {
        Path file = folder.resolve("3k.sdf");
        try (InputStream in = new GZIPInputStream(Files.newInputStream(FILES.resolve("sdf/3k_shapes.sdf.gz")))) {
            Files.copy(in, file);
        }
        World world = WorldReader.read(file);
        Path copy = folder.resolve("copy.xml");
        WorldWriter.write(world, copy);
        assertThat(WorldReader.read(copy)).isEqualTo(world);
    }

    /** The commands and tests that read a world read any file. */
    @ParameterizedTest
    @MethodSource("realFiles")
    void theWorldReaderTakesThemAll(Path file) throws IOException {
        assertThat(WorldReader.read(file))
                .isEqualTo(WorldImport.read(file, ImportOptions.DEFAULT).world());
    }

    /** The reader that gives a world alone warns of what is not in it. */
    @Test
    void whatIsLeftOutIsAWarning() throws IOException {
        Path file = Files.writeString(
                folder.resolve("few.sdf"),
                "<sdf version='1.7'><world name='w'><model name='m'><link name='l'><collision name='c'><geometry>"
                        + "<sphere><radius>1</radius></sphere></geometry></collision></link></model>\n"
                        + "<actor name='a'/>" + "<actor/>".repeat(2) + "</world></sdf>");
        WorldReader.read(file);
        assertThat(log.lines())
                .hasSize(3)
                .first()
                .asString()
                .startsWith("WARNING " + file + ":2: left out <actor> \"a\": ");
        Path many = Files.writeString(
                folder.resolve("many.sdf"),
                "<sdf version='1.7'><world name='w'><model name='m'><link name='l'><collision name='c'><geometry>"
                        + "<sphere><radius>1</radius></sphere></geometry></collision></link></model>"
                        + "<actor/>".repeat(12) + "</world></sdf>");
        WorldReader.read(many);
        assertThat(log.lines())
                .hasSize(3 + 11)
                .last()
                .asString()
                .isEqualTo("WARNING " + many + ": left out 2 more; the command convert lists them");
        WorldReader.read(Path.of("worlds/maze.xml"));
        assertThat(log.lines()).hasSize(14);
    }

    @Test
    void theOptionsAreForThoseThatNeedThem() throws IOException {
        ImportOptions options = new ImportOptions(0.25, 0.001, ImportOptions.Up.Z, List.of());
        World map =
                WorldImport.read(FILES.resolve("maps/TenByTen.yaml"), options).world();
        assertThat(map.height()).isEqualTo(0.25);
        assertThat(map).isEqualTo(RosMaps.read(FILES.resolve("maps/TenByTen.yaml"), 0.25));
        World mesh = WorldImport.read(FILES.resolve("unit_cube.STL"), options).world();
        MeshObject cube = (MeshObject) mesh.objects().get(0).object();
        assertThat(cube.name()).isEqualTo("unit_cube");
        assertThat(cube.vertices())
                .isEqualTo(WorldReader.readMesh(FILES.resolve("unit_cube.STL"), 0.001)
                        .vertices());
        // Its own Z points up: what is at z = 1 is at Y = 1.
        assertThat(cube.pose().rotation()).containsExactly(1, 0, 0, 0, 0, 1, 0, -1, 0);
    }

    /** In the middle of a box that it fills, and as large as it is. */
    @Test
    void aMeshStandsInAWorldOfItsSize() throws IOException {
        Path file = Files.writeString(folder.resolve("wedge.obj"), "v 1 2 3\nv 4 2 3\nv 1 -8 3\nf 1 2 3\n");
        WorldImport read = WorldImport.read(file, ImportOptions.DEFAULT);
        assertThat(read.read()).isEqualTo(Map.of("vertex", 3, "face", 1));
        assertThat(List.of(
                        read.world().width(),
                        read.world().height(),
                        read.world().length()))
                .containsExactly(2 * (4 + 2.0), 2 * (8 + 2.0), 2 * (3 + 2.0));
        Files.writeString(file, "v 0 0 0\nf 1 1 1\n");
        assertThat(WorldReader.read(file).width()).isEqualTo(2);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "map.pgm| a map is read from its .yaml file, which gives the size of a cell",
                "map.PNG| a map is read from its .yaml",
                "robot.urdf|1:1: this is not well-formed XML",
                "robot.xacro| macros are not carried out; run the file through xacro first: xacro robot.xacro > NEW.urdf",
                "world.sdf.gz| files of this format are not supported; unpack this one",
                "model.fbx| files of this format are not supported",
                "mesh.dae|1:1: this is not well-formed XML",
                "notes.txt|1:1: this is not well-formed XML",
                "empty.sdf|1:1: this is not well-formed XML",
                "model.config|1:1: this is not well-formed XML",
                "map.yml| a map must consist of keys with values",
                "mesh.obj| an OBJ file must have at least one face",
                "mesh.stl| an STL file must"
            })
    void otherFilesAreRefusedByName(String line) throws IOException {
        String name = line.substring(0, line.indexOf('|'));
        Path file = Files.writeString(folder.resolve(name), name.equals("notes.txt") ? "Buy milk." : "");
        assertThatThrownBy(() -> WorldReader.read(file))
                .isInstanceOf(WorldException.class)
                .hasMessageStartingWith(file + ":" + line.substring(line.indexOf('|') + 1));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "# a world\ninclude \"map.inc\"\n",
                "define floorplan model\n(\n  color \"gray30\"\n)\n",
                "interval_sim 100  # milliseconds\n",
                "resolution 0.02\n",
                "floorplan( name \"cave\" bitmap \"cave.png\" )\n"
            })
    void aWorldOfStageIsToldByItsName(String text) throws IOException {
        Path file = Files.writeString(folder.resolve("simple.sdf"), text);
        assertThatThrownBy(() -> WorldReader.read(file))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("this is a world of Stage; give it a name that ends in .world (got: simple.sdf)");
    }

    @Test
    void aMissingFileOfAnyFormat() {
        for (String name : List.of("no.sdf", "no.world", "no.yaml", "no.obj", "no.stl", "no.dae", "no.xml", "no")) {
            assertThatThrownBy(() -> WorldReader.read(folder.resolve(name)))
                    .hasMessage(folder.resolve(name) + ": there is no such file; check the path");
        }
    }

    @Test
    void badOptionsAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ImportOptions(0, 1, ImportOptions.Up.Y, List.of()))
                .withMessage("the walls' height must be above 0 and at most 2^100 (got: 0.0)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ImportOptions(2, Double.NaN, ImportOptions.Up.Y, List.of()))
                .withMessage("scale must be a number above 0, up to 2^100 (got: NaN)");
    }

    @Test
    void theAccountInLines() throws IOException {
        WorldImport read = WorldImport.read(FILES.resolve("sdf/shapes.sdf"), ImportOptions.DEFAULT);
        assertThat(read.lines(2))
                .hasSize(5)
                .startsWith(
                        "Read SDFormat: box 1, capsule 1, collision 7, cone 1, cylinder 1, ellipsoid 1, link 7, model 7,"
                                + " plane 1, sphere 1",
                        "Ignored, as irrelevant to solid geometry: inertial 6, light 1, scene 1, visual 7")
                .last()
                .isEqualTo("... and 1 more");
        assertThat(read.lines(2).get(2))
                .startsWith(FILES.resolve("sdf/shapes.sdf")
                        + ":36: <plane> of ground_plane::link::collision is infinite ground, ");
    }

    /** A package for Gazebo has its models beside its worlds. */
    @Test
    void modelsBesideWorldsAreFound() throws IOException {
        Path world = Files.createDirectories(folder.resolve("worlds")).resolve("w.world");
        Files.writeString(
                world,
                "<sdf version='1.7'><world name='w'><include><uri>model://inner_walls</uri></include></world></sdf>");
        Path model = Files.createDirectories(folder.resolve("models/inner_walls"));
        for (String name : List.of("model.config", "model.sdf")) {
            Files.copy(FILES.resolve("sdf/inner_walls").resolve(name), model.resolve(name));
        }
        WorldImport read = WorldImport.read(world, ImportOptions.DEFAULT);
        assertThat(read.isWhole()).isTrue();
        assertThat(read.world().objects()).hasSize(7);
        assertThat(read.read()).containsEntry("model", 1);
        // Only beside a folder of that name: of any other file the folders around it are not opened.
        Path other = Files.createDirectories(folder.resolve("arenas")).resolve("w.world");
        Files.copy(world, other);
        assertThatThrownBy(() -> WorldImport.read(other, ImportOptions.DEFAULT))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("there is no such file or folder below "
                        + other.toRealPath().getParent());
    }

    /** Eighty models that are not found have one reason and one remedy. */
    @Test
    void partsLeftOutForTheSameReasonShareALine() throws IOException {
        StringBuilder includes = new StringBuilder();
        for (int k = 0; k < 80; k++) {
            includes.append("<include><uri>model://chair_").append(k).append("</uri></include>\n");
        }
        Path file = Files.writeString(
                folder.resolve("w.sdf"), "<sdf version='1.7'><world name='w'>" + includes + "</world></sdf>");
        assertThatThrownBy(() -> WorldImport.read(file, ImportOptions.DEFAULT))
                .isInstanceOf(WorldException.class)
                .message()
                .containsOnlyOnce("--models DIR")
                .contains(":1: left out <include> of model://chair_0, <include> of model://chair_1, <include> of"
                        + " model://chair_2 and 77 more: there is no such file or folder below ")
                .hasSizeLessThan(700);
        Path box = Files.writeString(
                folder.resolve("b.sdf"),
                Files.readString(file)
                        .replace(
                                "<world name='w'>",
                                "<world name='w'><model name='m'><static>1</static><link name='l'><collision name='c'>"
                                        + "<geometry><box><size>1 1 1</size></box></geometry></collision></link></model>"));
        WorldImport read = WorldImport.read(box, ImportOptions.DEFAULT);
        assertThat(read.skipped()).hasSize(80);
        assertThat(read.lines(10)).hasSize(2).last().asString().contains(" and 77 more: ");
        assertThat(read.lines(Integer.MAX_VALUE)).hasSize(81);
    }

    /** Bounds of turned things, against their surfaces as triangles: never less, and hardly more. */
    @Test
    void boundsAreThoseOfTheTriangles() throws IOException {
        for (String name : List.of("cylinders", "meshes", "rooms")) {
            World world = WorldReader.read(Path.of("worlds", name + ".xml"));
            Path triangles = folder.resolve(name + ".obj");
            WorldWriter.writeObj(world, triangles, done -> {});
            double[] least = {9e9, 9e9, 9e9};
            double[] most = {-9e9, -9e9, -9e9};
            for (Point vertex : WorldReader.readMesh(triangles).vertices()) {
                double[] at = {vertex.x(), vertex.y(), vertex.z()};
                for (int axis = 0; axis < 3; axis++) {
                    least[axis] = Math.min(least[axis], at[axis]);
                    most[axis] = Math.max(most[axis], at[axis]);
                }
            }
            Bounds all = world.objects().stream()
                    .map(each -> each.object().bounds())
                    .reduce(Bounds::and)
                    .orElseThrow();
            double[] bounds = {all.minX(), all.minY(), all.minZ(), all.maxX(), all.maxY(), all.maxZ()};
            for (int axis = 0; axis < 3; axis++) {
                assertThat(bounds[axis]).isBetween(least[axis] - 0.02, least[axis] + 1e-12);
                assertThat(bounds[3 + axis]).isBetween(most[axis] - 1e-12, most[axis] + 0.02);
            }
        }
    }
}
