package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** Bodies under gravity beside what is known of them on paper. */
@Tag("slow")
class FallingTest {
    private static final double G = Body.GRAVITY;

    /** How far bodies at rest are from what carries them. */
    private static final double RESTS = 1e-8;

    private static final double[] LEVEL = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    static Geometry world() {
        return new Geometry(100, 100, 100, Dimension.SPATIAL, Accuracy.EXACT);
    }

    /** A floor whose top is at height 0. */
    static Geometry floor() {
        Geometry world = world();
        world.addObject(new BoxObject(new Point(0, -0.5, 0), 40, 1, 40).named("floor"));
        return world;
    }

    /** A rotation about the world's Z, which tips what points along X upward. */
    static double[] tipped(double degrees) {
        double cos = StrictMath.cos(StrictMath.toRadians(degrees));
        double sin = StrictMath.sin(StrictMath.toRadians(degrees));
        return new double[] {cos, -sin, 0, sin, cos, 0, 0, 0, 1};
    }

    static void assertApart(Geometry world, String name, String when) {
        GeometryObject body = world.getObject(name);
        for (GeometryObject other : world.objects()) {
            if (!name.equals(other.name())) {
                assertThat(CollisionDetection.intersects(body, other))
                        .as("%s: %s and %s", when, body, other)
                        .isFalse();
            }
        }
    }

    private static Dynamics one(Geometry world, GeometryObject shape, Surface surface) {
        Body body = Body.ofMass(shape.oriented(LEVEL), 2);
        assertThat(world.addObject(shape.moveable("body"))).isTrue();
        Dynamics dynamics = new Dynamics(world, surface);
        dynamics.add("body", body.withSurface(surface));
        return dynamics;
    }

    @Test
    void aBallInFreeFallIsWhereItShouldBe() {
        Geometry world = world();
        Dynamics dynamics = one(world, new SphereObject(new Point(0, 40, 0), 0.5), Surface.SMOOTH);
        dynamics.setSpatialVelocity("body", new SpatialVelocity(3, 0, -1, 0, 90, 0));
        dynamics.step(2);
        Point at = world.getObject("body").center();
        assertThat(at.x()).isCloseTo(6, within(1e-10));
        assertThat(at.y()).isCloseTo(40 - 2 * G, within(1e-10));
        assertThat(at.z()).isCloseTo(-2, within(1e-10));
        assertThat(dynamics.spatialVelocity("body").y()).isCloseTo(-2 * G, within(1e-10));
        assertThat(dynamics.spatialVelocity("body").ry()).isCloseTo(90, within(1e-10));
        assertThat(world.getObject("body").heading()).isCloseTo(180, within(1e-9));
    }

    /** How high a ball will be at the top, above where it rests, if nothing is in its way: its energy, but for its mass. */
    private static double top(Geometry world, Dynamics dynamics) {
        double speed = dynamics.spatialVelocity("body").y();
        return world.getObject("body").center().y() - 0.5 - RESTS + speed * speed / (2 * G);
    }

    @ParameterizedTest
    @CsvSource({"0.3, 0.001", "0.5, 0.001", "0.8, 0.001", "0.3, 0.007", "0.5, 0.01", "0.8, 0.1"})
    void aBallBouncesToTheSquareOfTheRestitution(double restitution, double seconds) {
        Geometry world = floor();
        Surface surface = new Surface(restitution, 0.5, 0.4);
        Dynamics dynamics = one(world, new SphereObject(new Point(0, 1.5, 0), 0.5), surface);
        double height = 1 - RESTS;
        int bounces = 0;
        while (bounces < 3) {
            dynamics.step(seconds);
            double top = top(world, dynamics);
            if (top < height / 2 + height * restitution * restitution / 2) {
                height *= restitution * restitution;
                bounces++;
            }
            assertThat(top).as("bounce %d", bounces).isCloseTo(height, within(1e-9));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.03, 1})
    void anElasticBallBouncesForGood(double seconds) {
        Geometry world = floor();
        Dynamics dynamics = one(world, new SphereObject(new Point(0, 1.5, 0), 0.5), new Surface(1, 0.5, 0.4));
        for (double time = 0; time < 20; time += seconds) {
            dynamics.step(seconds);
            assertThat(top(world, dynamics)).isCloseTo(1 - RESTS, within(1e-9));
        }
    }

