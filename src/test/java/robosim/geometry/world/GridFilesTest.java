package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.management.ThreadMXBean;
import java.io.ByteArrayInputStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;

/** Grids in world files: run lengths, row by row. */
class GridFilesTest {
    private static final String HEAD =
            "<world xmlns=\"urn:robosim:world:1\" width=\"10\" height=\"10\" length=\"10\" unit=\"m\">\n";

    @TempDir
    Path folder;

    private static World read(String objects) throws WorldException {
        byte[] bytes = (HEAD + objects.replace(';', '\n') + "</world>").getBytes(StandardCharsets.UTF_8);
        return WorldReader.read(new ByteArrayInputStream(bytes), "w.xml", null);
    }

    private static GeometryObject only(String object) throws WorldException {
        List<WorldObject> objects = read(object).objects();
        assertThat(objects).hasSize(1);
        return objects.get(0).object();
    }

    private static World worldOf(GeometryObject... objects) {
        return new World(
                400,
                4,
                400,
                Unit.METRE,
                Dimension.SPATIAL,
                Accuracy.EXACT,
                List.of(objects).stream().map(WorldObject::new).toList());
    }

    @Test
    void readsRunsRowByRow() throws WorldException {
        GridObject expected = GridObject.of(new Point(1, 0, 2), 0.05, 2, 4, 3, new byte[] {(byte) 0b0110_1001, 0b1111})
                .named("map");
        String attributes = "name='map' center='1 0 2' cell='5cm' height='2' columns='4' rows='3'";
        // Rows #..#, .##. and ####.
        assertThat(only("<grid " + attributes + ">;  0 1 2 1;  1 2 1;  0 4;</grid>"))
                .isEqualTo(expected);
        assertThat(only("<grid " + attributes + ">0 1 2 1 1 2 1 0 4</grid>")).isEqualTo(expected);
        assertThat(only("<grid " + attributes + "><!-- first -->0 1 2;1 1<!-- second --> 2 1 0 4</grid>"))
                .isEqualTo(expected);
        assertThat(only("<grid cell='1' height='1' columns='1' rows='1'>0 1</grid>")
                        .name())
                .isNull();
    }

