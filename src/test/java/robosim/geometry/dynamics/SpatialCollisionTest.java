package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Collisions of two bodies in space beside the textbook's, whatever their masses, speeds and restitution. */
@Tag("slow")
class SpatialCollisionTest {
    private static final double[] LEVEL = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    private static final Point WEIGHTLESS = new Point(0, 0, 0);

    private final SplittableRandom random = new SplittableRandom(261124);

    private static Dynamics two(GeometryObject a, double massA, GeometryObject b, double massB, Surface surface) {
        Geometry world = new Geometry(400, 400, 400);
        Dynamics dynamics = new Dynamics(world, surface, WEIGHTLESS);
        world.addObject(a);
        world.addObject(b);
        dynamics.add("a", Body.ofMass(a.oriented(LEVEL), massA).withSurface(surface));
        dynamics.add("b", Body.ofMass(b.oriented(LEVEL), massB).withSurface(surface));
        return dynamics;
    }

    /** Two smooth spheres that both move, off the line of their centres: Newton's impulse along it, whatever the step. */
    @Test
    void spheresCollideAsTheTextbookSays() {
        for (int k = 0; k < 120; k++) {
            double restitution = k % 4 == 0 ? 0 : random.nextDouble();
            double radiusA = random.nextDouble(0.2, 0.8);
            double radiusB = random.nextDouble(0.2, 0.8);
            double massA = random.nextDouble(0.5, 4);
            double massB = random.nextDouble(0.5, 4);
            double speedA = random.nextDouble(1, 6);
            double speedB = k % 3 == 0 ? 0 : -random.nextDouble(1, 6);
            double aside = random.nextDouble(-0.9, 0.9) * (radiusA + radiusB);
            Dynamics dynamics = two(
                    new SphereObject(new Point(-3, 0, 0), radiusA).moveable("a"),
                    massA,
                    new SphereObject(new Point(3, 0, aside), radiusB).moveable("b"),
                    massB,
                    new Surface(restitution, 0, 0));
            dynamics.setSpatialVelocity("a", new SpatialVelocity(speedA, 0, 0, 0, 0, 0));
            dynamics.setSpatialVelocity("b", new SpatialVelocity(speedB, 0, 0, 0, 0, 0));
            double seconds = StrictMath.pow(10, random.nextDouble(-2, 0.5));
            for (double time = 0; time < 6; time += seconds) {
                assertThat(dynamics.step(seconds).stopped()).as("case %d", k).isEmpty();
            }
            double nz = aside / (radiusA + radiusB);
            double nx = Math.sqrt(1 - nz * nz);
            double impulse = (1 + restitution) * (speedA - speedB) * nx / (1 / massA + 1 / massB);
            String what = "case " + k + ", restitution " + restitution;
            // Bodies meet 1e-8 m apart, which turns the line of the centres a little.
            assertVelocity(dynamics, "a", speedA - impulse * nx / massA, -impulse * nz / massA, what);
            assertVelocity(dynamics, "b", speedB + impulse * nx / massB, impulse * nz / massB, what);
        }
    }

    private static void assertVelocity(Dynamics dynamics, String name, double x, double z, String what) {
        SpatialVelocity velocity = dynamics.spatialVelocity(name);
        assertThat(velocity.x()).as(what).isCloseTo(x, within(1e-6));
        assertThat(velocity.y()).as(what).isCloseTo(0, within(1e-9));
        assertThat(velocity.z()).as(what).isCloseTo(z, within(1e-6));
    }

    private GeometryObject any(int kind, Point at, String name) {
        double size = random.nextDouble(0.1, 0.6);
        double height = random.nextDouble(0.2, 1.2);
        GeometryObject shape = switch (kind) {
            case 0 -> new SphereObject(at, size);
            case 1 -> new BoxObject(at, 2 * size, height, 1);
            case 2 -> new CylinderObject(at, size, height);
            default -> new CapsuleObject(at, size, height);
        };
        return shape.moveable(name);
    }

