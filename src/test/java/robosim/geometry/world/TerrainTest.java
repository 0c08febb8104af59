package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.RayHit;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** Terrains: exact as their triangles, and closed between them, in Java and in world files. */
class TerrainTest {
    private static final int COLUMNS = 17;
    private static final int ROWS = 12;
    private static final double CELL = 0.375;

    private final SplittableRandom random = new SplittableRandom(40_401);
    private final double[] heights = random.doubles(COLUMNS * ROWS, -1, 1).toArray();
    private final MeshObject terrain = MeshObject.heightfield(CELL, COLUMNS, ROWS, heights);

    private double at(int column, int row) {
        return heights[row * COLUMNS + column];
    }

    /** The height over a place, on the triangle whose corners are two of a row and one of the next. */
    private double height(double x, double z) {
        double u = x / CELL + 0.5 * (COLUMNS - 1);
        double v = z / CELL + 0.5 * (ROWS - 1);
        int column = Math.min(COLUMNS - 2, (int) Math.floor(u));
        int row = Math.min(ROWS - 2, (int) Math.floor(v));
        double right = u - column;
        double down = v - row;
        double least = at(column, row);
        double greatest = at(column + 1, row + 1);
        return right >= down
                ? least + right * (at(column + 1, row) - least) + down * (greatest - at(column + 1, row))
                : least + down * (at(column, row + 1) - least) + right * (greatest - at(column, row + 1));
    }

    @Test
    void raysMeetTheTriangleThatIsThere() {
        for (int k = 0; k < 2000; k++) {
            double x = random.nextDouble(-0.49, 0.49) * CELL * (COLUMNS - 1);
            double z = random.nextDouble(-0.49, 0.49) * CELL * (ROWS - 1);
            double found = CollisionDetection.rayDistance(new Ray(new Point(x, 3, z), new Point(0, -1, 0)), terrain);
            assertThat(3 - found).isEqualTo(height(x, z), within(1e-12));
        }
    }

    /** Rays through every corner, edge and diagonal, from above and from below, and lines that run along them. */
    @Test
    void nothingSlipsThroughBetweenCells() {
        int asked = 0;
        for (int row = 0; row < ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                double x = CELL * (column - 0.5 * (COLUMNS - 1));
                double z = CELL * (row - 0.5 * (ROWS - 1));
                for (double along : new double[] {0, 1.0 / 3, 0.7}) {
                    for (int way = 0; way < 3; way++) {
                        double px = way == 1 ? x : x + along * CELL;
                        double pz = way == 0 ? z : z + along * CELL;
                        if (px > CELL * 0.5 * (COLUMNS - 1) || pz > CELL * 0.5 * (ROWS - 1)) {
                            continue;
                        }
                        for (int sign = -1; sign <= 1; sign += 2) {
                            Ray ray = new Ray(new Point(px, 2 * sign, pz), new Point(0, -sign, 0));
                            assertThat(CollisionDetection.rayDistance(ray, terrain))
                                    .as("%s", ray)
                                    .isBetween(1.0, 3.0);
                            asked++;
                        }
                    }
                }
            }
        }
        assertThat(asked).isGreaterThan(3000);
    }

    /** A ball goes down to the surface and never through it, wherever it comes down and whichever way it goes. */
    @Test
    void nothingMovesThroughIt() {
        Geometry world = new Geometry(20, 20, 20);
        world.addObject(terrain.named("terrain"));
        for (int k = 0; k < 300; k++) {
            SphereObject ball = new SphereObject(
                    new Point(random.nextDouble(-2, 2), 2, random.nextDouble(-1.5, 1.5)),
                    k % 3 == 0 ? 0 : random.nextDouble(0.1));
            assertThat(world.addObject(ball.moveable("ball"))).isTrue();
            Move down = new Move(random.nextDouble(-0.5, 0.5), -6, random.nextDouble(-0.3, 0.3), 0, 0);
            assertThat(world.moveToContact("ball", down, 0.001).allowed()).isFalse();
            Point end = world.getObject("ball").center();
            assertThat(end.y()).isGreaterThan(height(end.x(), end.z()));
            assertThat(world.getProximity("ball", 1)).isEqualTo(0.001, within(1e-6));
            RayHit below = world.castRay(new Ray(new Point(end.x(), -5, end.z()), new Point(0, 1, 0)), 20);
            assertThat(below == null ? "nothing" : below.object().name()).isEqualTo("terrain");
            world.removeObject("ball");
        }
    }

    @Test
    void aFileHasHeights() throws WorldException {
        StringBuilder text = new StringBuilder();
        for (double height : heights) {
            text.append(height).append(' ');
        }
        String xml = "<world xmlns=\"urn:robosim:world:1\" width=\"20\" height=\"20\" length=\"20\">"
                + "<mesh name=\"hill\" center=\"1 2 3\" layers=\"ground\"><heights cell=\"" + CELL + "\" columns=\""
                + COLUMNS + "\">" + text + "</heights></mesh></world>";
        World world = read(xml);
        GeometryObject hill = world.objects().get(0).object();
        assertThat(hill.named("terrain"))
                .isEqualTo(terrain.named("terrain").withLayers(hill.layers()).at(hill.pose()));
        assertThat(read(WorldWriter.toXml(world))).isEqualTo(world);
        assertThat(world.toGeometry().dimension()).isEqualTo(Dimension.SPATIAL);
        String first = heights[0] + " ";
        assertThatThrownBy(() -> read(xml.replaceFirst(first, "")))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("heights must be whole rows of 17 numbers (got: 203 numbers)");
        assertThatThrownBy(() -> read(xml.replaceFirst(first, "high ")))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("high");
        assertThatThrownBy(() -> read(xml.replace("columns=\"17\"", "columns=\"1\"")))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("columns and rows must be at least 2");
        assertThatThrownBy(() -> read(xml.replace("<heights", "<vertices>0 0 0</vertices><heights")))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("heights");
    }

    private static World read(String xml) throws WorldException {
        return WorldReader.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "terrain", null);
    }

    @Test
    void whatIsNoTerrainIsRefused() {
        assertThatThrownBy(() -> MeshObject.heightfield(0, 2, 2, 0, 0, 0, 0)).hasMessageContaining("(got: 0.0)");
        assertThatThrownBy(() -> MeshObject.heightfield(Double.NaN, 2, 2, 0, 0, 0, 0))
                .hasMessageContaining("cell must be above 0");
        assertThatThrownBy(() -> MeshObject.heightfield(1, 2, 2, 0, 0, 0)).hasMessageContaining("(got: 3)");
        assertThatThrownBy(() -> MeshObject.heightfield(1, 2, 2, 0, 0, Double.NaN, 0))
                .hasMessageContaining("heights[2]");
        assertThatThrownBy(() -> MeshObject.heightfield(1, 1 << 13, 1 << 12))
                .hasMessageContaining("(got: 8192 x 4096)");
    }
}
