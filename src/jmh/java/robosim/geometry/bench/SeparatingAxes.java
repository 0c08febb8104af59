package robosim.geometry.bench;

import java.util.SplittableRandom;
import java.util.function.LongSupplier;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.planar.PlanarScratch;
import robosim.geometry.narrow.planar.PolygonPolygon;
import robosim.geometry.narrow.planar.RectangleRectangle;
import robosim.geometry.narrow.planar.ZonogonZonogon;
import robosim.geometry.narrow.sat.AxisBody;
import robosim.geometry.narrow.sat.MovingAxes;
import robosim.geometry.narrow.sat.PolytopePolytope;

/**
 * What each test by separating axes is worth beside a more general one that would answer the same: in space the one
 * without motion, in the plane those for rectangles and for boxes. Half of the pairs overlap.
 */
public final class SeparatingAxes {
    private static final int PAIRS = 2000;
    private static final int REPEATS = 20;
    private static final int WARM_UP = 20;
    private static final int ROUNDS = 41;

    private final double[] a = new double[PAIRS * Leaf.STRIDE];
    private final double[] b = new double[PAIRS * Leaf.STRIDE];
    private final MovingAxes moving = new MovingAxes();
    private final PolytopePolytope polytopes = new PolytopePolytope();
    private final PlanarScratch s = new Scratch().planar;

    private interface Test {
        boolean touch(int at);
    }

    private SeparatingAxes() {}

    /** Prints a line for each: nanoseconds of both, and the ratio. */
    public static void main(String[] args) {
        SeparatingAxes bench = new SeparatingAxes();
        bench.fill(LeafKind.BOX);
        bench.compare(
                "boxes in space, without and with motion",
                at -> bench.polytopes.touch(new Leaf(LeafKind.BOX, bench.a, at), new Leaf(LeafKind.BOX, bench.b, at)),
                at -> bench.moving.time(
                                AxisBody.Mode.SPATIAL,
                                new Leaf(LeafKind.BOX, bench.a, at),
                                1e-9,
                                0,
                                0,
                                new Leaf(LeafKind.BOX, bench.b, at))
                        <= 1);
        bench.compare(
                "boxes in the plane, as boxes and as polygons",
                at -> ZonogonZonogon.touch(
                        new Leaf(LeafKind.BOX, bench.a, at), new Leaf(LeafKind.BOX, bench.b, at), bench.s.fine),
                at -> PolygonPolygon.touch(
                        new Leaf(LeafKind.BOX, bench.a, at), new Leaf(LeafKind.BOX, bench.b, at), bench.s));
        bench.fill(LeafKind.UPRIGHT_BOX);
        bench.compare(
                "upright boxes in the plane, as rectangles and as boxes",
                at -> RectangleRectangle.touch(bench.a, at, bench.b, at, bench.s.fine),
                at -> ZonogonZonogon.touch(
                        new Leaf(LeafKind.BOX, bench.a, at), new Leaf(LeafKind.BOX, bench.b, at), bench.s.fine));
    }

    private void fill(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < PAIRS; k++) {
            box(kind, random, a, k * Leaf.STRIDE);
            box(kind, random, b, k * Leaf.STRIDE);
        }
    }

    private static void box(LeafKind kind, SplittableRandom random, double[] row, int at) {
        for (int k = 0; k < 3; k++) {
            row[at + k] = random.nextDouble(-0.75, 0.75);
            row[at + 3 + k] = random.nextDouble(0.2, 0.8);
        }
        double yaw = random.nextDouble(0, 2 * Math.PI);
        double pitch = kind == LeafKind.UPRIGHT_BOX ? 0 : random.nextDouble(0, 2 * Math.PI);
        double c = StrictMath.cos(yaw);
        double s = StrictMath.sin(yaw);
        double p = StrictMath.cos(pitch);
        double q = StrictMath.sin(pitch);
        double[] rotation = {c, s * q, s * p, 0, p, -q, -s, c * q, c * p};
        System.arraycopy(rotation, 0, row, at + Leaf.ROTATION, 9);
    }

    private void compare(String what, Test special, Test general) {
        double[][] nanos = Timing.inTurn(WARM_UP, ROUNDS, task(special), task(general));
        double each = 1.0 / (PAIRS * REPEATS);
        Timing.print(
                "%s: %.1f ns, %.1f ns, %.2f times",
                what, each * Timing.median(nanos[0]), each * Timing.median(nanos[1]), Timing.ratio(nanos[1], nanos[0]));
    }

    private static LongSupplier task(Test test) {
        return () -> {
            long count = 0;
            for (int repeat = 0; repeat < REPEATS; repeat++) {
                for (int at = 0; at < PAIRS * Leaf.STRIDE; at += Leaf.STRIDE) {
                    count += test.touch(at) ? 1 : 0;
                }
            }
            return count;
        };
    }
}
