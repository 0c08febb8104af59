package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Models of Fuel, from a folder like the one in which Gazebo keeps what it has downloaded. */
class FuelModelsTest {
    private static final String SERVER = "fuel/fuel.gazebosim.org/";

    @TempDir
    Path folder;

    private Path file(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    private static String model(String geometry) {
        return "<sdf version='1.6'><model name='Big Shelf'><link name='l'><collision name='c'><geometry>" + geometry
                + "</geometry></collision></link></model></sdf>";
    }

    private static String ball(int radius) {
        return model("<sphere><radius>" + radius + "</radius></sphere>");
    }

    @BeforeEach
    void download() throws IOException {
        for (int version : new int[] {2, 9, 10}) {
            file(SERVER + "movai/models/big shelf/" + version + "/model.config", "<model><sdf>model.sdf</sdf></model>");
            file(SERVER + "movai/models/big shelf/" + version + "/model.sdf", ball(version));
        }
        file(SERVER + "movai/models/big shelf/10 (copy)/model.sdf", ball(11));
        file("fuel/fuel.ignitionrobotics.org/old/models/desk/1/model.sdf", ball(1));
        file(SERVER + "movai/models/table/1/meshes/t.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
        file(
                SERVER + "movai/models/table/1/model.sdf",
                model("<mesh><uri>model://Any Table/meshes/t.obj</uri></mesh>"));
        file(
                SERVER + "movai/models/stool/3/model.sdf",
                model(
                        "<mesh><uri>https://fuel.gazebosim.org/1.0/MovAi/models/Table/1/files/meshes/t.obj</uri></mesh>"));
    }

    private WorldImport read(String include, boolean hasCache) throws IOException {
        Path world = file(
                "w/a.sdf",
                "<sdf version='1.6'><world name='w'>\n<include><uri>" + include + "</uri></include></world></sdf>");
        return SdfReader.read(world, hasCache ? List.of(folder.resolve("fuel")) : List.of());
    }

    @ParameterizedTest
    @CsvSource({
        "https://fuel.gazebosim.org/1.0/MovAi/models/Big Shelf,10",
        "https://fuel.gazebosim.org/1.0/MovAi/models/Big%20Shelf/,10",
        "https://fuel.gazebosim.org/MovAi/models/big shelf/tip,10",
        "https://fuel.gazebosim.org/1.0/MovAi/models/Big Shelf/9,9",
        "https://fuel.ignitionrobotics.org/1.0/MovAi/models/Big Shelf/2,2",
        "http://FUEL.gazebosim.org/1.0/Old/models/Desk,1"
    })
    void theNewestVersionUnlessOneIsNamed(String address, double radius) throws IOException {
        WorldImport read = read(address, true);
        assertThat(read.isWhole()).isTrue();
        assertThat(read.world().objects().get(0).object().bounds().maxX()).isEqualTo(radius);
    }

    @Test
    void meshesOfAModel() throws IOException {
        for (String name : List.of("Table", "Stool")) {
            WorldImport read = read("https://fuel.gazebosim.org/1.0/MovAi/models/" + name, true);
            assertThat(read.skipped()).isEmpty();
            assertThat(read.world().objects().get(0).object().bounds().maxX()).isEqualTo(1);
        }
        // Directly in a world, too.
        Path world = file(
                "w/b.sdf",
                model("<mesh><uri>https://fuel.gazebosim.org/1.0/MovAi/models/Table/1/files/meshes/t.obj"
                        + "</uri><scale>2 1 1</scale></mesh>"));
        assertThat(SdfReader.read(world, List.of(folder.resolve("fuel")))
                        .world()
                        .objects()
                        .get(0)
                        .object()
                        .bounds()
                        .maxX())
                .isEqualTo(2);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "https://fuel.gazebosim.org/1.0/MovAi/models/Sofa|true|Gazebo has not downloaded it to",
                "https://fuel.gazebosim.org/1.0/MovAi/models/Big Shelf/3|true|/models/Big Shelf/3\"",
                "https://fuel.gazebosim.org/1.0/MovAi/models/Big Shelf|false|such as ~/.gz/fuel; give it with --models",
                "https://fuel.gazebosim.org/1.0/../models/..|true|Gazebo has not downloaded it",
                "https://example.com/a.sdf|true|download the model, write model://NAME",
                "https://fuel.gazebosim.org/1.0/MovAi/worlds/Hall|true|network addresses are not followed"
            })
    void whatIsNotThere(String address, boolean hasCache, String message) throws IOException {
        WorldImport read = read(address, hasCache);
        assertThat(read.world().objects()).isEmpty();
        assertThat(read.skipped()).singleElement().satisfies(each -> {
            assertThat(each.line()).isEqualTo(2);
            assertThat(each.reason()).contains("network addresses are not followed", message);
        });
        assertThat(read("https://fuel.gazebosim.org/1.0/MovAi/models/Sofa", true)
                        .skipped()
                        .get(0)
                        .reason())
                .endsWith("download it: gz fuel download -u \"https://fuel.gazebosim.org/1.0/MovAi/models/Sofa\"");
    }

    @Test
    void noFileOutsideTheModelIsRead() throws IOException {
        file("fuel/secret.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
        Path world = file(
                "w/c.sdf",
                model("<mesh><uri>https://fuel.gazebosim.org/1.0/MovAi/models/Table/1/files/../../../../../secret.obj"
                        + "</uri></mesh>"));
        WorldImport read = SdfReader.read(world, List.of(folder.resolve("fuel")));
        assertThat(read.skipped()).hasSize(1);
        assertThat(read.world().objects()).isEmpty();
    }

    @Test
    void sunAndGroundWithAVersion() throws IOException {
        WorldImport read = read("https://fuel.gazebosim.org/1.0/OpenRobotics/models/Ground Plane/4", true);
        assertThat(read.isWhole()).isTrue();
        assertThat(read.remarks()).singleElement().asString().contains("is infinite ground");
    }
}