    @Test
    void aBallWithoutRestitutionRestsAtOnce() {
        Geometry world = floor();
        Dynamics dynamics = one(world, new SphereObject(new Point(0, 1.5, 0), 0.5), Surface.SMOOTH);
        dynamics.step(0.5);
        assertThat(top(world, dynamics)).isCloseTo(0, within(1e-9));
        dynamics.step(0.5);
        assertThat(dynamics.spatialVelocity("body")).isEqualTo(SpatialVelocity.REST);
    }

    @Test
    void aBallThatSlidesRollsInTheEnd() {
        Geometry world = floor();
        Dynamics dynamics = one(world, new SphereObject(new Point(0, 0.5 + 1e-7, 0), 0.5), new Surface(0, 0.3, 0.3));
        dynamics.setSpatialVelocity("body", new SpatialVelocity(2, 0, 0, 0, 0, 0));
        dynamics.step(0.1);
        assertThat(dynamics.spatialVelocity("body").x()).isCloseTo(2 - 0.3 * G * 0.1, within(1e-7)); // still slides
        dynamics.step(1);
        SpatialVelocity rolls = dynamics.spatialVelocity("body");
        assertThat(rolls.x()).isCloseTo(10.0 / 7, within(1e-7));
        assertThat(rolls.rz()).isCloseTo(-StrictMath.toDegrees(rolls.x() / 0.5), within(1e-4));
        dynamics.step(1);
        assertThat(dynamics.spatialVelocity("body").x()).isCloseTo(rolls.x(), within(1e-7));
        assertApart(world, "body", "rolling");
    }

    @Test
    void aBallRollsDownASlopeWithFiveSeventhsOfTheSlide() {
        Geometry world = world();
        world.addObject(new BoxObject(new Point(0, 0, 0), 40, 1, 40).oriented(tipped(-20)));
        double high = 0.5 + 0.3 + 1e-7;
        double[] r = tipped(-20);
        Dynamics dynamics =
                one(world, new SphereObject(new Point(r[1] * high, r[4] * high, 0), 0.3), new Surface(0, 0.9, 0.9));
        dynamics.step(1);
        double speed = 5.0 / 7 * G * StrictMath.sin(StrictMath.toRadians(20));
        assertThat(dynamics.spatialVelocity("body").speed()).isCloseTo(speed, within(1e-6));
    }

    @ParameterizedTest
    @ValueSource(doubles = {10, 20, 26, 27, 30, 40})
    void aBlockSlidesAboveTheAngleOfFrictionAndRestsBelowIt(double degrees) {
        double friction = 0.5; // 26.565 degrees
        Geometry world = world();
        double[] r = tipped(degrees);
        world.addObject(new BoxObject(new Point(0, 0, 0), 40, 1, 40).oriented(r).named("slope"));
        double high = 0.5 + 0.1 + RESTS;
        BoxObject block = new BoxObject(new Point(r[1] * high, r[4] * high, 0), 0.4, 0.2, 0.4);
        Dynamics dynamics = one(world, block.oriented(r), new Surface(0, friction, friction));
        Point from = world.getObject("body").center();
        dynamics.step(1);
        assertApart(world, "body", "on a slope");
        Point to = world.getObject("body").center();
        double way =
                StrictMath.sqrt((to.x() - from.x()) * (to.x() - from.x()) + (to.y() - from.y()) * (to.y() - from.y()));
        double acceleration = Math.max(0, G * (r[3] - friction * r[0]));
        assertThat(way).isCloseTo(acceleration / 2, within(1e-9));
        assertThat(dynamics.spatialVelocity("body").speed()).isCloseTo(acceleration, within(1e-9));
        dynamics.step(1);
        if (acceleration == 0) {
            assertThat(dynamics.spatialVelocity("body")).isEqualTo(SpatialVelocity.REST);
            assertThat(world.getObject("body").center().x()).isCloseTo(to.x(), within(1e-9));
        } else {
            assertThat(dynamics.spatialVelocity("body").speed()).isCloseTo(2 * acceleration, within(1e-9));
        }
    }

