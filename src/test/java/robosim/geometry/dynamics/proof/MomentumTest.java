package robosim.geometry.dynamics.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.ForceDrive;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** Forces times time, less what walls give, are what the momentum changes by, in each step and whatever is in the way. */
class MomentumTest {
    /** Steps of one part: then a force has one direction in a step. */
    private static final double LONGEST = 1.0 / 16;

    private static final double BOUND = 1e-9;

    private final int effort = (int) Math.max(1, 40 * Double.parseDouble(System.getProperty("test.effort", "1")));
    private int bodySteps;
    private int pressed;
    private int stopped;

    private static double wholeMetres(SplittableRandom random) {
        return random.nextInt(3) == 0 ? 1e-9 : random.nextDouble(1e-9, 0.3);
    }

    /** A row of smooth discs between two walls: each body's momentum by itself, as all normals lie along the row. */
    @Test
    void forcesLessContactsAreTheChangeOfMomentumInARow() {
        SplittableRandom random = new SplittableRandom(41);
        for (int run = 0; run < 4 * effort; run++) {
            Geometry world = new Geometry(60, 3, 8, Dimension.PLANAR, Accuracy.EXACT);
            Surface surface = new Surface(random.nextBoolean() ? 0 : random.nextDouble(), 0, 0);
            Dynamics dynamics = new Dynamics(world, surface);
            int count = random.nextInt(1, 5);
            double[] mass = new double[count];
            double edge = -10;
            world.addObject(new BoxObject(new Point(edge - 0.5, 0, 0), 1, 1, 3).named("left"));
            for (int k = 0; k < count; k++) {
                double size = random.nextDouble(0.3, 1);
                edge += wholeMetres(random);
                // Round: a box that is off by an ulp lands on a corner, and turns, and then its normals do not lie
                // along the row.
                Point at = new Point(edge + size / 2, 0, 0);
                assertThat(world.addObject(new CylinderObject(at, size / 2, 0.5).moveable("b" + k)))
                        .isTrue();
                edge += size;
                mass[k] = Math.exp(random.nextDouble(-2, 4));
                dynamics.add("b" + k, Body.of(mass[k], mass[k]).withSurface(surface));
            }
            edge += wholeMetres(random);
            world.addObject(new BoxObject(new Point(edge + 0.5, 0, 0), 1, 1, 3).named("right"));
            double seconds = random.nextInt(3) == 0 ? LONGEST : random.nextDouble(1e-3, LONGEST);
            double[] force = new double[count];
            for (int step = 0; step < 30; step++) {
                double[] momentum = new double[count];
                double scale = 1;
                for (int k = 0; k < count; k++) {
                    if (random.nextInt(3) == 0) {
                        force[k] = random.nextInt(3) == 0 ? 0 : mass[k] * random.nextDouble(-5, 5);
                        dynamics.drive("b" + k, new ForceDrive(force[k], 0, 0));
                    }
                    momentum[k] = mass[k] * dynamics.velocity("b" + k).x();
                    scale = Math.max(scale, Math.abs(momentum[k]));
                }
                StepResult result = dynamics.step(seconds);
                if (!result.stopped().isEmpty()) {
                    stopped++; // it loses what it had
                    continue;
                }
                for (int k = 0; k < count; k++) {
                    double given = force[k] * seconds + impulse(result, "b" + k);
                    pressed += impulse(result, "b" + k) != 0 ? 1 : 0;
                    bodySteps++;
                    assertThat(mass[k] * dynamics.velocity("b" + k).x() - momentum[k])
                            .as("run %d, step %d of %s s, body %d of %d", run, step, seconds, k, count)
                            .isCloseTo(given, within(BOUND * scale));
                }
            }
        }
        assertThat(pressed).isBetween(bodySteps / 5, bodySteps * 9 / 10);
        assertThat(stopped).isLessThanOrEqualTo(bodySteps / 1000);
    }

