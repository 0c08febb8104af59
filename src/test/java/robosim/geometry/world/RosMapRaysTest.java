package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/**
 * What is seen and touched in the grid of a map is what is seen and touched in its cells. The figures go to
 * {@code target/ros-map-rays.md}; {@code -Drays=1000000} asks for more of them.
 */
class RosMapRaysTest {
    private static final Path MAPS = Path.of("src/test/resources/robosim/geometry/world/maps");
    private static final int RAYS = Integer.getInteger("rays", Effort.cases(20_000));
    private static final List<String> FIGURES = new ArrayList<>();

    @TempDir
    Path folder;

    /** The cells as the test reads them: columns from the left, rows from below. */
    private record Cells(boolean[][] walls, double resolution, double x, double y, double yaw) {
        static final double NEAR_A_CORNER = -1;

        boolean isWall(int column, int row) {
            return column >= 0 && row >= 0 && column < walls.length && row < walls[0].length && walls[column][row];
        }

        /** A place of the image, in metres from its lower left corner, in the world. */
        Point place(double right, double up, double height) {
            double cos = StrictMath.cos(yaw);
            double sin = StrictMath.sin(yaw);
            return new Point(x + right * cos - up * sin, height, -(y + right * sin + up * cos));
        }

        Point direction(double right, double up) {
            double cos = StrictMath.cos(yaw);
            double sin = StrictMath.sin(yaw);
            return new Point(right * cos - up * sin, 0, -(right * sin + up * cos));
        }

        /**
         * From cell to cell along a ray in the image: the distance at which it enters the first wall; negative where it
         * passes too near to a corner for rounded coordinates to tell which cell is next.
         */
        double walk(double right, double up, double towardsRight, double towardsUp) {
            int column = (int) Math.floor(right / resolution);
            int row = (int) Math.floor(up / resolution);
            int columnStep = towardsRight > 0 ? 1 : -1;
            int rowStep = towardsUp > 0 ? 1 : -1;
            double length = StrictMath.hypot(towardsRight, towardsUp);
            double distance = 0;
            while (!isWall(column, row)) {
                double nextColumn = towardsRight == 0
                        ? Double.POSITIVE_INFINITY
                        : ((column + (columnStep > 0 ? 1 : 0)) * resolution - right) / towardsRight * length;
                double nextRow = towardsUp == 0
                        ? Double.POSITIVE_INFINITY
                        : ((row + (rowStep > 0 ? 1 : 0)) * resolution - up) / towardsUp * length;
                if (Math.abs(nextColumn - nextRow) < 1e-9) {
                    return NEAR_A_CORNER;
                }
                distance = Math.min(nextColumn, nextRow);
                column += nextColumn < nextRow ? columnStep : 0;
                row += nextRow < nextColumn ? rowStep : 0;
                boolean isPast = (columnStep > 0 ? column >= walls.length : column < 0)
                        || (rowStep > 0 ? row >= walls[0].length : row < 0);
                if (isPast) {
                    return Double.POSITIVE_INFINITY;
                }
            }
            return distance;
        }
    }

    @AfterAll
    static void writeFigures() throws IOException {
        StringBuilder table = new StringBuilder("| map | rays | hit and miss agree | hits | largest difference, m |\n");
        table.append("|---|---|---|---|---|\n");
        FIGURES.stream().sorted().forEach(row -> table.append(row).append('\n'));
        Files.writeString(Path.of("target", "ros-map-rays.md"), table);
    }

    private Path yaml(Cells cells) throws IOException {
        return Files.writeString(
                folder.resolve("map.yaml"), """
                image: map.pgm
                resolution: %s
                origin: [%s, %s, %s]
                negate: 0
                occupied_thresh: 0.65
                free_thresh: 0.196
                """.formatted(cells.resolution, cells.x, cells.y, cells.yaw));
    }

    private Geometry world(Cells cells) throws IOException {
        Geometry geometry = RosMaps.read(yaml(cells), 1).toGeometry();
        // The walk ends with the image, and so that it can: what stands around the image has its own test.
        for (String side : new String[] {"left", "right", "upper", "lower"}) {
            assertThat(geometry.removeObject(side + " edge of the map")).isTrue();
        }
        return geometry;
    }

    private Cells arena(double x, double y, double yaw) throws IOException {
        return square("tb3_sandbox.pgm", 384, 0, 0.05, x, y, yaw); // 0, 205 and 254 are all it has
    }

    /** A square map of a byte to a pixel, whose walls are as dark as that or darker. */
    private Cells square(String name, int size, int darkest, double resolution, double x, double y, double yaw)
            throws IOException {
        byte[] bytes = Files.readAllBytes(MAPS.resolve(name));
        Files.write(folder.resolve("map.pgm"), bytes);
        boolean[][] walls = new boolean[size][size];
        for (int k = 0; k < size * size; k++) {
            walls[k % size][size - 1 - k / size] = (bytes[bytes.length - size * size + k] & 0xff) <= darkest;
        }
        return new Cells(walls, resolution, x, y, yaw);
    }

    private Cells random(SplittableRandom random, double resolution, double x, double y, double yaw)
            throws IOException {
        boolean[][] walls = new boolean[40][30];
        StringBuilder pgm = new StringBuilder("P2 40 30 1");
        for (int row = 29; row >= 0; row--) {
            for (int column = 0; column < 40; column++) {
                walls[column][row] = random.nextInt(20) == 0;
                pgm.append(walls[column][row] ? " 0" : " 1");
            }
        }
        Files.writeString(folder.resolve("map.pgm"), pgm, StandardCharsets.US_ASCII);
        return new Cells(walls, resolution, x, y, yaw);
    }

