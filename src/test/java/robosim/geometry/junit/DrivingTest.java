package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.opentest4j.AssertionFailedError;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.ForceDrive;
import robosim.geometry.dynamics.Motor;
import robosim.geometry.dynamics.OmnidirectionalDrive;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.dynamics.SwerveDrive;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.scenario.Mismatch;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioReader;

/** Robots that are driven for a time, push and are pushed, and the scenario that repeats it. */
class DrivingTest {
    private static Geometry arena() {
        Geometry world = new Geometry(20, 5, 20, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(6, 0, 0), 1, 2, 8).named("wall"));
        world.addObject(new BoxObject(new Point(0, 0, 0), 1, 1, 1).moveable("cart"));
        world.addObject(new BoxObject(new Point(2, 0, 0), 1, 1, 1).moveable("crate"));
        world.addObject(new CylinderObject(new Point(-6, 0, 5), 0.3, 1).moveable("drum"));
        return world;
    }

    @Test
    void aRobotDrivesFreely() {
        RobotWorld world = RobotWorld.of(arena());
        world.robot("drum").drives(0.5, 0).forSeconds(10).endsNear(-1, 5, 1e-9).hitsNothing();
        assertThat(world.clock().steps()).isEqualTo(100);
        // It was told to stand, and its drive has no limits.
        world.clock().advance(5);
        world.robot("drum").endsNear(-1, 5, 1e-9);
    }

    @Test
    void aKickAndAForceAreRecordedAndReplayed() throws IOException {
        RobotWorld world = RobotWorld.of(arena());
        Robot crate = world.robot("crate").hasBody(Body.of(10, 2).withDrag(0.5, 0.01));
        crate.getsImpulse(new Point(-20, 0, 0));
        world.robot("drum").drives(0.5, 0).forSeconds(0.5);
        assertThat(crate.velocity().x()).isLessThan(-1).isGreaterThan(-2);
        crate.getsForce(new Point(0, 0, 30));
        world.clock().advance(1);
        assertThat(crate.velocity().z()).isCloseTo(0.3, org.assertj.core.data.Offset.offset(0.05));
        world.clock().advance(20);
        assertThat(crate.contacts())
                .singleElement()
                .satisfies(each -> assertThat(each.other()).isEqualTo("cart"));
        world.robot("drum").losesDrive();
        world.clock().advance(5);
        assertThat(Replay.of(world.scenario("kicked"))).isEmpty();
    }

    @Test
    void aSwerveRobotIsRecordedAndReplayed() {
        RobotWorld world = RobotWorld.of(arena());
        Motor motor = new Motor(7.09, 6000, 366, 6.75, 0.05, 60, 0.002);
        Robot cart = world.robot("cart")
                .hasDrive(SwerveDrive.of(0.8, 0.8, motor, 0.5).steering(300));
        cart.drives(-1, 1, 20).forSeconds(2);
        assertThat(cart.velocity().ry()).isCloseTo(20, org.assertj.core.data.Offset.offset(1.0));
        world.clock().advance(10);
        assertThat(cart.velocity().x()).isCloseTo(0, org.assertj.core.data.Offset.offset(1e-9));
        assertThat(Replay.of(world.scenario("swerve"))).isEmpty();
    }

    @Test
    void aCurveIsACircle() {
        RobotWorld world = RobotWorld.of(arena());
        // Back where it was after 36 s of 10 degrees each; a step turns after it has translated.
        world.robot("drum").drives(0.5, 10).forSeconds(36).endsNear(-6, 5, 0.05).hitsNothing();
        assertThat(world.robot("drum").heading()).isCloseTo(0, org.assertj.core.data.Offset.offset(1e-9));
    }

    @Tag("slow")
    @Test
    void itPushesWhatHasAMass() {
        RobotWorld world = RobotWorld.of(arena());
        world.object("crate").hasMass(5).hasDamping(1, 1);
        world.robot("cart")
                .drives(1, 0)
                .forSeconds(8)
                .hits("crate")
                .isBumpedBy("crate")
                .endsNear(4, 0, 1e-6);
        world.object("crate").endsNear(5, 0, 1e-6);
    }

    @Test
    void whatHasNoMassStandsStill() {
        RobotWorld world = RobotWorld.of(arena());
        Robot cart =
                world.robot("cart").drives(1, 0).forSeconds(3).hits("crate").endsNear(1, 0, 1e-6);
        world.object("crate").endsNear(2, 0, 0);
        assertThatThrownBy(() -> cart.isBumpedBy("crate"))
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageContaining("no body");
    }

    @Test
    void twoRobotsDriveAtOnceAndBothKnowThatTheyBumped() {
        Geometry geometry = arena();
        geometry.addObject(new CylinderObject(new Point(6, 0, 5), 0.3, 1).moveable("other"));
        RobotWorld world = RobotWorld.of(geometry);
        world.robot("drum").hasBody(Body.of(10, 1).withSurface(new Surface(1, 0, 0)));
        world.robot("other").hasBody(Body.of(10, 1).withSurface(new Surface(1, 0, 0)));
        world.robot("other").drives(-1, 0);
        world.robot("drum").drives(1, 0).forSeconds(7);
        world.robot("drum").isBumpedBy("other");
        world.robot("other").isBumpedBy("drum");
        double apart =
                world.robot("other").center().x() - world.robot("drum").center().x();
        assertThat(apart).isGreaterThanOrEqualTo(0.6);
    }

    /** The turn of a force is a torque, not an angle: half of 0.5 rad/s^2 for 2 s. */
    @Test
    void aTorqueIsInNewtonMetres() {
        RobotWorld world = RobotWorld.of(arena());
        world.robot("drum")
                .hasBody(Body.of(10, 2))
                .hasDrive(new ForceDrive(0, 0, 0))
                .drives(0, 0, 1)
                .forSeconds(2);
        assertThat(world.robot("drum").heading())
                .isCloseTo(Math.toDegrees(0.5 * 0.5 * 4), org.assertj.core.data.Offset.offset(1e-9));
    }

    /** A robot that takes the place of another one of its name is none that drives. */
    @Test
    void anotherRobotOfTheNameInheritsNothing() {
        RobotWorld world = RobotWorld.of(arena());
        world.robot("drum").hasBody(Body.of(7, 2)).drives(0.5, 0).forSeconds(1);
        world.robot("crate").drives(0, 90).forSeconds(1);
        world.geometry().removeObject("drum");
        world.geometry().addObject(new CylinderObject(new Point(-6, 0, 5), 0.3, 1).moveable("drum"));
        world.robot("crate").drives(0, 0).forSeconds(1);
        assertThat(world.robot("crate").heading()).isCloseTo(90, org.assertj.core.data.Offset.offset(1e-6));
        world.robot("drum").endsNear(-6, 5, 0);
        world.robot("drum").drives(1, 0).forSeconds(1).endsNear(-5, 5, 1e-9);
    }

    @Test
    void aDriveHasItsLimits() {
        RobotWorld world = RobotWorld.of(arena());
        world.robot("drum")
                .hasDrive(new DifferentialDrive(0.5, 1, 0.5))
                .drives(9, 0)
                .forSeconds(2);
        // 1/2 a t^2.
        world.robot("drum").endsNear(-6 + 0.5 * 0.5 * 4, 5, 1e-9);
        world.robot("crate")
                .hasDrive(new OmnidirectionalDrive(1, 100, 90, 100))
                .drives(0, 1, 0)
                .forSeconds(2)
                .endsNear(2, 2, 0.02);
    }

    @Test
    void sentencesThatDoNotHoldSayWhatHappened() {
        RobotWorld world = RobotWorld.of(arena());
        Robot cart = world.robot("cart").drives(1, 0).forSeconds(3);
        assertThatThrownBy(cart::hitsNothing)
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageContaining("robot \"cart\" was to hit nothing, but has met box \"crate\" in step ")
                .hasMessageContaining("it stands at (1, 0, 0)");
        assertThatThrownBy(() -> cart.hits("wall"))
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageContaining(
                        "was to hit \"wall\" in step 30, but has met box \"crate\" in step 10 at (1.5, 0, ");
        assertThatThrownBy(() -> world.robot("drum").hits("wall")).hasMessageContaining("has met nothing");
        assertThatThrownBy(() -> cart.endsNear(3, 0, 0.5))
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageContaining("was to be within 0.5 of (3, 0) in step 30, but is 2 away");
        assertThatThrownBy(() -> cart.neverTouches("crate"))
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageContaining("but they met in step 10");
        cart.neverTouches("wall");
    }

    @Test
    void whatCannotBeIsRefused() {
        RobotWorld world = RobotWorld.of(arena());
        assertThatThrownBy(() -> world.robot("cart").drives(1, 0).forSeconds(0.25))
                .hasMessageContaining("seconds must be a multiple of the clock's step of 0.1 s");
        assertThatThrownBy(() -> world.robot("cart").drives(1, 0).forSeconds(-1))
                .hasMessageContaining("seconds must");
        assertThatThrownBy(() -> world.object("cup")).hasMessageContaining("one of [\"wall\", \"cart\"");
        assertThatThrownBy(() -> world.object("crate").hasMass(-1)).hasMessageContaining("mass must be");
    }

    @Test
    void aBehaviourDrives() {
        RobotWorld world = RobotWorld.of(arena());
        world.robot("drum")
                .follows(robot -> robot.drives(robot.center().x() < -4 ? 1 : 0, 0))
                .reaches(Goal.at(-4, 5, 0.1))
                .within(40);
    }

    private static Scenario writtenAndRead(RobotWorld world) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        world.scenario("drives").write(file);
        java.util.ArrayList<robosim.geometry.scenario.Step> steps = new java.util.ArrayList<>();
        try (ScenarioReader reader = ScenarioReader.of(new ByteArrayInputStream(file.toByteArray()), "file")) {
            for (var step = reader.next(); step != null; step = reader.next()) {
                steps.add(step);
            }
            return new Scenario(reader.header(), steps);
        }
    }

    @Test
    void whatWasCarriedIsReplayedToTheBit() throws IOException {
        RobotWorld world = RobotWorld.of(arena());
        world.object("crate").hasMass(5);
        Robot drum = world.robot("drum");
        Robot cart = world.robot("cart").drives(1, 7).forSeconds(0.5);
        cart.attach("crate").drives(0.6, 25).forSeconds(2);
        Pose held = world.geometry()
                .getObject("crate")
                .pose()
                .relativeTo(world.geometry().getObject("cart").pose());
        cart.drives(0.5, -30).forSeconds(1);
        Pose later = world.geometry()
                .getObject("crate")
                .pose()
                .relativeTo(world.geometry().getObject("cart").pose());
        assertThat(later.center().x()).isEqualTo(held.center().x(), within(1e-9));
        assertThat(later.center().z()).isEqualTo(held.center().z(), within(1e-9));
        cart.detach("crate").drives(-1, 0).forSeconds(1);
        assertThat(world.geometry().carrierOf("crate")).isNull();
        assertThat(drum.center()).isNotNull();
        Scenario scenario = writtenAndRead(world);
        assertThat(Replay.of(scenario)).isEmpty();
    }

    @Test
    void whatWasDrivenIsReplayedToTheBit() throws IOException {
        RobotWorld world = RobotWorld.of(arena());
        world.object("crate").hasMass(5).hasDamping(1, 1).hasSurface(new Surface(0.5, 0.5, 0.4));
        world.robot("drum").drives(0.7, 13);
        Robot cart = world.robot("cart").drives(1, 7).forSeconds(4);
        cart.triesToTurn(33);
        cart.range(12);
        // Changed by other means: the bodies go on as they moved, in a world that a replay makes anew.
        world.geometry().addObject(new CylinderObject(new Point(-6, 0, -5), 0.5, 1).named("pillar"));
        world.geometry().removeObject("wall");
        cart.drives(-1, 20).forSeconds(3);
        world.geometry().removeObject("crate");
        cart.drives(1, -20).forSeconds(1);
        Scenario scenario = writtenAndRead(world);
        assertThat(scenario.steps().size()).isGreaterThan(80);
        List<Mismatch> found = Replay.of(scenario);
        assertThat(found).isEmpty();
    }

    @Test
    void aFailureLeavesAPictureAndAPageOfTheDrive(@TempDir Path folder) throws IOException {
        RobotWorld world = RobotWorld.of(arena());
        world.object("crate").hasMass(5).hasDamping(1, 1);
        world.robot("cart").drives(1, 0).forSeconds(3);
        Evidence evidence = new Evidence(folder);
        String lines = evidence.leave("failure", 1, world, new RecordedServer(), "drive");
        assertThat(lines).doesNotContain("none");
        String picture = Files.readString(folder.resolve("last-moments.svg"), StandardCharsets.UTF_8);
        assertThat(picture).contains("cart");
        assertThat(Files.size(folder.resolve("last-moments.html"))).isGreaterThan(10_000);
    }
}
