package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** No step traps a body: after each step, the way that it has just come is free again. */
class ReversedStepTest {
    private static GeometryObject shape(int kind, Point at, double size, SplittableRandom random) {
        return switch (kind) {
            case 0 -> new BoxObject(at, size, size * random.nextDouble(0.3, 1), size * random.nextDouble(0.1, 1));
            case 1 -> new CylinderObject(at, size / 2, size);
            case 2 -> new SphereObject(at, size / 2);
            default -> new CapsuleObject(at, size / 3, size / 2);
        };
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void theWayThatLedHereIsFree(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(5 + dimension.ordinal());
        int steps = 0;
        int pressed = 0;
        int untouched = 0;
        for (int run = 0; run < Effort.cases(80, 24); run++) {
            Geometry world = new Geometry(400, 400, 400, dimension, Accuracy.EXACT);
            double large = random.nextInt(3) == 0 ? 100 : 3;
            GeometryObject wall = shape(random.nextInt(4), new Point(), large, random)
                    .turned(0, random.nextInt(3) == 0 ? 0 : random.nextDouble(-180, 180));
            GeometryObject upright = shape(run % 4, new Point(large, 0, 0.1 * large), 0.6, random);
            boolean isTipped = dimension == Dimension.SPATIAL && random.nextBoolean();
            GeometryObject body = upright.turned(isTipped ? 90 : 0, random.nextDouble(-180, 180))
                    .moveable("b");
            assertThat(world.addObject(wall)).isTrue();
            if (!world.addObject(body)) {
                continue;
            }
            Dynamics dynamics = new Dynamics(world, new Surface(random.nextDouble(), 0.5, 0));
            dynamics.add("b", Body.ofMass(upright, 1));
            for (int step = 0; step < 12; step++) {
                Point from = world.getObject("b").center();
                double slow = random.nextInt(4) == 0 ? 0.01 : 1;
                dynamics.setVelocity(
                        "b",
                        new Twist(
                                slow * large * (-2 * from.x() / large + random.nextDouble(-1, 1)),
                                0,
                                slow * large * (-2 * from.z() / large + random.nextDouble(-1, 1)),
                                random.nextInt(2) * random.nextDouble(-90, 90)));
                boolean isTouched =
                        !dynamics.step(random.nextDouble(0.02, 0.4)).contacts().isEmpty();
                Point to = world.getObject("b").center();
                Move back = new Move(
                        0.999 * (from.x() - to.x()), 0.999 * (from.y() - to.y()), 0.999 * (from.z() - to.z()), 0, 0);
                if (Math.abs(back.x()) + Math.abs(back.y()) + Math.abs(back.z()) < 1e-6) {
                    continue;
                }
                steps++;
                pressed += isTouched ? 1 : 0;
                MoveResult result = world.snapshot().toGeometry().moveGlobal("b", back);
                String what = "%s from %s beside %s: %s".formatted(world.getObject("b"), from, wall, result);
                // Who has turned, or has gone round a corner, may not fit through all of the way; but off it comes.
                assertThat(result.allowed() || result.fraction() > 0).as(what).isTrue();
                untouched += result.allowed() ? 1 : 0;
            }
        }
        assertThat(steps).isGreaterThan(100);
        assertThat(pressed).isGreaterThan(steps / 10);
        assertThat(untouched).isGreaterThan(steps * 9 / 10);
    }
}
