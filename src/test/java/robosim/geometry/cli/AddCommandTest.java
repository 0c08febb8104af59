package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Geometry;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.SonarRing;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;
import robosim.geometry.world.WorldWriter;

@Timeout(60)
class AddCommandTest extends CommandRun {
    private Path map() throws IOException {
        StringBuilder pixels = new StringBuilder("P2 40 40 255");
        for (int k = 0; k < 1600; k++) {
            pixels.append(k % 40 == 30 ? " 0" : " 254");
        }
        Files.writeString(folder.resolve("map.pgm"), pixels);
        return Files.writeString(folder.resolve("map.yaml"), """
                image: map.pgm
                resolution: 0.25
                origin: [-2, -3, 0]
                negate: 0
                occupied_thresh: 0.65
                free_thresh: 0.196
                """);
    }

    private static GeometryObject last(World world) {
        return world.objects().get(world.objects().size() - 1).object();
    }

    @Test
    void aRobotStandsOnAMap() throws IOException {
        Path xml = folder.resolve("world.xml");
        assertThat(run("convert", map(), xml, "--robot", "disc:0.3@1,2")).isEqualTo(ExitCodes.FINE);
        World world = WorldReader.read(xml);
        CylinderObject robot = (CylinderObject) last(world);
        assertThat(robot.name()).isEqualTo("robot");
        assertThat(robot.isMoveable()).isTrue();
        assertThat(robot.center().x()).isEqualTo(1);
        assertThat(robot.center().z()).isEqualTo(2);
        assertThat(robot.radius()).isEqualTo(0.3);
        // On the floor, at half the height of the walls below the middle.
        assertThat(robot.center().y() - robot.height() / 2).isBetween(-1.0, -0.98);
        Geometry geometry = world.toGeometry();
        assertThat(geometry.simpleMove("robot", 1, 0, 0)).isTrue();
        assertThat(geometry.simpleMove("robot", 10, 0, 0)).isFalse();
    }

    @Test
    void addKeepsTheTextOfAWorld() throws IOException {
        Path in = Files.writeString(
                folder.resolve("in.xml"),
                "<!-- mine -->\n<world xmlns=\"urn:robosim:world:1\" width=\"20\" height=\"4\" length=\"20\">\n"
                        + "  <box name=\"robot\" center=\"5 -1 0\" width=\"1\" height=\"2\" length=\"1\"/> <!-- a name -->\n"
                        + "</world>\n");
        Path xml = folder.resolve("out.xml");
        assertThat(run("add", in, xml, "disc:0.3x0.5@1,2,90", "cart=box:0.6x0.4x0.2@-3,0", "--sonars", "8"))
                .isEqualTo(ExitCodes.FINE);
        assertThat(Files.readString(xml)).startsWith(Files.readString(in).replace("</world>\n", ""));
        World world = WorldReader.read(xml);
        assertThat(world.objects()).hasSize(3);
        WorldObject disc = world.objects().get(1);
        assertThat(disc.object().name()).isEqualTo("robot 2");
        assertThat(disc.object().heading()).isEqualTo(90);
        assertThat(disc.sonars()).singleElement().isEqualTo(new SonarRing(8, 0, 6, 15));
        BoxObject cart = (BoxObject) last(world);
        assertThat(new double[] {cart.width(), cart.height(), cart.length()}).containsExactly(0.6, 0.2, 0.4);
        assertThat(cart.name()).isEqualTo("cart");
        assertThat(out.toString()).contains("Added ", "Wrote " + xml);
    }

    @Test
    void itsSonarsReachSixMetresInAnyUnit() throws IOException {
        Path in = Files.writeString(
                folder.resolve("in.xml"),
                "<world xmlns=\"urn:robosim:world:1\" width=\"2000\" height=\"400\" length=\"2000\" unit=\"cm\"/>");
        Path xml = folder.resolve("out.xml");
        assertThat(run("add", in, xml, "disc:30@0,0", "--sonars", "4")).isEqualTo(ExitCodes.FINE);
        assertThat(WorldReader.read(xml).objects().get(0).sonars()).containsExactly(new SonarRing(4, 0, 600, 15));
    }

