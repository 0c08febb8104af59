package robosim.geometry.dynamics.planar;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.engine.World;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** How many collisions a step has. */
class CollisionsTest {
    /** As many as a body's velocity may change fast, and one more, after which it is held. */
    private static final int FAST = 49;

    /** So often a pair meets slowly: thrice, and then after pauses of 2^-10, 2^-8 and so on of the step. */
    private static final int SLOW = 9;

    /** Elastic, slow, sticky: whatever the surface, the speed and the length of the step. */
    @Test
    void aStepHasABoundedNumberOfCollisions() {
        SplittableRandom random = new SplittableRandom(3);
        int most = 0;
        for (int run = 0; run < 60; run++) {
            int count = random.nextInt(2, 10);
            Geometry world = new Geometry(3, 2, 3, Dimension.PLANAR, Accuracy.EXACT);
            PlanarStepper stepper = new PlanarStepper(world.engine());
            World engine = world.engine();
            double speed = Math.pow(10, random.nextDouble(-3, 4));
            int bodies = 0;
            for (int k = 0; k < count; k++) {
                Point c = new Point(random.nextDouble(-1.2, 1.2), 0, random.nextDouble(-1.2, 1.2));
                GeometryObject shape = k % 2 == 0
                        ? new CylinderObject(c, 0.2, 1)
                        : new BoxObject(c, 0.5, 1, 0.2).turned(0, random.nextDouble(90));
                if (world.addObject(shape.moveable("b" + k))) {
                    stepper.add(engine.mover("b" + k), 1, 0.02);
                    bodies++;
                }
            }
            double bounce = run % 3 == 0 ? 1 : random.nextDouble();
            double friction = run % 2 == 0 ? 0 : random.nextDouble();
            ContactSurfaces surfaces = surfaces(bounce, friction);
            stepper.build(surfaces);
            stepper.begin();
            for (int b = 0; b < bodies; b++) {
                stepper.setVelocity(
                        b,
                        speed * random.nextDouble(-1, 1),
                        speed * random.nextDouble(-1, 1),
                        random.nextDouble(-4, 4));
            }
            stepper.run(random.nextDouble(2), surfaces, (body, angle, round) -> false);
            // Each pair of bodies, and each body with each side of the border.
            int pairs = bodies * (bodies - 1) / 2 + 4 * bodies;
            assertThat(stepper.collisions).as("run %d", run).isLessThanOrEqualTo(FAST * bodies + SLOW * pairs);
            most = Math.max(most, stepper.collisions / bodies);
        }
        // Some of them reach what a body may have.
        assertThat(most).isBetween(FAST / 4, FAST + 9 * SLOW);
    }

    private static ContactSurfaces surfaces(double bounce, double friction) {
        return new ContactSurfaces() {
            @Override
            public double restitution(int object) {
                return bounce;
            }

            @Override
            public double staticFriction(int object) {
                return friction;
            }

            @Override
            public double mixRestitution(double a, double b) {
                return Math.sqrt(a * b);
            }

            @Override
            public double mixFriction(double a, double b) {
                return Math.sqrt(a * b);
            }

            @Override
            public double slidingFriction(int object) {
                return friction;
            }
        };
    }
}
