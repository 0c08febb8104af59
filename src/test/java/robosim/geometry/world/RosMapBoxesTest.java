package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** A map that was read from a robot's files answers as the same map of boxes does, a box for each occupied cell. */
class RosMapBoxesTest {
    private static final Path MAPS = Path.of("src/test/resources/robosim/geometry/world/maps");
    private static final String YAML = """
            image: tb3_sandbox.pgm
            resolution: 0.05
            origin: [%s]
            negate: 0
            occupied_thresh: 0.65
            free_thresh: 0.196
            """;

    @TempDir
    Path folder;

    private World world(String origin) throws IOException {
        Files.copy(MAPS.resolve("tb3_sandbox.pgm"), folder.resolve("tb3_sandbox.pgm"));
        return RosMaps.read(Files.writeString(folder.resolve("map.yaml"), YAML.formatted(origin)), 1);
    }

    private static Geometry boxes(World world) {
        Geometry geometry =
                new Geometry(world.width(), world.height(), world.length(), world.dimension(), world.accuracy());
        for (WorldObject each : world.objects()) {
            if (each.object() instanceof GridObject grid) {
                grid.occupied().stream()
                        .mapToObj(cell -> grid.box(cell % grid.columns(), cell / grid.columns()))
                        .forEach(geometry::addObjectUnchecked);
            } else {
                geometry.addObjectUnchecked(each.object());
            }
        }
        return geometry;
    }

    /** A place about the walls, in the world. */
    private static Point place(SplittableRandom random, GridObject walls, double y) {
        double u = random.nextDouble(-5, 5);
        double v = random.nextDouble(-5, 5);
        double[] r = walls.rotation();
        Point c = walls.center();
        return new Point(c.x() + r[0] * u + r[2] * v, y, c.z() + r[6] * u + r[8] * v);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"-10, -10, 0", "-9.6, 3.125, 1.5707963267948966", "3.7, -21.3, 2.5", "-1, 2, -0.1"})
    void raysTestsAndMovesAreThoseOfTheBoxes(String origin) throws IOException {
        World world = world(origin);
        Geometry grid = world.toGeometry();
        Geometry boxes = boxes(world);
        assertThat(boxes.objects()).hasSize(870 + 4);
        GridObject walls = (GridObject) world.objects().get(0).object();
        SplittableRandom random = new SplittableRandom(8);
        int hits = 0;
        int touching = 0;
        int blocked = 0;
        for (int k = 0; k < 4000; k++) {
            Point from = place(random, walls, random.nextDouble(-0.5, 0.5));
            double angle = random.nextDouble(2 * Math.PI);
            double up = k % 2 == 0 ? 0 : random.nextDouble(-0.3, 0.3);
            Ray ray = new Ray(from, new Point(StrictMath.cos(angle), up, StrictMath.sin(angle)));
            double range = grid.getRayDistance(ray, 0, 8, 0);
            assertThat(range).as("%s", ray).isEqualTo(boxes.getRayDistance(ray, 0, 8, 0));
            hits += range < 8 ? 1 : 0;
            double cone = grid.getRayDistance(ray, 0, 8, 15);
            assertThat(cone).as("cone %s", ray).isEqualTo(boxes.getRayDistance(ray, 0, 8, 15));
            GeometryObject shape = k % 3 == 0
                    ? new BoxObject(new Point(), 0.5, 0.4, 0.3).turned(0, random.nextDouble(360))
                    : new CylinderObject(new Point(), random.nextDouble(0.02, 0.3), 0.4);
            GeometryObject robot = shape.movedTo(place(random, walls, 0)).moveable("robot");
            boolean touches = grid.testObject(robot);
            assertThat(touches).as("%s", robot).isEqualTo(boxes.testObject(robot));
            touching += touches ? 1 : 0;
            if (touches) {
                continue;
            }
            Move move = new Move(random.nextDouble(3), 0, k % 3 == 1 ? 0.5 : 0, 0, k % 5 == 0 ? 30 : 0);
            MoveResult one = moved(grid, robot, move);
            MoveResult other = moved(boxes, robot, move);
            assertThat(one.allowed()).as("%s by %s", robot, move).isEqualTo(other.allowed());
            assertThat(one.fraction()).as("%s by %s", robot, move).isEqualTo(other.fraction());
            assertThat(one.turnFraction()).as("%s by %s", robot, move).isEqualTo(other.turnFraction());
            blocked += one.allowed() ? 0 : 1;
        }
        assertThat(hits).isBetween(1200, 3990);
        assertThat(touching).isBetween(200, 2000);
        assertThat(blocked).isBetween(500, 3000);
    }

    private static MoveResult moved(Geometry geometry, GeometryObject robot, Move move) {
        assertThat(geometry.addObjectUnchecked(robot)).isTrue();
        MoveResult result = geometry.move("robot", move);
        assertThat(geometry.removeObject("robot")).isTrue();
        return result;
    }

    @Test
    void thePlaceOfEachCellIsThatOfItsPixel() throws IOException {
        World world = world("-10, -10, 0");
        GridObject walls = (GridObject) world.objects().get(0).object();
        for (int row = 0; row < 384; row += 7) {
            for (int column = 0; column < 384; column += 7) {
                BoxObject box = walls.box(column, row);
                assertThat(Math.abs(box.center().x() - (-10 + 0.05 * (column + 0.5))))
                        .isLessThan(1e-12);
                assertThat(Math.abs(box.center().z() - (10 - 0.05 * (384 - row - 0.5))))
                        .isLessThan(1e-12);
                assertThat(Math.abs(box.width() - 0.05)).isLessThan(1e-12);
            }
        }
    }
}