    /** With less friction once it slides: at whatever angle static friction is overcome, it slides at once, and only there. */
    @ParameterizedTest
    @ValueSource(doubles = {-1, -0.01, -0.001, 0.001, 0.01, 0.1, 1, 5})
    void aBlockSlidesAtOnceWhereStaticFrictionIsOvercome(double beyond) {
        for (double size : new double[] {0.4, 1}) {
            Geometry world = world();
            double[] r = tipped(StrictMath.toDegrees(StrictMath.atan(0.5)) + beyond);
            world.addObject(
                    new BoxObject(new Point(0, 0, 0), 40, 1, 40).oriented(r).named("slope"));
            double high = 0.5 + 0.1 + RESTS;
            BoxObject block = new BoxObject(new Point(r[1] * high, r[4] * high, 0), size, 0.2, size);
            Dynamics dynamics = one(world, block.oriented(r), new Surface(0, 0.5, 0.4));
            Point from = world.getObject("body").center();
            dynamics.step(1);
            double acceleration = beyond < 0 ? 0 : G * (r[3] - 0.4 * r[0]);
            assertThat(way(from, world)).isCloseTo(acceleration / 2, within(1e-8));
            assertThat(dynamics.spatialVelocity("body").speed()).isCloseTo(acceleration, within(1e-8));
            dynamics.step(beyond < 0 ? 9 : 1);
            assertThat(way(from, world)).isCloseTo(2 * acceleration, within(1e-8));
        }
    }

