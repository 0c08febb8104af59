package robosim.geometry.narrow.planar;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Effort;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/** What plain doubles say about a leaf beside a grid, against the exact kernels, cell by cell. */
class PlainCellsTest {
    private static final int CASES = Effort.cases(4000);

    /** How far off a touch: none, some ulp, or a power of two. */
    private static final int FINEST = -52;

    private final PlainCells plain = new PlainCells();
    private final Scratch scratch = new Scratch();
    private final Sweep sweep = new Sweep(scratch);

    private static GridObject grid(SplittableRandom random) {
        int columns = random.nextInt(1, 9);
        int rows = random.nextInt(1, 9);
        BitSet occupied = new BitSet();
        occupied.set(random.nextInt(columns * rows));
        for (int k = random.nextInt(6); k > 0; k--) {
            occupied.set(random.nextInt(columns * rows));
        }
        boolean isDyadic = random.nextBoolean();
        double far = random.nextInt(5) == 0 ? 1000 : 3;
        Point center = isDyadic
                ? new Point(random.nextInt(-8, 9) / 4.0, 0, random.nextInt(-8, 9) / 4.0)
                : new Point(random.nextDouble(-far, far), random.nextDouble(-1, 1), random.nextDouble(-far, far));
        double cell = isDyadic ? 0.5 : random.nextDouble(0.1, 1);
        GridObject grid =
                new GridObject(center, cell, isDyadic ? 1 : random.nextDouble(0.2, 2), columns, rows, occupied);
        return switch (random.nextInt(4)) {
            case 0 -> grid;
            case 1 -> grid.turned(0, 90 * random.nextInt(4));
            case 2 -> grid.turned(0, random.nextDouble(-180, 180));
            default -> (GridObject) stretched(grid.turned(0, random.nextDouble(-180, 180)), random);
        };
    }

    /** The same object with a rotation that is one to 1e-9 only, and kept as it is given. */
    private static GeometryObject stretched(GeometryObject object, SplittableRandom random) {
        double by = 1 + random.nextDouble(-4e-10, 4e-10);
        double[] rotation = object.rotation();
        for (int k = 0; k < 9; k++) {
            rotation[k] *= k == 4 ? 1 : by;
        }
        return object.oriented(rotation);
    }

    private static GeometryObject body(String shape, SplittableRandom random) {
        boolean isDyadic = random.nextBoolean();
        double r = isDyadic ? random.nextInt(1, 5) / 4.0 : random.nextDouble(0.05, 1);
        double h = isDyadic ? random.nextInt(0, 5) / 4.0 : random.nextDouble(0.05, 1.5);
        GeometryObject box = new BoxObject(new Point(), 2 * r, h, h);
        return switch (shape) {
            case "disc" -> new CylinderObject(new Point(), r, h);
            case "sphere" -> new SphereObject(new Point(), r);
            case "capsule" -> new CapsuleObject(new Point(), r, h);
            default ->
                switch (random.nextInt(3)) {
                    case 0 -> box.turned(0, 90 * random.nextInt(4));
                    case 1 -> box.turned(0, random.nextDouble(-180, 180));
                    default -> stretched(box.turned(0, random.nextDouble(-180, 180)), random);
                };
        };
    }

    private static double reach(GeometryObject body, double x, double z) {
        double[] r = body.rotation();
        return switch (body.kind()) {
            case CYLINDER -> ((CylinderObject) body).radius();
            case SPHERE -> ((SphereObject) body).radius();
            case CAPSULE -> ((CapsuleObject) body).radius();
            case BOX ->
                Math.abs(r[0] * x + r[6] * z) * ((BoxObject) body).width() / 2
                        + Math.abs(r[2] * x + r[8] * z) * ((BoxObject) body).length() / 2;
            case MESH, GROUP, GRID -> throw new IllegalArgumentException("no body: " + body);
        };
    }

    /** A place beside a side of a cell, at a gap. */
    private static Point beside(GridObject grid, GeometryObject body, double gap, SplittableRandom random) {
        int cell = random.nextInt(grid.cells().occupied());
        int at = grid.cells().next(0);
        for (int k = 0; k < cell; k++) {
            at = grid.cells().next(at + 1);
        }
        Point middle = grid.box(at % grid.columns(), at / grid.columns()).center();
        int side = random.nextInt(4);
        double[] r = grid.rotation();
        double sign = side < 2 ? 1 : -1;
        double ax = sign * (side % 2 == 0 ? r[0] : r[2]);
        double az = sign * (side % 2 == 0 ? r[6] : r[8]);
        double out = grid.cell() / 2 + reach(body, ax, az) + gap;
        double along = random.nextInt(3) == 0 ? 0 : random.nextDouble(-1, 1) * grid.cell();
        return new Point(middle.x() + out * ax - along * az, middle.y(), middle.z() + out * az + along * ax);
    }

