package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** Bodies that are attached to each other move as one rigid body. */
class AttachedBodiesTest {
    private static final Offset<Double> NEAR = within(1e-9);

    private static Geometry world() {
        return new Geometry(40, 5, 40, Dimension.PLANAR, Accuracy.EXACT);
    }

    private static void disc(Geometry world, String name, double x, double z) {
        world.addObject(new CylinderObject(new Point(x, 0, z), 0.5, 1).moveable(name));
    }

    @Test
    void massAndInertiaAreThoseOfBothAndMomentumStays() {
        Geometry world = world();
        disc(world, "a", -1, 0);
        disc(world, "b", 1, 0);
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("a", Body.of(3, 0.375));
        dynamics.add("b", Body.of(1, 0.125));
        dynamics.setVelocity("a", new Twist(0, 0, 2, 0));
        world.attach("a", "b");
        // The centre of mass is at x = -0.5; I = 0.375 + 0.125 + 3 * 0.5^2 + 1 * 1.5^2 = 3.5.
        double inertia = 3.5;
        double v = 1.5; // 3 * 2 / 4
        double turn = 0.5 * 3 * (2 - v) / inertia + 1.5 * v / inertia; // -x * m * (vz - v) of both about the centre
        assertThat(Math.toRadians(dynamics.velocity("a").ry())).isEqualTo(turn, NEAR);
        assertThat(dynamics.velocity("a").z()).isEqualTo(v + turn * 0.5, NEAR);
        assertThat(dynamics.velocity("b").z()).isEqualTo(v - turn * 1.5, NEAR);
        dynamics.step(1);
        Point a = world.getObject("a").center();
        Point b = world.getObject("b").center();
        assertThat(0.75 * a.x() + 0.25 * b.x()).isEqualTo(-0.5, NEAR);
        assertThat(0.75 * a.z() + 0.25 * b.z()).isEqualTo(v, NEAR);
        assertThat(Math.toRadians(world.getObject("a").heading())).isEqualTo(turn, NEAR);
        assertThat(Math.hypot(a.x() - b.x(), a.z() - b.z())).isEqualTo(2, NEAR);
    }

    @Test
    void whatIsDetachedHasTheVelocityOfItsPlace() {
        Geometry world = world();
        disc(world, "a", 0, 0);
        disc(world, "b", 2, 0);
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("a", Body.of(1, 1));
        dynamics.add("b", Body.of(1, 1));
        world.attach("a", "b");
        dynamics.setVelocity(
                "a", new Twist(0, 0, 1, 90)); // about a's place: b's velocity is 1 - 2 * pi / 2 to the right
        double z = 1 - Math.PI;
        assertThat(dynamics.velocity("b").z()).isEqualTo(z, NEAR);
        world.detach("b");
        assertThat(dynamics.velocity("b").z()).isEqualTo(z, NEAR);
        assertThat(dynamics.velocity("b").ry()).isEqualTo(90, NEAR);
        assertThat(dynamics.velocity("a").z()).isEqualTo(1, NEAR);
        dynamics.step(0.1);
        assertThat(world.getObject("b").center().z()).isEqualTo(0.1 * z, NEAR);
        assertThat(world.getObject("b").center().x()).isEqualTo(2, NEAR);
    }

    @Test
    void aForceOnTheCarrierTurnsBothAboutTheirCommonCentre() {
        Geometry world = world();
        disc(world, "a", 0, 0);
        disc(world, "b", 0, 2);
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("a", Body.of(1, 1));
        dynamics.add("b", Body.of(1, 1));
        world.attach("a", "b");
        dynamics.drive("a", new ForceDrive(4, 0, 0));
        dynamics.step(1e-3);
        // Pulled 1 m beside the centre of mass: torque -4 (z of the force's place less that of the centre is -1), I =
        // 4.
        assertThat(Math.toRadians(dynamics.velocity("a").ry())).isEqualTo(-1e-3, within(1e-8));
        assertThat(0.5 * (dynamics.velocity("a").x() + dynamics.velocity("b").x()))
                .isEqualTo(2e-3, within(1e-8));
    }

