package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;

/**
 * Edges of a disc on a map, against the distance of each from every cell nearby. No edge is free that comes nearer than the
 * radius, and none is refused that stays farther away; {@code -Dedges=100000000} asks for more of them.
 */
class FreeEdgesOnMapsTest {
    private static final long EDGES = Long.getLong("edges", Effort.cases(200_000));
    private static final int COLUMNS = 400;
    private static final int ROWS = 300;
    private static final double CELL = 0.05;
    private static final double RADIUS = 0.2;

    /** What the rounding of a path and of the distance taken here may amount to; coordinates are below 16. */
    private static final double DOUBT = 1e-13;

    private static final int BATCH = 4096;

    private final SplittableRandom random = new SplittableRandom(Long.getLong("edges.seed", 5));
    private final BitSet occupied = caves();

    /** Blocks, walls and single cells, with room between them for a disc. */
    private BitSet caves() {
        BitSet cells = new BitSet();
        for (int k = 0; k < 110; k++) {
            int kind = random.nextInt(3);
            int width = kind == 0 ? random.nextInt(2, 16) : kind == 1 ? random.nextInt(1, 50) : 1;
            int height = kind == 0 ? random.nextInt(2, 16) : kind == 1 ? 1 + 50 / (width + 1) : 1;
            int column = random.nextInt(COLUMNS - width);
            int row = random.nextInt(ROWS - height);
            for (int j = row; j < row + height; j++) {
                cells.set(j * COLUMNS + column, j * COLUMNS + column + width);
            }
        }
        return cells;
    }

    private static double column(double x) {
        return x / CELL + COLUMNS / 2.0;
    }

    private static double row(double z) {
        return z / CELL + ROWS / 2.0;
    }

    private static double clamp(double value, double half) {
        return Math.max(-half, Math.min(half, value));
    }

    /** The distance of a segment from the nearest occupied cell, if that is below a metre or so. */
    private double distance(double ax, double az, double bx, double bz) {
        int left = Math.max(0, (int) column(Math.min(ax, bx) - 2 * RADIUS));
        int right = Math.min(COLUMNS - 1, (int) column(Math.max(ax, bx) + 2 * RADIUS));
        int low = Math.max(0, (int) row(Math.min(az, bz) - 2 * RADIUS));
        int high = Math.min(ROWS - 1, (int) row(Math.max(az, bz) + 2 * RADIUS));
        double nearest = Double.POSITIVE_INFINITY;
        for (int j = low; j <= high; j++) {
            int end = j * COLUMNS + right;
            for (int cell = occupied.nextSetBit(j * COLUMNS + left);
                    cell >= 0 && cell <= end;
                    cell = occupied.nextSetBit(cell + 1)) {
                double cx = (cell - j * COLUMNS + 0.5 - COLUMNS / 2.0) * CELL;
                double cz = (j + 0.5 - ROWS / 2.0) * CELL;
                nearest = Math.min(nearest, toSquare(ax - cx, az - cz, bx - cx, bz - cz, CELL / 2));
            }
        }
        return Math.sqrt(nearest);
    }

    /** The squared distance of a segment from a square about the origin: of its ends, of the corners, or 0 where they cross. */
    private static double toSquare(double ax, double az, double bx, double bz, double half) {
        double least = Math.min(
                square(ax - clamp(ax, half), az - clamp(az, half)), square(bx - clamp(bx, half), bz - clamp(bz, half)));
        double dx = bx - ax;
        double dz = bz - az;
        double length = dx * dx + dz * dz;
        int sides = 0;
        for (int corner = 0; corner < 4; corner++) {
            double x = (corner & 1) == 0 ? -half : half;
            double z = corner < 2 ? -half : half;
            double along = length == 0 ? 0 : ((x - ax) * dx + (z - az) * dz) / length;
            double t = Math.max(0, Math.min(1, along));
            least = Math.min(least, square(ax + t * dx - x, az + t * dz - z));
            sides |= (x - ax) * dz - (z - az) * dx > 0 ? 1 : 2;
        }
        boolean isBeside = Math.min(ax, bx) > half
                || Math.max(ax, bx) < -half
                || Math.min(az, bz) > half
                || Math.max(az, bz) < -half;
        return sides == 3 && !isBeside ? 0 : least;
    }

