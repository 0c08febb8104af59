package robosim.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.engine.motion.MotionSegment;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.Rotations;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;

/** Robots that move and turn for a long time come to where exact arithmetic says, and no worse in the end than early. */
@Tag("slow")
class LongRunTest {
    /** How many moves or turns; ten and a hundred times as many under the profile for stress. */
    private static final int STEPS = 100_000;

    private static final int LONG = Boolean.getBoolean("robosim.stress") ? 10 * STEPS : STEPS;
    private static final int VERY_LONG = Boolean.getBoolean("robosim.stress") ? 100 * STEPS : STEPS;

    /** Far from the origin, where a coordinate's ulp is 2^-44. */
    private static final Point AWAY = new Point(301.3, 0.1, -417.7);

    private static Geometry world(Dimension dimension, GeometryObject robot) {
        Geometry world = new Geometry(1000, 1000, 1000, dimension, Accuracy.EXACT);
        for (int x = -8; x <= 8; x += 2) {
            for (int z = -8; z <= 8; z += 2) {
                if (x * x + z * z > 20) {
                    addPost(world, x, z);
                }
            }
        }
        for (int side = 0; side < 4; side++) {
            double angle = 90 * side;
            Point middle =
                    new Point(AWAY.x() + (side % 2) * 9 * (side - 2), 0, AWAY.z() + (1 - side % 2) * 9 * (side - 1));
            assertThat(world.addObjectUnchecked(new BoxObject(middle, 0.2, 5, 20).turned(0, angle + 90)))
                    .isTrue();
        }
        assertThat(world.addObjectUnchecked(robot)).isTrue();
        return world;
    }

    private static void addPost(Geometry world, int x, int z) {
        Point at = new Point(AWAY.x() + x, 0.1, AWAY.z() + z);
        GeometryObject post =
                (x + z) % 4 == 0 ? new CylinderObject(at, 0.2, 5) : new BoxObject(at, 0.3, 5, 0.2).turned(0, 10 * x);
        assertThat(world.addObject(post)).isTrue();
    }

    private static BoxObject box(Point at) {
        return new BoxObject(at, 0.5, 0.25, 0.375).moveable("robot");
    }

