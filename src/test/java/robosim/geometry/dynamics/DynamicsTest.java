package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

class DynamicsTest {
    private static final Surface ELASTIC = new Surface(1, 0, 0);

    private static Geometry world(double size) {
        return new Geometry(size, 5, size, Dimension.PLANAR, Accuracy.EXACT);
    }

    private static GeometryObject disc(String name, double x, double z, double radius) {
        return new CylinderObject(new Point(x, 0, z), radius, 1).moveable(name);
    }

    /** All stand upright, so that intersecting in space is intersecting as seen from above. */
    private static void assertApart(Geometry world, String what) {
        List<GeometryObject> all = world.objects();
        for (int i = 0; i < all.size(); i++) {
            for (int j = 0; j < i; j++) {
                if (all.get(i).isMoveable() || all.get(j).isMoveable()) {
                    assertThat(CollisionDetection.intersects(all.get(i), all.get(j)))
                            .as("%s: %s and %s", what, all.get(i), all.get(j))
                            .isFalse();
                }
            }
        }
    }

    private static double[] momentum(Dynamics dynamics, Geometry world, List<String> names, List<Body> bodies) {
        double[] sum = new double[2];
        for (int k = 0; k < names.size(); k++) {
            Twist v = dynamics.velocity(names.get(k));
            double[] r = world.getObject(names.get(k)).rotation();
            sum[0] += bodies.get(k).mass() * (r[0] * v.x() + r[2] * v.z());
            sum[1] += bodies.get(k).mass() * (r[6] * v.x() + r[8] * v.z());
        }
        return sum;
    }

    private static double energy(Dynamics dynamics, List<String> names, List<Body> bodies) {
        double sum = 0;
        for (int k = 0; k < names.size(); k++) {
            Twist v = dynamics.velocity(names.get(k));
            double w = StrictMath.toRadians(v.ry());
            sum += 0.5 * bodies.get(k).mass() * (v.x() * v.x() + v.z() * v.z())
                    + 0.5 * bodies.get(k).inertia() * w * w;
        }
        return sum;
    }

