package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** Bodies that pass through what they ignore, as if it were not there. */
class IgnoredBodiesTest {
    private static final Surface BOUNCY = new Surface(0.5, 0.2, 0.2);

    private static Geometry world(Dimension dimension, Accuracy accuracy) {
        return new Geometry(20, 12, 20, dimension, accuracy);
    }

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void anIgnoredBodyIsPassedThroughAndAnotherOneIsHit(Accuracy accuracy) {
        Geometry world = world(Dimension.PLANAR, accuracy);
        world.addObject(new CylinderObject(new Point(-6, 0, 0), 0.5, 1).moveable("a"));
        world.addObject(new BoxObject(new Point(-3, 0, 0), 1, 1, 1).moveable("b"));
        world.addObject(new BoxObject(new Point(0, 0, 0), 1, 1, 2).named("pane").withLayers(Set.of("glass")));
        world.addObject(new CylinderObject(new Point(3, 0, 0), 0.5, 1).moveable("c"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        Body body = Body.of(2, 1).withSurface(new Surface(1, 0, 0));
        dynamics.add("a", body.ignoring(List.of("glass")));
        dynamics.add("b", body.ignoring(List.of("a")));
        dynamics.add("c", body);
        dynamics.setVelocity("a", new Twist(4, 0, 0, 0));
        StepResult first = dynamics.step(1.5);
        assertThat(first.contacts()).isEmpty();
        assertThat(first.stops()).isEmpty();
        assertThat(world.getObject("a").center()).isEqualTo(new Point(0, 0, 0)); // within the pane
        StepResult second = dynamics.step(1);
        assertThat(second.contacts()).extracting(BodyContact::other).containsExactly("c");
        assertThat(dynamics.velocity("c").x()).isEqualTo(4, within(1e-9));
        assertThat(dynamics.velocity("b").x()).isZero();
        assertThat(world.getObject("b").center()).isEqualTo(new Point(-3, 0, 0));
    }

    @Test
    void aBallFallsThroughAnIgnoredPlateOntoTheFloor() {
        Geometry world = world(Dimension.SPATIAL, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(0, -5.5, 0), 20, 1, 20).named("floor"));
        world.addObject(new BoxObject(new Point(0, -2, 0), 4, 0.5, 4).named("plate"));
        world.addObject(new SphereObject(new Point(0, 0, 0), 0.5).moveable("ball"));
        world.addObject(new BoxObject(new Point(0, -4.25, 0), 1, 1, 1).moveable("crate"));
        Dynamics dynamics = new Dynamics(world);
        dynamics.add("ball", Body.ofMass(new SphereObject(new Point(), 0.5), 1).ignoring(List.of("plate")));
        dynamics.add(
                "crate", Body.ofMass(new BoxObject(new Point(), 1, 1, 1), 1).ignoring(List.of("ball")));
        for (int k = 0; k < 20; k++) {
            for (BodyContact contact : dynamics.step(0.1).contacts()) {
                assertThat(contact.other()).isEqualTo("floor");
            }
        }
        assertThat(world.getObject("ball").center().y()).isEqualTo(-4.5, within(1e-3));
        assertThat(world.getObject("crate").center().y()).isEqualTo(-4.5, within(1e-3)); // both in one place
    }

    /** Two lots of bodies that ignore each other go as each lot does by itself. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void lotsThatIgnoreEachOtherAreInWorldsOfTheirOwn(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(40_301);
        int contacts = 0;
        for (int n = 0; n < 8; n++) {
            Geometry both = world(dimension, Accuracy.EXACT);
            Geometry red = world(dimension, Accuracy.EXACT);
            Geometry blue = world(dimension, Accuracy.EXACT);
            Dynamics all = new Dynamics(both, BOUNCY);
            Dynamics reds = new Dynamics(red, BOUNCY);
            Dynamics blues = new Dynamics(blue, BOUNCY);
            for (int k = 0; k < 16; k++) {
                boolean isRed = k % 2 == 0;
                GeometryObject shape = shape(random).moveable((isRed ? "red " : "blue ") + k);
                GeometryObject object = shape.withLayers(Set.of(isRed ? "reds" : "blues"));
                Geometry own = isRed ? red : blue;
                if (!own.addObject(object)) {
                    continue;
                }
                both.addObjectUnchecked(object);
                Body body = Body.ofMass(shape, 1 + random.nextDouble()).withSurface(BOUNCY);
                String name = String.valueOf(object.name());
                Twist velocity = new Twist(random.nextDouble(-4, 4), 0, random.nextDouble(-4, 4), 0);
                (isRed ? reds : blues).add(name, body);
                (isRed ? reds : blues).setVelocity(name, velocity);
                all.add(name, body);
                all.setVelocity(name, velocity);
            }
            for (String name : red.objects().stream()
                    .map(each -> String.valueOf(each.name()))
                    .toList()) {
                all.add(name, all.body(name).ignoring(List.of("blues"))); // one side is enough
            }
            for (int step = 0; step < 4; step++) {
                int told = all.step(0.25).contacts().size();
                int alone = reds.step(0.25).contacts().size()
                        + blues.step(0.25).contacts().size();
                assertThat(told).isEqualTo(alone);
                contacts += told;
            }
            for (Geometry own : List.of(red, blue)) {
                for (GeometryObject each : own.objects()) {
                    Point expected = each.center();
                    Point found = both.getObject(String.valueOf(each.name())).center();
                    assertThat(found.x()).isEqualTo(expected.x(), within(1e-9));
                    assertThat(found.y()).isEqualTo(expected.y(), within(1e-9));
                    assertThat(found.z()).isEqualTo(expected.z(), within(1e-9));
                }
            }
        }
        assertThat(contacts).isGreaterThan(9);
    }

    private static GeometryObject shape(SplittableRandom random) {
        Point at = new Point(random.nextDouble(-4, 4), random.nextDouble(-4, 4), random.nextDouble(-4, 4));
        return random.nextBoolean() ? new SphereObject(at, 0.6) : new CylinderObject(at, 0.5, 1.2);
    }

    /** Where a pair counts again while one is in the other, they may part and do not go deeper. */
    @Test
    void aPairThatCountsAgainParts() {
        Geometry world = world(Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new CylinderObject(new Point(0, 0, 0), 0.5, 1).moveable("a"));
        world.addObjectUnchecked(new CylinderObject(new Point(0.25, 0, 0), 0.5, 1).moveable("b"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("a", Body.of(1, 1).ignoring(List.of("b")));
        dynamics.add("b", Body.of(1, 1));
        dynamics.setVelocity("a", new Twist(0.25, 0, 0, 0));
        dynamics.step(0.5);
        assertThat(world.getObject("a").center().x()).isEqualTo(0.125, within(1e-12));
        dynamics.add("a", Body.of(1, 1));
        dynamics.step(0.5);
        assertThat(world.getObject("a").center().x()).isLessThan(0.126);
        dynamics.setVelocity("a", new Twist(-1, 0, 0, 0));
        dynamics.step(1);
        assertThat(world.getObject("a").center().x()).isLessThan(-0.5);
    }

    @Test
    void anUnknownNameIsRefusedAndOneThatHasGoneIsNot() {
        Geometry world = world(Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new CylinderObject(new Point(-2, 0, 0), 0.5, 1).moveable("a"));
        world.addObject(new BoxObject(new Point(0, 0, 0), 1, 1, 1).named("crate"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        Body passing = Body.of(1, 1).ignoring(List.of("crate"));
        assertThatThrownBy(() -> dynamics.add("a", Body.of(1, 1).ignoring(List.of("crat"))))
                .hasMessageContaining("perhaps \"crate\" (got: \"crat\")");
        assertThat(dynamics.has("a")).isFalse();
        dynamics.add("a", passing);
        world.removeObject("crate");
        dynamics.setVelocity("a", new Twist(1, 0, 0, 0));
        dynamics.step(1);
        assertThat(world.addObject(new BoxObject(new Point(1, 0, 0), 1, 1, 1).named("crate")))
                .isTrue();
        dynamics.step(4);
        assertThat(world.getObject("a").center().x()).isEqualTo(3, within(1e-9)); // the name counts, not the object
    }

    /** What a step that failed has changed about its bodies is as before: who is ignored, and the mass too. */
    @Test
    void aFailedStepTakesItsBodiesBack() {
        Geometry world = world(Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new CylinderObject(new Point(-3, 0, 0), 0.5, 1).moveable("a"));
        world.addObject(new CylinderObject(new Point(3, 0, 0), 0.5, 1).moveable("b"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("a", Body.of(2, 1));
        dynamics.add("b", Body.of(2, 1));
        dynamics.setVelocity("a", new Twist(4, 0, 0, 0));
        dynamics.step(0.1);
        for (Body other : List.of(Body.of(200, 1), Body.of(2, 1).ignoring(List.of("b")))) {
            assertThatThrownBy(() -> dynamics.together(() -> {
                        dynamics.add("a", other);
                        dynamics.step(0.5);
                        throw new IllegalStateException("as a limit does");
                    }))
                    .hasMessage("as a limit does");
        }
        dynamics.step(2);
        assertThat(dynamics.velocity("a").x()).isEqualTo(2, within(1e-9)); // they stick together
        assertThat(dynamics.velocity("b").x()).isEqualTo(2, within(1e-9));
    }
}
