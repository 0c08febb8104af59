package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** What a step promises; {@code StepFamiliesTest} makes millions of steps. */
class StepProofTest {
    private static Geometry world(double size) {
        return new Geometry(size, 5, size, Dimension.PLANAR, Accuracy.EXACT);
    }

    private static GeometryObject disc(String name, double x, double z, double radius) {
        return new CylinderObject(new Point(x, 0, z), radius, 1).moveable(name);
    }

    /** A disc slides along a smooth wall, pressed against it by each step anew. */
    @Test
    void aDiscSlidesAlongAWall() {
        Geometry world = world(100);
        world.addObject(new BoxObject(new Point(0, 0, 1), 90, 1, 1).named("wall"));
        world.addObject(disc("a", -20, 0, 0.5 - 1e-10));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("a", Body.of(2, 1));
        for (int step = 0; step < 100; step++) {
            dynamics.setVelocity("a", new Twist(3, 0, 1, 0));
            StepResult result = dynamics.step(0.05);
            assertThat(result.contacts()).hasSize(1);
            assertThat(result.contacts().get(0).other()).isEqualTo("wall");
            assertThat(result.contacts().get(0).impulse()).isCloseTo(2, within(1e-9));
            assertThat(result.contacts().get(0).phase())
                    .isEqualTo(step == 0 ? BodyContact.Phase.BEGIN : BodyContact.Phase.LAST);
        }
        assertThat(world.getObject("a").center().x()).isCloseTo(-5, within(1e-9));
        dynamics.setVelocity("a", new Twist(0, 0, -1, 0));
        StepResult result = dynamics.step(0.05);
        assertThat(result.contacts()).isEmpty();
        assertThat(result.ended()).hasSize(1);
        assertThat(result.ended().get(0).phase()).isEqualTo(BodyContact.Phase.END);
    }

    /** A rough disc that has less room between two walls than bodies keep turns as if it were alone. */
    @Test
    void aDiscTurnsInASlotHardlyWiderThanItself() {
        SplittableRandom random = new SplittableRandom(4);
        for (int run = 0; run < 60; run++) {
            double gap = 2e-10 * random.nextInt(1, 4);
            double beside = random.nextDouble(gap);
            double yaw = run % 4 == 0 ? 0 : random.nextDouble(360);
            double seconds = List.of(0.02, 0.1, 0.5).get(run % 3);
            Geometry world = world(100);
            Point at = new Point(random.nextDouble(-5, 5), 0, random.nextDouble(-5, 5));
            for (int side = -1; side < 2; side += 2) {
                double far = side < 0 ? -0.65 - beside : 0.65 + gap - beside;
                double x = at.x() + far * StrictMath.cos(StrictMath.toRadians(yaw));
                double z = at.z() - far * StrictMath.sin(StrictMath.toRadians(yaw));
                Point middle = new Point(x, 0, z);
                world.addObject(
                        random.nextBoolean()
                                ? new CylinderObject(middle, 0.4, 1)
                                : new BoxObject(middle, 0.8, 1, 4).turned(0, yaw));
            }
            assertThat(world.addObject(disc("a", at.x(), at.z(), 0.25))).isTrue();
            Dynamics dynamics = new Dynamics(world, new Surface(0.3, 0.5, 0.4));
            dynamics.add("a", Body.of(20, 1));
            dynamics.drive("a", new DifferentialDrive(0.4, 1, 2).driving(0, 60));
            for (double time = 0; time < 1; time += seconds) {
                assertThat(dynamics.step(seconds).stopped()).isEmpty();
            }
            assertThat(dynamics.velocity("a").ry()).as("run %d", run).isCloseTo(60, within(1e-9));
            assertThat(world.getObject("a").center().x()).isCloseTo(at.x(), within(1e-9));
        }
    }