    /** An impulse, or a force for the same time, on either part acts on the whole, about its centre of mass. */
    @Test
    void whatPushesAPartPushesTheWhole() {
        for (String pushed : new String[] {"a", "b"}) {
            for (boolean isForce : new boolean[] {false, true}) {
                Geometry world = world();
                world.addObject(
                        new CylinderObject(new Point(), 0.5, 1).turned(0, 30).moveable("a"));
                disc(world, "b", 0, 2);
                Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
                dynamics.add("a", Body.of(1, 1));
                dynamics.add("b", Body.of(1, 1));
                world.attach("a", "b");
                if (isForce) {
                    dynamics.applyForce(pushed, new Point(4, 0, 0));
                } else {
                    dynamics.applyImpulse(pushed, new Point(4e-3, 0, 0));
                }
                dynamics.step(1e-3);
                double side = pushed.equals("a") ? -1 : 1; // of the centre of mass, 1 m away; I = 4
                assertThat(Math.toRadians(dynamics.velocity("a").ry())).isEqualTo(side * 1e-3, within(1e-8));
                Twist a = dynamics.velocity("a");
                double ahead = a.x() * Math.cos(Math.PI / 6) + a.z() * Math.sin(Math.PI / 6); // along the world's X
                assertThat(0.5 * (ahead + dynamics.velocity("b").x())).isEqualTo(2e-3, within(1e-8));
            }
        }
    }