    /** Two smooth boxes face to face, pushed in pulses: both halves of each push get through, whatever the pauses. */
    @Test
    void pulsesOfAPushThatBeginsInContactAreNotLost() {
        for (double seconds : new double[] {0.004, 0.02, 0.05}) {
            for (int pauses : new int[] {0, 1, 2, 5}) {
                Geometry world = new Geometry(16.5, 3, 8, Dimension.PLANAR, Accuracy.EXACT);
                Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
                for (int k = 0; k < 2; k++) {
                    double x = (k == 0 ? -0.45 - 1e-9 : 0.45) - 5;
                    world.addObject(new BoxObject(new Point(x, 0, 0), 0.9, 0.5, 0.9).moveable("b" + k));
                    dynamics.add("b" + k, Body.of(50, 6.75));
                }
                double given = 0;
                for (int pulse = 0; pulse < 20; pulse++) {
                    dynamics.drive("b0", new ForceDrive(200, 0, 0));
                    StepResult result = dynamics.step(seconds);
                    given += 200 * seconds;
                    assertThat(impulse(result, "b1")).isCloseTo(100 * seconds, within(BOUND));
                    dynamics.drive("b0", new ForceDrive(0, 0, 0));
                    for (int k = 0; k < pauses; k++) {
                        dynamics.step(seconds);
                    }
                }
                double momentum = 50
                        * (dynamics.velocity("b0").x() + dynamics.velocity("b1").x());
                assertThat(momentum).as("%s s, %d pauses", seconds, pauses).isCloseTo(given, within(BOUND));
            }
        }
    }