    /** Beside a grid, however it is turned, a disc stops where it stops beside the equal boxes. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 90, 180, 270, -90, 30, 45})
    void aGridStopsABodyWhereItsCellsDo(double heading) {
        BitSet cells = new BitSet();
        cells.set(0, 2);
        cells.set(4);
        GridObject grid = new GridObject(new Point(0, 0, 0), 1, 2, 2, 3, cells).turned(0, heading);
        List<GeometryObject> boxes = new ArrayList<>();
        cells.stream().forEach(cell -> boxes.add(grid.box(cell % 2, cell / 2)));
        for (double aside = -2; aside <= 2; aside += 0.1) {
            Point asGrid = thrownAt(List.of(grid), aside);
            Point asBoxes = thrownAt(boxes, aside);
            assertThat(asGrid.x()).as("%s", aside).isCloseTo(asBoxes.x(), within(1e-6));
            assertThat(asGrid.z()).as("%s", aside).isCloseTo(asBoxes.z(), within(1e-6));
            GeometryObject disc = new CylinderObject(asGrid, 0.3, 1);
            boxes.forEach(
                    box -> assertThat(CollisionDetection.intersects(disc, box)).isFalse());
        }
    }

    private static Point thrownAt(List<? extends GeometryObject> obstacles, double aside) {
        Geometry world = new Geometry(40, 10, 40, Dimension.PLANAR, Accuracy.EXACT);
        obstacles.forEach(world::addObjectUnchecked);
        world.addObject(new CylinderObject(new Point(5, 0, aside), 0.3, 1).moveable("disc"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("disc", Body.of(1, 0.1));
        dynamics.setVelocity("disc", new Twist(-3, 0, 0, 0));
        for (int step = 0; step < 40; step++) {
            dynamics.step(0.05);
        }
        return world.getObject("disc").center();
    }

    /** A force does not turn the velocity of what spins, as wheels do: without one, a body goes on straight. */
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.1, 2})
    void aForceIsNoWheel(double seconds) {
        Geometry world = new Geometry(40, 10, 40, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(0, 0, 0), 0.6, 1, 0.4).moveable("body"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("body", Body.of(5, 1));
        dynamics.drive("body", new ForceDrive(0, 0, 0));
        dynamics.setVelocity("body", new Twist(1, 0, 0, 90));
        for (double time = 0; time < 2 - 1e-9; time += seconds) {
            dynamics.step(seconds);
        }
        assertThat(world.getObject("body").center().x()).isCloseTo(2, within(1e-9));
        assertThat(world.getObject("body").center().z()).isCloseTo(0, within(1e-9));
        assertThat(dynamics.velocity("body").x()).isCloseTo(-1, within(1e-9)); // it looks back
        assertThat(dynamics.velocity("body").z()).isCloseTo(0, within(1e-9));
    }

    /** A force along the own axes of a body that a torque turns, against Newton's law in many small steps. */
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.1, 2})
    void aForceTurnsWithItsBody(double seconds) {
        Geometry world = new Geometry(40, 10, 40, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new CylinderObject(new Point(0, 0, 0), 0.3, 1).moveable("body"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("body", Body.of(5, 1));
        dynamics.drive("body", new ForceDrive(1, 0, 0.4));
        for (double time = 0; time < 2 - 1e-9; time += seconds) {
            dynamics.step(seconds);
        }
        double vx = 0;
        double vz = 0;
        double x = 0;
        double z = 0;
        double dt = 1e-5;
        for (double time = dt / 2; time < 2; time += dt) {
            vx += 0.2 * StrictMath.cos(0.2 * time * time) * dt;
            vz -= 0.2 * StrictMath.sin(0.2 * time * time) * dt;
            x += vx * dt;
            z += vz * dt;
        }
        assertThat(world.getObject("body").center().x()).isCloseTo(x, within(2e-4));
        assertThat(world.getObject("body").center().z()).isCloseTo(z, within(2e-4));
        double cos = StrictMath.cos(0.8);
        double sin = StrictMath.sin(0.8);
        assertThat(dynamics.velocity("body").x()).isCloseTo(vx * cos - vz * sin, within(2e-4));
        assertThat(dynamics.velocity("body").z()).isCloseTo(vx * sin + vz * cos, within(2e-4));
    }

    /** Ways that cross all over the world: a long step is divided before all of its pairs fill the memory. */
    @Test
    void aLongStepOfManyFastBodiesKeepsFewPairs() {
        Geometry world = world(200);
        Dynamics dynamics = new Dynamics(world, new Surface(1, 0, 0));
        for (int k = 0; k < 900; k++) {
            world.addObject(disc("d" + k, 6 * (k % 30) - 87, 6 * (k / 30) - 87, 0.05));
            dynamics.add("d" + k, Body.of(1, 1).withSurface(new Surface(1, 0, 0)));
            dynamics.setVelocity("d" + k, new Twist(100 * StrictMath.cos(k), 0, 100 * StrictMath.sin(k), 0));
        }
        dynamics.advance(1e-3);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long before = threads.getThreadAllocatedBytes(id);
        dynamics.advance(4);
        // Nearly each of 404,550 pairs has boxes of ways that meet; a few hundred bytes for each are more than 100 MB.
        assertThat(threads.getThreadAllocatedBytes(id) - before).isLessThan(60_000_000);
        assertApart(world, "after 400 m");
    }

    /** Its body goes with the next step. */
    @ParameterizedTest
    @EnumSource
    void whatHasBeenRemovedHasNoVelocity(Dimension dimension) {
        Geometry world = new Geometry(20, 10, 20, dimension, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(), 1, 1, 1).moveable("crate"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("crate", Body.of(5, 0.2));
        dynamics.step(0.01);
        world.removeObject("crate");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> dynamics.velocity("crate"))
                .withMessageContaining("(got: \"crate\")");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> dynamics.setVelocity("crate", new Twist(1, 0, 0, 0)))
                .withMessageContaining("(got: \"crate\")");
    }

    /** On an arc, however long the steps, the end is that of the arc. */
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.05, 0.2, 1})
    void aCurveIsAnArc(double seconds) {
        Geometry world = world(60);
        world.addObject(disc("cart", 0, 0, 0.3));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("cart", Body.of(10, 1));
        double turn = StrictMath.toDegrees(0.5);
        dynamics.drive("cart", new DifferentialDrive(0.5, 2, Double.POSITIVE_INFINITY).driving(0.5, turn));
        int steps = (int) Math.round(6 / seconds);
        for (int k = 0; k < steps; k++) {
            dynamics.step(seconds);
        }
        // A circle of a radius of 1 m, to the left: -Z.
        Point end = world.getObject("cart").center();
        assertThat(end.x()).isCloseTo(StrictMath.sin(3), within(1e-9));
        assertThat(end.z()).isCloseTo(-(1 - StrictMath.cos(3)), within(1e-9));
        assertThat(dynamics.velocity("cart").x()).isCloseTo(0.5, within(1e-12));
        assertThat(dynamics.velocity("cart").z()).isCloseTo(0, within(1e-12));
    }

    /** The way while it gains speed is that of a constant acceleration, however long the steps. */
    @ParameterizedTest
    @CsvSource({"0.01, 1e-9", "0.05, 1e-9", "0.25, 1e-9", "1, 1e-9"})
    void speedIsGainedEvenly(double seconds, double bound) {
        Geometry world = world(60);
        world.addObject(disc("cart", 0, 0, 0.3));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("cart", Body.of(10, 1));
        dynamics.drive("cart", new DifferentialDrive(0.5, 2, 2).driving(1, 0));
        for (int k = 0; k < Math.round(1 / seconds); k++) {
            dynamics.step(seconds);
        }
        assertThat(world.getObject("cart").center().x()).isCloseTo(0.75, within(bound));
    }

    /** Steps of 0.5 s and of 10 ms agree about what a robot pushes that the floor slows. */
    @Test
    void pushingDoesNotDependOnTheLengthOfAStep() {
        double[] places = new double[3];
        double[] lengths = {0.01, 1.0 / 16, 0.5};
        for (int k = 0; k < 3; k++) {
            Geometry world = world(60);
            world.addObject(disc("cart", 0, 0, 0.5));
            world.addObject(disc("crate", 2, 0, 0.5));
            Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
            dynamics.add("cart", Body.of(40, 5));
            dynamics.add("crate", Body.of(10, 1).withFloorFriction(0.5));
            dynamics.drive("cart", new DifferentialDrive(0.5, 2, 2).driving(1, 0));
            for (int step = 0; step < Math.round(10 / lengths[k]); step++) {
                dynamics.step(lengths[k]);
            }
            places[k] = world.getObject("crate").center().x();
            assertThat(dynamics.velocity("crate").x()).isCloseTo(1, within(1e-5));
        }
        assertThat(places[1]).isCloseTo(places[0], within(0.03));
        assertThat(places[2]).isCloseTo(places[1], within(1e-9));
    }

    /** Two discs of any masses on a line: the velocities after an impact of any restitution, and the places. */
    @Test
    void twoDiscsInALineCollideAsTheTextbookSays() {
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < 300; k++) {
            double e = k % 3 == 0 ? 1 : random.nextDouble();
            double m1 = random.nextDouble(0.1, 10);
            double m2 = random.nextDouble(0.1, 10);
            double u1 = random.nextDouble(1, 5);
            double u2 = random.nextDouble(-2, 0.5);
            Geometry world = world(100);
            world.addObject(disc("a", -1, 0, 0.5));
            world.addObject(disc("b", 1, 0, 0.5));
            Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
            dynamics.add("a", Body.of(m1, 1).withSurface(new Surface(e, 0, 0)));
            dynamics.add("b", Body.of(m2, 1).withSurface(new Surface(e, 0, 0)));
            dynamics.setVelocity("a", new Twist(u1, 0, 0, 0));
            dynamics.setVelocity("b", new Twist(u2, 0, 0, 0));

            StepResult result = dynamics.step(3);

            double v1 = (m1 * u1 + m2 * u2 + m2 * e * (u2 - u1)) / (m1 + m2);
            double v2 = (m1 * u1 + m2 * u2 + m1 * e * (u1 - u2)) / (m1 + m2);
            double meet = 1 / (u1 - u2);
            assertThat(result.stopped()).isEmpty();
            assertThat(result.contacts()).hasSize(meet < 3 ? 1 : 0);
            if (meet < 3) {
                assertThat(dynamics.velocity("a").x()).isCloseTo(v1, within(1e-9));
                assertThat(dynamics.velocity("b").x()).isCloseTo(v2, within(1e-9));
                assertThat(world.getObject("a").center().x()).isCloseTo(-1 + u1 * meet + v1 * (3 - meet), within(1e-7));
                assertThat(world.getObject("b").center().x()).isCloseTo(1 + u2 * meet + v2 * (3 - meet), within(1e-7));
                assertThat(result.contacts().get(0).impulse()).isCloseTo(m1 * (u1 - v1), within(1e-9));
            }
        }
    }

    /** A disc against an oblique wall: its speed along the wall stays, that across it is reversed times the restitution. */
    @Test
    void aDiscBouncesOffAWall() {
        SplittableRandom random = new SplittableRandom(2);
        for (int k = 0; k < 200; k++) {
            double degrees = random.nextDouble(-40, 40);
            double e = random.nextDouble();
            Geometry world = world(200);
            world.addObject(new BoxObject(new Point(5, 0, 0), 1, 2, 60).turned(0, degrees));
            world.addObject(disc("a", 0, 0, 0.5));
            Dynamics dynamics = new Dynamics(world, new Surface(e, 0, 0));
            dynamics.add("a", Body.of(3, 1).withSurface(new Surface(e, 0, 0)));
            dynamics.setVelocity("a", new Twist(4, 0, random.nextDouble(-2, 2), 0));
            Twist before = dynamics.velocity("a");

            StepResult result = dynamics.step(2.5);

            double nx = StrictMath.cos(StrictMath.toRadians(degrees));
            double nz = -StrictMath.sin(StrictMath.toRadians(degrees));
            Twist after = dynamics.velocity("a");
            if (result.contacts().size() == 1) {
                assertThat(after.x() * nx + after.z() * nz)
                        .isCloseTo(-e * (before.x() * nx + before.z() * nz), within(1e-8));
                assertThat(after.x() * nz - after.z() * nx).isCloseTo(before.x() * nz - before.z() * nx, within(1e-8));
            }
            assertThat(result.contacts()).as("%s", before).hasSizeLessThan(2);
            assertApart(world, "wall " + k);
        }
    }

    /** Friction turns what slides along a wall: sticking, a disc leaves it rolling. */
    @Test
    void frictionMakesADiscRollAlongAWall() {
        for (double friction : new double[] {0.05, 10}) {
            Geometry world = world(100);
            world.addObject(new BoxObject(new Point(0, 0, 3), 60, 2, 1));
            world.addObject(disc("a", 0, 0, 0.5));
            Dynamics dynamics = new Dynamics(world, new Surface(0, friction, friction));
            double inertia = 2 * 0.125;
            dynamics.add("a", Body.of(2, inertia).withSurface(new Surface(0, friction, friction)));
            dynamics.setVelocity("a", new Twist(1, 0, 2, 0));

            dynamics.step(1.5);

            Twist after = world.getObject("a").heading() == 0 ? dynamics.velocity("a") : null;
            double[] r = world.getObject("a").rotation();
            Twist own = dynamics.velocity("a");
            double along = r[0] * own.x() + r[2] * own.z();
            // The impulse across the wall is 4 Ns: sliding, friction takes 0.2 Ns of the 2 along it; rolling, a third.
            double expected = friction < 1 ? (2 - 0.2) / 2 : 2.0 / 3;
            assertThat(after).isNull();
            assertThat(along).isCloseTo(expected, within(1e-8));
            double spin = StrictMath.toRadians(own.ry());
            assertThat(Math.abs(spin) * inertia).isCloseTo((1 - expected) * 2 * 0.5, within(1e-8));
            if (friction > 1) {
                assertThat(Math.abs(spin) * 0.5).isCloseTo(along, within(1e-8));
            }
        }
    }

    /** Discs that meet in open space: momentum is kept to rounding, and energy never grows. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.6, 0})
    void momentumIsKeptAndEnergyNeverGrows(double restitution) {
        SplittableRandom random = new SplittableRandom(3);
        int met = 0;
        for (int run = 0; run < Effort.cases(8, 4); run++) {
            Geometry world = world(4000);
            Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
            List<String> names = new ArrayList<>();
            List<Body> bodies = new ArrayList<>();
            for (int k = 0; k < 12; k++) {
                GeometryObject disc = disc("d" + k, random.nextDouble(-5, 5), random.nextDouble(-5, 5), 0.6);
                if (world.addObject(disc)) {
                    names.add("d" + k);
                    bodies.add(Body.ofMass(disc, random.nextDouble(0.5, 4))
                            .withSurface(new Surface(restitution, 0.4, 0.3)));
                    dynamics.add("d" + k, bodies.get(bodies.size() - 1));
                    Point c = disc.center();
                    dynamics.setVelocity("d" + k, new Twist(-c.x(), 0, -c.z(), random.nextDouble(-90, 90)));
                }
            }
            double[] before = momentum(dynamics, world, names, bodies);
            double energy = energy(dynamics, names, bodies);
            for (int step = 0; step < 60; step++) {
                StepResult result = dynamics.step(0.05);
                met += result.contacts().size();
                assertThat(result.stopped()).isEmpty();
                double[] now = momentum(dynamics, world, names, bodies);
                assertThat(now[0]).isCloseTo(before[0], within(1e-9));
                assertThat(now[1]).isCloseTo(before[1], within(1e-9));
                double later = energy(dynamics, names, bodies);
                assertThat(later).isLessThanOrEqualTo(energy * (1 + 1e-12));
                energy = later;
            }
            assertApart(world, "run " + run);
        }
        assertThat(met).isGreaterThan(50);
    }

    /** Smooth elastic discs keep their energy. */
    @Test
    void elasticDiscsKeepTheirEnergy() {
        Geometry world = world(20);
        Dynamics dynamics = new Dynamics(world, ELASTIC);
        List<String> names = new ArrayList<>();
        List<Body> bodies = new ArrayList<>();
        for (int k = 0; k < 9; k++) {
            names.add("d" + k);
            bodies.add(Body.of(1 + k % 3, 1).withSurface(ELASTIC));
            world.addObject(disc("d" + k, 3.0 * (k % 3) - 3, 3.0 * (k / 3) - 2.9, 0.8));
            dynamics.add("d" + k, bodies.get(k));
            dynamics.setVelocity("d" + k, new Twist(k - 3.5, 0, 2 - k * 0.7, 0));
        }
        double energy = energy(dynamics, names, bodies);
        int met = 0;
        for (int step = 0; step < 100; step++) {
            StepResult result = dynamics.step(0.1);
            met += result.contacts().size();
            assertThat(result.stopped()).isEmpty();
        }
        assertThat(energy(dynamics, names, bodies)).isCloseTo(energy, within(energy * 1e-9));
        assertThat(met).isGreaterThan(25);
    }

    /** Boxes, discs and thin walls, speeds up to 10,000, steps up to a second: nothing overlaps, and nothing gets out. */
    @Test
    void nothingOverlapsAfterAnyStep() {
        SplittableRandom random = new SplittableRandom(4);
        int met = 0;
        int stopped = 0;
        int steps = 0;
        Set<StepResult.Reason> reasons = EnumSet.noneOf(StepResult.Reason.class);
        for (int run = 0; run < Math.max(8, Effort.cases(8)); run++) { // fewer may have no stop
            Geometry world = world(12);
            // A closed room of thin walls, whose corners overlap.
            for (int side = 0; side < 4; side++) {
                double x = side == 0 ? 5 : side == 1 ? -5 : 0;
                double z = side == 2 ? 5 : side == 3 ? -5 : 0;
                assertThat(world.addObjectUnchecked(
                                new BoxObject(new Point(x, 0, z), x == 0 ? 10.5 : 1e-3, 1, z == 0 ? 10.5 : 1e-3)))
                        .isTrue();
            }
            world.addObject(new BoxObject(new Point(1, 0, 1), 3, 1, 1e-6).turned(0, random.nextDouble(180)));
            Dynamics dynamics = new Dynamics(world, new Surface(random.nextDouble(), 0.5, 0.4));
            List<String> names = new ArrayList<>();
            for (int k = 0; k < 10; k++) {
                GeometryObject body = k % 2 == 0
                        ? new SphereObject(new Point(), 0.4)
                        : new BoxObject(new Point(), random.nextDouble(0.3, 1.2), 1, 0.5);
                body = body.movedTo(new Point(random.nextDouble(-4, 4), 0, random.nextDouble(-4, 4)));
                String name = "b" + k;
                if (world.addObject(
                        k % 3 == 0 ? body.moveable(name) : body.moveable(name).turned(0, 45))) {
                    names.add(name);
                    dynamics.add(
                            name,
                            Body.ofMass(body, random.nextDouble(0.5, 5))
                                    .withSurface(new Surface(random.nextDouble(), 0.5, 0.4)));
                }
            }
            for (int step = 0; step < 12; step++) {
                for (String name : names) {
                    if (step % 4 == 0) {
                        double speed = random.nextInt(3) == 0 ? 10_000 : 8;
                        dynamics.setVelocity(
                                name,
                                new Twist(
                                        random.nextDouble(-speed, speed),
                                        0,
                                        random.nextDouble(-speed, speed),
                                        random.nextDouble(-300, 300)));
                    }
                }
                StepResult result = dynamics.step(step % 3 == 0 ? 1e-3 : random.nextDouble(0.1));
                steps++;
                met += result.contacts().size();
                stopped += result.stopped().isEmpty() ? 0 : 1;
                assertThat(result.stops()).extracting(StepResult.Stop::body).isEqualTo(result.stopped());
                result.stops().forEach(stop -> reasons.add(stop.reason()));
                assertApart(world, "run " + run + ", step " + step);
                for (String name : names) {
                    Point c = world.getObject(name).center();
                    assertThat(Math.max(Math.abs(c.x()), Math.abs(c.z())))
                            .as(name)
                            .isLessThan(5);
                }
            }
        }
        assertThat(met).isGreaterThan(2 * steps);
        assertThat(stopped).isBetween(1, steps);
        assertThat(reasons).contains(StepResult.Reason.COLLISIONS);
    }

    /** A cart that is driven pushes a crate, and that another one, until a wall stops all three. */
    @Test
    void aDrivenCartPushesAChainUpToAWall() {
        Geometry world = world(40);
        world.addObject(new BoxObject(new Point(10, 0, 0), 1, 2, 10).named("wall"));
        world.addObject(new BoxObject(new Point(0, 0, 0), 1, 1, 1).moveable("cart"));
        world.addObject(new BoxObject(new Point(2, 0, 0), 1, 1, 1).moveable("one"));
        world.addObject(new BoxObject(new Point(4, 0, 0), 1, 1, 1).moveable("two"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("cart", Body.of(50, 10));
        dynamics.add("one", Body.of(10, 2).withDamping(3, 3));
        dynamics.add("two", Body.of(10, 2).withDamping(3, 3));
        dynamics.drive("cart", new DifferentialDrive(0.5, 1, 2).driving(1, 0));
        for (int step = 0; step < 400; step++) {
            dynamics.step(0.05);
            assertApart(world, "step " + step);
        }
        assertThat(world.getObject("two").center().x()).isCloseTo(9, within(1e-6));
        assertThat(world.getObject("one").center().x()).isCloseTo(8, within(1e-6));
        assertThat(world.getObject("cart").center().x()).isCloseTo(7, within(1e-6));
    }

    /** Without restitution a clump of bodies may need more events than a step has: then all stop, and it is told. */
    @Test
    void aClumpThatCannotBeDecidedStops() {
        Geometry world = world(4000);
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        List<String> names = new ArrayList<>();
        List<Body> bodies = new ArrayList<>();
        SplittableRandom random = new SplittableRandom(9);
        for (int k = 0; k < 12; k++) {
            GeometryObject disc = disc("d" + k, random.nextDouble(-4, 4), random.nextDouble(-4, 4), 0.6);
            if (world.addObject(disc)) {
                names.add(disc.name());
                bodies.add(Body.ofMass(disc, 2));
                dynamics.add("d" + k, Body.ofMass(disc, 2));
                dynamics.setVelocity(
                        "d" + k, new Twist(-disc.center().x(), 0, -disc.center().z(), 0));
            }
        }
        double energy = energy(dynamics, names, bodies);
        for (int step = 0; step < 40; step++) {
            StepResult result = dynamics.step(0.05);
            double later = energy(dynamics, names, bodies);
            assertThat(later).isLessThanOrEqualTo(energy * (1 + 1e-12));
            if (!result.stopped().isEmpty()) {
                for (String name : result.stopped()) {
                    assertThat(dynamics.velocity(name)).isEqualTo(new Twist(0, 0, 0, 0));
                }
            }
            energy = later;
            assertApart(world, "step " + step);
        }
    }

    /** Two discs that miss each other, in a world where each stands for its box: the boxes are in each other's way. */
    @Test
    void whatIsBlockedNamesWhatBlocksIt() {
        Geometry world = new Geometry(40, 5, 40, Dimension.PLANAR, Accuracy.AABB);
        world.addObject(disc("disc", 0, 0, 1));
        world.addObject(new CylinderObject(new Point(2.1, 0, 1.7), 1, 1).named("post"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("disc", Body.of(1, 1));
        dynamics.setVelocity("disc", new Twist(1, 0, -0.2, 0));
        StepResult result = dynamics.step(2);
        assertThat(result.stops()).containsExactly(new StepResult.Stop("disc", StepResult.Reason.BLOCKED, "post"));
        assertThat(result.stopped()).containsExactly("disc");
        assertThat(dynamics.last()).isEqualTo(result);
        assertThat(dynamics.step(1).stops()).isEmpty();
    }

    @Test
    void theSameRunHasTheSameBits() {
        assertThat(run()).isEqualTo(run());
    }

    private static List<GeometryObject> run() {
        Geometry world = world(10);
        Dynamics dynamics = new Dynamics(world, new Surface(0.7, 0.5, 0.4));
        for (int k = 0; k < 8; k++) {
            world.addObject(disc("d" + k, 2.0 * (k % 3) - 2, 2.0 * (k / 3) - 2.1, 0.6));
            dynamics.add("d" + k, Body.of(1 + k, 1).withSurface(new Surface(0.9, 0.5, 0.4)));
            dynamics.setVelocity("d" + k, new Twist(k - 3.5, 0, 2 - k * 0.7, 30 * k));
        }
        for (int step = 0; step < 40; step++) {
            dynamics.step(0.1);
        }
        return world.objects();
    }

    @Test
    void badArgumentsAreNamed() {
        Geometry world = world(10);
        world.addObject(disc("a", 0, 0, 1));
        world.addObject(new BoxObject(new Point(4, 0, 0), 1, 1, 1).named("wall"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        assertThatThrownBy(() -> new Dynamics(world, Surface.SMOOTH, new Point(0, -1, 0)))
                .hasMessageStartingWith("world ");
        assertThatThrownBy(() -> dynamics.add("wall", Body.of(1, 1))).hasMessageStartingWith("name ");
        assertThatThrownBy(() -> dynamics.velocity("a")).hasMessageStartingWith("name ");
        dynamics.add("a", Body.of(1, 1));
        Twist up = new Twist(1, 0.5, 0, 0);
        assertThatThrownBy(() -> dynamics.setVelocity("a", up))
                .hasMessageStartingWith(
                        "velocity must have no part upwards in a PLANAR world; set y to 0 (got: Twist[");
        assertThatThrownBy(() -> dynamics.drive("a", new VelocityDrive(up)))
                .hasMessageStartingWith("drive must have no part upwards where it acts along the ground; set y to 0");
        // Nothing has come of what was refused, and a drive that is asked by itself answers all of it.
        dynamics.step(1);
        assertThat(dynamics.velocity("a")).isEqualTo(new Twist(0, 0, 0, 0));
        assertThat(new VelocityDrive(up).next(new Twist(0, 0, 0, 0), Body.of(1, 1), 1))
                .isEqualTo(up);
        assertThatThrownBy(() -> dynamics.step(0)).hasMessageStartingWith("seconds ");
        assertThatThrownBy(() -> dynamics.step(Double.NaN)).hasMessageStartingWith("seconds ");
    }
}
