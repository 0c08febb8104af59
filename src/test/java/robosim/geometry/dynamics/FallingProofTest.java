package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Vectors;

/**
 * What holds after every step in space, on random and adversarial input: nothing overlaps, which is decided exactly; nothing has
 * passed through anything; energy has not grown. {@code -Ddynamics.steps=N} for more steps.
 */
@Tag("slow")
class FallingProofTest {
    private static final int STEPS = Integer.getInteger("dynamics.steps", 600);

    /** Of one run, after which the next has other shapes. */
    private static final int STEPS_A_RUN = 30;

    private static double[] rotation(SplittableRandom random) {
        while (true) {
            double w = random.nextDouble(-1, 1);
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double z = random.nextDouble(-1, 1);
            double square = w * w + x * x + y * y + z * z;
            if (square > 0.1 && square < 1) {
                double size = Math.sqrt(square);
                return Vectors.rotation(2, w / size, x / size, y / size, z / size);
            }
        }
    }

    private static GeometryObject shape(SplittableRandom random, Point at) {
        return switch (random.nextInt(4)) {
            case 0 -> new SphereObject(at, random.nextDouble(0.2, 0.6));
            case 1 ->
                new BoxObject(
                        at, random.nextDouble(0.2, 1.2), random.nextDouble(0.2, 1.2), random.nextDouble(0.2, 1.2));
            case 2 -> new CylinderObject(at, random.nextDouble(0.1, 0.6), random.nextDouble(0.1, 1.1));
            default -> new CapsuleObject(at, random.nextDouble(0.1, 0.4), random.nextDouble(0, 1.2));
        };
    }

    private static Point point(SplittableRandom random, double low, double high) {
        return new Point(random.nextDouble(-2, 2), random.nextDouble(low, high), random.nextDouble(-2, 2));
    }

    /** A closed room of sheets as thin as they can be, or nearly so, with things standing about in it. */
    private static Geometry room(SplittableRandom random) {
        Geometry world = FallingTest.world();
        double thick = random.nextBoolean() ? 0 : 1e-6;
        world.addObjectUnchecked(new BoxObject(new Point(0, -thick / 2, 0), 6.1, thick, 6.1).named("floor"));
        world.addObjectUnchecked(new BoxObject(new Point(0, 4 + thick, 0), 6.1, thick, 6.1));
        for (int side = -1; side <= 1; side += 2) {
            world.addObjectUnchecked(new BoxObject(new Point(3 * side, 2, 0), thick, 4.1, 6.1));
            world.addObjectUnchecked(new BoxObject(new Point(0, 2, 3 * side), 6.1, 4.1, thick));
        }
        for (int k = 0; k < 3; k++) {
            GeometryObject stands = shape(random, point(random, 0, 1.2));
            world.addObjectUnchecked(random.nextBoolean() ? stands : stands.oriented(rotation(random)));
        }
        return world;
    }

    /** Kinetic and potential energy. */
    static double energy(Geometry world, Dynamics dynamics) {
        double sum = 0;
        for (String name : dynamics.names()) {
            Body body = dynamics.body(name);
            GeometryObject object = world.getObject(name);
            double[] moments = body.moments(object);
            SpatialVelocity v = dynamics.spatialVelocity(name);
            double[] r = object.pose().rotation();
            double turning = 0;
            for (int k = 0; k < 3; k++) {
                double along = StrictMath.toRadians(r[k] * v.rx() + r[3 + k] * v.ry() + r[6 + k] * v.rz());
                turning += moments[k] * along * along;
            }
            sum += 0.5 * body.mass() * v.speed() * v.speed()
                    + 0.5 * turning
                    + body.mass() * Body.GRAVITY * object.center().y();
        }
        return sum;
    }

    private static Dynamics bodies(SplittableRandom random, Geometry world, int count, boolean isDamped) {
        Dynamics dynamics = new Dynamics(world, new Surface(random.nextDouble(), 0.7, random.nextDouble(0, 0.7)));
        for (int k = 0; k < count; k++) {
            GeometryObject shape = shape(random, point(random, 1, 3));
            String name = "body" + k;
            if (world.addObject(shape.oriented(rotation(random)).moveable(name))) {
                Surface surface = new Surface(random.nextInt(3) == 0 ? 1 : random.nextDouble(), 0.8, 0.5);
                Body body = Body.ofMass(shape, random.nextDouble(0.5, 5)).withSurface(surface);
                dynamics.add(name, isDamped ? body.withDamping(0.5, 0.5) : body);
                double speed = random.nextInt(3) == 0 ? StrictMath.pow(10, random.nextDouble(0, 4)) : 3;
                double turn = random.nextInt(4) == 0 ? 30_000 : 400;
                dynamics.setSpatialVelocity(
                        name,
                        new SpatialVelocity(
                                speed * random.nextDouble(-1, 1),
                                speed * random.nextDouble(-1, 1),
                                speed * random.nextDouble(-1, 1),
                                turn * random.nextDouble(-1, 1),
                                turn * random.nextDouble(-1, 1),
                                turn * random.nextDouble(-1, 1)));
            }
        }
        return dynamics;
    }

