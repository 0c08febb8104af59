package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;

/** The worlds that come with the module. */
class WorldFilesTest {
    private static final Path WORLDS = Path.of("worlds");

    static List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(WORLDS)) {
            return files.filter(file -> file.toString().endsWith(".xml"))
                    .sorted()
                    .toList();
        }
    }

    @Test
    void areAllThere() throws IOException {
        assertThat(files().stream().map(file -> file.getFileName().toString()))
                .contains("rooms.xml", "warehouse.xml", "maze.xml", "hard.xml", "meshes.xml", "cylinders.xml");
    }

    @ParameterizedTest
    @MethodSource("files")
    void readsBackToAnEqualWorld(Path file) throws IOException {
        World world = WorldReader.read(file);
        String xml = WorldWriter.toXml(world);
        Path copy = Files.createTempFile("world", ".xml");
        try {
            Files.writeString(copy, xml);
            assertThat(WorldReader.read(copy)).isEqualTo(world);
        } finally {
            Files.delete(copy);
        }
    }

    @ParameterizedTest
    @MethodSource("files")
    void opensWithWhatItShows(Path file) throws IOException {
        assertThat(Files.readString(file)).matches("(?s)<\\?xml [^>]*\\?>\\n<!--\\n.{80,}?-->\\n<world .*");
    }

    @ParameterizedTest
    @MethodSource("files")
    void holdsAllItsObjectsAndItsRobotsTouchNothing(Path file) throws IOException {
        World world = WorldReader.read(file);
        Geometry geometry = world.toGeometry();
        List<GeometryObject> robots = new ArrayList<>();
        for (WorldObject object : world.objects()) {
            if (object.object().isMoveable()) {
                robots.add(object.object());
                assertThat(object.sonars()).as("sonars of %s", object.object()).isNotEmpty();
            }
        }
        assertThat(robots).hasSizeGreaterThanOrEqualTo(2);
        for (GeometryObject robot : robots) {
            String name = Objects.requireNonNull(robot.name());
            assertThat(geometry.testObject(robot))
                    .as("%s where it stands itself", robot)
                    .isTrue();
            assertThat(geometry.removeObject(name)).isTrue();
            assertThat(geometry.testObject(robot)).as("%s at its start", robot).isFalse();
            assertThat(geometry.addObject(robot)).isTrue();
        }
        assertThat(geometry.objects()).hasSameSizeAs(world.objects());
    }

    @Test
    void roomsIsWhatTheDemonstrationNeeds() throws IOException {
        World rooms = WorldReader.read(WORLDS.resolve("rooms.xml"));
        assertThat(rooms.width()).isEqualTo(40);
        assertThat(rooms.length()).isEqualTo(30);
        assertThat(rooms.objects().stream().filter(object -> object.object().isMoveable()))
                .hasSize(8);
    }

    @Test
    void warehouseHasHundredsOfObjects() throws IOException {
        List<WorldObject> objects =
                WorldReader.read(WORLDS.resolve("warehouse.xml")).objects();
        assertThat(objects.stream().filter(object -> !object.object().isMoveable()))
                .hasSizeGreaterThan(400);
        assertThat(objects.stream().filter(object -> object.object().kind() == GeometryObject.Kind.GROUP))
                .hasSizeGreaterThan(250);
        assertThat(objects.stream().filter(object -> object.object().isMoveable()))
                .hasSize(20);
    }

    @Test
    void theHerdSharesItsTriangles() throws IOException {
        List<MeshObject> cows = WorldReader.read(WORLDS.resolve("meshes.xml")).objects().stream()
                .map(WorldObject::object)
                .filter(object -> object.name() != null && object.name().startsWith("cow"))
                .map(MeshObject.class::cast)
                .toList();
        assertThat(cows).hasSize(4);
        assertThat(cows.get(0).triangles().size()).isEqualTo(5856);
        assertThat(cows.get(1).triangles()).isSameAs(cows.get(0).triangles());
    }

    @Test
    void theExampleOfTheFormatsPageIsOne() throws IOException {
        String page = Files.readString(Path.of("docs/world-format.md"));
        int begin = page.indexOf("<?xml");
        String example = page.substring(begin, page.indexOf("```", begin));
        World world = WorldReader.read(
                new ByteArrayInputStream(example.getBytes(StandardCharsets.UTF_8)), "world-format.md", WORLDS);
        assertThat(world.objects()).hasSize(6);
        assertThat(world.toGeometry().objects()).hasSize(6);
    }

    @Test
    void theSchemaInTheJarIsThePublishedOne() throws IOException {
        try (InputStream in = Objects.requireNonNull(World.class.getResourceAsStream("world.xsd"))) {
            assertThat(in.readAllBytes()).isEqualTo(Files.readAllBytes(WORLDS.resolve("world.xsd")));
        }
    }
}
