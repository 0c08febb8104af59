package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** Robots that drive where heights count: over floors, up ramps, off edges, against walls and crates. */
@Tag("slow")
class SpatialDriveTest {
    private static final double G = Body.GRAVITY;
    private static final double STANDS = 0.25 + 1e-8;
    private static final Surface GROUND = new Surface(0, 0.6, 0.5);

    private enum Shape {
        BOX,
        CYLINDER,
        BALL;

        GeometryObject at(double x, double y, double z) {
            Point center = new Point(x, y, z);
            return switch (this) {
                case BOX -> new BoxObject(center, 0.6, 0.5, 0.4);
                case CYLINDER -> new CylinderObject(center, 0.3, 0.5);
                case BALL -> new SphereObject(center, 0.25);
            };
        }
    }

    private static final Body BODY = Body.of(20, 1).withFloorFriction(0.6);

    private static Dynamics cart(Geometry world, GeometryObject shape, Drive drive) {
        assertThat(world.addObject(shape.moveable("cart"))).isTrue();
        Dynamics dynamics = new Dynamics(world, GROUND);
        dynamics.add("cart", BODY);
        dynamics.drive("cart", drive);
        return dynamics;
    }

    private static void run(Dynamics dynamics, Geometry world, double seconds) {
        for (int step = 0; step < Math.round(seconds / 0.05); step++) {
            dynamics.advance(0.05);
            for (String name : dynamics.names()) {
                FallingTest.assertApart(world, name, "step " + step);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(Shape.class)
    void wheelsGoTheirArc(Shape shape) {
        Geometry world = FallingTest.floor();
        double infinite = Double.POSITIVE_INFINITY;
        Dynamics dynamics =
                cart(world, shape.at(0, STANDS, 0), new DifferentialDrive(0.4, 1, infinite).driving(0.5, 36));
        dynamics.setVelocity("cart", new Twist(0.5, 0, 0, 36));
        run(dynamics, world, 2.5);
        double radius = 0.5 / StrictMath.toRadians(36);
        Point at = world.getObject("cart").center();
        assertThat(at.x()).isCloseTo(radius, within(1e-6));
        assertThat(at.z()).isCloseTo(-radius, within(1e-6));
        assertThat(world.getObject("cart").heading()).isCloseTo(90, within(1e-4));
        assertThat(dynamics.velocity("cart").x()).isCloseTo(0.5, within(1e-9));
    }

    @ParameterizedTest
    @EnumSource(Shape.class)
    void aDriveGainsSpeedWithinItsLimitAndThatOfFriction(Shape shape) {
        for (double limit : new double[] {2, 50}) {
            Geometry world = FallingTest.floor();
            Dynamics dynamics =
                    cart(world, shape.at(0, STANDS, 0), new OmnidirectionalDrive(9, limit, 90, 90).driving(3, 4, 0));
            run(dynamics, world, 0.5);
            double gained = Math.min(limit, 0.6 * G) * 0.5;
            Twist now = dynamics.velocity("cart");
            assertThat(now.x()).isCloseTo(0.6 * gained, within(1e-6));
            assertThat(now.z()).isCloseTo(0.8 * gained, within(1e-6));
            Point at = world.getObject("cart").center();
            assertThat(at.x()).isCloseTo(0.6 * gained * 0.25, within(1e-6));
        }
    }

    @Test
    void eachDriveDoesWhatItSays() {
        Geometry world = FallingTest.floor();
        Dynamics dynamics = cart(world, Shape.BOX.at(0, STANDS, 0), new AckermannDrive(0.4, 45, 1, 2).driving(0.5, 10));
        run(dynamics, world, 1);
        double turn = StrictMath.toDegrees(0.5 * StrictMath.tan(StrictMath.toRadians(10)) / 0.4);
        assertThat(dynamics.velocity("cart").ry()).isCloseTo(turn, within(1e-6));
        dynamics.drive("cart", new VelocityDrive(new Twist(-0.5, 0, 0.25, 0)));
        run(dynamics, world, 1);
        assertThat(dynamics.velocity("cart").x()).isCloseTo(-0.5, within(1e-9));
        assertThat(dynamics.velocity("cart").z()).isCloseTo(0.25, within(1e-9));
        dynamics.drive("cart", new VelocityDrive(new Twist(0, 0, 0, 0)));
        run(dynamics, world, 1);
        dynamics.drive("cart", new ForceDrive(30, 0, 2));
        run(dynamics, world, 0.5);
        Twist pushed = dynamics.velocity("cart");
        assertThat(StrictMath.hypot(pushed.x(), pushed.z())).isCloseTo(0.75, within(0.01));
        assertThat(pushed.ry()).isCloseTo(StrictMath.toDegrees(1), within(1e-6));
    }

    /** Wheels hold the rear axle, so that a centre ahead of it goes round farther out. */
    @Test
    void aCarWithItsCentreAheadOfItsRearAxle() {
        Geometry world = FallingTest.floor();
        AckermannDrive car =
                new AckermannDrive(0.4, 45, 1, 2).withCentreAhead(0.2).driving(0.5, 20);
        Dynamics dynamics = cart(world, Shape.BOX.at(0, STANDS, 0), car);
        run(dynamics, world, 3);
        double turn = 0.5 * StrictMath.tan(StrictMath.toRadians(20)) / 0.4;
        Twist now = dynamics.velocity("cart");
        assertThat(now.x()).isCloseTo(0.5, within(1e-6));
        assertThat(now.z()).isCloseTo(-0.2 * turn, within(1e-6));
        assertThat(now.ry()).isCloseTo(StrictMath.toDegrees(turn), within(1e-6));
    }

    private static Geometry ramp(double degrees) {
        Geometry world = FallingTest.floor();
        double cos = StrictMath.cos(StrictMath.toRadians(degrees));
        double sin = StrictMath.sin(StrictMath.toRadians(degrees));
        Point middle = new Point(2 + 3 * cos + 0.5 * sin, 3 * sin - 0.5 * cos, 0);
        world.addObjectUnchecked(new BoxObject(middle, 6, 1, 4)
                .oriented(FallingTest.tipped(degrees))
                .named("ramp"));
        return world;
    }

    @ParameterizedTest
    @ValueSource(doubles = {5, 15, 29, 33})
    void aRampBelowTheAngleOfFrictionIsClimbed(double degrees) {
        Geometry world = ramp(degrees);
        Dynamics dynamics = cart(world, Shape.BOX.at(1, STANDS, 0), new DifferentialDrive(0.4, 1, 2).driving(0.5, 0));
        run(dynamics, world, 8);
        boolean isClimbed = degrees < StrictMath.toDegrees(StrictMath.atan(0.6));
        double high = world.getObject("cart").center().y() - 0.25;
        if (!isClimbed) {
            assertThat(high).isLessThan(0.5);
            return;
        }
        assertThat(dynamics.velocity("cart").x()).isCloseTo(0.5, within(1e-6));
        assertThat(high).isGreaterThan(2 * StrictMath.sin(StrictMath.toRadians(degrees)));
        // And there it stands, when it is told to.
        dynamics.drive("cart", new DifferentialDrive(0.4, 1, 2));
        run(dynamics, world, 1);
        Point stands = world.getObject("cart").center();
        run(dynamics, world, 1);
        assertThat(world.getObject("cart").center()).isEqualTo(stands);
        assertThat(dynamics.spatialVelocity("cart")).isEqualTo(SpatialVelocity.REST);
    }

    /** Numbers in files are rounded, so that what ought to be flush stands out by some nanometres. */
    @ParameterizedTest
    @ValueSource(doubles = {-2e-5, -3e-7, 0, 4e-7, 2e-5})
    void lipsThatRoundingLeavesAreClimbed(double lip) {
        Geometry world = FallingTest.floor();
        double cos = StrictMath.cos(StrictMath.toRadians(15));
        double sin = StrictMath.sin(StrictMath.toRadians(15));
        Point middle = new Point(2 + cos + 0.1 * sin, lip + sin - 0.1 * cos, 0);
        world.addObjectUnchecked(new BoxObject(middle, 2, 0.2, 4)
                .oriented(FallingTest.tipped(15))
                .named("ramp"));
        double top = 2 * sin + 2 * lip;
        world.addObjectUnchecked(new BoxObject(new Point(2 + 2 * cos + 3, top / 2, 0), 6, top, 4).named("deck"));
        Dynamics dynamics = cart(world, Shape.BOX.at(1, STANDS, 0), new DifferentialDrive(0.4, 1, 2).driving(0.5, 0));
        run(dynamics, world, 9);
        assertThat(world.getObject("cart").center().y()).isCloseTo(top + 0.25, within(1e-5));
        assertThat(dynamics.velocity("cart").x()).isCloseTo(0.5, within(1e-6));
    }

    @Test
    void aLipThatIsOneStopsIt() {
        Geometry world = FallingTest.floor();
        world.addObjectUnchecked(new BoxObject(new Point(4, 0, 0), 4, 0.004, 4).named("step"));
        Dynamics dynamics = cart(world, Shape.BOX.at(1, STANDS, 0), new DifferentialDrive(0.4, 1, 2).driving(0.5, 0));
        run(dynamics, world, 4);
        assertThat(world.getObject("cart").center().x()).isCloseTo(1.7, within(1e-6));
    }

    @Test
    void inTheAirADriveDoesNothing() {
        Point[] ends = new Point[2];
        for (int k = 0; k < 2; k++) {
            Geometry world = FallingTest.world();
            Dynamics dynamics =
                    cart(world, Shape.BOX.at(0, 20, 0), new DifferentialDrive(0.4, 1, 2).driving(k, 90 * k));
            dynamics.advance(1);
            ends[k] = world.getObject("cart").center();
            assertThat(world.getObject("cart").heading()).isZero();
        }
        assertThat(ends[1]).isEqualTo(ends[0]);
    }

    @ParameterizedTest
    @EnumSource(Shape.class)
    void aRobotFallsOffAnEdge(Shape shape) {
        Geometry world = FallingTest.floor();
        world.addObject(new BoxObject(new Point(0, 0.4 + 1e-9, 0), 2, 0.8, 2).named("table"));
        Dynamics dynamics = cart(world, shape.at(0, 0.8 + STANDS, 0), new DifferentialDrive(0.4, 1, 2).driving(0.6, 0));
        run(dynamics, world, 1);
        assertThat(world.getObject("cart").center().y()).isCloseTo(0.8 + STANDS, within(1e-7));
        run(dynamics, world, 5);
        Point at = world.getObject("cart").center();
        assertThat(at.x()).isGreaterThan(1);
        assertThat(at.y()).isBetween(0.19, 0.4);
    }

    @Test
    void itPushesACrateUpToTheWall() {
        Geometry world = FallingTest.floor();
        world.addObject(new BoxObject(new Point(3, 0.5 + 1e-8, 0), 0.6, 1, 4).named("wall"));
        world.addObject(new BoxObject(new Point(1.5, 0.3 + 1e-8, 0.05), 0.6, 0.6, 0.6).moveable("crate"));
        Dynamics dynamics = cart(world, Shape.BOX.at(0, STANDS, 0), new DifferentialDrive(0.4, 1, 2).driving(0.5, 0));
        dynamics.add("crate", Body.of(5, 0.5).withFloorFriction(0.5));
        run(dynamics, world, 3.5);
        // 20 kg at 2 m/s^2 are more than the 5 kg by 0.5 g that the floor takes: it goes at its full speed.
        assertThat(dynamics.velocity("cart").x()).isCloseTo(0.5, within(1e-3));
        assertThat(world.getObject("crate").center().x()).isBetween(1.6, 2.4 - 1e-3);
        run(dynamics, world, 4);
        assertThat(world.getObject("crate").center().x()).isCloseTo(2.4, within(1e-6));
        assertThat(dynamics.last().contacts())
                .anyMatch(contact -> "cart".equals(contact.body()) && "crate".equals(contact.other())
                        || "crate".equals(contact.body()) && "cart".equals(contact.other()));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.4, 0.8})
    void itPushesWithItsMassTimesItsAcceleration(double share) {
        Geometry world = FallingTest.floor();
        world.addObject(new BoxObject(new Point(0.6 + 1e-6, 0.3 + 1e-8, 0), 0.6, 0.6, 0.6).moveable("crate"));
        Dynamics dynamics = cart(world, Shape.BOX.at(0, STANDS, 0), new DifferentialDrive(0.4, 1, 2).driving(0.5, 0));
        double friction = Math.sqrt(0.6 * 0.6);
        dynamics.add("crate", Body.of(20 * 2 / (friction * G) * 2 * share, 0.5).withFloorFriction(0.6));
        run(dynamics, world, 3);
        double moved = world.getObject("crate").center().x() - 0.6;
        if (share < 0.5) {
            assertThat(moved).isGreaterThan(0.5);
        } else {
            assertThat(moved).isLessThan(1e-3);
        }
    }

    @Test
    void whatCarriesARobotTakesTheOppositeImpulse() {
        Geometry world = FallingTest.floor();
        world.addObject(new BoxObject(new Point(0, 0.1 + 1e-8, 0), 3, 0.2, 2).moveable("raft"));
        world.addObject(Shape.BOX.at(0, 0.2 + STANDS + 1e-8, 0).moveable("cart"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("raft", Body.of(60, 60).withSurface(new Surface(0, 0.8, 0.8)));
        dynamics.add("cart", BODY);
        dynamics.drive("cart", new DifferentialDrive(0.4, 1, 1).driving(0.4, 0));
        for (int step = 0; step < 20; step++) {
            dynamics.advance(0.05);
        }
        double cart = dynamics.spatialVelocity("cart").x();
        double raft = dynamics.spatialVelocity("raft").x();
        assertThat(20 * cart + 60 * raft).isCloseTo(0, within(1e-9));
        assertThat(cart - raft).isCloseTo(0.4, within(1e-6));
    }

    @Test
    void onItsSideItIsDrivenNoMore() {
        Geometry world = FallingTest.floor();
        double[] lies = {1, 0, 0, 0, 0, -1, 0, 1, 0};
        GeometryObject box = new BoxObject(new Point(0, 0.2 + 1e-8, 0), 0.6, 0.5, 0.4).oriented(lies);
        Dynamics dynamics = cart(world, box, new DifferentialDrive(0.4, 1, 2).driving(0.5, 0));
        run(dynamics, world, 1);
        assertThat(world.getObject("cart").center().x()).isCloseTo(0, within(1e-9));
    }

    /** The border may be touched, so a body may begin on it or against its walls with no gap at all. */
    @Test
    void aBodyThatBeginsExactlyOnTheBorderMoves() {
        for (double height : new double[] {1, 4, 20, 1000}) {
            Geometry world = new Geometry(20, height, 20);
            Dynamics dynamics = cart(
                    world,
                    new BoxObject(new Point(0, 0.25 - height / 2, 9.75), 0.5, 0.5, 0.5),
                    new DifferentialDrive(0.4, 1, 2).driving(0.5, 0));
            run(dynamics, world, 1);
            assertThat(world.getObject("cart").center().x()).isGreaterThan(0.3);
        }
    }

    @Test
    void aStepAllocatesNothingOnceItHasRun() {
        Geometry world = FallingTest.floor();
        world.addObject(new BoxObject(new Point(3, 0.5 + 1e-8, 0), 0.6, 1, 4).named("wall"));
        world.addObject(new BoxObject(new Point(1.5, 0.3 + 1e-8, 0.05), 0.6, 0.6, 0.6).moveable("crate"));
        world.addObject(new SphereObject(new Point(-2, 2, 0), 0.2).moveable("ball"));
        Dynamics dynamics = cart(world, Shape.BOX.at(0, STANDS, 0), new DifferentialDrive(0.4, 1, 2).driving(0.5, 3));
        dynamics.add("crate", Body.of(5, 0.5).withFloorFriction(0.5));
        dynamics.add("ball", Body.of(1, 0.02).withSurface(new Surface(1, 0, 0)));
        for (int step = 0; step < 80; step++) {
            dynamics.advance(0.05);
        }
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long least = Long.MAX_VALUE;
        for (int round = 0; round < 5 && least > 0; round++) { // in the first ones classes may be loaded
            dynamics.drive("cart", new DifferentialDrive(0.4, 1, 2).driving(round % 2 == 0 ? -0.5 : 0.5, 5));
            long before = threads.getThreadAllocatedBytes(id);
            for (int step = 0; step < 20; step++) {
                dynamics.advance(0.05);
            }
            least = Math.min(least, (threads.getThreadAllocatedBytes(id) - before) / 20);
        }
        assertThat(least).isZero();
    }

    /** The force of a drive times the way: it pushes with its mass times its limit, and besides carries its weight uphill. */
    @Test
    void energyGrowsByNoMoreThanADriveDoes() {
        for (double degrees : new double[] {0, 12, 25}) {
            Geometry world = ramp(degrees);
            world.addObject(new BoxObject(new Point(-3, 0.5 + 1e-8, 0), 0.5, 1, 9).named("wall"));
            Dynamics dynamics =
                    cart(world, Shape.BOX.at(1, STANDS, 0), new DifferentialDrive(0.4, 1, 2).driving(0.5, 4));
            double growth = 0;
            for (int step = 0; step < 9000; step++) {
                if (step == 4000) {
                    dynamics.drive("cart", new DifferentialDrive(0.4, 1, 2).driving(-0.9, 9));
                }
                double before = FallingProofTest.energy(world, dynamics);
                Point from = world.getObject("cart").center();
                double heading = world.getObject("cart").heading();
                dynamics.advance(0.001);
                Point to = world.getObject("cart").center();
                double dx = to.x() - from.x();
                double dy = to.y() - from.y();
                double dz = to.z() - from.z();
                double turned = StrictMath.toRadians(
                        Math.IEEEremainder(world.getObject("cart").heading() - heading, 360));
                double way = Math.sqrt(dx * dx + dy * dy + dz * dz);
                double most = 20 * 2 * way + 20 * G * Math.max(0, dy) + 2 * 2 / 0.4 * Math.abs(turned);
                double after = FallingProofTest.energy(world, dynamics);
                growth = Math.max(growth, after - before);
                assertThat(after - before)
                        .as("%s degrees, step %d", degrees, step)
                        .isLessThanOrEqualTo(most * (1 + 1e-6) + 1e-9);
            }
            assertThat(growth).isGreaterThan(1e-4);
        }
    }

    private static Drive drive(SplittableRandom random) {
        double forward = random.nextDouble(-1.5, 1.5);
        double turn = random.nextDouble(-90, 90);
        return switch (random.nextInt(5)) {
            case 0 -> new DifferentialDrive(0.4, 1, random.nextDouble(0.5, 9)).driving(forward, turn);
            case 1 -> new OmnidirectionalDrive(1, 3, 90, 90).driving(forward, random.nextDouble(-1, 1), turn);
            case 2 -> new AckermannDrive(0.4, 45, 2, 3).driving(forward, turn);
            case 3 -> new VelocityDrive(new Twist(forward, 0, 0, turn));
            default -> new ForceDrive(60 * forward, 0, 0.1 * turn);
        };
    }

    @Test
    void whoeverDrivesNeverOverlaps() {
        int touching = 0;
        StopCount stops = new StopCount();
        int steps = 0;
        for (int run = 0; run < Effort.cases(6, 3); run++) {
            SplittableRandom random = new SplittableRandom(run);
            Geometry world = ramp(random.nextDouble(5, 30));
            for (int side = -1; side <= 1; side += 2) {
                world.addObjectUnchecked(new BoxObject(new Point(0, 0, 3 * side), 12, 9, 0));
                world.addObjectUnchecked(new BoxObject(new Point(5 * side, 0, 0), 1e-6, 9, 6));
            }
            world.addObjectUnchecked(new BoxObject(new Point(-3, 0.05, 0), 1, 0.1, 2).named("step"));
            Dynamics dynamics = new Dynamics(world, GROUND);
            int count = 2 + random.nextInt(4);
            for (int k = 0; k < count; k++) {
                String name = "body" + k;
                Shape shape = Shape.values()[random.nextInt(3)];
                Point at = new Point(random.nextDouble(-4, 1), 0.6, random.nextDouble(-2.5, 2.5));
                if (world.addObject(shape.at(at.x(), at.y(), at.z()).moveable(name))) {
                    dynamics.add(
                            name,
                            k == 0
                                    ? BODY
                                    : Body.of(random.nextDouble(2, 20), 0.5).withFloorFriction(0.5));
                }
            }
            for (int step = 0; step < 60; step++, steps++) {
                for (String name : dynamics.names()) {
                    if (random.nextInt(12) == 0) {
                        dynamics.drive(name, drive(random));
                    }
                }
                StepResult result = dynamics.step(random.nextInt(3) == 0 ? 0.1 : 0.03);
                touching += result.contacts().size() > dynamics.names().size() ? 1 : 0;
                stops.add(result, dynamics.names().size(), "run " + run + ", step " + step);
                for (String name : dynamics.names()) {
                    FallingTest.assertApart(world, name, "run " + run + ", step " + step);
                }
            }
        }
        assertThat(touching).isGreaterThan(steps / 10); // a sample in which nobody meets anybody proves nothing
        stops.assertAtMost(0);
    }
}
