package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

/** World files that include others. */
class IncludeTest {
    @TempDir
    Path folder;

    private Path write(String name, String content) throws IOException {
        Path file = folder.resolve(name);
        Path parent = file.getParent();
        if (parent != null) {
            Files.createDirectories(parent);
        }
        return Files.writeString(file, content);
    }

    private Path world(String name, String... elements) throws IOException {
        return write(
                name,
                "<world xmlns=\"urn:robosim:world:1\" width=\"100\" height=\"20\" length=\"100\" unit=\"m\">\n"
                        + String.join("\n", elements) + "\n</world>");
    }

    private static GeometryObject object(World world, String name) {
        return world.objects().stream()
                .map(WorldObject::object)
                .filter(object -> name.equals(object.name()))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aWorldIsPlacedWithItsPrefix() throws IOException {
        world(
                "parts/table.xml",
                "<box name=\"top\" center=\"1 2 0\" width=\"1\" height=\"1\" length=\"2\" heading=\"30\" color=\"#ff0000\"/>",
                "<cylinder name=\"cart\" moveable=\"true\" center=\"0 0 -3\" radius=\"1\" height=\"1\"><sonar count=\"4\"/></cylinder>",
                "<box width=\"1\" height=\"1\" length=\"1\"/>");
        Path file = world(
                "main.xml",
                "<box name=\"top\" width=\"1\" height=\"1\" length=\"1\"/>",
                "<include file=\"parts/table.xml\" at=\"10 0.5 -20\" heading=\"90\" prefix=\"a/\"/>",
                "<include file=\"parts/table.xml\" prefix=\"b/\"/>");
        World world = WorldReader.read(file);
        assertThat(world.objects()).hasSize(7);
        GeometryObject top = object(world, "a/top");
        // A heading of 90 takes X to -Z.
        assertThat(top.center()).isEqualTo(new Point(10, 2.5, -21));
        assertThat(top.heading()).isEqualTo(120);
        assertThat(object(world, "b/top").center()).isEqualTo(new Point(1, 2, 0));
        GeometryObject cart = object(world, "a/cart");
        assertThat(cart.center()).isEqualTo(new Point(7, 0.5, -20));
        assertThat(cart.isMoveable()).isTrue();
        assertThat(world.objects().get(1).color()).isEqualTo("#ff0000");
        assertThat(world.objects().get(2).sonars()).hasSize(1);
        assertThat(WorldImport.read(file, ImportOptions.DEFAULT).read())
                .containsEntry("included world", 1)
                .containsEntry("object", 7);
        // What was written is the same world, without the other files.
        Path copy = folder.resolve("copy.xml");
        WorldWriter.write(world, copy);
        assertThat(WorldReader.read(copy)).isEqualTo(world);
    }

    /** The same poses by the plain formula. */
    @Test
    void placesAreThoseOfThePlainFormula() throws IOException {
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < 50; k++) {
            double x = random.nextDouble(-5, 5);
            double z = random.nextDouble(-5, 5);
            double heading = random.nextDouble(-180, 180);
            double own = random.nextDouble(-90, 90);
            world(
                    "inner.xml",
                    "<box name=\"upright\" center=\"%s 1 %s\" heading=\"%s\" width=\"1\" height=\"1\" length=\"1\"/>"
                            .formatted(x, z, own),
                    "<box name=\"leaning\" center=\"%s 1 %s\" turned=\"20 %s\" width=\"1\" height=\"1\" length=\"1\"/>"
                            .formatted(x, z, own));
            World world = WorldReader.read(
                    world("outer.xml", "<include file=\"inner.xml\" at=\"3 -2 4\" heading=\"" + heading + "\"/>"));
            World inner = WorldReader.read(folder.resolve("inner.xml"));
            double cos = StrictMath.cos(StrictMath.toRadians(heading));
            double sin = StrictMath.sin(StrictMath.toRadians(heading));
            for (String name : List.of("upright", "leaning")) {
                GeometryObject there = object(world, name);
                assertThat(there.center().x()).isCloseTo(3 + x * cos + z * sin, within(1e-12));
                assertThat(there.center().y()).isEqualTo(-1);
                assertThat(there.center().z()).isCloseTo(4 - x * sin + z * cos, within(1e-12));
                double[] before = object(inner, name).rotation();
                double[] after = there.rotation();
                for (int column = 0; column < 3; column++) {
                    assertThat(after[column]).isCloseTo(cos * before[column] + sin * before[6 + column], within(1e-12));
                    assertThat(after[3 + column]).isCloseTo(before[3 + column], within(1e-12));
                    assertThat(after[6 + column])
                            .isCloseTo(-sin * before[column] + cos * before[6 + column], within(1e-12));
                }
            }
        }
    }