    private static double way(Point from, Geometry world) {
        Point to = world.getObject("body").center();
        return StrictMath.hypot(to.x() - from.x(), to.y() - from.y());
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aTallBlockTipsOverWhereItsCentreIsBesideItsBase(boolean isCylinder) {
        for (double degrees : new double[] {24.5, 28.5}) { // the tangent of 26.565 is half a base over half a height
            Geometry world = world();
            double[] r = tipped(degrees);
            world.addObject(new BoxObject(new Point(0, 0, 0), 40, 1, 40).oriented(r));
            double high = 0.5 + 0.5 + 1e-7;
            Point at = new Point(r[1] * high, r[4] * high, 0);
            GeometryObject tower = isCylinder ? new CylinderObject(at, 0.25, 1) : new BoxObject(at, 0.5, 1, 0.5);
            Dynamics dynamics = one(world, tower.oriented(r), new Surface(0, 2, 2));
            dynamics.step(1.3);
            double[] now = world.getObject("body").pose().rotation();
            double upright = now[1] * r[1] + now[4] * r[4] + now[7] * r[7];
            if (degrees < 26) {
                assertThat(upright).as("%s degrees", degrees).isCloseTo(1, within(1e-9));
            } else {
                assertThat(upright).as("%s degrees", degrees).isLessThan(0.5);
            }
            assertApart(world, "body", "tipping");
        }
    }

    @Test
    void whateverFallsComesToLieOnASide() {
        List<GeometryObject> shapes = List.of(
                new BoxObject(new Point(0, 2, 0), 1, 0.5, 0.7),
                new CylinderObject(new Point(0, 2, 0), 0.3, 1),
                new CapsuleObject(new Point(0, 2, 0), 0.3, 1.2));
        List<List<Double>> heights = List.of(List.of(0.25, 0.35, 0.5), List.of(0.3, 0.5), List.of(0.3));
        for (int k = 0; k < shapes.size(); k++) {
            for (int degrees = 5; degrees < 90; degrees += 17) {
                Geometry world = floor();
                GeometryObject shape = shapes.get(k).turned(0, 20).oriented(tipped(degrees));
                Dynamics dynamics = one(world, shape, new Surface(0.3, 0.6, 0.5));
                dynamics.add("body", dynamics.body("body").withDamping(0.3, 0.3));
                String when = shape + " at " + degrees;
                for (int step = 0; step < 120; step++) {
                    dynamics.step(0.1);
                    assertApart(world, "body", when);
                }
                assertThat(dynamics.spatialVelocity("body")).as(when).isEqualTo(SpatialVelocity.REST);
                double high = world.getObject("body").center().y();
                assertThat(heights.get(k).stream()
                                .mapToDouble(at -> Math.abs(at - high))
                                .min()
                                .orElse(1))
                        .as(when)
                        .isLessThan(1e-5);
            }
        }
    }

    @Test
    void aBallRestsOnTrianglesAndOnCells() {
        List<Point> corners = List.of(
                new Point(-5, 0, -5), new Point(5, 0, -5), new Point(5, 0, 5), new Point(-5, 0, 5), new Point(0, 0, 0));
        MeshObject sheet = new MeshObject(corners, new int[][] {{0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}});
        BitSet occupied = new BitSet();
        occupied.set(0, 100);
        GridObject cells = new GridObject(new Point(0, 0, 0), 0.5, 1, 10, 10, occupied);
        for (boolean isMesh : new boolean[] {true, false}) {
            Geometry world = world();
            world.addObject(isMesh ? sheet : cells);
            double top = isMesh ? 0 : 0.5;
            for (GeometryObject shape : List.of(
                    new SphereObject(new Point(-1.03, top + 1, 0.4), 0.3),
                    new BoxObject(new Point(0.1, top + 1, 0.2), 0.5, 0.4, 0.3))) {
                Geometry each = world.snapshot().toGeometry();
                Dynamics dynamics = one(each, shape, new Surface(0.2, 0.5, 0.5));
                dynamics.step(2);
                assertApart(each, "body", "on the ground");
                assertThat(each.getObject("body").center().y() - top)
                        .isCloseTo(shape instanceof SphereObject ? 0.3 : 0.2, within(1e-6));
            }
        }
    }

    @Test
    void contactsBeginLastAndEnd() {
        Geometry world = floor();
        Dynamics dynamics = one(world, new SphereObject(new Point(1, 0.6, 2), 0.5), new Surface(0, 0, 0));
        assertThat(dynamics.step(0.1).contacts()).isEmpty();
        StepResult met = dynamics.step(0.1);
        assertThat(met.contacts()).hasSize(1);
        BodyContact contact = met.contacts().get(0);
        assertThat(contact.body()).isEqualTo("body");
        assertThat(contact.other()).isEqualTo("floor");
        assertThat(contact.phase()).isEqualTo(BodyContact.Phase.BEGIN);
        assertThat(contact.normal()).isEqualTo(new Point(0, 1, 0));
        assertThat(contact.point().x()).isCloseTo(1, within(1e-9));
        assertThat(contact.point().y()).isCloseTo(0, within(1e-7));
        // All of its momentum, and of what gravity has added since.
        assertThat(contact.impulse()).isCloseTo(2 * G * 0.2, within(1e-4));
        assertThat(dynamics.step(0.1).contacts().get(0).phase()).isEqualTo(BodyContact.Phase.LAST);
        dynamics.setSpatialVelocity("body", new SpatialVelocity(0, 3, 0, 0, 0, 0));
        StepResult left = dynamics.step(0.1);
        assertThat(left.contacts()).isEmpty();
        assertThat(left.ended()).hasSize(1);
    }

    @Test
    void twoBallsExchangeTheirVelocities() {
        Geometry world = world();
        world.addObject(new SphereObject(new Point(-2, 0, 0), 0.5).moveable("a"));
        world.addObject(new SphereObject(new Point(2, 0, 0), 0.5).moveable("b"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH, new Point(0, 0, 0));
        Surface elastic = new Surface(1, 0, 0);
        dynamics.add("a", Body.ofMass(world.getObject("a"), 2).withSurface(elastic));
        dynamics.add("b", Body.ofMass(world.getObject("b"), 2).withSurface(elastic));
        dynamics.setSpatialVelocity("a", new SpatialVelocity(4, 0, 0, 0, 0, 0));
        StepResult met = dynamics.step(1);
        assertThat(met.contacts()).hasSize(1);
        assertThat(met.contacts().get(0).body()).isEqualTo("a");
        assertThat(met.contacts().get(0).other()).isEqualTo("b");
        assertThat(met.contacts().get(0).normal().x()).isCloseTo(-1, within(1e-9));
        assertThat(met.contacts().get(0).impulse()).isCloseTo(8, within(1e-6));
        assertThat(dynamics.spatialVelocity("a").x()).isCloseTo(0, within(1e-7));
        assertThat(dynamics.spatialVelocity("b").x()).isCloseTo(4, within(1e-7));
    }

    @Test
    void aBoxRestsOnABox() {
        Geometry world = floor();
        world.addObject(new BoxObject(new Point(0, 0.5 + 1e-6, 0), 1, 1, 1).moveable("low"));
        world.addObject(new BoxObject(new Point(0.1, 1.4, 0.05), 0.6, 0.6, 0.6).moveable("high"));
        Surface surface = new Surface(0, 0.6, 0.5);
        Dynamics dynamics = new Dynamics(world, surface);
        for (String name : List.of("low", "high")) {
            dynamics.add(name, Body.ofMass(world.getObject(name), 3).withSurface(surface));
        }
        for (int step = 0; step < 40; step++) {
            dynamics.step(0.1);
            assertApart(world, "low", "step " + step);
            assertApart(world, "high", "step " + step);
        }
        assertThat(world.getObject("high").center().y()).isCloseTo(1.3, within(1e-5));
        assertThat(dynamics.spatialVelocity("high")).isEqualTo(SpatialVelocity.REST);
        assertThat(dynamics.spatialVelocity("low")).isEqualTo(SpatialVelocity.REST);
    }

    @Test
    void whatIsTakenFromUnderABodyLetsItFall() {
        Geometry world = floor();
        world.addObject(new BoxObject(new Point(0, 1, 0), 1, 0.2, 1).named("shelf"));
        Dynamics dynamics = one(world, new BoxObject(new Point(0, 1.3, 0), 0.3, 0.3, 0.3), new Surface(0, 0.5, 0.5));
        dynamics.step(3);
        assertThat(world.getObject("body").center().y()).isCloseTo(1.25, within(1e-6));
        world.removeObject("shelf");
        dynamics.step(3);
        assertThat(world.getObject("body").center().y()).isCloseTo(0.15, within(1e-6));
    }

    @Test
    void aBodyStaysWithinTheBorderOfTheWorld() {
        Geometry world = new Geometry(4, 4, 4, Dimension.SPATIAL, Accuracy.EXACT);
        Dynamics dynamics = one(world, new BoxObject(new Point(0, 0, 0), 0.5, 0.4, 0.3), new Surface(0.2, 0.5, 0.5));
        dynamics.setSpatialVelocity("body", new SpatialVelocity(5000, 100, 30, 400, 0, 90));
        dynamics.step(3);
        assertThat(world.getObject("body").center().y()).isBetween(-1.86, -1.74);
        assertThat(dynamics.last().contacts().get(0).other()).isNull();
    }

    @Test
    void velocitiesAreAlongTheWorldsAxesOrTheOwn() {
        Geometry world = floor();
        Dynamics dynamics = one(world, new BoxObject(new Point(0, 5, 0), 1, 1, 1).turned(0, 90), Surface.SMOOTH);
        dynamics.setVelocity("body", new Twist(2, 1, 0, 30));
        SpatialVelocity there = dynamics.spatialVelocity("body");
        assertThat(there.z()).isCloseTo(-2, within(1e-12)); // forward is -Z at a heading of 90 degrees
        assertThat(there.y()).isCloseTo(1, within(1e-12));
        assertThat(there.ry()).isCloseTo(30, within(1e-12));
        assertThat(dynamics.velocity("body").x()).isCloseTo(2, within(1e-12));
        assertThat(dynamics.velocity("body").ry()).isCloseTo(30, within(1e-12));
    }

    @Test
    void inertiaIsThatOfSolids() {
        assertThat(moments(new BoxObject(new Point(), 1, 2, 3), 12)).containsExactly(13, 10, 5);
        assertThat(moments(new SphereObject(new Point(), 0.5), 10)).containsExactly(1, 1, 1);
        double[] cylinder = moments(new CylinderObject(new Point(), 2, 3), 12);
        assertThat(cylinder).containsExactly(new double[] {21, 24, 21}, within(1e-12));
        // A capsule without a segment is a ball; a long one is nearly a rod.
        double[] ball = moments(new CapsuleObject(new Point(), 0.5, 0), 10);
        assertThat(ball).containsExactly(new double[] {1, 1, 1}, within(1e-12));
        double[] rod = moments(new CapsuleObject(new Point(), 1e-3, 6), 1);
        assertThat(rod[0]).isCloseTo(3, within(3e-3));
        Body given = Body.of(3, 1).withInertia(4, 5, 6);
        assertThat(given.moments(new BoxObject(new Point(), 1, 1, 1))).containsExactly(4, 5, 6);
        // Where one moment is given, the others follow from the shape.
        Body one = Body.of(3, 20);
        assertThat(one.moments(new BoxObject(new Point(), 1, 2, 3))).containsExactly(26, 20, 10);
    }

    private static double[] moments(GeometryObject shape, double mass) {
        return Body.ofMass(shape, mass).moments(shape);
    }

    @Test
    void badArgumentsAreNamed() {
        Geometry flat = new Geometry(10, 10, 10, Dimension.PLANAR, Accuracy.EXACT);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Dynamics(flat, Surface.SMOOTH, new Point(0, -1, 0)))
                .withMessageContaining("SPATIAL");
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () -> new Dynamics(new Geometry(10, 10, 10, Dimension.SPATIAL, Accuracy.OBB), Surface.SMOOTH))
                .withMessageContaining("EXACT");
        Geometry world = floor();
        world.addObject(new MeshObject(
                        List.of(new Point(0, 5, 0), new Point(1, 5, 0), new Point(0, 5, 1)), new int[][] {{0, 1, 2}})
                .moveable("mesh"));
        world.addObject(new SphereObject(new Point(0, 3, 0), 0.5).moveable("ball"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> dynamics.add("mesh", Body.of(1, 1)))
                .withMessageContaining("sphere, box, cylinder or capsule");
        dynamics.add("ball", Body.of(1, 1));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SpatialVelocity(0, Double.NaN, 0, 0, 0, 0))
                .withMessageStartingWith("y ");
        flat.addObject(new SphereObject(new Point(0, 0, 0), 0.5).moveable("ball"));
        Dynamics level = new Dynamics(flat, Surface.SMOOTH);
        level.add("ball", Body.of(1, 1));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> level.setSpatialVelocity("ball", SpatialVelocity.REST))
                .withMessageContaining("SPATIAL");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> level.spatialVelocity("ball"))
                .withMessageContaining("SPATIAL");
    }
}
