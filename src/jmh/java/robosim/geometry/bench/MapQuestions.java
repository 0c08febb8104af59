package robosim.geometry.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;

/**
 * What robots ask on a map of 1730 x 1300 cells of 0.05 m, caves and corridors: beams of a laser, tests of discs, moves of
 * 1 m, and batches for planners. Beside it, a walk over the same cells in plain doubles that jumps by their clearance, which
 * decides nothing exactly and gives no answer to anything else.
 */
public final class MapQuestions {
    private static final Path REPORT = Path.of("docs", "report");
    private static final int COLUMNS = 1730;
    private static final int ROWS = 1300;
    private static final double CELL = 0.05;
    private static final double RANGE = 30;
    private static final int BEAMS = 1081;
    private static final int POSES = 200;
    private static final double RADIUS = 0.2;

    private final BitSet occupied;
    private final byte[] clearance = new byte[COLUMNS * ROWS];
    private final SplittableRandom random = new SplittableRandom(19);
    private final double[] x = new double[POSES];
    private final double[] z = new double[POSES];
    private final double[] heading = new double[POSES];
    private final double[] plain = new double[BEAMS];
    private final double[] fan = new double[2 * BEAMS];
    private final double[] cos = new double[POSES];
    private final double[] sin = new double[POSES];

    private MapQuestions() {
        occupied = caves();
        GridObject grid = grid();
        for (int cell = 0; cell < clearance.length; cell++) {
            clearance[cell] = (byte) grid.cells().clearance(cell);
        }
        for (int k = 0; k < POSES; k++) {
            int cell;
            do {
                cell = random.nextInt(clearance.length);
            } while ((clearance[cell] & 0xff) < 6);
            x[k] = (cell % COLUMNS + random.nextDouble() - COLUMNS / 2.0) * CELL;
            z[k] = (cell / COLUMNS + random.nextDouble() - ROWS / 2.0) * CELL;
            heading[k] = random.nextDouble(-180, 180);
            cos[k] = StrictMath.cos(Math.toRadians(heading[k]));
            sin[k] = StrictMath.sin(Math.toRadians(heading[k]));
        }
        for (int beam = 0; beam < BEAMS; beam++) {
            double angle = Math.toRadians(-135 + beam * 270.0 / (BEAMS - 1));
            fan[beam] = StrictMath.cos(angle);
            fan[BEAMS + beam] = -StrictMath.sin(angle);
        }
    }

    private GridObject grid() {
        return new GridObject(new Point(0, 1, 0), CELL, 2, COLUMNS, ROWS, occupied);
    }

    /** Caves by a cellular automaton, in which corridors and rooms are cut. */
    private BitSet caves() {
        BitSet now = new BitSet();
        for (int cell = 0; cell < COLUMNS * ROWS; cell++) {
            now.set(cell, random.nextInt(100) < 44);
        }
        for (int step = 0; step < 4; step++) {
            BitSet next = new BitSet();
            for (int row = 0; row < ROWS; row++) {
                for (int column = 0; column < COLUMNS; column++) {
                    next.set(row * COLUMNS + column, neighbours(now, column, row) >= 5);
                }
            }
            now = next;
        }
        for (int k = 0; k < 160; k++) {
            boolean isLong = random.nextBoolean();
            int width = isLong ? random.nextInt(200, 700) : random.nextInt(24, 60);
            int height = isLong ? random.nextInt(24, 60) : random.nextInt(100, 400);
            int column = random.nextInt(1, COLUMNS - width);
            int row = random.nextInt(1, ROWS - height);
            for (int j = row; j < row + height; j++) {
                now.clear(j * COLUMNS + column, j * COLUMNS + column + width);
            }
        }
        return now;
    }

