package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.dynamics.Surface.Mixing;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

class BodyTest {
    private static final int SAMPLES = 200_000;

    /** Against points thrown into a box around the shape: how many are inside, and how far they are from the vertical. */
    @Test
    void massAndInertiaAreThoseOfThePointsInside() {
        SplittableRandom random = new SplittableRandom(5);
        for (GeometryObject shape : List.of(
                new BoxObject(new Point(), 1.5, 0.7, 0.4),
                new BoxObject(new Point(), 1.5, 0.7, 0.4).turned(0, 33),
                new CylinderObject(new Point(), 0.8, 1.1),
                new SphereObject(new Point(), 0.9),
                new SphereObject(new Point(), 0.9).turned(30, 40),
                new CapsuleObject(new Point(), 0.5, 0.8))) {
            int inside = 0;
            double squares = 0;
            for (int k = 0; k < SAMPLES; k++) {
                Point p = new Point(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
                if (CollisionDetection.intersects(shape, new SphereObject(p, 0))) {
                    inside++;
                    squares += p.x() * p.x() + p.z() * p.z();
                }
            }
            Body body = Body.ofDensity(shape, 250);
            assertThat(body.mass()).as("%s", shape).isCloseTo(250.0 * 8 * inside / SAMPLES, within(body.mass() * 0.02));
            assertThat(body.inertia() / body.mass())
                    .as("%s", shape)
                    .isCloseTo(squares / inside, within(0.02 * body.inertia() / body.mass()));
            assertThat(Body.ofMass(shape, 3).inertia()).isCloseTo(3 * body.inertia() / body.mass(), within(1e-12));
        }
    }

    @Test
    void otherShapesNeedTheirInertia() {
        assertThatThrownBy(() -> Body.ofMass(new ObjectGroup(List.of(new SphereObject(new Point(), 1))), 1))
                .hasMessageStartingWith(
                        "shape must be a sphere, box, cylinder or capsule; for other shapes, give mass");
        assertThatThrownBy(() -> Body.ofMass(new SphereObject(new Point(), 0), 1))
                .hasMessageStartingWith("shape must not be a point or a line along its own Y")
                .hasMessageContaining("Body.of(mass, inertia) (got: ");
        assertThatThrownBy(() -> Body.ofMass(new CapsuleObject(new Point(), 0, 1), 1))
                .hasMessageStartingWith("shape must not be a point or a line along its own Y");
        assertThatThrownBy(() -> Body.ofDensity(new SphereObject(new Point(), 0), 1))
                .hasMessageStartingWith("shape must have a volume; ");
        assertThatThrownBy(() -> Body.ofDensity(new BoxObject(new Point(), 1, 0, 1), 1))
                .hasMessageStartingWith("shape must have a volume; ");
        assertThat(Body.ofMass(new BoxObject(new Point(), 1, 0, 1), 6).inertia())
                .as("a plate")
                .isEqualTo(1);
    }

    /** A tilted solid: three moments about its own axes, of which its attitude makes the one about the vertical. */
    @Test
    void tiltedShapesHaveMomentsOfTheirOwnAxes() {
        SplittableRandom random = new SplittableRandom(4);
        GeometryObject[] shapes = {
            new BoxObject(new Point(), 1.2, 0.5, 0.8),
            new CylinderObject(new Point(), 0.4, 1.5),
            new CapsuleObject(new Point(), 0.3, 1)
        };
        for (GeometryObject upright : shapes) {
            GeometryObject tilted = upright.turned(50, 20).turned(15, 0);
            Body body = Body.ofMass(tilted, 3);
            assertThat(body.mass()).isEqualTo(3);
            assertThat(body.inertia()).isEqualTo(Body.ofMass(upright, 3).inertia());
            assertThat(Body.ofDensity(tilted, 90).mass())
                    .isEqualTo(Body.ofDensity(upright, 90).mass());
            double[] squares = new double[4]; // about the own axes, and about the vertical
            int inside = 0;
            for (int k = 0; k < SAMPLES; k++) {
                double x = random.nextDouble(-1, 1);
                double y = random.nextDouble(-1, 1);
                double z = random.nextDouble(-1, 1);
                if (CollisionDetection.intersects(upright, new SphereObject(new Point(x, y, z), 0))) {
                    inside++;
                    squares[0] += y * y + z * z;
                    squares[1] += x * x + z * z;
                    squares[2] += x * x + y * y;
                    double up = tilted.rotation()[3] * x + tilted.rotation()[4] * y + tilted.rotation()[5] * z;
                    squares[3] += x * x + y * y + z * z - up * up;
                }
            }
            double[] moments = {body.inertiaX(), body.inertia(), body.inertiaZ(), spun(tilted, body)};
            for (int axis = 0; axis < 4; axis++) {
                assertThat(moments[axis])
                        .as("%s about axis %d", tilted, axis)
                        .isCloseTo(3 * squares[axis] / inside, within(0.02 * moments[axis]));
            }
            assertThat(spun(upright, body)).isCloseTo(body.inertia(), within(1e-12));
        }
    }

    /** The moment of inertia that a torque in a PLANAR world finds, and a collision likewise. */
    private static double spun(GeometryObject shape, Body body) {
        Geometry world = new Geometry(20, 20, 20, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(shape.moveable("top"));
        world.addObject(new CylinderObject(new Point(3, 0, 0.3), 0.01, 1).moveable("ball"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        Surface elastic = new Surface(1, 0, 0);
        dynamics.add("top", body.withSurface(elastic));
        dynamics.add("ball", Body.of(1, 1).withSurface(elastic));
        dynamics.setVelocity("ball", new Twist(-1, 0, 0, 0));
        dynamics.step(2.9);
        double about = 0;
        for (BodyContact contact : dynamics.last().contacts()) {
            Point at = contact.point();
            Point n = contact.normal();
            double sign = contact.body().equals("top") ? contact.impulse() : -contact.impulse();
            // About Y, counter-clockwise: z F_x - x F_z.
            about += sign * (at.z() * n.x() - at.x() * n.z());
        }
        double struck = about / Math.toRadians(dynamics.velocity("top").ry());
        world.removeObject("ball");
        dynamics.setVelocity("top", new Twist(0, 0, 0, 0));
        dynamics.drive("top", new ForceDrive(0, 0, 0.5));
        dynamics.step(1);
        double driven = 0.5 / Math.toRadians(dynamics.velocity("top").ry());
        if (!shape.pose().isUpright()) { // what is round does not turn where it is struck
            assertThat(struck).isCloseTo(driven, within(1e-9 * driven));
        }
        return driven;
    }

    @Test
    void surfacesMixBySelectedRules() {
        double[][] expected = {{0.4, 0.4}, {0.5, 0.5}, {0.8, 0.8}, {0.2, 0.2}, {0.16, 0.16}};
        Surface one = new Surface(0.8, 0.8, 0.8);
        Surface other = new Surface(0.2, 0.2, 0.2);
        for (Mixing rule : Mixing.values()) {
            double truth = expected[rule.ordinal()][0];
            assertThat(rule.of(0.8, 0.2)).isEqualTo(rule.of(0.2, 0.8)).isCloseTo(truth, within(1e-15));
            assertThat(one.against(other, rule, Mixing.LARGER).restitution()).isCloseTo(truth, within(1e-15));
            assertThat(one.against(other, Mixing.LARGER, rule).slidingFriction())
                    .isCloseTo(truth, within(1e-15));
            for (Dimension dimension : Dimension.values()) {
                // A ball bounces off a wall by the restitution of the pair, and a box is slowed by its friction.
                assertThat(bounced(dimension, rule, one, other)).isCloseTo(truth, within(1e-6));
            }
            assertThat(slowed(rule, one, other)).isCloseTo(truth * Body.GRAVITY, within(1e-3));
        }
        assertThat(one.against(other)).isEqualTo(one.against(other, Mixing.GEOMETRIC_MEAN, Mixing.GEOMETRIC_MEAN));
    }

    private static double bounced(Dimension dimension, Mixing rule, Surface one, Surface other) {
        Geometry world = new Geometry(20, 20, 20, dimension, Accuracy.EXACT);
        world.addObject(new SphereObject(new Point(), 0.5).moveable("ball"));
        world.addObject(new BoxObject(new Point(3, 0, 0), 1, 5, 5));
        Dynamics dynamics =
                dimension == Dimension.PLANAR ? new Dynamics(world, other) : new Dynamics(world, other, new Point());
        dynamics.mix(rule, Mixing.GEOMETRIC_MEAN);
        dynamics.add("ball", Body.of(1, 0.1).withSurface(one));
        dynamics.setVelocity("ball", new Twist(1, 0, 0, 0));
        dynamics.step(3);
        return -dynamics.velocity("ball").x();
    }

    /** What is taken back takes the rules along. */
    @Test
    void rulesThatAreTakenBackHoldNoLonger() {
        Geometry world = new Geometry(20, 20, 20, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new SphereObject(new Point(), 0.5).moveable("ball"));
        world.addObject(new BoxObject(new Point(3, 0, 0), 1, 5, 5));
        Dynamics dynamics = new Dynamics(world, new Surface(0, 0, 0));
        dynamics.add("ball", Body.of(1, 0.1).withSurface(new Surface(1, 0, 0)));
        assertThatThrownBy(() -> dynamics.together(() -> {
                    dynamics.mix(Mixing.LARGER, Mixing.LARGER);
                    throw new IllegalStateException("taken back");
                }))
                .hasMessage("taken back");
        dynamics.setVelocity("ball", new Twist(1, 0, 0, 0));
        dynamics.step(3);
        assertThat(dynamics.velocity("ball").x()).isCloseTo(0, within(1e-12));
    }

    private static double slowed(Mixing rule, Surface one, Surface other) {
        Geometry world = new Geometry(20, 20, 20, Dimension.SPATIAL, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(0, -1, 0), 20, 2, 20));
        world.addObject(new BoxObject(new Point(0, 0.1001, 0), 1, 0.2, 1).moveable("box"));
        Dynamics dynamics = new Dynamics(world, other);
        dynamics.mix(Mixing.GEOMETRIC_MEAN, rule);
        dynamics.add("box", Body.ofMass(world.getObject("box"), 1).withSurface(one));
        dynamics.step(0.5);
        dynamics.setVelocity("box", new Twist(5, 0, 0, 0));
        dynamics.step(0.5);
        return 2 * (5 - dynamics.velocity("box").x());
    }

    /** Of masses at random points about any axes, and of plates and rods, where one moment is the sum of the others. */
    @Test
    void momentsAreThoseThatABodyCanHave() {
        SplittableRandom random = new SplittableRandom(8);
        for (int k = 0; k < 10_000; k++) {
            double x = random.nextDouble();
            double y = random.nextDouble();
            double z = k % 3 == 0 ? 0 : random.nextDouble();
            Body body = Body.of(1, 1).withInertia(y + z, x + z, x + y);
            assertThat(body.inertiaZ()).isEqualTo(x + y);
            // Plates in seven digits, as in files.
            Body.of(1, 1).withInertia((float) y, (float) x, (float) (x + y));
            double more = (x + y) * (1 + random.nextDouble(1e-5, 3));
            for (int turn = 0; turn < 3; turn++) {
                double[] m = {x, y, more, x, y};
                int from = turn;
                assertThatThrownBy(() -> Body.of(1, 1).withInertia(m[from], m[from + 1], m[from + 2]))
                        .hasMessageStartingWith("moments of inertia must each be at most the sum of the other two")
                        .hasMessageContaining("(got: " + m[from] + ", " + m[from + 1]);
            }
        }
    }

    @Test
    void eachMomentIsGivenByItself() {
        BoxObject box = new BoxObject(new Point(), 1, 2, 3);
        double[] solid = Body.ofMass(box, 12).moments(box);
        assertThat(solid).containsExactly(new double[] {13, 10, 5}, within(1e-12));
        Body given = new Body(12, 10, Surface.SMOOTH, 0, 0, 9, 9, 0, 0, 6);
        assertThat(given.moments(box)).containsExactly(new double[] {13, 10, 6}, within(1e-12));
        given = new Body(12, 10, Surface.SMOOTH, 0, 0, 9, 9, 0, 14, 0);
        assertThat(given.moments(box)).containsExactly(new double[] {14, 10, 5}, within(1e-12));
    }

    @Test
    void badNumbersAreNamed() {
        assertThatThrownBy(() -> Body.of(0, 1)).hasMessageStartingWith("mass ");
        assertThatThrownBy(() -> Body.of(Double.NaN, 1)).hasMessageStartingWith("mass ");
        assertThatThrownBy(() -> Body.of(1, Double.POSITIVE_INFINITY)).hasMessageStartingWith("inertia ");
        assertThatThrownBy(() -> Body.of(1, 1).withDamping(-1, 0)).hasMessageStartingWith("damping ");
        assertThatThrownBy(() -> Body.of(1, 1).withDamping(0, Double.NaN)).hasMessageStartingWith("turnDamping ");
        assertThatThrownBy(() -> Body.of(1, 1).withLimits(Double.NaN, 0)).hasMessageStartingWith("maxSpeed ");
        assertThatThrownBy(() -> Body.of(1, 1).withLimits(0, -1)).hasMessageStartingWith("maxTurn ");
        assertThatThrownBy(() -> new Surface(1.1, 0, 0)).hasMessageStartingWith("restitution ");
        assertThatThrownBy(() -> new Surface(Double.NaN, 0, 0)).hasMessageStartingWith("restitution ");
        assertThatThrownBy(() -> new Surface(0, -1, 0)).hasMessageStartingWith("staticFriction ");
        assertThatThrownBy(() -> new Surface(0, 0.1, 0.2)).hasMessageStartingWith("slidingFriction ");
        assertThatThrownBy(() -> Body.ofDensity(new SphereObject(new Point(), 1), -1))
                .hasMessageStartingWith("density ");
    }

    @Test
    void theSurfaceOfAPairIsTheSameBothWays() {
        SplittableRandom random = new SplittableRandom(6);
        for (int k = 0; k < 10_000; k++) {
            Surface a = surface(random);
            Surface b = surface(random);
            Surface pair = a.against(b);
            assertThat(b.against(a)).isEqualTo(pair);
            assertThat(a.against(a)).isEqualTo(a);
            assertThat(pair.restitution())
                    .isBetween(Math.min(a.restitution(), b.restitution()), Math.max(a.restitution(), b.restitution()));
            assertThat(pair.slidingFriction()).isLessThanOrEqualTo(pair.staticFriction());
            assertThat(a.against(Surface.SMOOTH)).isEqualTo(Surface.SMOOTH);
        }
    }

    private static Surface surface(SplittableRandom random) {
        double still = random.nextInt(4) == 0 ? 1e-300 : random.nextDouble(2);
        return new Surface(random.nextDouble(), still, random.nextBoolean() ? still : still * random.nextDouble());
    }

    @Test
    void limitsKeepTheDirection() {
        Body body = Body.of(1, 1).withLimits(2, 90);
        assertThat(body.limited(new Twist(3, 0, 4, -120))).isEqualTo(new Twist(3 * 0.4, 0, 4 * 0.4, -90));
        assertThat(body.limited(new Twist(1, 0, 1, 60))).isEqualTo(new Twist(1, 0, 1, 60));
        assertThat(body.withLimits(0, 0).limited(new Twist(3, 0, 4, 1))).isEqualTo(new Twist(0, 0, 0, 0));
    }
}