    /** A rack that is symmetric in z, hit in its middle, stays so to the bit. */
    @Test
    void aSymmetricRackBreaksSymmetrically() {
        Geometry world = world(400);
        Surface surface = new Surface(0.9, 0.1, 0.1);
        Dynamics dynamics = new Dynamics(world, surface);
        List<String> names = new ArrayList<>();
        for (int row = 0; row < 5; row++) {
            for (int k = 0; k <= row; k++) {
                String name = row + "/" + k;
                world.addObject(disc(name, row * 0.9, (2 * k - row) * 0.5078125, 0.5));
                names.add(name);
            }
        }
        world.addObject(disc("cue", -5, 0, 0.5));
        names.add("cue");
        names.forEach(name -> dynamics.add(name, Body.of(1, 0.125).withSurface(surface)));
        dynamics.setVelocity("cue", new Twist(10, 0, 0, 0));
        int met = 0;
        for (int step = 0; step < 100; step++) {
            met += dynamics.step(0.02).contacts().size();
            for (int row = 0; row < 5; row++) {
                for (int k = 0; k <= row; k++) {
                    Point one = world.getObject(row + "/" + k).center();
                    Point other = world.getObject(row + "/" + (row - k)).center();
                    assertThat(one.x()).as("step %s, %s/%s", step, row, k).isEqualTo(other.x());
                    assertThat(one.z()).as("step %s, %s/%s", step, row, k).isEqualTo(-other.z() + 0.0);
                }
            }
        }
        assertThat(met).isGreaterThan(15);
    }

    /** Sliding over the floor, a body stops after v^2 / (2 mu g), exactly at rest, however long the steps are. */
    @Test
    void theFloorStopsABody() {
        for (double seconds : new double[] {1, 0.05, 1e-3}) {
            Geometry world = world(100);
            world.addObject(disc("a", 0, 0, 0.5));
            Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
            dynamics.add("a", Body.of(2, 0.25).withFloorFriction(0.4));
            dynamics.setVelocity("a", new Twist(3, 0, 0, 90));
            for (double time = 0; time < 2; time += seconds) {
                dynamics.step(seconds);
            }
            assertThat(dynamics.velocity("a")).isEqualTo(new Twist(0, 0, 0, 0));
            double way = 9 / (2 * 0.4 * Body.GRAVITY);
            assertThat(world.getObject("a").center().x()).isCloseTo(way, within(1e-9));
        }
    }

    @Test
    void aWallHasASurfaceOfItsOwn() {
        Geometry world = world(100);
        world.addObject(new BoxObject(new Point(5, 0, 0), 1, 1, 9).named("rubber"));
        world.addObject(disc("a", 0, 0, 0.5));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("a", Body.of(2, 1).withSurface(new Surface(1, 0, 0)));
        dynamics.surface("rubber", new Surface(0.25, 0, 0));
        dynamics.setVelocity("a", new Twist(10, 0, 0, 0));
        dynamics.step(1);
        assertThat(dynamics.velocity("a").x()).isCloseTo(-5, within(1e-9));
    }

    /** A box that turns into a disc passes an impulse on, with its lever arm. */
    @Test
    void aTurnPushes() {
        Geometry world = world(100);
        world.addObject(new BoxObject(new Point(0, 0, 0), 4, 1, 0.2).moveable("bar"));
        world.addObject(disc("a", 1.5, -1, 0.25));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("bar", Body.of(1, 1.4));
        dynamics.add("a", Body.of(0.5, 0.1));
        dynamics.setVelocity("bar", new Twist(0, 0, 0, 90));
        for (int step = 0; step < 20; step++) {
            assertThat(dynamics.step(0.05).stopped()).as("step %d", step).isEmpty();
        }
        Twist a = dynamics.velocity("a");
        assertThat(a.x() * a.x() + a.z() * a.z()).isGreaterThan(0.25);
        assertThat(dynamics.velocity("bar").ry()).isLessThan(90);
    }

    /** In steady state a step without drives allocates next to nothing: what the world does where its fast path is unsure. */
    @Test
    void aStepAllocatesLittle() {
        Geometry world = world(14);
        Dynamics dynamics = new Dynamics(world, new Surface(1, 0, 0));
        for (int k = 0; k < 25; k++) {
            GeometryObject body = disc("d" + k, 2.5 * (k % 5) - 5, 2.5 * (k / 5) - 5, 0.7);
            world.addObject(body);
            dynamics.add("d" + k, Body.of(1 + k % 3, 1).withSurface(new Surface(1, 0, 0)));
            dynamics.setVelocity("d" + k, new Twist(k % 7 - 3, 0, k % 4 - 1.5, 0));
        }
        for (int step = 0; step < 4000; step++) {
            dynamics.advance(0.02);
        }
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long before = threads.getThreadAllocatedBytes(id);
        for (int step = 0; step < 1000; step++) {
            dynamics.advance(0.02);
        }
        assertThat((threads.getThreadAllocatedBytes(id) - before) / 1000).isLessThan(2048);
    }
}