    private static Point place(Geometry world) {
        return world.getObject("robot").center();
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aSquareEndsWhereItBegan(Dimension dimension) {
        for (double step : new double[] {0.75, 0.1, 1e-3 / 3}) {
            for (Point at : List.of(AWAY, new Point(-0.3, 0.1, 1e-3))) {
                Geometry world = world(dimension, box(at));
                GeometryObject start = world.getObject("robot");
                for (int k = 0; k < LONG / 10; k++) {
                    assertThat(world.simpleMove("robot", step, 0, 0)).isTrue();
                    assertThat(world.simpleTurn("robot", k % 8 < 4 ? 90 : -90)).isTrue();
                    if (k % 4 == 3) {
                        assertThat(world.getObject("robot")).as("after " + k).isEqualTo(start);
                    }
                }
            }
        }
    }

    /** A polygon of 3600 sides, over and over, against its corners to 30 digits: moves that are all alike err alike. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aPolygonDoesNotDrift(Dimension dimension) {
        double turn = 0.1;
        double step = 0.003;
        double[] turning = Turning.of(new BigDecimal(turn));
        double[] ahead = {1, 0, 0, 0}; // along X, and against Z
        double[] centre = {AWAY.x(), 0, -AWAY.z(), 0};
        Geometry world = world(dimension, box(AWAY));
        for (int k = 1; k <= LONG; k++) {
            assertThat(world.simpleMove("robot", step, 0, 0)).isTrue();
            assertThat(world.simpleTurn("robot", turn)).isTrue();
            Turning.addProduct(centre, 0, ahead[0], ahead[1], step, 0);
            Turning.addProduct(centre, 2, ahead[2], ahead[3], step, 0);
            Turning.turn(ahead, 0, 2, turning);
            if (isSampled(k)) {
                assertPlace(world, centre, k * step);
                BigDecimal heading = new BigDecimal(turn).multiply(new BigDecimal(k));
                assertHeading(world, heading);
            }
        }
    }

    private static boolean isSampled(int k) {
        return k == 1_000 || k == 3_600 || k == 10_000 || k == 100_000 || k == 1_000_000 || k == 10_000_000;
    }

    private static void assertPlace(Geometry world, double[] centre, double way) {
        Point at = place(world);
        double x = (at.x() - centre[0]) - centre[1];
        double z = (-at.z() - centre[2]) - centre[3];
        double ulps = Math.hypot(Math.ulp(at.x()), Math.ulp(at.z())) / 2;
        assertThat(Math.hypot(x, z))
                .as("after a way of " + way)
                .isLessThanOrEqualTo(MotionSegment.WAY_ERROR * way + ulps);
    }

    private static void assertHeading(Geometry world, BigDecimal exact) {
        double heading = world.getObject("robot").heading();
        assertThat(heading).isGreaterThan(-180).isLessThanOrEqualTo(180);
        BigDecimal off = new BigDecimal(heading).subtract(exact).remainder(new BigDecimal(360));
        double error = Math.abs(Math.IEEEremainder(off.doubleValue(), 360));
        double shown = Math.ulp(180.0) / 2;
        assertThat(error).isLessThanOrEqualTo(shown * (1 + 1e-6));
    }

    /** Out by random turns and steps among posts that refuse some of them, and back the same way. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aWayBackEndsWhereItBegan(Dimension dimension) {
        int steps = LONG / 4;
        GeometryObject robot = new CylinderObject(AWAY, 0.25, 0.5).moveable("robot");
        Geometry world = world(dimension, robot);
        double[] turns = new double[steps];
        double[] ways = new double[steps];
        SplittableRandom random = new SplittableRandom(36);
        int refused = 0;
        for (int k = 0; k < steps; k++) {
            turns[k] = random.nextDouble(-200, 200);
            ways[k] = random.nextDouble(-0.5, 0.5);
            assertThat(world.simpleTurn("robot", turns[k])).isTrue();
            if (!world.simpleMove("robot", ways[k], 0, 0)) {
                ways[k] = 0;
                refused++;
            }
        }
        assertThat(refused).isBetween(steps / 1000, steps / 4);
        assertThat(place(world)).isNotEqualTo(AWAY);
        for (int k = steps - 1; k >= 0; k--) {
            assertThat(world.simpleMove("robot", -ways[k], 0, 0))
                    .as("back " + k)
                    .isTrue();
            assertThat(world.simpleTurn("robot", -turns[k])).isTrue();
        }
        assertThat(world.getObject("robot")).isEqualTo(robot);
    }

    /** Steps too small for the coordinate to tell are not lost. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void theSmallestStepsAddUp(Dimension dimension) {
        Geometry world = world(dimension, box(AWAY));
        double step = Math.ulp(AWAY.x()) / 64;
        for (int k = 0; k < 64 * 100; k++) {
            assertThat(world.simpleMove("robot", step, 0, 0)).isTrue();
        }
        assertThat(place(world).x()).isEqualTo(AWAY.x() + 100 * Math.ulp(AWAY.x()));
    }

    /** A value carries all that its world knew of its place, so that a copy of the world goes on alike. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aCopyOfAWorldGoesOnAlike(Dimension dimension) {
        Geometry world = world(dimension, box(AWAY));
        SplittableRandom random = new SplittableRandom(7);
        for (int k = 0; k < 1000; k++) {
            Geometry copy = world(dimension, (BoxObject) world.getObject("robot"));
            double way = random.nextDouble(-0.3, 0.3);
            double turn = random.nextDouble(-1, 1);
            for (Geometry each : List.of(world, copy)) {
                each.simpleMove("robot", way, 0, 0);
                each.simpleTurn("robot", turn);
            }
            assertThat(copy.getObject("robot")).isEqualTo(world.getObject("robot"));
        }
        assertThat(place(world)).isNotEqualTo(AWAY);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aRefusedMoveKeepsEvenWhatWasLost(Dimension dimension) {
        Geometry world = world(dimension, box(AWAY));
        double half = Math.ulp(AWAY.x()) * 0.375;
        assertThat(world.simpleMove("robot", half, 0, 0)).isTrue();
        assertThat(world.simpleMove("robot", 1000, 0, 0)).isFalse();
        assertThat(world.move("robot", new Move(0, 0, 1000, 0, 3)).allowed()).isFalse();
        assertThat(place(world)).isEqualTo(AWAY);
        assertThat(world.simpleMove("robot", half, 0, 0)).isTrue();
        assertThat(place(world).x()).isEqualTo(Math.nextUp(AWAY.x()));
        assertThat(world.placeObject("robot", AWAY, 0)).isTrue();
        assertThat(world.simpleMove("robot", half, 0, 0)).isTrue();
        assertThat(place(world)).as("a placed object has lost nothing yet").isEqualTo(AWAY);
    }

    /** Turns about both axes, all through the world, against rotations to 30 digits. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aTippedObjectStaysARotation(Dimension dimension) {
        Geometry world = world(dimension, box(AWAY));
        Tumble tumble = new Tumble();
        double[] attitude = Attitude.identity();
        for (int k = 1; k <= STEPS / 10; k++) {
            tumble.next();
            assertThat(world.move("robot", new Move(0, 0, 0, tumble.rx(), tumble.ry()))
                            .allowed())
                    .isTrue();
            Attitude.turn(attitude, 0, tumble.rx(), tumble.ry());
            if (isSampled(k)) {
                double[] rotation = world.getObject("robot").rotation();
                assertThat(rotation).as("as computed alone").isEqualTo(Arrays.copyOf(attitude, 9));
                tumble.assertNear(rotation, 2 * k);
            }
        }
        assertThat(place(world)).isEqualTo(AWAY);
    }

    /** The same for longer, without a world around it. */
    @Test
    void manyTurnsAboutBothAxesStayWithinTheirBound() {
        Tumble tumble = new Tumble();
        double[] attitude = Attitude.identity();
        for (int k = 1; k <= VERY_LONG; k++) {
            tumble.next();
            Attitude.turn(attitude, 0, tumble.rx(), tumble.ry());
            if (isSampled(k)) {
                tumble.assertNear(attitude, 2 * k);
            }
        }
        tumble.assertNear(attitude, 2 * VERY_LONG);
        assertThat(tumble.worstDefect).as("the bound is not idle").isGreaterThan(Rotations.ORTHONORMALITY / 10);
    }

    /** Turns by angles that are drawn from a few, and their product to 30 digits: nine pairs, row-major. */
    private static final class Tumble {
        private final SplittableRandom random = new SplittableRandom(41);
        private final double[] degrees = {0.1, -0.1, 0.1, 37.2, -1e-3, 89.999, 200.5, 0.1};
        private final double[][] turnings = Arrays.stream(degrees)
                .mapToObj(angle -> Turning.of(new BigDecimal(angle)))
                .toArray(double[][]::new);
        private final double[] truth = new double[18];
        private int x;
        private int y;
        private double worstDefect;

        Tumble() {
            truth[0] = 1;
            truth[8] = 1;
            truth[16] = 1;
        }

        double rx() {
            return degrees[x];
        }

        double ry() {
            return degrees[y];
        }

        void next() {
            x = random.nextInt(degrees.length);
            y = random.nextInt(degrees.length);
            for (int row = 0; row < 18; row += 6) {
                Turning.turn(truth, row, row + 4, turnings[y]);
            }
            for (int row = 0; row < 18; row += 6) {
                Turning.turn(truth, row + 4, row + 2, turnings[x]);
            }
        }

        void assertNear(double[] r, int turns) {
            double angle = 0;
            for (int p = 0; p < 3; p++) {
                for (int q = 0; q < 3; q++) {
                    double[] product = {p == q ? -1 : 0, 0};
                    double[] towards = {p == q ? -1 : 0, 0};
                    for (int row = 0; row < 3; row++) {
                        int k = 3 * row;
                        Turning.addProduct(product, 0, r[k + p], 0, r[k + q], 0);
                        Turning.addProduct(towards, 0, r[k + p], 0, truth[2 * (k + q)], truth[2 * (k + q) + 1]);
                    }
                    worstDefect = Math.max(worstDefect, Math.abs(product[0]));
                    angle += p == q ? 0 : towards[0] * towards[0];
                }
            }
            assertThat(worstDefect).as("after " + turns).isLessThanOrEqualTo(Rotations.ORTHONORMALITY);
            assertThat(Math.sqrt(angle / 2))
                    .as("radians after " + turns)
                    .isLessThanOrEqualTo(turns * Rotations.TURN_ERROR);
        }
    }
}