    /** Rays from anywhere between two columns and rows, in any direction. */
    private void raysAgree(String name, Cells cells, int count, int from, int to, SplittableRandom random)
            throws IOException {
        Geometry geometry = world(cells);
        int hits = 0;
        int inside = 0;
        int near = 0;
        int agreed = 0;
        double worst = 0;
        for (int k = 0; k < count; k++) {
            double right = (from + random.nextDouble() * (to - from)) * cells.resolution;
            double up = (from + random.nextDouble() * (to - from)) * cells.resolution;
            double angle = random.nextDouble() * 2 * Math.PI;
            double towardsRight = StrictMath.cos(angle);
            double towardsUp = StrictMath.sin(angle);
            double expected = cells.walk(right, up, towardsRight, towardsUp);
            if (expected == Cells.NEAR_A_CORNER) {
                near++;
                continue;
            }
            Ray ray = new Ray(
                    cells.place(right, up, random.nextDouble() - 0.5), cells.direction(towardsRight, towardsUp));
            double distance = geometry.getRayDistance(ray, 0, Double.POSITIVE_INFINITY, 0);
            agreed += Double.isFinite(expected) == Double.isFinite(distance) ? 1 : 0;
            if (expected == Double.POSITIVE_INFINITY) {
                assertThat(distance).as("%s", ray).isEqualTo(expected);
            } else {
                assertThat(distance).as("%s", ray).isCloseTo(expected, within(1e-9));
                worst = Math.max(worst, Math.abs(distance - expected));
                hits++;
                inside += expected == 0 ? 1 : 0;
            }
        }
        if (!name.isEmpty()) {
            FIGURES.add(String.format(
                    Locale.ROOT,
                    "| %s | %,d | %,d of %,d | %,d | %.1e |",
                    name,
                    count,
                    agreed,
                    count - near,
                    hits,
                    worst));
        }
        assertThat(agreed).isEqualTo(count - near);
        assertThat(hits).isBetween(count * 3 / 10, count * 99 / 100);
        assertThat(inside).isBetween(1, count / 3);
        assertThat(near).isLessThan(count / 100);
        assertThat(worst).isGreaterThan(0);
    }

    @Test
    void raysThroughAnArena() throws IOException {
        raysAgree(
                "tb3_sandbox, 384 x 384 cells of 0.05 m", arena(-10, -10, 0), RAYS, 120, 260, new SplittableRandom(1));
    }

    @Test
    void raysThroughAnArenaThatIsTurned() throws IOException {
        raysAgree(
                "tb3_sandbox, elsewhere and turned by 2.5 rad",
                arena(3.7, -21.3, 2.5),
                RAYS,
                120,
                260,
                new SplittableRandom(2));
    }

    @Test
    void raysThroughTenByTen() throws IOException {
        raysAgree(
                "TenByTen, 10 x 10 cells of 1 m",
                square("TenByTen.pgm", 10, 0x33, 1, 0, 0, 0),
                RAYS,
                0,
                10,
                new SplittableRandom(5));
        raysAgree(
                "TenByTen, turned by 1 rad",
                square("TenByTen.pgm", 10, 0x33, 1, 2, 3, 1),
                RAYS,
                0,
                10,
                new SplittableRandom(6));
    }

    @Test
    void raysThroughRandomCells() throws IOException {
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < 10; k++) {
            double yaw = k % 3 == 0 ? 0 : random.nextDouble() * 7 - 3.5;
            Cells cells = random(random, 0.01 + random.nextDouble(), random.nextDouble() * 50, -9, yaw);
            raysAgree("", cells, 1000, 0, 30, random);
        }
    }

    /** Where the cells' coordinates are binary fractions, the numbers are the same to the bit. */
    @Test
    void raysAlongTheAxesToTheBit() throws IOException {
        SplittableRandom random = new SplittableRandom(4);
        Cells cells = random(random, 0.125, -2.5, 1.75, 0);
        Geometry geometry = world(cells);
        int hits = 0;
        int[][] directions = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
        for (int column = 0; column < 40; column++) {
            for (int row = 0; row < 30; row++) {
                for (int[] towards : directions) {
                    double right = (column + 0.5) * 0.125;
                    double up = (row + 0.5) * 0.125;
                    double expected = cells.walk(right, up, towards[0], towards[1]);
                    Ray ray = new Ray(cells.place(right, up, 0), cells.direction(towards[0], towards[1]));
                    assertThat(geometry.getRayDistance(ray, 0, Double.POSITIVE_INFINITY, 0))
                            .as("%s", ray)
                            .isEqualTo(expected);
                    hits += expected < Double.POSITIVE_INFINITY ? 1 : 0;
                }
            }
        }
        assertThat(hits).isBetween(1500, 4500);
    }

    /** Every cell of the image: a ball in its middle touches a wall where it is one, and nowhere else. */
    @Test
    void everyCellOfAnArena() throws IOException {
        for (double yaw : new double[] {0, 1, Math.PI / 2}) {
            Cells cells = arena(-10, -10, yaw);
            Geometry geometry = world(cells);
            for (int column = 0; column < 384; column++) {
                for (int row = 0; row < 384; row++) {
                    Point middle = cells.place((column + 0.5) * 0.05, (row + 0.5) * 0.05, 0);
                    boolean touches = geometry.testObject(new SphereObject(middle, 0.0249));
                    if (touches != cells.walls[column][row]) {
                        assertThat(touches)
                                .as("cell %d, %d at %s", column, row, middle)
                                .isEqualTo(cells.walls[column][row]);
                    }
                }
            }
        }
    }
}