    @Test
    void writesALineForEachRow() throws WorldException {
        GridObject grid = GridObject.of(new Point(), 0.5, 2, 4, 4, new byte[] {(byte) 0b0110_1001, 0b1111});
        String xml = WorldWriter.toXml(worldOf(grid));
        assertThat(xml)
                .contains("  <grid cell=\"0.5\" height=\"2\" columns=\"4\" rows=\"4\">\n"
                        + "    0 1 2 1\n    1 2 1\n    0 4\n    4\n  </grid>\n");
        assertThat(WorldReader.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "w.xml", null))
                .isEqualTo(worldOf(grid));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0 1 2 1;1 2 1;0 5;|5|a run must be from 1 to 4 cells here, after 0 of the 4 cells of row 2 (got: 5)",
                "0 1 2 1;1 2 2;0 4;|4|a run must be from 1 to 1 cells here, after 3 of the 4 cells of row 1 (got: 2)",
                "0 1 2 1;1 0 3;0 4;|4|a run must be from 1 to 3 cells here, after 1 of the 4 cells of row 1 (got: 0)",
                "0 0 4;4;0 4;|3|a run must be from 1 to 4 cells here, after 0 of the 4 cells of row 0 (got: 0)",
                "0 4 0;4;4 4;|5|the runs must end with the last of 3 rows of 4 cells (got: 4 after it)",
                "0 1 2 1;1 2 1;0 4;1;|6|the runs must end with the last of 3 rows of 4 cells (got: 1 after it)",
                "0 1 2 1;1 2 1;0 3;|2|no more after 3 cells of row 2",
                "0 1 2 1;1 2 1;|2|no more after 0 cells of row 2",
                "''|2|the runs must add up to 4 cells in each row (got: no more after 0 cells of row 0)",
                "0 1 2 1;1 2 one;0 4;|4|a run must be a whole number of cells (got: one)",
                "0 1 2 1;-1 2 1;0 4;|4|a run must be from 0 to 4 cells here, after 0 of the 4 cells of row 1 (got: -1)",
                "0 1 2 1;1 2.0 1;0 4;|4|a run must be a whole number of cells (got: 2.0)",
                "0 4;0 99999999999;0 4;|4|a run must be a whole number of cells (got: 99999999999)",
                "4;4;4;|2|occupied must have a bit",
                "0 4;<box/>;0 4;4;|7|<grid> must contain only numbers; remove the elements in it",
            })
    void refusesOtherRunsWithTheirLine(String runs, int line, String message) {
        assertThatThrownBy(() -> read("<grid cell='1' height='1' columns='4' rows='3'>;" + runs + "</grid>"))
                .isInstanceOfSatisfying(
                        WorldException.class, e -> assertThat(e.line()).isEqualTo(line))
                .hasMessageContaining(message);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "columns='2'|columns='0'|columns of <grid> must be a whole number of at least 1 (got: 0)",
                "columns='2'|columns='-2'|columns of <grid> must be a whole number of at least 1",
                "columns='2'|columns='2.0'|columns of <grid> must be a whole number of at least 1",
                "columns='2'|columns='99999999999'|columns of <grid> must be a whole number of at least 1",
                "columns='2'|''|<grid> needs the attribute columns",
                "cell='1'|cell='0'|cell must be a number from 2^-500",
                "cell='1'|cell='-1'|cell of <grid> must be a length of at least 0",
                "cell='1'|cell='1' moveable='true'|<grid> has no attribute moveable",
                "cell='1'|cell='1' turned='90 0'|<grid> has no attribute turned",
                "cell='1'|cell='1' rotation='1 0 0 0 0 -1 0 1 0'|a grid stands upright",
                "cell='1'|cell='1' center='1e10 0 0'|a grid must lie within 2^30 of its cells",
                "height='1'|height='-1'|height of <grid> must be a length of at least 0",
            })
    void refusesWhatIsNoGrid(String was, String is, String message) {
        String grid = "<grid cell='1' height='1' columns='2' rows='1'>1 1</grid>";
        assertThat(grid).contains(was);
        assertThatThrownBy(() -> read(grid.replace(was, is)))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining(message);
    }

    @Test
    void aGridIsAnObjectOfTheWorldItselfAndHasNoSonars() {
        String grid = "<grid name='map' cell='1' height='1' columns='2' rows='1'>1 1";
        assertThatThrownBy(() -> read("<group>" + grid + "</grid></group>"))
                .hasMessageContaining("<grid> is not allowed in <group>");
        assertThatThrownBy(() -> read(grid + "<sonar count='1'/></grid>")).isInstanceOf(WorldException.class);
        GridObject object =
                GridObject.of(new Point(), 1, 1, 1, 1, new byte[] {1}).named("map");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new WorldObject(object, null, List.of(new SonarRing(1, 0, 1, 0))))
                .withMessageStartingWith("a grid has no sonars (got: grid");
    }

    /** A few characters may claim millions of cells. */
    @Test
    void claimedCellsAreLimitedBeforeTheyTakeMemory() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadAllocatedBytes();
        assertThatThrownBy(() -> read("<grid cell='1' height='1' columns='268435456' rows='1'>1 268435455</grid>"))
                .hasMessageContaining(
                        "the grids of a world must have at most 16777216 cells together; use larger cells (got: 268435456)");
        assertThatThrownBy(() -> read("<grid cell='1' height='1' columns='2147483647' rows='2147483647'>1 1</grid>"))
                .hasMessageContaining("at most 16777216 cells together; use larger cells (got: 4611686014132420609)");
        assertThat(threads.getCurrentThreadAllocatedBytes() - before).isLessThan(20_000_000);
        String half = "<grid cell='0.001' height='1' columns='8388609' rows='1'>1 8388608</grid>";
        assertThatThrownBy(() -> read(half + half))
                .hasMessageContaining("at most 16777216 cells together; use larger cells (got: 16777218)");
        BitSet one = new BitSet();
        one.set(7);
        GridObject large = new GridObject(new Point(), 0.001, 1, 8_388_609, 1, one);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> WorldWriter.toXml(worldOf(large, large)))
                .withMessage(
                        "the grids of a world file must have at most 16777216 cells together; use larger cells (got: 16777218)");
    }

    @Test
    void aMapOf4000By4000CellsComesBackAsItWas() throws Exception {
        SplittableRandom random = new SplittableRandom(7);
        BitSet walls = new BitSet();
        for (int k = 0; k < 5000; k++) {
            int from = random.nextInt(15_990_000);
            walls.set(from, from + random.nextInt(300));
        }
        World world = worldOf(new GridObject(new Point(0.1, 0, 0.3), 0.05, 2, 4000, 4000, walls)
                .turned(0, 12.3)
                .named("map"));
        Path file = folder.resolve("map.xml");
        WorldWriter.write(world, file);
        assertThat(Files.size(file)).isLessThan(200_000);
        assertThat(WorldReader.read(file)).isEqualTo(world);
    }
}