    private static int neighbours(BitSet cells, int column, int row) {
        int count = 0;
        for (int j = row - 1; j <= row + 1; j++) {
            for (int i = column - 1; i <= column + 1; i++) {
                boolean isOutside = i < 0 || j < 0 || i >= COLUMNS || j >= ROWS;
                count += isOutside || cells.get(j * COLUMNS + i) ? 1 : 0;
            }
        }
        return count;
    }

    private Geometry world(Dimension dimension, boolean asBoxes) {
        Geometry world = new Geometry(100, 10, 80, dimension, Accuracy.EXACT);
        if (asBoxes) {
            runs(world);
        } else {
            world.addObjectUnchecked(grid());
        }
        // The edges of the map, as its reader adds them.
        double width = COLUMNS * CELL;
        double length = ROWS * CELL;
        for (int side = -1; side <= 1; side += 2) {
            world.addObjectUnchecked(new BoxObject(new Point(side * (width + CELL) / 2, 1, 0), CELL, 2, length));
            world.addObjectUnchecked(new BoxObject(new Point(0, 1, side * (length + CELL) / 2), width, 2, CELL));
        }
        world.addObjectUnchecked(new CylinderObject(new Point(x[0], 1, z[0]), RADIUS, 0.4).moveable("robot"));
        world.addObjectUnchecked(new BoxObject(new Point(x[0], 1, z[0]), 0.5, 0.4, 0.3).moveable("cart"));
        return world;
    }

    /** The map as a box for each run of cells in a row. */
    private void runs(Geometry world) {
        for (int row = 0; row < ROWS; row++) {
            int end = (row + 1) * COLUMNS;
            int from = occupied.nextSetBit(row * COLUMNS);
            while (from >= 0 && from < end) {
                int to = Math.min(end, occupied.nextClearBit(from));
                double middle = ((from + to) / 2.0 - row * COLUMNS - COLUMNS / 2.0) * CELL;
                world.addObjectUnchecked(new BoxObject(
                        new Point(middle, 1, (row + 0.5 - ROWS / 2.0) * CELL), (to - from) * CELL, 2, CELL));
                from = occupied.nextSetBit(to);
            }
        }
    }

    private LongSupplier laser(Geometry world) {
        RayPattern fan = RayPattern.fan(-135, 270.0 / (BEAMS - 1), BEAMS);
        SenseOptions options = SenseOptions.range(0, RANGE);
        SenseBuffer out = new SenseBuffer();
        world.removeObject("robot");
        world.removeObject("cart");
        return () -> {
            long sum = 0;
            for (int k = 0; k < POSES; k++) {
                world.sense(Pose.of(new Point(x[k], 1, z[k]), heading[k]), fan, options, out);
                sum += (long) out.distance(k);
            }
            return sum;
        };
    }

    private long plainLaser() {
        long sum = 0;
        for (int k = 0; k < POSES; k++) {
            for (int beam = 0; beam < BEAMS; beam++) {
                double dx = cos[k] * fan[beam] + sin[k] * fan[BEAMS + beam];
                plain[beam] = walk(x[k], z[k], dx, cos[k] * fan[BEAMS + beam] - sin[k] * fan[beam]);
            }
            sum += (long) plain[k];
        }
        return sum;
    }