    @Test
    void aWheeledCarrierFollowsItsDriveWhateverItCarries() {
        Geometry world = world();
        world.addObject(new BoxObject(new Point(0, 0, 0), 1, 0.5, 0.6).moveable("truck"));
        world.addObject(new BoxObject(new Point(1.2, 0, 0.3), 1, 0.5, 0.6).moveable("crate"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("truck", Body.of(20, 3));
        dynamics.add("crate", Body.of(40, 5));
        world.attach("truck", "crate");
        dynamics.drive("truck", new DifferentialDrive(0.5, 2, 100).driving(1, 45));
        for (int k = 0; k < 800; k++) {
            dynamics.step(0.01);
            assertThat(dynamics.velocity("truck").z()).isEqualTo(0, NEAR);
        }
        assertThat(dynamics.velocity("truck").x()).isEqualTo(1, NEAR);
        // A whole turn: back where it began, but for the centimetres until it was up to speed.
        assertThat(world.getObject("truck").center().x()).isEqualTo(0, within(0.05));
        assertThat(world.getObject("truck").center().z()).isEqualTo(0, within(0.05));
        Pose crate = world.getObject("crate")
                .pose()
                .relativeTo(world.getObject("truck").pose());
        assertThat(crate.center().x()).isEqualTo(1.2, NEAR);
        assertThat(crate.center().z()).isEqualTo(0.3, NEAR);
    }

    @Test
    void theDriveOfALoadWaitsUntilItIsDetached() {
        Geometry world = world();
        disc(world, "a", 0, 0);
        disc(world, "b", 0, 2);
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("a", Body.of(1, 1));
        dynamics.add("b", Body.of(1, 1));
        world.attach("a", "b");
        dynamics.drive("b", new VelocityDrive(new Twist(1, 0, 0, 0)));
        dynamics.step(1);
        assertThat(world.getObject("b").center()).isEqualTo(new Point(0, 0, 2));
        world.detach("b");
        dynamics.step(1);
        assertThat(world.getObject("b").center().x()).isEqualTo(1, NEAR);
        assertThat(world.getObject("a").center().x()).isZero();
    }

    /** Crates fetched with next to no gap, turned by any angle and put down: no step finds an overlap. */
    @Test
    void whatIsPutDownOverlapsNothing() {
        SplittableRandom random = new SplittableRandom(9);
        for (int round = 0; round < 100; round++) {
            Geometry world = world();
            world.addObject(new BoxObject(new Point(random.nextDouble(-9, 9), 0, 1), 1, 1, 1).moveable("lift"));
            world.addObject(new BoxObject(new Point(12, 0, 1), 1, 1, 1).moveable("crate"));
            Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
            dynamics.add("lift", Body.of(5, 1));
            dynamics.add("crate", Body.of(2, 0.3));
            dynamics.setVelocity("lift", new Twist(3, 0, 0, 0));
            dynamics.step(8); // against the crate
            world.attach("lift", "crate");
            dynamics.setVelocity("lift", new Twist(0, 0, 0, random.nextDouble(-90, 90)));
            dynamics.step(random.nextDouble(0.1, 2));
            world.detach("crate");
            for (int k = 0; k < 5; k++) {
                StepResult result = dynamics.step(0.1);
                assertThat(result.stops()).isEmpty();
                dynamics.setVelocity("lift", new Twist(random.nextDouble(-2, 2), 0, 0, random.nextDouble(-20, 20)));
            }
            assertThat(CollisionDetection.intersects(world.getObject("lift"), world.getObject("crate")))
                    .isFalse();
        }
    }

    /** An hour of simulated driving with a load, in an ordinary build a quarter: it stays where it is held. */
    @Tag("slow")
    @Test
    void aLoadStaysInPlaceForAnHour() {
        Geometry world = world();
        world.addObject(new BoxObject(new Point(0, 0, 0), 1, 0.5, 0.6).moveable("truck"));
        world.addObject(new BoxObject(new Point(-1.7, 0, 0.1), 2, 0.5, 0.8).moveable("trailer"));
        world.addObject(new CylinderObject(new Point(7, 0, 0), 1, 1).named("post"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("truck", Body.of(20, 3));
        dynamics.add("trailer", Body.of(40, 15));
        world.attach("truck", "trailer");
        SplittableRandom random = new SplittableRandom(3);
        int contacts = 0;
        for (int k = 0; k < Effort.cases(18_000); k++) {
            if (k % 20 == 0) {
                DifferentialDrive drive = new DifferentialDrive(0.5, 2, 3);
                dynamics.drive("truck", drive.driving(random.nextDouble(-1, 2), random.nextDouble(-60, 60)));
            }
            contacts += dynamics.step(0.2).contacts().size();
        }
        Pose held = world.getObject("trailer")
                .pose()
                .relativeTo(world.getObject("truck").pose());
        assertThat(held.center().x()).isEqualTo(-1.7, within(1e-12));
        assertThat(held.center().z()).isEqualTo(0.1, within(1e-12));
        assertThat(held.heading()).isEqualTo(0, within(1e-12));
        assertThat(contacts).isGreaterThan(Effort.cases(500));
    }

    /** The same shapes as one group with its own centre in the common centre of mass. */
    @Test
    void collisionsAreThoseOfAGroup() {
        SplittableRandom random = new SplittableRandom(5);
        int collided = 0;
        for (int round = 0; round < 20; round++) {
            Geometry one = world();
            Geometry other = world();
            one.addObject(new BoxObject(new Point(-1, 0, 0), 1, 1, 2).moveable("a"));
            one.addObject(new CylinderObject(new Point(0.5, 0, 0.5), 0.5, 1).moveable("b"));
            Point centre = new Point(-0.4, 0, 0.2); // of 3 and 2 kg
            other.addObject(new ObjectGroup(List.of(
                            new BoxObject(new Point(-0.6, 0, -0.2), 1, 1, 2),
                            new CylinderObject(new Point(0.9, 0, 0.3), 0.5, 1)))
                    .moveable("a")
                    .movedTo(centre));
            double inertia = 1 + 0.3 + 3 * (0.36 + 0.04) + 2 * (0.81 + 0.09);
            Surface elastic = new Surface(0.8, 0.3, 0.2);
            Dynamics first = new Dynamics(one, elastic);
            Dynamics second = new Dynamics(other, elastic);
            first.add("a", Body.of(3, 1).withSurface(elastic));
            first.add("b", Body.of(2, 0.3).withSurface(elastic));
            second.add("a", Body.of(5, inertia).withSurface(elastic));
            for (Geometry world : List.of(one, other)) {
                world.addObject(new SphereObject(new Point(5, 0, 0.4), 0.6).moveable("ball"));
                world.addObject(new BoxObject(new Point(9, 0, 0), 1, 1, 20).named("wall"));
            }
            for (Dynamics each : List.of(first, second)) {
                each.add("ball", Body.of(1.5, 0.2).withSurface(elastic));
            }
            one.attach("a", "b");
            double turn = random.nextDouble(-90, 90);
            double x = random.nextDouble(2, 5);
            second.setVelocity("a", new Twist(x, 0, 0, turn));
            // The velocity of the box, which is at (-0.6, -0.2) from the centre of mass.
            double w = Math.toRadians(turn);
            first.setVelocity("a", new Twist(x - 0.2 * w, 0, 0.6 * w, turn));
            for (int k = 0; k < 25; k++) {
                StepResult a = first.step(0.05);
                StepResult b = second.step(0.05);
                assertThat(a.contacts().size()).isEqualTo(b.contacts().size());
                collided += a.contacts().size();
                GeometryObject whole = other.getObject("a");
                Pose box = ((ObjectGroup) whole).placedMembers().get(0).pose();
                near(one.getObject("a").center(), box.center());
                near(one.getObject("ball").center(), other.getObject("ball").center());
                assertThat(CollisionDetection.intersects(one.getObject("b"), one.getObject("ball")))
                        .isFalse();
            }
        }
        assertThat(collided).isGreaterThan(10);
    }

    private static void near(Point a, Point b) {
        assertThat(Math.hypot(a.x() - b.x(), a.z() - b.z())).isLessThan(1e-6);
    }

    /** Robots that fetch, carry and drop boxes at random, for a long time: momentum and energy of what nothing drives. */
    @Test
    void attachingTakesEnergyAndKeepsMomentumInLongRuns() {
        SplittableRandom random = new SplittableRandom(7);
        Geometry world = new Geometry(400, 5, 400, Dimension.PLANAR, Accuracy.EXACT);
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        String[] names = new String[8];
        for (int k = 0; k < names.length; k++) {
            names[k] = "disc" + k;
            disc(world, names[k], 3 * (k % 4), 3 * (k / 4));
            dynamics.add(names[k], Body.of(1 + k, 0.2 + 0.1 * k));
            dynamics.setVelocity(
                    names[k],
                    new Twist(random.nextDouble(-0.2, 0.2), 0, random.nextDouble(-0.2, 0.2), random.nextDouble(-5, 5)));
        }
        double[] momentum = momentum(world, dynamics, names);
        double energy = momentum[3];
        for (int k = 0; k < 600; k++) {
            String one = names[random.nextInt(names.length)];
            String other = names[random.nextInt(names.length)];
            if (world.carrierOf(one) != null) {
                world.detach(one);
            } else if (!isWithin(world, other, one)) {
                world.attach(other, one);
            }
            dynamics.step(0.02);
            double[] now = momentum(world, dynamics, names);
            for (int m = 0; m < 3; m++) {
                assertThat(now[m]).isEqualTo(momentum[m], within(1e-7));
            }
            assertThat(now[3]).isLessThan(energy + 1e-9);
            energy = now[3];
        }
        assertThat(energy).isPositive();
    }

    private static boolean isWithin(Geometry world, String name, String of) {
        for (String each = name; each != null; each = world.carrierOf(each)) {
            if (each.equals(of)) {
                return true;
            }
        }
        return false;
    }

    /** Along X and Z, about the origin, and the energy. */
    private static double[] momentum(Geometry world, Dynamics dynamics, String[] names) {
        double[] sum = new double[4];
        for (String name : names) {
            Body body = dynamics.body(name);
            Pose pose = world.getObject(name).pose();
            Twist v = dynamics.velocity(name);
            double[] r = pose.rotation();
            double vx = r[0] * v.x() + r[2] * v.z();
            double vz = r[6] * v.x() + r[8] * v.z();
            double w = Math.toRadians(v.ry());
            sum[0] += body.mass() * vx;
            sum[1] += body.mass() * vz;
            sum[2] += body.inertia() * w
                    + body.mass() * (pose.center().z() * vx - pose.center().x() * vz);
            sum[3] += 0.5 * body.mass() * (vx * vx + vz * vz) + 0.5 * body.inertia() * w * w;
        }
        return sum;
    }

    @Test
    void aStepThatIsTakenBackLeavesWhatIsAttached() {
        Geometry world = world();
        Geometry other = world();
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        Dynamics second = new Dynamics(other, Surface.SMOOTH);
        for (Geometry each : List.of(world, other)) {
            disc(each, "a", 0, 0);
            disc(each, "b", 2, 0);
        }
        for (Dynamics each : List.of(dynamics, second)) {
            each.add("a", Body.of(1, 1));
            each.add("b", Body.of(2, 1));
            each.setVelocity("a", new Twist(0, 0, 1, 20));
            each.step(0.1);
        }
        world.attach("a", "b");
        other.attach("a", "b");
        assertThatThrownBy(() -> dynamics.together(() -> {
                    dynamics.step(0.1);
                    throw new IllegalStateException("no");
                }))
                .hasMessage("no");
        for (int k = 0; k < 5; k++) {
            dynamics.step(0.1);
            second.step(0.1);
            assertThat(world.objects()).isEqualTo(other.objects());
            assertThat(dynamics.velocity("b")).isEqualTo(second.velocity("b"));
        }
    }

    @Test
    void anotherObjectOfTheNameOfALoadHasNoBody() {
        Geometry world = world();
        disc(world, "a", 0, 0);
        disc(world, "b", 2, 0);
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("a", Body.of(1, 1));
        dynamics.add("b", Body.of(1, 1));
        world.attach("a", "b");
        assertThat(dynamics.has("b")).isTrue();
        assertThat(dynamics.names()).containsExactly("a", "b");
        world.removeObject("b");
        disc(world, "b", 2, 0);
        assertThat(dynamics.has("b")).isFalse();
        assertThat(dynamics.velocity("a")).isEqualTo(new Twist(0, 0, 0, 0));
    }

    @Test
    void bodiesThatFallCarryNothing() {
        Geometry world = new Geometry(40, 5, 40, Dimension.SPATIAL, Accuracy.EXACT);
        disc(world, "a", 0, 0);
        disc(world, "b", 2, 0);
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("a", Body.of(1, 1));
        world.attach("a", "b");
        assertThatThrownBy(() -> dynamics.step(0.1)).hasMessageContaining("world must be PLANAR");
        world.detach("b");
        dynamics.step(0.01);
    }
}