    /** What meets off its centre without restitution goes on touching, and slides over a face that turns. */
    @Test
    void momentumIsKeptWhileOneSlidesOverAnother() {
        for (int k = 0; k < Math.max(16, Effort.cases(64)); k++) { // each pair of shapes at least once
            double friction = k % 3 == 0 ? 0.5 : 0;
            double massA = StrictMath.pow(10, random.nextDouble(-1, 1));
            double massB = StrictMath.pow(10, random.nextDouble(-1, 1));
            Dynamics dynamics = two(
                    any(k % 4, new Point(-1.5, 0, 0), "a"),
                    massA,
                    any(k / 4 % 4, new Point(1, random.nextDouble(0.3), random.nextDouble(0.5)), "b"),
                    massB,
                    new Surface(0, friction, friction));
            dynamics.setSpatialVelocity("a", new SpatialVelocity(3, 0, 0, 0, random.nextDouble(-90, 90), 0));
            double seconds = k % 2 == 0 ? 0.01 : 1;
            for (double time = 0; time < 1.4; time += seconds) {
                String what = "case " + k + ", " + time + " s";
                assertThat(dynamics.step(seconds).stopped()).as(what).isEmpty();
                SpatialVelocity one = dynamics.spatialVelocity("a");
                SpatialVelocity other = dynamics.spatialVelocity("b");
                double rounding = 1e-9 * (massA + massB);
                assertThat(massA * one.x() + massB * other.x()).as(what).isCloseTo(3 * massA, within(rounding));
                assertThat(massA * one.y() + massB * other.y()).as(what).isCloseTo(0, within(rounding));
                assertThat(massA * one.z() + massB * other.z()).as(what).isCloseTo(0, within(rounding));
            }
        }
    }

    /** A body bounces as it does alone, to the bit, while others collide far from it. */
    @Test
    void whatCollidesFarAwayChangesNothing() {
        List<Point> places = new ArrayList<>();
        for (boolean isAlone : new boolean[] {true, false}) {
            Geometry world = FallingTest.floor();
            Surface surface = new Surface(0.6, 0.5, 0.4);
            Dynamics dynamics = new Dynamics(world, surface);
            BoxObject box = new BoxObject(new Point(0, 1, 0), 0.5, 0.3, 0.4);
            for (int k = 0; k < (isAlone ? 1 : 4); k++) {
                Point at = new Point(k == 0 ? 0 : 3, k == 0 ? 1 : k, 0);
                assertThat(world.addObject(box.movedTo(at).turned(20 * k, 30).moveable("b" + k)))
                        .isTrue();
                dynamics.add("b" + k, Body.ofMass(box, 1).withSurface(surface));
                dynamics.setSpatialVelocity("b" + k, new SpatialVelocity(0, 0, 0.1, 100, 50, 20));
            }
            for (int step = 0; step < 30; step++) {
                dynamics.advance(0.02);
            }
            places.add(world.getObject("b0").center());
        }
        assertThat(places.get(1)).isEqualTo(places.get(0));
    }

    /** A ball that a heavy one throws reaches in the same slice what neither was near when it began: nothing is lost. */
    @Test
    void whatIsThrownFartherThanItCouldGoByItselfKeepsItsMomentum() {
        int thrown = 0;
        for (int run = 0; run < 40; run++) {
            Geometry world = new Geometry(100, 20, 20);
            Surface smooth = new Surface(run % 2, 0, 0);
            Dynamics dynamics = new Dynamics(world, smooth, WEIGHTLESS);
            double[] mass = {3, 1, 1000};
            double[] at = {0.35, 0.1, -0.401 - 0.002 * run};
            double[] radius = {0.1, 0.1, 0.4};
            for (int k = 0; k < 3; k++) {
                SphereObject ball = new SphereObject(new Point(at[k], 0, 0), radius[k]);
                assertThat(world.addObject(ball.moveable("b" + k))).isTrue();
                dynamics.add("b" + k, Body.of(mass[k], 1).withSurface(smooth));
            }
            dynamics.setSpatialVelocity("b2", new SpatialVelocity(100, 0, 0, 0, 0, 0));
            dynamics.step(0.001);
            double momentum = 0;
            double energy = 0;
            for (int k = 0; k < 3; k++) {
                double v = dynamics.spatialVelocity("b" + k).x();
                momentum += mass[k] * v;
                energy += 0.5 * mass[k] * v * v;
            }
            thrown += dynamics.spatialVelocity("b0").x() > 1 ? 1 : 0;
            assertThat(momentum).as("run %d", run).isCloseTo(1e5, within(1e-4));
            assertThat(energy).as("run %d", run).isLessThan(5e6 * (1 + 1e-9));
        }
        assertThat(thrown).isBetween(6, 38);
    }
}
