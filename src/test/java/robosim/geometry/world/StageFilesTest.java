package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Geometry;
import robosim.geometry.image.PngWriter;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** Worlds of Stage. */
class StageFilesTest {
    @TempDir
    Path folder;

    private WorldImport imported(String text) throws IOException {
        return WorldImport.read(
                Files.writeString(folder.resolve("w.world"), "resolution 0.02\n" + text), ImportOptions.DEFAULT);
    }

    private World read(String text) throws IOException {
        WorldImport read = imported(text);
        assertThat(read.skipped()).isEmpty();
        assertThat(read.format()).isEqualTo("Stage");
        return read.world();
    }

    private static GeometryObject object(World world, String name) {
        return world.objects().stream()
                .map(WorldObject::object)
                .filter(each -> name.equals(each.name()))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aModelIsABoxOfItsSize() throws IOException {
        World world = read("model( name \"crate\" size [2 4 1] pose [10 20 0.5 90] ) # a comment\nmodel ( )\n");
        BoxObject crate = (BoxObject) object(world, "crate");
        assertThat(crate.center()).isEqualTo(new Point(10, 1, -20));
        assertThat(new double[] {crate.width(), crate.height(), crate.length()}).containsExactly(2, 1, 4);
        assertThat(crate.isMoveable()).isFalse();
        Geometry geometry = world.toGeometry();
        assertThat(geometry.getRayDistance(new Ray(new Point(0, 1, -20), new Point(1, 0, 0)), 0, 50, 0))
                .as("turned by 90 degrees, it is 4 wide")
                .isCloseTo(8, within(1e-12));
        assertThat(object(world, "model").bounds().maxX()).isCloseTo(.05, within(1e-12));
        assertThat(world.unit()).isEqualTo(Unit.METRE);
    }

    @Test
    void whatIsDefinedIsExpandedAndReplaced() throws IOException {
        Files.writeString(
                folder.resolve("a.inc"), "include \"b.inc\"\ndefine wide low ( size [9 1 1] model( size [1 1 1] ) )\n");
        Files.writeString(folder.resolve("b.inc"), "define low model\n(\n  size [1 1 .5]\n color \"red\"\n)\n");
        World world =
                read("include \"a.inc\"\nwide( name \"w\" )\nwide( name \"v\" size [3 1 1] )\nlow( name \"l\" )\n");
        ObjectGroup wide = (ObjectGroup) object(world, "w");
        assertThat(wide.members()).hasSize(2);
        assertThat(wide.bounds().maxX()).isCloseTo(4.5, within(1e-12));
        assertThat(wide.bounds().maxY()).as("a child is on top of its parent").isCloseTo(2, within(1e-12));
        assertThat(object(world, "v").bounds().maxX()).isCloseTo(1.5, within(1e-12));
        assertThat(object(world, "l").bounds().maxY()).isCloseTo(.5, within(1e-12));
    }

    /** Dark pixels, stretched until their bounds are the size, against the image itself. */
    @Test
    void aFloorplansDarkPixelsAreSolid() throws IOException {
        SplittableRandom random = new SplittableRandom(22_005);
        int width = 23;
        int height = 17;
        byte[] pixels = new byte[width * height];
        int[] bounds = {width, height, 0, 0};
        for (int k = 0; k < pixels.length; k++) {
            boolean isInside = k % width > 2 && k % width < 20 && k / width > 1 && k / width < 12;
            pixels[k] = (byte) (isInside && random.nextInt(3) == 0 ? random.nextInt(128) : 128 + random.nextInt(128));
            if ((pixels[k] & 0xff) < 128) {
                bounds[0] = Math.min(bounds[0], k % width);
                bounds[1] = Math.min(bounds[1], k / width);
                bounds[2] = Math.max(bounds[2], k % width + 1);
                bounds[3] = Math.max(bounds[3], k / width + 1);
            }
        }
        try (OutputStream out = Files.newOutputStream(folder.resolve("plan.png"))) {
            PngWriter.writeGrey(out, width, height, pixels);
        }
        Geometry geometry = read("model( name \"plan\" size [8 6 2] pose [1 2 0 0] bitmap \"plan.png\" )\n")
                .toGeometry();
        int solid = 0;
        for (int k = 0; k < pixels.length; k++) {
            double x = 1 + 8 * ((k % width + .5 - bounds[0]) / (bounds[2] - bounds[0]) - .5);
            double y = 2 + 6 * (.5 - (k / width + .5 - bounds[1]) / (bounds[3] - bounds[1]));
            boolean isDark = (pixels[k] & 0xff) < 128;
            solid += isDark ? 1 : 0;
            // From above: on a pixel that is solid a ray stops at the height of the plan.
            double found = geometry.getRayDistance(new Ray(new Point(x, 2.5, -y), new Point(0, -1, 0)), 0, 2.4, 0);
            assertThat(found).as("pixel %d", k).isCloseTo(isDark ? .5 : Double.POSITIVE_INFINITY, within(1e-9));
        }
        assertThat(solid).isBetween(30, 100);
    }

    @Test
    void aBoundaryIsFourThinWalls() throws IOException {
        World world = read("model( name \"b\" size [8 6 2] boundary 1 noblocks 1 )\n");
        Geometry geometry = world.toGeometry();
        Ray east = new Ray(new Point(0, 1, 0), new Point(1, 0, 0));
        Ray north = new Ray(new Point(0, 1, 0), new Point(0, 0, -1));
        assertThat(geometry.getRayDistance(east, 0, 50, 0)).isCloseTo(3.99, within(1e-12));
        assertThat(geometry.getRayDistance(north, 0, 50, 0)).isCloseTo(2.99, within(1e-12));
    }

    @Test
    void blocksAreStretchedToTheSize() throws IOException {
        World world = read("model( name \"roof\" size [4 2 3] block( points 3 point[0] [0 0] point[1] [10 0]\n"
                + "point[2] [0 1] z [0 1] ) )\n");
        MeshObject roof = (MeshObject) object(world, "roof");
        assertThat(roof.isSolid()).isTrue();
        assertThat(roof.vertices())
                .containsExactly(
                        new Point(-2, 0, 1),
                        new Point(2, 0, 1),
                        new Point(-2, 0, -1),
                        new Point(-2, 3, 1),
                        new Point(2, 3, 1),
                        new Point(-2, 3, -1));
    }

    @Test
    void aPositionIsARobotWithItsSensors() throws IOException {
        WorldImport read = imported("define eye sensor( range [0.1 4] fov 20 samples 1 )\n"
                + "position( name \"r\" size [.4 .4 .2] pose [1 2 0 30] drive \"diff\"\n"
                + "ranger( eye( pose [0.1 0 0 90] ) eye( pose [0 0 0 -90] ) )\n"
                + "ranger( pose [0 0 0 180] sensor( range [0 8] fov 180 samples 181 ) ) ctrl \"wander\" )\n");
        WorldObject robot = read.world().objects().get(0);
        assertThat(robot.object()).isInstanceOf(BoxObject.class);
        assertThat(robot.object().isMoveable()).isTrue();
        assertThat(robot.object().center())
                .as("its sensors are not on the ground")
                .isEqualTo(new Point(1, .1, -2));
        assertThat(robot.sonars())
                .containsExactly(
                        new SonarRing(1, 90, 0, .1, 4, 20),
                        new SonarRing(1, -90, 0, .1, 4, 20),
                        new SonarRing(181, 90, 1, 0, 8, 0));
        assertThat(read.remarks().toString()).contains("w.world:3: the range sensors of r are at its centre here; in");
    }

    @Test
    void sonarsAndLasersOfStage3() throws IOException {
        World world = read("position( size [1 1 1] ranger( scount 2 spose[0] [.1 0 30] spose[1] [.1 0 -30]\n"
                + "sview [0 5 15] ) laser( range_max 8 fov 180 samples 361 ) )\n");
        assertThat(world.objects().get(0).sonars())
                .containsExactly(
                        new SonarRing(1, 30, 0, 0, 5, 15),
                        new SonarRing(1, -30, 0, 0, 5, 15),
                        new SonarRing(361, -90, .5, 0, 8, 0));
    }

    @Test
    void whatNothingMeetsIsNoObject() throws IOException {
        WorldImport read = imported("model( name \"zone\" size [4 4 .01] obstacle_return 0 ranger_return -1 )\n"
                + "model( name \"wall\" obstacle_return 0 )\nwindow( size [600 600] )\n");
        assertThat(read.world().objects()).hasSize(1);
        assertThat(read.passedOver()).containsKeys("body that is no obstacle", "window");
        assertThat(read.remarks().toString())
                .contains("w.world:3: model \"wall\" is solid here; in Stage robots drive");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "pioneer( name \"p\" ) | w.world:2: left out pioneer \"p\": there is no such model; define it before, or",
                "include \"gone.inc\" | w.world:2: left out include of gone.inc: there is no such Stage file in",
                "include \"../up.inc\" | w.world:2: left out include of ../up.inc: file must be a path with / relative to",
                "model( bitmap \"no.png\" ) | w.world:2: left out model: there is no such image file in",
                "model( bitmap \"w.world\" ) | w.world:1: P2 or P5 must come next",
                "model( size [1 x 1] ) | w.world:2: left out model: size: a number must be decimal",
                "model( size [1 -1 1] ) | w.world:2: left out model: size must be at least 0 (got: -1.0)",
                "model( block( points 2 ) ) | w.world:2: left out model: a block must have 3 to 1000 points (got: 2)",
                "position( ranger( sensor( samples 0 ) ) ) | left out position: samples must be a whole number from 1",
                "position( ranger( sensor( range [5 1] ) ) ) | left out position: a sensor's range must begin at 0 or"
            })
    void aBadModelCostsItself(String bad, String message) throws IOException {
        WorldImport read = imported(bad + "\nmodel( name \"good\" )\n");
        assertThat(read.world().objects()).hasSize(1);
        assertThat(read.skipped()).hasSize(1);
        String left = read.skipped().get(0).toString();
        assertThat(left.replace("left out model: ", ""))
                .contains(message.strip().replace("left out model: ", ""));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "model( | an entity must end with ) (got: the end of the file)",
                "model( size [1 2 | size must have values and then ] (got: )",
                "model( name \"x | a text must end with quotes in its line (got: none)",
                "define a model | define must be followed by a name, a type and (",
                "size | size must have a value (got: )",
                "window( ) | nothing in it is solid, so the world would be empty"
            })
    void aBrokenFileIsRefused(String text, String message) {
        assertThatThrownBy(() -> imported(text))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining(message);
    }

    @Test
    void whatGrowsWithoutEndIsRefused() throws IOException {
        Files.writeString(folder.resolve("loop.inc"), "include \"loop.inc\"\n");
        assertThatThrownBy(() -> imported("include \"loop.inc\"\n")).hasMessageContaining("no file may include itself");
        StringBuilder text = new StringBuilder("define a0 model( )\n");
        for (int k = 1; k < 40; k++) {
            text.append("define a%d model( a%d() a%d() a%d() )\n".formatted(k, k - 1, k - 1, k - 1));
        }
        assertThatThrownBy(() -> imported(text.toString()))
                .hasMessageContaining("at most 200000 entities, with all that");
        assertThatThrownBy(() -> imported("model(".repeat(100_000))).hasMessageContaining("nested at most 50 deep");
    }

    @Test
    void tooFewNumbersAreTold() throws IOException {
        WorldImport read =
                imported("position ( name \"r\" size [1 1 1] pose [-6 -5 45] )\nmodel ( size 0.4 pose [3 0 0 0] )\n");
        assertThat(read.world().objects()).hasSize(2);
        assertThat(read.remarks())
                .hasSize(2)
                .anyMatch(line ->
                        line.endsWith("w.world:2: pose of position \"r\" must be [x y z heading] (got: 3 numbers);"
                                + " what is missing is as if it were left out"))
                .anyMatch(line -> line.contains("w.world:3: size of model must be [x y z] (got: 1 number); "));
    }
}