    @Test
    void nothingOverlapsNothingIsPassedThroughAndEnergyNeverGrows() {
        int steps = 0;
        int touching = 0;
        StopCount stops = new StopCount();
        for (int run = 0; steps < STEPS; run++) {
            SplittableRandom random = new SplittableRandom(run);
            Geometry world = room(random);
            Dynamics dynamics = bodies(random, world, 1 + random.nextInt(3), random.nextBoolean());
            double energy = energy(world, dynamics);
            for (int k = 0; k < STEPS_A_RUN; k++, steps++) {
                double seconds = new double[] {0.001, 0.01, 0.03, 0.1}[random.nextInt(4)];
                StepResult result = dynamics.step(seconds);
                String when = "run " + run + ", step " + k;
                for (String name : dynamics.names()) {
                    FallingTest.assertApart(world, name, when);
                    Point at = world.getObject(name).center();
                    boolean isInside = Math.abs(at.x()) < 3 && at.y() > 0 && at.y() < 4.1 && Math.abs(at.z()) < 3;
                    assertThat(isInside).as("%s: %s", when, at).isTrue();
                }
                double now = energy(world, dynamics);
                assertThat(now).as(when).isLessThanOrEqualTo(energy + 1e-9 * (1 + energy));
                energy = now;
                touching += result.contacts().isEmpty() ? 0 : 1;
                stops.add(result, dynamics.names().size(), when);
            }
        }
        assertThat(touching).isBetween(steps / 5, steps - 1); // a sample without contacts proves nothing
        stops.assertAtMost(0);
    }

    @Test
    void nothingPassesThroughAThinFloorAtTenKilometresASecond() {
        for (int run = 0; run < Effort.cases(40); run++) {
            SplittableRandom random = new SplittableRandom(run);
            Geometry world = FallingTest.world();
            double thick = run % 2 == 0 ? 0 : 1e-9;
            world.addObject(new BoxObject(new Point(0, -thick / 2, 0), 100, thick, 100).named("sheet"));
            GeometryObject shape = shape(random, new Point(0, 5, 0));
            world.addObject(shape.oriented(rotation(random)).moveable("body"));
            Dynamics dynamics = new Dynamics(world, new Surface(0, 0.5, 0.5));
            dynamics.add(
                    "body", Body.ofMass(shape, 1).withDamping(0, 1).withSurface(new Surface(0.1 * (run % 3), 1, 1)));
            double turn = run % 4 < 2 ? 0 : 20_000;
            dynamics.setSpatialVelocity("body", new SpatialVelocity(50, -10_000, 20, turn, -turn / 2, turn / 3));
            for (double seconds : new double[] {0.001, 1, 0.0001, 0.05}) {
                dynamics.step(seconds);
                FallingTest.assertApart(world, "body", "run " + run);
                assertThat(world.getObject("body").center().y())
                        .as("run %d", run)
                        .isPositive();
            }
        }
    }

    @Test
    void stepsOfASecondAndOfAMillisecondAgreeOnRest() {
        for (int run = 0; run < Effort.cases(12); run++) {
            List<Point> rests = new ArrayList<>();
            for (int parts : new int[] {1, 1000}) {
                SplittableRandom random = new SplittableRandom(1000 + run);
                Geometry world = FallingTest.floor();
                GeometryObject shape = shape(random, new Point(0, 1.5, 0));
                world.addObject(shape.oriented(rotation(random)).moveable("body"));
                Surface surface = new Surface(0.2, 0.6, 0.5);
                Dynamics dynamics = new Dynamics(world, surface);
                dynamics.add("body", Body.ofMass(shape, 1).withDamping(1, 2).withSurface(surface));
                for (int k = 0; k < 20 * parts; k++) {
                    dynamics.advance(1.0 / parts);
                }
                assertThat(dynamics.spatialVelocity("body")).as("run %d", run).isEqualTo(SpatialVelocity.REST);
                rests.add(world.getObject("body").center());
            }
            assertThat(rests.get(1).x())
                    .as("run %d", run)
                    .isCloseTo(rests.get(0).x(), within(1e-6));
            assertThat(rests.get(1).y())
                    .as("run %d", run)
                    .isCloseTo(rests.get(0).y(), within(1e-6));
            assertThat(rests.get(1).z())
                    .as("run %d", run)
                    .isCloseTo(rests.get(0).z(), within(1e-6));
        }
    }

    @Test
    void theBitsAreTheSameEverywhere() {
        long digest = 17;
        for (int run = 0; run < 6; run++) {
            SplittableRandom random = new SplittableRandom(77 + run);
            Geometry world = room(random);
            Dynamics dynamics = bodies(random, world, 3, true);
            for (int k = 0; k < 10; k++) {
                dynamics.step(0.05);
                for (String name : dynamics.names()) {
                    double[] r = world.getObject(name).pose().rotation();
                    Point at = world.getObject(name).center();
                    for (double number : new double[] {at.x(), at.y(), at.z(), r[0], r[1], r[5]}) {
                        digest = 31 * digest + Double.doubleToLongBits(number);
                    }
                }
            }
        }
        assertThat(Long.toHexString(digest)).isEqualTo("f0dc869816145d42");
    }
}
