package robosim.geometry.dynamics.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.ForceDrive;
import robosim.geometry.dynamics.SpatialVelocity;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** In SPATIAL worlds, forces times time, less what contacts give, are what the momentum changes by in each step. */
@Tag("slow")
class SpatialMomentumTest {
    private static final double BOUND = 1e-9;

    /** Nothing that touches something comes to rest before: what rests is given nothing. */
    private static final double AWAKE = 0.24;

    private static String name(int k) {
        return "b" + k;
    }

    private static double impulse(StepResult result, String name) {
        double sum = 0;
        for (BodyContact contact : result.contacts()) {
            double along = contact.normal().x() * contact.impulse();
            sum += contact.body().equals(name) ? along : name.equals(contact.other()) ? -along : 0;
        }
        return sum;
    }

    /** A row of smooth spheres between two walls, pulled along it: each one's momentum by itself, to what sweeps leave. */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.0123, 0.05, 0.2})
    void eachOfARowGetsWhatItsContactsReport(double seconds) {
        SplittableRandom random = new SplittableRandom(5);
        int pressed = 0;
        int all = 0;
        for (int run = 0; run < Effort.cases(40, 16); run++) {
            double gravity = random.nextDouble(-5, 5);
            Geometry world = new Geometry(60, 8, 8);
            Surface surface = new Surface(random.nextBoolean() ? 0 : random.nextDouble(), 0, 0);
            Dynamics dynamics = new Dynamics(world, surface, new Point(gravity, 0, 0));
            double edge = -10;
            world.addObject(new BoxObject(new Point(edge - 0.5, 0, 0), 1, 3, 3).named("left"));
            double[] mass = new double[random.nextInt(1, 5)];
            for (int k = 0; k < mass.length; k++) {
                double size = random.nextDouble(0.3, 1);
                edge += random.nextInt(3) == 0 ? 1e-8 : random.nextDouble(1e-8, 0.02);
                Point at = new Point(edge + size / 2, 0, 0);
                assertThat(world.addObject(new SphereObject(at, size / 2).moveable(name(k))))
                        .isTrue();
                edge += size;
                mass[k] = random.nextDouble(1, 3);
                dynamics.add(name(k), Body.of(mass[k], mass[k]).withSurface(surface));
            }
            edge += random.nextDouble(1e-8, 0.02);
            world.addObject(new BoxObject(new Point(edge + 0.5, 0, 0), 1, 3, 3).named("right"));
            for (int step = 0; (step + 1) * seconds < AWAKE; step++) {
                double[] before = new double[mass.length];
                double scale = 1;
                for (int k = 0; k < mass.length; k++) {
                    before[k] = mass[k] * dynamics.spatialVelocity(name(k)).x();
                    scale = Math.max(scale, Math.abs(before[k]));
                }
                StepResult result = dynamics.step(seconds);
                assertThat(result.stopped()).isEmpty();
                for (int k = 0; k < mass.length; k++) {
                    double given = impulse(result, name(k));
                    pressed += given != 0 ? 1 : 0;
                    all++;
                    assertThat(mass[k] * dynamics.spatialVelocity(name(k)).x() - before[k])
                            .as("run %d, step %d, body %d of %d", run, step, k, mass.length)
                            .isCloseTo(given + mass[k] * gravity * seconds, within(10 * BOUND * scale));
                }
            }
        }
        assertThat(pressed).isGreaterThan(all / 5);
    }

    /** Bodies of all shapes that spin and collide while they fall: together they get what gravity gives them. */
    @ParameterizedTest
    @ValueSource(doubles = {0.0123, 0.05, 0.3})
    void bodiesThatFallAndCollideGetWhatGravityGives(double seconds) {
        SplittableRandom random = new SplittableRandom(6);
        int met = 0;
        for (int run = 0; run < 4; run++) {
            Geometry world = new Geometry(400, 4000, 400);
            Surface surface = new Surface(random.nextBoolean() ? 0 : random.nextDouble(), 0.5, 0.4);
            Point gravity = new Point(0, -9.81, random.nextDouble(-3, 3));
            Dynamics dynamics = new Dynamics(world, surface, gravity);
            double[] mass = new double[2 + run % 3];
            double whole = 0;
            for (int k = 0; k < mass.length; k++) {
                GeometryObject object = add(world, random, name(k));
                mass[k] = Math.exp(random.nextDouble(-1, 2));
                whole += mass[k];
                dynamics.add(name(k), Body.ofMass(object, mass[k]).withSurface(surface));
                Point c = object.center();
                dynamics.setSpatialVelocity(
                        name(k), new SpatialVelocity(-2 * c.x(), -2 * c.y(), -2 * c.z(), 80, random.nextDouble(90), 0));
            }
            double[] before = momentum(dynamics, mass);
            for (double time = 0; time < 0.6; time += seconds) {
                StepResult result = dynamics.step(seconds);
                met += result.contacts().isEmpty() ? 0 : 1;
                assertThat(result.stopped()).isEmpty();
                double[] after = momentum(dynamics, mass);
                double[] given = {0, whole * gravity.y() * seconds, whole * gravity.z() * seconds};
                for (int axis = 0; axis < 3; axis++) {
                    assertThat(after[axis] - before[axis])
                            .as("run %d at %s s, axis %d", run, time, axis)
                            .isCloseTo(given[axis], within(BOUND * Math.max(1, after[3])));
                }
                before = after;
            }
        }
        assertThat(met).isGreaterThan(2);
    }

    private static GeometryObject add(Geometry world, SplittableRandom random, String name) {
        while (true) {
            Point at =
                    new Point(random.nextDouble(-0.7, 0.7), random.nextDouble(-0.7, 0.7), random.nextDouble(-0.7, 0.7));
            double size = random.nextDouble(0.1, 0.3);
            double height = random.nextDouble(0.3, 0.6);
            GeometryObject shape = switch (random.nextInt(4)) {
                case 0 -> new SphereObject(at, size);
                case 1 -> new BoxObject(at, 2 * size, height, size);
                case 2 -> new CylinderObject(at, size, height);
                default -> new CapsuleObject(at, size / 2, height);
            };
            GeometryObject object =
                    shape.turned(random.nextDouble(90), random.nextDouble(360)).moveable(name);
            if (world.addObject(object)) {
                return object;
            }
        }
    }

    /** Three numbers, and the sum of the magnitudes. */
    private static double[] momentum(Dynamics dynamics, double[] mass) {
        double[] sum = new double[4];
        for (int k = 0; k < mass.length; k++) {
            SpatialVelocity v = dynamics.spatialVelocity(name(k));
            sum[0] += mass[k] * v.x();
            sum[1] += mass[k] * v.y();
            sum[2] += mass[k] * v.z();
            sum[3] += mass[k] * (Math.abs(v.x()) + Math.abs(v.y()) + Math.abs(v.z()));
        }
        return sum;
    }

    /** A force at an offset is a force and a torque: neither loses anything to the floor that gives it. */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.0123, 0.05, 0.3})
    void aForceAtAnOffsetGivesItsMomentumAndItsTorque(double seconds) {
        for (double offset : new double[] {0, 0.02, -0.3}) {
            Geometry world = new Geometry(60, 10, 60);
            world.addObject(new BoxObject(new Point(0, -3, 0), 50, 1, 50));
            Surface rough = new Surface(0, 1, 1);
            Dynamics dynamics = new Dynamics(world, rough, new Point(0, -9.81, 0));
            BoxObject box = new BoxObject(new Point(0, -2.25 + 1e-8, 0), 0.9, 0.5, 0.5).moveable(name(0));
            assertThat(world.addObject(box)).isTrue();
            Body body = Body.ofMass(box, 50).withSurface(rough);
            dynamics.add(name(0), body);
            double force = offset == -0.3 ? 0 : 20; // one that turns far has a force of many directions
            dynamics.drive(name(0), new ForceDrive(force, 0, 20 * offset));
            double time = 0;
            while (time < 0.6) {
                dynamics.step(seconds);
                time += seconds;
                SpatialVelocity v = dynamics.spatialVelocity(name(0));
                double speed = Math.sqrt(v.x() * v.x() + v.z() * v.z());
                assertThat(body.inertia() * Math.toRadians(v.ry()))
                        .as("offset %s, %s s", offset, time)
                        .isCloseTo(20 * offset * time, within(BOUND));
                if (offset == 0 || force == 0) {
                    assertThat(50 * speed).isCloseTo(force * time, within(BOUND));
                }
            }
        }
    }

    /**
     * A row of smooth cylinders on the floor, of which the first is driven against the others, by forces that change: all
     * together get what the drive and walls give, whatever the masses, and each gets what its contacts report.
     */
    @ParameterizedTest
    @CsvSource({"0.001, 1", "0.02, 1", "0.001, 200", "0.01, 200", "0.03, 200"})
    void aRowThatIsDrivenGetsWhatItsDriveGives(double seconds, double ratio) {
        SplittableRandom random = new SplittableRandom(7);
        int pressed = 0;
        for (int run = 0; run < 4; run++) {
            Geometry world = new Geometry(60, 8, 8);
            world.addObject(new BoxObject(new Point(0, -0.5, 0), 50, 1, 6).named("floor"));
            double restitution = random.nextBoolean() ? 0 : random.nextDouble();
            Dynamics dynamics = new Dynamics(world, new Surface(restitution, 1, 1));
            double edge = -10;
            double height = random.nextDouble(0.3, 0.6);
            double[] mass = new double[random.nextInt(2, 5)];
            for (int k = 0; k < mass.length; k++) {
                double size = random.nextDouble(0.4, 0.9);
                edge += random.nextBoolean() ? 2e-8 : random.nextDouble(2e-8, 0.02);
                Point at = new Point(edge + size / 2, height / 2 + 1.5e-8, 0);
                GeometryObject object = new CylinderObject(at, size / 2, height).moveable(name(k));
                assertThat(world.addObject(object)).isTrue();
                edge += size;
                mass[k] = StrictMath.pow(ratio, random.nextDouble());
                Body body = Body.ofMass(object, mass[k]).withSurface(new Surface(restitution, 0, 0));
                dynamics.add(name(k), k == 0 ? body.withFloorFriction(1) : body);
            }
            if (run % 2 == 1) {
                double before = random.nextDouble(2e-8, 0.02);
                assertThat(world.addObject(new BoxObject(new Point(edge + before + 0.5, 1.1, 0), 1, 2, 3)))
                        .isTrue();
            }
            double force = 0;
            for (int step = 0; step < 15; step++) {
                if (step % 4 == 0) {
                    force = mass[0] * random.nextDouble(step == 0 ? 2 : -1, 5); // no more than its friction
                    dynamics.drive(name(0), new ForceDrive(force, 0, 0));
                }
                double[] before = momenta(dynamics, mass);
                StepResult result = dynamics.step(seconds);
                assertThat(result.stopped()).isEmpty();
                double[] after = momenta(dynamics, mass);
                double scale = Math.max(1, force * seconds); // 1e-9 N s is what is promised
                double given = force * seconds;
                double change = 0;
                for (int k = 0; k < mass.length; k++) {
                    scale = Math.max(scale, Math.abs(before[k]));
                    double impulse = impulse(result, name(k));
                    pressed += impulse != 0 ? 1 : 0;
                    given += impulse;
                    change += after[k] - before[k];
                    // Normals of one contact are told as one, although bodies that hit walls are tipped by some 1e-5.
                    assertThat(after[k] - before[k])
                            .as("run %d, step %d, body %d of %d", run, step, k, mass.length)
                            .isCloseTo(impulse + (k == 0 ? force * seconds : 0), within(10 * BOUND * scale));
                }
                assertThat(change).as("run %d, step %d", run, step).isCloseTo(given, within(10 * BOUND * scale));
            }
        }
        assertThat(pressed).isGreaterThan(20);
    }

    private static double[] momenta(Dynamics dynamics, double[] mass) {
        double[] all = new double[mass.length];
        for (int k = 0; k < mass.length; k++) {
            all[k] = mass[k] * dynamics.spatialVelocity(name(k)).x();
        }
        return all;
    }

    /** A bar that is turned against bodies of any shape on a smooth floor: their angular momentum is torque times time. */
    @ParameterizedTest
    @CsvSource({
        "0.001, 2, false",
        "0.0123, 2, false",
        "0.1, 2, false",
        "0.0123, 2, true",
        "0.1, 2, true",
        "0.0123, 3, false",
        "0.1, 3, false",
        "0.0123, 3, true",
        "0.1, 3, true"
    })
    void aBarThatTurnsOthersGivesThemWhatItLoses(double seconds, int count, boolean isBouncing) {
        SplittableRandom random = new SplittableRandom(count == 2 ? 8 : 3);
        int pressed = 0;
        for (int run = 0; run < (count == 2 ? Effort.cases(4, 2) : 1); run++) {
            double restitution = isBouncing ? random.nextDouble() : 0;
            Geometry world = new Geometry(60, 8, 60);
            world.addObject(new BoxObject(new Point(0, -0.5, 0), 50, 1, 50).named("floor"));
            Dynamics dynamics = new Dynamics(world, new Surface(0, 1, 1));
            double height = 0.5; // all meet at half of it, so that none is lifted off the floor and loses its grip
            Body[] body = new Body[count];
            for (int k = 0; k < count; k++) {
                double gap = random.nextBoolean() ? 2e-8 : random.nextDouble(0.02);
                Point at = k == 0
                        ? new Point(7, height / 2 + 1.5e-8, -3)
                        : k == 1
                                ? new Point(6.2, height / 2 + 1.5e-8, -2.6 + gap)
                                : random.nextBoolean()
                                        ? new Point(7.8, height / 2 + 1.5e-8, -3.4 - gap)
                                        : new Point(6.2, height / 2 + 1.5e-8, -2.05 + 2 * gap);
                int which = k == 0 ? 0 : 1 + random.nextInt(4);
                // A capsule may meet others with one of its ends first, above the middle.
                GeometryObject shape = switch (which == 3 && (count > 2 || isBouncing) ? 1 : which) {
                    case 0 -> new BoxObject(at, 2, height, 0.3);
                    case 1 -> new CylinderObject(at, 0.25, height);
                    case 2 -> new BoxObject(at, 0.6, height, 0.5);
                    case 3 -> new CapsuleObject(new Point(at.x(), at.y(), at.z() - 0.05), 0.2, 0.1);
                    default -> new SphereObject(at, 0.25);
                };
                GeometryObject object = shape.moveable(name(k));
                assertThat(world.addObject(object)).isTrue();
                double mass = random.nextDouble(1, 5);
                double inertia = mass * random.nextDouble(0.03, 0.1); // about all axes, as some are tipped a little
                body[k] = Body.of(mass, inertia)
                        .withInertia(inertia, inertia, inertia)
                        .withSurface(new Surface(restitution, 0, 0));
                dynamics.add(name(k), k == 0 ? body[k].withFloorFriction(100) : body[k]);
            }
            double torque = random.nextDouble(2, 5);
            dynamics.drive(name(0), new ForceDrive(0, 0, torque));
            double time = 0;
            while (time < (count > 2 ? Effort.cases(60, 30) / 100.0 : AWAKE)) {
                StepResult result = dynamics.step(seconds);
                time += seconds;
                assertThat(result.stopped()).isEmpty();
                for (BodyContact contact : result.contacts()) {
                    pressed += contact.impulse() > 0 && !"floor".equals(contact.other()) ? 1 : 0;
                }
                assertThat(angular(world, dynamics, body))
                        .as("run %d at %s s", run, time)
                        .isCloseTo(torque * time, within(BOUND));
            }
        }
        assertThat(pressed).isGreaterThan(count == 2 ? 5 : 0);
    }

    /** The angular momentum of all bodies about the vertical through the middle of the world. */
    private static double angular(Geometry world, Dynamics dynamics, Body[] body) {
        double sum = 0;
        for (int k = 0; k < body.length; k++) {
            Point at = world.getObject(name(k)).center();
            SpatialVelocity v = dynamics.spatialVelocity(name(k));
            sum += body[k].mass() * (at.z() * v.x() - at.x() * v.z()) + body[k].inertia() * Math.toRadians(v.ry());
        }
        return sum;
    }

    /** A cart on a slab on a smooth floor, both at rest: whatever its drive does, both together have no angular momentum. */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.0123, 0.1})
    void aCartAndItsSlabTurnAgainstEachOther(double seconds) {
        for (int run = 0; run < 3; run++) {
            Geometry world = new Geometry(60, 8, 60);
            world.addObject(new BoxObject(new Point(0, -0.5, 0), 50, 1, 50).named("floor"));
            Surface rough = new Surface(0, 1, 1);
            Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
            BoxObject slab = new BoxObject(new Point(1, 0.1 + 1.5e-8, 2), 4, 0.2, 3).moveable(name(0));
            BoxObject cart = new BoxObject(new Point(1.6, 0.4 + 3e-8, 1.5), 0.9, 0.4, 0.5).moveable(name(1));
            assertThat(world.addObject(slab) && world.addObject(cart)).isTrue();
            Body[] body = {
                Body.ofMass(slab, 7).withSurface(rough), Body.ofMass(cart, 5).withSurface(rough)
            };
            dynamics.add(name(0), body[0]);
            dynamics.add(name(1), body[1].withFloorFriction(1));
            dynamics.drive(
                    name(1),
                    run == 0
                            ? new DifferentialDrive(0.4, 1, 2).driving(0.6, 50)
                            : new ForceDrive(run == 1 ? 4 : 0, run == 1 ? 3 : 0, 2));
            for (double time = 0; time < 0.5; time += seconds) {
                dynamics.step(seconds);
                assertThat(angular(world, dynamics, body))
                        .as("run %d at %s s", run, time)
                        .isCloseTo(0, within(BOUND));
            }
            assertThat(Math.abs(dynamics.velocity(name(1)).ry())).isGreaterThan(5);
        }
    }

    /** A body on the floor that hits a wall: the floor gives no more than what gravity takes. */
    @ParameterizedTest
    @ValueSource(doubles = {0.0013, 0.02, 0.1})
    void theFloorCarriesTheWeightAlsoWhereWallsAreHit(double seconds) {
        Geometry world = new Geometry(60, 8, 8);
        world.addObject(new BoxObject(new Point(0, -0.5, 0), 50, 1, 6).named("floor"));
        assertThat(world.addObject(new BoxObject(new Point(2, 1 + 1e-6, 0), 1, 2, 6).named("wall")))
                .isTrue();
        Dynamics dynamics = new Dynamics(world, new Surface(1, 0, 0));
        CylinderObject object = new CylinderObject(new Point(0, 0.2 + 1.5e-8, 0), 0.3, 0.4).moveable(name(0));
        assertThat(world.addObject(object)).isTrue();
        dynamics.add(name(0), Body.ofMass(object, 3).withSurface(new Surface(1, 0, 0)));
        dynamics.setSpatialVelocity(name(0), new SpatialVelocity(7.0123, 0, 0, 0, 0, 0));
        double walls = 0;
        double rises = 0;
        for (double time = 0; time < 0.4; time += seconds) {
            StepResult result = dynamics.step(seconds);
            double gained = 3 * dynamics.spatialVelocity(name(0)).y() - rises;
            rises += gained;
            for (BodyContact contact : result.contacts()) {
                boolean isFloor = "floor".equals(contact.other());
                walls += isFloor ? 0 : contact.impulse();
                if (isFloor) {
                    assertThat(contact.impulse()).isCloseTo(3 * Body.GRAVITY * seconds + gained, within(BOUND));
                }
            }
        }
        assertThat(walls).isCloseTo(2 * 3 * 7.0123, within(1e-7));
    }
}