    @Test
    void mapsModelsAndMeshesAreIncluded() throws IOException {
        write("maps/map.pgm", "P2 2 1 1 0 1");
        write("maps/map.yaml", """
                image: map.pgm
                resolution: 0.5
                origin: [0, 0, 0]
                negate: 0
                occupied_thresh: 0.65
                free_thresh: 0.196
                """);
        write("tetra.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        String sdf =
                "<sdf version=\"1.6\"><model name=\"chair\"><static>true</static><link name=\"l\"><collision name=\"c\">"
                        + "<geometry><box><size>1 2 3</size></box></geometry></collision><collision name=\"d\"><geometry>"
                        + "<heightmap><uri>gone.png</uri></heightmap></geometry></collision></link></model></sdf>";
        write("models/chair/model.sdf", sdf);
        write("chair.sdf", sdf);
        Path file = world(
                "main.xml",
                "<include file=\"maps/map.yaml\" at=\"1 0 0\"/>",
                "<include file=\"tetra.obj\" at=\"0 0 5\" heading=\"45\"/>",
                "<include file=\"chair.sdf\" prefix=\"first \"/>",
                "<include file=\"models/chair\" at=\"0 5 0\" prefix=\"second \"/>",
                "<include file=\"models/chair\" at=\"0 8 0\" prefix=\"third \"/>");
        WorldImport read = WorldImport.read(file, ImportOptions.DEFAULT);
        World world = read.world();
        assertThat(object(world, "map")).isInstanceOf(GridObject.class);
        assertThat(object(world, "map").center()).isEqualTo(new Point(1.5, 0, -0.25));
        assertThat(object(world, "tetra")).isInstanceOf(MeshObject.class);
        assertThat(object(world, "second chair").center()).isEqualTo(new Point(0, 5, 0));
        assertThat(world.objects()).hasSize(5 + 1 + 3);
        // What each file leaves out is told once.
        assertThat(read.skipped()).hasSize(2);
        assertThat(read.isWhole()).isFalse();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<include file='main.xml'/>|a world must not include itself; remove one of these (got: main.xml, which includes main.xml)",
                "<include file='a.xml'/>|a world must not include itself; remove one of these (got: main.xml, which includes a.xml, which includes sub/b.xml, which includes a.xml)",
                "<include file='gone.xml'/>|main.xml:2:27: <include>: there is no such file in ",
                "<include file='../x.xml'/>|(got: ../x.xml)",
                "<include file='/etc/passwd'/>|file must be a path with / relative to the world file's folder, and lie below the folder of the world that is read",
                "<include file='inches.xml'/>|an included file must have the unit of the world, m; convert one of them (got: in)",
                "<include file='wrong.xml'/>|wrong.xml:1:",
                "<box name='b' width='1' height='1' length='1'/><include file='good.xml'/>|names must be unique in a world, and one of the file is also in line 2; give a prefix (got twice: b)",
                "<include at='1 2'/>|at of <include> must be three lengths x y z",
                "<include at='1 2 3'/>|<include> needs the attribute file",
                "<group><include file='good.xml'/></group>|<include> is not allowed in <group>",
            })
    void refusesWithPlaceAndRemedy(String element, String message) throws IOException {
        String box = "<box name=\"b\" width=\"1\" height=\"1\" length=\"1\"/>";
        world("a.xml", "<include file=\"sub/b.xml\"/>");
        world("sub/b.xml", "<include file=\"../a.xml\"/>");
        world("good.xml", box);
        write("wrong.xml", "<world/>");
        write(
                "inches.xml",
                "<world xmlns=\"urn:robosim:world:1\" width=\"9\" height=\"9\" length=\"9\" unit=\"in\">" + box
                        + "</world>");
        Path file = world("main.xml", element.replace('\'', '"'));
        assertThatThrownBy(() -> WorldReader.read(file))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("main.xml")
                .hasMessageContaining(message);
        assertThat(WorldReader.problems(file)).isNotEmpty();
    }

    @Test
    void aStreamWithoutAFolderIncludesNothing() throws IOException {
        byte[] bytes = Files.readAllBytes(world("main.xml", "<include file=\"main.xml\"/>"));
        assertThatThrownBy(() -> WorldReader.read(new ByteArrayInputStream(bytes), "here", null))
                .hasMessageContaining("a world from a stream without a folder cannot include files");
    }

    /** Each file doubles the one before: 2^40 objects, of some kilobytes of files. */
    @Test
    void aBombIsRefusedSoon() throws IOException {
        world("0.xml", "<box width=\"1\" height=\"1\" length=\"1\"/>");
        for (int k = 1; k <= 40; k++) {
            String one = "<include file=\"" + (k - 1) + ".xml\"/>";
            world(k + ".xml", one, one);
        }
        assertThatThrownBy(() -> WorldReader.read(folder.resolve("40.xml")))
                .hasMessageContaining(
                        "a world must have at most 200000 objects, included ones too; leave some out, or make one mesh of many (got: more)");
        for (int k = 1; k <= 60; k++) {
            world("c" + k + ".xml", k == 60 ? "" : "<include file=\"c" + (k + 1) + ".xml\"/>");
        }
        assertThatThrownBy(() -> WorldReader.read(folder.resolve("c1.xml")))
                .hasMessageContaining("files must be included at most 50 deep; nest less (got: one more)");
    }

    @Test
    void nothingOutsideTheFolderIsReadEvenThroughALink(@TempDir Path elsewhere) throws IOException {
        Path secret = elsewhere.resolve("secret.xml");
        Files.copy(world("good.xml", "<box width=\"1\" height=\"1\" length=\"1\"/>"), secret);
        Files.createSymbolicLink(folder.resolve("link.xml"), secret);
        Path file = world("main.xml", "<include file=\"link.xml\"/>");
        assertThatThrownBy(() -> WorldReader.read(file))
                .hasMessageContaining("file must be a path with / relative to the world file's folder");
        // A folder of models is one that may be read.
        ImportOptions options = ImportOptions.DEFAULT.withModels(List.of(elsewhere));
        Path other = world("other.xml", "<include file=\"model://secret.xml\"/>");
        assertThat(WorldImport.read(other, options).world().objects()).hasSize(1);
    }
}