    /** A colour of its own for each, in the world, in pictures and in what is included. */
    @Test
    void aRobotMayHaveAColour() throws IOException {
        Path xml = folder.resolve("world.xml");
        assertThat(run("add", map(), xml, "disc:0.3@1,2#ff8000", "cart=box:0.6x0.4@-1,-2,90#00Ff7f"))
                .isEqualTo(ExitCodes.FINE);
        World world = WorldReader.read(xml);
        List<WorldObject> all = world.objects();
        assertThat(all.get(all.size() - 2).color()).isEqualTo("#ff8000");
        assertThat(all.get(all.size() - 1).color()).isEqualTo("#00ff7f");
        assertThat(last(world).material().color()).hasToString("#00ff7f");
        assertThat(last(world).heading()).isEqualTo(90);
        Path other = folder.resolve("other.xml");
        assertThat(run("convert", map(), other, "--robot", "disc:0.3@1,2#ff8000"))
                .isEqualTo(ExitCodes.FINE);
        assertThat(last(WorldReader.read(other)).material().color()).hasToString("#ff8000");
        assertThat(run("add", map(), folder.resolve("no.xml"), "disc:0.3@1,2#ff80"))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("[,HEADING][#RRGGBB]");
    }

    @Test
    void addIncludesAMap() throws IOException {
        Path xml = folder.resolve("world.xml");
        assertThat(run("add", map(), xml, "disc:0.3@1,2")).isEqualTo(ExitCodes.FINE);
        assertThat(xml).content().contains("<include file=\"map.yaml\"/>");
        Path whole = folder.resolve("whole.xml");
        assertThat(run("convert", map(), whole, "--robot", "disc:0.3@1,2")).isEqualTo(ExitCodes.FINE);
        assertThat(WorldReader.read(xml)).isEqualTo(WorldReader.read(whole));
    }

    /** An include names only what is below it; elsewhere the new world has all that the map has. */
    @Test
    void theNewWorldMayBeAnywhere() throws IOException {
        Path map = map();
        Path xml = Files.createDirectory(folder.resolve("elsewhere")).resolve("world.xml");
        assertThat(run("add", map, xml, "disc:0.3@1,2")).isEqualTo(ExitCodes.FINE);
        assertThat(out.toString()).contains("Wrote " + xml + ", with a copy of what is in " + map);
        Path whole = folder.resolve("whole.xml");
        assertThat(run("convert", map, whole, "--robot", "disc:0.3@1,2")).isEqualTo(ExitCodes.FINE);
        assertThat(xml).hasSameTextualContentAs(whole);
    }