    private static double square(double x, double z) {
        return x * x + z * z;
    }

    /** Anywhere; or along a side or past a corner of a cell, at about the radius. */
    private void edge(double[] edges, int at) {
        double x = (random.nextDouble() - 0.5) * (COLUMNS * CELL - 3);
        double z = (random.nextDouble() - 0.5) * (ROWS * CELL - 3);
        double angle = random.nextDouble() * 2 * Math.PI;
        double dx = StrictMath.cos(angle);
        double dz = StrictMath.sin(angle);
        if (random.nextInt(3) > 0) {
            int cell = occupied.nextSetBit(random.nextInt(occupied.length()));
            double off = RADIUS + (random.nextInt(3) - 1) * Math.scalb(random.nextDouble(), -random.nextInt(50));
            if (random.nextBoolean()) {
                dx = random.nextInt(3) - 1;
                dz = dx == 0 ? 1 : random.nextInt(2) * (random.nextBoolean() ? 1 : -1);
                double length = Math.sqrt(dx * dx + dz * dz);
                dx /= length;
                dz /= length;
            }
            double along = random.nextDouble();
            x = (cell % COLUMNS + random.nextInt(2) - COLUMNS / 2.0) * CELL + off * dz - along * dx;
            z = (cell / COLUMNS + random.nextInt(2) - ROWS / 2.0) * CELL - off * dx - along * dz;
        }
        double limit = COLUMNS * CELL / 2 - 2;
        double limitZ = ROWS * CELL / 2 - 2;
        x = clamp(x, limit);
        z = clamp(z, limitZ);
        edges[at] = x;
        edges[at + 1] = 1;
        edges[at + 2] = z;
        edges[at + 4] = x + dx;
        edges[at + 5] = 1;
        edges[at + 6] = z + dz;
    }

    @Test
    void edgesOfADisc() {
        Geometry world = new Geometry(40, 4, 40, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new GridObject(new Point(0, 1, 0), CELL, 2, COLUMNS, ROWS, occupied));
        world.addObjectUnchecked(new CylinderObject(new Point(0, 1, -18), RADIUS, 0.4).moveable("disc"));
        double[] edges = new double[8 * BATCH];
        long[] free = new long[BATCH / 64];
        long asked = 0;
        long told = 0;
        long falseFree = 0;
        long falseRefused = 0;
        long doubtful = 0;
        String example = "";
        while (asked < EDGES) {
            for (int k = 0; k < BATCH; k++) {
                edge(edges, 8 * k);
            }
            told += world.freeEdges("disc", edges, free);
            for (int k = 0; k < BATCH; k++) {
                int at = 8 * k;
                double distance = distance(edges[at], edges[at + 2], edges[at + 4], edges[at + 6]);
                boolean isFree = (free[k >> 6] >>> k & 1) != 0;
                boolean isWrong = isFree ? distance < RADIUS - DOUBT : distance > RADIUS + DOUBT;
                doubtful += Math.abs(distance - RADIUS) <= DOUBT ? 1 : 0;
                if (isWrong) {
                    falseFree += isFree ? 1 : 0;
                    falseRefused += isFree ? 0 : 1;
                    example = "from (%s, %s) to (%s, %s), %s from a cell, told %s"
                            .formatted(
                                    edges[at],
                                    edges[at + 2],
                                    edges[at + 4],
                                    edges[at + 6],
                                    distance,
                                    isFree ? "free" : "not free");
                }
            }
            asked += BATCH;
        }
        String counts = "%,d edges, %,d free, %,d in doubt, %,d wrongly free, %,d wrongly refused %s"
                .formatted(asked, told, doubtful, falseFree, falseRefused, example);
        if (EDGES > 1_000_000) {
            System.out.println(counts);
        }
        assertThat(falseFree).as(counts).isZero();
        assertThat(falseRefused).as(counts).isZero();
        assertThat(told).as(counts).isBetween(asked / 5, asked * 4 / 5);
        assertThat(doubtful).as(counts).isBetween(asked / 1000, asked / 5);
    }
}