    private static double gap(SplittableRandom random) {
        double sign = random.nextBoolean() ? 1 : -1;
        return switch (random.nextInt(4)) {
            case 0 -> 0;
            case 1 -> sign * Math.scalb(1, random.nextInt(FINEST, 0));
            default -> sign * random.nextDouble(1.5);
        };
    }

    private static List<LeafColumn> cells(GridObject grid) {
        List<LeafColumn> cells = new ArrayList<>();
        for (int cell = grid.cells().next(0); cell >= 0; cell = grid.cells().next(cell + 1)) {
            cells.add(LocalLeaves.placed(grid.box(cell % grid.columns(), cell / grid.columns())));
        }
        return cells;
    }

    @ParameterizedTest
    @CsvSource({
        "PLANAR, disc, false", "PLANAR, sphere, false", "PLANAR, capsule, false", "PLANAR, box, false",
        "SPATIAL, disc, false", "SPATIAL, sphere, false", "SPATIAL, capsule, false", "SPATIAL, box, false",
        "PLANAR, disc, true", "PLANAR, sphere, true", "PLANAR, capsule, true", "PLANAR, box, true",
        "SPATIAL, disc, true", "SPATIAL, sphere, true", "SPATIAL, capsule, true", "SPATIAL, box, true"
    })
    void isCertainOnlyWhereTheKernelsAgree(Dimension dimension, String shape, boolean goes) {
        SplittableRandom random = new SplittableRandom(71 + shape.hashCode());
        int[] counts = new int[3];
        for (int k = 0; k < CASES; k++) {
            GridObject grid = grid(random);
            GeometryObject body = body(shape, random);
            Point place = beside(grid, body, gap(random), random);
            double rise = random.nextInt(3) == 0 ? random.nextDouble(-2, 2) : 0;
            Point from = new Point(place.x(), place.y() + rise, place.z());
            double[] way = new double[3];
            if (goes) {
                // On to a place beside a cell, or along the grid's side, or anywhere.
                Point to = beside(grid, body, gap(random), random);
                double by = random.nextInt(3) == 0 ? random.nextDouble(-3, 3) : 1;
                double[] r = grid.rotation();
                boolean isAlong = random.nextInt(3) == 0;
                way[0] = isAlong ? by * r[0] : by * (to.x() - from.x());
                way[1] = random.nextInt(4) == 0 ? random.nextDouble(-1, 1) : 0;
                way[2] = isAlong ? by * r[6] : by * (to.z() - from.z());
            }
            check(dimension, grid, body.movedTo(from), way, counts);
        }
        boolean isRoundBelow = dimension == Dimension.SPATIAL && (shape.equals("sphere") || shape.equals("capsule"));
        assertThat(counts[0]).as("unsure").isBetween(CASES / 50, CASES * 9 / 10);
        assertThat(counts[1]).as("past").isBetween(CASES / 10, CASES * 9 / 10);
        assertThat(counts[2]).as("met").isBetween(isRoundBelow ? 0 : CASES / 10, isRoundBelow ? 0 : CASES * 9 / 10);
    }

    private void check(Dimension dimension, GridObject grid, GeometryObject body, double[] way, int[] counts) {
        String as = "%s, %s, %s, way %s, %s, %s".formatted(dimension, grid, body, way[0], way[1], way[2]);
        LeafColumn mover = LocalLeaves.placed(body);
        LeafColumn column = LocalLeaves.placed(grid);
        int said = plain.compare(
                dimension, new Leaf(mover.kind(0), mover.rows(0), mover.at(0)), way[0], way[1], way[2], column, 0);
        boolean isStill = way[0] == 0 && way[2] == 0 && (way[1] == 0 || dimension == Dimension.PLANAR);
        boolean meets = false;
        boolean meetsLater = false;
        sweep.translation(dimension, way[0], way[1], way[2]);
        for (LeafColumn cell : cells(grid)) {
            boolean touches = Overlap.test(dimension, mover, 0, cell, 0, scratch);
            boolean isHit = touches || (!isStill && sweep.free(mover, 0, cell, 0) != Double.POSITIVE_INFINITY);
            meets |= isHit;
            meetsLater |= isHit && (isStill || !touches);
        }
        counts[said == PlainCells.UNSURE ? 0 : said == PlainCells.PAST ? 1 : 2]++;
        if (said == PlainCells.PAST) {
            assertThat(meets).as(as).isFalse();
        } else if (said == PlainCells.MET) {
            assertThat(meetsLater).as(as).isTrue();
        }
    }
}
