package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.world.check.WorldCheck;

/** The infinite ground of Gazebo's worlds, which is a floor here. */
class FloorTest {
    private static final String MODEL = "<model name='ground'><static>1</static><pose>%s</pose><link name='l'>"
            + "<collision name='c'><geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link></model>";
    private static final String REST = """
            <model name='wall'><static>1</static><pose>2 1 0.5 0 0 0</pose><link name='l'><collision name='c'><geometry>
            <box><size>0.1 4 1</size></box></geometry></collision></link></model>
            <model name='robot'><pose>0 0 0.1 0 0 0</pose><link name='l'><collision name='c'><geometry>
            <cylinder><radius>0.2</radius><length>0.2</length></cylinder></geometry></collision></link></model>
            """;

    @TempDir
    Path folder;

    private WorldImport read(String ground) throws IOException {
        Path file = folder.resolve("lab.sdf");
        Files.writeString(file, "<sdf version='1.6'><world name='w'>" + ground + REST + "</world></sdf>");
        return WorldImport.read(file, ImportOptions.DEFAULT);
    }

    private World including(String attributes, String include) throws IOException {
        return WorldReader.read(Files.writeString(
                folder.resolve("world.xml"),
                "<world xmlns=\"urn:robosim:world:1\" " + attributes + " unit=\"m\"><include file=\"lab.sdf\" "
                        + include + "/></world>"));
    }

    private static GeometryObject object(World world, String name) {
        return world.objects().stream()
                .map(WorldObject::object)
                .filter(each -> name.equals(each.name()))
                .findFirst()
                .orElseThrow();
    }

    private static List<String> names(World world) {
        return world.objects().stream()
                .map(each -> String.valueOf(each.object().name()))
                .toList();
    }

    private static double top(World world, double x, double z) {
        Ray ray = new Ray(new Point(x, world.height() / 2, z), new Point(0, -1, 0));
        return world.height() / 2 - world.toGeometry().getRayDistance(ray, 0, Double.POSITIVE_INFINITY, 0);
    }

    /** Whether its own model is there, or one that comes with Gazebo and is not. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "<include><uri>model://ground_plane</uri></include>",
                "<include><uri>https://fuel.gazebosim.org/1.0/OpenRobotics/models/Ground Plane</uri></include>",
                "<model name='ground'><static>1</static><link name='l'><collision name='c'><geometry><plane/></geometry>"
                        + "</collision></link></model>",
                "<model name='ground'><link name='l'><collision name='c'><geometry><plane/></geometry></collision></link></model>"
            })
    void robotsStandAndDriveOnIt(String ground) throws IOException {
        WorldImport read = read(ground);
        assertThat(read.isWhole()).isTrue();
        World world = read.world();
        assertThat(world.dimension()).isEqualTo(Dimension.SPATIAL);
        for (double x : new double[] {-world.width() / 2, -1, 1, world.width() / 2}) {
            assertThat(top(world, x, world.length() / 2)).isZero();
        }
        Geometry geometry = world.toGeometry();
        assertThat(geometry.moveGlobal("robot", new Move(0, -0.001, 0, 0, 0)).fraction())
                .isZero();
        assertThat(geometry.simpleMove("robot", 1, 0, 0)).isTrue();
        assertThat(geometry.simpleMove("robot", 1, 0, 0))
                .as("there is the wall")
                .isFalse();
        WorldCheck check = WorldCheck.of(world);
        assertThat(check.isFine()).isTrue();
        assertThat(check.rooms().get(0).places()).isGreaterThan(100);
        assertThat(WorldCheck.falls(world)).isEmpty();
    }

    @Test
    void itsHeightIsThatOfThePlane() throws IOException {
        assertThat(top(read(MODEL.formatted("7 8 -0.5 0 0 1")).world(), 1, 1)).isEqualTo(-0.5);
        World two = read(MODEL.formatted("0 0 -0.25 0 0 0")
                        + MODEL.replace("'ground'", "'deep'").formatted("0 0 -1 0 0 0"))
                .world();
        assertThat(names(two)).containsExactly("ground", "deep", "wall", "robot");
        assertThat(object(two, "deep").bounds().maxY()).isEqualTo(-1);
        String included = "<include><uri>model://ground_plane</uri><pose>3 0 -0.5 0 0 0</pose></include>";
        assertThat(top(read(included).world(), 1, 1)).isEqualTo(-0.5);
    }

    @Test
    void anIncludedOneFillsTheOuterWorld() throws IOException {
        read(MODEL.formatted("0 0 0 0 0 0"));
        Bounds wide = object(including("width=\"40\" height=\"6\" length=\"30\"", ""), "ground")
                .bounds();
        assertThat(List.of(wide.width(), wide.length(), wide.minY(), wide.maxY()))
                .containsExactly(40.0, 30.0, -0.125, 0.0);
        World turned =
                including("width=\"9\" height=\"6\" length=\"9\"", "at=\"0 0.5 0\" heading=\"30\" prefix=\"a \"");
        assertThat(object(turned, "a ground").bounds().width()).isEqualTo(9);
        assertThat(object(turned, "a ground").bounds().maxY()).isEqualTo(0.5);
        turned.toGeometry(); // nothing is outside
        // On the lower border it needs no room of its own, and just above it is thinner.
        assertThat(names(including("width=\"9\" height=\"4\" length=\"9\"", "at=\"0 -2 0\"")))
                .containsExactly("wall", "robot");
        World low = including("width=\"9\" height=\"4\" length=\"9\"", "at=\"0 -1.9375 0\"");
        assertThat(object(low, "ground").bounds().minY()).isEqualTo(-2);
        assertThat(object(low, "ground").bounds().maxY()).isEqualTo(-1.9375);
        low.toGeometry();
        World planar = including("width=\"9\" height=\"4\" length=\"9\" dimension=\"PLANAR\"", "");
        assertThat(names(planar)).containsExactly("wall", "robot");
    }

    @Test
    void withoutOneTheFallIsReported() throws IOException {
        World world = read("").world();
        assertThat(WorldCheck.falls(world)).satisfiesExactly(fall -> {
            assertThat(fall.robot().object().name()).isEqualTo("robot");
            assertThat(fall.drop()).isCloseTo(world.height() / 2, within(1e-9));
        });
        assertThat(WorldCheck.falls(world.planar())).isEmpty();
        assertThat(WorldCheck.of(world).isFine()).isTrue();
    }

    @Test
    void whereHeightsDoNotCountThereIsNone() throws IOException {
        World world = read(MODEL.formatted("0 0 0 0 0 0")).world();
        assertThat(names(world.planar())).containsExactly("wall", "robot");
        assertThat(world.planar().dimension()).isEqualTo(Dimension.PLANAR);
        assertThat(world.planar().toGeometry().simpleMove("robot", 1, 0, 0)).isTrue();
    }
}
