package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.WorkLimit;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** Steps that end with an exception, again and again, against a twin that never made them: all later bits are the same. */
class EndedStepsTest {
    private static final int BODIES = 24;
    private static final Surface SURFACE = new Surface(0.3, 0.4, 0.3);

    private static Geometry world(Dimension dimension) {
        Geometry world = new Geometry(16, 10, 16, dimension, Accuracy.EXACT);
        if (dimension == Dimension.SPATIAL) {
            world.addObject(new BoxObject(new Point(0, -4.5, 0), 16, 1, 16).named("floor"));
        }
        for (int k = 0; k < BODIES; k++) {
            Point at = dimension == Dimension.PLANAR
                    ? new Point(k % 6 * 1.3 - 4, 0, k / 6 * 1.3 - 3)
                    : new Point(k % 4 * 1.6 - 3, -3.4 + k / 12 * 1.1, k / 4 % 3 * 1.6 - 2);
            GeometryObject shape = k % 2 == 0 ? new BoxObject(at, 1, 1, 1) : new SphereObject(at, 0.5);
            world.addObject(shape.moveable("b" + k));
        }
        return world;
    }

    private static void add(Dynamics dynamics, String name, double mass) {
        GeometryObject object = dynamics.world().getObject(name);
        dynamics.add(name, Body.ofMass(object, mass).withSurface(SURFACE).withFloorFriction(0.2));
    }

    /** Ends a step of another body somewhere on its way; whether a limit of work did, and not its end. */
    private static boolean isEnded(Dynamics dynamics, String name, long work) {
        dynamics.world().limitWork(WorkLimit.of(work));
        boolean isMade = false;
        try {
            dynamics.together(() -> {
                add(dynamics, name, 3);
                dynamics.setVelocity(name, new Twist(1, 0, 1, 9));
                dynamics.advance(1);
                throw new IllegalStateException("made, and taken back");
            });
        } catch (IllegalStateException made) {
            isMade = true;
        } catch (RuntimeException ended) {
            assertThat(ended).hasMessageContaining("units of work");
        }
        dynamics.world().limitWork(WorkLimit.none());
        return !isMade;
    }

    private static void change(Dynamics dynamics, int what, String name, Twist velocity) {
        if (what == 0) {
            add(dynamics, name, 1 + Math.abs(velocity.x()));
        } else if (dynamics.has(name) && what == 1) {
            dynamics.setVelocity(name, velocity);
        } else if (dynamics.has(name) && what == 2) {
            dynamics.drive(name, new VelocityDrive(new Twist(velocity.x() / 4, 0, velocity.z() / 4, 10)));
        } else if (dynamics.has(name)) {
            dynamics.clearDrive(name);
        }
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void leaveNothingBehind(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(99);
        Dynamics often = new Dynamics(world(dimension), SURFACE);
        Dynamics twin = new Dynamics(world(dimension), SURFACE);
        int ended = 0;
        int rounds = Effort.cases(320);
        for (int round = 0; round < rounds; round++) {
            ended += isEnded(often, "b" + random.nextInt(BODIES), random.nextInt(1, 400)) ? 1 : 0;
            String name = "b" + random.nextInt(BODIES);
            Twist velocity =
                    new Twist(random.nextDouble(-2, 2), 0, random.nextDouble(-2, 2), random.nextDouble(-90, 90));
            int what = random.nextInt(4);
            double seconds = random.nextDouble(0.005, 0.05);
            for (Dynamics each : new Dynamics[] {often, twin}) {
                change(each, what, name, velocity);
                each.advance(seconds);
            }
            for (int k = 0; k < BODIES; k++) {
                assertThat(often.world().getObject("b" + k).pose())
                        .as("b" + k + " in round " + round)
                        .isEqualTo(twin.world().getObject("b" + k).pose());
            }
        }
        assertThat(ended).isGreaterThan(rounds / 2);
    }
}