    /** A mesh is hollow, so nothing touches a robot in a bed, which it can never leave. */
    @Test
    void aRobotInAClosedSurfaceIsWarnedOf() throws IOException {
        Path in = folder.resolve("in.xml");
        MeshObject bed = new MeshObject(
                List.of(new Point(-1, -1, -1), new Point(1, -1, -1), new Point(0, -1, 1), new Point(0, 1, 0)),
                new int[][] {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
        World world = new World(
                20, 4, 20, null, Dimension.SPATIAL, Accuracy.EXACT, List.of(new WorldObject(bed.named("bed"))));
        WorldWriter.write(world, in);
        Path xml = folder.resolve("world.xml");
        for (String command : List.of("add", "convert")) {
            String option = command.equals("add") ? "--sonars=0" : "--robot";
            assertThat(run(command, in, xml, option, "disc:0.1x0.2@0,0")).isEqualTo(ExitCodes.FINE);
            assertThat(err.toString()).contains("warning: \"robot\" is inside the closed surface \"bed\"");
            assertThat(run(command, in, xml, option, "disc:0.1x0.2@2,0")).isEqualTo(ExitCodes.FINE);
            // But there is no floor.
            assertThat(err.toString())
                    .doesNotContain("closed surface")
                    .contains("warning: \"robot\" stands on nothing: where bodies move it falls ");
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "disc:0.3@5.6,2|a robot must stand where nothing is, since what touches cannot move; grid \"map\" is at this place, free nearby is",
                "disc:0.3@500,2|a robot must stand within the world of ",
                "disc:0.3|a robot must be [NAME=]disc:RADIUS[xHEIGHT]@X,Z[,HEADING][#RRGGBB] or ",
                "disc:1x2x3@1,2|a robot must be ",
                "box:1@1,2|a robot must be ",
                "map=disc:0.3@1,2|a robot must have a name of its own (got twice: map)",
                "disc:-1@1,2|the sizes of a robot must be above 0 (got: disc:-1@1,2)",
            })
    void refusesWithTheRemedy(String robot, String message) throws IOException {
        Path xml = folder.resolve("world.xml");
        assertThat(run("add", map(), xml, robot)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains(message);
        assertThat(xml).doesNotExist();
    }

    /** What the message proposes can be typed, is free and near. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "scout=disc:0.3x0.5@0.25,-1,30#ff8000|scout=disc:0.3x0.5@0.9,-1,30#ff8000",
                "box:0.4x0.2@0,0|box:0.4x0.2@-0.8,0",
                "disc:0.3@9.6,2|disc:0.3@9.6,1.6",
            })
    void proposesAFreePlace(String robot, String proposed) throws IOException {
        Path in = Files.writeString(
                folder.resolve("in.xml"),
                "<world xmlns=\"urn:robosim:world:1\" width=\"20\" height=\"4\" length=\"20\">"
                        + "<box name=\"crate\" center=\"0 0 0\" width=\"1\" height=\"4\" length=\"9\"/>"
                        + "<box center=\"9.5 0 4\" width=\"1\" height=\"4\" length=\"4\"/></world>");
        Path xml = folder.resolve("out.xml");
        assertThat(run("add", in, xml, robot)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString())
                .contains(
                        robot.contains("9.6")
                                ? "; box without a name is at this place, "
                                : "; box \"crate\" is at this")
                .contains("free nearby is " + proposed + " (got: " + robot + ")");
        assertThat(run("add", in, xml, proposed)).as(err.toString()).isEqualTo(ExitCodes.FINE);
    }

    @Test
    void saysWhereNoPlaceIsFree() throws IOException {
        Path in = Files.writeString(
                folder.resolve("in.xml"),
                "<world xmlns=\"urn:robosim:world:1\" width=\"20\" height=\"4\" length=\"20\">"
                        + "<box name=\"rock\" center=\"0 0 0\" width=\"19.8\" height=\"4\" length=\"19.8\"/></world>");
        assertThat(run("add", in, folder.resolve("out.xml"), "disc:0.3@0,0")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("box \"rock\" is at this place, and none nearby has room for it");
    }

    @Test
    void doesNotOverwriteItsInput() throws IOException {
        Path in = Files.writeString(
                folder.resolve("in.xml"),
                "<world xmlns=\"urn:robosim:world:1\" width=\"20\" height=\"4\" length=\"20\"></world>");
        assertThat(run("add", in, in, "disc:0.3@1,2")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("OUT must not be a file that is read");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "disc:0@1,1",
                "disc:-0@1,1",
                "disc:-1@1,1",
                "disc:0x10@1,1",
                "disc:1x0@1,1",
                "box:0x1@1,1",
                "box:1x0@1,1"
            })
    void aRobotWithoutASizeIsRefused(String robot) throws IOException {
        assertThat(run("add", map(), folder.resolve("w.xml"), robot)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("the sizes of a robot must be above 0 (got: " + robot + ")");
        assertThat(folder.resolve("w.xml")).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource({"-1", "10001"})
    void sonarsAreToldByTheOption(int count) throws IOException {
        assertThat(run("add", map(), folder.resolve("w.xml"), "disc:0.2@0,0", "--sonars", count))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("--sonars must be from 0 to 10000 (got: " + count + ")");
    }
}