    /** The plain walk: from cell to cell, or as far as nothing is occupied around. */
    private double walk(double fromX, double fromZ, double dx, double dz) {
        double u = fromX / CELL + COLUMNS / 2.0;
        double v = fromZ / CELL + ROWS / 2.0;
        int i = (int) u;
        int j = (int) v;
        double perU = 1 / dx;
        double perV = 1 / dz;
        double along = 0;
        while (along < RANGE / CELL) {
            int free = clearance[j * COLUMNS + i] & 0xff;
            if (free == 0) {
                return along * CELL;
            }
            double alongU = (dx > 0 ? i + free - u : i - free + 1 - u) * perU;
            double alongV = (dz > 0 ? j + free - v : j - free + 1 - v) * perV;
            if (alongU < alongV) {
                along = alongU;
                i += dx > 0 ? free : -free;
                j = (int) (v + along * dz);
            } else {
                along = alongV;
                j += dz > 0 ? free : -free;
                i = (int) (u + along * dx);
            }
            if (i < 0 || j < 0 || i >= COLUMNS || j >= ROWS) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    private LongSupplier discs(Geometry world) {
        CylinderObject[] discs = new CylinderObject[POSES];
        for (int k = 0; k < POSES; k++) {
            discs[k] = new CylinderObject(new Point(x[k], 1, z[k]), RADIUS, 0.4);
        }
        return () -> {
            long sum = 0;
            for (int k = 0; k < 100 * POSES; k++) {
                sum += world.testObject(discs[k % POSES]) ? 1 : 0;
            }
            return sum;
        };
    }

    private LongSupplier moves(Geometry world) {
        return () -> {
            long sum = 0;
            for (int k = 0; k < 20 * POSES; k++) {
                int at = k % POSES;
                if (world.placeObject("robot", new Point(x[at], 1, z[at]), heading[at])) {
                    sum += world.simpleMove("robot", 1, 0, 0) ? 1 : 0;
                }
            }
            return sum;
        };
    }

    /** Poses or edges near the places of the robot; only those of a box are turned. */
    private double[] anywhere(int numbers, boolean isTurned) {
        double[] poses = new double[numbers * 4096];
        for (int k = 0; k < poses.length; k += numbers) {
            int at = random.nextInt(POSES);
            double turn = random.nextDouble(2 * Math.PI);
            for (int each = 0; each < numbers; each += 4) {
                poses[k + each] = x[at] + (each == 0 ? 0 : StrictMath.cos(turn));
                poses[k + each + 1] = 1;
                poses[k + each + 2] = z[at] + (each == 0 ? 0 : StrictMath.sin(turn));
                poses[k + each + 3] = isTurned ? heading[at] : 0;
            }
        }
        return poses;
    }

    private LongSupplier poses(Geometry world, String name) {
        double[] poses = anywhere(4, name.equals("cart"));
        long[] free = new long[64];
        return () -> world.freePoses(name, poses, free);
    }

    private LongSupplier edges(Geometry world, String name) {
        double[] edges = anywhere(8, name.equals("cart"));
        long[] free = new long[64];
        return () -> world.freeEdges(name, edges, free);
    }

    /** Prints nanoseconds of each question, with the same map as one grid and as boxes. */
    public static void main(String[] args) throws IOException {
        MapQuestions map = new MapQuestions();
        boolean hasBoxes = Boolean.parseBoolean(System.getProperty("boxes", "true"));
        GridObject grid = map.grid();
        System.out.println(grid);
        LongSupplier plain = map::plainLaser;
        List<Row> rows = new ArrayList<>();
        for (Dimension dimension : Dimension.values()) {
            Geometry world = map.world(dimension, false);
            Geometry boxes = hasBoxes ? map.world(dimension, true) : null;
            String in = dimension == Dimension.PLANAR ? ", in the plane" : ", in space";
            rows.add(row(
                    "beam of a laser" + in,
                    POSES * BEAMS,
                    plain,
                    map.laser(map.world(dimension, false)),
                    hasBoxes ? map.laser(map.world(dimension, true)) : null));
            rows.add(row(
                    "test of a disc" + in,
                    100 * POSES,
                    plain,
                    map.discs(world),
                    boxes == null ? null : map.discs(boxes)));
            rows.add(row(
                    "placement and move of a disc by 1 m" + in,
                    20 * POSES,
                    plain,
                    map.moves(world),
                    boxes == null ? null : map.moves(boxes)));
            for (String name : new String[] {"robot", "cart"}) {
                String of = (name.equals("robot") ? " of a disc" : " of a box") + in;
                rows.add(row(
                        "free pose" + of,
                        4096,
                        plain,
                        map.poses(world, name),
                        boxes == null ? null : map.poses(boxes, name)));
                rows.add(row(
                        "free edge of 1 m" + of,
                        4096,
                        plain,
                        map.edges(world, name),
                        boxes == null ? null : map.edges(boxes, name)));
            }
        }
        if (System.getProperty("publish") != null) {
            publish(rows, grid);
        }
    }

    /** A question: nanoseconds of the plain walk in the same minutes, with the map as a grid and as boxes; 0 if not asked. */
    private record Row(String what, double plain, double grid, double boxes) {}

    private static Row row(
            String what, int count, LongSupplier plain, LongSupplier grid, @Nullable LongSupplier boxes) {
        int repeats = Math.max(1, 200_000 / count);
        LongSupplier again = () -> {
            long sum = 0;
            for (int k = 0; k < repeats; k++) {
                sum += grid.getAsLong();
            }
            return sum;
        };
        LongSupplier boxesAgain = boxes == null ? () -> 0 : boxes;
        double[][] nanos = Timing.inTurn(10, 15, plain, again, boxesAgain);
        Row row = new Row(
                what,
                Timing.median(nanos[0]) / (POSES * BEAMS),
                Timing.median(nanos[1]) / count / repeats,
                boxes == null ? 0 : Timing.median(nanos[2]) / count);
        Timing.print("%-34s plain walk %6.1f   grid %8.1f   boxes %8.1f ns", what, row.plain, row.grid, row.boxes);
        return row;
    }

    /** The page of the report, with what was measured elsewhere from a file beside it. */
    private static void publish(List<Row> rows, GridObject grid) throws IOException {
        StringBuilder page = new StringBuilder();
        page.append("# A robot on a map\n\n").append("""
                One map of caves, corridors and rooms, %d x %d cells of %s m, %d of them occupied. Nanoseconds a question on \
                one core, and how many times that is of what a plain walk over the same cells takes for a beam of 30 m: \
                60 lines of Java in doubles, which jump by a byte of clearance per cell. Medians of 15 rounds in turn; a \
                laser is 1,081 beams from each of %d places, a planner's poses and edges are anywhere around these.

                `mvn -q test-compile exec:java -Dexec.classpathScope=test \
                -Dexec.mainClass=robosim.geometry.bench.MapQuestions -Dpublish` writes this page.

                | question | the map as a grid, ns | times the plain walk | as a box for each run of cells, ns | boxes over grid |
                |---|--:|--:|--:|--:|
                """.formatted(
                        grid.columns(), grid.rows(), grid.cell(), grid.cells().occupied(), POSES));
        for (Row row : rows) {
            page.append(String.format(
                    Locale.ROOT,
                    "| %s | %.0f | %.2f | %s | %s |%n",
                    row.what,
                    row.grid,
                    row.grid / row.plain,
                    row.boxes == 0 ? "" : String.format(Locale.ROOT, "%.0f", row.boxes),
                    row.boxes == 0 ? "" : String.format(Locale.ROOT, "%.1f", row.boxes / row.grid)));
        }
        page.append("\n## What robot people use for a laser today\n\n").append("""
                Measured in November 2026 on one core of another machine (±15 %%), on a map of a basement of the same size: \
                2,000 free poses x 1,081 beams over 270 degrees, range 30 m; errors against an exact walk over the cells. \
                Compare the third column with the third one above. The figures stand in [laser-peers.csv](laser-peers.csv).

                """.formatted());
        List<String> peers = Files.readAllLines(REPORT.resolve("laser-peers.csv"));
        for (String line : peers) {
            page.append("| ")
                    .append(line.replaceAll(",(?=(?:[^\"]*\"[^\"]*\")*[^\"]*$)", " | ")
                            .replace("\"", ""))
                    .append(" |\n");
            if (line.equals(peers.get(0))) {
                page.append("|---|--:|--:|--:|--:|--:|--:|\n");
            }
        }
        Files.writeString(REPORT.resolve("maps.md"), page);
    }
}
