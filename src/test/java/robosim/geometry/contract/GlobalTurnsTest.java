package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Global moves turn about the world's axes through the object's centre. */
class GlobalTurnsTest {
    private static Geometry world(Dimension dimension, GeometryObject... objects) {
        Geometry world = new Geometry(64, 64, 64, dimension, Accuracy.EXACT);
        for (GeometryObject object : objects) {
            assertThat(world.addObjectUnchecked(object)).isTrue();
        }
        return world;
    }

    private static GeometryObject bar(double rx, double ry) {
        return new BoxObject(new Point(1, 2, 3), 4, 0.5, 0.25)
                .turned(0, ry)
                .turned(rx, 0)
                .moveable("bar");
    }

    /** The rotation about an axis of the world, by its definition. */
    private static double[] about(int axis, double degrees) {
        double c = StrictMath.cos(StrictMath.toRadians(degrees));
        double s = StrictMath.sin(StrictMath.toRadians(degrees));
        return axis == 0 ? new double[] {1, 0, 0, 0, c, -s, 0, s, c} : new double[] {c, 0, s, 0, 1, 0, -s, 0, c};
    }

    private static double[] product(double[] a, double[] b) {
        double[] product = new double[9];
        for (int k = 0; k < 9; k++) {
            int row = k / 3 * 3;
            product[k] = a[row] * b[k % 3] + a[row + 1] * b[3 + k % 3] + a[row + 2] * b[6 + k % 3];
        }
        return product;
    }

    @Test
    void firstAboutTheVerticalThenAboutX() {
        SplittableRandom random = new SplittableRandom(81);
        for (int k = 0; k < 500; k++) {
            GeometryObject bar = bar(k % 4 == 0 ? 0 : random.nextDouble(-180, 180), random.nextDouble(-180, 180));
            Geometry world = world(Dimension.SPATIAL, bar);
            Move move = new Move(1, 0.5, -1, random.nextDouble(-300, 300), random.nextDouble(-300, 300));
            assertThat(world.moveGlobal("bar", move).allowed()).isTrue();
            GeometryObject moved = world.getObject("bar");
            double[] expected = product(about(0, move.rx()), product(about(1, move.ry()), bar.rotation()));
            for (int n = 0; n < 9; n++) {
                assertThat(moved.rotation()[n]).isBetween(expected[n] - 1e-14, expected[n] + 1e-14);
            }
            assertThat(moved.center()).isEqualTo(new Point(2, 2.5, 2));
        }
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void uprightOnesTurnAsAboutTheirOwnY(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(82);
        Geometry own = world(dimension, bar(0, 17));
        Geometry global = world(dimension, bar(0, 17));
        for (int k = 0; k < 300; k++) {
            double ry = k % 5 == 0 ? 90 : random.nextDouble(-400, 400);
            assertThat(own.move("bar", new Move(0, 0, 0, 0, ry)).allowed()).isTrue();
            assertThat(global.moveGlobal("bar", new Move(0, 0, 0, 0, ry)).allowed())
                    .isTrue();
            assertThat(global.getObject("bar")).isEqualTo(own.getObject("bar"));
        }
    }

    @Test
    void fourQuarterTurnsReturnToTheBit() {
        SplittableRandom random = new SplittableRandom(83);
        for (int k = 0; k < 200; k++) {
            GeometryObject bar = bar(random.nextDouble(-180, 180), random.nextDouble(-180, 180));
            Geometry world = world(Dimension.SPATIAL, bar);
            double quarter = k % 2 == 0 ? 90 : -90;
            for (int n = 0; n < 4; n++) {
                Move move = k % 4 < 2 ? new Move(0, 0, 0, quarter, 0) : new Move(0, 0, 0, 0, quarter);
                assertThat(world.moveGlobal("bar", move).allowed()).isTrue();
            }
            assertThat(world.getObject("bar").rotation()).containsExactly(bar.rotation());
        }
    }

    @Test
    void inThePlaneTheTurnAboutXIsLeftOut() {
        Geometry world = world(Dimension.PLANAR, bar(0, 30));
        MoveResult result = world.moveGlobal("bar", new Move(0, 0, 0, 40, 20));
        assertThat(result.allowed()).isTrue();
        assertThat(world.getObject("bar")).isEqualTo(bar(0, 50));
    }

    /** A bar on end, tipped, sweeps a cone about the vertical: posts beside it block where they stand in the cone's way. */
    @Test
    void nothingIsPassedThrough() {
        SplittableRandom random = new SplittableRandom(84);
        int made = 0;
        int refused = 0;
        for (int k = 0; k < 400; k++) {
            GeometryObject bar = bar(random.nextDouble(-180, 180), random.nextDouble(-180, 180));
            Point at =
                    new Point(1 + random.nextDouble(-2, 2), 2 + random.nextDouble(-2, 2), 3 + random.nextDouble(-2, 2));
            GeometryObject post = k % 2 == 0
                    ? new SphereObject(at, random.nextDouble(0.3))
                    : new CylinderObject(at, 0.1, random.nextDouble(2));
            Geometry rest = world(Dimension.SPATIAL, post);
            if (rest.testObject(bar)) {
                continue;
            }
            Geometry world = world(Dimension.SPATIAL, post, bar);
            boolean isAboutX = k % 3 == 0;
            double degrees = random.nextDouble(-350, 350);
            Move move = isAboutX ? new Move(0, 0, 0, degrees, 0) : new Move(0, 0, 0, 0, degrees);
            MoveResult result = world.moveGlobal("bar", move);
            double free = result.allowed() ? 1 : result.turnFraction();
            for (int n = 0; n <= 2000; n++) {
                double[] turn = about(isAboutX ? 0 : 1, degrees * free * (n / 2000.0) * (1 - 1e-12));
                GeometryObject there = bar.oriented(product(turn, bar.rotation()));
                if (rest.testObject(there)) {
                    assertThat(rest.testObject(there))
                            .as("%s by %s beside %s: %s", bar, move, post, result)
                            .isFalse();
                }
            }
            if (result.allowed()) {
                made++;
            } else {
                refused++;
                double[] turn = about(isAboutX ? 0 : 1, degrees * Math.min(1, free + 1e-6));
                assertThat(rest.testObject(bar.oriented(product(turn, bar.rotation()))))
                        .as("%s by %s beside %s: %s", bar, move, post, result)
                        .isTrue();
                assertThat(world.getObject("bar")).isEqualTo(bar);
            }
        }
        assertThat(made).isGreaterThan(60);
        assertThat(refused).isGreaterThan(60);
    }
}
