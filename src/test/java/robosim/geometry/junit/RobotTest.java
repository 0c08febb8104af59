package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Point;
import robosim.geometry.scenario.Mismatch;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.Step;

/** What holds passes, and what does not says where and why. */
class RobotTest {
    private final RobotWorld world = RobotWorld.of(Worlds.wallAhead());
    private final Robot r1 = world.robot("r1");

    @Test
    void itDrivesAndTurns() {
        r1.drives(2.0).turns(90).drives(1.0);
        assertThat(r1.center()).isEqualTo(new Point(2, 0, -1));
        assertThat(r1.heading()).isEqualTo(90);
    }

    @Test
    void aBlockedDriveTellsWhereAndWhy() {
        assertThatThrownBy(() -> r1.drives(1).drives(2.5))
                .isInstanceOf(AssertionError.class)
                .hasMessage("robot \"r1\" was to drive 2.5, but is blocked after 2 of 2.5 by box \"wall\" at (4, 0, 0),"
                        + " where it touches (3.5, 0, 0); it stands at (1, 0, 0), heading 0");
        assertThat(r1.center()).isEqualTo(new Point(1, 0, 0));
        assertThatThrownBy(() -> r1.drives(-30)).hasMessageContaining("by the border of the world");
    }

    @Test
    void toTryIsNoFailure() {
        assertThat(r1.triesToDrive(4)).isFalse();
        assertThat(r1.triesToDrive(2)).isTrue();
        assertThat(r1.triesToTurn(30)).isTrue();
        assertThat(r1.heading()).isCloseTo(30, within(1e-14));
    }

    @Test
    void itIsBlockedByWhatIsNamed() {
        r1.isBlockedBy("wall", 4);
        assertThatThrownBy(() -> r1.isBlockedBy("wall", 1)).hasMessageContaining("but nothing is in its way");
        assertThatThrownBy(() -> r1.isBlockedBy("r2", 4))
                .hasMessageContaining("was to be blocked by \"r2\"")
                .hasMessageContaining("by box \"wall\" at (4, 0, 0)");
    }

    @Test
    void itSensesAtTheDistanceThatThereIs() {
        assertThat(r1.range(0)).isEqualTo(3.5);
        assertThat(r1.range(90)).isEqualTo(3.5);
        assertThat(r1.range(180)).isInfinite();
        r1.senses(0, 3.5).sensesNothing(0, 3.4).sensesNothing(180, 100);
        assertThatThrownBy(() -> r1.senses(0, 3.4))
                .hasMessage(
                        "robot \"r1\" was to sense something within 3.4 at 0 degrees, but the first echo is 3.5 away,"
                                + " at about (3.5, 0, 0); it stands at (0, 0, 0), heading 0");
        assertThatThrownBy(() -> r1.senses(180, 9)).hasMessageContaining("nothing echoes there at any distance");
        assertThatThrownBy(() -> r1.sensesNothing(90, 3.5)).hasMessageContaining("at about (0, 0, -3.5)");
        assertThatThrownBy(() -> r1.senses(0, Double.NaN)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void itIsAsFarFromOthersAsTheirSurfacesAre() {
        assertThat(r1.rangeTo("wall").value()).isCloseTo(3, within(1e-12)).isLessThanOrEqualTo(3);
        r1.rangeTo("wall")
                .isAtLeast(3)
                .rangeTo("wall")
                .isAtMost(3)
                .rangeTo("r2")
                .isAtMost(3);
        assertThatThrownBy(() -> r1.rangeTo("wall").isAtLeast(3.5))
                .hasMessage(
                        "robot \"r1\" was to be at least 3.5 from \"wall\", but is 3 from it; it stands at (0, 0, 0),"
                                + " heading 0");
        assertThatThrownBy(() -> r1.rangeTo("wall").isAtMost(2.5)).hasMessageContaining("at most 2.5 from \"wall\"");
    }

    @Test
    void itNeverTouchesLooksBackAndForth() {
        r1.neverTouches("wall").drives(2);
        assertThatThrownBy(() -> r1.triesToDrive(2))
                .hasMessageStartingWith(
                        "robot \"r1\" must never touch \"wall\", but robot \"r1\" was to drive 2 and was"
                                + " blocked after 1 of 2 by box \"wall\"");
        assertThatThrownBy(() -> r1.neverTouches("wall")).isInstanceOf(AssertionError.class);
        assertThatCode(() -> r1.neverTouches("r2")).doesNotThrowAnyException();
    }

    @Test
    void whatTouchesWithoutAMoveIsSeenToo() {
        world.geometry().addObjectUnchecked(new BoxObject(new Point(0.5, 0, 0), 0.1, 1, 0.1).named("thing"));
        assertThatThrownBy(() -> r1.neverTouches("thing"))
                .hasMessage(
                        "robot \"r1\" must never touch \"thing\", but they touch: cylinder \"r1\" at (0, 0, 0) and box"
                                + " \"thing\" at (0.5, 0, 0)");
    }

    @Test
    void itReachesAGoalInSteps() {
        r1.follows(robot -> robot.triesToDrive(0.5));
        r1.reaches(Goal.at(2, 0, 0.25)).within(4);
        assertThat(world.clock().steps()).isEqualTo(4);
        r1.reaches(Goal.near("wall", 0.5)).within(1);
        assertThatThrownBy(() -> r1.reaches(Goal.at(3, 1, 0.5)).within(3))
                .hasMessageStartingWith(
                        "robot \"r1\" was to reach (3, 1) to within 0.5 in 3 steps, but came no nearer than ")
                .hasMessageContaining(
                        "it stands at (2.5, 0, 0), heading 0; the last that stopped it: robot \"r1\" was to"
                                + " drive 0.5 in step 8 and was blocked after 0.5 of 0.5 by box \"wall\"");
    }

    @Test
    void stepsInWhichNothingHappensAreRefused() {
        r1.reaches(Goal.at(0, 0, 0)).within(0);
        assertThatThrownBy(() -> r1.reaches(Goal.at(1, 0, 0)).within(10))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("follows");
    }

    @Test
    void aStrangeNameIsToldWhichThereAre() {
        assertThatThrownBy(() -> world.robot("wall"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("name must be that of a moveable object, one of [\"r1\", \"r2\"] (got: \"wall\")");
        assertThatThrownBy(() -> r1.rangeTo("walls")).hasMessageContaining("[\"r1\", \"wall\", \"r2\"]");
        assertThat(world.robots()).extracting(Robot::name).containsExactly("r1", "r2");
    }

    @Test
    void whatItDidReplaysToTheBitWhateverElseChangesTheWorld() {
        r1.drives(1).turns(33.3).triesToDrive(9);
        r1.range(17);
        world.geometry().placeObject("r2", new Point(-3, 0, 3), 12.5);
        world.robot("r2").turns(-0.1).drives(0.7).range(99);
        Scenario scenario = world.scenario("what it did");
        assertThat(Replay.of(scenario)).extracting(Mismatch::toString).isEmpty();
        assertThat(scenario.steps()).hasSize(9);
        assertThat(scenario.steps().stream().filter(step -> step.expected() != null))
                .hasSize(7);
        assertThat(scenario.steps().get(5).notes()).containsExactly("the test changed the world by other means");
        Step last = scenario.steps().get(8);
        assertThat(last.expected()).isNotNull();
    }
}
