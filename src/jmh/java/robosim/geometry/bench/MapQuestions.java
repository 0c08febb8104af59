package robosim.geometry.bench;

import java.util.BitSet;
import java.util.SplittableRandom;
import java.util.function.LongSupplier;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
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
    public static void main(String[] args) {
        MapQuestions map = new MapQuestions();
        boolean hasBoxes = Boolean.parseBoolean(System.getProperty("boxes", "true"));
        GridObject grid = map.grid();
        System.out.println(grid);
        for (Dimension dimension : Dimension.values()) {
            row(
                    dimension + " laser, a beam",
                    POSES * BEAMS,
                    map::plainLaser,
                    map.laser(map.world(dimension, false)),
                    hasBoxes ? map.laser(map.world(dimension, true)) : null);
            Geometry world = map.world(dimension, false);
            Geometry boxes = hasBoxes ? map.world(dimension, true) : null;
            row(
                    dimension + " disc, a test",
                    100 * POSES,
                    null,
                    map.discs(world),
                    boxes == null ? null : map.discs(boxes));
            row(
                    dimension + " disc, a move of 1 m",
                    20 * POSES,
                    null,
                    map.moves(world),
                    boxes == null ? null : map.moves(boxes));
            for (String name : new String[] {"robot", "cart"}) {
                GeometryObject mover = world.getObject(name);
                row(
                        dimension + " poses of a " + mover.kind().word(),
                        4096,
                        null,
                        map.poses(world, name),
                        boxes == null ? null : map.poses(boxes, name));
                row(
                        dimension + " edges of a " + mover.kind().word(),
                        4096,
                        null,
                        map.edges(world, name),
                        boxes == null ? null : map.edges(boxes, name));
            }
        }
    }

    private static void row(String what, int count, LongSupplier plain, LongSupplier grid, LongSupplier boxes) {
        LongSupplier none = () -> 0;
        double[][] nanos = Timing.inTurn(8, 9, plain == null ? none : plain, grid, boxes == null ? none : boxes);
        Timing.print(
                "%-34s plain walk %6.1f   grid %8.1f   boxes %8.1f ns",
                what,
                Timing.median(nanos[0]) / count,
                Timing.median(nanos[1]) / count,
                Timing.median(nanos[2]) / count);
    }
}