    /** Against a wall it is the wall that gets it, from the first step on. */
    @Test
    void aWallGetsAllOfAPush() {
        Geometry world = new Geometry(16.5, 3, 8, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(0.5, 0, 0), 1, 1, 3));
        world.addObject(new BoxObject(new Point(-0.25 - 1e-9, 0, 0), 0.5, 0.5, 0.5).moveable("b0"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("b0", Body.of(50, 6.75));
        dynamics.drive("b0", new ForceDrive(200, 0, 0));
        for (int step = 0; step < 5; step++) {
            assertThat(impulse(dynamics.step(0.02), "b0")).isCloseTo(-4, within(BOUND));
            assertThat(dynamics.velocity("b0").x()).isCloseTo(0, within(BOUND));
        }
    }

    /** Nobody has to make room by more than the gaps that touching bodies keep: that is no reason to stop anybody. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 30})
    void bodiesPackedInExactContactAreAtRest(double turned) {
        Geometry world = new Geometry(60, 3, 60, Dimension.PLANAR, Accuracy.EXACT);
        Dynamics dynamics = new Dynamics(world, new Surface(0.2, 0.4, 0.3));
        double cos = 0.3 * Math.cos(Math.toRadians(turned));
        double sin = 0.3 * Math.sin(Math.toRadians(turned));
        for (int k = 0; k < 16; k++) {
            int i = k / 4;
            int j = k % 4;
            GeometryObject box = new BoxObject(new Point(i * cos + j * sin, 0, j * cos - i * sin), 0.3, 0.5, 0.3)
                    .turned(0, turned)
                    .moveable("b" + k);
            assertThat(world.addObjectUnchecked(box)).isTrue();
            dynamics.add("b" + k, Body.ofMass(box, 5));
        }
        for (int step = 0; step < 3; step++) {
            assertThat(dynamics.step(0.05).stopped()).isEmpty();
            for (int k = 0; k < 16; k++) {
                Twist velocity = dynamics.velocity("b" + k);
                assertThat(Math.hypot(velocity.x(), velocity.z())).isLessThan(1e-8);
            }
        }
    }

    /** What contacts gave a body along X; the normal points to the body that is named first. */
    private static double impulse(StepResult result, String name) {
        double sum = 0;
        for (BodyContact contact : result.contacts()) {
            double along = contact.normal().x() * contact.impulse();
            sum += contact.body().equals(name) ? along : name.equals(contact.other()) ? -along : 0;
        }
        return sum;
    }

    /** Turned bodies with friction and nothing else around: what contacts give cancels, forces do not. */
    @Test
    void contactsOfFreeBodiesGiveThemNothingTogether() {
        SplittableRandom random = new SplittableRandom(42);
        for (int run = 0; run < 4 * effort; run++) {
            Geometry world = new Geometry(400, 3, 400, Dimension.PLANAR, Accuracy.EXACT);
            Surface surface =
                    new Surface(random.nextBoolean() ? 0 : random.nextDouble(), 0.5, random.nextBoolean() ? 0 : 0.4);
            Dynamics dynamics = new Dynamics(world, surface);
            int count = random.nextInt(2, 6);
            double[] mass = new double[count];
            for (int k = 0; k < count; k++) {
                GeometryObject object;
                do {
                    Point at = new Point(random.nextDouble(-0.9, 0.9), 0, random.nextDouble(-0.9, 0.9));
                    object = random.nextBoolean()
                            ? new CylinderObject(at, random.nextDouble(0.1, 0.3), 1).moveable("b" + k)
                            : new BoxObject(at, random.nextDouble(0.2, 0.6), 1, random.nextDouble(0.2, 0.6))
                                    .turned(0, random.nextDouble(360))
                                    .moveable("b" + k);
                } while (!world.addObject(object));
                mass[k] = Math.exp(random.nextDouble(-1, 3));
                dynamics.add("b" + k, Body.ofMass(object, mass[k]).withSurface(surface));
            }
            double seconds = random.nextDouble(1e-3, LONGEST);
            for (int step = 0; step < 80; step++) {
                double[] given = new double[2];
                double[] before = momentum(world, dynamics, mass);
                double fastest = 0;
                for (int k = 0; k < count; k++) {
                    fastest = Math.max(
                            fastest, Math.abs(dynamics.velocity("b" + k).ry()));
                }
                // What turns by more than 0.5 rad divides the step; then a force has several directions.
                double most = Math.toRadians(fastest) * seconds < 0.49 ? 9 : 0;
                for (int k = 0; k < count; k++) {
                    // Towards the middle, mostly: so that they press against each other.
                    GeometryObject object = world.getObject("b" + k);
                    double way = Math.toDegrees(Math.atan2(
                                    object.center().z(), -object.center().x()))
                            - object.heading()
                            + random.nextDouble(-60, 60);
                    double force = mass[k] * most * random.nextDouble();
                    double x = force * Math.cos(Math.toRadians(way));
                    double z = -force * Math.sin(Math.toRadians(way));
                    dynamics.drive("b" + k, new ForceDrive(x, z, 0));
                    Twist now = dynamics.velocity("b" + k);
                    double heading = Math.toRadians(object.heading() + 0.5 * seconds * now.ry());
                    given[0] += seconds * (x * Math.cos(heading) + z * Math.sin(heading));
                    given[1] += seconds * (z * Math.cos(heading) - x * Math.sin(heading));
                }
                StepResult result = dynamics.step(seconds);
                pressed += result.contacts().isEmpty() ? 0 : 1;
                bodySteps++;
                if (!result.stopped().isEmpty()) {
                    stopped++;
                    continue;
                }
                double[] after = momentum(world, dynamics, mass);
                for (int axis = 0; axis < 2; axis++) {
                    assertThat(after[axis] - before[axis])
                            .as("run %d, step %d of %s s, axis %d", run, step, seconds, axis)
                            .isCloseTo(given[axis], within(BOUND * Math.max(1, after[2])));
                }
            }
        }
        assertThat(pressed).isGreaterThan(bodySteps / 3);
        assertThat(stopped).isLessThanOrEqualTo(bodySteps / 500);
    }

    /** The momentum along X and Z of all bodies together, and the sum of its magnitudes. */
    private static double[] momentum(Geometry world, Dynamics dynamics, double[] mass) {
        double[] sum = new double[3];
        for (int k = 0; k < mass.length; k++) {
            Twist v = dynamics.velocity("b" + k);
            double heading = Math.toRadians(world.getObject("b" + k).heading());
            sum[0] += mass[k] * (v.x() * Math.cos(heading) + v.z() * Math.sin(heading));
            sum[1] += mass[k] * (v.z() * Math.cos(heading) - v.x() * Math.sin(heading));
            sum[2] += mass[k] * Math.hypot(v.x(), v.z());
        }
        return sum;
    }
}
