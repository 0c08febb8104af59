package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Twist;
import robosim.geometry.net.Session;

/** A step that is made of the values of dynamics, and its answer, which is read as such. */
class StepBundleTest {
    private static final List<GeometryObject> OBJECTS = List.of(
            new BoxObject(new Point(3, 0, 0), 0.5, 1, 8),
            new CylinderObject(new Point(-2, 0, 0.1), 0.25, 1).moveable("robot"),
            new BoxObject(new Point(0.5, 0, 0), 0.5, 1, 0.5).moveable("crate"));

    /** What a session does with a bundle is what Dynamics does with the same values, degrees and radians aside. */
    @Test
    void aSessionCarriesOutWhatDynamicsDoes() {
        Session session = new Session();
        session.reply(new InitBundle(OBJECTS, new WorldSettings(20, 4, 20, Dimension.PLANAR, Accuracy.EXACT)));
        Geometry world = new Geometry(20, 4, 20, Dimension.PLANAR, Accuracy.EXACT);
        OBJECTS.forEach(world::addObjectUnchecked);
        Dynamics dynamics = new Dynamics(world);

        Body crate = Body.of(5, 0.3)
                .withSurface(new Surface(0.25, 0.5, 0.4))
                .withLimits(4, 170)
                .withDamping(0.1, 0.2);
        DifferentialDrive wheels = new DifferentialDrive(0.4, 1.5, 3);
        StepBundle given = StepBundle.of(0)
                .withBody("robot", Body.of(10, 0.5), wheels)
                .withBody("crate", crate, null)
                .withMixing(Surface.Mixing.LARGER, Surface.Mixing.MEAN);
        assertThat(given.bodyNames()).containsExactly("robot", "crate");
        assertThat(answer(session, given).places().keySet()).containsExactly("robot", "crate");
        dynamics.mix(Surface.Mixing.LARGER, Surface.Mixing.MEAN);
        dynamics.add("robot", Body.of(10, 0.5));
        dynamics.add("crate", crate);

        SplittableRandom random = new SplittableRandom(5);
        int contacts = 0;
        int ended = 0;
        for (int k = 0; k < 60; k++) {
            Twist wish = Twist.drive(random.nextDouble(0, 1.5), random.nextDouble(-40, 40));
            Point kick = new Point(k % 10 == 0 ? 12 : random.nextDouble(-6, 1), 0, random.nextDouble(-1, 1));
            Point at = world.getObject("crate").center();
            StepBundle.Answer answer = answer(
                    session,
                    StepBundle.of(0.1).withMotions(Map.of("robot", wish)).withPush("crate", kick, null, at));
            dynamics.drive("robot", wheels.driving(wish.x(), wish.ry()));
            dynamics.applyImpulse("crate", kick, at);
            StepResult truth = dynamics.step(0.1);
            for (String name : List.of("robot", "crate")) {
                Pose place = Objects.requireNonNull(answer.places().get(name));
                GeometryObject object = world.getObject(name);
                assertThat(place.center().x()).isCloseTo(object.center().x(), within(1e-9));
                assertThat(place.center().z()).isCloseTo(object.center().z(), within(1e-9));
                assertThat(place.heading()).isCloseTo(object.heading(), within(1e-7));
                Twist velocity = Objects.requireNonNull(answer.velocities().get(name));
                assertThat(velocity.x()).isCloseTo(dynamics.velocity(name).x(), within(1e-8));
                assertThat(velocity.ry()).isCloseTo(dynamics.velocity(name).ry(), within(1e-6));
            }
            StepResult result = answer.result();
            assertThat(result.stopped()).isEqualTo(truth.stopped());
            assertThat(result.contacts()).hasSameSizeAs(truth.contacts());
            assertThat(result.ended()).hasSameSizeAs(truth.ended());
            for (int c = 0; c < truth.contacts().size(); c++) {
                assertThat(result.contacts().get(c).body())
                        .isEqualTo(truth.contacts().get(c).body());
                assertThat(result.contacts().get(c).phase())
                        .isEqualTo(truth.contacts().get(c).phase());
            }
            contacts += truth.contacts().size();
            ended += truth.ended().size();
        }
        // A run in which nothing touches, or nothing parts, shows nothing.
        assertThat(contacts).isGreaterThan(5);
        assertThat(ended).isGreaterThan(1);
    }

    @Test
    void motionsAreReadAsTheyWereGiven() {
        Map<String, Twist> motions = new LinkedHashMap<>();
        motions.put("b", new Twist(1, 0, -0.5, 90));
        motions.put("a", Twist.drive(0.25, -180));
        StepBundle step = StepBundle.of(0.5).withMotions(motions);
        assertThat(step.motions()).isEqualTo(motions);
        assertThat(step.motions().keySet()).containsExactly("b", "a");
        assertThat(step.withMotions(Map.of("a", Twist.drive(2, 0))).motions())
                .as("of several the last")
                .containsEntry("a", Twist.drive(2, 0));
        assertThat(step.size()).isEqualTo(2);
        assertThat(StepBundle.of(0.5).size()).isZero();
        assertThatThrownBy(() -> StepBundle.of(1).withPush("a", null, null, null))
                .hasMessageContaining("impulse or force must be given");
    }

    private static StepBundle.Answer answer(Session session, StepBundle step) {
        return (StepBundle.Answer) Objects.requireNonNull(session.answer(step));
    }
}
